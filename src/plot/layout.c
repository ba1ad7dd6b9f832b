/* Lays a chart's parts out on a canvas and draws what stands around the data.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/layout.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

uint32_t
layout_rule_code(enum series series, enum charset charset)
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

/* One entry of the legend, "-v- measured 69"; the caller frees. */
static char *
legend_text(const struct chart_series *series, enum charset charset)
{
	static const char *const LINES[] = {[CHART_MARKS] = "",
	    [CHART_SOLID] = "\u2500",
	    [CHART_DASHED] = "\u254C",
	    [CHART_LONG] = "\u2501",
	    [CHART_DOTTED] = "\u2508"};
	char ascii[2] = {series->ascii, '\0'};
	char mark[2] = {series->mark, '\0'};
	const char *line = series->line == CHART_MARKS ? ""
			   : charset == CHARSET_ASCII  ? ascii
						       : LINES[series->line];
	return xasprintf("%s%s%s %s", line, mark[0] != '\0' ? mark : line, line,
	    series->name);
}

/* Series, then rules, side by side in rows as wide as the canvas; from row on,
 * or only counted where row is negative.  Returns the rows they take. */
static int
flow_legend(struct layout *l, int row)
{
	enum { GAP = 3 };
	const struct chart *c = l->chart;
	int column = 0, rows = 0;
	for (size_t i = 0; i < c->n + c->n_rule; i++) {
		const struct chart_rule *rule =
		    i < c->n ? NULL : &c->rule[i - c->n];
		enum series series =
		    rule != NULL ? rule->series : c->series[i].series;
		char *text = rule != NULL
				 ? xasprintf("  %s", rule->name)
				 : legend_text(&c->series[i], l->charset);
		int wide = text_width(text);
		if (rows == 0 || column + wide > l->canvas->columns) {
			column = 0;
			rows++;
		}
		if (row >= 0)
			canvas_text(
			    l->canvas, column, row + rows - 1, text, series, 0);
		if (row >= 0 && rule != NULL && column < l->canvas->columns)
			*canvas_at(l->canvas, column, row + rows - 1) =
			    (struct canvas_cell){
				layout_rule_code(series, l->charset),
				(unsigned char)series, 0};
		column += wide + GAP;
		free(text);
	}
	return rows;
}

/* Text in lines as wide as the canvas, from row on; only counted where row is
 * negative.  Returns how many. */
static int
flow_text(struct layout *l, int row, const char *text, unsigned attribute)
{
	char *wrapped = text_wrapped(text, l->canvas->columns), *save = NULL;
	int rows = 0;
	for (char *line = strtok_r(wrapped, "\n", &save); line != NULL;
	     line = strtok_r(NULL, "\n", &save), rows++)
		if (row >= 0)
			canvas_text(l->canvas, 0, row + rows, line, SERIES_TEXT,
			    attribute);
	free(wrapped);
	return rows;
}

static int
flow_notes(struct layout *l, int row)
{
	int rows = l->words & CHART_LEGEND ? flow_legend(l, row) : 0;
	size_t n = l->words & CHART_NOTES ? l->chart->n_note : 0;
	for (size_t i = 0; i < n; i++)
		rows += flow_text(
		    l, row < 0 ? row : row + rows, l->chart->note[i], 0);
	return rows;
}

/* Where the data are from. */
static int
flow_foot(struct layout *l, int row)
{
	char *text = xasprintf("data: %s", l->chart->about);
	int rows = flow_text(l, row, text, CELL_DIM);
	free(text);
	return rows;
}

/* Columns for the labels of the y axis and its line; none on a canvas that is
 * hardly wider. */
static int
gutter(const struct chart *chart, int columns)
{
	enum { NARROW = 3 };
	int wide = 0;
	for (size_t i = 0; i < chart->y.n; i++) {
		int label = text_width(chart->y.tick[i].label);
		wide = label > wide ? label : wide;
	}
	return columns >= NARROW * (wide + 1) ? wide + 1 : 0;
}

/* Rows that the labels of the x axis want, 1 or 2. */
static int
label_rows(const struct layout *l)
{
	const struct axis *a = &l->chart->x;
	int *column = xcalloc(a->n, sizeof *column);
	int *row = xcalloc(a->n, sizeof *row);
	int rows = axis_place(a, l->width, 2, column, row);
	free(column);
	free(row);
	return rows;
}

