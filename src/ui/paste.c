/* The first line of what is pasted is typed: lines put together could mean
 * something else, and what nobody has seen is not to be run.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/paste.h"

#include <string.h>

#include "ui/act.h"
#include "ui/screen.h"

/* Longer than any line may be. */
enum { MOST = 2000 };

/* Whether a line takes the character; a speed has but few. */
static bool
is_taken(const struct tui *t, int code)
{
	if (t->question != NULL || t->typing.active)
		return t->question == NULL;
	if (t->viewer.text != NULL)
		return t->viewer.word.active;
	return t->speed.n > 0 && t->speed.n < SPEED_LETTERS &&
	       (code == '.' || (code >= '0' && code <= '9'));
}

static void
take(struct tui *t, int code)
{
	struct paste *p = &t->paste;
	bool ends = code == '\n' || code == '\r';
	code = code == '\t' ? ' ' : code;
	if (ends && p->taken > 0)
		p->ended = true;
	/* Controls, those beyond ASCII too. */
	if (code < ' ' || (code >= 127 && code < 160))
		return;
	if (p->ended || p->taken >= MOST || !is_taken(t, code)) {
		p->left = p->left || code != ' ';
		return;
	}
	p->taken++;
	act_key(t, code, false);
}

void
paste_end(struct tui *t)
{
	const struct paste *p = &t->paste;
	if (p->left && p->taken == 0)
		tui_say(t, false,
		    "pasted text was ignored: press : first to paste it into "
		    "the command line");
	else if (p->left)
		tui_say(t, false,
		    "only part of the pasted text was taken: a "
		    "line takes one line");
	t->paste.on = false;
}

bool
paste_key(struct tui *t, int code, bool special)
{
	if (special && code == SCREEN_PASTE)
		t->paste = (struct paste){.on = true};
	else if (!t->paste.on)
		return false;
	else if (special && code == SCREEN_PASTED)
		paste_end(t);
	else if (!special)
		take(t, code);
	return true;
}
