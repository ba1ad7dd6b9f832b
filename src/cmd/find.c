/* find: the tip speed that gives a wanted product; spec: a product compared
 * with a grading envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/files.h"
#include "cmd/table.h"
#include "cmd/outlook.h"
#include "core/inverse.h"
#include "core/predict.h"
#include "io/spec.h"
#include "io/units.h"

/* An envelope with a model of one feed on those of its sieves that the feed
 * tells: the first `n` of the spec. */
struct grading {
	struct spec *spec;
	size_t n;
	struct inverse inverse;
	struct envelope envelope;
};

/* Reads the file; feed: the run of the site in use whose feed to take.  Faults
 * of the file are reported as session_load does. */
static bool
grading_open(struct session *s, const char *path, size_t feed,
    struct grading *grading, struct error *error)
{
	const struct entry *entry = session_entry(s);
	const struct psd *from = &entry->site->run[feed].feed;
	struct error_list errors = {0};
	files_reads(s, path);
	struct spec *spec = spec_read(path, &errors);
	*grading = (struct grading){.spec = spec};
	if (spec == NULL)
		return session_tell_faults(s, path, &errors, error);
	if (spec->note[0] != '\0')
		session_note(s, "%s: %s", path, spec->note);
	while (grading->n < spec->n && psd_covers(from, spec->size[grading->n]))
		grading->n++;
	if (grading->n == 0) {
		spec_free(spec);
		return error_set(error, ERROR_DATA,
		    "%s: none of its sieves is in the range of the feed's "
		    "sieves",
		    path);
	}
	grading->inverse =
	    outlook_inverse(s, entry, feed, spec->size, grading->n);
	grading->envelope = (struct envelope){spec->least, spec->most};
	return true;
}

static void
grading_close(struct grading *grading)
{
	inverse_free(&grading->inverse);
	spec_free(grading->spec);
}

/* Of sieve i, at the speed the inverse was asked for last. */
static const char *
verdict(const struct grading *grading, size_t i)
{
	const double exact = 1e-9;
	if (i >= grading->n)
		return "not known";
	double passing = grading->inverse.product.passing[i];
	if (passing < grading->spec->least[i] - exact)
		return "below";
	return passing > grading->spec->most[i] + exact ? "above" : "ok";
}

/* A row for each sieve: limits, passing at speed v and "ok", "above", "below"
 * or "not known". */
static void
grading_rows(struct answer *r, const struct session *s, struct grading *grading,
    double v)
{
	const struct spec *spec = grading->spec;
	struct ensemble *e = grading->inverse.ensemble;
	const struct psd *product = inverse_at(&grading->inverse, v);
	answer_columns(r, "sieve_mm: sieve mm, min_pct: min %%, max_pct: max "
			  "%%, passing_pct: product %%");
	if (e != NULL)
		answer_columns(r, "low_pct: low %%, high_pct: high %%");
	answer_columns(r, "verdict");
	for (size_t i = 0; i < spec->n; i++) {
		bool known = i < grading->n;
		double low = NAN, high = NAN;
		if (known && e != NULL)
			ensemble_band(e, ENSEMBLE_ANSWER, i,
			    settings_level(&s->set), &low, &high);
		answer_cells(r, "%g %g %g %.1f", units_mm(spec->size[i]),
		    units_pct(spec->least[i]), units_pct(spec->most[i]),
		    known ? units_pct(product->passing[i]) : NAN);
		if (e != NULL)
			answer_cells(
			    r, "%.1f %.1f", units_pct(low), units_pct(high));
		answer_cells(r, "%s", verdict(grading, i));
	}
}

/* Where the limits are from, and which sieves are not checked. */
static void
grading_notes(struct answer *r, const struct grading *grading)
{
	const struct spec *spec = grading->spec;
	if (grading->n < spec->n)
		answer_say(r, ANSWER_REMARK,
		    "not checked: %g mm and below, finer than the feed's "
		    "finest sieve",
		    units_mm(spec->size[grading->n]));
	if (spec->source[0] != '\0')
		answer_say(r, ANSWER_REMARK, "limits: %s", spec->source);
}

/* Puts spec, source and the columns of grading_rows into its JSON. */
static void
grading_put(struct answer *r, const struct spec *spec)
{
	fields_put(
	    answer_fields(r), "spec %s source %s", spec->name, spec->source);
	answer_put_columns(r, "sieve_mm min_pct max_pct passing_pct verdict");
}

