/* The panel of numbers at the slider's speed, beside the curves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_PANEL_H
#define TIPSPEED_TUI_WIDGETS_PANEL_H

#include "tui/tui_state.h"

/* Draws the side panel of page Predict. */
void panel_draw(struct tui *t);

/* Returns the light and the envelope in words, "trust amber: beyond the
 * measured speeds, out of ASTM C33", as far as the side panel does not show
 * them; or "".  The text is cut to `columns`, or to `most` if the reason then
 * fits.  The caller frees it. */
char *panel_trust_text(struct tui *t, int columns, int most);

/* Draws the row of numbers that replaces the side panel, on any page. */
void panel_draw_row_of_numbers(struct tui *t);

#endif
