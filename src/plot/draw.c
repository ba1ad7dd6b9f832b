/* Draws a chart's data on a canvas: bands, guides, rules, lines, marks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "plot/layout.h"

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

static void
draw_marks(struct brush *p, const struct chart_series *s)
{
	for (size_t i = 0; i < s->n && s->mark != 0; i++)
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
			put(p, column, row,
			    layout_rule_code(r->series, p->at.charset),
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
	layout_draw_around(&p.at);
	draw_data(&p);
	free(p.dots);
	return canvas;
}
