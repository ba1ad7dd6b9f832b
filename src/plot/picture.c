/* Lays out a chart or a screen on a page and draws it with any pen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/picture.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "config.h"

/* Distances on the page, points. */
enum {
	TOP = 34,
	LEGEND = 18, /* from the plot to the legend beside it */
	SAMPLE = 26,
	SAMPLE_GAP = 5,
	Y_TITLE = 46, /* left of the y axis */
	BELOW = 52,   /* labels and title of the x axis */
	ROW = 13,
	FOOT_ROW = 11
};

/* How a chart is laid out on a page of some width.  left: of the plot; right:
 * what is left beside it, for the legend if that is beside.  title, axis, foot:
 * sizes of letters; head, text: what a letter of the title and of the foot
 * takes; margin: left of the foot.  All in points. */
struct page_layout {
	bool beside;
	double left, right, title, axis, foot, head, text, margin;
};

/* As wide as two columns of a journal, and narrower. */
static const struct page_layout WIDE = {true, 64, 192, 11, 10, 8, 6, 4.71, 64},
				NARROW = {false, 56, 12, 9, 9, 7, 5.5, 4.1, 10};

/* The heights of a plot and of a strip, as shares of its width, and the least
 * height of a strip, points. */
static const double HEIGHT = 240.0 / 336, STRIP = 96.0 / 336, LEAST_STRIP = 60;

struct chart_page {
	const struct chart *chart;
	struct pen *pen;
	const struct page_layout *layout;
	double page;                     /* its width */
	double left, top, width, height; /* of the plot */
};

bool
picture_format_of_file_name(const char *path, enum picture_form *form)
{
	static const char *const ENDS[] = {[PICTURE_SVG] = ".svg",
	    [PICTURE_PNG] = ".png",
	    [PICTURE_PDF] = ".pdf"};
	const size_t n = ARRAY_LEN(ENDS), i = text_file_ending(path, ENDS, n);
	*form = (enum picture_form)i;
	return i < n;
}

static struct pen_paper
make_white_pen_paper(enum theme theme)
{
	struct pen_paper paper = {.colour = 0xFFFFFF};
	for (int i = 0; i < SERIES_COUNT; i++)
		paper.ink[i] =
		    palette_series_rgb_on_white((enum series)i, theme);
	return paper;
}

bool
picture_can_draw_format(enum picture_form form)
{
	return HAVE_CAIRO || form == PICTURE_SVG || form == PICTURE_INLINE;
}

const char *
picture_list_formats(void)
{
	return HAVE_CAIRO ? "svg, png, pdf" : "svg (built without cairo)";
}

static struct pen *
new_pen_for_format(enum picture_form form, double width, double height,
    const struct pen_paper *paper, const char *title, const char *about,
    FILE *out)
{
#if HAVE_CAIRO
	if (form == PICTURE_PNG || form == PICTURE_PDF)
		return pen_new_cairo(width, height, paper, title, about,
		    form == PICTURE_PDF, out);
#endif
	assert(form == PICTURE_SVG || form == PICTURE_INLINE);
	return pen_new_svg(
	    width, height, paper, title, about, form == PICTURE_INLINE, out);
}

static double
page_x_of_value(const struct chart_page *p, double x)
{
	return p->left + p->width * axis_relative_position(&p->chart->x, x);
}

static double
page_y_of_value(const struct chart_page *p, double y)
{
	return p->top +
	       p->height * (1 - axis_relative_position(&p->chart->y, y));
}

static void
draw_straight_line(struct chart_page *p, double x0, double y0, double x1,
    double y1, struct pen_stroke stroke)
{
	double x[2] = {x0, x1}, y[2] = {y0, y1};
	p->pen->path(p->pen, x, y, 2, &stroke);
}

static const struct pen_stroke THIN = {SERIES_TEXT, CHART_SOLID, 0.6, PEN_OPEN};
static const struct pen_stroke GUIDE = {
    SERIES_FEED, CHART_DOTTED, 0.3, PEN_OPEN};

