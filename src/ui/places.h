/* Where the parts of the full screen stand at a size.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PLACES_H
#define TIPSPEED_UI_PLACES_H

#include <stdbool.h>

/* From the top left of the screen; of no rows: left out. */
struct area {
	int row, column, rows, columns;
};

/* body: all between header and rule; plot and side are its two parts. */
struct places {
	struct area header, body, plot, side, legend, rule, numbers, caption,
	    track, command, status, hints;
};

/* Any size of at least 1 x 1.  What there is no room for drops in this order:
 * legend, side panel (a row of numbers takes its place), hints, rule, caption,
 * status, plot (the side panel has its rows), header, command; track and
 * numbers go last.  side_columns: width of the side panel. */
struct places places_make(int rows, int columns, int side_columns);

/* The same for text on all of the screen: between header and hints, as long as
 * there is room for these. */
struct places places_text(int rows, int columns);

/* The track of the slider without its ends. */
struct area places_track(const struct places *l);

/* How many rows a message may have. */
int places_message_rows(const struct places *l);

/* Whether a cell lies in the area. */
bool area_has(const struct area *area, int row, int column);

#endif
