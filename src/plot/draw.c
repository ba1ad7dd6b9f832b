/* Lays out a chart on a canvas and draws it: what surrounds the data, then
 * bands, guides, rules, lines and marks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/draw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

/* The data's cells begin at left, top and are width x height; dots: those set
 * so far in each cell.  Each other part has its first row, or -1 if it was
 * dropped.  words: bits of CHART_ALL. */
struct layout {
	const struct chart *chart;
	struct canvas *canvas;
	enum charset charset;
	unsigned words;
	int left, top, width, height;
	int title, y_title, axis, labels, rows_of_x_labels, legend, foot;
	unsigned char *dots;
};

/* column_of_chart_x returns the column of an x among the data, row_of_chart_y
 * the row of a y: the part that contains the value, always within the data.
 * parts: into how many parts each cell is divided, 1, or 2 or 4 for dots. */
static int
column_of_chart_x(const struct layout *l, double x, int parts)
{
	return axis_cell_at_position(
	    axis_relative_position(&l->chart->x, x), l->width * parts);
}

static int
row_of_chart_y(const struct layout *l, double y, int parts)
{
	return axis_cell_at_position(
	    1 - axis_relative_position(&l->chart->y, y), l->height * parts);
}

static uint32_t
char_of_vertical_rule(enum series series, enum charset charset)
{
	bool ascii = charset == CHARSET_ASCII;
	switch (series) {
	case SERIES_CROSSHAIR:
		return ascii ? '|' : 0x2502;
	case SERIES_OTHER:
		return ascii ? '!' : 0x254E;
	default:
		return ascii ? ':' : 0x250A;
	}
}

static uint32_t
char_of_mark(const struct chart_series *s, enum charset charset)
{
	const struct point_mark *mark = point_mark_of_character(s->mark);
	return s->fine && mark != NULL && charset != CHARSET_ASCII
		   ? mark->sign
		   : (uint32_t)s->mark;
}

char *
chart_legend_sample(const struct chart_series *series, enum charset charset)
{
	static const char *const LINES[] = {[CHART_MARKS] = "",
	    [CHART_SOLID] = "\u2500",
	    [CHART_DASHED] = "\u254C",
	    [CHART_LONG] = "\u2501",
	    [CHART_DOTTED] = "\u2508"};
	char ascii[2] = {series->ascii, '\0'};
	char mark[5] = "";
	const char *line = series->line == CHART_MARKS ? ""
			   : charset == CHARSET_ASCII  ? ascii
						       : LINES[series->line];
	if (series->mark != '\0')
		canvas_encode_code_point(char_of_mark(series, charset), mark);
	/* A heavy line would not look dashed; a bar is meant to be heavy. */
	if (series->line == CHART_LONG && mark[0] == '\0' && !series->bars)
		return xasprintf(
		    charset == CHARSET_ASCII ? "%s %s" : "\u2500 \u2500", ascii,
		    ascii);
	return xasprintf("%s%s%s", line, mark[0] != '\0' ? mark : line, line);
}

/* As canvas_draw_text, but text that the edge would cut is shortened to what
 * can be read. */
static void
draw_text_cut_to_width(struct layout *l, int column, int row, const char *text,
    enum series series, unsigned attribute)
{
	FREED char *fitted =
	    text_cut_to_width(text, l->canvas->columns - column);
	canvas_draw_text(l->canvas, column, row, fitted, series, attribute);
}

/* Lays out series that have a name, and then rules, side by side in rows as
 * wide as the canvas.  Draws them from `row` on or, if it is negative, only
 * counts rows.  Returns the number of rows. */
static int
draw_or_count_legend_rows(struct layout *l, int row)
{
	enum { GAP = 3 };
	const struct chart *c = l->chart;
	int column = 0, rows = 0;
	for (size_t i = 0; i < c->n + c->n_rule; i++) {
		const struct chart_rule *rule =
		    i < c->n ? NULL : &c->rule[i - c->n];
		enum series series =
		    rule != NULL ? rule->series : c->series[i]->series;
		if (rule == NULL && c->series[i]->name[0] == '\0')
			continue;
		FREED char *sample =
		    rule != NULL
			? xstrdup(" ")
			: chart_legend_sample(c->series[i], l->charset);
		FREED char *text = xasprintf("%s %s", sample,
		    rule != NULL ? rule->name : c->series[i]->name);
		int wide = text_width_in_columns(text);
		if (rows == 0 || column + wide > l->canvas->columns) {
			column = 0;
			rows++;
		}
		if (row >= 0)
			draw_text_cut_to_width(
			    l, column, row + rows - 1, text, series, 0);
		if (row >= 0 && rule != NULL && column < l->canvas->columns)
			*canvas_cell_at(l->canvas, column, row + rows - 1) =
			    (struct canvas_cell){
				char_of_vertical_rule(series, l->charset),
				(unsigned char)series, 0};
		column += wide + GAP;
	}
	return rows;
}

