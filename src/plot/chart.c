/* Makes, queries and frees charts as data.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/chart.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"

struct chart *
chart_new(const char *title, const char *about, struct axis x, struct axis y)
{
	struct chart *c = xcalloc(1, sizeof *c);
	c->title = xstrdup(title);
	c->about = xstrdup(about);
	c->x = x;
	c->y = y;
	return c;
}

static void
free_chart_series(struct chart_series *s)
{
	if (s->finer != NULL)
		free_chart_series(s->finer);
	free(s->name);
	free(s->x);
	free(s->y);
	free(s->low);
	free(s->high);
	for (size_t j = 0; j < s->n && s->whose != NULL; j++) {
		free(s->whose[j].site);
		free(s->whose[j].about);
		free(s->whose[j].label);
	}
	free(s->whose);
	for (size_t j = 0; j < s->n && s->field != NULL; j++)
		free(s->field[j].label);
	free(s->field);
	free(s);
}

void
chart_free(struct chart *chart)
{
	if (chart == NULL)
		return;
	chart_free(chart->below);
	for (size_t i = 0; i < chart->n; i++)
		free_chart_series(chart->series[i]);
	for (size_t i = 0; i < chart->n_rule; i++)
		free(chart->rule[i].name);
	for (size_t i = 0; i < chart->n_note; i++)
		free(chart->note[i]);
	axis_free(&chart->x);
	axis_free(&chart->y);
	free(chart->series);
	free(chart->rule);
	free(chart->note);
	free(chart->title);
	free(chart->about);
	free(chart);
}

struct chart_series *
chart_append_series(struct chart *chart, struct chart_series look, size_t n,
    const char *name, ...)
{
	chart->series =
	    xrealloc(chart->series, chart->n + 1, sizeof *chart->series);
	struct chart_series *s = xcalloc(1, sizeof *s);
	chart->series[chart->n++] = s;
	*s = look;
	va_list ap;
	va_start(ap, name);
	s->name = xvasprintf(tr(name), ap);
	va_end(ap);
	s->n = n;
	s->x = xcalloc_doubles(n);
	s->y = xcalloc_doubles(n);
	s->low = s->high = NULL;
	s->whose = NULL;
	s->field = NULL;
	s->finer = NULL;
	return s;
}

void
chart_append_point_series(struct chart *chart, struct chart_series look,
    size_t n, const double *x, const double *y, const char *name)
{
	struct chart_series *s =
	    chart_append_series(chart, look, n, "%s", name);
	memcpy(s->x, x, n * sizeof *x);
	memcpy(s->y, y, n * sizeof *y);
}

void
chart_move_last_series_to_back(struct chart *chart)
{
	struct chart_series *last = chart->series[chart->n - 1];
	memmove(chart->series + 1, chart->series,
	    (chart->n - 1) * sizeof(*chart->series));
	chart->series[0] = last;
}

struct chart_series *
chart_allocate_finer_points(struct chart_series *series, size_t n)
{
	struct chart_series *finer = xcalloc(1, sizeof *finer);
	*finer = (struct chart_series){
	    .n = n, .x = xcalloc_doubles(n), .y = xcalloc_doubles(n)};
	series->finer = finer;
	return finer;
}

void
chart_allocate_point_names(struct chart_series *series)
{
	series->whose = xcalloc(series->n, sizeof *series->whose);
}

void
series_allocate_band(struct chart_series *series)
{
	series->low = xcalloc_doubles(series->n);
	series->high = xcalloc_doubles(series->n);
}

void
series_remove_band(struct chart_series *series)
{
	free(series->low);
	free(series->high);
	series->low = series->high = NULL;
}

void
chart_add_vertical_rule(
    struct chart *chart, enum series series, double x, const char *name, ...)
{
	if (!(x >= chart->x.low && x <= chart->x.high))
		return;
	va_list ap;
	va_start(ap, name);
	chart->rule =
	    xrealloc(chart->rule, chart->n_rule + 1, sizeof *chart->rule);
	chart->rule[chart->n_rule++] =
	    (struct chart_rule){x, series, xvasprintf(tr(name), ap)};
	va_end(ap);
}

void
chart_add_note(struct chart *chart, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	chart->note =
	    xrealloc(chart->note, chart->n_note + 1, sizeof *chart->note);
	chart->note[chart->n_note++] = xvasprintf(tr(format), ap);
	va_end(ap);
}

/* Returns the b that belongs to the value `at` of a, by interpolation between
 * the n points: in the logarithm of a if log_a, and of b if log_b.  Returns NAN
 * outside the points. */
