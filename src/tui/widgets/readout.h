/* The values at the crosshair, and sizes in words.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_READOUT_H
#define TIPSPEED_TUI_WIDGETS_READOUT_H

#include "tui/tui_state.h"

/* Returns the rows that the readout needs, or 0 if it is off. */
int readout_count_rows(const struct tui *t);

/* Draws each curve's passing at the crosshair and its size at the level, with
 * the cursor if the readout has the focus. */
void readout_draw(struct tui *t, const struct area *area);

/* Returns "2.81 mm", or why there is no such number. */
const char *readout_size_or_reason(double mm, char text[static 24]);

#endif
