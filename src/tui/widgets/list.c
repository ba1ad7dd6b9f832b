/* Choosing, opening and filtering rows, whatever they show.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/list.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "tui/acts.h"
#include "tui/pages.h"

static const struct page_list *
list_of(const struct tui *t)
{
	return t->picker.on ? t->picker.rows : pages_open(t)->list;
}

static void
list_go(struct tui *t, size_t i)
{
	if (list_of(t)->at(t) != i)
		list_of(t)->go(t, i);
}

static size_t
list_total(const struct tui *t)
{
	return list_of(t) != NULL ? list_of(t)->n(t) : 0;
}

static bool
has_rows(const struct tui *t)
{
	return list_total(t) > 0;
}

static bool
list_has_word(const struct tui *t, size_t i)
{
	if (t->filter.n == 0 || list_of(t)->text == NULL)
		return true;
	char *text = list_of(t)->text(t, i);
	bool has = text_has(text, t->filter.text);
	free(text);
	return has;
}

size_t
rows_next(const struct tui *t, size_t i)
{
	size_t n = list_total(t);
	do
		i++;
	while (i < n && !list_has_word(t, i));
	return i;
}

/* The one before i, or i itself. */
static size_t
list_before(const struct tui *t, size_t i)
{
	size_t to = i;
	while (to-- > 0)
		if (list_has_word(t, to))
			return to;
	return i;
}

size_t
rows_count(const struct tui *t)
{
	size_t n = 0;
	for (size_t i = 0; i < list_total(t); i++)
		n += list_has_word(t, i);
	return n;
}

/* The cursor onto a row that is shown: there, after it, or before it. */
static void
list_settle(struct tui *t)
{
	size_t n = list_total(t), at = list_of(t)->at(t);
	at = n == 0 ? 0 : at < n ? at : n - 1;
	if (n > 0 && !list_has_word(t, at)) {
		size_t next = rows_next(t, at);
		at = next < n ? next : list_before(t, at);
	}
	list_go(t, at);
}

static void
list_move(struct tui *t, int by)
{
	list_settle(t);
	size_t at = list_of(t)->at(t), n = list_total(t);
	for (; by > 0 && rows_next(t, at) < n; by--)
		at = rows_next(t, at);
	for (; by < 0 && list_before(t, at) != at; by++)
		at = list_before(t, at);
	list_go(t, at);
}

size_t
rows_first(struct tui *t, size_t room)
{
	size_t *top = t->picker.on ? &t->picker.top : &t->ui.top[t->ui.page];
	list_settle(t);
	size_t first = list_of(t)->at(t), shown = 1, n = list_total(t);
	if (n == 0 || !list_has_word(t, first))
		return n;
	for (; first > *top && shown < room && list_before(t, first) != first;
	     shown++)
		first = list_before(t, first);
	/* At the end of the list no row is left blank. */
	for (size_t i = list_of(t)->at(t); rows_next(t, i) < n; shown++)
		i = rows_next(t, i);
	for (; shown < room && list_before(t, first) != first; shown++)
		first = list_before(t, first);
	*top = first;
	return first;
}

bool
rows_here(const struct tui *t)
{
	return list_of(t) != NULL;
}

static void
open_row(struct tui *t)
{
	if (list_of(t)->open != NULL && list_has_word(t, list_of(t)->at(t)))
		list_of(t)->open(t);
}

static void
touch_row(struct tui *t, const struct touched *touched)
{
	/* Another page may have been opened since the frame was drawn. */
	if (list_of(t) == NULL)
		return;
	size_t at = list_of(t)->at(t);
	bool again = at == touched->item;
	list_go(t, touched->item);
	if (again)
		open_row(t);
}

static void
list_touch_wheel(struct tui *t, const struct touched *touched)
{
	if (list_of(t) != NULL)
		list_move(t, touched->by);
}

void
rows_touch(struct tui *t, struct area area, size_t i)
{
	hits_add(&t->hits, HIT_PRESS, area, touch_row, i);
}

void
rows_wheel(struct tui *t, struct area area)
{
	hits_add(&t->hits, HIT_WHEEL, area, list_touch_wheel, 0);
}

/* Keys that move the slider where there is no list. */
static bool
list_moves(struct tui *t, const struct key *key)
{
	int page = t->layout.body.rows > 3 ? t->layout.body.rows - 2 : 1;
	int steps = abs(key->amount);
	if (key->act == act_ends)
		list_move(t, key->amount == TO_LEAST ? -INT_MAX : INT_MAX);
	else if (steps == FAR)
		list_move(t, key->amount > 0 ? -page : page);
	else if (steps == STEP)
		list_move(t, key->amount);
	else
		return false;
	return true;
}

bool
rows_move(struct tui *t, const struct key *key)
{
	if (list_of(t) == NULL)
		return false;
	/* Several keys may come before the next frame. */
	if (!t->picker.on)
		pages_update(t);
	if (!has_rows(t))
		return false;
	if (key->act != act_list)
		return list_moves(t, key);
	list_move(t, key->amount);
	return true;
}

void
act_choose(struct tui *t, const struct key *key)
{
	(void)key;
	if (list_of(t) != NULL)
		pages_update(t);
	if (has_rows(t) && list_of(t)->open != NULL)
		open_row(t);
	else
		tui_say(t, false, "there is nothing to open on this page");
}

void
act_filter(struct tui *t, const struct key *key)
{
	(void)key;
	if (list_of(t) == NULL || list_of(t)->text == NULL) {
		tui_say(t, false,
		    "this page has no list to look through: Sites, ? and texts "
		    "have");
		return;
	}
	t->message[0] = '\0';
	t->filter.active = true;
}

bool
rows_letter(struct tui *t, int code, bool special)
{
	if (!t->filter.active || list_of(t) == NULL)
		return false;
	if (code == '\n' || code == '\r') {
		t->filter.active = false;
		return true;
	}
	if (!edit_letter(&t->filter, code, special, VIEWER_WORD))
		return false;
	list_settle(t);
	return true;
}

bool
rows_forget(struct tui *t)
{
	if (!t->filter.active && t->filter.n == 0)
		return false;
	edit_begin(&t->filter, "");
	t->filter.active = false;
	return true;
}
