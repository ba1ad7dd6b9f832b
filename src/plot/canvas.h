/* A grid of cells that plots draw on and screens show.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_CANVAS_H
#define TIPSPEED_PLOT_CANVAS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* What a line is drawn with: ASCII characters, quarters of a cell (2 x 2), or
 * braille dots (2 x 4). */
enum charset { CHARSET_ASCII, CHARSET_QUADRANTS, CHARSET_BRAILLE };

/* What a cell belongs to; decides its colour. The measured ones of several
 * speeds take turns. */
enum series {
	SERIES_TEXT, /* axes, labels, legend */
	SERIES_FEED,
	SERIES_MEASURED_1,
	SERIES_MEASURED_2,
	SERIES_MEASURED_3,
	SERIES_PREDICTED,
	SERIES_OTHER, /* a second prediction, beside the first */
	SERIES_BAND,
	SERIES_BREAK,
	SERIES_CROSSHAIR,
	SERIES_COUNT
};

/* CELL_SHADE: within a band.  Where there are 256 colours that is a ground of
 * colour CANVAS_SHADE; with fewer it is ignored, and the character of code
 * CANVAS_SHADE_CODE stands for it. */
enum { CELL_BOLD = 1, CELL_DIM = 2, CELL_REVERSE = 4, CELL_SHADE = 8 };
enum { CANVAS_SHADE = 238, CANVAS_SHADE_CODE = 0x2591 };

/* code: a Unicode code point; 0 after one that is two columns wide. */
struct canvas_cell {
	uint32_t code;
	unsigned char series, attribute;
};

/* cell [rows][columns], from the top left. */
struct canvas {
	int columns, rows;
	struct canvas_cell *cell;
};

/* Blank; columns and rows of at least 1. */
struct canvas *canvas_new(int columns, int rows);
void canvas_free(struct canvas *canvas);

/* A cell; asserts that it is on the canvas. */
struct canvas_cell *canvas_at(struct canvas *canvas, int column, int row);

/* Writes text as shown (base/text.h) from a cell to the right, cut at the edge;
 * what is off the canvas is left out. */
void canvas_text(struct canvas *canvas, int column, int row, const char *text,
    enum series series, unsigned attribute);

/* The same, cut at column `end`.  Returns the column after the text. */
int canvas_text_within(struct canvas *canvas, int column, int row, int end,
    const char *text, enum series series, unsigned attribute);

/* A code point as UTF-8 in text, which it returns. */
const char *canvas_utf8(uint32_t code, char text[static 5]);

/* Depth of colour: 0 (none), 8, 16 or 256. Colour of a series in it, or -1 for
 * that of the text; safe for red-green blindness, and never the only mark. From
 * 8 on it is a bright one, which among eight is the bold one. */
int canvas_colour(enum series series, int depth);

/* Whether a cell has that ground; and what is shown of it, a space instead of
 * the shade that the ground is. */
bool canvas_is_shaded(const struct canvas_cell *cell, int depth);
uint32_t canvas_code(const struct canvas_cell *cell, int depth);

/* Prints the rows, each without spaces at its end and with a line feed; escape
 * sequences where depth > 0. */
void canvas_print(const struct canvas *canvas, int depth, FILE *out);

#endif
