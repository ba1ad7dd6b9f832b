/* A grid of cells.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/canvas.h"

#include <assert.h>
#include <stdlib.h>

#include "base/xalloc.h"

struct canvas *
canvas_new(int columns, int rows)
{
	struct canvas *canvas = xcalloc(1, sizeof *canvas);
	size_t n = (size_t)columns * (size_t)rows;
	canvas->columns = columns;
	canvas->rows = rows;
	canvas->cell = xcalloc(n, sizeof *canvas->cell);
	for (size_t i = 0; i < n; i++)
		canvas->cell[i].code = ' ';
	return canvas;
}

void
canvas_free(struct canvas *canvas)
{
	if (canvas == NULL)
		return;
	free(canvas->cell);
	free(canvas);
}

struct canvas_cell *
canvas_at(struct canvas *canvas, int column, int row)
{
	assert(column >= 0 && column < canvas->columns && row >= 0 &&
	       row < canvas->rows);
	return &canvas->cell[row * canvas->columns + column];
}

void
canvas_text(struct canvas *canvas, int column, int row, const char *text,
    enum series series, unsigned attribute)
{
	for (; *text != '\0' && column < canvas->columns; text++, column++)
		if (row >= 0 && row < canvas->rows && column >= 0)
			*canvas_at(canvas, column, row) = (struct canvas_cell){
			    (unsigned char)*text, (unsigned char)series,
			    (unsigned char)attribute};
}

int
canvas_colour(enum series series, int depth)
{
	static const int colours[SERIES_COUNT] = {
	    -1, 3, 6, 4, 5, 2, 1, 3, 5, 7};
	return depth > 0 ? colours[series] : -1;
}
