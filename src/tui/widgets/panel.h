/* What the slider's speed gives, beside the curves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_PANEL_H
#define TIPSPEED_TUI_WIDGETS_PANEL_H

#include "tui/tui_state.h"

/* The side panel of page Predict. */
void panel_draw(struct tui *t);

/* What stands for the panel where it has no room: "trust amber, misses ASTM
 * C33", or "".  The caller frees. */
char *panel_words(struct tui *t);

/* The row of numbers that takes the side panel's place, on any page. */
void panel_row(struct tui *t);

#endif
