/* Keys as they come from the terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_INPUT_H
#define TIPSPEED_TUI_INPUT_H

#include <stdbool.h>

#include "tui/tui_state.h"

/* The next key, if there is one by now; what is pasted is dealt with, and as
 * that may be much, signals come in meanwhile.  code: of ncurses where special,
 * else a character. */
bool input_key(struct tui *t, int *code, bool *special);

/* Text that is pasted stands between marks that terminals put around it: it is
 * typed into the line that is open, and never run.  True for a mark and for
 * what stands between two, which is dealt with. */
bool input_paste(struct tui *t, int code, bool special);

/* The end of what is pasted, also where its mark does not come. */
void input_end_paste(struct tui *t);

#endif
