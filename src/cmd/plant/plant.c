/* Solves the circuit for the draws at a speed (circuit_compute_flow), and adds
 * power and earnings draw by draw.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/plant/plant.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "base/text.h"
#include "cmd/ask/outlook.h"
#include "cmd/session/files.h"
#include "cmd/ask/quantity_words.h"
#include "core/psd/rotor_speed.h"
#include "core/posterior/ensemble.h"
#include "core/answer/predict.h"
#include "io/formats/circuit_file.h"
#include "io/sitefile/units.h"

/* Each fraction may need two screens and two stockpiles. */
enum { FRACTIONS = CIRCUIT_UNITS / 5, EDGES = 2 * FRACTIONS };

/* Returns the next part of a list, trimmed, or NULL at its end.  A comma or a
 * semicolon separates parts.  The caller frees it. */
static char *
next_comma_list_item(const char **at)
{
	if (**at == '\0')
		return NULL;
	size_t n = strcspn(*at, ",;");
	FREED char *copy = xstrndup(*at, n);
	*at += n + ((*at)[n] != '\0');
	return xstrdup(text_trim(copy));
}

/* The fractions of fractions=, and their edges, m, coarsest first, without
 * 0. */
struct fraction_list {
	size_t n, n_edge;
	struct fraction fraction[FRACTIONS];
	double edge[EDGES];
};

static bool
parse_size_fractions(
    const char *text, struct fraction_list *c, struct error *error)
{
	char *part;
	bool ok = true;
	for (const char *at = text;
	     ok && (part = next_comma_list_item(&at)) != NULL;) {
		struct fraction f = {0};
		ok = quantities_parse_size_fraction(part, &f, error);
		for (size_t i = 0; ok && i < c->n; i++)
			if (f.fine < c->fraction[i].coarse &&
			    c->fraction[i].fine < f.coarse)
				ok = error_set(error, ERROR_USAGE,
				    "fractions= has %s, which overlaps with "
				    "another one\n"
				    "write fractions that follow each other, "
				    "such as 0/2,2/5,5/8",
				    part);
		if (ok && c->n == FRACTIONS)
			ok = error_set(error, ERROR_USAGE,
			    "expected at most %d fractions, got more\n"
			    "leave some out: what is between is listed too",
			    (int)FRACTIONS);
		if (ok) {
			c->fraction[c->n++] = f;
			c->edge[c->n_edge++] = f.coarse;
			if (f.fine > 0)
				c->edge[c->n_edge++] = f.fine;
		}
		free(part);
	}
	c->n_edge = psd_sort_distinct_sizes(c->edge, c->n_edge, 0);
	return ok;
}

/* Returns "2/5", or "+11.2" for a fraction without an upper size. */
static char *
name_of_size_fraction(double fine, double coarse)
{
	if (!(coarse > 0))
		return xasprintf("+%g", units_m_to_mm(fine));
	struct fraction f = {.fine = fine, .coarse = coarse};
	return quantities_fraction_text(&f);
}

/* Returns how many parts of a list are `name`, or all if that is NULL. */
static size_t
count_list_parts(const char *list, const char *name)
{
	size_t n = 0;
	char *part;
	for (const char *at = list; (part = next_comma_list_item(&at)) != NULL;
	     free(part))
		n += name == NULL || strcmp(part, name) == 0;
	return n;
}

static struct unit *
add_circuit_unit_with_inlet(
    struct circuit *c, enum unit_kind kind, const char *name, size_t in)
{
	struct unit *unit = circuit_add_unit(c, kind, name);
	unit->n_in = 1;
	unit->in[0] = in;
	return unit;
}

/* Adds the next screen of the deck.  Its feed is *now, which becomes its
 * undersize; returns its oversize, which is named after the fraction. */
static size_t
add_screen_of_deck(struct circuit *c, const struct args *args, double opening,
    const char *name, bool last, size_t *now)
{
	struct unit *screen =
	    add_circuit_unit_with_inlet(c, UNIT_SCREEN, "", *now);
	FREED char *under = last ? name_of_size_fraction(0, opening)
				 : xasprintf("-%g", units_m_to_mm(opening));
	screen->opening = opening;
	screen->partition.sharpness = args->sharpness;
	screen->partition.cut_size = args->cut_size / 100;
	screen->n_out = 2;
	screen->out[0] = circuit_find_or_add_stream(c, name);
	screen->out[1] = *now = circuit_find_or_add_stream(c, under);
	return screen->out[0];
}