/* Draws text in lines as wide as the canvas, from `row` on or, if that is
 * negative, only counts them.  Returns their number. */
static int
draw_or_count_wrapped_text(
    struct layout *l, int row, const char *text, unsigned attribute)
{
	FREED char *wrapped = text_wrapped(text, l->canvas->columns);
	char *save = NULL;
	int rows = 0;
	for (char *line = strtok_r(wrapped, "\n", &save); line != NULL;
	     line = strtok_r(NULL, "\n", &save), rows++)
		if (row >= 0)
			canvas_draw_text(l->canvas, 0, row + rows, line,
			    SERIES_TEXT, attribute);
	return rows;
}

static int
draw_or_count_legend_and_notes(struct layout *l, int row)
{
	int rows =
	    l->words & CHART_LEGEND ? draw_or_count_legend_rows(l, row) : 0;
	size_t n = l->words & CHART_NOTES ? l->chart->n_note : 0;
	for (size_t i = 0; i < n; i++)
		rows += draw_or_count_wrapped_text(
		    l, row < 0 ? row : row + rows, l->chart->note[i], 0);
	return rows;
}

/* Lays out the line about the source of the data.  Returns its rows. */
static int
draw_or_count_data_source(struct layout *l, int row)
{
	FREED char *text = xasprintf(tr("data: %s"), l->chart->about);
	return draw_or_count_wrapped_text(l, row, text, CELL_DIM);
}

/* Returns the number of columns for the labels of the y axis and its line, the
 * same for all charts below one another; 0 on a canvas that is hardly wider.
 * The labels of a strip change with its limits, so there is always room for
 * "+0.5". */
static int
y_label_columns(const struct chart *chart, int columns, unsigned words)
{
	enum { NARROW = 3, STRIP = 4 };
	int wide = 0;
	for (const struct chart *c = chart; c != NULL; c = c->below) {
		wide = c->strip > 0 && wide < STRIP ? STRIP : wide;
		for (size_t i = 0; i < c->y.n; i++) {
			int label = text_width_in_columns(c->y.tick[i].label);
			wide = label > wide ? label : wide;
		}
	}
	bool narrow = columns < NARROW * (wide + 1);
	return narrow || words & CHART_BARE ? 0 : wide + 1;
}

/* Returns the number of rows that the labels of the x axis want, 1 or 2. */
static int
rows_of_x_labels(const struct layout *l)
{
	const struct axis *a = &l->chart->x;
	FREED int *column = xcalloc(a->n, sizeof *column);
	FREED int *row = xcalloc(a->n, sizeof *row);
	return axis_place_labels(a, l->width, 2, column, row);
}

/* A strip has only its title; bare data have not even that. */
static struct layout
lay_out_chart_strip(struct layout l)
{
	bool bare = l.words & CHART_BARE;
	l.title = l.canvas->rows > 1 && !bare ? 0 : -1;
	l.top = l.title + 1;
	l.height = l.canvas->rows - l.top;
	l.y_title = l.axis = l.labels = l.legend = l.foot = -1;
	return l;
}

