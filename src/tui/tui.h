/* The full screen: a session with its curves, controlled by keys and mouse.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_TUI_H
#define TIPSPEED_TUI_TUI_H

#include "cmd/session/session.h"

/* Runs the full screen until the user quits.  Returns the exit status: 0, that
 * of a signal (see signals_exit_status), or, if the terminal cannot show the
 * screen, ERROR_SYSTEM after a note. */
int tui_run(struct session *s);

#endif
