/* The goal in `set goal`, which is an envelope or conditions on the product, as
 * `find` and `window` read them; and the speeds that meet it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_GOALS_H
#define TIPSPEED_CMD_ASK_GOALS_H

#include "cmd/ask/condition.h"

/* The goal as parsed for the feed of a run, and the search for the speeds that
 * meet it. */
struct goal {
	/* The conditions; the last n_value of them are single values. */
	struct condition_list list;
	size_t n_value;
	/* why: what prevents the search, or NULL.  missed: what stands in the
	 * way if no speed meets the goal, or NULL. */
	char *why, *missed;
	/* binds: the condition that limits the range of speeds or, if there is
	 * none, the one missed by most. */
	size_t feed, binds;
	/* The search for the ranges, with a single value as its target; NULL if
	 * it has not begun or cannot. */
	struct speed_search *found;
	/* The speeds, [n_met], that give the single value within the ranges. */
	size_t n_met;
	double *met;
};

/* True if a goal is set. */
bool goals_is_set(const struct session *s);

/* True if a text has a sign or begins with a quantity; otherwise it names an
 * envelope. */
bool goals_is_condition_text(const char *text);

/* Parses conditions and names of envelopes, separated by commas, into an empty
 * list; the last *n_value are single values.  feed: must cover their sizes,
 * unless it is NULL. */
bool goals_parse(struct session *s, const char *text, const struct psd *feed,
    struct condition_list *list, size_t *n_value, struct error *error);

/* Discards the results of the search. */
void goals_discard_results(struct goal *goal);

/* goals_is_search_done is true if the search has ended; goals_is_search_needed
 * is true if part of the search for the feed of a run remains;
 * goals_step_search does one part, which takes a few ms. */
bool goals_is_search_done(const struct session *s, const struct goal *goal);
bool goals_is_search_needed(
    const struct session *s, const struct goal *goal, size_t feed);
void goals_step_search(struct session *s, const struct entry *entry,
    struct goal *goal, size_t feed);

/* Returns the best speed; of several, the one nearest to `speed`.  NAN if it is
 * not known. */
double goals_best_speed(
    const struct session *s, const struct goal *goal, double speed);

enum goals_length {
	/* "goal p80=5.4: met at 71.2 m/s", "goal p80>5: met up to 75.6 m/s, 80
	 * % certain up to 75.3", "goal p80=3: met at no speed from 65 to 85
	 * m/s, nearest 85.0: P80 4.8 mm" */
	GOALS_FULL,
	/* Without the goal. */
	GOALS_SPEEDS,
	/* Only the speeds that are certain. */
	GOALS_PLAIN,
	/* As GOALS_PLAIN, but leaves extrapolation to the track. */
	GOALS_UNMARKED,
	/* As GOALS_UNMARKED, but all speeds that meet the goal. */
	GOALS_SHORT,
	GOALS_LENGTHS
};

/* Returns the outcome of the search in words or, while it runs, says that it
 * does; "" without a goal.  The caller frees it. */
char *goals_outcome_text(const struct session *s, const struct entry *entry,
    const struct goal *goal, double speed, enum goals_length length);

#endif
