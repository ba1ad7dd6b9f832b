/* Runs command lines for the full screen, and keeps their output off it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CONTROL_H
#define TIPSPEED_TUI_CONTROL_H

#include "tui/tui_state.h"
#include "tui/view.h"

/* control_begin opens a full screen on a session; control_end closes it: a
 * running calibration is stopped and kept, and the session's streams and hooks
 * are restored. */
void control_begin(
    struct tui *t, struct session *s, const struct tui_ways *ways);
void control_end(struct tui *t);

/* Returns the full screen that is open, or NULL. */
struct tui *control_screen(void);

/* Runs a line that a key composed, and shows it.  False with a message where
 * it failed. */
bool control_run(struct tui *t, const char *line);

/* Updates the screen after a command that was not run here. */
void control_refresh(struct tui *t);

/* ---- For cmdline.c ---- */

/* Returns the command of a line; NULL if the line has several, or no known
 * one. */
const struct command *control_find_command(const char *line);

/* Stores the page and the quantity shown as settings, so that they are saved
 * and restored. */
void control_set_looks(struct tui *t);

#endif
