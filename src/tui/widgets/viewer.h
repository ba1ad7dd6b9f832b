/* Text on the whole screen: what commands print, and the list of keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_VIEWER_H
#define TIPSPEED_TUI_WIDGETS_VIEWER_H

#include "tui/tui_state.h"

/* Shows text, which it takes. */
void viewer_text(struct tui *t, char *text);

/* Shows the message where its rows have no room for all of it. */
void viewer_message(struct tui *t);

/* Shows the keys whose line has the word that is looked for. */
void viewer_keys(struct tui *t);

/* Takes a key: scrolls, looks for a word, or closes.  False where it is none
 * of the text's, which is closed then, and does what it does without.  run: the
 * key chosen from the list of keys, else left alone. */
bool viewer_key(struct tui *t, int code, bool special, const struct key **run);

/* Draws it with its hints. */
void viewer_draw(struct tui *t);

/* Moves the text, or the key that is chosen, by so many lines. */
void viewer_scroll(struct tui *t, int by);

/* Closes it; what was printed can be shown again. */
void viewer_close(struct tui *t);

#endif