static void
picture_draw_x_axis(struct chart_page *p)
{
	enum { COLUMN = 5, LABEL = 8, ROWS = 2 };
	/* The width of a digit; COLUMN is this, rounded. */
	static const double DIGIT = 5.1;
	const struct axis *a = &p->chart->x;
	double foot = p->top + p->height;
	FREED int *column = xcalloc(a->n, sizeof *column);
	FREED int *row = xcalloc(a->n, sizeof *row);
	double end[ROWS] = {0};
	axis_place_labels(a, (int)p->width / COLUMN, ROWS, column, row);
	for (size_t i = 0; i < a->n; i++) {
		double x = page_x_of_value(p, a->tick[i].at);
		double half = DIGIT * (double)strlen(a->tick[i].label) / 2;
		draw_straight_line(p, x, foot, x, foot + 4, THIN);
		if (row[i] == AXIS_DROPPED || x - half < end[row[i]] + 1)
			continue;
		end[row[i]] = x + half;
		p->pen->text(p->pen, x, foot + 4 + (LABEL + 2) * (row[i] + 1),
		    a->tick[i].label,
		    &(struct pen_style){.size = LABEL, .anchor = PEN_MIDDLE});
	}
	p->pen->text(p->pen, p->left + p->width / 2, foot + 4 + 4 * (LABEL + 2),
	    a->title,
	    &(struct pen_style){.size = p->layout->axis, .anchor = PEN_MIDDLE});
}

/* Returns true if a label at y would not touch one of those placed. */
static bool
is_label_place_free(const double *placed, size_t n, double y)
{
	for (size_t i = 0; i < n; i++)
		if (fabs(placed[i] - y) < 10)
			return false;
	return true;
}

static void
picture_draw_y_axis(struct chart_page *p)
{
	enum { RANKS = 3, LABEL = 8 };
	const struct axis *a = &p->chart->y;
	FREED double *placed = xcalloc_doubles(a->n);
	size_t n = 0;
	for (int rank = 0; rank < RANKS; rank++)
		for (size_t i = 0; i < a->n; i++) {
			const struct axis_tick *t = &a->tick[i];
			double y = page_y_of_value(p, t->at);
			if (t->rank != rank)
				continue;
			draw_straight_line(p, p->left - 4, y, p->left, y, THIN);
			if (t->guide)
				draw_straight_line(p, p->left, y,
				    p->left + p->width, y, GUIDE);
			if (!is_label_place_free(placed, n, y))
				continue;
			placed[n++] = y;
			p->pen->text(p->pen, p->left - 6, y + 3, t->label,
			    &(struct pen_style){
				.size = LABEL, .anchor = PEN_END});
		}
	p->pen->text(p->pen, p->left - Y_TITLE, p->top + p->height / 2,
	    a->title,
	    &(struct pen_style){
		.size = p->layout->axis, .anchor = PEN_MIDDLE, .upward = true});
}

/* Draws a regular polygon around a point.  start: where its first corner is, in
 * full turns. */
static void
draw_polygon(struct chart_page *p, int sides, double start, enum pen_fill fill,
    enum series series, double x, double y)
{
	enum { MOST = 16 };
	const double r = 2.8, turn = 2 * acos(-1);
	double px[MOST], py[MOST];
	for (int i = 0; i < sides; i++) {
		double angle = turn * (start + (double)i / sides);
		px[i] = x + r * cos(angle);
		py[i] = y + r * sin(angle);
	}
	p->pen->path(p->pen, px, py, (size_t)sides,
	    &(struct pen_stroke){series, CHART_SOLID, 0.8, fill});
}

/* Draws a mark as a shape if there is one for it, else as its character. */
static void
picture_draw_mark(
    struct chart_page *p, const struct chart_series *s, double x, double y)
{
	const struct point_mark *fine =
	    s->fine ? point_mark_of_character(s->mark) : NULL;
	int sides = s->mark == 'o'                     ? 16
		    : s->mark == 'v' || s->mark == '^' ? 3
		    : s->mark == '#'                   ? 4
						       : 0;
	double start = s->mark == 'v' ? 0.25 : s->mark == '^' ? 0.75 : 0.125;
	char text[2] = {s->mark, '\0'};
	if (fine != NULL)
		draw_polygon(p, fine->sides, fine->turn,
		    fine->hollow ? PEN_PAPER : PEN_FULL, s->series, x, y);
	else if (sides > 0)
		draw_polygon(p, sides, start,
		    s->mark == '#' ? PEN_FULL : PEN_PAPER, s->series, x, y);
	else /* the star is in the upper half of its line */
		p->pen->text(p->pen, x, y + (s->mark == '*' ? 5 : 3), text,
		    &(struct pen_style){.size = 9,
			.anchor = PEN_MIDDLE,
			.bold = true,
			.series = s->series});
}