static struct layout
lay_out_chart(const struct chart *chart, struct canvas *canvas, int left,
    enum charset charset, unsigned words)
{
	enum { Y_TITLE, LEGEND, SECOND, FOOT, TITLE, LABELS, AXIS, PARTS };
	enum { LEAST = 3, PLENTY = 6 };
	struct layout l = {.chart = chart,
	    .canvas = canvas,
	    .charset = charset,
	    .words = words};
	l.left = left;
	l.width = canvas->columns - l.left;
	if (chart->strip > 0 || words & CHART_BARE)
		return lay_out_chart_strip(l);
	int rows[PARTS] = {[Y_TITLE] = 1,
	    [LEGEND] = draw_or_count_legend_and_notes(&l, -1),
	    [SECOND] = rows_of_x_labels(&l) - 1,
	    [FOOT] = words & CHART_LEGEND &&
			     (chart->below == NULL || chart->below->strip > 0)
			 ? draw_or_count_data_source(&l, -1)
			 : 0,
	    [TITLE] = words & CHART_TITLE ? 1 : 0,
	    [LABELS] = 1,
	    [AXIS] = 1};
	l.height = canvas->rows;
	for (int i = 0; i < PARTS; i++)
		l.height -= rows[i];
	for (int i = 0; i < PARTS; i++) {
		if (l.height >= (i < TITLE ? PLENTY : LEAST))
			break;
		l.height += rows[i];
		rows[i] = 0;
	}
	l.top = rows[TITLE] + rows[Y_TITLE];
	l.title = rows[TITLE] > 0 ? 0 : -1;
	l.y_title = rows[Y_TITLE] > 0 ? rows[TITLE] : -1;
	int at = l.top + l.height;
	l.axis = rows[AXIS] > 0 ? at : -1;
	at += rows[AXIS];
	l.rows_of_x_labels = rows[LABELS] + rows[SECOND];
	l.labels = rows[LABELS] > 0 ? at : -1;
	at += l.rows_of_x_labels;
	l.legend = rows[LEGEND] > 0 ? at : -1;
	l.foot = rows[FOOT] > 0 ? at + rows[LEGEND] : -1;
	return l;
}

/* Draws a part of an axis, faint so that the data are seen first. */
static void
draw_axis_char(struct layout *l, int column, int row, uint32_t code)
{
	if (column >= 0)
		*canvas_cell_at(l->canvas, column, row) =
		    (struct canvas_cell){code, SERIES_TEXT, CELL_DIM};
}

/* Draws the line to the left of the plot, with ticks.  Of several labels in a
 * row, only the one with the lowest rank is drawn. */
static void
draw_chart_y_axis(struct layout *l)
{
	enum { RANKS = 3 };
	const struct axis *a = &l->chart->y;
	bool ascii = l->charset == CHARSET_ASCII;
	FREED char *taken = xcalloc((size_t)l->height, 1);
	for (int row = 0; row < l->height; row++)
		draw_axis_char(
		    l, l->left - 1, l->top + row, ascii ? '|' : 0x2502);
	for (int rank = 0; rank < RANKS; rank++)
		for (size_t i = 0; i < a->n; i++) {
			const struct axis_tick *t = &a->tick[i];
			int row = row_of_chart_y(l, t->at, 1);
			draw_axis_char(
			    l, l->left - 1, l->top + row, ascii ? '+' : 0x2524);
			if (t->rank != rank || taken[row])
				continue;
			taken[row] = 1;
			canvas_draw_text(l->canvas,
			    l->left - 1 - text_width_in_columns(t->label),
			    l->top + row, t->label, SERIES_TEXT, 0);
		}
}

static void
draw_chart_x_axis_line(struct layout *l)
{
	const struct axis *a = &l->chart->x;
	bool ascii = l->charset == CHARSET_ASCII;
	if (l->axis < 0)
		return;
	draw_axis_char(l, l->left - 1, l->axis, ascii ? '+' : 0x2514);
	for (int column = 0; column < l->width; column++)
		draw_axis_char(
		    l, l->left + column, l->axis, ascii ? '-' : 0x2500);
	for (size_t i = 0; i < a->n; i++)
		draw_axis_char(l,
		    l->left + column_of_chart_x(l, a->tick[i].at, 1), l->axis,
		    ascii ? '+' : 0x252C);
}

static void
draw_chart_x_axis_labels(struct layout *l)
{
	const struct axis *a = &l->chart->x;
	FREED int *column = xcalloc(a->n, sizeof *column);
	FREED int *row = xcalloc(a->n, sizeof *row);
	if (l->labels < 0)
		return;
	axis_place_labels(a, l->width, l->rows_of_x_labels, column, row);
	for (size_t i = 0; i < a->n; i++)
		if (row[i] != AXIS_DROPPED)
			canvas_draw_text(l->canvas, l->left + column[i],
			    l->labels + row[i], a->tick[i].label, SERIES_TEXT,
			    0);
}

/* Returns the title, "Tierp, Granite, 11.2 mm: product", or what fits of it:
 * "Tierp: product", or "product". */
