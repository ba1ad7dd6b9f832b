/* The full screen as a picture: drawn as it is on a terminal, but aside of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_SCRIPT_TERMINAL_H
#define TIPSPEED_TUI_SCRIPT_TERMINAL_H

#include "cmd/draw/plot.h"
#include "tui/tui_state.h"

/* Drawn aside of any terminal; the next key that is pressed answers. */
extern const struct tui_ways SCRIPT_WAYS;

/* What the request asks for, see there.  Without an open screen one is begun on
 * the session, its keys do what they do, and it is left.  NULL with an error
 * where a key has no such name, or a signal came. */
struct canvas *script_draw(
    struct session *s, struct screen_request *request, struct error *error);

#endif
