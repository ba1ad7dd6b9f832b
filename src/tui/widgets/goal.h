/* The goal on the full screen: the field in which it is typed, and the speeds
 * on the track that meet it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_GOAL_H
#define TIPSPEED_TUI_WIDGETS_GOAL_H

#include "cmd/ask/goals.h"
#include "tui/tui_state.h"

/* goal_is_known returns true if the goal has been computed, goal_is_pending if
 * it has yet to be. */
bool goal_is_known(const struct tui *t);
bool goal_is_pending(const struct tui *t);

/* Computes a part of the goal.  The quantity above the track then becomes the
 * one that limits an envelope. */
void goal_compute_step(struct tui *t);

/* Handles a key in the goal's field.  Returns the command for Enter, which the
 * caller frees, or NULL. */
char *goal_handle_key(struct tui *t, int code, bool special);

/* True if page Predict shows the goal at full height. goal_show_chosen_quantity
 * then makes the quantity above the track that of the condition chosen there.
 */
bool goal_is_viewed(const struct tui *t);
void goal_show_chosen_quantity(struct tui *t);

/* Returns the share of draws in which all conditions hold at a speed; NAN: not
 * known. */
double goal_probability_at(const struct tui *t, double speed);

/* The same at the slider's speed; NAN also for a goal that is a value, and
 * while the site is being calibrated. */
double goal_probability_at_slider(const struct tui *t);

/* Returns the goal in words, see goals_outcome_text. */
char *goal_in_words(const struct tui *t, enum goals_length length);

/* Returns the best speed, or NAN if not known. */
double goal_best_speed(const struct tui *t);

/* Lists the speeds at the limits, speed [most] out.  Returns their number. */
size_t goal_limit_speeds(const struct tui *t, double *speed, size_t most);

/* True if all conditions hold between two speeds.  certain: out, with the
 * probability of bands. */
bool goal_is_met_between(
    const struct tui *t, double from, double to, bool *certain);

#endif
