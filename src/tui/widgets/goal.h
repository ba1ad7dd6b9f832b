/* The goal on the full screen: the field that it is typed into, and the speeds
 * on the track that meet it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_GOAL_H
#define TIPSPEED_TUI_WIDGETS_GOAL_H

#include "cmd/ask/goals.h"
#include "tui/tui_state.h"

/* goal_known: true if the goal that is set is computed; goal_pending: if it has
 * yet to be. */
bool goal_known(const struct tui *t);
bool goal_pending(const struct tui *t);

/* Computes a part of the goal.  For an envelope the quantity above the track is
 * then the one that binds. */
void goal_step(struct tui *t);

/* Handles the keys of the goal's field; returns the command that Enter asks
 * for, which the caller frees, or NULL. */
char *goal_key(struct tui *t, int code, bool special);

/* Returns the goal in words, see goals_words. */
char *goal_words(const struct tui *t, enum goals_length length);

/* Returns the best speed; NAN if none is known. */
double goal_best(const struct tui *t);

/* Writes the speeds of the limits to [most] out.  Returns how many. */
size_t goal_limits(const struct tui *t, double *speed, size_t most);

/* True if all conditions hold between two speeds; certain: as surely as bands
 * hold. */
bool goal_holds(const struct tui *t, double from, double to, bool *certain);

#endif
