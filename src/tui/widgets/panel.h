/* The numbers at the slider's speed, beside the curves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_PANEL_H
#define TIPSPEED_TUI_WIDGETS_PANEL_H

#include "tui/tui_state.h"

/* Draws the side panel of page Predict. */
void panel_draw(struct tui *t);

/* Returns what the panel has no room for, or what replaces it: "trust amber:
 * beyond the measured speeds, out of ASTM C33", or "".  It is cut to `columns`,
 * or to `most` if it then has room for the reason.  The caller frees. */
char *panel_words(struct tui *t, int columns, int most);

/* Draws the row of numbers that replaces the side panel, on any page. */
void panel_row(struct tui *t);

#endif
