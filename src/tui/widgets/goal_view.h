/* The goal at full height on page Predict: a list of its conditions and, below
 * it, the curve of the chosen one at all speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_GOAL_VIEW_H
#define TIPSPEED_TUI_WIDGETS_GOAL_VIEW_H

#include "tui/tui_state.h"

/* Returns the number of rows that the list needs, or 0 if the goal is not
 * shown. */
int goal_view_count_rows(const struct tui *t);

/* Draws the list in the body, and how likely the goal is met at the slider's
 * speed. */
void goal_view_draw(struct tui *t);

#endif
