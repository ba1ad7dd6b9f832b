/* The goal in `set goal`: conditions on the product, as read by `find` and
 * `window`, or an envelope; and the speeds that meet it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_GOALS_H
#define TIPSPEED_CMD_ASK_GOALS_H

#include "cmd/ask/condition.h"

/* list: the conditions; single values (n_value of them) are last.  why: what
 * prevents the search, or NULL.  found: the search for the ranges, with a
 * single value as its target; NULL if not begun or prevented.
 *
 * Set by the search: met [n_met] are the speeds that give the single value
 * within the ranges; missed says what stands in the way if no speed meets the
 * goal, or is NULL; binds is the condition that limits the window or, without a
 * window, is missed most. */
struct goal {
	struct condition_list list;
	size_t n_value;
	char *why, *missed;
	size_t feed, binds;
	struct speed_search *found;
	size_t n_met;
	double *met;
};

/* True if a goal is set. */
bool goals_is_set(const struct session *s);

/* True if a text has a sign or begins with a quantity; otherwise it names an
 * envelope. */
bool goals_is_condition(const char *text);

/* Parses conditions and names of envelopes, separated by commas, into an empty
 * list.  feed: must cover their sizes, unless NULL. */
bool goals_parse(struct session *s, const char *text, const struct psd *feed,
    struct condition_list *list, size_t *n_value, struct error *error);

/* Discards what was computed. */
void goals_discard_results(struct goal *goal);

/* goals_is_search_done: true if the search has ended; goals_is_search_needed:
 * true if part of the search for the feed of a run remains; goals_step_search:
 * does one part, in a few ms. */
bool goals_is_search_done(const struct session *s, const struct goal *goal);
bool goals_is_search_needed(
    const struct session *s, const struct goal *goal, size_t feed);
void goals_step_search(struct session *s, const struct entry *entry,
    struct goal *goal, size_t feed);

/* Returns the best speed, the nearest to `speed` of several, or NAN if not
 * known. */
double goals_best_speed(
    const struct session *s, const struct goal *goal, double speed);

/* "goal p80=5.4: met at 71.2 m/s", "goal p80>5: met up to 75.6 m/s, 80 %
 * certain up to 75.3", "goal p80=3: met at no speed from 65 to 85 m/s, nearest
 * 85.0: P80 4.8 mm".
 * GOALS_SPEEDS omits the goal; GOALS_PLAIN has only the speeds that are
 * certain; GOALS_UNMARKED leaves extrapolation to the track, and so does
 * GOALS_SHORT, which has all speeds, not only the certain ones.  During the
 * search, the text says so; without a goal, it is "".  The caller frees it. */
enum goals_length {
	GOALS_FULL,
	GOALS_SPEEDS,
	GOALS_PLAIN,
	GOALS_UNMARKED,
	GOALS_SHORT,
	GOALS_LENGTHS
};
char *goals_outcome_text(const struct session *s, const struct entry *entry,
    const struct goal *goal, double speed, enum goals_length length);

#endif
