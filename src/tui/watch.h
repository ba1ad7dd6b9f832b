/* Runs the calibration under way while the full screen shows it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WATCH_H
#define TIPSPEED_TUI_WATCH_H

#include "tui/tui_state.h"

/* Runs as many steps of the running calibration as are due. */
void watch_pump(struct tui *t);

/* watch_hold pauses the running calibration, or lets it continue; watch_step
 * runs one step of it. */
void watch_hold(struct tui *t, bool hold);
void watch_step(struct tui *t);

/* Stops the calibration that runs, see session_pause, and says what became of
 * it.  Returns that in words to append to another message; "" where none
 * ran. */
const char *watch_pause(struct tui *t);

#endif
