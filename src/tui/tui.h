/* The full screen: the session with its curves, moved by keys and mouse.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_TUI_H
#define TIPSPEED_TUI_TUI_H

#include "cmd/session/session.h"

/* Runs the full screen until the user quits.  Where the terminal cannot show
 * it, says so beside the results and returns.  Returns the exit status: 0, or
 * what a signal asks for, see signals_status. */
int tui_run(struct session *s);

#endif
