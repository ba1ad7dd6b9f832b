/* The list of files over the page: one is looked at, and opened.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_FILE_PICKER_H
#define TIPSPEED_TUI_WIDGETS_FILE_PICKER_H

#include "tui/tui_state.h"

/* Only a message under --safe. */
void picker_open(struct tui *t, enum picker_list list);

/* Takes a key; false: the list is closed and the key is for what was below
 * it. */
bool picker_key(struct tui *t, int code, bool special);

/* Draws it with its hints. */
void picker_draw(struct tui *t);

#endif
