/* guess: a first product for a site with no calibration.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/guess.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/data.h"
#include "cmd/fit.h"
#include "cmd/origin.h"
#include "cmd/table.h"
#include "io/units.h"

/* What a guess is made from.  list: all materials; m [list.n]: the same for
 * core; pick [n]: the nearest ones. */
struct basis {
	struct stored_list list;
	struct guess_material *m, wanted;
	bool *leave_out;
	size_t n, *pick;
};

static void
basis_free(struct basis *b)
{
	stored_list_free(&b->list);
	free(b->m);
	free(b->leave_out);
	free(b->pick);
}

static void
basis_find(struct basis *b, size_t most)
{
	size_t n = b->list.n;
	b->m = xcalloc(n, sizeof *b->m);
	b->leave_out = xcalloc(n, sizeof *b->leave_out);
	b->pick = xcalloc(most, sizeof *b->pick);
	for (size_t i = 0; i < n; i++) {
		const struct stored *m = &b->list.item[i];
		double top_mm = m->top_size_mm;
		b->m[i] = (struct guess_material){m->site, m->rock,
		    isfinite(top_mm) ? top_mm / 1000 : 0, m->params,
		    stored_settings(m)};
		b->leave_out[i] = text_same(m->site, b->wanted.site);
	}
	b->n = guess_nearest(b->m, n, &b->wanted, b->leave_out, most, b->pick);
}

/* Rock and top size as given, else the sheet's. */
static bool
find_wanted(const struct site *site, const struct args *args,
    struct guess_material *wanted, struct error *error)
{
	const struct value *rock = args_value(args, "rock");
	const struct value *top = args_value(args, "top");
	*wanted = (struct guess_material){.site = site->name,
	    .rock = rock->given ? rock->text : site->rock,
	    .top_size = top->given ? top->number / 1000 : site->top_size};
	if (wanted->rock[0] != '\0' || wanted->top_size > 0)
		return true;
	return error_set(error, ERROR_USAGE,
	    "guess wants a rock or a top size, and the sheet of %s states "
	    "neither\nguess rock=granite top=11.2",
	    site->name);
}

/* Of Table 3 alone, so that it is the same for everyone. */
static struct guess_error
table3_error(const struct basis *b, size_t nearest, double speed, char **worst)
{
	size_t first = 0;
	while (!stored_is_table3(&b->list.item[first]))
		first++;
	struct guess_error e = guess_leave_one_out(
	    b->m + first, b->list.n - first, nearest, speed);
	*worst = xstrdup(b->list.item[first + e.worst_at].name);
	return e;
}

/* "p20_mm": middle and "p20_range_mm": [least, most]. */
static void
put_range(json_t *o, const char *name, const struct guess_range *range)
{
	char key[32];
	snprintf(key, sizeof key, "%s_mm", name);
	json_object_set_new(o, key, report_json_number(1000 * range->middle));
	snprintf(key, sizeof key, "%s_range_mm", name);
	answers_put_pair(o, key, 1000 * range->least, 1000 * range->most);
}

static void
put_materials(json_t *o, const struct basis *b)
{
	json_t *list = json_array();
	for (size_t i = 0; i < b->n; i++) {
		const struct stored *m = &b->list.item[b->pick[i]];
		json_t *one = json_object();
		report_put(one,
		    "name %s site %s rock %s top_size_mm %g origin %s "
		    "provenance %s train_mps %s",
		    m->name, m->site, m->rock, m->top_size_mm, m->origin,
		    m->provenance, m->train_mps);
		fit_put_params(one, &m->params);
		json_array_append_new(list, one);
	}
	json_object_set_new(o, "materials", list);
}

static void
put_error(json_t *o, const struct guess_error *e, const char *worst)
{
	json_t *error = json_object();
	report_put(error,
	    "data %s sites %zu median_rmse_pct %g worst_rmse_pct %g worst %s "
	    "feed_rmse_pct %g",
	    "reconstructed from Table 3", e->n, 100 * e->median, 100 * e->worst,
	    worst, 100 * e->feed);
	json_object_set_new(o, "leave_one_site_out", error);
}

static void
put_guess(struct report *r, const struct basis *b, const struct guess *guess)
{
	static const char *const NAMES[] = {"p20", "p50", "p80", "break"};
	json_t *o = report_json(r);
	double top = b->wanted.top_size;
	report_put(o, "calibrated %d rock %s top_size_mm %g speed %g", false,
	    b->wanted.rock, top > 0 ? units_mm(top) : NAN, guess->speed);
	report_put_columns(r, "sieve_mm passing_pct least_pct most_pct");
	for (size_t i = 0; i < ANSWERS_SIZES; i++)
		put_range(o, NAMES[i], &guess->size[i]);
	put_materials(o, b);
}

static struct report *
guess_table(const struct site *site, const struct guess *guess)
{
	struct report *r = answers_report(site, "guess",
	    "guessed product at %.1f m/s, not calibrated", guess->speed);
	report_columns(r,
	    "sieve_mm: sieve mm, feed_pct: feed %%, passing_pct: guess %%, "
	    "least_pct: least %%, most_pct: most %%");
	for (size_t i = 0; i < guess->median.n; i++)
		report_cells(r, "%g %.1f %.1f %.1f %.1f",
		    units_mm(guess->median.size[i]),
		    units_pct(guess->feed.passing[i]),
		    units_pct(guess->median.passing[i]),
		    units_pct(guess->least.passing[i]),
		    units_pct(guess->most.passing[i]));
	return r;
}

