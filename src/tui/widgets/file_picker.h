/* The list of files over the page, for previewing and opening one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_FILE_PICKER_H
#define TIPSPEED_TUI_WIDGETS_FILE_PICKER_H

#include "tui/tui_state.h"

/* Opens a list of files; with --safe, only shows a message. */
void file_picker_open(struct tui *t, enum picker_list list);

/* Handles a key.  Returns false if the key closed the list and is still to be
 * handled by the page below it. */
bool file_picker_handle_key(struct tui *t, int code, bool special);

/* Draws the list with its hints. */
void file_picker_draw(struct tui *t);

#endif