static char *
title_that_fits(const char *title, int columns)
{
	const char *rest = strstr(title, ": ");
	if (text_width_in_columns(title) <= columns || rest == NULL)
		return xstrdup(title);
	char *named =
	    xasprintf("%.*s%s", (int)strcspn(title, ",:"), title, rest);
	if (text_width_in_columns(named) <= columns)
		return named;
	free(named);
	return xstrdup(rest + 2);
}

static void
draw_chart_titles(struct layout *l)
{
	const struct chart *c = l->chart;
	int columns = l->canvas->columns;
	FREED char *axes =
	    xasprintf(tr("%s  against  %s"), c->y.title, c->x.title);
	FREED char *title = c->strip > 0 ? xstrdup(c->title)
					 : title_that_fits(c->title, columns);
	if (l->title >= 0)
		draw_text_cut_to_width(l, 0, l->title, title, SERIES_TEXT,
		    c->strip > 0 ? CELL_DIM : CELL_BOLD);
	if (l->y_title >= 0)
		draw_text_cut_to_width(l, 0, l->y_title,
		    text_width_in_columns(axes) <= columns ? axes : c->y.title,
		    SERIES_TEXT, 0);
}

/* Draws titles, axes, labels, legend and foot: everything but the data. */
static void
draw_chart_titles_and_axes(struct layout *l)
{
	draw_chart_titles(l);
	if (l->left > 0)
		draw_chart_y_axis(l);
	draw_chart_x_axis_line(l);
	draw_chart_x_axis_labels(l);
	if (l->legend >= 0)
		draw_or_count_legend_and_notes(l, l->legend);
	if (l->foot >= 0)
		draw_or_count_data_source(l, l->foot);
}

/* Returns true if a line is drawn at this step of its path, rather than in a
 * gap.  In ASCII a step is a whole cell, so dashes are short; it is mainly the
 * character that tells lines apart. */
static bool
is_dash_drawn_at_step(enum chart_line line, enum charset charset, int step)
{
	int on, off;
	chart_dash_lengths(line, &on, &off);
	if (charset == CHARSET_ASCII && on > 0) {
		on = (on + 1) / 2;
		off = on > 1 ? 1 : 0;
	}
	return step % (on + off) < on;
}

static void
draw_char_in_plot(struct layout *l, int column, int row, uint32_t code,
    enum series series, unsigned attribute)
{
	if (column < 0 || column >= l->width || row < 0 || row >= l->height)
		return;
	struct canvas_cell *cell =
	    canvas_cell_at(l->canvas, l->left + column, l->top + row);
	*cell = (struct canvas_cell){
	    code, (unsigned char)series, (unsigned char)attribute};
	l->dots[row * l->width + column] = 0;
}

/* Sets a dot.  All dots of a cell share the colour of the last one. */
static void
draw_dot_in_plot(struct layout *l, const struct chart_series *s, int x, int y)
{
	int across = canvas_dot_columns_per_cell(l->charset),
	    down = canvas_dot_rows_per_cell(l->charset);
	int column = x / across, row = y / down;
	if (x < 0 || column >= l->width || y < 0 || row >= l->height)
		return;
	unsigned char *dots = &l->dots[row * l->width + column];
	unsigned bit = 1u << (across * (y % down) + x % across);
	unsigned all = *dots | bit;
	uint32_t code = l->charset == CHARSET_ASCII
			    ? (uint32_t)s->ascii
			    : canvas_character_of_dots(l->charset, all);
	draw_char_in_plot(l, column, row, code, s->series, 0);
	*dots = (unsigned char)all;
}

/* Draws the line from point i to the next, dot by dot, if both have a value. */
static void
draw_line_segment(struct layout *l, const struct chart_series *s, size_t i)
{
	int across = canvas_dot_columns_per_cell(l->charset),
	    down = canvas_dot_rows_per_cell(l->charset);
	if (!isfinite(s->y[i]) || !isfinite(s->y[i + 1]))
		return;
	int x0 = column_of_chart_x(l, s->x[i], across);
	int y0 = row_of_chart_y(l, s->y[i], down);
	int dx = column_of_chart_x(l, s->x[i + 1], across) - x0;
	int dy = row_of_chart_y(l, s->y[i + 1], down) - y0;
	int n = abs(dx) > abs(dy) ? abs(dx) : abs(dy);
	for (int k = 0; k <= n; k++) {
		double t = n > 0 ? (double)k / n : 0;
		int step = dx < 0 ? x0 + dx + n - k : x0 + k;
		if (is_dash_drawn_at_step(s->line, l->charset, step))
			draw_dot_in_plot(l, s, x0 + (int)lround(t * dx),
			    y0 + (int)lround(t * dy));
	}
}

