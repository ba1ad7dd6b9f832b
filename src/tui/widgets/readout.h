/* What the crosshair reads, and sizes in words.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_READOUT_H
#define TIPSPEED_TUI_WIDGETS_READOUT_H

#include "tui/tui_state.h"

/* Rows that it takes where there is room: 0 where it is off. */
int readout_rows(const struct tui *t);

/* What every curve passes at the crosshair and the size at its level, with the
 * cursor there where it has the focus. */
void readout_draw(struct tui *t, const struct area *area);

/* "2.81 mm", or why there is no such number. */
const char *readout_size(double mm, char text[static 24]);

#endif