/* What is wrong, in a line. */
static void
note_verdict(struct answer *r, struct grading *grading, double v)
{
	size_t worst, out = 0;
	double by =
	    inverse_outside(&grading->inverse, &grading->envelope, v, &worst);
	for (size_t i = 0; i < grading->n; i++)
		out += verdict(grading, i)[0] != 'o';
	double certain =
	    inverse_certainty(&grading->inverse, &grading->envelope, v);
	fields_number(answer_fields(r), "certainty_pct", 100 * certain);
	if (out == 0)
		answer_note(r, "meets the envelope");
	else
		answer_note(r,
		    "outside on %zu of %zu sieves; worst at %g mm: %.1f points "
		    "%s",
		    out, grading->n, units_mm(grading->spec->size[worst]),
		    100 * fabs(by), by > 0 ? "above max" : "below min");
	if (isfinite(certain))
		answer_note(r,
		    "the true product meets the checked limits with %.0f %% "
		    "probability",
		    100 * certain);
}

bool
cmd_spec(struct session *s, const struct args *args, struct error *error)
{
	const struct entry *entry = session_entry(s);
	double v = answers_speed(args, entry);
	size_t feed, worst;
	struct grading g;
	if (!answers_ready(s, error) ||
	    !answers_feed(entry->site, args, v, &feed, error) ||
	    !grading_open(s, args->operand[0], feed, &g, error))
		return false;
	bool outside = answers_extrapolates(entry, v);
	bool inside = inverse_outside(&g.inverse, &g.envelope, v, &worst) == 0;
	struct answer *r =
	    answers_new(entry->site, "spec", "%s at %g m/s", g.spec->name, v);
	grading_rows(r, s, &g, v);
	note_verdict(r, &g, v);
	grading_notes(r, &g);
	answers_note_doubt(s, r, v, feed);
	fields_put(answer_fields(r), "speed %g extrapolated %d inside %d", v,
	    outside, inside);
	grading_put(r, g.spec);
	session_answer(s, r);
	grading_close(&g);
	return true;
}

/* What is wanted: that a share passes a size; and on which feed, between which
 * speeds.  key: p80_mm, p50_mm or p20_mm; NULL where the passing is looked
 * at. */
struct wish {
	const char *key;
	double passing, x; /* 0..1; m */
	double from, to;
	size_t feed;
	struct inverse inverse;
};

static double
passing_over(void *data, double v)
{
	struct wish *wish = data;
	return psd_passing(inverse_at(&wish->inverse, v), wish->x) -
	       wish->passing;
}

/* Exactly one of the wishes is given, with what belongs to it. */
static bool
check_wish(
    const struct args *args, const struct wish *wish, struct error *error)
{
	static const char *const ONE[] = {
	    "p20", "p50", "p80", "passing", "spec"};
	size_t given = 0;
	for (size_t i = 0; i < ARRAY_LEN(ONE); i++)
		given += args_value(args, ONE[i])->given;
	bool at = args_value(args, "at")->given;
	if (given != 1)
		error_set(error, ERROR_USAGE,
		    "find: expected one of p20, p50, p80, passing and spec, "
		    "got %zu of them",
		    given);
	else if (at != args_value(args, "passing")->given)
		error_set(error, ERROR_USAGE,
		    "find: expected passing and at together: this much passing "
		    "at this size");
	else if (wish->from >= wish->to)
		error_set(error, ERROR_USAGE,
		    "find: expected from below to, got %g and %g m/s",
		    wish->from, wish->to);
	else
		return true;
	return error_hint(
	    error, "write: find p80=5, find passing=40 at=2 or find spec=FILE");
}

/* Sizes are read from the curve that predict reads them from; a passing is that
 * of the size itself. */
static bool
open_wish(struct session *s, const struct args *args, struct wish *wish,
    struct error *error)
{
	static const char *const NAMES[3] = {"p20", "p50", "p80"};
	const struct entry *entry = session_entry(s);
	const struct psd *feed = &entry->site->run[wish->feed].feed;
	wish->x = args_value(args, "at")->number / 1000;
	wish->passing = args_value(args, "passing")->number / 100;
	for (size_t i = 0; i < 3; i++) {
		if (!args_value(args, NAMES[i])->given)
			continue;
		wish->key = ANSWERS_KEYS[i];
		wish->passing = PSD_PASSING[i];
		wish->x = args_value(args, NAMES[i])->number / 1000;
	}
	if (!psd_covers(feed, wish->x))
		return error_set(error, ERROR_USAGE,
		    "%g mm is finer than the feed's finest sieve, %g mm\n"
		    "use a size on or above that sieve",
		    1000 * wish->x, units_mm(feed->size[feed->n - 1]));
	struct psd sizes = predict_sizes(entry->site, feed);
	wish->inverse =
	    wish->key != NULL
		? outlook_inverse(s, entry, wish->feed, sizes.size, sizes.n)
		: outlook_inverse(s, entry, wish->feed, &wish->x, 1);
	psd_free(&sizes);
	return true;
}

