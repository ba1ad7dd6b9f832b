/* The goal that is set: conditions on the product, as `find` and `window` read
 * them, or an envelope; and the speeds that meet it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_GOALS_H
#define TIPSPEED_CMD_ASK_GOALS_H

#include "cmd/ask/condition.h"

/* list: the conditions; a single value (n_value of them) is last.  why: what
 * prevents the search, or NULL.  found: the search for the conditions that are
 * ranges, with the single value as its target; NULL before it has begun, and
 * where something prevents it.
 *
 * Known when the search has ended: met [n_met]: the speeds at which the single
 * value is reached and the ranges hold; nearest: the speed that misses it
 * least; missed: what is in the way if no speed meets the goal, or NULL; binds:
 * the condition that ends the window, or misses most. */
struct goal {
	struct condition_list list;
	size_t n_value;
	char *why, *missed;
	size_t feed, binds;
	struct speed_search *found;
	size_t n_met;
	double *met, nearest;
};

/* True if a goal is set. */
bool goals_set(const struct session *s);

/* True if a text has a sign or begins with a quantity; else it names an
 * envelope. */
bool goals_is_condition(const char *text);

/* Reads a text with commas between into an empty list: conditions, on sizes
 * that the feed has to cover, NULL: any, and names of envelopes. */
bool goals_read(struct session *s, const char *text, const struct psd *feed,
    struct condition_list *list, size_t *n_value, struct error *error);

/* Discards what was computed. */
void goals_clear(struct goal *goal);

/* goals_search_done: the goal has been worked out for the feed of a run;
 * goals_need_search: a part of that is left; goals_step: does one part, a few
 * ms. */
bool goals_search_done(const struct session *s, const struct goal *goal);
bool goals_need_search(
    const struct session *s, const struct goal *goal, size_t feed);
void goals_step(struct session *s, const struct entry *entry, struct goal *goal,
    size_t feed);

/* Returns the best speed, of several the one nearest to `speed`; NAN if none is
 * known. */
double goals_best(
    const struct session *s, const struct goal *goal, double speed);

/* "goal p80=5.4: met at 71.2 m/s", "goal p80>5: met at 65.0 to 75.6 m/s, 80 %
 * certain to 75.3", "goal p80=3: met at no speed, nearest 85.0: P80 4.8 mm";
 * GOALS_SPEEDS leaves out the goal, GOALS_PLAIN the certainty, too, and
 * GOALS_SHORT has a ? for what is extrapolated; while it is being worked out
 * they say so; "" without a goal.  The caller frees. */
enum goals_length {
	GOALS_FULL,
	GOALS_SPEEDS,
	GOALS_PLAIN,
	GOALS_SHORT,
	GOALS_LENGTHS
};
char *goals_words(const struct session *s, const struct entry *entry,
    const struct goal *goal, double speed, enum goals_length length);

#endif
