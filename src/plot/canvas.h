/* A grid of cells, on which plots and screens are drawn.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_CANVAS_H
#define TIPSPEED_PLOT_CANVAS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "plot/palette.h"

/* The characters with which lines are drawn: ASCII, quarters of a cell (2 x 2),
 * or braille dots (2 x 4). */
enum charset { CHARSET_ASCII, CHARSET_QUADRANTS, CHARSET_BRAILLE };

enum { CELL_BOLD = 1, CELL_DIM = 2, CELL_REVERSE = 4 };

/* code: a Unicode code point, or 0 after a character two columns wide. */
struct canvas_cell {
	uint32_t code;
	unsigned char series, attribute;
};

/* cell [rows][columns], from the top left. */
struct canvas {
	int columns, rows;
	enum theme theme;
	struct canvas_cell *cell;
};

/* Returns a blank canvas; columns and rows must be at least 1. */
struct canvas *canvas_new(int columns, int rows);
void canvas_free(struct canvas *canvas);

/* Returns a cell; asserts that it is on the canvas. */
struct canvas_cell *canvas_cell_at(struct canvas *canvas, int column, int row);

/* Writes text to the right from a cell, clipped at the edges of the canvas.
 * Control characters are escaped (text_escape_next_character). */
void canvas_draw_text(struct canvas *canvas, int column, int row,
    const char *text, enum series series, unsigned attribute);

/* As canvas_draw_text, but clipped at column `end`.  Returns the column after
 * the text. */
int canvas_draw_text_within(struct canvas *canvas, int column, int row, int end,
    const char *text, enum series series, unsigned attribute);

/* Writes a code point as UTF-8 to text and returns text. */
const char *canvas_encode_code_point(uint32_t code, char text[static 5]);

/* True if two cells have the same colour and attributes. */
bool canvas_is_same_style(
    const struct canvas_cell *a, const struct canvas_cell *b);

/* True if a cell is drawn faint: it is dim, there are 256 colours, and the
 * theme is not a high-contrast one. */
bool canvas_is_cell_faint(
    const struct canvas *canvas, const struct canvas_cell *cell, int depth);

/* Prints the rows as lines without trailing spaces, with escape sequences if
 * depth > 0. */
void canvas_print(const struct canvas *canvas, int depth, FILE *out);

/* canvas_dot_columns_per_cell and canvas_dot_rows_per_cell return the number of
 * dots in a cell in each direction.  canvas_character_of_dots returns the
 * character with the given dots set, bit 2 * row + column; not for ASCII, which
 * has none. */
int canvas_dot_columns_per_cell(enum charset charset);
int canvas_dot_rows_per_cell(enum charset charset);
uint32_t canvas_character_of_dots(enum charset charset, unsigned dots);

#endif