/* What is wanted, at a speed, in mm or %; NAN outside the sieves. */
static double
value_at(struct wish *wish, double v)
{
	const struct psd *product = inverse_at(&wish->inverse, v);
	return wish->key != NULL ? 1000 * psd_size(product, wish->passing)
				 : units_pct(psd_passing(product, wish->x));
}

static char *
wish_words(const struct wish *wish)
{
	return wish->key != NULL ? xasprintf("P%.0f %g mm", 100 * wish->passing,
				       units_mm(wish->x))
				 : xasprintf("%g %% passing %g mm",
				       100 * wish->passing, units_mm(wish->x));
}

static void
put_wish(
    struct fields *o, struct wish *wish, double speed, const double range[2])
{
	bool size = wish->key != NULL;
	fields_put(o,
	    "wanted %s value %g at_mm %g from %g to %g value_from %g "
	    "value_to %g speed %g",
	    size ? wish->key : "passing_pct",
	    size ? units_mm(wish->x) : units_pct(wish->passing),
	    size ? NAN : units_mm(wish->x), wish->from, wish->to,
	    value_at(wish, wish->from), value_at(wish, wish->to), speed);
	fields_put(o, "speed_low %g speed_high %g",
	    range[0] > 0 ? range[0] : NAN, isfinite(range[1]) ? range[1] : NAN);
}

/* The speed found with its range, an end of which may lie beyond the speeds
 * searched. */
static void
note_speed(struct answer *r, const struct session *s, const struct wish *wish,
    const char *words, double v, const double range[2])
{
	char low[40], high[40];
	snprintf(low, sizeof low, range[0] > 0 ? "%.2f" : "below %g",
	    range[0] > 0 ? range[0] : wish->from);
	snprintf(high, sizeof high, isfinite(range[1]) ? "%.2f" : "above %g",
	    isfinite(range[1]) ? range[1] : wish->to);
	if (isnan(range[0]))
		answer_note(r, "%s at %.2f m/s", words, v);
	else
		answer_note(r, "%s at %.2f m/s (%.0f %% range: %s to %s m/s)",
		    words, v, 100 * settings_level(&s->set), low, high);
}

/* Why there is no such speed: what the two ends give. */
static void
note_unreached(struct answer *r, struct wish *wish, const char *words)
{
	const char *what = wish->key != NULL ? "mm" : "%";
	double low = value_at(wish, wish->from),
	       high = value_at(wish, wish->to);
	bool above = passing_over(wish, wish->from) > 0;
	answer_note(r,
	    "no speed from %g to %g m/s gives %s: the product is still %s at "
	    "%g m/s",
	    wish->from, wish->to, words, above ? "finer" : "coarser",
	    above ? wish->from : wish->to);
	if (isfinite(low) && isfinite(high))
		answer_note(r, "it is %.2f %s at %g m/s and %.2f %s at %g m/s",
		    low, what, wish->from, high, what, wish->to);
	answer_note(r, above ? "use from= to search slower speeds"
			     : "use to= to search faster speeds");
}

/* The product at the speed found; without one those at the two ends. */
static void
answer_wish(struct session *s, struct wish *wish)
{
	const double exact = 1e-9;
	const struct entry *entry = session_entry(s);
	double v = inverse_speed(passing_over, wish, wish->from, wish->to);
	bool found = isfinite(v) && passing_over(wish, v) < exact;
	double speed[2] = {found ? v : wish->from, wish->to};
	size_t n = found ? 1 : 2;
	struct prediction p[2];
	for (size_t i = 0; i < n; i++)
		p[i] = outlook_predict(s, entry, speed[i], wish->feed);
	session_forget(s);
	char *words = wish_words(wish);
	struct answer *r =
	    answers_new(entry->site, "find", "the speed for %s", words);
	answers_speed_rows(s, r, p, n);
	double range[2];
	inverse_range(&wish->inverse, wish->x, wish->passing, wish->from,
	    wish->to, settings_level(&s->set), range);
	if (found)
		note_speed(r, s, wish, words, v, range);
	else
		note_unreached(r, wish, words);
	if (found)
		answers_note_sizes(r, &p[0]);
	answers_note_doubt(
	    s, r, found ? v : entry->site->run[wish->feed].speed, wish->feed);
	put_wish(answer_fields(r), wish, found ? v : NAN, range);
	answers_put_products(s, answer_fields(r), p, n);
	session_answer(s, r);
	if (found)
		answers_keep(s, &entry->params, &p[0]);
	for (size_t i = 0; i < n; i++)
		prediction_free(&p[i]);
	free(words);
}

