/* What keys and mouse do on the full screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_KEYMAP_H
#define TIPSPEED_TUI_KEYMAP_H

#include "tui/tui_state.h"

/* Takes one key: code as ncurses has it; special: one with a name, no
 * character; the mouse is one such, whose event ncurses holds. */
void keymap_key(struct tui *t, int code, bool special);

/* Whether a character is typed into what takes the keys now. */
bool keymap_types(const struct tui *t, int code);

/* Opens the line of a command where a page has the keys. */
void keymap_open_line(struct tui *t);

/* Does what the held key does, see word.h. */
void keymap_held(struct tui *t);

/* While an answer is waited for: what the mouse did, from the event ncurses
 * holds.  True where that is a key, which answers. */
bool keymap_pointed(struct tui *t, int *code, bool *special);

#endif
