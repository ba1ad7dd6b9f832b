/* Runs command lines for the full screen, with all they print kept off it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CONTROL_H
#define TIPSPEED_TUI_CONTROL_H

#include "tui/tui_state.h"
#include "tui/view.h"

/* A full screen on a session, as it opens, and its end: what runs is stopped
 * and kept, and the session has its ways again. */
void control_begin(
    struct tui *t, struct session *s, const struct tui_ways *ways);
void control_end(struct tui *t);

/* The one that is open, or NULL. */
const struct tui *control_open(void);

/* Another one that shows the same, for a frame beside it: nothing that is done
 * to it hits the open one, and control_drop is its end.  It has a copy of
 * what is chosen (struct ui), and works the rest out. */
struct tui *control_beside(void);
void control_drop(struct tui *t);

/* Runs a line that a key composed, and shows it.  False with a message where
 * it failed. */
bool control_run(struct tui *t, const char *line);

/* Looks what the session is like after a command that was not run here. */
void control_look(struct tui *t);

/* ---- For cmdline.c ---- */

/* The command of a line; NULL where it has several, or none of that name. */
const struct command *control_command(const char *line);

/* Sets the page and the quantity shown, so that they are saved and come back.
 */
void control_set_looks(struct tui *t);

#endif
