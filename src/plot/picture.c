/* Lays a chart out on a page and draws it with any pen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/picture.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "config.h"
#include "plot/pen.h"

/* The page, in points: two columns of a journal wide. */
enum {
	LEFT = 64,
	TOP = 34,
	WIDTH = 336,
	LEAST_HEIGHT = 240,
	LEGEND = LEFT + WIDTH + 18,
	SAMPLE = 26,
	RIGHT = 192,
	PAGE = LEFT + WIDTH + RIGHT,
	BELOW = 52, /* labels and title of the x axis */
	ROW = 13,
	FOOT_ROW = 11,
	FOOT_COLUMNS = 112
};

struct page {
	const struct chart *chart;
	struct pen *pen;
	double height; /* of the plot */
};

bool
picture_form_of(const char *path, enum picture_form *form)
{
	static const char *const ENDS[] = {[PICTURE_SVG] = ".svg",
	    [PICTURE_PNG] = ".png",
	    [PICTURE_PDF] = ".pdf"};
	for (size_t i = 0; i < ARRAY_LEN(ENDS); i++) {
		*form = (enum picture_form)i;
		if (text_ends(path, ENDS[i]))
			return true;
	}
	return false;
}

/* White; the inks are safe for red-green blindness. */
static const struct pen_paper WHITE = {.colour = 0xFFFFFF,
    .ink = {[SERIES_TEXT] = 0x000000,
	[SERIES_FEED] = 0xE69F00,
	[SERIES_MEASURED_1] = 0x0072B2,
	[SERIES_MEASURED_2] = 0x009E73,
	[SERIES_MEASURED_3] = 0x56B4E9,
	[SERIES_PREDICTED] = 0xD55E00,
	[SERIES_OTHER] = 0xCC79A7,
	[SERIES_BAND] = 0xD55E00,
	[SERIES_BREAK] = 0x555555,
	[SERIES_CROSSHAIR] = 0x000000}};

bool
picture_can(enum picture_form form)
{
	return HAVE_CAIRO || form == PICTURE_SVG;
}

const char *
picture_forms(void)
{
	return HAVE_CAIRO ? "svg, png, pdf" : "svg (built without cairo)";
}

struct pen *
pen_open(enum picture_form form, double width, double height,
    const struct pen_paper *paper, const char *title, const char *about,
    FILE *out)
{
#if HAVE_CAIRO
	if (form != PICTURE_SVG)
		return pen_cairo(width, height, paper, title, about,
		    form == PICTURE_PDF, out);
#endif
	assert(form == PICTURE_SVG);
	return pen_svg(width, height, paper, title, about, out);
}

static double
page_x(const struct page *p, double x)
{
	return LEFT + WIDTH * axis_share(&p->chart->x, x);
}

static double
page_y(const struct page *p, double y)
{
	return TOP + p->height * (1 - axis_share(&p->chart->y, y));
}

static void
draw_rule(struct page *p, double x0, double y0, double x1, double y1,
    struct pen_stroke stroke)
{
	double x[2] = {x0, x1}, y[2] = {y0, y1};
	p->pen->path(p->pen, x, y, 2, &stroke);
}

static const struct pen_stroke THIN = {SERIES_TEXT, CHART_SOLID, 0.6, PEN_OPEN};
static const struct pen_stroke GUIDE = {
    SERIES_BREAK, CHART_DOTTED, 0.3, PEN_OPEN};

static void
draw_x_axis(struct page *p)
{
	enum { COLUMN = 5, LABEL = 8, ROWS = 2 };
	static const double DIGIT = 5.1; /* its width; a column rounds it */
	const struct axis *a = &p->chart->x;
	double foot = TOP + p->height;
	int *column = xcalloc(a->n, sizeof *column);
	int *row = xcalloc(a->n, sizeof *row);
	double end[ROWS] = {0};
	axis_place(a, WIDTH / COLUMN, ROWS, column, row);
	for (size_t i = 0; i < a->n; i++) {
		double x = page_x(p, a->tick[i].at);
		double half = DIGIT * (double)strlen(a->tick[i].label) / 2;
		draw_rule(p, x, foot, x, foot + 4, THIN);
		if (row[i] == AXIS_DROPPED || x - half < end[row[i]] + 1)
			continue;
		end[row[i]] = x + half;
		p->pen->text(p->pen, x, foot + 4 + (LABEL + 2) * (row[i] + 1),
		    a->tick[i].label,
		    &(struct pen_style){.size = LABEL, .anchor = PEN_MIDDLE});
	}
	p->pen->text(p->pen, LEFT + WIDTH / 2.0, foot + 4 + 4 * (LABEL + 2),
	    a->title, &(struct pen_style){.size = 10, .anchor = PEN_MIDDLE});
	free(column);
	free(row);
}

