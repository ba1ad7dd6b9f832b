/* sweep: products over a range of speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/table.h"
#include "cmd/outlook.h"
#include "core/predict.h"
#include "io/units.h"

/* Sieves down, speeds across: for as many speeds as fit a screen. */
static void
sweep_across(
    struct session *s, struct answer *r, const struct prediction *p, size_t n)
{
	const struct entry *entry = session_entry(s);
	answer_columns(r, "sieve_mm: sieve mm, feed_pct: feed %%");
	for (size_t i = 0; i < n; i++) {
		bool outside = answers_extrapolates(entry, p[i].speed);
		answer_columns(r, "passing_pct@%g: %g m/s%s", p[i].speed,
		    p[i].speed, outside ? "*" : "");
	}
	for (size_t row = 0; row < p[0].product.n; row++) {
		answer_text(r, "%g", units_mm(p[0].product.size[row]));
		answer_cells(r, "%.1f", units_pct(p[0].feed.passing[row]));
		for (size_t i = 0; i < n; i++)
			answer_cells(
			    r, "%.1f", units_pct(p[i].product.passing[row]));
	}
	for (size_t size = 0; size < ANSWERS_SIZES; size++) {
		answer_cells(r, "%s", ANSWERS_HEADS[size]);
		answer_missing(r, "");
		answer_cells(r, "%.0f", NAN);
		for (size_t i = 0; i < n; i++)
			answers_size_cell(r, &p[i], size);
	}
}

/* One row a speed and sieve: for spreadsheets and programs. */
static void
sweep_long(
    struct session *s, struct answer *r, const struct prediction *p, size_t n)
{
	const struct entry *entry = session_entry(s);
	answer_columns(r, "speed: m/s, extrapolated, sieve_mm: sieve mm, "
			  "feed_pct: feed %%, passing_pct: product %%");
	for (size_t i = 0; i < n; i++) {
		bool outside = answers_extrapolates(entry, p[i].speed);
		for (size_t j = 0; j < p[i].product.n; j++)
			answer_cells(r, "%g %s %g %.1f %.1f", p[i].speed,
			    outside ? "yes" : "no",
			    units_mm(p[i].product.size[j]),
			    units_pct(p[i].feed.passing[j]),
			    units_pct(p[i].product.passing[j]));
	}
}

bool
cmd_sweep(struct session *s, const struct args *args, struct error *error)
{
	enum { ACROSS = 7 };
	const struct entry *entry = session_entry(s);
	const struct value *speeds = args_value(args, "speeds");
	size_t n = speeds->n, feed;
	if (!answers_ready(s, error) ||
	    !answers_feed(
		entry->site, args, answers_middle(entry->site), &feed, error))
		return false;
	double *usual = n == 0 ? answers_speeds(entry->site, &n) : NULL;
	const double *speed = usual != NULL ? usual : speeds->list;
	struct prediction *p = xcalloc(n, sizeof *p);
	bool outside = false;
	for (size_t i = 0; i < n; i++) {
		p[i] = outlook_predict(s, entry, speed[i], feed);
		outside = outside || answers_extrapolates(entry, speed[i]);
	}
	free(usual);
	struct answer *r =
	    answers_new(entry->site, "sweep", "products, %% passing");
	bool across = n <= ACROSS;
	(across ? sweep_across : answers_speed_rows)(s, r, p, n);
	answer_for_programs(r);
	sweep_long(s, r, p, n);
	origin_note(r, entry);
	if (entry->site->individual_feeds)
		answer_say(r, ANSWER_REMARK,
		    "feed used for all speeds: sampled at %g m/s",
		    entry->site->run[feed].speed);
	if (outside && across)
		answer_say(r, ANSWER_WARNING,
		    "speeds marked * are outside the training speeds");
	answers_note_worth(s, r, entry);
	answers_put_products(s, answer_fields(r), p, n);
	for (size_t i = 0; i < n; i++)
		prediction_free(&p[i]);
	free(p);
	return session_answer(s, r);
}