/* Draws a field with a shade for its value, and its label if there is room. */
static void
draw_cell_shaded_by_value(
    struct layout *l, const struct chart_series *s, size_t i)
{
	static const uint32_t SHADES[] = {' ', '.', ':', '#'},
			      BLOCKS[] = {' ', 0x2591, 0x2592, 0x2593};
	static const double FROM[] = {0, 0.5, 0.7, 0.9};
	double value = fabs(s->field[i].value);
	const char *label = s->field[i].label;
	size_t shade = 0;
	while (shade + 1 < ARRAY_LEN(FROM) && value >= FROM[shade + 1])
		shade++;
	int left = column_of_chart_x(l, s->x[i] - 0.5, 1);
	int right = column_of_chart_x(l, s->x[i] + 0.5, 1);
	int top = row_of_chart_y(l, s->y[i] + 0.5, 1);
	int foot = row_of_chart_y(l, s->y[i] - 0.5, 1);
	for (int row = top; row < foot || row == top; row++)
		for (int column = left; column < right; column++)
			draw_char_in_plot(l, column, row,
			    l->charset == CHARSET_ASCII ? SHADES[shade]
							: BLOCKS[shade],
			    s->series, 0);
	int room = right - left - 2, wide = text_width_in_columns(label);
	if (wide <= room)
		canvas_draw_text(l->canvas,
		    l->left + left + (right - left - wide) / 2,
		    l->top + (top + foot) / 2, label, s->series,
		    shade == 3 ? CELL_BOLD : 0);
}

/* Returns the column of point i, moved by the series' `beside`. */
static int
column_of_point(const struct layout *l, const struct chart_series *s, size_t i)
{
	int column = column_of_chart_x(l, s->x[i], 1) + s->beside;
	int last = l->width - 1;
	return column < 0 ? 0 : column > last ? last : column;
}

/* Draws a mark of half a cell's height, because in the few rows of a strip that
 * shows more. */
static void
draw_small_mark(struct layout *l, const struct chart_series *s, size_t i)
{
	int down = canvas_dot_rows_per_cell(l->charset), high = down / 2;
	int row = row_of_chart_y(l, s->y[i], down);
	int top = row % down - high / 2, x = 2 * column_of_point(l, s, i);
	top = top < 0 ? 0 : top > down - high ? down - high : top;
	for (int k = 0; k < 2 * high; k++)
		draw_dot_in_plot(
		    l, s, x + k % 2, row - row % down + top + k / 2);
}

static void
draw_chart_mark(struct layout *l, const struct chart_series *s, size_t i)
{
	bool fine = s->fine && l->charset != CHARSET_ASCII;
	if (!isfinite(s->y[i]))
		return;
	if (fine && l->chart->strip > 0)
		draw_small_mark(l, s, i);
	else
		draw_char_in_plot(l, column_of_point(l, s, i),
		    row_of_chart_y(l, s->y[i], 1), char_of_mark(s, l->charset),
		    s->series,
		    (s->line == CHART_MARKS && !fine ? CELL_BOLD : 0) |
			(s->lifted && !fine ? CELL_REVERSE : 0));
}

static bool
has_plot_cell_dots(const struct layout *l, int column, int row)
{
	return row >= 0 && row < l->height &&
	       l->dots[row * l->width + column] != 0;
}

/* Leaves a gap in a bar around its mark, which shows where the mark is even
 * without colours.  A bar that ends there anyway is not made shorter. */
static void
leave_gap_around_bar_marks(struct layout *l, const struct chart_series *s)
{
	for (size_t i = 0; i < s->n && s->lifted; i++)
		for (int by = -1; by <= 1 && isfinite(s->y[i]); by += 2) {
			int column = column_of_point(l, s, i);
			int row = row_of_chart_y(l, s->y[i], 1);
			if (has_plot_cell_dots(l, column, row) &&
			    has_plot_cell_dots(l, column, row + 2 * by))
				draw_char_in_plot(
				    l, column, row + by, ' ', SERIES_TEXT, 0);
		}
}