/* "2.81 (2.52..3.10)", in mm. */
static char *
range_words(const struct guess_range *range, const char *none)
{
	const double v[3] = {range->middle, range->least, range->most};
	char *word[3];
	for (size_t i = 0; i < 3; i++)
		word[i] = isfinite(v[i]) ? xasprintf("%.2f", 1000 * v[i])
					 : xstrdup(none);
	char *words = xasprintf("%s (%s..%s)", word[0], word[1], word[2]);
	for (size_t i = 0; i < 3; i++)
		free(word[i]);
	return words;
}

static void
note_sizes(struct report *r, const struct guess *guess)
{
	const struct psd *psd = &guess->median;
	char *none = xasprintf("<%g", units_mm(psd->size[psd->n - 1]));
	char *words[ANSWERS_SIZES];
	for (size_t i = 0; i < ANSWERS_SIZES; i++)
		words[i] = range_words(
		    &guess->size[i], i == ANSWER_BREAK ? "none" : none);
	report_note(
	    r, "P20 %s, P50 %s, P80 %s mm", words[0], words[1], words[2]);
	report_note(r, "breaks from %s mm up", words[ANSWER_BREAK]);
	for (size_t i = 0; i < ANSWERS_SIZES; i++)
		free(words[i]);
	free(none);
}

/* Names of the materials picked (or, with `left`, left out). */
static char *
names(const struct basis *b, bool left)
{
	char *list = xstrdup("");
	for (size_t i = 0; i < (left ? b->list.n : b->n); i++) {
		size_t at = left ? i : b->pick[i];
		if (!left || b->leave_out[i])
			xlist(&list, ", ", "%s", b->list.item[at].name);
	}
	return list;
}

static void
note_materials(struct report *r, const struct basis *b)
{
	size_t same = 0;
	bool measured = true;
	for (size_t i = 0; i < b->n; i++) {
		const struct stored *m = &b->list.item[b->pick[i]];
		same += text_same(m->rock, b->wanted.rock);
		measured = measured && strcmp(site_data_kind(m->provenance),
					   "measured") == 0;
	}
	char *picked = names(b, false), *left = names(b, true);
	if (b->n > 1)
		report_note(r,
		    "a guess from other quarries, not a calibration: the "
		    "median of the products with each of the %zu nearest "
		    "materials, and their spread",
		    b->n);
	else
		report_note(r,
		    "a guess from another quarry, not a calibration: the "
		    "product with the nearest material, which tells no spread");
	if (b->wanted.rock[0] == '\0')
		report_note(
		    r, "nearest by top size, no rock is stated: %s", picked);
	else
		report_note(r, "nearest by rock (%s, %zu of %zu)%s: %s",
		    b->wanted.rock, same, b->n,
		    b->wanted.top_size > 0 ? " and top size"
					   : ", no top size is stated",
		    picked);
	if (!measured)
		report_note(
		    r, "some of them were not calibrated on measured data");
	if (left[0] != '\0')
		report_note(r, "left out, being this site's own: %s", left);
	free(picked);
	free(left);
}

/* A speed that one of the materials, or more, was not trained at; nothing is
 * said of those that do not tell theirs. */
static void
note_reach(struct report *r, const struct basis *b, double speed)
{
	double slowest = 0, fastest = INFINITY;
	for (size_t i = 0; i < b->n; i++) {
		struct origin *o = origin_stored(&b->list.item[b->pick[i]]);
		double slow = INFINITY, fast = 0;
		for (size_t k = 0; k < o->n_speed; k++) {
			slow = fmin(slow, o->speed[k]);
			fast = fmax(fast, o->speed[k]);
		}
		if (o->n_speed > 0) {
			slowest = fmax(slowest, slow);
			fastest = fmin(fastest, fast);
		}
		origin_drop(o);
	}
	bool beyond = speed < slowest - 1e-9 || speed > fastest + 1e-9;
	report_put(report_json(r), "extrapolated %d", beyond);
	if (beyond)
		report_note(r,
		    "extrapolated: %.1f m/s lies outside the speeds that all "
		    "of them were trained at, %g to %g m/s",
		    speed, slowest, fastest);
}

static void
report_guess(struct session *s, const struct basis *b,
    const struct guess *guess, size_t nearest)
{
	const struct site *site = session_entry(s)->site;
	struct report *r = guess_table(site, guess);
	char *worst;
	struct guess_error e = table3_error(b, nearest, guess->speed, &worst);
	note_sizes(r, guess);
	note_materials(r, b);
	note_reach(r, b, guess->speed);
	report_note(r,
	    "how far such guesses err: each of %zu materials of Table 3, "
	    "guessed from the other sites, misses its own model's product by "
	    "%.1f points RMS (median), %.1f at worst (%s); product = feed "
	    "misses by %.1f. Reconstructed data on made-up feeds, with no "
	    "sampling error: a plant will be farther off",
	    e.n, 100 * e.median, 100 * e.worst, worst, 100 * e.feed);
	put_guess(r, b, guess);
	put_error(report_json(r), &e, worst);
	free(worst);
	session_report(s, r);
}

bool
cmd_guess(struct session *s, const struct args *args, struct error *error)
{
	const struct site *site = session_entry(s)->site;
	double speed = answers_speed(args, session_entry(s));
	size_t nearest = (size_t)args_value(args, "nearest")->whole, feed;
	struct basis b = {0};
	bool ok = find_wanted(site, args, &b.wanted, error) &&
		  answers_feed(site, args, speed, &feed, error) &&
		  store_list_all(s->store, &b.list, error);
	if (ok) {
		basis_find(&b, nearest);
		struct guess guess =
		    guess_product(site, feed, b.m, b.pick, b.n, speed);
		report_guess(s, &b, &guess, nearest);
		guess_free(&guess);
	}
	basis_free(&b);
	return ok;
}
