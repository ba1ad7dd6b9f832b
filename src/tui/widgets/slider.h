/* The slider: a speed as a whole number of 0.1 m/s, and its track.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_SLIDER_H
#define TIPSPEED_TUI_WIDGETS_SLIDER_H

#include <stdbool.h>
#include <stddef.h>

struct slider_range {
	int least, most; /* tenths */
};

/* A measured speed, and whether it is a training speed. */
struct slider_mark {
	int tenths;
	bool trained;
};

/* Returns the range between two speeds, m/s, truncated to whole m/s. */
struct slider_range slider_range(double from, double to);

/* Returns the nearest value in the range. */
int slider_clamp(struct slider_range range, int tenths);

/* slider_tenths returns a speed, m/s, rounded to tenths; slider_has_speed
 * returns true if the speed is in the range. */
int slider_tenths(struct slider_range range, double speed);
bool slider_has_speed(struct slider_range range, double speed);

/* slider_column returns the column of a value on a track of `width` columns, 0
 * at its left end; slider_value_at_column returns the value at a column. Values
 * and columns off the track are clamped. */
int slider_column(struct slider_range range, int tenths, int width);
int slider_value_at_column(struct slider_range range, int column, int width);

/* A cell of the track.  sign: '|' at training speeds, '-' between them, 'x'
 * beyond them, 'o' at held-out speeds; text: it holds a letter; taken: it must
 * not get a label. */
struct slider_cell {
	char sign;
	bool taken, text;
};

/* Makes the cells [width] of the track: labels after the marks, "69" or, on a
 * long track, "69 m/s 2380 J/kg"; the word `beyond` outside the training
 * speeds; the value as "[74.0]" on top.  kept [width]: cells that no label may
 * cover, or NULL; if there are any, labels are short.  Returns the column of
 * the '['. */
int slider_fill_cells(struct slider_cell *cell, int width,
    struct slider_range range, int tenths, const struct slider_mark *mark,
    size_t n, const bool *kept, const char *beyond);

#endif
