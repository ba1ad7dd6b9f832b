/* Computes rows and columns, without a terminal or a session.
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
area_of_columns_in_row(
    const struct area *area, int row, int column, int columns)
{
	return (struct area){
	    area->row + row, area->column + column, 1, columns};
}

struct area
area_of_row(const struct area *area, int row)
{
	return area_of_columns_in_row(area, row, 0, area->columns);
}

struct area
area_cut_off_edge(struct area *from, enum edge edge, int n)
{
	struct area cut = *from;
	bool across = edge == EDGE_LEFT || edge == EDGE_RIGHT;
	int *left = across ? &from->columns : &from->rows;
	n = n < 0 ? 0 : n < *left ? n : *left;
	*left -= n;
	*(across ? &cut.columns : &cut.rows) = n;
	from->row += edge == EDGE_TOP ? n : 0;
	from->column += edge == EDGE_LEFT ? n : 0;
	cut.row += edge == EDGE_FOOT ? from->rows : 0;
	cut.column += edge == EDGE_RIGHT ? from->columns : 0;
	return cut;
}

/* With fewer columns, a plot, a legend or a panel would be useless. */
enum { PLOT_COLUMNS = 34, LEGEND_COLUMNS = 50, PANEL = 24 };
/* With fewer rows, the screen has no panel beside a plot, or no plot. */
enum { SIDE_ROWS = 18, PLOT_ROWS = 11 };
/* The strips get another row for each EVERY rows of the screen.  From
 * GAP_COLUMNS on, there is a blank column between a wall and its text. */
enum { EVERY = 10, GAP_COLUMNS = 100 };

static void
split_off_side_panel(struct layout *l, int rows, int side_columns)
{
	int gap = l->body.columns >= GAP_COLUMNS ? 1 : 0;
	l->plot = l->body;
	if (rows < PLOT_ROWS) {
		l->plot.rows = 0;
		l->side = l->body;
		l->side.rows *= side_columns > 0 && l->body.columns >= PANEL;
	} else if (rows >= SIDE_ROWS && side_columns > 0 &&
		   l->body.columns - side_columns >= PLOT_COLUMNS) {
		l->side = area_cut_off_edge(&l->plot, EDGE_RIGHT, side_columns);
		area_cut_off_edge(&l->plot, EDGE_RIGHT, 1 + gap);
		l->wall = l->plot.columns;
	}
}

struct layout
layout_make(int rows, int columns, struct layout_ask ask)
{
	enum { STRIP = 24, DIFFERENCES = 30, AROUND = 5, APART = 2 };
	struct layout l = {.wall = -1,
	    .end_columns = ask.in_rpm ? 5 : 4,
	    .body = {0, 0, rows, columns}};
	bool site = !ask.no_site, tall = ask.strip && ask.list_rows > 0;
	bool side = rows >= SIDE_ROWS && ask.side_columns > 0 &&
		    columns - ask.side_columns > PLOT_COLUMNS;
	int half = (rows - AROUND) / 2,
	    list = ask.list_rows < half ? ask.list_rows : half;
	/* From the foot up, with the fewest rows of the screen at which each is
	 * shown. */
	const struct {
		bool wanted;
		int least;
		struct area *area;
		int rows;
	} part[] = {{true, 7, &l.hints, 1}, {true, 15, &l.status, 1},
	    {true, 3, &l.command, 1}, {site || rows < 3, 1, &l.track, 1},
	    {tall, 16, &l.certainty, 1},
	    {tall, 16, &l.strip, rows - AROUND - 1 - list - APART},
	    {ask.strip && !tall, STRIP, &l.strip, 3 + (rows - STRIP) / EVERY},
	    {site, 5, &l.caption, 1}, {site && !side, 2, &l.numbers, 1},
	    {columns >= LEGEND_COLUMNS && ask.list_rows == 0, 20, &l.legend,
		1}};
	l.header = area_cut_off_edge(&l.body, EDGE_TOP, rows >= 4 ? 1 : 0);
	for (size_t i = 0; i < ARRAY_LEN(part); i++)
		if (part[i].wanted && rows >= part[i].least)
			*part[i].area =
			    area_cut_off_edge(&l.body, EDGE_FOOT, part[i].rows);
	split_off_side_panel(&l, rows, ask.side_columns);
	if (ask.differences && rows >= DIFFERENCES)
		l.differences = area_cut_off_edge(
		    &l.plot, EDGE_FOOT, 4 + (rows - DIFFERENCES) / EVERY);
	return l;
}

struct layout
layout_make_for_text(int rows, int columns)
{
	enum { FOR_TEXT_HINTS = 3, FOR_TEXT_HEADER = 8 };
	struct layout l = {.body = {0, 0, rows, columns}};
	if (rows >= FOR_TEXT_HINTS)
		l.hints = area_cut_off_edge(&l.body, EDGE_FOOT, 1);
	if (rows >= FOR_TEXT_HEADER)
		l.header = area_cut_off_edge(&l.body, EDGE_TOP, 1);
	return l;
}

struct area
layout_track_area(const struct layout *l)
{
	struct area track = l->track;
	int end = track.columns >= 30 ? l->end_columns : 0;
	area_cut_off_edge(&track, EDGE_LEFT, end);
	area_cut_off_edge(&track, EDGE_RIGHT, end);
	return track;
}

int
layout_count_message_rows(const struct layout *l)
{
	return l->hints.rows + l->status.rows > 0 ? 2 : 1;
}