static bool
is_mark_hollow(const struct chart_series *s)
{
	const struct point_mark *mark =
	    s->fine ? point_mark_of_character(s->mark) : NULL;
	return mark != NULL && mark->hollow;
}

static void
draw_series_marks(struct layout *l, const struct chart_series *s)
{
	for (size_t i = 0; i < s->n && s->field != NULL; i++)
		draw_cell_shaded_by_value(l, s, i);
	for (size_t i = 0; i < s->n && s->mark != 0 && s->field == NULL; i++)
		draw_chart_mark(l, s, i);
}

/* Draws a bar from low to high at each point, one dot or one cell wide. */
static void
draw_chart_bars(struct layout *l, const struct chart_series *s)
{
	enum { DOTTED = 2 };
	int across = canvas_dot_columns_per_cell(l->charset),
	    down = canvas_dot_rows_per_cell(l->charset);
	int wide = s->line == CHART_LONG ? across : 1;
	int step = s->line == CHART_DOTTED ? DOTTED : 1;
	for (size_t i = 0; i < s->n; i++) {
		int column = column_of_point(l, s, i);
		int foot = row_of_chart_y(l, s->low[i], down);
		int top = row_of_chart_y(l, s->high[i], down);
		for (int y = top; y <= foot; y += step)
			for (int x = 0; x < wide; x++)
				draw_dot_in_plot(l, s, column * across + x, y);
	}
}

/* Returns the value in the middle of part i of n along an axis. */
static double
value_of_axis_part(const struct axis *a, int i, int n)
{
	double t = (i + 0.5) / n;
	return a->log ? a->low * pow(a->high / a->low, t)
		      : a->low + t * (a->high - a->low);
}

/* Shades the rows of a column that the band fills completely. */
static void
shade_band_in_plot_column(
    struct layout *l, int column, double low, double high, enum series tint)
{
	double top =
	    l->height * (1 - axis_relative_position(&l->chart->y, high));
	double foot =
	    l->height * (1 - axis_relative_position(&l->chart->y, low));
	uint32_t shade = l->charset == CHARSET_ASCII ? ',' : 0x2591;
	for (int row = (int)ceil(top); row + 1 <= foot; row++)
		draw_char_in_plot(l, column, row, shade, tint, CELL_DIM);
}

/* Stipples a band at dot x: in every second column, sets the dots at its edges
 * and every fourth dot between them. */
static void
stipple_band_column(
    struct layout *l, int x, double low, double high, enum series tint)
{
	enum { EVERY = 2, APART = 4 };
	const struct chart_series look = {.series = tint};
	int down = canvas_dot_rows_per_cell(CHARSET_BRAILLE),
	    top = row_of_chart_y(l, high, down),
	    foot = row_of_chart_y(l, low, down);
	for (int y = top; y <= foot && x % EVERY == 0; y++)
		if (y == top || y == foot || (y + x) % APART == 0)
			draw_dot_in_plot(l, &look, x, y);
}

/* Makes the bands drawn so far faint.  Lines then have their cells to
 * themselves. */
static void
make_bands_faint(struct layout *l)
{
	for (int i = 0; i < l->width * l->height; i++)
		if (l->dots[i] != 0)
			canvas_cell_at(l->canvas, l->left + i % l->width,
			    l->top + i / l->width)
			    ->attribute = CELL_DIM;
	memset(l->dots, 0, (size_t)(l->width * l->height));
}

static void
draw_chart_band(struct layout *l, const struct chart_series *s)
{
	int across = canvas_dot_columns_per_cell(l->charset),
	    parts = l->width * across;
	for (int i = 0; i < parts && s->low != NULL; i++) {
		double x = value_of_axis_part(&l->chart->x, i, parts);
		double low = chart_interpolate_at_x(l->chart, s, s->low, x);
		double high = chart_interpolate_at_x(l->chart, s, s->high, x);
		if (isnan(low) || isnan(high))
			continue;
		if (l->charset == CHARSET_BRAILLE)
			stipple_band_column(l, i, low, high, s->series);
		else if (i % across == 0)
			shade_band_in_plot_column(
			    l, i / across, low, high, s->series);
	}
}

/* Draws the guides faintly, and only if the plot is tall enough not to be
 * crowded by them.  In a strip they are sparse: its marks stand on them and
 * move. */
