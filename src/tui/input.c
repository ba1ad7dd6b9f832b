/* Reads keys from ncurses, and pasted text.  Only the first pasted line is
 * typed: joined lines could mean something else, and nothing that the user has
 * not seen may be run.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/input.h"

#include <poll.h>
#include <unistd.h>
#include <wchar.h>

#include <curses.h>

#include "tui/keymap.h"
#include "cli/signals.h"
#include "tui/screen.h"

/* Longer than any line may be. */
enum { MOST = 2000 };

static void
type_pasted_character(struct tui *t, int code)
{
	struct paste *p = &t->paste;
	bool ends = code == '\n' || code == '\r';
	code = code == '\t' ? ' ' : code;
	if (ends && p->taken > 0)
		p->ended = true;
	/* Control characters are ignored, including those beyond ASCII. */
	if (code < ' ' || (code >= 127 && code < 160))
		return;
	if (p->taken == 0 && !p->ended && code != ' ')
		keymap_open_command_line(t);
	if (code == ':' && t->line.active && t->line.n == 0)
		return;
	if (p->ended || p->taken >= MOST || !keymap_is_typed_as_text(t, code)) {
		p->left = p->left || code != ' ';
		return;
	}
	p->taken++;
	keymap_handle_key(t, code, false);
}

void
input_end_paste(struct tui *t)
{
	const struct paste *p = &t->paste;
	if (p->left && p->taken == 0)
		tui_set_message(t, false,
		    "pasted text was ignored: Esc, then paste it as a command");
	else if (p->left)
		tui_set_message(t, false,
		    "only part of the pasted text was used: the command line "
		    "holds one line");
	t->paste.on = false;
}

bool
input_handle_paste(struct tui *t, int code, bool special)
{
	if (special && code == SCREEN_PASTE)
		t->paste = (struct paste){.on = true};
	else if (!t->paste.on)
		return false;
	else if (special && code == SCREEN_PASTED)
		input_end_paste(t);
	else if (!special)
		type_pasted_character(t, code);
	return true;
}

/* Reads a key with signals unblocked: when a key begins like a mouse event,
 * ncurses waits for the rest of it, even if that never comes. */
static int
read_curses_key(wint_t *code)
{
	signals_unblock();
	int got = get_wch(code);
	signals_block();
	return got;
}

/* Skips an escape sequence that is not in the terminal's description, because
 * its characters would be taken for keys.  Returns true if there was one:
 * unlike an Esc that was typed, its Esc comes together with other
 * characters. */
static bool
skip_escape_sequence(void)
{
	wint_t code = 0;
	int got = read_curses_key(&code);
	if (got == OK && (code == '[' || code == 'O')) {
		bool long_one = code == '[';
		do
			got = read_curses_key(&code);
		while (got == OK && long_one && code < '@');
		if (got == KEY_CODE_YES)
			ungetch((int)code);
		return true;
	}
	if (got == OK)
		unget_wch((wchar_t)code);
	else if (got == KEY_CODE_YES)
		ungetch((int)code);
	return false;
}

/* Returns true if there is more to read.  get_wch fails also on bytes that are
 * not a character. */
static bool
is_input_waiting(void)
{
	struct pollfd in = {.fd = STDIN_FILENO, .events = POLLIN};
	return poll(&in, 1, 0) > 0 && in.revents == POLLIN;
}

bool
input_read_next_key(struct tui *t, int *code, bool *special)
{
	wint_t c = 0;
	if (t->put_back.is) {
		t->put_back.is = false;
		*code = t->put_back.code;
		*special = t->put_back.special;
		return true;
	}
	while (signals_get_ending_or_interrupt() == 0) {
		int got = read_curses_key(&c);
		if (got == ERR && !is_input_waiting())
			return false;
		if (got == ERR || (got == KEY_CODE_YES && c == KEY_RESIZE))
			continue;
		if (!t->paste.on && got == OK && c == ESCAPE &&
		    skip_escape_sequence())
			continue;
		*code = (int)c;
		*special = got == KEY_CODE_YES;
		if (!input_handle_paste(t, *code, *special))
			return true;
		t->pasted = session_clock_seconds();
	}
	return false;
}
