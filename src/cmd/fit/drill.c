/* drill: a training game against a hidden plant.
 *
 * Nothing that a command shows or saves has the truth before the answer: the
 * site has its samples, the journal the seed and what was asked.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/drill.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/sites.h"
#include "cmd/session/turn.h"
#include "cmd/ask/forecast.h"
#include "cmd/lang/table.h"
#include "core/model/breakage.h"
#include "core/numeric/rng.h"
#include "io/sitefile/units.h"

/* What a drill begins with, and what samples cost: the rotor's speed has to be
 * changed for one at a new speed. */
enum { CREDITS = 10, COST_NEW = 2, COST_SAME = 1 };

/* Points of the score: for a product that meets the conditions at all, for
 * meeting them in the middle, and for all credits left; and what is lost of the
 * first for each m/s beside them. */
static const double MET = 50, MIDDLE = 30, THRIFT = 20, LOST = 20;

static char *
provenance_of(const struct drill *d)
{
	return xasprintf("made up: a drill, seed %" PRIu64 ", %s",
	    d->plant.seed, d->plant.hard ? "hard" : "easy");
}

/* The place of the drill's site, or n_entry. */
static size_t
site_of(const struct session *s, const struct drill *d)
{
	char *provenance = provenance_of(d);
	size_t i = 0;
	while (i < s->n_entry &&
	       strcmp(s->entry[i].site->provenance, provenance) != 0)
		i++;
	free(provenance);
	return i;
}

/* Another one, which the session then owns, in the place of that under way. */
static struct drill *
put_drill(struct session *s, const struct drill *from)
{
	struct drill *d = xcalloc(1, sizeof *d);
	*d = *from;
	s->drills = xrealloc(s->drills, s->n_drill + 1, sizeof(*s->drills));
	s->drills[s->n_drill++] = d;
	s->drill = d;
	return d;
}

static void
add_conditions(struct answer *r, const struct drill_plant *plant)
{
	struct fields *list = fields_list(answer_fields(r), "conditions");
	for (size_t i = 0; i < DRILL_CONDITIONS; i++) {
		const struct drill_condition *c = &plant->condition[i];
		answer_pair(r, i == 0 ? N_("wanted") : N_("and"),
		    c->most ? N_("at most %.1f %% below %g mm")
			    : N_("at least %.1f %% below %g mm"),
		    100 * c->passing, units_mm(c->size));
		fields_put(fields_object(list, NULL),
		    "sieve_mm %g passing_pct %g most %d", units_mm(c->size),
		    units_pct(c->passing), c->most);
	}
}

static struct answer *
status_answer(const struct drill *d)
{
	struct answer *r = answer_new("drill");
	struct fields *o = answer_fields(r);
	char *provenance = provenance_of(d), *speeds = xstrdup("");
	answer_title(r, "a drill: find the speed for a product");
	answer_site(r, "drill", provenance);
	answer_columns(r, "what, value");
	add_conditions(r, &d->plant);
	fields_put(o, "level %s credits %zu", d->plant.hard ? "hard" : "easy",
	    d->credits);
	fields_numbers(o, "samples", d->speed, d->n, NULL);
	for (size_t i = 0; i < d->n; i++)
		xlist(&speeds, ", ", "%g", d->speed[i]);
	answer_pair(r, "speeds", "%d to %d m/s", DRILL_SLOWEST, DRILL_FASTEST);
	answer_pair(r, "sampled", "%s", d->n > 0 ? speeds : tr("nothing"));
	answer_pair(r, "credits",
	    "%zu of %d; a sample costs %d, another one at "
	    "its speed %d",
	    d->credits, CREDITS, COST_NEW, COST_SAME);
	free(speeds);
	free(provenance);
	return r;
}

