/* A frame of the full screen: the page and its surroundings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_FRAME_H
#define TIPSPEED_TUI_FRAME_H

#include "tui/tui_state.h"

/* Draws a frame, with the cursor on the focus. */
void frame_draw(struct tui *t);

#endif
