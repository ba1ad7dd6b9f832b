/* Arithmetic of rows and columns: no terminal, no session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/places.h"

#include <stddef.h>

#include "base/xalloc.h"

bool
area_has(const struct area *a, int row, int column)
{
	return row >= a->row && row < a->row + a->rows && column >= a->column &&
	       column < a->column + a->columns;
}

/* One row at the bottom of what is left. */
static struct area
take_bottom(struct area *left)
{
	left->rows--;
	return (struct area){left->row + left->rows, 0, 1, left->columns};
}

/* The least rows of the screen at which each part is there. */
enum {
	FOR_NUMBERS = 2,
	FOR_COMMAND = 3,
	FOR_HEADER = 4,
	FOR_CAPTION = 5,
	FOR_STATUS = 7,
	FOR_PLOT = 11,
	FOR_RULE = 14,
	FOR_HINTS = 15,
	FOR_SIDE = 18,
	FOR_LEGEND = 20
};
/* Narrower, a plot, a legend or a panel says nothing. */
enum { PLOT_COLUMNS = 34, LEGEND_COLUMNS = 50, PANEL = 24 };

static void
split_body(struct places *l, int rows, int side_columns)
{
	bool side = rows >= FOR_SIDE && side_columns > 0 &&
		    l->body.columns - side_columns >= PLOT_COLUMNS;
	l->plot = l->body;
	if (rows < FOR_PLOT) {
		l->plot.rows = 0;
		l->side = l->body;
		l->side.rows *= side_columns > 0 && l->body.columns >= PANEL;
	}
	if (!side)
		return;
	l->plot.columns -= side_columns + 1;
	l->side = l->body;
	l->side.column = l->plot.columns + 1;
	l->side.columns = side_columns;
}

struct places
places_make(int rows, int columns, int side_columns)
{
	struct places l = {.body = {0, 0, rows, columns}};
	struct area *left = &l.body;
	if (rows >= FOR_HEADER) {
		l.header = (struct area){0, 0, 1, columns};
		left->row++;
		left->rows--;
	}
	const struct {
		int least;
		struct area *area;
	} bottom[] = {{FOR_HINTS, &l.hints}, {FOR_STATUS, &l.status},
	    {FOR_COMMAND, &l.command}, {1, &l.track}, {FOR_CAPTION, &l.caption},
	    {FOR_RULE, &l.rule}};
	for (size_t i = 0; i < ARRAY_LEN(bottom); i++)
		if (rows >= bottom[i].least)
			*bottom[i].area = take_bottom(left);
	bool side = rows >= FOR_SIDE && side_columns > 0 &&
		    columns - side_columns > PLOT_COLUMNS;
	if (rows >= FOR_NUMBERS && !side)
		l.numbers = take_bottom(left);
	if (rows >= FOR_LEGEND && columns >= LEGEND_COLUMNS)
		l.legend = take_bottom(left);
	split_body(&l, rows, side_columns);
	return l;
}

struct places
places_text(int rows, int columns)
{
	enum { FOR_TEXT_HINTS = 3, FOR_TEXT_HEADER = 8 };
	struct places l = {.body = {0, 0, rows, columns}};
	if (rows >= FOR_TEXT_HINTS)
		l.hints = take_bottom(&l.body);
	if (rows >= FOR_TEXT_HEADER) {
		l.header = (struct area){0, 0, 1, columns};
		l.body.row++;
		l.body.rows--;
	}
	return l;
}

struct area
places_track(const struct places *l)
{
	struct area track = l->track;
	bool ends = track.columns >= 30;
	track.column += ends ? 4 : 0;
	track.columns -= ends ? 8 : 0;
	return track;
}

int
places_message_rows(const struct places *l)
{
	return l->hints.rows + l->status.rows > 0 ? 2 : 1;
}
