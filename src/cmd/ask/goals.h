/* The goal that is set: what is wanted of the product, and at which speeds it
 * is so.  Conditions as `find` and `window` read them, or an envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_GOALS_H
#define TIPSPEED_CMD_ASK_GOALS_H

#include "cmd/ask/condition.h"

/* list: the conditions; one that is a single value, n_value of them, stands
 * last.  why: what is in the way, or NULL.  found: the search, of the
 * conditions that are ranges with the single value as its target, NULL before
 * it has begun and where something is in the way.
 *
 * What follows is known when it has ended: met [n_met]: the speeds at which the
 * single value is reached and the ranges hold; nearest: the one that misses it
 * least; missed: what is in the way where no speed will do, or NULL; binds: the
 * condition that ends the window, or misses most. */
struct goal {
	struct condition_list list;
	size_t n_value;
	char *why, *missed;
	size_t feed, binds;
	struct speed_search *found;
	size_t n_met;
	double *met, nearest;
};

/* Whether one is set. */
bool goals_set(const struct session *s);

/* Whether a text has a sign or begins with a quantity: else it names an
 * envelope. */
bool goals_is_condition(const char *text);

/* Adds what a text has, with commas between, to an empty list: conditions that
 * a feed has to tell of, NULL: any, and names of envelopes. */
bool goals_read(struct session *s, const char *text, const struct psd *feed,
    struct condition_list *list, size_t *n_value, struct error *error);

/* Forgets what was worked out. */
void goals_clear(struct goal *goal);

/* Whether the one that is set is worked out for the feed of a run, or whether a
 * part of that is to be done; and does one, of a few ms. */
bool goals_known(const struct session *s, const struct goal *goal);
bool goals_pending(
    const struct session *s, const struct goal *goal, size_t feed);
void goals_step(struct session *s, const struct entry *entry, struct goal *goal,
    size_t feed);

/* The best speed, of several the one nearest to `speed`; NAN where none is
 * known. */
double goals_best(
    const struct session *s, const struct goal *goal, double speed);

/* "goal p80=5.4: met at 71.2 m/s", "goal p80>5: met at 65.0 to 75.6 m/s, 80 %
 * certain to 75.3", "goal p80=3: met at no speed, nearest 85.0: P80 4.8 mm";
 * without what was set; without how certain; while it is not known that it is
 * being worked out; "" without a goal.  The caller frees. */
enum goals_length { GOALS_FULL, GOALS_SPEEDS, GOALS_SHORT, GOALS_LENGTHS };
char *goals_words(const struct session *s, const struct entry *entry,
    const struct goal *goal, double speed, enum goals_length length);

#endif