static void
picture_draw_band(struct chart_page *p, const struct chart_series *s)
{
	if (s->low == NULL)
		return;
	FREED double *x = xcalloc_doubles(2 * s->n),
		     *y = xcalloc_doubles(2 * s->n);
	for (size_t i = 0; i < s->n; i++) {
		size_t back = 2 * s->n - 1 - i;
		x[i] = x[back] = page_x_of_value(p, s->x[i]);
		y[i] = page_y_of_value(p, s->low[i]);
		y[back] = page_y_of_value(p, s->high[i]);
	}
	p->pen->path(p->pen, x, y, 2 * s->n,
	    &(struct pen_stroke){s->series, CHART_SOLID, 0, PEN_TINT});
}

/* Returns the x of point i on the page, moved by the series' `beside`. */
static double
page_x_of_point(
    const struct chart_page *p, const struct chart_series *s, size_t i)
{
	enum { CELL = 4 };
	return page_x_of_value(p, s->x[i]) + CELL * s->beside;
}

static struct pen_stroke
stroke_of_bar(const struct chart_series *s)
{
	return (struct pen_stroke){s->series, CHART_SOLID,
	    s->line == CHART_LONG ? 2.4 : 1.2, PEN_OPEN};
}

/* Draws a line from low to high at each point. */
static void
draw_range_bars(struct chart_page *p, const struct chart_series *s)
{
	struct pen_stroke stroke = stroke_of_bar(s);
	for (size_t i = 0; i < s->n; i++) {
		double x = page_x_of_point(p, s, i);
		draw_straight_line(p, x, page_y_of_value(p, s->low[i]), x,
		    page_y_of_value(p, s->high[i]), stroke);
	}
}

/* Draws the line, lifting the pen where a value is missing. */
static void
picture_draw_series_line(struct chart_page *p, const struct chart_series *s)
{
	FREED double *x = xcalloc_doubles(s->n), *y = xcalloc_doubles(s->n);
	struct pen_stroke stroke = {s->series, s->line, 1.2, PEN_OPEN};
	size_t n = 0;
	for (size_t i = 0; i <= s->n && s->line != CHART_MARKS; i++) {
		if (i < s->n && isfinite(s->y[i])) {
			x[n] = page_x_of_value(p, s->x[i]);
			y[n++] = page_y_of_value(p, s->y[i]);
			continue;
		}
		if (n > 1)
			p->pen->path(p->pen, x, y, n, &stroke);
		n = 0;
	}
}

static struct pen_stroke
stroke_of_chart_rule(const struct chart_rule *rule)
{
	enum chart_line line = rule->series == SERIES_OTHER ? CHART_DASHED
			       : rule->series == SERIES_CROSSHAIR
				   ? CHART_SOLID
				   : CHART_DOTTED;
	return (struct pen_stroke){rule->series, line, 0.8, PEN_OPEN};
}

/* Draws a square whose area shows the value, unless that is NAN, and the
 * label. */
static void
draw_square_sized_by_value(
    struct chart_page *p, const struct chart_series *s, size_t i)
{
	double x = page_x_of_value(p, s->x[i]), y = page_y_of_value(p, s->y[i]);
	double width = page_x_of_value(p, s->x[i] + 0.5) -
		       page_x_of_value(p, s->x[i] - 0.5);
	double height = page_y_of_value(p, s->y[i] - 0.5) -
			page_y_of_value(p, s->y[i] + 0.5);
	double share = 0.95 * sqrt(fabs(s->field[i].value)) / 2;
	double w = share * width, h = share * height;
	double px[] = {x - w, x + w, x + w, x - w};
	double py[] = {y - h, y - h, y + h, y + h};
	if (!isnan(share))
		p->pen->path(p->pen, px, py, ARRAY_LEN(px),
		    &(struct pen_stroke){s->series, CHART_SOLID, 0, PEN_TINT});
	p->pen->text(p->pen, x, y + 3, s->field[i].label,
	    &(struct pen_style){
		.size = fmin(8, 0.31 * width), .anchor = PEN_MIDDLE});
}

/* Places on a page that marks and names have taken. */
struct taken {
	size_t n;
	struct box {
		double left, top, right, foot;
	} * box;
};

static bool
is_box_free_on_page(
    const struct chart_page *p, const struct taken *taken, struct box box)
{
	if (box.left < p->left || box.right > p->left + p->width ||
	    box.top < p->top || box.foot > p->top + p->height)
		return false;
	for (size_t i = 0; i < taken->n; i++) {
		const struct box *b = &taken->box[i];
		if (box.left < b->right && b->left < box.right &&
		    box.top < b->foot && b->top < box.foot)
			return false;
	}
	return true;
}

static void
mark_box_taken(struct taken *taken, struct box box)
{
	taken->box = xrealloc(taken->box, taken->n + 1, sizeof *taken->box);
	taken->box[taken->n++] = box;
}