static void
note_window(struct answer *r, const struct wish *wish, const struct grading *g,
    const struct window *w)
{
	if (w->inside) {
		answer_note(r,
		    "meets the envelope from %.2f to %.2f m/s; table: %.2f m/s",
		    w->slowest, w->fastest, w->slowest);
		return;
	}
	answer_note(r,
	    "no speed from %g to %g m/s meets the envelope; the nearest is "
	    "%.2f m/s",
	    wish->from, wish->to, w->nearest);
	answer_note(r, "worst at %g mm: %.1f points %s",
	    units_mm(g->spec->size[w->worst]), 100 * fabs(w->by),
	    w->by > 0 ? "above max" : "below min");
}

/* The speeds around the most certain one at which the limits hold with the
 * probability of bands; [2] out, NAN where there are none. */
static void
certain_window(const struct session *s, const struct wish *wish,
    struct grading *g, double range[2])
{
	enum { STEPS = 80 };
	double certain[STEPS + 1], step = (wish->to - wish->from) / STEPS;
	size_t best = 0;
	for (size_t k = 0; k <= STEPS; k++) {
		certain[k] = inverse_certainty(
		    &g->inverse, &g->envelope, wish->from + step * (double)k);
		best = certain[k] > certain[best] ? k : best;
	}
	size_t low = best, high = best;
	double level = settings_level(&s->set);
	range[0] = range[1] = NAN;
	if (!(certain[best] >= level))
		return;
	while (low > 0 && certain[low - 1] >= level)
		low--;
	while (high < STEPS && certain[high + 1] >= level)
		high++;
	range[0] = wish->from + step * (double)low;
	range[1] = wish->from + step * (double)high;
}

static void
note_certain(struct answer *r, const struct session *s, const double range[2])
{
	double level = 100 * settings_level(&s->set);
	if (isfinite(range[0]))
		answer_note(r,
		    "holds with %.0f %% probability from %.2f to %.2f m/s",
		    level, range[0], range[1]);
	else
		answer_note(r,
		    "at no speed does it hold with %.0f %% probability", level);
	answers_put_pair(answer_fields(r), "certain", range[0], range[1]);
}

static bool
answer_spec(struct session *s, const struct args *args, const struct wish *wish,
    struct error *error)
{
	const struct entry *entry = session_entry(s);
	struct grading g;
	if (!grading_open(
		s, args_value(args, "spec")->text, wish->feed, &g, error))
		return false;
	struct window w =
	    inverse_window(&g.inverse, &g.envelope, wish->from, wish->to);
	double v = w.inside ? w.slowest : w.nearest;
	struct answer *r =
	    answers_new(entry->site, "find", "the speeds for %s", g.spec->name);
	grading_rows(r, s, &g, v);
	note_window(r, wish, &g, &w);
	if (g.inverse.ensemble != NULL) {
		double certain[2];
		certain_window(s, wish, &g, certain);
		note_certain(r, s, certain);
	}
	grading_notes(r, &g);
	answers_note_doubt(s, r, v, wish->feed);
	fields_put(answer_fields(r),
	    "wanted %s from %g to %g inside %d slowest %g fastest %g "
	    "speed %g worst_mm %g outside_pct %g",
	    "spec", wish->from, wish->to, w.inside, w.inside ? w.slowest : NAN,
	    w.inside ? w.fastest : NAN, v,
	    w.inside ? NAN : units_mm(g.spec->size[w.worst]), 100 * w.by);
	grading_put(r, g.spec);
	session_forget(s);
	session_answer(s, r);
	grading_close(&g);
	return true;
}

bool
cmd_find(struct session *s, const struct args *args, struct error *error)
{
	const struct site *site = session_entry(s)->site;
	const struct value *from = args_value(args, "from");
	const struct value *to = args_value(args, "to");
	struct wish wish = {0};
	site_reach(site, &wish.from, &wish.to);
	wish.from = from->given ? from->number : wish.from;
	wish.to = to->given ? to->number : wish.to;
	if (!answers_ready(s, error) || !check_wish(args, &wish, error))
		return false;
	if (!answers_feed(site, args, answers_middle(site), &wish.feed, error))
		return false;
	if (args_value(args, "spec")->given)
		return answer_spec(s, args, &wish, error);
	if (!open_wish(s, args, &wish, error))
		return false;
	answer_wish(s, &wish);
	inverse_free(&wish.inverse);
	return true;
}