/* A label at y is not to touch one of those placed. */
static bool
is_free(const double *placed, size_t n, double y)
{
	for (size_t i = 0; i < n; i++)
		if (fabs(placed[i] - y) < 10)
			return false;
	return true;
}

static void
draw_y_axis(struct page *p)
{
	enum { RANKS = 3, LABEL = 8 };
	const struct axis *a = &p->chart->y;
	double *placed = xdoubles(a->n);
	size_t n = 0;
	for (int rank = 0; rank < RANKS; rank++)
		for (size_t i = 0; i < a->n; i++) {
			const struct axis_tick *t = &a->tick[i];
			double y = page_y(p, t->at);
			if (t->rank != rank)
				continue;
			draw_rule(p, LEFT - 4, y, LEFT, y, THIN);
			if (t->guide)
				draw_rule(p, LEFT, y, LEFT + WIDTH, y, GUIDE);
			if (!is_free(placed, n, y))
				continue;
			placed[n++] = y;
			p->pen->text(p->pen, LEFT - 6, y + 3, t->label,
			    &(struct pen_style){
				.size = LABEL, .anchor = PEN_END});
		}
	p->pen->text(p->pen, 18, TOP + p->height / 2, a->title,
	    &(struct pen_style){
		.size = 10, .anchor = PEN_MIDDLE, .upward = true});
	free(placed);
}

/* Marks as shapes where there is one, else as the character. */
static void
draw_mark(struct page *p, char mark, enum series series, double x, double y)
{
	enum { ROUND = 16 };
	const double r = 2.8, turn = 2 * acos(-1);
	double px[ROUND], py[ROUND];
	size_t n = mark == 'o'                  ? ROUND
		   : mark == 'v' || mark == '^' ? 3
		   : mark == '#'                ? 4
						: 0;
	double start = mark == 'v' ? 0.25 : mark == '^' ? 0.75 : 0.125;
	for (size_t i = 0; i < n; i++) {
		double angle = turn * (start + (double)i / (double)n);
		px[i] = x + r * cos(angle);
		py[i] = y + r * sin(angle);
	}
	char text[2] = {mark, '\0'};
	if (n > 0)
		p->pen->path(p->pen, px, py, n,
		    &(struct pen_stroke){series, CHART_SOLID, 0.8,
			mark == '#' ? PEN_FULL : PEN_PAPER});
	else
		p->pen->text(p->pen, x, y + 3, text,
		    &(struct pen_style){.size = 9,
			.anchor = PEN_MIDDLE,
			.bold = true,
			.series = series});
}

static void
draw_band(struct page *p, const struct chart_series *s)
{
	if (s->low == NULL)
		return;
	double *x = xdoubles(2 * s->n), *y = xdoubles(2 * s->n);
	for (size_t i = 0; i < s->n; i++) {
		size_t back = 2 * s->n - 1 - i;
		x[i] = x[back] = page_x(p, s->x[i]);
		y[i] = page_y(p, s->low[i]);
		y[back] = page_y(p, s->high[i]);
	}
	p->pen->path(p->pen, x, y, 2 * s->n,
	    &(struct pen_stroke){SERIES_BAND, CHART_SOLID, 0, PEN_TINT});
	free(x);
	free(y);
}

/* From one lift of the pen to the next. */
static void
draw_line(struct page *p, const struct chart_series *s)
{
	double *x = xdoubles(s->n), *y = xdoubles(s->n);
	struct pen_stroke stroke = {s->series, s->line, 1.2, PEN_OPEN};
	size_t n = 0;
	for (size_t i = 0; i <= s->n && s->line != CHART_MARKS; i++) {
		if (i < s->n && isfinite(s->y[i])) {
			x[n] = page_x(p, s->x[i]);
			y[n++] = page_y(p, s->y[i]);
			continue;
		}
		if (n > 1)
			p->pen->path(p->pen, x, y, n, &stroke);
		n = 0;
	}
	free(x);
	free(y);
}