/* Adds a crusher that the new feed enters, and returns it.  Sets *crushed to
 * its outgoing stream. */
static struct unit *
add_crusher_to_circuit(
    struct circuit *c, const struct args *args, size_t *crushed)
{
	struct unit *new = circuit_add_unit(c, UNIT_FEED, "");
	new->n_out = 1;
	new->out[0] = circuit_find_or_add_stream(c, "new feed");
	struct unit *crusher =
	    add_circuit_unit_with_inlet(c, UNIT_CRUSHER, "", new->out[0]);
	crusher->n_out = 1;
	crusher->out[0] = *crushed = circuit_find_or_add_stream(c, "crushed");
	crusher->cascade = args->cascade / 100;
	return crusher;
}

/* Builds the circuit of a crusher and a deck of screens.  The oversize of each
 * screen is a fraction, which goes back to the crusher or to a stockpile. */
static bool
build_circuit(const struct args *args, const struct fraction_list *cuts,
    struct plant *p, struct error *error)
{
	struct circuit *c = p->circuit;
	size_t taken = 0, now;
	struct unit *crusher = add_crusher_to_circuit(c, args, &now);
	for (size_t i = 0; i <= cuts->n_edge; i++) {
		bool pan = i == cuts->n_edge;
		FREED char *name = name_of_size_fraction(
		    pan ? 0 : cuts->edge[i], i > 0 ? cuts->edge[i - 1] : 0);
		size_t over = pan ? now
				  : add_screen_of_deck(c, args, cuts->edge[i],
					name, i + 1 == cuts->n_edge, &now);
		bool back = count_list_parts(p->back, name) > 0;
		taken += back;
		if (back && crusher->n_in < UNIT_STREAMS)
			crusher->in[crusher->n_in++] = over;
		else
			add_circuit_unit_with_inlet(
			    c, UNIT_STOCKPILE, name, over);
	}
	if (taken == count_list_parts(p->back, NULL) && taken < UNIT_STREAMS)
		return true;
	return error_set(error, ERROR_USAGE,
	    "expected fractions of the list in recycle=, got '%s'\n"
	    "write them as in fractions=, or +%g for what is coarser than all",
	    p->back, units_m_to_mm(cuts->edge[0]));
}

static bool
parse_options_and_build_circuit(
    const struct args *args, struct plant *p, struct error *error)
{
	struct fraction_list cuts = {0};
	if (!(args->tph > 0))
		return error_set(error, ERROR_USAGE,
		    "flow: expected tph, the new feed in t/h, got none\n"
		    "write: flow tph=120 fractions=0/2,2/5,5/8,8/11.2");
	p->circuit = circuit_new();
	p->back = xstrdup(args->recycle != NULL ? args->recycle : "");
	return parse_size_fractions(args->fractions, &cuts, error) &&
	       build_circuit(args, &cuts, p, error);
}

static bool
read_circuit_file(const struct args *args, struct plant *p, struct error *error)
{
	const void *const of_file[] = {&args->fractions, &args->recycle,
	    &args->cascade, &args->sharpness, &args->cut_size};
	const char *path = args->circuit;
	struct error_list errors = {.stop = p->s->hooks.stop};
	for (size_t i = 0; i < ARRAY_LEN(of_file); i++)
		if (args_is_given(args, of_file[i]))
			return error_set(error, ERROR_USAGE,
			    "%s= is given, but the circuit comes from a "
			    "file\nstate it in %s, see tipspeed-circuit(5)",
			    args_option_name(args, of_file[i]), path);
	files_record_read(p->s, path);
	p->from_file = true;
	p->circuit = circuit_file_read(path, p->question->entry->site, &errors);
	if (p->circuit == NULL)
		return session_report_file_faults(p->s, path, &errors, error);
	if (p->circuit->tph > 0 || args->tph > 0)
		return true;
	return error_set(error, ERROR_USAGE,
	    "neither tph= nor the feed of %s says how much new feed there is\n"
	    "write: flow circuit=%s tph=120",
	    path, path);
}

