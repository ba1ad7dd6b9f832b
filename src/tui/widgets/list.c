/* Selects, opens, filters and draws rows of any kind, and lays out columns.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/list.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "tui/acts.h"
#include "tui/pages.h"
#include "tui/screen.h"

static const struct page_list *
list_of(const struct tui *t)
{
	return t->picker.on ? t->picker.rows : pages_open(t)->list;
}

static struct list *
list_state(struct tui *t)
{
	return t->picker.on ? &t->picker.list : &t->ui.list[t->ui.page];
}

static struct edit *
list_word(struct tui *t)
{
	return t->picker.on ? &t->picker.word : &t->filter;
}

static size_t
list_total(const struct tui *t)
{
	return list_of(t) != NULL ? list_of(t)->n(t) : 0;
}

static size_t
list_id(const struct tui *t, size_t i)
{
	return list_of(t)->id != NULL ? list_of(t)->id(t, i) : i;
}

/* Returns the row under the cursor of a list that has rows. */
static size_t
list_at(const struct tui *t)
{
	size_t at =
	    t->picker.on ? t->picker.list.at : t->ui.list[t->ui.page].at;
	size_t i = 0, n = list_total(t);
	while (i + 1 < n && list_id(t, i) != at)
		i++;
	return i;
}

static void
move_cursor_to_row(struct tui *t, size_t i)
{
	if (list_state(t)->at == list_id(t, i))
		return;
	list_state(t)->at = list_id(t, i);
	if (list_of(t)->chosen != NULL)
		list_of(t)->chosen(t);
}

static bool
list_has_words(const struct page_list *of)
{
	return of != NULL && (of->text != NULL || of->table != NULL);
}

/* Looks through all columns, also those that are not shown. */
static bool
list_row_matches(const struct tui *t, size_t i)
{
	const struct edit *word = t->picker.on ? &t->picker.word : &t->filter;
	const struct page_list *of = list_of(t);
	if (word->n == 0 || !list_has_words(of))
		return true;
	FREED char *text = of->text != NULL ? of->text(t, i) : xstrdup("");
	for (int c = 0; of->table != NULL && c < of->table->n; c++) {
		char cell[128];
		of->table->cell(t, i, c, cell, sizeof cell);
		xappend(&text, " %s", cell);
	}
	return text_contains_word(text, word->text);
}

/* Returns the nearest row before or after i that matches, else i. */
static size_t
list_next(const struct tui *t, size_t i, int by)
{
	size_t n = list_total(t);
	for (size_t to = i + (size_t)by; to < n; to += (size_t)by)
		if (list_row_matches(t, to))
			return to;
	return i;
}

size_t
rows_count(const struct tui *t)
{
	size_t n = 0;
	for (size_t i = 0; i < list_total(t); i++)
		n += list_row_matches(t, i);
	return n;
}

/* Moves the cursor to a matching row, there, after or before.  Returns false if
 * there is none. */
static bool
move_cursor_to_match(struct tui *t)
{
	if (list_total(t) == 0)
		return false;
	size_t at = list_at(t);
	if (!list_row_matches(t, at))
		at = list_next(t, at, 1);
	if (!list_row_matches(t, at))
		at = list_next(t, at, -1);
	move_cursor_to_row(t, at);
	return list_row_matches(t, at);
}

static void
list_move(struct tui *t, int by)
{
	if (!move_cursor_to_match(t))
		return;
	size_t at = list_at(t);
	for (int left = abs(by); left > 0; left--) {
		size_t next = list_next(t, at, by > 0 ? 1 : -1);
		if (next == at)
			break;
		at = next;
	}
	move_cursor_to_row(t, at);
}

/* Returns the first row to draw, so that the one under the cursor is among
 * `room` of them and none is left blank at the end. */
static size_t
list_first(struct tui *t, int room)
{
	size_t *top = &list_state(t)->top, first = list_at(t), i = first;
	int shown = 1;
	for (; first > *top && shown < room && list_next(t, first, -1) != first;
	     shown++)
		first = list_next(t, first, -1);
	for (; list_next(t, i, 1) != i; shown++)
		i = list_next(t, i, 1);
	for (; shown < room && list_next(t, first, -1) != first; shown++)
		first = list_next(t, first, -1);
	*top = first;
	return first;
}

