/* The panel of the page Fit: the state of the search, the parameters within
 * their bounds, and the convergence.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_SEARCH_SIDE_H
#define TIPSPEED_TUI_WIDGETS_SEARCH_SIDE_H

#include "tui/tui_state.h"

void search_side_draw(struct tui *t);

/* Chooses the parameter `by` places after the chosen one. */
void search_side_choose_parameter(struct tui *t, int by);

#endif
