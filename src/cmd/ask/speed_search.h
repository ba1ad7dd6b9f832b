/* Searches for the speeds at which a product meets conditions; the only such
 * search.  It can be run in steps, so that a screen stays live.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_SPEED_SEARCH_H
#define TIPSPEED_CMD_ASK_SPEED_SEARCH_H

#include <stdbool.h>

#include "cmd/ask/forecast.h"

/* Limits of a quantity, in its own unit; NAN where there is none. */
struct condition {
	struct quantity quantity;
	double least, most;
};

/* Condition i of a list is on quantity i of the forecast, and the target, or
 * NULL, on the quantity after these: a value (both limits) to be reached, or a
 * quantity without limits of which the largest or least value is sought.  from,
 * to: range of speeds, m/s; measured: the slowest and the fastest of those that
 * inform the answer; level: of bands.  Unless stated otherwise functions move
 * the forecast to other speeds. */
struct wanted {
	struct forecast *forecast;
	size_t n;
	const struct condition *at, *target;
	double from, to, measured[2], level;
};

/* Returns conditions [n] of a question, with more quantities [n_more] after
 * theirs, at the speeds of site_reach, without a target; `at` must outlive it;
 * free its `forecast` with forecast_close. */
struct wanted wanted_of(const struct session *s, const struct question *q,
    size_t n, const struct condition *at, size_t n_more,
    const struct quantity *more);

/* One of the two limits of condition i; i SIZE_MAX: none. */
struct wanted_limit {
	size_t i;
	bool most;
};

/* How far a limit is away, below 0 where it is missed: as a passing 0..1
 * (quantity_over), and over the width of the band there, so that limits on
 * different sieves compare (D21), as long as they hold; for a model alone both
 * are the passing.  A limit that leaves no room, at least 100 % or at most 0 %,
 * has to hold but is never near: INFINITY. */
struct margin {
	double passing, widths;
	struct wanted_limit limit;
};

/* The first and the last tenth of a m/s at which all conditions hold, and the
 * limits that bind below and above them: none at an end of the speeds searched.
 * The ends of a range between two tenths are exact to 1e-4 m/s. */
struct speed_range {
	double from, to;
	struct wanted_limit low, high;
};

/* A speed that gives the target's value, and whether the conditions hold. */
struct speed_root {
	double speed;
	bool holds;
};

/* speed, certain [n]: each tenth of a m/s, and the share of the draws in which
 * all conditions hold there, NAN for a model alone; the first `done` are known,
 * and the members below once all are.
 *
 * best: the speed at which the conditions hold most surely, if any between the
 * measured speeds one of these; of those as sure to 2 % the one with the
 * largest margin, in widths; where none holds the one that misses least.
 * margin: its least.  low, high: limits that bind below and above, or are
 * missed just below and just above the best speed; alike: every speed misses
 * by as much.
 * alone [conditions]: the tenths about the best speed, or nearest to it, at
 * which each condition alone holds; NAN: up to an end of the speeds searched.
 * sure: the speeds about the best one, or else about the most certain one, that
 * hold with the probability `level`; NAN where none does.
 * root [n_root]: slowest first.  found: of these the one nearest to the
 * measured speeds, preferably one at which the conditions hold; NAN: none.
 * range: the middle `level` of the speeds at which the draws give the value,
 * too; cut: the same for the product that a belt cut would show.  0 and
 * INFINITY: below and above the speeds searched; NAN for a model alone. */
struct speed_search {
	size_t n, done;
	double *speed, *certain;
	size_t n_inside;
	struct speed_range *inside;
	double best, best_certain;
	struct margin margin;
	struct wanted_limit low, high;
	bool alike;
	double (*alone)[2];
	double sure[2];
	size_t n_root;
	struct speed_root *root;
	double found, range[2], cut[2];
	struct speed_table *table;
};

/* speed_search_step searches one more speed, and is true when all is known;
 * speed_search_all searches all of them at once.  Free with
 * speed_search_free. */
struct speed_search *speed_search_new(const struct wanted *w);
bool speed_search_step(struct speed_search *s, const struct wanted *w);
struct speed_search *speed_search_all(const struct wanted *w);
void speed_search_free(struct speed_search *s);

/* Returns the range `inside` that contains the best speed; NULL where there is
 * none. */
const struct speed_range *speed_search_around(const struct speed_search *s);

/* Returns the tenth inside the ranges, or where it is sure, at which the
 * target's quantity is largest, or least; NAN where there is none. */
double speed_search_extreme(const struct speed_search *s, bool most, bool sure);

/* At the forecast's speed, which they leave unchanged: wanted_margin returns
 * the margin of a condition's nearer limit, or of all conditions (SIZE_MAX);
 * wanted_holds whether these hold; wanted_certainty the share of draws in which
 * all do. */
struct margin wanted_margin(const struct wanted *w, size_t i);
bool wanted_holds(const struct wanted *w, size_t i);
double wanted_certainty(const struct wanted *w);

#endif