/* What the player's own prediction would have said there. */
static void
add_band(struct answer *r, struct session *s, const struct drill *d)
{
	size_t at = site_of(s, d), held = 0;
	if (at == s->n_entry || !s->entry[at].has_params) {
		answer_note(r, "nothing was calibrated on the site drill, so "
			       "that there is no prediction to compare");
		return;
	}
	const struct entry *entry = &s->entry[at];
	struct prediction p =
	    forecast_whole(s, entry, d->answer, SITE_MEAN_FEED);
	const struct psd *curve = &p.product;
	double *truth = xdoubles(curve->n), worst = 0;
	drill_truth(&d->plant, d->answer, curve->size, curve->n, truth);
	for (size_t i = 0; i < curve->n; i++) {
		held += p.low != NULL && truth[i] >= p.low[i] - 1e-9 &&
			truth[i] <= p.high[i] + 1e-9;
		worst = fmax(worst, fabs(truth[i] - curve->passing[i]));
	}
	answer_note(
	    r, "your prediction was off by %.1f points at most", 100 * worst);
	fields_put(answer_fields(r), "off_points %g", 100 * worst);
	if (p.low != NULL) {
		answer_note(r,
		    "its %.0f %% band held the truth at %zu of %zu sieves",
		    100 * settings_level(&s->set), held, curve->n);
		fields_put(answer_fields(r), "band_held %zu band_sieves %zu",
		    held, curve->n);
	}
	free(truth);
	prediction_free(&p);
}

static double
score_of(const struct drill *d)
{
	double margin = drill_margin(&d->plant, d->answer);
	double half = (d->plant.fastest - d->plant.slowest) / 2;
	double product = margin >= 0 ? MET + MIDDLE * margin / half
				     : fmax(0, MET + LOST * (margin - 0.5));
	return round(product + THRIFT * (double)d->credits / CREDITS);
}

static void
say_truth(struct answer *r, const struct drill *d)
{
	const struct drill_plant *p = &d->plant;
	const struct breakage *of = breakage_of(&p->made.params);
	char *hidden = xstrdup("");
	for (size_t j = of->strength; j < of->n; j++)
		if (p->made.params.at[j] > 0 && j != of->reference)
			xlist(&hidden, ", ", "%s %.3g", of->parameter[j].name,
			    p->made.params.at[j]);
	answer_note(r, "the hidden plant: %s, samples err by %.1f points",
	    hidden, 100 * p->made.noise);
	free(hidden);
}

/* The truth, once the answer is given. */
static void
add_result(struct answer *r, struct session *s, const struct drill *d)
{
	const struct drill_plant *p = &d->plant;
	double margin = drill_margin(p, d->answer), score = score_of(d);
	double best = (p->slowest + p->fastest) / 2;
	for (size_t i = 0; i < DRILL_CONDITIONS; i++) {
		const struct drill_condition *c = &p->condition[i];
		double is;
		drill_truth(p, d->answer, &c->size, 1, &is);
		double spare = c->most ? c->passing - is : is - c->passing;
		answer_note(r,
		    spare >= 0 ? N_("%.1f %% below %g mm: met by %.1f points")
			       : N_("%.1f %% below %g mm: missed by %.1f "
				    "points"),
		    100 * is, units_mm(c->size), 100 * fabs(spare));
	}
	answer_note(r,
	    margin >= 0 ? N_("you answered %g m/s, %.1f m/s within the speeds "
			     "that meet both, %.1f to %.1f; the best was %.1f")
			: N_("you answered %g m/s, %.1f m/s outside the speeds "
			     "that meet both, %.1f to %.1f; the best was "
			     "%.1f"),
	    d->answer, fabs(margin), p->slowest, p->fastest, best);
	add_band(r, s, d);
	say_truth(r, d);
	answer_note(r, "score %.0f of 100", score);
	fields_put(answer_fields(r),
	    "answer %g met %d margin_mps %g best %g slowest %g fastest %g "
	    "score %g",
	    d->answer, margin >= 0, margin, best, p->slowest, p->fastest,
	    score);
}

static bool
show(struct session *s)
{
	const struct drill *d = s->drill;
	struct answer *r = status_answer(d);
	if (isfinite(d->answer))
		add_result(r, s, d);
	else if (d->n < 2)
		answer_note(r, "sample the site, two speeds at least, then "
			       "'calibrate': drill sample 69");
	else
		answer_note(r,
		    "work on the site drill as on any other (window \"passing "
		    "2 "
		    ">= %g\" \"passing 0.5 <= %g\"), then answer once: drill "
		    "answer SPEED",
		    units_pct(d->plant.condition[0].passing),
		    units_pct(d->plant.condition[1].passing));
	return session_answer(s, r);
}

