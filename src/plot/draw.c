/* Lays a chart's parts out on a canvas and draws them: what stands around the
 * data, then bands, guides, rules, lines and marks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/draw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

/* The data's cells begin at left, top and are width x height.  Each other part
 * has its first row, -1 where it was dropped.  words: of CHART_ALL. */
struct layout {
	const struct chart *chart;
	struct canvas *canvas;
	enum charset charset;
	unsigned words;
	int left, top, width, height;
	int title, y_title, axis, labels, label_rows, legend, foot;
};

/* Column of an x and row of a y among the data, in parts of a cell: 1 for
 * cells, 2 or 4 for dots.  Always within. */
static int
layout_column(const struct layout *l, double x, int parts)
{
	double t = axis_share(&l->chart->x, x);
	return (int)lround(t * (l->width * parts - 1));
}

static int
layout_row(const struct layout *l, double y, int parts)
{
	double t = axis_share(&l->chart->y, y);
	return (int)lround((1 - t) * (l->height * parts - 1));
}

/* The character of a rule across the plot. */
static uint32_t
rule_code(enum series series, enum charset charset)
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
			    (struct canvas_cell){rule_code(series, l->charset),
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

static struct layout
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

/* Titles, axes, labels, legend and foot: all but the data. */
static void
draw_around(struct layout *l)
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

/* The data's part of a canvas.  dots [width * height]: those set so far. */
struct brush {
	struct layout at;
	unsigned char *dots;
};

/* Dots of a cell, across and down. */
static int
dots_across(enum charset charset)
{
	return charset == CHARSET_ASCII ? 1 : 2;
}

static int
dots_down(enum charset charset)
{
	return charset == CHARSET_ASCII       ? 1
	       : charset == CHARSET_QUADRANTS ? 2
					      : 4;
}

/* The character of a cell whose dots are set; bit 2 * row + column. */
static uint32_t
dots_code(enum charset charset, unsigned dots)
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
	return 0x2800 + code;
}

/* Whether a line is drawn at this step of its path.  In ASCII a cell is a step,
 * and the character tells most. */
static bool
is_inked(enum chart_line line, enum charset charset, int step)
{
	int on, off;
	chart_dash(line, &on, &off);
	if (charset == CHARSET_ASCII && on > 0) {
		on = (on + 1) / 2;
		off = on > 1 ? 1 : 0;
	}
	return step % (on + off) < on;
}

static void
put(struct brush *p, int column, int row, uint32_t code, enum series series,
    unsigned attribute)
{
	if (column < 0 || column >= p->at.width || row < 0 ||
	    row >= p->at.height)
		return;
	struct canvas_cell *cell =
	    canvas_at(p->at.canvas, p->at.left + column, p->at.top + row);
	attribute |= cell->attribute & CELL_SHADE;
	*cell = (struct canvas_cell){
	    code, (unsigned char)series, (unsigned char)attribute};
	p->dots[row * p->at.width + column] = 0;
}

static void
put_dot(struct brush *p, const struct chart_series *s, int x, int y)
{
	int across = dots_across(p->at.charset),
	    down = dots_down(p->at.charset);
	int column = x / across, row = y / down;
	if (p->at.charset == CHARSET_ASCII) {
		put(p, column, row, (uint32_t)s->ascii, s->series, 0);
		return;
	}
	unsigned char *dots = &p->dots[row * p->at.width + column];
	unsigned all = *dots | 1u << (across * (y % down) + x % across);
	put(p, column, row, dots_code(p->at.charset, all), s->series, 0);
	*dots = (unsigned char)all;
}

/* From point i to the next, dot by dot. */
static void
draw_segment(struct brush *p, const struct chart_series *s, size_t i)
{
	int across = dots_across(p->at.charset),
	    down = dots_down(p->at.charset);
	int x0 = layout_column(&p->at, s->x[i], across);
	int y0 = layout_row(&p->at, s->y[i], down);
	int dx = layout_column(&p->at, s->x[i + 1], across) - x0;
	int dy = layout_row(&p->at, s->y[i + 1], down) - y0;
	int n = abs(dx) > abs(dy) ? abs(dx) : abs(dy);
	for (int k = 0; k <= n; k++) {
		double t = n > 0 ? (double)k / n : 0;
		int step = dx < 0 ? x0 + dx + n - k : x0 + k;
		if (is_inked(s->line, p->at.charset, step))
			put_dot(p, s, x0 + (int)lround(t * dx),
			    y0 + (int)lround(t * dy));
	}
}

static void
draw_line(struct brush *p, const struct chart_series *s)
{
	for (size_t i = 0; i + 1 < s->n; i++)
		if (isfinite(s->y[i]) && isfinite(s->y[i + 1]))
			draw_segment(p, s, i);
}

