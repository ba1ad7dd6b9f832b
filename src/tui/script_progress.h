/* The progress of a running line or script on the full screen; Esc stops it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_SCRIPT_PROGRESS_H
#define TIPSPEED_TUI_SCRIPT_PROGRESS_H

#include "tui/tui_state.h"

/* Notes that a typed line starts running. */
void script_progress_start_typed_line(struct tui *t, const char *line);

/* See `begins` in struct driver; of: a struct tui *.  Shows the line, then
 * checks for Esc again. */
void script_progress_start_line(void *of, const char *line);

/* As script_progress_start_line, but during a line, whenever its progress
 * changes. */
void script_progress_draw(struct tui *t);

/* Reports at the end whether the line was stopped and, for a script, which
 * sites it left loaded.  restores: it restored a session. */
void script_progress_end(struct tui *t, bool restores, bool ok);

#endif
