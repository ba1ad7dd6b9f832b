/* The full screen as a picture, drawn as on a terminal but without one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_SCRIPT_TERMINAL_H
#define TIPSPEED_TUI_SCRIPT_TERMINAL_H

#include "cmd/draw/plot.h"
#include "tui/tui_state.h"

/* Callbacks for a screen drawn without a terminal; the next key of the script
 * answers questions. */
extern const struct tui_callbacks SCRIPT_CALLBACKS;

/* Draws the picture of a request, see struct screen_request.  If no screen is
 * open, opens one on the session, presses the keys, and closes it.  Returns
 * NULL with an error if a key's name is unknown or on a signal. */
struct canvas *script_draw_screen(
    struct session *s, struct screen_request *request, struct error *error);

#endif
