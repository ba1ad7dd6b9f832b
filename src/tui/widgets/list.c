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
#include "tui/pane.h"
#include "tui/screen.h"

static const struct page_list *
current_page_list(const struct tui *t)
{
	return t->picker.on ? t->picker.rows : pages_current(t)->list;
}

static struct list *
current_list_state(struct tui *t)
{
	return t->picker.on ? &t->picker.list : &t->ui.list[t->ui.page];
}

static struct edit *
current_filter_word(struct tui *t)
{
	return t->picker.on ? &t->picker.word : &t->filter;
}

static size_t
count_list_rows(const struct tui *t)
{
	return current_page_list(t) != NULL ? current_page_list(t)->n(t) : 0;
}

static size_t
id_of_list_row(const struct tui *t, size_t i)
{
	return current_page_list(t)->id != NULL ? current_page_list(t)->id(t, i)
						: i;
}

/* Returns the row under the cursor of a list that has rows. */
static size_t
list_row_under_cursor(const struct tui *t)
{
	size_t at =
	    t->picker.on ? t->picker.list.at : t->ui.list[t->ui.page].at;
	size_t i = 0, n = count_list_rows(t);
	while (i + 1 < n && id_of_list_row(t, i) != at)
		i++;
	return i;
}

static void
move_cursor_to_row(struct tui *t, size_t i)
{
	if (current_list_state(t)->at == id_of_list_row(t, i))
		return;
	current_list_state(t)->at = id_of_list_row(t, i);
	if (current_page_list(t)->chosen != NULL)
		current_page_list(t)->chosen(t);
}

static bool
has_searchable_rows(const struct page_list *of)
{
	return of != NULL && (of->text != NULL || of->table != NULL);
}

/* Looks in all columns, including those that are not shown. */
static bool
is_row_matching_filter(const struct tui *t, size_t i)
{
	const struct edit *word = t->picker.on ? &t->picker.word : &t->filter;
	const struct page_list *of = current_page_list(t);
	if (word->n == 0 || !has_searchable_rows(of))
		return true;
	FREED char *text = of->text != NULL ? of->text(t, i) : xstrdup("");
	for (int c = 0; of->table != NULL && c < of->table->n; c++) {
		FREED char *cell = of->table->cell(t, i, c);
		xappend(&text, " %s", cell);
	}
	return text_contains_folded(text, word->text);
}

/* Returns the nearest matching row before i (by -1) or after it (by 1), or i if
 * there is none. */
static size_t
next_matching_row(const struct tui *t, size_t i, int by)
{
	size_t n = count_list_rows(t);
	for (size_t to = i + (size_t)by; to < n; to += (size_t)by)
		if (is_row_matching_filter(t, to))
			return to;
	return i;
}

size_t
list_count_matching_rows(const struct tui *t)
{
	size_t n = 0;
	for (size_t i = 0; i < count_list_rows(t); i++)
		n += is_row_matching_filter(t, i);
	return n;
}

/* Moves the cursor to the nearest matching row: its own, else one below, else
 * one above.  Returns false if there is none. */
static bool
move_cursor_to_match(struct tui *t)
{
	if (count_list_rows(t) == 0)
		return false;
	size_t at = list_row_under_cursor(t);
	if (!is_row_matching_filter(t, at))
		at = next_matching_row(t, at, 1);
	if (!is_row_matching_filter(t, at))
		at = next_matching_row(t, at, -1);
	move_cursor_to_row(t, at);
	return is_row_matching_filter(t, at);
}

static void
move_cursor_by_rows(struct tui *t, int by)
{
	if (!move_cursor_to_match(t))
		return;
	size_t at = list_row_under_cursor(t);
	for (int left = abs(by); left > 0; left--) {
		size_t next = next_matching_row(t, at, by > 0 ? 1 : -1);
		if (next == at)
			break;
		at = next;
	}
	move_cursor_to_row(t, at);
}

/* Returns the first row to draw, so that `room` rows include the one under the
 * cursor and, if possible, none is left blank. */
static size_t
first_list_row_to_draw(struct tui *t, int room)
{
	size_t *top = &current_list_state(t)->top,
	       first = list_row_under_cursor(t), i = first;
	int shown = 1;
	for (; first > *top && shown < room &&
	       next_matching_row(t, first, -1) != first;
	     shown++)
		first = next_matching_row(t, first, -1);
	for (; next_matching_row(t, i, 1) != i; shown++)
		i = next_matching_row(t, i, 1);
	for (; shown < room && next_matching_row(t, first, -1) != first;
	     shown++)
		first = next_matching_row(t, first, -1);
	*top = first;
	return first;
}