/* Sorts sizes, coarsest first, and drops those that differ from their neighbour
 * only by rounding.  Returns their number. */
static size_t
sort_and_drop_equal_sizes(double *size, size_t n)
{
	const double alike = 1e-9;
	size_t kept = 0;
	n = psd_sort_distinct_sizes(size, n, 0);
	for (size_t i = 0; i < n; i++)
		if (kept == 0 || size[i] < size[kept - 1] * (1 - alike))
			size[kept++] = size[i];
	return kept;
}

/* Chooses the classes: the sizes of the site, sizes between them, and those of
 * the screens.  If there are very many sieves, only some of them are taken,
 * because the work grows with the third power of their number. */
static void
choose_size_classes(struct plant *p)
{
	enum { MOST = 120 };
	const struct psd *feed = question_feed(p->question);
	struct psd sieves =
	    predict_list_table_sieves(p->question->entry->site, feed);
	struct psd all = psd_new_with_sizes_between(sieves.size, sieves.n);
	struct circuit *c = p->circuit;
	const struct psd *from = all.n <= MOST ? &all : &sieves;
	size_t step = (from->n + MOST - 1) / MOST;
	p->size = xcalloc_doubles(from->n + c->n_unit + 1);
	for (size_t i = 0; i < from->n; i += step)
		p->size[p->n++] = from->size[i];
	p->size[p->n++] = from->size[from->n - 1];
	for (size_t u = 0; u < c->n_unit; u++)
		if (c->unit[u].kind == UNIT_SCREEN)
			p->size[p->n++] =
			    c->unit[u].opening * c->unit[u].partition.cut_size;
	p->n = sort_and_drop_equal_sizes(p->size, p->n);
	psd_free(&all);
	psd_free(&sieves);
}

/* Sets an error if a screen is finer than the finest sieve of the feed. */
static bool
check_screens_covered_by_feed(const struct plant *p, struct error *error)
{
	const struct psd *feed = question_feed(p->question);
	for (size_t u = 0; u < p->circuit->n_unit; u++) {
		const struct unit *unit = &p->circuit->unit[u];
		double cut = unit->opening * unit->partition.cut_size;
		if (unit->kind == UNIT_SCREEN && !psd_covers_size(feed, cut))
			return error_set(error, ERROR_USAGE,
			    "a screen at %g mm cuts finer than the feed's "
			    "finest sieve, %g mm\nuse sizes on or above that "
			    "sieve",
			    units_m_to_mm(cut),
			    units_m_to_mm(feed->size[feed->n - 1]));
	}
	return true;
}

/* Sets the price of every product with a name.  priced [n_unit] marks those
 * that the same list has priced already. */
static bool
set_price_of_product(struct circuit *c, const char *name, double price,
    bool *priced, struct error *error)
{
	bool found = false;
	for (size_t u = 0; u < c->n_unit; u++) {
		if (c->unit[u].kind != UNIT_STOCKPILE ||
		    strcmp(c->unit[u].name, name) != 0)
			continue;
		if (priced[u])
			return error_set(error, ERROR_USAGE,
			    "%s has two prices, %g and %g\n"
			    "leave out one of them",
			    name, c->unit[u].price, price);
		c->unit[u].price = price;
		priced[u] = found = true;
	}
	return found || error_set(error, ERROR_USAGE,
			    "no product is called '%s'\n"
			    "prices are those of what leaves the circuit: "
			    "fractions that are not recycled, or stockpiles",
			    name);
}

/* Reads a price, "0/2:12". */
static bool
parse_product_price(
    struct circuit *c, const char *part, bool *priced, struct error *error)
{
	char *name = xstrdup(part), *colon = strrchr(name, ':');
	double price;
	bool ok = colon != NULL && text_parse_number(colon + 1, &price);
	if (!ok)
		error_set(error, ERROR_USAGE,
		    "expected a fraction and its price per t, got '%s'\n"
		    "write: prices=0/2:12,2/5:9",
		    part);
	if (colon != NULL)
		*colon = '\0';
	ok = ok &&
	     set_price_of_product(c, text_trim(name), price, priced, error);
	free(name);
	return ok;
}

