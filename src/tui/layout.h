/* The layout of the full screen, at any size.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_LAYOUT_H
#define TIPSPEED_TUI_LAYOUT_H

#include <stdbool.h>

/* What a page needs besides its body: columns of a side panel, or 0; the strip
 * of differences below the plot; the response strip above the track.
 * list_rows: 0, or the rows of a list to which the body is reduced, for a strip
 * at full height with a row of certainty; no_site: there is nothing at any
 * speed, so neither numbers, caption nor track, but the row of the track where
 * it is the only one for messages; in_rpm: the ends of the track are in rpm, of
 * four digits. */
struct layout_ask {
	int side_columns;
	bool differences, strip, no_site, in_rpm;
	int list_rows;
};

/* An area of the screen, from its top left; not shown if it has no rows. */
struct area {
	int row, column, rows, columns;
};

/* Cuts n rows or columns off an edge of an area, or all if it has fewer, and
 * returns them. */
enum edge { EDGE_TOP, EDGE_FOOT, EDGE_LEFT, EDGE_RIGHT };
struct area area_cut(struct area *from, enum edge edge, int n);

/* body: everything between the header and the caption, which is a rule with
 * words; plot and side are its parts.  wall: the column of the line before
 * side, or -1; end_columns: of either end of the track, with a blank. */
struct layout {
	int wall, end_columns;
	struct area header, body, plot, side, legend, differences, numbers,
	    caption, strip, certainty, track, command, status, hints;
};

/* Places everything on a screen of at least 1 x 1.  Parts without room are
 * dropped in this order: differences, strip, legend, side panel (a row of
 * numbers replaces it), status (moves to the row of the command), plot (the
 * side panel gets its rows), hints, caption, header, command; track and numbers
 * last. */
struct layout layout_make(int rows, int columns, struct layout_ask ask);

/* Places text on the whole screen: between header and hints, if there is room
 * for these. */
struct layout layout_make_for_text(int rows, int columns);

/* Returns the area of the slider's track, without its ends. */
struct area layout_track_area(const struct layout *l);

/* Returns the maximum number of rows for a message. */
int layout_message_rows(const struct layout *l);

/* True if a cell is in the area. */
bool area_has_cell(const struct area *area, int row, int column);

/* Return a row of an area, or some columns of a row. */
struct area area_of_row(const struct area *area, int row);
struct area area_part_of_row(
    const struct area *area, int row, int column, int columns);

#endif
