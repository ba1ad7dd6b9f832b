/* What runs for long, watched on the full screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WATCH_H
#define TIPSPEED_TUI_WATCH_H

#include "tui/tui_state.h"

/* Some steps of the calibration that runs, as many as are due. */
void watch_pump(struct tui *t);

/* Lets the calibration that runs wait, or go on; makes one step of it. */
void watch_hold(struct tui *t, bool hold);
void watch_step(struct tui *t);

/* Stops the calibration that runs, see session_pause, and says what became of
 * it.  Returns the same for behind something else that is said; "" where none
 * ran. */
const char *watch_keep(struct tui *t);

#endif