/* Puts the name right of the mark, left of it, above or below, or else beside
 * it but lower or higher.  Leaves it out if there is no room. */
static void
picture_draw_point_name(struct chart_page *p, const struct chart_series *s,
    size_t i, struct taken *taken)
{
	enum { LETTERS_HIGH = 7, APART = 5 };
	const double letter = 4.2;
	const char *label = s->whose[i].label;
	double x = page_x_of_value(p, s->x[i]), y = page_y_of_value(p, s->y[i]);
	double wide = letter * text_width_in_columns(label);
	const double right = x + APART, before = x - APART - wide,
		     middle = x - wide / 2, above = y - APART,
		     below = y + APART + LETTERS_HIGH;
	const double left[] = {right, before, middle, middle, right, before,
	    right, before, right, before, right, before};
	const double foot[] = {y + 3, y + 3, above, below, y, y, y + 6, y + 6,
	    above, above, below, below};
	for (size_t k = 0; k < ARRAY_LEN(left); k++) {
		struct box box = {
		    left[k], foot[k] - LETTERS_HIGH, left[k] + wide, foot[k]};
		if (!is_box_free_on_page(p, taken, box))
			continue;
		mark_box_taken(taken, box);
		p->pen->text(p->pen, left[k], foot[k], label,
		    &(struct pen_style){
			.size = LETTERS_HIGH, .series = s->series});
		return;
	}
}

static void
picture_draw_point_names(struct chart_page *p)
{
	const double half = 3;
	const struct chart *c = p->chart;
	struct taken taken = {0};
	for (size_t i = 0; i < c->n; i++)
		for (size_t j = 0; j < c->series[i]->n; j++) {
			double x = page_x_of_value(p, c->series[i]->x[j]),
			       y = page_y_of_value(p, c->series[i]->y[j]);
			if (c->series[i]->mark != 0)
				mark_box_taken(
				    &taken, (struct box){x - half, y - half,
						x + half, y + half});
		}
	for (size_t i = 0; i < c->n; i++)
		for (size_t j = 0; j < c->series[i]->n && c->series[i]->named;
		     j++)
			if (c->series[i]->whose[j].label != NULL)
				picture_draw_point_name(
				    p, c->series[i], j, &taken);
	free(taken.box);
}

static void
picture_draw_data(struct chart_page *p)
{
	const struct chart *c = p->chart;
	double foot = p->top + p->height;
	for (size_t i = 0; i < c->n; i++)
		if (!c->series[i]->bars)
			picture_draw_band(p, c->series[i]);
	for (size_t i = 0; i < c->n_rule; i++) {
		double x = page_x_of_value(p, c->rule[i].x);
		draw_straight_line(
		    p, x, p->top, x, foot, stroke_of_chart_rule(&c->rule[i]));
	}
	for (size_t i = 0; i < c->n; i++)
		if (c->series[i]->bars)
			draw_range_bars(p, c->series[i]);
		else
			picture_draw_series_line(p, c->series[i]);
	for (size_t i = 0; i < c->n; i++)
		for (size_t j = 0; j < c->series[i]->n; j++) {
			const struct chart_series *s = c->series[i];
			if (s->field != NULL)
				draw_square_sized_by_value(p, s, j);
			else if (s->mark != 0 && isfinite(s->y[j]))
				picture_draw_mark(p, s,
				    page_x_of_point(p, s, j),
				    page_y_of_value(p, s->y[j]));
		}
	picture_draw_point_names(p);
}

/* Draws the line, mark and name of series i or, after the series, of a rule. */
static void
draw_legend_entry(struct chart_page *p, size_t i, double x, double y)
{
	const struct chart *c = p->chart;
	struct pen_style style = {.size = 8};
	const struct chart_series *s = i < c->n ? c->series[i] : NULL;
	const struct chart_rule *r = s ? NULL : &c->rule[i - c->n];
	struct pen_stroke stroke =
	    s != NULL ? (struct pen_stroke){s->series, s->line, 1.2, PEN_OPEN}
		      : stroke_of_chart_rule(r);
	if (stroke.line != CHART_MARKS)
		draw_straight_line(p, x, y, x + SAMPLE, y,
		    s != NULL && s->bars ? stroke_of_bar(s) : stroke);
	if (s != NULL && s->mark != 0)
		picture_draw_mark(p, s, x + SAMPLE / 2.0, y);
	p->pen->text(p->pen, x + SAMPLE + SAMPLE_GAP, y + 3,
	    s != NULL ? s->name : r->name, &style);
}

