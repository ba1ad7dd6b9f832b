/* Text on the whole screen: what commands print, and the list of keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_VIEW_H
#define TIPSPEED_UI_VIEW_H

#include "ui/tui_state.h"

/* Shows text, which it takes. */
void view_text(struct tui *t, char *text);

/* Shows the message where its rows have no room for all of it. */
void view_message(struct tui *t);

/* Shows the keys whose line has the word that is looked for. */
void view_keys(struct tui *t);

/* Takes a key: scrolls, filters, or closes.  Returns the key to act on, or
 * NULL. */
const struct key *view_key(struct tui *t, int code, bool special);

/* Draws it with its hints. */
void view_draw(struct tui *t);

void view_close(struct tui *t);

#endif
