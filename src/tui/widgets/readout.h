/* The readout: the values of the curves at the crosshair.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_READOUT_H
#define TIPSPEED_TUI_WIDGETS_READOUT_H

#include "tui/tui_state.h"

/* Returns the number of rows that the readout needs, or 0 if it is off. */
int readout_count_rows(const struct tui *t);

/* Draws the passing of each curve at the crosshair's sieve, and its size at the
 * crosshair's passing. */
void readout_draw_at_crosshair(struct tui *t, const struct area *area);

/* Writes a size, "2.81 mm", or why there is none, to text, and returns text. */
const char *readout_size_or_reason_text(double mm, char text[static 24]);

#endif
