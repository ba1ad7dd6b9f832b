/* Keys as they come from the terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_INPUT_H
#define TIPSPEED_UI_INPUT_H

#include <signal.h>
#include <stdbool.h>

#include "ui/tui_state.h"

/* The next key, if there is one by now; what is pasted is dealt with, and as
 * that may be much, signals of let_in come in meanwhile.  code: of ncurses
 * where special, else a character. */
bool input_key(struct tui *t, const sigset_t *let_in, int *code, bool *special);

#endif
