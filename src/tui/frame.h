/* A frame of the full screen: what stands around every page, and the page.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_FRAME_H
#define TIPSPEED_TUI_FRAME_H

#include "tui/tui_state.h"

/* Draws it, with the cursor on the focus. */
void frame_draw(struct tui *t);

#endif