static void
draw_chart_guides(struct layout *l)
{
	enum { TALL = 12, EVERY = 4, SELDOM = 12 };
	bool braille = l->charset == CHARSET_BRAILLE;
	bool strip = l->chart->strip > 0;
	int every = strip ? SELDOM : EVERY;
	for (size_t i = 0; i < l->chart->y.n && (strip || l->height >= TALL);
	     i++) {
		const struct axis_tick *t = &l->chart->y.tick[i];
		int dot = row_of_chart_y(l, t->at, 4) % 4;
		uint32_t code = braille ? canvas_character_of_dots(
					      CHARSET_BRAILLE, 1U << (2 * dot))
				: l->charset == CHARSET_ASCII ? '-'
							      : 0x00B7;
		for (int column = every / 2; column < l->width && t->guide;
		     column += every)
			draw_char_in_plot(l, column,
			    row_of_chart_y(l, t->at, 1), code, SERIES_TEXT,
			    CELL_DIM);
	}
}

/* Draws the rules.  A break size moves with the slider: in every second row of
 * a tall plot it is seen as well, and half as much has to be written to the
 * terminal. */
static void
draw_chart_vertical_rules(struct layout *l)
{
	enum { TALL = 12 };
	for (size_t i = 0; i < l->chart->n_rule; i++) {
		const struct chart_rule *r = &l->chart->rule[i];
		int column = column_of_chart_x(l, r->x, 1);
		bool thin = r->series != SERIES_CROSSHAIR;
		for (int row = 0; row < l->height;
		     row += thin && l->height >= TALL ? 2 : 1)
			draw_char_in_plot(l, column, row,
			    char_of_vertical_rule(r->series, l->charset),
			    r->series, 0);
	}
}

/* Returns true if cells of a row, and one on either side, are among the data
 * and still blank. */
static bool
are_plot_cells_blank(struct layout *l, int column, int row, int wide)
{
	for (int c = column - 1; c <= column + wide; c++)
		if (c < 0 || c >= l->width ||
		    canvas_cell_at(l->canvas, l->left + c, l->top + row)
			    ->code != ' ')
			return false;
	return true;
}

/* Draws the label of a point to the right of its mark, or to the left, or not
 * at all. */
static void
draw_chart_point_name(struct layout *l, const struct chart_series *s, size_t i)
{
	const char *label = s->whose[i].label;
	if (label == NULL || !isfinite(s->y[i]))
		return;
	int wide = text_width_in_columns(label), at = column_of_point(l, s, i);
	int row = row_of_chart_y(l, s->y[i], 1);
	int from[] = {at + 2, at - 1 - wide};
	for (size_t k = 0; k < ARRAY_LEN(from); k++)
		if (are_plot_cells_blank(l, from[k], row, wide)) {
			canvas_draw_text(l->canvas, l->left + from[k],
			    l->top + row, label, s->series, 0);
			return;
		}
}

static void
draw_chart_data(struct layout *l)
{
	const struct chart *c = l->chart;
	for (size_t i = 0; i < c->n; i++)
		if (!c->series[i]->bars)
			draw_chart_band(l, c->series[i]);
	make_bands_faint(l);
	draw_chart_guides(l);
	draw_chart_vertical_rules(l);
	for (size_t i = 0; i < c->n; i++)
		if (c->series[i]->bars)
			draw_chart_bars(l, c->series[i]);
		else
			for (size_t k = 0; k + 1 < c->series[i]->n; k++)
				draw_line_segment(l, c->series[i], k);
	for (size_t i = 0; i < c->n; i++)
		leave_gap_around_bar_marks(l, c->series[i]);
	/* If two marks share a cell, a hollow one is seen. */
	for (int hollow = 0; hollow <= 1; hollow++)
		for (size_t i = 0; i < c->n; i++)
			if (is_mark_hollow(c->series[i]) == hollow)
				draw_series_marks(l, c->series[i]);
	for (size_t i = 0; i < c->n; i++)
		for (size_t j = 0; j < c->series[i]->n && c->series[i]->named;
		     j++)
			draw_chart_point_name(l, c->series[i], j);
}

/* Finds the mark nearest to a cell of the data, among those in it and next to
 * it. */
