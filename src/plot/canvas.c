/* A grid of cells: text into it, escape sequences out of it.
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
	*c = (struct canvas){columns, rows, xcalloc(n, sizeof *c->cell)};
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
canvas_at(struct canvas *canvas, int column, int row)
{
	assert(column >= 0 && column < canvas->columns);
	assert(row >= 0 && row < canvas->rows);
	return &canvas->cell[row * canvas->columns + column];
}

int
canvas_text_within(struct canvas *canvas, int column, int row, int end,
    const char *text, enum series series, unsigned attribute)
{
	if (row < 0 || row >= canvas->rows)
		return column;
	end = end < canvas->columns ? end : canvas->columns;
	struct canvas_cell cell = {
	    .series = (unsigned char)series,
	    .attribute = (unsigned char)attribute,
	};
	char *shown = text_shown(text);
	for (const char *p = shown; *p != '\0';) {
		cell.code = text_next(&p);
		int width = text_columns(cell.code);
		if (column + width > end)
			break;
		if (column >= 0 && width > 0)
			*canvas_at(canvas, column, row) = cell;
		cell.code = 0;
		if (column >= 0 && width == 2)
			*canvas_at(canvas, column + 1, row) = cell;
		column += width;
	}
	free(shown);
	return column;
}

void
canvas_text(struct canvas *canvas, int column, int row, const char *text,
    enum series series, unsigned attribute)
{
	canvas_text_within(
	    canvas, column, row, canvas->columns, text, series, attribute);
}

/* The safe colours of Okabe and Ito as near as each depth has them; no bright
 * black, which some terminals do not show, and no dark blue, which the Linux
 * console hardly shows on black. */
int
canvas_colour(enum series series, int depth)
{
	static const struct {
		int of8, of16, of256;
	} COLOURS[SERIES_COUNT] = {
	    [SERIES_TEXT] = {-1, -1, -1},
	    [SERIES_FEED] = {3, 3, 178},
	    [SERIES_MEASURED_1] = {6, 14, 74},
	    [SERIES_MEASURED_2] = {2, 10, 36},
	    [SERIES_MEASURED_3] = {12, 12, 33},
	    [SERIES_PREDICTED] = {1, 9, 202},
	    [SERIES_OTHER] = {5, 13, 175},
	    [SERIES_BAND] = {1, 1, 180},
	    [SERIES_BREAK] = {3, 3, 178},
	    [SERIES_CROSSHAIR] = {-1, -1, -1},
	};
	return depth <= 0    ? -1
	       : depth < 16  ? COLOURS[series].of8
	       : depth < 256 ? COLOURS[series].of16
			     : COLOURS[series].of256;
}

bool
canvas_is_shaded(const struct canvas_cell *cell, int depth)
{
	return depth >= 256 && (cell->attribute & CELL_SHADE);
}

uint32_t
canvas_code(const struct canvas_cell *cell, int depth)
{
	bool ground =
	    cell->code == CANVAS_SHADE_CODE && canvas_is_shaded(cell, depth);
	return ground ? ' ' : cell->code;
}

static void
print_style(const struct canvas_cell *cell, int depth, FILE *out)
{
	int colour = canvas_colour((enum series)cell->series, depth);
	bool bright = depth < 16 && colour >= 8; /* there: bold */
	if (bright)
		colour -= 8;
	fputs("\033[0", out);
	if ((cell->attribute & CELL_BOLD) || bright)
		fputs(";1", out);
	if ((cell->attribute & CELL_DIM) && depth >= 256)
		fputs(";2", out);
	if (cell->attribute & CELL_REVERSE)
		fputs(";7", out);
	if (canvas_is_shaded(cell, depth))
		fprintf(out, ";48;5;%d", CANVAS_SHADE);
	if (colour >= 0 && depth >= 256)
		fprintf(out, ";38;5;%d", colour);
	else if (colour >= 0)
		fprintf(out, ";%d", colour < 8 ? 30 + colour : 90 + colour - 8);
	fputc('m', out);
}

const char *
canvas_utf8(uint32_t code, char text[static 5])
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
print_row(const struct canvas_cell *cell, int columns, int depth, FILE *out)
{
	struct canvas_cell plain = {.series = SERIES_TEXT}, style = plain;
	char text[5];
	while (columns > 0 && cell[columns - 1].code == ' ' &&
	       !(cell[columns - 1].attribute & CELL_REVERSE) &&
	       !canvas_is_shaded(&cell[columns - 1], depth))
		columns--;
	for (int i = 0; i < columns; i++) {
		bool same = cell[i].series == style.series &&
			    cell[i].attribute == style.attribute;
		if (depth > 0 && !same && cell[i].code != 0) {
			print_style(&cell[i], depth, out);
			style = cell[i];
		}
		if (cell[i].code != 0)
			fputs(canvas_utf8(canvas_code(&cell[i], depth), text),
			    out);
	}
	if (style.series != plain.series || style.attribute != plain.attribute)
		fputs("\033[0m", out);
	fputc('\n', out);
}

void
canvas_print(const struct canvas *canvas, int depth, FILE *out)
{
	for (int row = 0; row < canvas->rows; row++)
		print_row(canvas->cell + row * canvas->columns, canvas->columns,
		    depth, out);
}