static bool
parse_prices(const struct args *args, struct plant *p, struct error *error)
{
	FREED bool *priced = xcalloc(p->circuit->n_unit + 1, sizeof *priced);
	char *part;
	bool ok = true;
	if (args->prices != NULL)
		for (const char *at = args->prices;
		     ok && (part = next_comma_list_item(&at)) != NULL;
		     free(part))
			ok = parse_product_price(
			    p->circuit, part, priced, error);
	for (size_t u = 0; u < p->circuit->n_unit; u++)
		p->priced = p->priced || isfinite(p->circuit->unit[u].price);
	p->kwh = args->kwh;
	if (ok && p->kwh > 0 && !p->priced)
		return error_set(error, ERROR_USAGE,
		    "expected prices= with kwh=, which is taken off the "
		    "earnings\nadd prices, such as prices=0/2:12,2/5:9");
	return ok;
}

static void
add_power_reading(struct plant *p, const double value[static 3])
{
	p->reading = xrealloc(p->reading, p->n_reading + 1, sizeof *p->reading);
	p->reading[p->n_reading++] =
	    (struct reading){value[0], value[1], value[2]};
}

/* Parses a reading, "72:187:121", or "66:52:0" for an empty crusher.  More than
 * 5 MW is in W, as no such crusher has that. */
static bool
parse_power_reading(struct plant *p, const char *part, struct error *error)
{
	const double MOST_KW = 5000;
	double value[3];
	char *copy = xstrdup(part), *at = copy;
	bool ok = true;
	for (size_t i = 0; i < 3; i++) {
		char *colon = i < 2 && at != NULL ? strchr(at, ':') : NULL;
		if (colon != NULL)
			*colon = '\0';
		ok = ok && at != NULL && text_parse_number(at, &value[i]) &&
		     (value[i] > 0 || (i == 2 && value[i] == 0));
		at = colon != NULL ? colon + 1 : NULL;
	}
	free(copy);
	if (!ok || value[0] > SITE_FASTEST || value[1] > MOST_KW)
		return error_set(error, ERROR_USAGE,
		    "expected a reading of the motor, m/s:kW:t/h, got '%s'\n"
		    "write: power=72:187:121,79:221:118",
		    part);
	add_power_reading(p, value);
	return true;
}

/* Adds the reading in a note that add wrote, such as "72 m/s, 2026-05-03 10:15,
 * 187 kW, 121 t/h, cut.csv", if it has all three values. */
static void
parse_power_reading_of_note(struct plant *p, const char *note)
{
	static const char *const UNITS[3] = {" m/s", " kW", " t/h"};
	double value[3] = {NAN, NAN, NAN};
	FREED char *plain = xstrdup(note);
	char *part;
	for (char *q = plain; *q != '\0'; q++)
		if (*q == ',' && q > plain && isdigit((unsigned char)q[-1]) &&
		    isdigit((unsigned char)q[1]))
			*q = '.'; /* a person may write 187,5 kW */
	for (const char *at = plain; (part = next_comma_list_item(&at)) != NULL;
	     free(part))
		for (size_t i = 0; i < 3; i++) {
			if (!text_ends_with(part, UNITS[i]))
				continue;
			double v;
			part[strlen(part) - strlen(UNITS[i])] = '\0';
			if (text_parse_number(part, &v) && v > 0)
				value[i] = v;
		}
	if (isfinite(value[0] + value[1] + value[2]))
		add_power_reading(p, value);
}

static bool
parse_power_options(
    const struct args *args, struct plant *p, struct error *error)
{
	const struct site *site = p->question->entry->site;
	char *part;
	bool ok = true;
	if (args->power != NULL) {
		for (const char *at = args->power;
		     ok && (part = next_comma_list_item(&at)) != NULL;
		     free(part))
			ok = parse_power_reading(p, part, error);
		return ok;
	}
	for (size_t i = 0; i < site->n_note; i++)
		if (strcmp(site->note[i].key, "cut") == 0)
			parse_power_reading_of_note(p, site->note[i].value);
	p->of_cuts = p->n_reading > 0;
	return true;
}

