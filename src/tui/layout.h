/* The places of the full screen's parts, at any size.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_LAYOUT_H
#define TIPSPEED_TUI_LAYOUT_H

#include <stdbool.h>

/* What a page needs beside its body: columns of a side panel, or 0; the strip
 * of differences below the plot; the response strip above the track. */
struct layout_ask {
	int side_columns;
	bool differences, strip;
};

/* An area of the screen, from its top left; without rows: left out. */
struct area {
	int row, column, rows, columns;
};

/* body: all between header and caption, a rule with words; plot and side are
 * its parts.  wall: the column of the line before side, -1: none. */
struct layout {
	int wall;
	struct area header, body, plot, side, legend, differences, numbers,
	    caption, strip, track, command, status, hints;
};

/* Places everything on a screen of at least 1 x 1.  Parts without room are
 * dropped in this order: differences, strip, legend, side panel (a row of
 * numbers replaces it), status (it shares the row of the command), plot (the
 * side panel gets its rows), hints, caption, header, command; track and numbers
 * last. */
struct layout layout_make(int rows, int columns, struct layout_ask ask);

/* Places text on all of the screen: between header and hints, as long as there
 * is room for these. */
struct layout layout_text(int rows, int columns);

/* Returns the area of the slider's track without its ends. */
struct area layout_track(const struct layout *l);

/* Returns how many rows a message may have. */
int layout_message_rows(const struct layout *l);

/* True if a cell lies in the area. */
bool area_has(const struct area *area, int row, int column);

/* Returns a row of an area, or of that some columns. */
struct area area_row(const struct area *area, int row);
struct area area_cells(
    const struct area *area, int row, int column, int columns);

#endif