/* Returns the number of rows of the legend below a plot and, if `draw`, draws
 * it.  Its entries stand side by side where there is room; those without a name
 * are left out. */
static size_t
lay_out_legend_below(struct chart_page *p, bool draw)
{
	const double letter = 4.4;
	const struct chart *c = p->chart;
	double x = p->layout->margin;
	size_t rows = 0;
	for (size_t i = 0; i < c->n + c->n_rule; i++) {
		const char *name =
		    i < c->n ? c->series[i]->name : c->rule[i - c->n].name;
		double wide = SAMPLE + SAMPLE_GAP +
			      letter * text_width_in_columns(name) + LEGEND / 2;
		if (name[0] == '\0')
			continue;
		if (rows == 0 || x + wide > p->page) {
			x = p->layout->margin;
			rows++;
		}
		if (draw)
			draw_legend_entry(p, i, x,
			    p->top + p->height + BELOW +
				ROW * ((double)rows - 0.5));
		x += wide;
	}
	return rows;
}

static void
draw_legend_beside(struct chart_page *p)
{
	const struct chart *c = p->chart;
	double y = p->top + ROW / 2.0;
	for (size_t i = 0; i < c->n + c->n_rule; i++, y += ROW)
		draw_legend_entry(p, i, p->left + p->width + LEGEND, y);
}

/* Returns the text at the foot: the notes, and then the source of the data and
 * the program.  The caller frees it. */
static char *
chart_foot_text(
    const struct chart_page *p, const struct chart *chart, const char *program)
{
	char *text = NULL;
	size_t n = 0;
	FILE *memory = text_open_memory(&text, &n);
	FREED char *about =
	    xasprintf(tr("data: %s; drawn by %s"), chart->about, program);
	int columns = (int)((p->page - p->layout->margin) / p->layout->text);
	for (const struct chart *c = chart; c != NULL; c = c->below)
		for (size_t i = 0; i < c->n_note; i++)
			text_print_wrapped(c->note[i], 0, columns, memory);
	text_print_wrapped(about, 0, columns, memory);
	fclose(memory);
	return text;
}

/* Draws lines of text, the first at y and each `row` below the one before. */
static void
draw_text_lines(struct chart_page *p, char *text, double x, double y,
    double row, const struct pen_style *style)
{
	char *save = NULL;
	for (char *line = strtok_r(text, "\n", &save); line != NULL;
	     line = strtok_r(NULL, "\n", &save), y += row)
		p->pen->text(p->pen, x, y, line, style);
}

static int
columns_of_title(const struct chart_page *p)
{
	return (int)((p->page - p->left) / p->layout->head);
}

static double
rows_of_title(const struct chart_page *p)
{
	return fmax(
	    1, (double)text_count_rows(p->chart->title, columns_of_title(p)));
}

static void
picture_draw_one_chart(struct chart_page *p)
{
	double x[] = {
	    p->left, p->left + p->width, p->left + p->width, p->left, p->left};
	double y[] = {
	    p->top, p->top, p->top + p->height, p->top + p->height, p->top};
	FREED char *title = text_wrapped(p->chart->title, columns_of_title(p));
	draw_text_lines(p, title, p->left,
	    p->top - 12 - ROW * (rows_of_title(p) - 1), ROW,
	    &(struct pen_style){.size = p->layout->title, .bold = true});
	picture_draw_x_axis(p);
	picture_draw_y_axis(p);
	picture_draw_data(p);
	p->pen->path(p->pen, x, y, ARRAY_LEN(x), &THIN);
	if (p->chart->strip > 0) /* its title says it all */
		return;
	if (p->layout->beside)
		draw_legend_beside(p);
	else
		lay_out_legend_below(p, true);
}

static struct chart_page
page_of_width(double width, struct pen *pen)
{
	const struct page_layout *layout =
	    width < PICTURE_WIDTH ? &NARROW : &WIDE;
	return (struct chart_page){.pen = pen,
	    .layout = layout,
	    .page = width,
	    .left = layout->left,
	    .width = width - layout->left - layout->right};
}

/* Places a chart, whose page begins at `top`, and returns where the next one
 * begins. */
static double
place_chart_on_page(struct chart_page *p, const struct chart *chart, double top)
{
	p->chart = chart;
	const struct page_layout *l = p->layout;
	p->top = top + TOP + ROW * (rows_of_title(p) - 1);
	p->height = chart->strip > 0 ? fmax(LEAST_STRIP, STRIP * p->width)
				     : HEIGHT * p->width;
	if (l->beside)
		p->height =
		    fmax(p->height, ROW * (double)(chart->n + chart->n_rule));
	double legend = l->beside || chart->strip > 0
			    ? 0
			    : ROW * (double)lay_out_legend_below(p, false);
	return p->top + p->height + BELOW + legend;
}