/* Makes the crusher's model, with the question's feed. */
static void
make_crusher_model(struct plant *p)
{
	const struct entry *entry = p->question->entry;
	const struct psd *feed = question_feed(p->question);
	struct psd sieves = predict_list_table_sieves(entry->site, feed);
	p->crusher = crusher_new_for_answers(p->s, entry, p->size, p->n);
	p->feed = xcalloc_doubles(p->n);
	crusher_class_masses_of_feed(p->crusher, feed, p->feed);
	crusher_set_reference_feed(p->crusher, feed, sieves.size, sieves.n);
	psd_free(&sieves);
}

static void
make_fixed_speed_crusher_models(struct plant *p)
{
	p->own = xcalloc(p->circuit->n_unit, sizeof(*p->own));
	for (size_t u = 0; u < p->circuit->n_unit; u++)
		if (p->circuit->unit[u].speed > 0)
			p->own[u] = crusher_transfer_at_speed(
			    p->crusher, p->circuit->unit[u].speed);
}

bool
plant_from_args(struct session *s, const struct args *args,
    const struct question *q, struct plant *plant, struct error *error)
{
	*plant = (struct plant){.s = s, .question = q};
	bool ok = args->circuit != NULL
		      ? read_circuit_file(args, plant, error)
		      : parse_options_and_build_circuit(args, plant, error);
	if (ok && args->tph > 0)
		plant->circuit->tph = args->tph;
	ok = ok && check_screens_covered_by_feed(plant, error) &&
	     parse_prices(args, plant, error) &&
	     parse_power_options(args, plant, error);
	if (!ok) {
		plant_free(plant);
		return false;
	}
	choose_size_classes(plant);
	make_crusher_model(plant);
	make_fixed_speed_crusher_models(plant);
	plant->power = power_fit_readings(plant->reading, plant->n_reading);
	const struct params *params = &q->entry->params;
	const struct breakage *of = breakage_model_of_params(params);
	plant->bypass = of->bypass ? params->at[of->n - 1] : 0;
	return true;
}

void
plant_free(struct plant *p)
{
	for (size_t u = 0; p->own != NULL && u < p->circuit->n_unit; u++)
		transfer_free(p->own[u]);
	crusher_free(p->crusher);
	circuit_free(p->circuit);
	free(p->own);
	free(p->feed);
	free(p->back);
	free(p->size);
	free(p->reading);
	*p = (struct plant){0};
}

double
plant_share_through_rotor(const struct plant *p, const struct unit *unit)
{
	return (1 - unit->cascade) * (1 - p->bypass);
}

double
plant_speed_of_circuit_unit(const struct unit *unit, double speed)
{
	return unit->speed > 0 ? unit->speed : speed;
}

char *
plant_fixed_speeds_text(const struct plant *p, double *first)
{
	char *text = xstrdup("");
	bool free_speed = false;
	for (size_t u = 0; u < p->circuit->n_unit; u++) {
		const struct unit *unit = &p->circuit->unit[u];
		if (unit->kind != UNIT_CRUSHER)
			continue;
		free_speed = free_speed || !(unit->speed > 0);
		if (text[0] == '\0' && first != NULL)
			*first = unit->speed;
		xappend_to_list(&text, ", ", "%.4g", unit->speed);
	}
	if (text[0] != '\0' && !free_speed)
		return text;
	free(text);
	return NULL;
}

/* Adds the power and the earnings of a draw.  A model alone has a single
 * product, which serves all draws of the power. */
static void
add_power_and_earnings_of_draw(
    const struct plant *p, struct plant_result *o, size_t d)
{
	double kw = 0, money = 0;
	size_t of = d % o->flow.draws;
	for (size_t u = 0; u < p->circuit->n_unit; u++) {
		const struct unit *unit = &p->circuit->unit[u];
		double tph = flow_tph_into_unit_in_draw(&o->flow, unit, of);
		if (unit->kind == UNIT_CRUSHER)
			kw += power_kw_of_posterior_draw(&p->power, d,
			    plant_speed_of_circuit_unit(unit, o->speed),
			    tph * plant_share_through_rotor(p, unit));
		if (unit->kind == UNIT_STOCKPILE && isfinite(unit->price))
			money += tph * unit->price;
	}
	o->kw_draw[d] = kw;
	o->money_draw[d] = money - kw * p->kwh;
	o->kw += kw / POWER_DRAWS;
	o->money += o->money_draw[d] / POWER_DRAWS;
}

