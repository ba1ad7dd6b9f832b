/* The slider and its track.  The slider's position is a whole number: of 0.1
 * m/s or, for a sheet in rpm, of rpm.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_SLIDER_H
#define TIPSPEED_TUI_WIDGETS_SLIDER_H

#include <stdbool.h>
#include <stddef.h>

struct slider_range {
	int least, most; /* positions */
	double rotor;    /* its diameter, m, for a sheet in rpm; else 0 */
};

/* A measured speed, and whether it is a training speed. */
struct slider_mark {
	int position;
	bool trained;
};

/* Returns the range between two speeds, m/s: truncated to whole m/s or, if the
 * rotor's diameter, m, is not 0, rounded to whole rpm. */
struct slider_range slider_range(double from, double to, double rotor);

/* Returns the nearest position in the range. */
int slider_clamped_position(struct slider_range range, int position);

/* slider_position_of_speed returns the position nearest to a speed, m/s, within
 * the range; slider_speed_of_position returns the speed at a position;
 * slider_has_speed returns true if the speed is in the range. */
int slider_position_of_speed(struct slider_range range, double speed);
double slider_speed_of_position(struct slider_range range, double position);
bool slider_has_speed(struct slider_range range, double speed);

/* slider_column_of_position returns the column of a position on a track of
 * `width` columns, 0 at its left end; slider_position_at_column returns the
 * position at a column.  Positions and columns off the track are clamped. */
int slider_column_of_position(
    struct slider_range range, int position, int width);
int slider_position_at_column(struct slider_range range, int column, int width);

/* A cell of the track.  sign: '|' at training speeds, '-' between them, 'x'
 * beyond them, 'o' at held-out speeds; text: it holds a letter; taken: it must
 * not get a label. */
struct slider_cell {
	char sign;
	bool taken, text;
};

/* Makes the cells [width] of the track.  The marks [n] have labels after them,
 * "69" or, on a long track, "69 m/s 2380 J/kg"; the word `beyond` stands
 * outside the training speeds; on top is the speed, "[74.0]" or "[1650]".  kept
 * [width]: cells that no label may cover, or NULL; if there are any, labels are
 * short.  Returns the column of the '['. */
int slider_fill_cells(struct slider_cell *cell, int width,
    struct slider_range range, int position, const struct slider_mark *mark,
    size_t n, const bool *kept, const char *beyond);

#endif
