/* Arithmetic with rows and columns, without terminal or session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/layout.h"

#include <stddef.h>

#include "base/xalloc.h"

bool
area_has_cell(const struct area *a, int row, int column)
{
	return row >= a->row && row < a->row + a->rows && column >= a->column &&
	       column < a->column + a->columns;
}

struct area
area_part_of_row(const struct area *area, int row, int column, int columns)
{
	return (struct area){
	    area->row + row, area->column + column, 1, columns};
}

struct area
area_of_row(const struct area *area, int row)
{
	return area_part_of_row(area, row, 0, area->columns);
}

/* Takes the last row of what is left. */
static struct area
take_bottom_row(struct area *left)
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
	FOR_HINTS = 7,
	FOR_PLOT = 11,
	FOR_STATUS = 15,
	FOR_TALL_STRIP = 16,
	FOR_SIDE = 18,
	FOR_LEGEND = 20,
	FOR_STRIP = 24,
	FOR_DIFFERENCES = 30
};
/* Narrower, a plot, a legend or a panel says nothing. */
enum { PLOT_COLUMNS = 34, LEGEND_COLUMNS = 50, PANEL = 24 };
/* From so many columns on there is room for a blank column between a wall and
 * its text. */
enum { FOR_GAP = 100 };

/* Takes three rows from the bottom of what is left, and one more for each
 * `every` rows that the screen has beyond `least`. */
static struct area
take_bottom_rows(struct area *left, int rows, int least, int every)
{
	struct area area = *left;
	area.rows = 3 + (rows - least) / every;
	left->rows -= area.rows;
	area.row = left->row + left->rows;
	return area;
}

/* Leaves a list and two more rows above the strip. */
static void
take_tall_strip(struct layout *l, int list_rows)
{
	int rows = list_rows < l->body.rows / 2 ? list_rows : l->body.rows / 2;
	l->certainty = take_bottom_row(&l->body);
	l->strip = l->body;
	l->strip.row += rows + 2;
	l->strip.rows -= rows + 2;
	l->body.rows = rows + 2;
}

static void
split_off_side_panel(struct layout *l, int rows, int side_columns)
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
	int gap = l->body.columns >= FOR_GAP ? 1 : 0;
	l->plot.columns -= side_columns + 1 + gap;
	l->side = l->body;
	l->wall = l->plot.columns;
	l->side.column = l->wall + 1 + gap;
	l->side.columns = side_columns;
}

struct layout
layout_make(int rows, int columns, struct layout_ask ask)
{
	struct layout l = {.wall = -1,
	    .end_columns = ask.in_rpm ? 5 : 4,
	    .body = {0, 0, rows, columns}};
	struct area *left = &l.body;
	bool track = !ask.no_site || rows < FOR_COMMAND;
	if (rows >= FOR_HEADER) {
		l.header = (struct area){0, 0, 1, columns};
		left->row++;
		left->rows--;
	}
	const struct {
		int least;
		struct area *area;
	} bottom[] = {{FOR_HINTS, &l.hints}, {FOR_STATUS, &l.status},
	    {FOR_COMMAND, &l.command}, {track ? 1 : rows + 1, &l.track}};
	for (size_t i = 0; i < ARRAY_LEN(bottom); i++)
		if (rows >= bottom[i].least)
			*bottom[i].area = take_bottom_row(left);
	enum { EVERY = 10 };
	if (ask.strip && ask.list_rows > 0 && rows >= FOR_TALL_STRIP)
		take_tall_strip(&l, ask.list_rows);
	else if (ask.strip && rows >= FOR_STRIP)
		l.strip = take_bottom_rows(left, rows, FOR_STRIP, EVERY);
	if (rows >= FOR_CAPTION && !ask.no_site)
		l.caption = take_bottom_row(left);
	bool side = rows >= FOR_SIDE && ask.side_columns > 0 &&
		    columns - ask.side_columns > PLOT_COLUMNS;
	if (rows >= FOR_NUMBERS && !ask.no_site && !side)
		l.numbers = take_bottom_row(left);
	if (rows >= FOR_LEGEND && columns >= LEGEND_COLUMNS &&
	    ask.list_rows == 0)
		l.legend = take_bottom_row(left);
	split_off_side_panel(&l, rows, ask.side_columns);
	if (ask.differences && rows >= FOR_DIFFERENCES) {
		l.differences = take_bottom_rows(
		    &l.plot, rows + EVERY, FOR_DIFFERENCES, EVERY);
		l.differences.row = l.plot.row + l.plot.rows;
	}
	return l;
}

struct layout
layout_make_for_text(int rows, int columns)
{
	enum { FOR_TEXT_HINTS = 3, FOR_TEXT_HEADER = 8 };
	struct layout l = {.body = {0, 0, rows, columns}};
	if (rows >= FOR_TEXT_HINTS)
		l.hints = take_bottom_row(&l.body);
	if (rows >= FOR_TEXT_HEADER) {
		l.header = (struct area){0, 0, 1, columns};
		l.body.row++;
		l.body.rows--;
	}
	return l;
}

struct area
layout_track_area(const struct layout *l)
{
	struct area track = l->track;
	bool ends = track.columns >= 30;
	track.column += ends ? l->end_columns : 0;
	track.columns -= ends ? 2 * l->end_columns : 0;
	return track;
}

int
layout_message_rows(const struct layout *l)
{
	return l->hints.rows + l->status.rows > 0 ? 2 : 1;
}