bool
list_has_rows(const struct tui *t)
{
	return list_total(t) > 0;
}

static void
list_open_row(struct tui *t)
{
	if (list_of(t)->open != NULL && list_row_matches(t, list_at(t)))
		list_of(t)->open(t);
}

static void
touch_row(struct tui *t, const struct touched *touched)
{
	/* Another page may have been opened since the frame was drawn. */
	if (list_total(t) <= touched->item)
		return;
	bool again = list_at(t) == touched->item;
	move_cursor_to_row(t, touched->item);
	if (again)
		list_open_row(t);
}

static void
list_touch_wheel(struct tui *t, const struct touched *touched)
{
	list_move(t, touched->by);
}

int
rows_draw(
    struct tui *t, const struct area *area, row_drawer *draw, const void *of)
{
	int row = 0;
	bool any = move_cursor_to_match(t);
	size_t i = any ? list_first(t, area->rows) : 0, next = i;
	for (; any && row < area->rows; row++) {
		const struct area line = area_row(area, row);
		bool here = i == list_at(t);
		if (here) {
			screen_text(
			    &line, 0, 0, LOOK_REVERSE, "%*s", line.columns, "");
			t->cursor = (struct cursor){line.row, line.column};
		}
		hits_add(&t->hits, HIT_PRESS, line, touch_row, i);
		draw(t, &line, i, here ? LOOK_REVERSE : LOOK_PLAIN, of);
		next = list_next(t, i, 1);
		any = next != i;
		i = next;
	}
	return row;
}

/* ---- Columns ---- */

/* Between two columns. */
enum { GAP = 2 };

void
table_measure(const struct tui *t, const struct list_table *table, size_t rows,
    int wanted[static LIST_COLUMNS])
{
	for (int c = 0; c < table->n; c++) {
		const struct list_column *column = &table->column[c];
		int most = text_width(tr(column->head)) + column->indent;
		for (size_t i = 0; i < rows; i++) {
			char text[128];
			table->cell(t, i, c, text, sizeof text);
			int width = text_width(text);
			most = width > most ? width : most;
		}
		wanted[c] = column->fixed ? column->least : most + GAP;
	}
}

static int
table_ranked(const struct list_table *table, int rank)
{
	int c = 0;
	while (table->column[c].rank != rank)
		c++;
	return c;
}

/* The first in rank gives way last, but leaves room for the second. */
void
table_share(const struct list_table *table, int columns,
    const int wanted[static LIST_COLUMNS], int width[static LIST_COLUMNS])
{
	memset(width, 0, LIST_COLUMNS * sizeof *width);
	int second = table->column[table_ranked(table, 1)].least;
	for (int rank = 0; rank < table->n; rank++) {
		int c = table_ranked(table, rank);
		int least = table->column[c].least;
		/* A number needs all of its width, and a space before it. */
		if (table->column[c].right)
			least = wanted[c] - GAP + 1;
		if (wanted[c] < least)
			least = wanted[c];
		if (columns < least)
			return;
		width[c] = wanted[c] < columns ? wanted[c] : columns;
		columns -= width[c];
		if (rank == 0 && columns < second && width[c] > 3 * second) {
			width[c] += columns - second;
			columns = second;
		}
	}
}

struct table_drawn {
	const struct list_table *table;
	int width[LIST_COLUMNS];
};

static void
table_touch_head(struct tui *t, const struct touched *touched)
{
	const struct page_list *list = list_of(t);
	if (list != NULL && list->table != NULL && list->table->sort != NULL)
		list->table->sort(t, (int)touched->item);
}

/* Draws the heading of a column; that of the column sorted by is marked with
 * its direction. */
static void
table_draw_head(struct tui *t, const struct list_table *table,
    const struct area *cell, int column)
{
	const struct list_column *of = &table->column[column];
	bool sorted = table->sort != NULL && column + 1 == t->ui.sort;
	char text[32];
	snprintf(text, sizeof text, "%*s%s", of->indent, "", tr(of->head));
	int room = cell->columns - text_width(text);
	int from = of->right && room > 0 ? room : 0;
	int end = screen_text(cell, 0, from,
	    LOOK_BOLD | (sorted ? LOOK_REVERSE : LOOK_PLAIN), "%s", text);
	if (sorted && (from > 0 || end < cell->columns))
		screen_text(cell, 0, from > 0 ? from - 1 : end, LOOK_BOLD, "%s",
		    t->ui.sort_down ? "v" : "^");
	if (table->sort != NULL)
		hits_add(&t->hits, HIT_PRESS, area_row(cell, 0),
		    table_touch_head, (size_t)column);
}