struct layout
layout_make(const struct chart *chart, struct canvas *canvas,
    enum charset charset, unsigned words)
{
	enum { Y_TITLE, LEGEND, SECOND, FOOT, TITLE, LABELS, AXIS, PARTS };
	enum { LEAST = 3, PLENTY = 6 };
	struct layout l = {.chart = chart,
	    .canvas = canvas,
	    .charset = charset,
	    .words = words};
	l.left = gutter(chart, canvas->columns);
	l.width = canvas->columns - l.left;
	int rows[PARTS] = {[Y_TITLE] = 1,
	    [LEGEND] = flow_notes(&l, -1),
	    [SECOND] = label_rows(&l) - 1,
	    [FOOT] = words & CHART_LEGEND ? flow_foot(&l, -1) : 0,
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
	l.label_rows = rows[LABELS] + rows[SECOND];
	l.labels = rows[LABELS] > 0 ? at : -1;
	at += l.label_rows;
	l.legend = rows[LEGEND] > 0 ? at : -1;
	l.foot = rows[FOOT] > 0 ? at + rows[LEGEND] : -1;
	return l;
}

static void
put_code(struct layout *l, int column, int row, uint32_t code)
{
	if (column >= 0)
		*canvas_at(l->canvas, column, row) =
		    (struct canvas_cell){code, SERIES_TEXT, 0};
}

/* The line left of the plot, with ticks; labels that would touch are left
 * out, those of low rank first. */
static void
draw_y_axis(struct layout *l)
{
	enum { RANKS = 3 };
	const struct axis *a = &l->chart->y;
	bool ascii = l->charset == CHARSET_ASCII;
	char *taken = xcalloc((size_t)l->height, 1);
	for (int row = 0; row < l->height; row++)
		put_code(l, l->left - 1, l->top + row, ascii ? '|' : 0x2502);
	for (int rank = 0; rank < RANKS; rank++)
		for (size_t i = 0; i < a->n; i++) {
			const struct axis_tick *t = &a->tick[i];
			int row = layout_row(l, t->at, 1);
			put_code(
			    l, l->left - 1, l->top + row, ascii ? '+' : 0x2524);
			if (t->rank != rank || taken[row])
				continue;
			taken[row] = 1;
			canvas_text(l->canvas,
			    l->left - 1 - text_width(t->label), l->top + row,
			    t->label, SERIES_TEXT, 0);
		}
	free(taken);
}

static void
draw_x_axis(struct layout *l)
{
	const struct axis *a = &l->chart->x;
	bool ascii = l->charset == CHARSET_ASCII;
	if (l->axis < 0)
		return;
	put_code(l, l->left - 1, l->axis, ascii ? '+' : 0x2514);
	for (int column = 0; column < l->width; column++)
		put_code(l, l->left + column, l->axis, ascii ? '-' : 0x2500);
	for (size_t i = 0; i < a->n; i++)
		put_code(l, l->left + layout_column(l, a->tick[i].at, 1),
		    l->axis, ascii ? '+' : 0x252C);
}

static void
draw_labels(struct layout *l)
{
	const struct axis *a = &l->chart->x;
	int *column = xcalloc(a->n, sizeof *column);
	int *row = xcalloc(a->n, sizeof *row);
	if (l->labels >= 0)
		axis_place(a, l->width, l->label_rows, column, row);
	for (size_t i = 0; i < a->n && l->labels >= 0; i++)
		if (row[i] != AXIS_DROPPED)
			canvas_text(l->canvas, l->left + column[i],
			    l->labels + row[i], a->tick[i].label, SERIES_TEXT,
			    0);
	free(column);
	free(row);
}

/* "Tierp, Granite, 11.2 mm: product", where that is too wide "Tierp: product",
 * or "product". */
static char *
short_title(const char *title, int columns)
{
	const char *rest = strstr(title, ": ");
	if (text_width(title) <= columns || rest == NULL)
		return xstrdup(title);
	char *named =
	    xasprintf("%.*s%s", (int)strcspn(title, ",:"), title, rest);
	if (text_width(named) <= columns)
		return named;
	free(named);
	return xstrdup(rest + 2);
}

static void
draw_titles(struct layout *l)
{
	const struct chart *c = l->chart;
	int columns = l->canvas->columns;
	char *axes = xasprintf("%s  against  %s", c->y.title, c->x.title);
	char *title = short_title(c->title, columns);
	if (l->title >= 0)
		canvas_text(
		    l->canvas, 0, l->title, title, SERIES_TEXT, CELL_BOLD);
	if (l->y_title >= 0)
		canvas_text(l->canvas, 0, l->y_title,
		    text_width(axes) <= columns ? axes : c->y.title,
		    SERIES_TEXT, 0);
	free(title);
	free(axes);
}

void
layout_draw_around(struct layout *l)
{
	draw_titles(l);
	if (l->left > 0)
		draw_y_axis(l);
	draw_x_axis(l);
	draw_labels(l);
	if (l->legend >= 0)
		flow_notes(l, l->legend);
	if (l->foot >= 0)
		flow_foot(l, l->foot);
}

int
layout_column(const struct layout *l, double x, int parts)
{
	double t = axis_share(&l->chart->x, x);
	return (int)lround(t * (l->width * parts - 1));
}

int
layout_row(const struct layout *l, double y, int parts)
{
	double t = axis_share(&l->chart->y, y);
	return (int)lround((1 - t) * (l->height * parts - 1));
}
