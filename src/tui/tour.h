/* Three steps for who is new to the full screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_TOUR_H
#define TIPSPEED_TUI_TOUR_H

#include "tui/tui_state.h"

/* Begins at the first step; without a site one that comes with the program is
 * loaded, with its parameters in the paper. */
void tour_begin(struct tui *t);

/* Goes to the next step once what the step asks for is done. */
void tour_update(struct tui *t);

/* How many of the rows of a screen it takes, 0 where none is shown, and draws
 * it in that area: nothing is hidden by it. */
int tour_rows(const struct tui *t, int rows, int columns);
void tour_draw(const struct tui *t, const struct area *area);

#endif