static struct pen_stroke
rule_stroke(const struct chart_rule *rule)
{
	enum chart_line line = rule->series == SERIES_OTHER ? CHART_DASHED
			       : rule->series == SERIES_CROSSHAIR
				   ? CHART_SOLID
				   : CHART_DOTTED;
	return (struct pen_stroke){rule->series, line, 0.8, PEN_OPEN};
}

static void
draw_data(struct page *p)
{
	const struct chart *c = p->chart;
	double foot = TOP + p->height;
	for (size_t i = 0; i < c->n; i++)
		draw_band(p, &c->series[i]);
	for (size_t i = 0; i < c->n_rule; i++) {
		double x = page_x(p, c->rule[i].x);
		draw_rule(p, x, TOP, x, foot, rule_stroke(&c->rule[i]));
	}
	for (size_t i = 0; i < c->n; i++)
		draw_line(p, &c->series[i]);
	for (size_t i = 0; i < c->n; i++)
		for (size_t j = 0; j < c->series[i].n; j++) {
			const struct chart_series *s = &c->series[i];
			if (s->mark != 0 && isfinite(s->y[j]))
				draw_mark(p, s->mark, s->series,
				    page_x(p, s->x[j]), page_y(p, s->y[j]));
		}
}

static void
draw_legend(struct page *p)
{
	const struct chart *c = p->chart;
	double y = TOP + ROW / 2.0;
	struct pen_style style = {.size = 8};
	for (size_t i = 0; i < c->n + c->n_rule; i++, y += ROW) {
		const struct chart_series *s = i < c->n ? &c->series[i] : NULL;
		const struct chart_rule *r = s ? NULL : &c->rule[i - c->n];
		struct pen_stroke stroke =
		    s != NULL
			? (struct pen_stroke){s->series, s->line, 1.2, PEN_OPEN}
			: rule_stroke(r);
		if (stroke.line != CHART_MARKS)
			draw_rule(p, LEGEND, y, LEGEND + SAMPLE, y, stroke);
		if (s != NULL && s->mark != 0)
			draw_mark(
			    p, s->mark, s->series, LEGEND + SAMPLE / 2.0, y);
		p->pen->text(p->pen, LEGEND + SAMPLE + 5, y + 3,
		    s != NULL ? s->name : r->name, &style);
	}
}

/* Notes, where the data are from, and the program, a line each or more. */
static char *
foot_text(const struct chart *chart, const char *program)
{
	char *text = NULL;
	size_t n = 0;
	FILE *memory = text_memory(&text, &n);
	char *about = xasprintf("data: %s; drawn by %s", chart->about, program);
	for (size_t i = 0; i < chart->n_note; i++)
		text_wrap(chart->note[i], 0, FOOT_COLUMNS, memory);
	text_wrap(about, 0, FOOT_COLUMNS, memory);
	free(about);
	fclose(memory);
	return text;
}

static void
draw_foot(struct page *p, char *text)
{
	char *save = NULL;
	double y = TOP + p->height + BELOW;
	struct pen_style style = {.size = 8};
	for (char *line = strtok_r(text, "\n", &save); line != NULL;
	     line = strtok_r(NULL, "\n", &save)) {
		y += FOOT_ROW;
		p->pen->text(p->pen, LEFT, y, line, &style);
	}
}

static void
draw_page(struct page *p, char *foot)
{
	double x[] = {LEFT, LEFT + WIDTH, LEFT + WIDTH, LEFT, LEFT};
	double y[] = {TOP, TOP, TOP + p->height, TOP + p->height, TOP};
	p->pen->text(p->pen, LEFT, TOP - 12, p->chart->title,
	    &(struct pen_style){.size = 11, .bold = true});
	draw_x_axis(p);
	draw_y_axis(p);
	draw_data(p);
	p->pen->path(p->pen, x, y, ARRAY_LEN(x), &THIN);
	draw_legend(p);
	draw_foot(p, foot);
}

bool
picture_write(const struct chart *chart, enum picture_form form,
    const char *program, FILE *out)
{
	struct page p = {.chart = chart};
	char *foot = foot_text(chart, program);
	size_t rows = 1;
	for (const char *c = foot; *c != '\0'; c++)
		rows += *c == '\n';
	p.height = fmax(LEAST_HEIGHT, ROW * (double)(chart->n + chart->n_rule));
	double height = TOP + p.height + BELOW + FOOT_ROW * (double)rows;
	p.pen = pen_open(
	    form, PAGE, height, &WHITE, chart->title, chart->about, out);
	draw_page(&p, foot);
	free(foot);
	return p.pen->close(p.pen);
}
