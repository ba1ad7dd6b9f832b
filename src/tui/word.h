/* Command names, and speeds in rpm, typed where letters and digits are keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WORD_H
#define TIPSPEED_TUI_WORD_H

#include "tui/tui_state.h"

/* If a key is the second letter of a command's name, opens the command line
 * with both letters, reverses what the first letter moved, and returns true. */
bool word_open_cmdline_on_two_letters(struct tui *t, int code, bool special);

/* If a key is the second digit of a speed in rpm, whose first digit opened a
 * page, goes back to the page before it, begins the speed with both digits, and
 * returns true. */
bool word_open_speed_on_two_digits(struct tui *t, int code, bool special);

/* Holds a key that may begin such a name and returns true if it is held.
 * Without a terminal, no key is held. */
bool word_hold_letter_until_next_key(
    struct tui *t, int code, bool special, const struct key *key);

/* Returns the time until the held key acts, s, or INFINITY if none is held. */
double word_key_delay_seconds_left(const struct tui *t);

/* Returns the held key, or NULL, and releases it. */
const struct key *word_pop_delayed_key(struct tui *t);

#endif