/* The shade of a field by its value, and the label where it has room. */
static void
draw_field(struct brush *p, const struct chart_series *s, size_t i)
{
	static const uint32_t SHADES[] = {' ', '.', ':', '#'},
			      BLOCKS[] = {' ', 0x2591, 0x2592, 0x2593};
	static const double FROM[] = {0, 0.5, 0.7, 0.9};
	double value = fabs(s->field[i].value);
	const char *label = s->field[i].label;
	size_t shade = 0;
	while (shade + 1 < ARRAY_LEN(FROM) && value >= FROM[shade + 1])
		shade++;
	int left = layout_column(&p->at, s->x[i] - 0.5, 1);
	int right = layout_column(&p->at, s->x[i] + 0.5, 1);
	int top = layout_row(&p->at, s->y[i] + 0.5, 1);
	int foot = layout_row(&p->at, s->y[i] - 0.5, 1);
	for (int row = top; row < foot || row == top; row++)
		for (int column = left; column < right; column++)
			put(p, column, row,
			    p->at.charset == CHARSET_ASCII ? SHADES[shade]
							   : BLOCKS[shade],
			    s->series, 0);
	int room = right - left - 2, wide = text_width(label);
	if (wide <= room)
		canvas_text(p->at.canvas,
		    p->at.left + left + (right - left - wide) / 2,
		    p->at.top + (top + foot) / 2, label, s->series,
		    shade == 3 ? CELL_BOLD : 0);
}

static void
draw_marks(struct brush *p, const struct chart_series *s)
{
	for (size_t i = 0; i < s->n && s->field != NULL; i++)
		draw_field(p, s, i);
	for (size_t i = 0; i < s->n && s->mark != 0 && s->field == NULL; i++)
		if (isfinite(s->y[i]))
			put(p, layout_column(&p->at, s->x[i], 1),
			    layout_row(&p->at, s->y[i], 1), (uint32_t)s->mark,
			    s->series, s->line == CHART_MARKS ? CELL_BOLD : 0);
}

/* y of the band's edge at x, straight between the points. */
static double
edge_at(struct brush *p, const struct chart_series *s, double *edge, double x)
{
	struct chart_series copy = *s;
	copy.y = edge;
	return chart_at(p->at.chart, &copy, x);
}

static double
x_at(const struct brush *p, int column)
{
	const struct axis *a = &p->at.chart->x;
	double t = p->at.width > 1 ? (double)column / (p->at.width - 1) : 0;
	return a->log ? a->low * pow(a->high / a->low, t)
		      : a->low + t * (a->high - a->low);
}

/* Behind the lines, where the depth of colour has a ground for it.  Elsewhere a
 * cell is shaded by a character where the band fills half of its height: of one
 * thinner than that there would be strays only, where it goes from row to row.
 */
static void
draw_band(struct brush *p, const struct chart_series *s)
{
	enum { PARTS = 8 };
	uint32_t shade =
	    p->at.charset == CHARSET_ASCII ? ',' : CANVAS_SHADE_CODE;
	for (int column = 0; column < p->at.width && s->low != NULL; column++) {
		double x = x_at(p, column);
		double low = edge_at(p, s, s->low, x);
		double high = edge_at(p, s, s->high, x);
		if (isnan(low) || isnan(high))
			continue;
		int top = layout_row(&p->at, high, PARTS);
		int foot = layout_row(&p->at, low, PARTS);
		for (int row = top / PARTS; row <= foot / PARTS; row++) {
			int from = row * PARTS, to = from + PARTS - 1;
			int filled = (foot < to ? foot : to) -
				     (top > from ? top : from) + 1;
			bool half = 2 * filled >= PARTS;
			bool middle = row == (top + foot) / 2 / PARTS;
			if (middle || 4 * filled >= PARTS)
				put(p, column, row, half ? shade : ' ',
				    SERIES_BAND, CELL_DIM | CELL_SHADE);
		}
	}
}

/* Faint, and only where the plot is tall enough for them not to crowd it. */
static void
draw_guides(struct brush *p)
{
	enum { TALL = 12, EVERY = 4 };
	uint32_t code = p->at.charset == CHARSET_ASCII ? '-' : 0x00B7;
	for (size_t i = 0; i < p->at.chart->y.n && p->at.height >= TALL; i++) {
		const struct axis_tick *t = &p->at.chart->y.tick[i];
		for (int column = EVERY / 2; column < p->at.width && t->guide;
		     column += EVERY)
			put(p, column, layout_row(&p->at, t->at, 1), code,
			    SERIES_TEXT, CELL_DIM);
	}
}

/* A break size moves with the slider: in every second row of a tall plot it is
 * seen as well, and half as much is written. */
static void
draw_rules(struct brush *p)
{
	enum { TALL = 12 };
	for (size_t i = 0; i < p->at.chart->n_rule; i++) {
		const struct chart_rule *r = &p->at.chart->rule[i];
		int column = layout_column(&p->at, r->x, 1);
		bool thin = r->series != SERIES_CROSSHAIR;
		for (int row = 0; row < p->at.height;
		     row += thin && p->at.height >= TALL ? 2 : 1)
			put(p, column, row, rule_code(r->series, p->at.charset),
			    r->series, 0);
	}
}

static void
draw_data(struct brush *p)
{
	const struct chart *c = p->at.chart;
	for (size_t i = 0; i < c->n; i++)
		draw_band(p, &c->series[i]);
	draw_guides(p);
	draw_rules(p);
	for (size_t i = 0; i < c->n; i++)
		draw_line(p, &c->series[i]);
	for (size_t i = 0; i < c->n; i++)
		draw_marks(p, &c->series[i]);
}

struct canvas *
chart_draw(const struct chart *chart, int columns, int rows,
    enum charset charset, unsigned words)
{
	struct canvas *canvas = canvas_new(columns, rows);
	struct brush p = {.at = layout_make(chart, canvas, charset, words)};
	p.dots = xcalloc((size_t)(p.at.width * p.at.height), 1);
	draw_around(&p.at);
	draw_data(&p);
	free(p.dots);
	return canvas;
}