bool
list_has_rows(const struct tui *t)
{
	return count_list_rows(t) > 0;
}

static void
list_open_row_at_cursor(struct tui *t)
{
	if (current_page_list(t)->open != NULL &&
	    is_row_matching_filter(t, list_row_under_cursor(t)))
		current_page_list(t)->open(t);
}

static void
on_click_row(struct tui *t, const struct mouse_event *touched)
{
	/* Another page may have been opened since the frame was drawn. */
	if (count_list_rows(t) <= touched->item)
		return;
	bool again = list_row_under_cursor(t) == touched->item;
	move_cursor_to_row(t, touched->item);
	if (again)
		list_open_row_at_cursor(t);
}

static void
on_wheel_move_cursor(struct tui *t, const struct mouse_event *touched)
{
	move_cursor_by_rows(t, touched->by);
}

int
list_draw_rows(
    struct tui *t, const struct area *area, row_drawer *draw, const void *of)
{
	int row = 0;
	bool any = move_cursor_to_match(t);
	size_t i = any ? first_list_row_to_draw(t, area->rows) : 0, next = i;
	for (; any && row < area->rows; row++) {
		const struct area line = area_of_row(area, row);
		bool here = i == list_row_under_cursor(t);
		if (here) {
			screen_draw_text(
			    &line, 0, 0, LOOK_REVERSE, "%*s", line.columns, "");
			t->cursor = (struct cursor){line.row, line.column};
		}
		hits_add_mouse_handler(
		    &t->hits, HIT_PRESS, line, on_click_row, i);
		draw(t, &line, i, here ? LOOK_REVERSE : LOOK_PLAIN, of);
		next = next_matching_row(t, i, 1);
		any = next != i;
		i = next;
	}
	return row;
}

/* ---- Columns ---- */

/* Blank columns between two columns. */
enum { GAP = 2 };

void
table_measure_columns(const struct tui *t, const struct list_table *table,
    size_t rows, int wanted[static LIST_COLUMNS])
{
	for (int c = 0; c < table->n; c++) {
		const struct list_column *column = &table->column[c];
		int most =
		    text_width_in_columns(tr(column->head)) + column->indent;
		for (size_t i = 0; i < rows; i++) {
			FREED char *text = table->cell(t, i, c);
			int width = text_width_in_columns(text);
			most = width > most ? width : most;
		}
		wanted[c] = column->fixed ? column->least : most + GAP;
	}
}

static int
find_column_with_rank(const struct list_table *table, int rank)
{
	int c = 0;
	while (table->column[c].rank != rank)
		c++;
	return c;
}

/* The column of rank 0 gets room first, but leaves some for the column of rank
 * 1. */
