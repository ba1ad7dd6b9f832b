/* Text on the whole screen: output of commands, and the list of keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_VIEWER_H
#define TIPSPEED_TUI_WIDGETS_VIEWER_H

#include "tui/tui_state.h"

/* Shows text and takes ownership of it. */
void viewer_show_text(struct tui *t, char *text);

/* Shows the message on the whole screen if it does not fit in its rows. */
void viewer_show_long_message(struct tui *t);

/* Handles a key: scrolls, searches for a word, or closes the text.  If the key
 * is not for the text, closes it and returns false; the key then acts as usual.
 * *run: set to a key chosen from the list of keys, else unchanged. */
bool viewer_handle_key(
    struct tui *t, int code, bool special, const struct key **run);

/* Draws the text with its hints. */
void viewer_draw(struct tui *t);

/* Moves the text, or the choice of a key, by a number of lines. */
void viewer_scroll(struct tui *t, int by);

/* Closes the text.  Text other than the list of keys can be shown again. */
void viewer_close(struct tui *t);

#endif
