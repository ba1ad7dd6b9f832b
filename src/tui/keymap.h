/* What keys and mouse do on the full screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_KEYMAP_H
#define TIPSPEED_TUI_KEYMAP_H

#include "tui/tui_state.h"

/* Handles one key: code as ncurses has it; special: a key with a name, not a
 * character.  The mouse is a special key, whose event ncurses holds. */
void keymap_key(struct tui *t, int code, bool special);

/* True if a character is typed into what has the keys now. */
bool keymap_types(const struct tui *t, int code);

/* Opens the command line, where a page has the keys. */
void keymap_open_line(struct tui *t);

/* Does what the held key does, see word.h. */
void keymap_held(struct tui *t);

/* While an answer is waited for: handles the mouse event that ncurses holds.
 * True if it is a key, which answers. */
bool keymap_pointed(struct tui *t, int *code, bool *special);

#endif
