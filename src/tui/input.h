/* Keys from the terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_INPUT_H
#define TIPSPEED_TUI_INPUT_H

#include <stdbool.h>

#include "tui/tui_state.h"

/* Reads the next key.  Returns false if there is none, or on a signal.  Handles
 * pasted text itself.  code: a key code of ncurses if special, else a
 * character. */
bool input_read_next_key(struct tui *t, int *code, bool *special);

/* Handles pasted text, which terminals enclose in marks: it is typed into the
 * open line and never run.  Returns true for a mark and for text between marks,
 * which are then handled. */
bool input_handle_paste(struct tui *t, int code, bool special);

/* Ends pasted text.  Called at its end mark, or if that never arrives. */
void input_end_paste(struct tui *t);

#endif
