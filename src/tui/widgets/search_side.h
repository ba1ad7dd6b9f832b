/* The panel of the page Fit: where the search stands, the parameters within
 * their bounds, and how it came together.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_SEARCH_SIDE_H
#define TIPSPEED_TUI_WIDGETS_SEARCH_SIDE_H

#include "tui/tui_state.h"

void search_side_draw(struct tui *t);

/* Chooses the next parameter or the one before. */
void search_side_choose(struct tui *t, int by);

#endif
