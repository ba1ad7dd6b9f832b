/* The goal at full height on page Predict: its conditions in a list, the curve
 * of the chosen one at all speeds below them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_GOAL_VIEW_H
#define TIPSPEED_TUI_WIDGETS_GOAL_VIEW_H

#include "tui/tui_state.h"

/* Returns the rows that the list needs, or 0 if the goal is not viewed. */
int goal_view_count_rows(const struct tui *t);

/* Draws the list in the body, and how well the goal is met at the slider's
 * speed. */
void goal_view_draw(struct tui *t);

#endif
