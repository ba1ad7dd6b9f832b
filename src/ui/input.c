/* What ncurses makes of the bytes, and what it leaves to others.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/input.h"

#include <poll.h>
#include <unistd.h>
#include <wchar.h>

#include <curses.h>

#include "ui/paste.h"
#include "ui/pump.h"

/* The rest of a sequence that the terminal's description does not have would be
 * taken for keys. True where there was one: it came with its Escape at once. */
static bool
pass_over_sequence(void)
{
	wint_t code = 0;
	int got = get_wch(&code);
	if (got == OK && (code == '[' || code == 'O')) {
		bool long_one = code == '[';
		do
			got = get_wch(&code);
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

/* Whether there is more to read: bytes that are no character end get_wch, too.
 */
static bool
more_waits(void)
{
	struct pollfd in = {.fd = STDIN_FILENO, .events = POLLIN};
	return poll(&in, 1, 0) > 0 && in.revents == POLLIN;
}

bool
input_key(struct tui *t, const sigset_t *let_in, int *code, bool *special)
{
	enum { ESCAPE = 27, MUCH = 4096 };
	wint_t c = 0;
	int got;
	for (int n = 1; pump_signal() == 0; n++) {
		if (n % MUCH == 0)
			pump_let_in(let_in);
		got = get_wch(&c);
		if (got == ERR && !more_waits())
			return false;
		if (got == ERR || (got == KEY_CODE_YES && c == KEY_RESIZE))
			continue;
		if (!t->paste.on && got == OK && c == ESCAPE &&
		    pass_over_sequence())
			continue;
		*code = (int)c;
		*special = got == KEY_CODE_YES;
		if (!paste_key(t, *code, *special))
			return true;
		t->pasted = session_clock();
	}
	return false;
}