/* A number that no command has to show: any will do. */
static uint64_t
any_seed(struct session *s)
{
	uint64_t seed = rng_mix((uint64_t)(1e6 * session_clock())) % 10000;
	char *said = xasprintf("%" PRIu64, seed);
	invocation_adds(s, "seed", said);
	free(said);
	return seed;
}

static bool
begin(struct session *s, const struct args *args)
{
	const struct value *seed = args_value(args, "seed");
	bool hard = args_value(args, "level")->choice == 1;
	struct drill d = {.credits = CREDITS, .answer = NAN};
	if (s->drill != NULL && site_of(s, s->drill) < s->n_entry)
		session_drop(s, site_of(s, s->drill));
	d.plant = drill_plant(seed->given ? seed->whole : any_seed(s), hard);
	struct site *site = drill_feed(&d.plant);
	free(site->name);
	free(site->provenance);
	site->name = xstrdup("drill");
	site->provenance = provenance_of(&d);
	session_add(s, site);
	put_drill(s, &d);
	return show(s);
}

/* What a sample at that speed costs. */
static size_t
cost_of(const struct drill *d, double speed)
{
	for (size_t i = 0; i < d->n; i++)
		if (fabs(d->speed[i] - speed) < 1e-3)
			return COST_SAME;
	return COST_NEW;
}

static bool
take_sample(struct session *s, double speed, struct error *error)
{
	struct drill d = *s->drill;
	size_t at = site_of(s, &d), cost = cost_of(&d, speed);
	if (at == s->n_entry)
		return error_set(error, ERROR_USAGE,
		    "the site of the drill is not loaded any more\n"
		    "run 'undo', or begin another: drill new");
	if (cost > d.credits)
		return error_set(error, ERROR_USAGE,
		    "a sample at %g m/s costs %zu credits, and %zu are left\n"
		    "answer now: drill answer SPEED",
		    speed, cost, d.credits);
	if (s->current != at)
		session_forget(s);
	s->current = at;
	const struct site *old = s->entry[at].site;
	struct site *cut = drill_sample(&d.plant, speed, d.n);
	size_t *from = xcalloc(old->n_run + 1, sizeof *from);
	session_grow(s, site_with_cuts(old, cut, from), from);
	site_free(cut);
	free(from);
	d.speed[d.n++] = speed;
	d.credits -= cost;
	put_drill(s, &d);
	return show(s);
}

static bool
take_answer(struct session *s, double speed)
{
	struct drill d = *s->drill;
	d.answer = speed;
	put_drill(s, &d);
	return show(s);
}

bool
cmd_drill(struct session *s, const struct args *args, struct error *error)
{
	size_t what;
	double speed = NAN;
	const char *word = args->n_operand > 0 ? args->operand[0] : "";
	bool known = text_choice("new sample answer", word, &what);
	if (known && what == 0 && args->n_operand == 1)
		return begin(s, args);
	if (s->drill == NULL)
		return error_set(error, ERROR_USAGE,
		    "no drill is under way\nbegin one: drill new");
	if (args->n_operand == 0)
		return show(s);
	if (!known || what == 0 || args->n_operand != 2 ||
	    !text_number(args->operand[1], &speed) ||
	    !(speed >= DRILL_SLOWEST && speed <= DRILL_FASTEST))
		return error_set(error, ERROR_USAGE,
		    "drill: expected new, or sample or answer with a speed "
		    "from %d to %d m/s, got '%s%s%s'\n"
		    "for instance: drill sample 69; drill answer 73.2",
		    DRILL_SLOWEST, DRILL_FASTEST, word,
		    args->n_operand > 1 ? " " : "",
		    args->n_operand > 1 ? args->operand[1] : "");
	if (isfinite(s->drill->answer))
		return error_set(error, ERROR_USAGE,
		    "this drill is answered\nbegin another: drill new");
	return what == 1 ? take_sample(s, speed, error) : take_answer(s, speed);
}
