/* The goal on the full screen: the field in which it is typed, and the speeds
 * on the track that meet it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_GOAL_H
#define TIPSPEED_TUI_WIDGETS_GOAL_H

#include "cmd/ask/goals.h"
#include "tui/tui_state.h"

/* goal_is_search_done returns true if the speeds of the goal have been
 * computed; goal_is_search_needed returns true if they are yet to be. */
bool goal_is_search_done(const struct tui *t);
bool goal_is_search_needed(const struct tui *t);

/* Computes a part of the goal.  When it is complete, the quantity above the
 * track becomes the one that limits the goal, unless the user chose another. */
void goal_run_search_step(struct tui *t);

/* Handles a key in the goal's field.  Returns the command for Enter, which the
 * caller frees, or NULL. */
char *goal_edit_field_by_key(struct tui *t, int code, bool special);

/* goal_is_viewed returns true if page Predict shows the goal at full height.
 * In that case, goal_show_condition_quantity puts the quantity of the selected
 * condition above the track. */
bool goal_is_viewed(const struct tui *t);
void goal_show_condition_quantity(struct tui *t);

/* Returns the share of draws in which all conditions hold at a speed, m/s; NAN
 * if it is not known. */
double goal_probability_at(const struct tui *t, double speed);

/* As goal_probability_at, at the slider's speed.  Returns NAN also for a goal
 * that is a value, and while the site is being calibrated. */
double goal_probability_at_slider(const struct tui *t);

/* Returns the goal in words, see goals_outcome_text.  The caller frees it. */
char *goal_result_text(const struct tui *t, enum goals_length length);

/* Returns the best speed, m/s, or NAN if it is not known. */
double goal_best_speed(const struct tui *t);

/* Writes to speed [most] the speeds, m/s, at which the goal begins or ends or,
 * if it is a value, those that give it; if there are none, the best speed.
 * Returns their number. */
size_t goal_list_limit_speeds(const struct tui *t, double *speed, size_t most);

/* Returns true if all conditions hold at some speed between two.  Sets *certain
 * to whether they do so with the probability of bands. */
bool goal_is_met_between(
    const struct tui *t, double from, double to, bool *certain);

#endif