static void
find_nearest_mark(
    const struct layout *l, int column, int row, struct chart_found *f)
{
	int best = 4; /* more than of any neighbour */
	for (size_t s = 0; s < l->chart->n; s++) {
		const struct chart_series *of = l->chart->series[s];
		bool marks = of->mark != 0 || of->line == CHART_MARKS;
		for (size_t i = 0; marks && i < of->n; i++) {
			if (!isfinite(of->x[i]) || !isfinite(of->y[i]))
				continue;
			int dx =
				abs(column_of_chart_x(l, of->x[i], 1) - column),
			    dy = abs(row_of_chart_y(l, of->y[i], 1) - row);
			if (dx > 1 || dy > 1 || dx + 2 * dy >= best)
				continue;
			best = dx + 2 * dy;
			f->series = of;
			f->point = i;
		}
	}
}

/* Finds the line in a row at f->x, of several the one on top. */
static void
find_chart_line_at_cell(const struct layout *l, int row, struct chart_found *f)
{
	for (size_t s = l->chart->n; s-- > 0 && f->series == NULL;) {
		const struct chart_series *of = l->chart->series[s];
		double y = chart_series_y_at_x(l->chart, of, f->x);
		if (of->line == CHART_MARKS || isnan(y) ||
		    abs(row_of_chart_y(l, y, 1) - row) > 1)
			continue;
		f->series = of;
		const struct axis *a = &l->chart->x;
		double at = axis_relative_position(a, f->x), least = INFINITY;
		for (size_t i = 0; i < of->n; i++) {
			double far =
			    fabs(axis_relative_position(a, of->x[i]) - at);
			if (far < least) {
				least = far;
				f->point = i;
			}
		}
	}
}

static bool
find_data_at_plot_cell(
    const struct layout *l, int column, int row, struct chart_found *f)
{
	*f = (struct chart_found){.chart = l->chart};
	column -= l->left;
	row -= l->top;
	if (column < 0 || column >= l->width || row < 0 || row >= l->height)
		return false;
	f->x = value_of_axis_part(&l->chart->x, column, l->width);
	f->y = value_of_axis_part(&l->chart->y, l->height - 1 - row, l->height);
	find_nearest_mark(l, column, row, f);
	find_chart_line_at_cell(l, row, f);
	return true;
}

static int
count_stacked_charts(const struct chart *chart)
{
	int n = 0;
	for (const struct chart *c = chart; c != NULL; c = c->below)
		n++;
	return n;
}

/* Returns the rows of a chart, where n charts, this one and those below it,
 * share what is left.  A strip has the rows it asks for, or none if its chart
 * would become too low. */
static int
count_rows_of_chart(const struct chart *chart, int left, int n)
{
	enum { LEAST = 8 };
	const struct chart *below = chart->below;
	bool strip = below != NULL && below->strip > 0;
	if (strip && left - below->strip >= LEAST)
		return left - below->strip;
	int own = strip ? left : left / n;
	return own > 0 ? own : 1;
}

bool
chart_find_data_at_cell(const struct chart *chart, int columns, int rows,
    enum charset charset, unsigned words, int column, int row,
    struct chart_found *found)
{
	int n = count_stacked_charts(chart), top = 0;
	int left = y_label_columns(chart, columns, words);
	for (const struct chart *c = chart; c != NULL && top < rows;
	     c = c->below) {
		struct canvas own = {.columns = columns,
		    .rows = count_rows_of_chart(c, rows - top, n--)};
		struct layout l = lay_out_chart(c, &own, left, charset, words);
		if (row < top + own.rows)
			return find_data_at_plot_cell(
			    &l, column, row - top, found);
		top += own.rows;
	}
	return false;
}

struct canvas *
chart_draw(const struct chart *chart, int columns, int rows,
    enum charset charset, unsigned words)
{
	struct canvas *all = canvas_new(columns, rows);
	int n = count_stacked_charts(chart), top = 0,
	    left = y_label_columns(chart, columns, words);
	all->theme = chart->theme;
	/* If there is no room for all charts, the first ones are drawn. */
	for (const struct chart *c = chart; c != NULL && top < rows;
	     c = c->below) {
		struct canvas own = {.columns = columns,
		    .rows = count_rows_of_chart(c, rows - top, n--),
		    .cell = all->cell + top * columns};
		struct layout l = lay_out_chart(c, &own, left, charset, words);
		draw_chart_titles_and_axes(&l);
		l.dots = xcalloc((size_t)(l.width * l.height), 1);
		draw_chart_data(&l);
		free(l.dots);
		top += own.rows;
	}
	return all;
}
