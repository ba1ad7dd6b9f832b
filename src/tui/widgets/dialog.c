/* Draws the box of a question.  If room is short, parts are dropped in this
 * order: other possible answers, the subject, the keys, the table except for
 * the row that the question is about.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/dialog.h"

#include <curses.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "tui/pane.h"
#include "tui/screen.h"

enum edit_result
dialog_handle_key(struct tui *t, int code, bool special)
{
	bool back =
	    special ? code == KEY_BACKSPACE : code == DELETE || code == '\b';
	if (special && (code == KEY_UP || code == KEY_DOWN)) {
		t->inquiry_up += code == KEY_UP ? 1 : -1;
		return EDIT_ON;
	}
	if (special && code == KEY_ENTER)
		return EDIT_DONE;
	/* In an empty line, Backspace would give up; Tab would complete
	 * commands. */
	if ((back && t->answer.n == 0) || (!special && code == '\t'))
		return EDIT_ON;
	return edit_handle_key(&t->answer, t->session, code, special);
}

char *
dialog_ask(struct tui *t, const struct user_question *q)
{
	int code;
	bool special;
	enum edit_result result = EDIT_ON;
	t->inquiry = q;
	t->inquiry_up = 0;
	edit_begin(&t->answer, "");
	while (result == EDIT_ON && t->callbacks->answer(t, &code, &special))
		result = dialog_handle_key(t, code, special);
	t->inquiry = NULL;
	edit_stop_editing(&t->answer);
	return result == EDIT_DONE ? xstrdup(t->answer.text) : NULL;
}

/* The number of rows of each part.  gap: blank rows around the table. */
struct parts {
	int about, table, gap, text, line, hint;
};

static int
allot_rows_at_most(int n, int *left)
{
	int taken = n < *left ? n : *left;
	*left -= taken;
	return taken;
}

static const char *
text_above_question(const struct user_question *q)
{
	return q->wrong[0] != '\0' ? q->wrong : q->about;
}

static struct parts
dialog_distribute_rows(
    const struct user_question *q, const char *asks, int room, int columns)
{
	enum { LEAST = 5 };
	int table = q->ask->n > 0 ? (int)q->ask->n + 1 : 0, left = room;
	struct parts p = {0};
	p.line = allot_rows_at_most(1, &left);
	p.text = allot_rows_at_most(text_count_rows(asks, columns), &left);
	p.table = allot_rows_at_most(table < LEAST ? table : LEAST, &left);
	p.about = allot_rows_at_most(
	    text_count_rows(text_above_question(q), columns), &left);
	int hint = text_count_rows(q->hint, columns);
	p.hint = hint <= left ? allot_rows_at_most(hint, &left) : 0;
	p.table += allot_rows_at_most(table - p.table, &left);
	p.gap = table > 0 && left >= 2 ? 2 : 0;
	return p;
}

static void
draw_dialog_frame(struct tui *t, const struct area *box, const char *keys)
{
	static const char *const CORNERS[] = {
	    "\u250c", "\u2510", "\u2514", "\u2518"};
	bool ascii = screen_charset() == CHARSET_ASCII;
	struct area edge = area_of_row(box, box->rows - 1);
	screen_draw_horizontal_rule(box);
	screen_draw_horizontal_rule(&edge);
	screen_draw_vertical_rule(box->row, box->column, box->rows);
	screen_draw_vertical_rule(
	    box->row, box->column + box->columns - 1, box->rows);
	for (int i = 0; i < 4; i++)
		screen_draw_text(box, i < 2 ? 0 : box->rows - 1,
		    i % 2 == 0 ? 0 : box->columns - 1, LOOK_DIM, "%s",
		    ascii ? "+" : CORNERS[i]);
	screen_draw_text(&edge, 0, 2, LOOK_PLAIN, " %s ", keys);
	pane_make_hints_clickable(t, edge.row, edge.column + 3, keys);
}