/* As chart_picture_height and chart_picture_draw, on a page of any width. */
static double
height_on_page(const struct chart *chart, const char *program, double width)
{
	struct chart_page p = page_of_width(width, NULL);
	FREED char *foot = chart_foot_text(&p, chart, program);
	size_t rows = 1;
	for (const char *c = foot; *c != '\0'; c++)
		rows += *c == '\n';
	double end = 0;
	for (const struct chart *c = chart; c != NULL; c = c->below)
		end = place_chart_on_page(&p, c, end);
	return end + FOOT_ROW * (double)rows;
}

static void
draw_on_page(const struct chart *chart, const char *program, double width,
    struct pen *pen)
{
	struct chart_page p = page_of_width(width, pen);
	FREED char *foot = chart_foot_text(&p, chart, program);
	double end = 0;
	for (const struct chart *c = chart; c != NULL; c = c->below) {
		end = place_chart_on_page(&p, c, end);
		picture_draw_one_chart(&p);
	}
	draw_text_lines(&p, foot, p.layout->margin, end + FOOT_ROW, FOOT_ROW,
	    &(struct pen_style){.size = p.layout->foot});
}

double
chart_picture_height(const struct chart *chart, const char *program)
{
	return height_on_page(chart, program, PICTURE_WIDTH);
}

void
chart_picture_draw(
    const struct chart *chart, const char *program, struct pen *pen)
{
	draw_on_page(chart, program, PICTURE_WIDTH, pen);
}

bool
picture_write_chart(const struct chart *chart, enum picture_form form,
    double width, const char *program, FILE *out)
{
	const struct pen_paper paper = make_white_pen_paper(chart->theme);
	struct pen *pen = new_pen_for_format(form, width,
	    height_on_page(chart, program, width), &paper, chart->title,
	    chart->about, out);
	draw_on_page(chart, program, width, pen);
	return pen->close(pen);
}

struct pen *
picture_new_pdf_pages(double width, double height, const char *title,
    const char *about, FILE *out)
{
	const struct pen_paper paper = make_white_pen_paper(THEME_NORMAL);
	return HAVE_CAIRO ? new_pen_for_format(PICTURE_PDF, width, height,
				&paper, title, about, out)
			  : NULL;
}

/* Draws the cells of a terminal as runs of text, and as shapes for characters
 * that join from cell to cell.  All sizes are in points: a cell is as wide as
 * most monospaced letters of this size. */
#define CELL_WIDTH 6.0
#define CELL_HEIGHT 12.0
#define LETTERS 10.0
#define BASE_LINE 9.25
#define MARGIN 8.0

/* The bars of each kind; the cell gives them its colour and may make them
 * faint. */
enum kind { GROUND, SHADE, BLOCK, LINE, HEAVY, DOT, KINDS };
static const struct pen_bar KIND[KINDS] = {
    [GROUND] = {SERIES_TEXT, CELL_HEIGHT, 1, false},
    [SHADE] = {SERIES_TEXT, CELL_HEIGHT, 0.3, false},
    [BLOCK] = {SERIES_TEXT, CELL_HEIGHT / 2, 1, false},
    [LINE] = {SERIES_TEXT, 0.8, 1, true},
    [HEAVY] = {SERIES_TEXT, 1.6, 1, true},
    [DOT] = {SERIES_TEXT, 2.3, 1, true}};

/* From x0, y0 to x1, y1, in eighths of the cell. */
struct bar {
	unsigned char x0, y0, x1, y1;
};

enum { BARS = 8 };

/* Characters that are drawn as bars instead of text. */
static const struct shape {
	uint32_t code;
	enum kind kind;
	unsigned n;
	struct bar bar[4];
} SHAPES[] = {{0x00B7, DOT, 1, {{4, 4, 4, 4}}},
    {0x2500, LINE, 1, {{0, 4, 8, 4}}}, {0x2501, HEAVY, 1, {{0, 4, 8, 4}}},
    {0x2502, LINE, 1, {{4, 0, 4, 8}}},
    {0x2508, LINE, 2, {{1, 4, 2, 4}, {5, 4, 6, 4}}},
    {0x250A, LINE, 2, {{4, 1, 4, 2}, {4, 5, 4, 6}}},
    {0x2514, LINE, 2, {{4, 0, 4, 4}, {4, 4, 8, 4}}},
    {0x2524, LINE, 2, {{4, 0, 4, 8}, {0, 4, 4, 4}}},
    {0x252C, LINE, 2, {{0, 4, 8, 4}, {4, 4, 4, 8}}},
    {0x254C, LINE, 2, {{0, 4, 2, 4}, {5, 4, 7, 4}}},
    {0x254E, LINE, 2, {{4, 0, 4, 3}, {4, 5, 4, 7}}},
    {0x2591, SHADE, 1, {{0, 4, 8, 4}}}};

