/* Words that are typed where letters are keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WORD_H
#define TIPSPEED_TUI_WORD_H

#include "tui/tui_state.h"

/* Whether a key is the second letter of the name of a command: then there is a
 * line with both, and what the first one moved is as it was. */
bool word_goes_on(struct tui *t, int code, bool special);

/* A key that may begin such a name; true: it is held.  Without a terminal none
 * is. */
bool word_begins(struct tui *t, int code, bool special, const struct key *key);

/* How long until the held key is one, s; INFINITY: none is held. */
double word_wait(const struct tui *t);

/* The key that is held, or NULL; none is any longer. */
const struct key *word_held(struct tui *t);

#endif