static double
interpolate(const double *a, bool log_a, const double *b, bool log_b, size_t n,
    double at)
{
	const double grace = 1e-9 * fabs(at); /* for rounding */
	for (size_t i = 0; i + 1 < n; i++, a++, b++) {
		if (!(at >= fmin(a[0], a[1]) - grace &&
			at <= fmax(a[0], a[1]) + grace))
			continue;
		double from = log_b ? log(b[0]) : b[0];
		double to = log_b ? log(b[1]) : b[1];
		double t = log_a ? log(at / a[0]) / log(a[1] / a[0])
				 : (at - a[0]) / (a[1] - a[0]);
		double value = a[0] == a[1] ? from : from + t * (to - from);
		return log_b ? exp(value) : value;
	}
	return NAN;
}

double
chart_interpolate_at_x(const struct chart *chart,
    const struct chart_series *series, const double *value, double x)
{
	return interpolate(
	    series->x, chart->x.log, value, chart->y.log, series->n, x);
}

double
chart_series_y_at_x(
    const struct chart *chart, const struct chart_series *series, double x)
{
	return chart_interpolate_at_x(chart, series, series->y, x);
}

double
chart_series_x_at_y(
    const struct chart *chart, const struct chart_series *series, double y)
{
	if (series->finer != NULL)
		series = series->finer;
	return interpolate(
	    series->y, chart->y.log, series->x, chart->x.log, series->n, y);
}

static void
extend_range_to_include(double extent[2], double low, double high)
{
	extent[0] = fmin(extent[0], low);
	extent[1] = fmax(extent[1], high);
}

struct chart_extent
chart_compute_extent(const struct chart *chart)
{
	struct chart_extent e = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}};
	for (size_t i = 0; i < chart->n; i++) {
		const struct chart_series *s = chart->series[i];
		for (size_t k = 0; k < s->n; k++) {
			extend_range_to_include(e.x, s->x[k], s->x[k]);
			extend_range_to_include(e.y, s->y[k], s->y[k]);
			if (s->low != NULL)
				extend_range_to_include(
				    e.y, s->low[k], s->high[k]);
		}
	}
	return e;
}

void
chart_dash_lengths(enum chart_line line, int *on, int *off)
{
	static const int DASHES[][2] = {[CHART_MARKS] = {0, 1},
	    [CHART_SOLID] = {1, 0},
	    [CHART_DASHED] = {4, 3},
	    [CHART_LONG] = {12, 4},
	    [CHART_DOTTED] = {1, 2}};
	*on = DASHES[line][0];
	*off = DASHES[line][1];
}

/* The full marks, then the same marks hollow. */
static const struct point_mark MARKS[] = {{'+', 0x25CF, 16, 0, false},
    {'x', 0x25A0, 4, 0.125, false}, {'v', 0x25BC, 3, 0.25, false},
    {'^', 0x25B2, 3, 0.75, false}, {'*', 0x25C6, 4, 0, false},
    {'&', 0x2605, 6, 0, false}, {'o', 0x25CB, 16, 0, true},
    {'O', 0x25A1, 4, 0.125, true}, {'Q', 0x25BD, 3, 0.25, true},
    {'D', 0x25B3, 3, 0.75, true}, {'C', 0x25C7, 4, 0, true},
    {'0', 0x2606, 6, 0, true}};
enum { ALL = sizeof MARKS / sizeof MARKS[0], EACH = ALL / 2 };

const struct point_mark *
point_mark_of_character(char code)
{
	for (size_t i = 0; i < ALL; i++)
		if (MARKS[i].code == code)
			return &MARKS[i];
	return NULL;
}

char
nth_mark_character(unsigned i, bool hollow)
{
	return MARKS[i % EACH + (hollow ? EACH : 0)].code;
}