/* Writes the bars of a character and returns their number, which is 0 for a
 * character that is text. */
static size_t
bars_of_block_character(
    uint32_t code, enum kind *kind, struct bar bar[static BARS])
{
	/* Dots 1 to 8 of braille: column, row. */
	static const unsigned char DOTS[BARS][2] = {
	    {2, 1}, {2, 3}, {2, 5}, {6, 1}, {6, 3}, {6, 5}, {2, 7}, {6, 7}};
	size_t n = 0;
	for (size_t i = 0; i < ARRAY_LEN(SHAPES); i++)
		if (SHAPES[i].code == code) {
			*kind = SHAPES[i].kind;
			memcpy(bar, SHAPES[i].bar, sizeof SHAPES[i].bar);
			return SHAPES[i].n;
		}
	if (code >= 0x2800 && code <= 0x28FF) {
		*kind = DOT;
		for (unsigned i = 0; i < BARS; i++)
			if (code >> i & 1)
				bar[n++] = (struct bar){DOTS[i][0], DOTS[i][1],
				    DOTS[i][0], DOTS[i][1]};
		return n;
	}
	/* Bits of the quarters that are full: top left, top right, and below
	 * them. */
	unsigned set = 15;
	while (
	    set > 0 && canvas_character_of_dots(CHARSET_QUADRANTS, set) != code)
		set--;
	*kind = BLOCK;
	for (unsigned i = 0; i < 4; i++)
		if (set >> i & 1) {
			unsigned char x = i % 2 ? 4 : 0, y = i / 2 ? 6 : 2;
			bar[n++] =
			    (struct bar){x, y, (unsigned char)(x + 4), y};
		}
	return n;
}

/* Bars that are drawn in one path, because a screen has thousands: bar i from
 * point 2 i to point 2 i + 1. */
struct bars {
	size_t n;
	double *x, *y;
};

/* The places of bars are multiples of 3/4, in points. */
static bool
are_coordinates_close(double a, double b)
{
	return fabs(a - b) < 0.1;
}

/* Adds a bar.  A level bar that begins where the last one ends lengthens that
 * one instead. */
static void
add_or_join_bar(struct bars *s, int column, int row, const struct bar *bar)
{
	double left = MARGIN + CELL_WIDTH * column;
	double top = MARGIN + CELL_HEIGHT * row;
	double x0 = left + bar->x0 * CELL_WIDTH / 8;
	double y0 = top + bar->y0 * CELL_HEIGHT / 8;
	size_t last = s->n > 0 ? 2 * s->n - 1 : 0;
	bool joins = s->n > 0 && bar->y0 == bar->y1 && bar->x1 > bar->x0 &&
		     are_coordinates_close(s->x[last], x0) &&
		     are_coordinates_close(s->y[last], y0) &&
		     are_coordinates_close(s->y[last - 1], y0);
	if (!joins) {
		last = 2 * s->n++ + 1;
		s->x = xrealloc(s->x, 2 * s->n, sizeof *s->x);
		s->y = xrealloc(s->y, 2 * s->n, sizeof *s->y);
		s->x[last - 1] = x0;
		s->y[last - 1] = y0;
	}
	s->x[last] = left + bar->x1 * CELL_WIDTH / 8;
	s->y[last] = top + bar->y1 * CELL_HEIGHT / 8;
}

static void
draw_and_free_bars(struct bars *bars, struct pen *pen, struct pen_bar look,
    enum series series, bool faint)
{
	look.series = series;
	look.opacity *= faint ? PEN_FAINT : 1;
	if (bars->n > 0)
		pen->bars(pen, bars->x, bars->y, bars->n, &look);
	free(bars->x);
	free(bars->y);
}

/* Draws the bars of all cells, those of the same kind, colour and faintness in
 * one path. */
