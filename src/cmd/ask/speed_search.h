/* The only search for the speeds at which a product meets conditions.  It can
 * run in steps, which keeps a screen responsive.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_SPEED_SEARCH_H
#define TIPSPEED_CMD_ASK_SPEED_SEARCH_H

#include <stdbool.h>

#include "cmd/ask/forecast.h"

/* Limits of a quantity, in its own unit; NAN if there is none. */
struct condition {
	struct quantity quantity;
	double least, most;
};

/* A list that grows.  source: the envelope from which limits in the list come,
 * and what in it is not checked, or NULL. */
struct condition_list {
	size_t n;
	struct condition *at;
	char *source;
};
void conditions_add(struct condition_list *list, struct condition condition);
void conditions_free(struct condition_list *list);

/* Condition i concerns quantity i of the forecast; the target, or NULL,
 * concerns the next quantity: it is a value (both limits) to reach, or has no
 * limits if the largest or smallest value is sought.  entry, feed, level: of
 * the question.  from, to: range of speeds, m/s; measured: the slowest and
 * fastest of those that inform the answer; reach: how far beyond them an answer
 * can be relied on (trust_reach_beyond_speeds), INFINITY if they are not known.
 * Unless stated otherwise, functions move the forecast to other speeds. */
struct conditions_search {
	const struct session *s;
	const struct entry *entry;
	size_t feed;
	struct forecast *forecast;
	size_t n;
	const struct condition *at, *target;
	double from, to, measured[2], reach, level;
};

/* Returns conditions [n] of a question, followed by more quantities [n_more],
 * over the speeds of settings_default_speed_range and without a target.  `at`
 * must outlive it; free its `forecast` with forecast_close. */
struct conditions_search wanted_from_question(const struct session *s,
    const struct question *q, size_t n, const struct condition *at,
    size_t n_more, const struct quantity *more);

/* One of the two limits of condition i; none if i is SIZE_MAX. */
struct wanted_limit {
	size_t i;
	bool most;
};

/* The distance from a limit, negative if missed: as a passing 0..1
 * (quantity_excess_as_passing), and in widths of the band there, so that limits
 * on different sieves can be compared (D21) while they hold, NAN for a model
 * alone.  A limit that leaves no room (at least 100 %, at most 0
 * %) must hold but is never close: INFINITY. */
struct margin {
	double passing, widths;
	struct wanted_limit limit;
};

/* The first and last tenth of a m/s at which all conditions hold, and the
 * limits that bind below and above (none at an end of the search).  A range
 * between two tenths has ends exact to 1e-4 m/s. */
struct speed_range {
	double from, to;
	struct wanted_limit low, high;
};

/* A speed that gives the target's value, and whether the conditions hold. */
struct speed_root {
	double speed;
	bool holds;
};

/* speed, certain [n]: each tenth of a m/s, and the share of draws in which all
 * conditions hold there, NAN for a model alone.  The first `done` are known;
 * the members below are known once all are.
 *
 * best: the speed at which the conditions hold most certainly, preferably
 * between the measured speeds; of those within 2 % of that, the one with the
 * largest margin, in widths; if none holds, the one that misses by least.
 * margin: the smallest at that speed.  low, high: the limits that bind below
 * and above, or are missed just below and above the best speed; alike: every
 * speed misses by the same amount.  alone [conditions]: the tenths around the
 * best speed, or nearest to it, at which each condition holds by itself; NAN:
 * up to an end of the search.  sure: the speeds around the best, or else around
 * the most certain, at which the conditions hold with probability `level`; NAN
 * if there are none.  safe: the slowest measured speed from which, up to the
 * best, the conditions hold with 95 % probability; NAN if the best does not.
 * root [n_root]: slowest first.  found: the root nearest to the measured
 * speeds, preferably one at which the conditions hold; NAN: none.
 * range: the middle `level` of the speeds at which the draws give the value;
 * cut: the same for the product that a belt cut would show.  0 and INFINITY:
 * below and above the search; NAN for a model alone.
 *
 * For the search itself, at each speed: step_margin [n][n_condition + 1]: of
 * each condition, then of all; value of the target's quantity and its excess
 * over the target's value, in the answer (over), in the draws and in the draws
 * of one more sample. */
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
	double sure[2], safe;
	size_t n_root;
	struct speed_root *root;
	double found, range[2], cut[2];
	size_t n_condition;
	struct margin *step_margin;
	double *over, *value, (*draw)[POSTERIOR_DRAWS],
	    (*sample)[POSTERIOR_DRAWS];
};

/* speed_search_step searches one more speed and returns true when the search is
 * complete; speed_search_run searches all at once.  Free with
 * speed_search_free. */
struct speed_search *speed_search_new(const struct conditions_search *w);
bool speed_search_step(
    struct speed_search *s, const struct conditions_search *w);
struct speed_search *speed_search_run(const struct conditions_search *w);
void speed_search_free(struct speed_search *s);

/* Returns the range in `inside` that contains the best speed, or NULL. */
const struct speed_range *speed_search_best_range(const struct speed_search *s);

/* Returns the tenth of a m/s inside the ranges (sure: the sure speeds) at which
 * the target's quantity is largest (most) or smallest, or NAN. */
double speed_search_speed_of_extreme(
    const struct speed_search *s, bool most, bool sure);

/* These do not change the forecast's speed.  condition_margin returns
 * the margin of a condition's nearer limit, or for SIZE_MAX that of all
 * conditions; conditions_are_met returns true if these hold;
 * conditions_probability returns the share of draws in which all do. */
struct margin condition_margin(const struct conditions_search *w, size_t i);
bool conditions_are_met(const struct conditions_search *w, size_t i);
double conditions_probability(const struct conditions_search *w);

#endif
