/* Command names, and speeds in rpm, typed where letters and digits are keys.  A
 * letter whose key does more than move waits for a moment: if the next letter
 * continues the name of a command, neither acts as a key.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/word.h"

#include <math.h>

#include "base/xalloc.h"
#include "cmd/lang/command.h"

/* The letters of a word follow each other within this time, s; single keys
 * seldom do. */
static const double GAP = 0.25;

static bool
is_lower_case_letter(int code, bool special)
{
	return !special && code >= 'a' && code <= 'z';
}

static bool
is_digit_key(int code, bool special)
{
	return !special && code >= '0' && code <= '9';
}

bool
word_open_line_on_two_keys(struct tui *t, int code, bool special)
{
	struct held_letter *w = &t->word;
	const char both[] = {w->letter, (char)code, '\0'};
	FREED char *names = command_names_beginning_with(both);
	bool digits = is_digit_key(w->letter, false) &&
		      is_digit_key(code, special) &&
		      tui_slider_range(t).rotor > 0;
	bool letters = is_lower_case_letter(code, special) && names[0] != '\0';
	if (w->letter == '\0' || !(digits || letters) || t->clock - w->at > GAP)
		return false;
	t->ui = w->was;
	*w = (struct held_letter){0};
	t->message[0] = '\0';
	edit_begin(digits ? &t->speed : &t->line, both);
	return true;
}

bool
word_hold_letter_until_next_key(
    struct tui *t, int code, bool special, const struct key *key)
{
	struct held_letter *w = &t->word;
	*w = (struct held_letter){0};
	bool digit = is_digit_key(code, special);
	if (t->aside || !(digit || is_lower_case_letter(code, special)))
		return false;
	bool moves =
	    key == NULL || digit || key->act == act_move_list_or_slider ||
	    key->act == act_move_to_end || key->act == act_move_in_list;
	*w = (struct held_letter){
	    (char)code, t->clock, moves ? NULL : key, t->ui};
	return !moves;
}

double
word_key_delay_seconds_left(const struct tui *t)
{
	return t->word.held != NULL ? fmax(0, t->word.at + GAP - t->clock)
				    : INFINITY;
}

const struct key *
word_pop_delayed_key(struct tui *t)
{
	const struct key *held = t->word.held;
	t->word = (struct held_letter){0};
	return held;
}