/* Draws a cell by itself, because texts may have wide letters. */
static void
table_draw_cell(const struct tui *t, const struct list_table *table,
    const struct area *cell, size_t i, int column, unsigned look)
{
	char text[128];
	enum series series;
	table->cell(t, i, column, text, sizeof text);
	if (table->column[column].right)
		screen_text(cell, 0, 0, look, "%*s", cell->columns, text);
	else if (table->series != NULL &&
		 table->series(t, i, column, text, &series))
		screen_series(cell, 0, 0, series, look | LOOK_BOLD, text);
	else
		screen_text(cell, 0, 0, look, "%s", text);
}

/* Draws a row, or for SIZE_MAX the headings.  A text has a gap before it,
 * except at the edge. */
static void
table_draw_row(struct tui *t, const struct area *line, size_t i, unsigned look,
    const void *of)
{
	const struct table_drawn *drawn = of;
	const struct list_table *table = drawn->table;
	int at = 0;
	for (int c = 0; c < table->n; c++) {
		struct area cell = *line;
		int gap = at == 0 || table->column[c].right ? 0 : GAP;
		cell.column += at + gap;
		cell.columns = drawn->width[c] - gap;
		at += drawn->width[c];
		if (drawn->width[c] > 0 && i == SIZE_MAX)
			table_draw_head(t, table, &cell, c);
		else if (drawn->width[c] > 0)
			table_draw_cell(t, table, &cell, i, c, look);
	}
}

void
table_draw(struct tui *t, const struct area *area,
    const struct list_table *table, const int wanted[static LIST_COLUMNS])
{
	struct table_drawn drawn = {.table = table};
	struct area rows = *area;
	rows.row++;
	rows.rows--;
	table_share(table, area->columns, wanted, drawn.width);
	table_draw_row(t, area, SIZE_MAX, LOOK_PLAIN, &drawn);
	rows_draw(t, &rows, table_draw_row, &drawn);
}

/* ---- Keys ---- */

void
rows_wheel(struct tui *t, struct area area)
{
	hits_add(&t->hits, HIT_WHEEL, area, list_touch_wheel, 0);
}

/* Updates the rows, because several keys may come before the next frame. */
static void
list_update(struct tui *t)
{
	const struct page_list *of = list_of(t);
	if (of != NULL && of->update != NULL && !t->picker.on)
		of->update(t);
}

bool
rows_move(struct tui *t, const struct key *key)
{
	int page = t->layout.body.rows > 3 ? t->layout.body.rows - 2 : 1;
	int steps = abs(key->amount);
	list_update(t);
	if (!list_has_rows(t) || (key->act == act_move && steps == FAST))
		return false;
	if (key->act == act_ends)
		list_move(t, key->amount == TO_LEAST ? -INT_MAX : INT_MAX);
	else if (key->act == act_move && steps == FAR)
		list_move(t, key->amount > 0 ? -page : page);
	else
		list_move(t, key->amount);
	return true;
}

void
act_choose(struct tui *t, const struct key *key)
{
	(void)key;
	list_update(t);
	if (list_has_rows(t) && list_of(t)->open != NULL)
		list_open_row(t);
	else
		tui_say(t, false, "there is nothing to open on this page");
}

void
act_filter(struct tui *t, const struct key *key)
{
	(void)key;
	if (!list_has_words(list_of(t))) {
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
	if (list_of(t) == NULL)
		return false;
	if (t->filter.active && (code == '\n' || code == '\r')) {
		t->filter.active = false;
		return true;
	}
	if (!edit_letter(list_word(t), code, special, VIEWER_WORD))
		return false;
	move_cursor_to_match(t);
	return true;
}

bool
rows_forget(struct tui *t)
{
	struct edit *word = list_word(t);
	if (!word->active && word->n == 0)
		return false;
	edit_begin(word, "");
	word->active = false;
	return true;
}
