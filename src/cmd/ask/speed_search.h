/* Finds the speeds at which a product meets conditions.  No other search for
 * these exists.  It can run in steps, so that the screen keeps responding.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_SPEED_SEARCH_H
#define TIPSPEED_CMD_ASK_SPEED_SEARCH_H

#include <stdbool.h>

#include "cmd/ask/forecast.h"

/* A quantity and its limits, in its own unit; NAN where there is no limit. */
struct condition {
	struct quantity quantity;
	double least, most;
};

struct condition_list {
	size_t n;
	struct condition *at;
	/* The envelope that set limits in the list, and which of its limits are
	 * not checked; or NULL. */
	char *source;
};
void conditions_add(struct condition_list *list, struct condition condition);
void conditions_free(struct condition_list *list);

/* What to search for.  Unless stated otherwise, functions that are given this
 * move its forecast to other speeds. */
struct conditions_search {
	const struct session *s;
	/* The site and the feed of the question. */
	const struct entry *entry;
	size_t feed;
	/* Forecasts the quantity of condition i as quantity i, and that of the
	 * target as quantity n. */
	struct forecast *forecast;
	size_t n;
	/* The conditions [n], and the target or NULL.  The target is a value to
	 * reach, as both limits, or has no limits if the largest or smallest
	 * value is sought. */
	const struct condition *at, *target;
	/* from, to: the range to search, m/s.  measured: the slowest and the
	 * fastest speed that inform the answer.  reach: how far beyond them an
	 * answer can be relied on (trust_reach_beyond_speeds), m/s; INFINITY if
	 * they are not known.  level: the probability of the band, 0..1. */
	double from, to, measured[2], reach, level;
};

/* Returns a search for a question's conditions [n] over
 * settings_default_speed_range, without a target.  The forecast also has the
 * quantities in more [n_more]. `at` must outlive it; free its `forecast` with
 * forecast_close. */
struct conditions_search conditions_search_from_question(
    const struct session *s, const struct question *q, size_t n,
    const struct condition *at, size_t n_more, const struct quantity *more);

/* One of the two limits of condition i; no limit if i is SIZE_MAX. */
struct wanted_limit {
	size_t i;
	bool most;
};

/* The distance to a limit, negative if the limit is missed.  A limit that
 * leaves no room on its other side (at least 100 %, at most 0 %) has to hold,
 * but is never close: INFINITY. */
struct margin {
	/* As a passing 0..1 (quantity_excess_as_passing), and in widths of the
	 * band there, by which limits on different sieves are compared while
	 * they hold (D21); NAN for a model alone. */
	double passing, widths;
	struct wanted_limit limit;
};

/* A range of speeds in which all conditions hold. */
struct speed_range {
	/* The first and last tenth of a m/s.  If the range lies between two
	 * tenths, its ends are exact to 1e-4 m/s. */
	double from, to;
	/* The limits that are missed just below and just above; none at an end
	 * of the search. */
	struct wanted_limit low, high;
};

/* A speed at which the target's value is reached, and whether the conditions
 * hold there. */
struct speed_root {
	double speed;
	bool holds;
};

/* The state of a search, and its results, which are known once all speeds are
 * done.  A speed that does not exist is NAN. */
struct speed_search {
	/* The number of speeds, and how many of them are done. */
	size_t n, done;
	/* speed [n]: each tenth of a m/s, and the ends of the range.  certain
	 * [n]: the share of the draws in which all conditions hold there; NAN
	 * for a model alone. */
	double *speed, *certain;
	/* The ranges [n_inside] in which all conditions hold. */
	size_t n_inside;
	struct speed_range *inside;
	/* The best speed, and the share of the draws in which all conditions
	 * hold there.  It is the speed at which they hold most certainly,
	 * within the measured speeds if they hold anywhere there; of those less
	 * certain by at most 0.02, the one with the largest margin in widths.
	 * If they hold nowhere, it is the speed that misses by least. */
	double best, best_certain;
	/* The smallest margin at the best speed. */
	struct margin margin;
	/* The limits at the ends of the range around the best speed; without a
	 * range, those missed by most just below and above it. */
	struct wanted_limit low, high;
	/* True if every speed misses by the same amount. */
	bool alike;
	/* For each condition: the first and last tenth of the range in which it
	 * holds, whatever the others do, around the best speed or nearest to
	 * it.  NAN at an end of the search. */
	double (*alone)[2];
	/* sure: the range in which the conditions hold with probability
	 * `level`, around the best speed if it includes that, otherwise around
	 * the most certain one.  safe: the slowest speed, within the measured
	 * ones, from which up to the best the conditions hold with 95 %
	 * probability. */
	double sure[2], safe;
	/* The speeds that reach the target's value, slowest first. */
	size_t n_root;
	struct speed_root *root;
	/* found: the root nearest to the measured speeds, of those at which the
	 * conditions hold if there are any.  range: the middle `level` of the
	 * speeds at which the draws reach the value.  cut: the same for what a
	 * belt cut would show.  Their ends are 0 below the search and INFINITY
	 * above it; NAN for a model alone. */
	double found, range[2], cut[2];
	/* What the search keeps for each speed.  step_margin [n][n_condition +
	 * 1]: the margin of each condition and, last, the smallest.  value: the
	 * target's quantity; over: by how much it exceeds the target's value.
	 * draw, sample: this excess in each draw, and in each draw of one more
	 * sample. */
	size_t n_condition;
	struct margin *step_margin;
	double *over, *value, (*draw)[POSTERIOR_DRAWS],
	    (*sample)[POSTERIOR_DRAWS];
};

/* speed_search_step does one more speed, and returns true once all are done;
 * speed_search_run does them all.  Free with speed_search_free. */
struct speed_search *speed_search_new(const struct conditions_search *w);
bool speed_search_step(
    struct speed_search *s, const struct conditions_search *w);
struct speed_search *speed_search_run(const struct conditions_search *w);
void speed_search_free(struct speed_search *s);

/* Returns the range in `inside` that contains the best speed, or NULL. */
const struct speed_range *speed_search_best_range(const struct speed_search *s);

/* Returns the tenth of a m/s at which the target's quantity is largest (most)
 * or smallest, of those at which all conditions hold or (sure) those in the
 * sure range; NAN if there is none. */
double speed_search_speed_of_max_or_min(
    const struct speed_search *s, bool most, bool sure);

/* These do not move the forecast.  condition_margin returns the margin to the
 * nearer limit of condition i, or the smallest of all conditions if i is
 * SIZE_MAX; conditions_are_met returns true if condition i, or all, hold;
 * conditions_probability returns the share of the draws in which all do. */
struct margin condition_margin(const struct conditions_search *w, size_t i);
bool conditions_are_met(const struct conditions_search *w, size_t i);
double conditions_probability(const struct conditions_search *w);

#endif
