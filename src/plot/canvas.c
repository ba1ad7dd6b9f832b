/* A grid of cells: writes text to it and prints it with escape sequences.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/canvas.h"

#include <assert.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/text.h"
#include "base/xalloc.h"

struct canvas *
canvas_new(int columns, int rows)
{
	assert(columns >= 1 && rows >= 1);
	struct canvas *c = xcalloc(1, sizeof *c);
	size_t n = (size_t)columns * (size_t)rows;
	*c = (struct canvas){.columns = columns,
	    .rows = rows,
	    .cell = xcalloc(n, sizeof *c->cell)};
	for (size_t i = 0; i < n; i++)
		c->cell[i].code = ' ';
	return c;
}

void
canvas_free(struct canvas *canvas)
{
	if (canvas != NULL)
		free(canvas->cell);
	free(canvas);
}

struct canvas_cell *
canvas_cell_at(struct canvas *canvas, int column, int row)
{
	assert(column >= 0 && column < canvas->columns);
	assert(row >= 0 && row < canvas->rows);
	return &canvas->cell[row * canvas->columns + column];
}

int
canvas_draw_text_within(struct canvas *canvas, int column, int row, int end,
    const char *text, enum series series, unsigned attribute)
{
	if (row < 0 || row >= canvas->rows)
		return column;
	end = end < canvas->columns ? end : canvas->columns;
	struct canvas_cell cell = {
	    .series = (unsigned char)series,
	    .attribute = (unsigned char)attribute,
	};
	FREED char *shown = text_with_control_escaped(text);
	for (const char *p = shown; *p != '\0';) {
		cell.code = text_next_code_point(&p);
		int width = text_columns_of_character(cell.code);
		if (column + width > end)
			break;
		if (column >= 0 && width > 0)
			*canvas_cell_at(canvas, column, row) = cell;
		cell.code = 0;
		if (column >= 0 && width == 2)
			*canvas_cell_at(canvas, column + 1, row) = cell;
		column += width;
	}
	return column;
}

void
canvas_draw_text(struct canvas *canvas, int column, int row, const char *text,
    enum series series, unsigned attribute)
{
	canvas_draw_text_within(
	    canvas, column, row, canvas->columns, text, series, attribute);
}

bool
canvas_is_cell_faint(
    const struct canvas *canvas, const struct canvas_cell *cell, int depth)
{
	return depth >= 256 && canvas->theme == THEME_NORMAL &&
	       (cell->attribute & CELL_DIM);
}

bool
canvas_is_same_style(const struct canvas_cell *a, const struct canvas_cell *b)
{
	return a->series == b->series && a->attribute == b->attribute;
}

static void
print_canvas_cell_style(const struct canvas *canvas,
    const struct canvas_cell *cell, int depth, FILE *out)
{
	int colour = palette_colour_of_series(
	    (enum series)cell->series, depth, canvas->theme);
	bool bright = depth < 16 && colour >= 8; /* then it is bold */
	if (bright)
		colour -= 8;
	fputs("\033[0", out);
	if ((cell->attribute & CELL_BOLD) || bright)
		fputs(";1", out);
	if (canvas_is_cell_faint(canvas, cell, depth))
		fputs(";2", out);
	if (cell->attribute & CELL_REVERSE)
		fputs(";7", out);
	if (colour >= 0 && depth >= 256)
		fprintf(out, ";38;5;%d", colour);
	else if (colour >= 0)
		fprintf(out, ";%d", colour < 8 ? 30 + colour : 90 + colour - 8);
	fputc('m', out);
}

const char *
canvas_encode_code_point(uint32_t code, char text[static 5])
{
	static const unsigned LEAD[] = {0, 0xC0, 0xE0, 0xF0};
	int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
	char *p = text;
	*p++ = (char)(LEAD[more] | code >> (6 * more));
	while (more-- > 0)
		*p++ = (char)(0x80 | (code >> (6 * more) & 0x3F));
	*p = '\0';
	return text;
}

static void
canvas_print_row(const struct canvas *canvas, int row, int depth, FILE *out)
{
	int columns = canvas->columns;
	const struct canvas_cell *cell = canvas->cell + row * columns;
	struct canvas_cell plain = {.series = SERIES_TEXT}, style = plain;
	char text[5];
	while (columns > 0 && cell[columns - 1].code == ' ' &&
	       !(cell[columns - 1].attribute & CELL_REVERSE))
		columns--;
	for (int i = 0; i < columns; i++) {
		if (depth > 0 && cell[i].code != 0 &&
		    !canvas_is_same_style(&cell[i], &style)) {
			print_canvas_cell_style(canvas, &cell[i], depth, out);
			style = cell[i];
		}
		if (cell[i].code != 0)
			fputs(
			    canvas_encode_code_point(cell[i].code, text), out);
	}
	if (!canvas_is_same_style(&style, &plain))
		fputs("\033[0m", out);
	fputc('\n', out);
}

void
canvas_print(const struct canvas *canvas, int depth, FILE *out)
{
	for (int row = 0; row < canvas->rows; row++)
		canvas_print_row(canvas, row, depth, out);
}

int
canvas_dot_columns_per_cell(enum charset charset)
{
	return charset == CHARSET_ASCII ? 1 : 2;
}

int
canvas_dot_rows_per_cell(enum charset charset)
{
	return charset == CHARSET_ASCII       ? 1
	       : charset == CHARSET_QUADRANTS ? 2
					      : 4;
}

uint32_t
canvas_character_of_dots(enum charset charset, unsigned dots)
{
	static const uint16_t QUADRANTS[16] = {' ', 0x2598, 0x259D, 0x2580,
	    0x2596, 0x258C, 0x259E, 0x259B, 0x2597, 0x259A, 0x2590, 0x259C,
	    0x2584, 0x2599, 0x259F, 0x2588};
	static const unsigned char BRAILLE[8] = {
	    0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80};
	if (charset == CHARSET_QUADRANTS)
		return QUADRANTS[dots];
	unsigned code = 0;
	for (unsigned i = 0; i < ARRAY_LEN(BRAILLE); i++)
		if (dots >> i & 1)
			code |= BRAILLE[i];
	return code > 0 ? 0x2800 + code : ' ';
}
