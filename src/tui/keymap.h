/* Handling of keys and mouse on the full screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_KEYMAP_H
#define TIPSPEED_TUI_KEYMAP_H

#include "tui/tui_state.h"

/* Handles one key.  special: code is that of a named key of ncurses, not a
 * character.  The mouse is a special key, whose event ncurses holds. */
void keymap_handle_key(struct tui *t, int code, bool special);

/* True if a character would now be typed as text. */
bool keymap_is_typed_as_text(const struct tui *t, int code);

/* Opens the command line, if a page has the focus. */
void keymap_open_command_line(struct tui *t);

/* Runs the action of the held key, see word.h. */
void keymap_run_delayed_key(struct tui *t);

/* Handles the mouse event that ncurses holds while the program waits for an
 * answer: if an area stands for a key, that key is read next. */
void keymap_handle_question_mouse(struct tui *t);

#endif
