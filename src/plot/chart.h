/* Charts as plain data, independent of where they are drawn.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_CHART_H
#define TIPSPEED_PLOT_CHART_H

#include <stdbool.h>
#include <stddef.h>

#include "plot/axis.h"
#include "plot/canvas.h"

/* Dashes are counted along the path, so that a steep part looks like a flat
 * one; on a canvas from the column of each point, so that a curve that moves in
 * one part keeps its dashes elsewhere. */
enum chart_line {
	CHART_MARKS, /* no line */
	CHART_SOLID,
	CHART_DASHED,
	CHART_LONG, /* long dashes */
	CHART_DOTTED
};

/* The site of a point, where a chart has several sites.  label: text that may
 * be written beside it, or NULL. */
struct chart_whose {
	char *site, *about, *label;
};

/* A field drawn around a point instead of a mark, a unit wide and high, filled
 * in proportion to |value|, at most 1, with its label; NAN: none. */
struct chart_field {
	double value;
	char *label;
};

/* One curve or set of points.  fine: its marks are drawn in parts of a cell
 * (plot/marks.h), and several such series take turns in lying on top.  x, y [n]
 * in the axes' units; a NAN in y lifts the pen.  low, high [n]: a shade behind
 * all lines, or both NULL.  ascii: the character of a line where there are only
 * ASCII characters; mark: an ASCII character at each point, 0: none.  bars:
 * low..high are a bar at each point instead of a shade, y is not drawn; long
 * dashes make it a heavy one.  beside: drawn so many cells to the right of x.
 * lifted: its marks stand out of bars, in reverse, with a gap on either side.
 * named: labels of its points are written where there is room.  whose, field
 * [n]: or NULL.  finer: points of the same curve that chart_at_y reads instead,
 * owned; NULL: none. */
struct chart_series {
	char *name;
	enum series series;
	enum chart_line line;
	char ascii, mark;
	bool fine;
	bool bars, lifted, named;
	int beside;
	size_t n;
	double *x, *y, *low, *high;
	struct chart_whose *whose;
	struct chart_field *field;
	struct chart_series *finer;
};

/* A line across the plot from its foot to its top, at x. */
struct chart_rule {
	double x;
	enum series series;
	char *name;
};

/* strip: the number of rows in which it is drawn, without labels, below another
 * chart of the same sizes; 0: a chart of its own.  Later series lie on top.
 * about: where the data are from, shown at the foot after "data: "; note: lines
 * below the legend; below: another chart that is drawn below it, of the same x
 * axis and other units, or NULL; chart_free frees it too. */
struct chart {
	char *title, *about;
	struct axis x, y;
	enum theme theme;
	int strip;
	size_t n, n_rule, n_note;
	struct chart_series **series;
	struct chart_rule *rule;
	char **note;
	struct chart *below;
};

/* The chart takes the axes; the words are copied. */
struct chart *chart_new(
    const char *title, const char *about, struct axis x, struct axis y);
void chart_free(struct chart *chart);

/* A series of n points at zero, to be filled in.  look: what distinguishes it
 * without colour: line, ascii and mark; its data are ignored.  Borrowed; it
 * does not move as others are added. */
struct chart_series *chart_add(struct chart *chart, struct chart_series look,
    size_t n, const char *name, ...) __attribute__((format(printf, 4, 5)));

/* An array whose for a series, to be filled with strings that it then owns. */
void chart_add_whose(struct chart_series *series);

/* Arrays low and high for a series, for its shade. */
void chart_add_band(struct chart_series *series);

/* Its finer points [n], of which x and y are to be filled in. */
struct chart_series *chart_add_finer(struct chart_series *series, size_t n);

/* Nothing is added where x lies outside the axis. */
void chart_add_rule(struct chart *chart, enum series series, double x,
    const char *name, ...) __attribute__((format(printf, 4, 5)));

void chart_note(struct chart *chart, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* y at x, straight between the points as the axes have it; NAN outside the
 * points.  at_y: x at y of points whose y never turns. */
double chart_at(
    const struct chart *chart, const struct chart_series *series, double x);
double chart_at_y(
    const struct chart *chart, const struct chart_series *series, double y);

/* How many dots of a line's path are drawn, then left out, and so on; off is 0
 * of a solid line. */
void chart_dash(enum chart_line line, int *on, int *off);

#endif