static void
draw_block_characters_of_canvas(
    const struct canvas *canvas, int depth, struct pen *pen)
{
	static const struct bar WHOLE = {0, 4, 8, 4};
	struct bars all[KINDS][SERIES_COUNT][2] = {0};
	for (int k = 0; k < canvas->columns * canvas->rows; k++) {
		const struct canvas_cell *cell = &canvas->cell[k];
		int column = k % canvas->columns, row = k / canvas->columns;
		bool faint = canvas_is_cell_faint(canvas, cell, depth);
		enum kind kind = GROUND;
		struct bar bar[BARS];
		size_t n = bars_of_block_character(cell->code, &kind, bar);
		for (size_t i = 0; i < n; i++)
			add_or_join_bar(&all[kind][cell->series][faint], column,
			    row, &bar[i]);
		if (cell->attribute & CELL_REVERSE)
			add_or_join_bar(&all[GROUND][cell->series][faint],
			    column, row, &WHOLE);
	}
	for (int i = 0; i < KINDS; i++)
		for (int j = 0; j < SERIES_COUNT; j++)
			for (int faint = 0; faint < 2; faint++)
				draw_and_free_bars(&all[i][j][faint], pen,
				    KIND[i], (enum series)j, faint == 1);
}

static bool
is_text_cell(const struct canvas_cell *cell)
{
	enum kind kind;
	struct bar bar[BARS];
	return cell->code > ' ' && cell->code != 0x2800 &&
	       bars_of_block_character(cell->code, &kind, bar) == 0;
}

/* Returns the column after a run of text that begins at `from`: cells of the
 * same style, with no more than one space between words. */
static int
end_of_same_style_text(const struct canvas *canvas, int from, int row)
{
	const struct canvas_cell *cell = canvas->cell + row * canvas->columns;
	int end = from + 1;
	for (int c = from + 1; c < canvas->columns; c++) {
		bool wide = cell[c].code == 0;
		bool text = is_text_cell(&cell[c]) &&
			    canvas_is_same_style(&cell[c], &cell[from]);
		if (!wide && !text && (cell[c].code != ' ' || end < c))
			break;
		end = wide || text ? c + 1 : end;
	}
	return end;
}

static void
draw_canvas_row_text(
    const struct canvas *canvas, int depth, struct pen *pen, int row)
{
	FREED char *text = xcalloc((size_t)canvas->columns + 1, 5);
	const struct canvas_cell *first = canvas->cell + row * canvas->columns;
	for (int c = 0, end; c < canvas->columns; c = end) {
		const struct canvas_cell *cell = first + c;
		char *at = text, code[5];
		end = c + 1;
		if (!is_text_cell(cell))
			continue;
		end = end_of_same_style_text(canvas, c, row);
		for (int i = 0; i < end - c; i++)
			if (cell[i].code != 0)
				at = stpcpy(at, canvas_encode_code_point(
						    cell[i].code, code));
		pen->text(pen, MARGIN + CELL_WIDTH * c,
		    MARGIN + CELL_HEIGHT * row + BASE_LINE, text,
		    &(struct pen_style){.size = LETTERS,
			.length = CELL_WIDTH * (end - c),
			.bold = cell->attribute & CELL_BOLD,
			.inverse = cell->attribute & CELL_REVERSE,
			.faint = canvas_is_cell_faint(canvas, cell, depth),
			.series = (enum series)cell->series});
	}
}

/* Returns the paper for cells.  Sets size to its width and height, points. */
static struct pen_paper
make_pen_paper_for_canvas(
    const struct canvas *canvas, int depth, double size[2])
{
	bool light = canvas->theme == THEME_LIGHT;
	struct pen_paper paper = {.colour = light ? 0xFFFFFF : 0x161B22,
	    .edge = 0x484F58,
	    .corner = 6,
	    .mono = true};
	for (int i = 0; i < SERIES_COUNT; i++) {
		int colour = palette_colour_of_series(
		    (enum series)i, depth, canvas->theme);
		paper.ink[i] = colour >= 0 ? palette_colour_to_rgb(colour)
			       : light     ? 0x000000
					   : 0xDFE3E8;
	}
	size[0] = 2 * MARGIN + CELL_WIDTH * canvas->columns;
	size[1] = 2 * MARGIN + CELL_HEIGHT * canvas->rows;
	return paper;
}

bool
picture_write_screen(const struct canvas *canvas, int depth,
    enum picture_form form, const char *title, const char *about, FILE *out)
{
	double size[2];
	struct pen_paper paper = make_pen_paper_for_canvas(canvas, depth, size);
	struct pen *pen = new_pen_for_format(
	    form, size[0], size[1], &paper, title, about, out);
	draw_block_characters_of_canvas(canvas, depth, pen);
	for (int row = 0; row < canvas->rows; row++)
		draw_canvas_row_text(canvas, depth, pen, row);
	return pen->close(pen);
}
