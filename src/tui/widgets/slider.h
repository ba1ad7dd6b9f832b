/* The slider: a speed as a whole number of 0.1 m/s, and its track.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_SLIDER_H
#define TIPSPEED_TUI_WIDGETS_SLIDER_H

#include <stdbool.h>
#include <stddef.h>

struct slider_range {
	int least, most; /* tenths */
};

/* A speed that was measured, and whether it was trained on. */
struct slider_mark {
	int tenths;
	bool trained;
};

/* Returns the range between two speeds, m/s, in whole m/s. */
struct slider_range slider_range(double from, double to);

/* Returns the nearest value the slider can have. */
int slider_clamp(struct slider_range range, int tenths);

/* slider_tenths returns the tenths of a speed, m/s, rounded; slider_has: true
 * if the speed is in the range. */
int slider_tenths(struct slider_range range, double speed);
bool slider_has(struct slider_range range, double speed);

/* slider_column returns the column of a value on a track of `width` columns, 0
 * at its left end; slider_at the value at a column; values and columns off the
 * track count as its ends. */
int slider_column(struct slider_range range, int tenths, int width);
int slider_at(struct slider_range range, int column, int width);

/* A cell of the track: 'x' where no speed was trained on that side, '-' between
 * trained ones, '|' at these and 'o' at those held out; text: a letter that
 * stands there; taken: no label may stand there. */
struct slider_cell {
	char sign;
	bool taken, text;
};

/* Makes the cells [width] of the track: labels behind the marks, "69", on a
 * long track "69 m/s 2380 J/kg", the word `beyond` where no speed was trained
 * on that side, the value as "[74.0]" on top.  kept [width]: cells that no
 * label may cover, with any of which labels are short; or NULL.  Returns the
 * column of its '['. */
int slider_draw(struct slider_cell *cell, int width, struct slider_range range,
    int tenths, const struct slider_mark *mark, size_t n, const bool *kept,
    const char *beyond);

#endif
