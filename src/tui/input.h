/* Keys as they come from the terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_INPUT_H
#define TIPSPEED_TUI_INPUT_H

#include <stdbool.h>

#include "tui/tui_state.h"

/* Reads the next key, if there is one by now.  Pasted text is handled meanwhile
 * and, as it may be long, signals are let in.  code: as ncurses has it where
 * special, else a character. */
bool input_key(struct tui *t, int *code, bool *special);

/* Handles pasted text, which terminals enclose in marks: it is typed into the
 * line that is open, and never run.  True for a mark and for text between two
 * marks, which is then handled. */
bool input_paste(struct tui *t, int code, bool special);

/* Ends pasted text, also where its end mark does not arrive. */
void input_end_paste(struct tui *t);

#endif