static void
on_wheel_scroll_table(struct tui *t, const struct mouse_event *touched)
{
	t->inquiry_up -= touched->by;
}

/* Draws the headings and as many rows as fit.  The row that the question is
 * about is among them, unless the table was scrolled. */
static void
draw_question_table(struct tui *t, const struct area *area)
{
	const struct user_question *q = t->inquiry;
	int shown = area->rows - 1, n = (int)q->ask->n, at = (int)q->at;
	if (shown < 1)
		return;
	int top = at - shown / 2 - t->inquiry_up, most = n - shown;
	int fit = top > most ? most : top;
	fit = fit < 0 ? 0 : fit;
	t->inquiry_up += top - fit;
	for (int r = 0; r < area->rows; r++) {
		size_t row = r == 0 ? 0 : (size_t)(fit + r);
		FREED char *line =
		    user_question_row_text(q, row, area->columns);
		screen_draw_text(area, r, 0,
		    r == 0               ? LOOK_DIM
		    : (int)row - 1 == at ? LOOK_REVERSE
					 : LOOK_PLAIN,
		    "%s", line);
	}
}

static void
draw_dialog_parts(struct tui *t, const struct area *inner,
    const struct parts *p, const char *asks)
{
	const struct user_question *q = t->inquiry;
	struct area left = *inner,
		    area = area_cut_off_edge(&left, EDGE_TOP, p->about);
	screen_draw_wrapped(&area, 0, LOOK_BOLD, text_above_question(q));
	area_cut_off_edge(&left, EDGE_TOP, p->gap / 2);
	area = area_cut_off_edge(&left, EDGE_TOP, p->table);
	draw_question_table(t, &area);
	area_cut_off_edge(&left, EDGE_TOP, p->gap / 2);
	area = area_cut_off_edge(&left, EDGE_TOP, p->text);
	screen_draw_wrapped(&area, 0, LOOK_BOLD, asks);
	area = area_cut_off_edge(&left, EDGE_TOP, p->line);
	size_t from;
	int at = pane_draw_typed_line(&area, "> ", &t->answer, &from);
	t->cursor = (struct cursor){area.row, area.column + at};
	screen_draw_wrapped(&left, 0, LOOK_DIM, p->hint > 0 ? q->hint : "");
}

void
dialog_draw(struct tui *t, int rows, int columns)
{
	enum { MOST_COLUMNS = 100, FRAME_ROWS = 9, FRAME_COLUMNS = 32 };
	const struct user_question *q = t->inquiry;
	bool frame = rows >= FRAME_ROWS && columns >= FRAME_COLUMNS;
	bool offers = q->offered[0] != '\0';
	int edge = frame ? 1 : 0, side = columns >= 60 ? 2 * edge : edge;
	int wide = columns < MOST_COLUMNS ? columns : MOST_COLUMNS;
	FREED char *asks = xasprintf("%s%s%s%s", q->text, offers ? " [" : "",
	    q->offered, offers ? "]" : "?");
	struct parts p =
	    dialog_distribute_rows(q, asks, rows - 2 * edge, wide - 2 * side);
	int high = p.about + p.table + p.gap + p.text + p.line + p.hint;
	struct area box = {.row = (rows - high) / 2 - edge,
	    .column = (columns - wide) / 2,
	    .rows = high + 2 * edge,
	    .columns = wide};
	screen_clear_area(&box);
	screen_clear_area(&t->layout.hints); /* of keys that are text now */
	hits_clear_click_areas(&t->hits);
	hits_add_mouse_handler(
	    &t->hits, HIT_WHEEL, box, on_wheel_scroll_table, 0);
	if (frame)
		draw_dialog_frame(t, &box,
		    offers ? tr("Enter accepts  Esc gives up")
			   : tr("Esc gives up"));
	struct area inner = {
	    box.row + edge, box.column + side, high, wide - 2 * side};
	draw_dialog_parts(t, &inner, &p, asks);
}