struct plant_result
plant_compute_flow_at_speed(const struct plant *p, double speed)
{
	struct plant_result o = {.speed = speed};
	struct transfer *t = crusher_transfer_at_speed(p->crusher, speed);
	FREED struct transfer **of = xcalloc(p->circuit->n_unit, sizeof(*of));
	for (size_t u = 0; u < p->circuit->n_unit; u++)
		of[u] = p->own[u] != NULL ? p->own[u] : t;
	o.flow = circuit_compute_flow(p->circuit, p->feed, p->size, p->n, of);
	for (size_t d = 0; d < POWER_DRAWS; d++)
		add_power_and_earnings_of_draw(p, &o, d);
	transfer_free(t);
	return o;
}

size_t
plant_list_streams(const struct plant *p, const struct plant_result *o,
    struct plant_stream_row *line)
{
	const struct circuit *c = p->circuit;
	size_t n = 0;
	for (size_t u = 0; u < c->n_unit; u++)
		if (c->unit[u].kind == UNIT_STOCKPILE)
			line[n++] = (struct plant_stream_row){
			    c->unit[u].name, &c->unit[u], c->unit[u].in[0]};
	for (size_t i = 0; i < c->n_stream; i++)
		if (o->flow.back[i])
			line[n++] =
			    (struct plant_stream_row){c->stream[i], NULL, i};
	/* The streams of the deck were made from coarse to fine; they are
	 * listed from fine to coarse. */
	for (size_t i = 1; i < n && !p->from_file; i++)
		for (size_t k = i; k > 0 && line[k - 1].stream < line[k].stream;
		     k--) {
			struct plant_stream_row other = line[k];
			line[k] = line[k - 1];
			line[k - 1] = other;
		}
	return n;
}

bool
plant_set_error_not_steady(
    const struct plant *p, const struct plant_result *o, struct error *error)
{
	return error_set(error, ERROR_NUMERIC,
	    "the circuit does not reach a steady state at %g m/s: after %d "
	    "passes %.4g t/h circulate for %g t/h of new feed, and the load "
	    "still grows\nwhat goes back hardly breaks: send a coarser "
	    "fraction back, take some of it out, or use a higher speed",
	    o->speed, (int)CIRCUIT_PASSES, o->flow.circulating,
	    p->circuit->tph);
}

double
plant_idle_power(const struct plant *p, double speed, double range[static 2])
{
	double draw[POWER_DRAWS], mean = 0;
	for (size_t d = 0; d < POWER_DRAWS; d++) {
		draw[d] = power_idle_kw_of_draw(&p->power, d, speed);
		mean += draw[d] / POWER_DRAWS;
	}
	ensemble_interval_around_answer(draw, p->question->level, mean, range);
	return mean;
}

char *
plant_power_basis_text(const struct plant *p, const struct plant_result *o)
{
	const struct power *w = &p->power;
	double range[2], idle = plant_idle_power(p, o->speed, range);
	if (w->n == 0)
		return xstrdup(tr("no motor readings: Q v2 alone, the power "
				  "that brings the rock to the tip speed: a "
				  "lower limit; give power=m/s:kW:t/h"));
	FREED char *rpm = rotor_speed_rpm_text(
	    p->question->entry->site->rotor, o->speed, NAN);
	char *words =
	    xasprintf(tr_n("engineering estimate from %zu reading %s, idle "
			   "%.0f kW (%.0f to %.0f) at %g m/s%s",
			  "engineering estimate from %zu readings %s, idle "
			  "%.0f kW (%.0f to %.0f) at %g m/s%s",
			  w->n),
		w->n, p->of_cuts ? tr("of the belt cuts") : tr("given"), idle,
		range[0], range[1], o->speed, rpm);
	if (w->n > 3)
		xappend_to_list(&words, "; ",
		    tr("the readings differ from it by %.1f kW (RMS)"), w->rms);
	if (range[1] - range[0] > 0.1 * o->kw)
		xappend_to_list(&words, "; ", "%s",
		    tr("the readings cannot separate idle from load: also read "
		       "the empty crusher at two speeds, as in "
		       "power=66:kW:0,78:kW:0"));
	return words;
}
