/* A plain text plot: characters in a grid.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/curve.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

enum { LEFT = 6, BELOW = 3 }; /* room for the axes */

/* cell [rows * columns], row 0 at 100 %. */
struct grid {
	int columns, rows;
	char *cell;
	double log_low, log_high;
};

static int
column_of(const struct grid *g, double size)
{
	double t = (log(size) - g->log_low) / (g->log_high - g->log_low);
	return (int)lround(t * (g->columns - 1));
}

static void
put(struct grid *g, int column, double passing, char mark)
{
	int row = (int)lround((1 - passing / 100) * (g->rows - 1));
	if (column >= 0 && column < g->columns && row >= 0 && row < g->rows)
		g->cell[row * g->columns + column] = mark;
}

/* Straight on log size from sieve to sieve. */
static void
draw(struct grid *g, const struct curve *c)
{
	for (size_t i = 0; i < c->n && c->points; i++)
		put(g, column_of(g, c->size[i]), c->passing[i], c->mark);
	for (size_t i = 0; i + 1 < c->n && !c->points; i++) {
		int from = column_of(g, c->size[i + 1]);
		int to = column_of(g, c->size[i]);
		for (int x = from; x <= to; x++) {
			double t =
			    to > from ? (double)(x - from) / (to - from) : 1;
			put(g, x,
			    c->passing[i + 1] +
				t * (c->passing[i] - c->passing[i + 1]),
			    c->mark);
		}
	}
}

static void
print_grid(const struct grid *g, FILE *out)
{
	for (int row = 0; row < g->rows; row++) {
		int percent =
		    (int)lround(100.0 * (g->rows - 1 - row) / (g->rows - 1));
		if (row % 5 == 0 || row == g->rows - 1)
			fprintf(out, "%4d +", percent);
		else
			fprintf(out, "%*s|", LEFT - 1, "");
		int end = g->columns;
		const char *cells = g->cell + row * g->columns;
		while (end > 0 && cells[end - 1] == ' ')
			end--;
		fprintf(out, "%.*s\n", end, cells);
	}
}

/* Ticks at every sieve, and labels where there is room for them. */
static void
print_axis(const struct grid *g, const struct curve *c, FILE *out)
{
	char *ticks = xcalloc((size_t)g->columns + 1, 1);
	char *labels = xcalloc((size_t)g->columns + 16, 1);
	memset(ticks, '-', (size_t)g->columns);
	memset(labels, ' ', (size_t)g->columns + 15);
	int next = 0;
	for (size_t i = c->n; i-- > 0;) {
		char text[16];
		int column = column_of(g, c->size[i]);
		int n = snprintf(text, sizeof text, "%g", c->size[i]);
		int at = column - n / 2 > 0 ? column - n / 2 : 0;
		ticks[column] = '+';
		if (at < next || n > 12)
			continue;
		memcpy(labels + at, text, (size_t)n);
		next = at + n + 1;
	}
	int end = g->columns + 15;
	while (end > 0 && labels[end - 1] == ' ')
		end--;
	fprintf(
	    out, "%*s%s\n%*s%.*s mm\n", LEFT, "", ticks, LEFT, "", end, labels);
	free(ticks);
	free(labels);
}

void
curve_print(const struct curve *curve, size_t n, double break_mm, int width,
    int height, FILE *out)
{
	struct grid g = {.columns = width - LEFT - 4,
	    .rows = height - BELOW,
	    .log_low = INFINITY,
	    .log_high = -INFINITY};
	for (size_t i = 0; i < n; i++) {
		g.log_low = fmin(g.log_low, log(curve[i].size[curve[i].n - 1]));
		g.log_high = fmax(g.log_high, log(curve[i].size[0]));
	}
	size_t cells = (size_t)(g.columns * g.rows);
	g.cell = xcalloc(cells, 1);
	memset(g.cell, ' ', cells);
	bool shown = break_mm > 0 && log(break_mm) > g.log_low &&
		     log(break_mm) < g.log_high;
	for (int row = 0; shown && row < g.rows; row++)
		g.cell[row * g.columns + column_of(&g, break_mm)] = ':';
	for (size_t i = 0; i < n; i++)
		draw(&g, &curve[i]);
	print_grid(&g, out);
	print_axis(&g, &curve[0], out);
	fprintf(out, "%*s", LEFT, "");
	for (size_t i = 0; i < n; i++)
		fprintf(out, "%c %s   ", curve[i].mark, curve[i].name);
	fprintf(out, shown ? ": break size\n" : "\n");
	free(g.cell);
}
