/* A line or a script that runs, told on the full screen: what it is at, and Esc
 * stops it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_SCRIPT_PROGRESS_H
#define TIPSPEED_TUI_SCRIPT_PROGRESS_H

#include "tui/tui_state.h"

/* A line that was typed runs from now on. */
void script_progress_typed(struct tui *t, const char *line);

/* See struct driver, of = struct tui *: the line, after which somebody looks
 * for Esc again. */
void script_progress_begins(void *of, const char *line);

/* The same in the midst of a line, as often as it changes. */
void script_progress_draw(struct tui *t);

/* What is left to say at its end: of one that was stopped, and of a session
 * that is there again (restores). */
void script_progress_end(struct tui *t, bool restores, bool ok);

#endif
