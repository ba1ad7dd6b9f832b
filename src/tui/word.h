/* Names of commands typed where letters are keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WORD_H
#define TIPSPEED_TUI_WORD_H

#include "tui/tui_state.h"

/* True if a key is the second letter of a command's name: then the command line
 * is opened with both letters, and what the first letter moved is put back. */
bool word_opens_line(struct tui *t, int code, bool special);

/* Holds a key that may begin such a name; true if it is held.  Without a
 * terminal no key is held. */
bool word_begins(struct tui *t, int code, bool special, const struct key *key);

/* How long until the held key is one, s; INFINITY: none is held. */
double word_wait(const struct tui *t);

/* Returns the key that is held, or NULL, and lets go of it. */
const struct key *word_take_held(struct tui *t);

#endif
