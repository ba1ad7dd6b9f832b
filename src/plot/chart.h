/* Charts as plain data, independent of the output.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_CHART_H
#define TIPSPEED_PLOT_CHART_H

#include <stdbool.h>
#include <stddef.h>

#include "plot/axis.h"
#include "plot/canvas.h"

/* Kinds of lines.  Dashes are counted along the path, so that steep and flat
 * parts look alike.  On a canvas they are counted by the column of each point,
 * so that a curve that changes in one part keeps its dashes elsewhere. */
enum chart_line {
	CHART_MARKS, /* no line */
	CHART_SOLID,
	CHART_DASHED,
	CHART_LONG, /* long dashes */
	CHART_DOTTED
};

/* The shape that stands for an ASCII character.  sign: its code point in a
 * cell.  On paper it has `sides` sides, with the first corner at `turn` of a
 * full turn.  hollow: it is for a held-out run. */
struct point_mark {
	char code;
	unsigned sign;
	int sides;
	double turn;
	bool hollow;
};

/* Returns the mark of a character, or NULL. */
const struct point_mark *point_mark_of_character(char code);

/* Returns the character of full or hollow mark i; these repeat cyclically. */
char nth_mark_character(unsigned i, bool hollow);

/* The site or material of a point, for a chart with several; NULL for data of
 * no site.  about: the source of its data.  label: a text to show beside the
 * point if there is room, or NULL. */
struct chart_whose {
	char *site, *about, *label;
};

/* A field with a label, drawn around a point instead of a mark: one unit wide
 * and high, filled in proportion to |value|, which is at most 1.  value NAN:
 * only the label. */
struct chart_field {
	double value;
	char *label;
};

/* One curve or set of points.
 *
 * x, y [n]: in the axes' units; a NAN in y interrupts the line.  low, high [n]:
 * a shaded band behind all lines, or both NULL.  ascii: the character of the
 * line where only ASCII is available.  mark: an ASCII character at each point,
 * or 0.  fine: marks have the shapes of struct point_mark.
 *
 * bars: low to high is drawn as a bar at each point instead of a band, and y is
 * not drawn as a line; with CHART_LONG, bars are heavy.  beside: cells by which
 * points are drawn to the right of x.  lifted: marks are set off from bars by a
 * gap on either side and, unless fine, in reverse.  named: labels of points are
 * shown if there is room.  whose, field [n]: may be NULL.
 *
 * finer: more closely spaced points of the same curve, for chart_series_x_at_y;
 * owned, or NULL.  compared: the difference of this series from the last one is
 * drawn below.  psd: it is a size distribution, off which P20, P50 and P80 are
 * read. */
struct chart_series {
	char *name;
	enum series series;
	enum chart_line line;
	char ascii, mark;
	bool fine;
	bool bars, lifted, named, compared, psd;
	int beside;
	size_t n;
	double *x, *y, *low, *high;
	struct chart_whose *whose;
	struct chart_field *field;
	struct chart_series *finer;
};

/* A vertical line across the plot at x. */
struct chart_rule {
	double x;
	enum series series;
	char *name;
};

/* strip: the number of rows of a chart drawn without labels below another chart
 * with the same x axis; 0 for a chart of its own.  Later series are drawn on
 * top.  mixed: the series are of different quantities, which are not to be
 * compared.  about: the source of the data, shown at the foot after "data: ".
 * note: lines below the legend.  below: another chart to draw below this one,
 * with the same x axis but other units, or NULL; chart_free also frees it. */
struct chart {
	char *title, *about;
	struct axis x, y;
	enum theme theme;
	bool mixed;
	int strip;
	size_t n, n_rule, n_note;
	struct chart_series **series;
	struct chart_rule *rule;
	char **note;
	struct chart *below;
};

/* Makes a chart and takes ownership of the axes; title and about are copied. */
struct chart *chart_new(
    const char *title, const char *about, struct axis x, struct axis y);
void chart_free(struct chart *chart);

/* Adds a series of n points at zero, to be filled in.  look: its members that
 * distinguish the series, such as line, ascii and mark; the data in it are
 * ignored.  Returns the series, borrowed; it stays valid when others are
 * added. */
struct chart_series *chart_append_series(struct chart *chart,
    struct chart_series look, size_t n, const char *name, ...)
    __attribute__((format(printf, 4, 5)));

/* As chart_append_series, but with the points x, y [n], which are copied. */
void chart_append_point_series(struct chart *chart, struct chart_series look,
    size_t n, const double *x, const double *y, const char *name);

/* Moves the last series to the front, so that all others are drawn on top. */
void chart_move_last_series_to_back(struct chart *chart);

/* Adds an array `whose` to a series, to be filled with strings that the series
 * then owns. */
void chart_allocate_point_names(struct chart_series *series);

/* series_allocate_band adds arrays low and high to a series, for its band;
 * series_remove_band removes them. */
void series_allocate_band(struct chart_series *series);
void series_remove_band(struct chart_series *series);

/* Adds n finer points to a series and returns them; their x and y are to be
 * filled in. */
struct chart_series *chart_allocate_finer_points(
    struct chart_series *series, size_t n);

/* Adds a rule, unless x is outside the axis. */
void chart_add_vertical_rule(struct chart *chart, enum series series, double x,
    const char *name, ...) __attribute__((format(printf, 4, 5)));

void chart_add_note(struct chart *chart, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* chart_series_y_at_x returns y at x by interpolation, along lines that are
 * straight on the axes; NAN outside the points.  chart_interpolate_at_x does so
 * for other values [n] at the points.  chart_series_x_at_y returns x at y,
 * where y is monotonic. */
double chart_interpolate_at_x(const struct chart *chart,
    const struct chart_series *series, const double *value, double x);
double chart_series_y_at_x(
    const struct chart *chart, const struct chart_series *series, double x);
double chart_series_x_at_y(
    const struct chart *chart, const struct chart_series *series, double y);

/* The ranges of x and y, from and to, that all series cover with their bands;
 * INFINITY to -INFINITY if there are no points. */
struct chart_extent {
	double x[2], y[2];
};
struct chart_extent chart_compute_extent(const struct chart *chart);

/* Sets *on to the number of dots in each dash of a line, and *off to that in
 * each gap; *off is 0 for a solid line. */
void chart_dash_lengths(enum chart_line line, int *on, int *off);

#endif