void
table_fit_columns(const struct list_table *table, int columns,
    const int wanted[static LIST_COLUMNS], int width[static LIST_COLUMNS])
{
	memset(width, 0, LIST_COLUMNS * sizeof *width);
	int second = table->column[find_column_with_rank(table, 1)].least;
	for (int rank = 0; rank < table->n; rank++) {
		int c = find_column_with_rank(table, rank);
		int least = table->column[c].least;
		/* A number needs its full width, and a space before it. */
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
on_click_column_heading(struct tui *t, const struct mouse_event *touched)
{
	const struct page_list *list = current_page_list(t);
	if (list != NULL && list->table != NULL && list->table->sort != NULL)
		list->table->sort(t, (int)touched->item);
}

/* Draws the heading of a column.  The heading by which rows are sorted is
 * marked with the direction. */
static void
table_draw_head(struct tui *t, const struct list_table *table,
    const struct area *cell, int column)
{
	const struct list_column *of = &table->column[column];
	bool sorted = table->sort != NULL && column + 1 == t->ui.sort;
	char text[32];
	snprintf(text, sizeof text, "%*s%s", of->indent, "", tr(of->head));
	int room = cell->columns - text_width_in_columns(text);
	int from = of->right && room > 0 ? room : 0;
	unsigned look = LOOK_BOLD | (sorted ? LOOK_REVERSE : LOOK_PLAIN);
	int end = screen_draw_text(cell, 0, from, look, "%s", text);
	/* A blank column follows the cell. */
	struct area wide = *cell;
	wide.columns++;
	if (sorted)
		screen_draw_text(&wide, 0, from > 0 ? from - 1 : end, look,
		    "%s", t->ui.sort_down ? "v" : "^");
	if (table->sort != NULL)
		hits_add_mouse_handler(&t->hits, HIT_PRESS,
		    area_of_row(cell, 0), on_click_column_heading,
		    (size_t)column);
}

/* Draws one cell at its own column, because texts may have wide letters. */
static void
table_draw_cell(const struct tui *t, const struct list_table *table,
    const struct area *cell, size_t i, int column, unsigned look)
{
	FREED char *text = table->cell(t, i, column);
	enum series series;
	if (table->column[column].right)
		screen_draw_text(cell, 0, 0, look, "%*s", cell->columns, text);
	else if (table->series != NULL &&
		 table->series(t, i, column, text, &series))
		screen_draw_text_in_series_colour(
		    cell, 0, 0, series, look | LOOK_BOLD, text);
	else
		screen_draw_text(cell, 0, 0, look, "%s", text);
}

/* Draws row i or, if i is SIZE_MAX, the headings.  A text has a gap before it,
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

/* Marks at the right that there are rows above or below those drawn. */
static void
draw_marks_of_more_rows(struct tui *t, const struct area *area)
{
	size_t first = current_list_state(t)->top, last = first;
	for (int row = 2; row < area->rows; row++)
		last = next_matching_row(t, last, 1);
	if (next_matching_row(t, first, -1) != first)
		screen_draw_text(area, 1, area->columns - 1, LOOK_BOLD, "^");
	if (next_matching_row(t, last, 1) != last)
		screen_draw_text(
		    area, area->rows - 1, area->columns - 1, LOOK_BOLD, "v");
}

void
table_draw(struct tui *t, const struct area *area,
    const struct list_table *table, const int wanted[static LIST_COLUMNS])
{
	struct table_drawn drawn = {.table = table};
	struct area rows = *area, head = area_cut_off_edge(&rows, EDGE_TOP, 1);
	/* The rows of a goal, which are not sorted, need the whole width. */
	const bool more =
	    table->sort != NULL && (int)list_count_matching_rows(t) > rows.rows;
	if (more)
		rows.columns = head.columns = area->columns - 1;
	table_fit_columns(table, rows.columns, wanted, drawn.width);
	table_draw_row(t, &head, SIZE_MAX, LOOK_PLAIN, &drawn);
	list_draw_rows(t, &rows, table_draw_row, &drawn);
	if (more)
		draw_marks_of_more_rows(t, area);
}

/* ---- Keys ---- */

void
list_add_wheel_area(struct tui *t, struct area area)
{
	hits_add_mouse_handler(
	    &t->hits, HIT_WHEEL, area, on_wheel_move_cursor, 0);
}

/* Updates the rows, because several keys may be handled before the next
 * frame. */
static void
update_list_rows(struct tui *t)
{
	const struct page_list *of = current_page_list(t);
	if (of != NULL && of->update != NULL && !t->picker.on)
		of->update(t);
}

bool
list_handle_move_key(struct tui *t, const struct key *key)
{
	int page = t->layout.body.rows > 3 ? t->layout.body.rows - 2 : 1;
	int steps = abs(key->amount);
	update_list_rows(t);
	if (!list_has_rows(t) ||
	    (key->act == act_move_list_or_slider && steps == FAST))
		return false;
	if (key->act == act_move_to_end)
		move_cursor_by_rows(
		    t, key->amount == TO_LEAST ? -INT_MAX : INT_MAX);
	else if (key->act == act_move_list_or_slider && steps == FAR)
		move_cursor_by_rows(t, key->amount > 0 ? -page : page);
	else
		move_cursor_by_rows(t, key->amount);
	return true;
}

void
act_open_row(struct tui *t, const struct key *key)
{
	(void)key;
	update_list_rows(t);
	if (list_has_rows(t) && current_page_list(t)->open != NULL)
		list_open_row_at_cursor(t);
	else
		tui_set_message(
		    t, false, "there is nothing to open on this page");
}

void
act_open_filter_field(struct tui *t, const struct key *key)
{
	(void)key;
	if (!has_searchable_rows(current_page_list(t))) {
		tui_set_message(t, false, "there are no rows to look through");
		return;
	}
	t->message[0] = '\0';
	t->filter.active = true;
}

bool
list_handle_filter_key(struct tui *t, int code, bool special)
{
	if (current_page_list(t) == NULL)
		return false;
	if (t->filter.active && (code == '\n' || code == '\r')) {
		t->filter.active = false;
		return true;
	}
	if (!edit_insert_or_erase_letter(
		current_filter_word(t), code, special, VIEWER_WORD))
		return false;
	move_cursor_to_match(t);
	return true;
}

bool
list_clear_filter(struct tui *t)
{
	struct edit *word = current_filter_word(t);
	if (!word->active && word->n == 0)
		return false;
	edit_begin(word, "");
	word->active = false;
	return true;
}
