/* The goal on the full screen: the field that it is typed into, and where it is
 * met along the track.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_GOAL_H
#define TIPSPEED_TUI_WIDGETS_GOAL_H

#include "cmd/ask/goals.h"
#include "tui/tui_state.h"

/* Whether the goal that is set is worked out, or is to be. */
bool goal_known(const struct tui *t);
bool goal_pending(const struct tui *t);

/* Works out a part of it.  Of an envelope the quantity above the track is then
 * that which binds. */
void goal_step(struct tui *t);

/* Takes the keys of its field; the command that Enter asks for, which the
 * caller frees, or NULL. */
char *goal_key(struct tui *t, int code, bool special);

/* See goals_words. */
char *goal_words(const struct tui *t, enum goals_length length);

/* The best speed; NAN where none is known. */
double goal_best(const struct tui *t);

/* The speeds of the limits, in [most] out.  Returns how many. */
size_t goal_limits(const struct tui *t, double *speed, size_t most);

/* Whether all that is wanted holds between two speeds, and whether that is as
 * sure as bands are. */
bool goal_holds(const struct tui *t, double from, double to, bool *certain);

#endif
