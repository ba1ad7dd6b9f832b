/* Command names, and speeds in rpm, typed where letters and digits are keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WORD_H
#define TIPSPEED_TUI_WORD_H

#include "tui/tui_state.h"

/* If a key is the second letter of a command's name, opens the command line
 * with both letters; if it is the second digit of a speed in rpm, begins the
 * speed.  Reverses what the first key did, and returns true. */
bool word_open_line_on_two_keys(struct tui *t, int code, bool special);

/* Holds a key that may begin such a name and returns true if it is held.
 * Without a terminal, no key is held. */
bool word_hold_letter_until_next_key(
    struct tui *t, int code, bool special, const struct key *key);

/* Returns the time until the held key acts, s, or INFINITY if none is held. */
double word_key_delay_seconds_left(const struct tui *t);

/* Returns the held key, or NULL, and releases it. */
const struct key *word_pop_delayed_key(struct tui *t);

#endif
