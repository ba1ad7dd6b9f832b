/* The layout of the full screen, at any size.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_LAYOUT_H
#define TIPSPEED_TUI_LAYOUT_H

#include <stdbool.h>

/* What a page needs besides its body.  side_columns: columns of a side panel,
 * or 0.  differences: a strip of differences below the plot.  strip: the
 * response strip above the track.  no_site: no site is loaded, so there are no
 * numbers, caption and track; the row of the track stays if it is the only one
 * for messages.  in_rpm: the ends of the track are in rpm, of four digits.
 * list_rows: rows of a list to which the body is reduced, to give the strip the
 * full height with a row of certainty; or 0. */
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
struct area area_cut_off_edge(struct area *from, enum edge edge, int n);

/* body: what the other parts leave between the header and the foot; plot and
 * side are its parts.  wall: the column of the line to the left of side, or -1.
 * end_columns: columns for the number at either end of the track, and a blank.
 * caption: a rule with words. */
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
int layout_count_message_rows(const struct layout *l);

/* True if a cell is in the area. */
bool area_has_cell(const struct area *area, int row, int column);

/* area_of_row returns a row of an area; area_of_columns_in_row returns some
 * columns of it. */
struct area area_of_row(const struct area *area, int row);
struct area area_of_columns_in_row(
    const struct area *area, int row, int column, int columns);

#endif
