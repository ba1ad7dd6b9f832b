/* The list of files over the page: one is looked at, and opened.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_FILE_PICKER_H
#define TIPSPEED_TUI_WIDGETS_FILE_PICKER_H

#include "tui/tui_state.h"

/* Only a message under --safe. */
void chooser_open(struct tui *t, enum chooser_list list);

/* Takes a key; false: the list is closed and the key is for what was below
 * it. */
bool chooser_key(struct tui *t, int code, bool special);

/* Draws it with its hints. */
void chooser_draw(struct tui *t);

#endif
