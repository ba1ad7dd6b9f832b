/* Subtracts curves at their own points, on a scale with one of a few limits (1,
 * 2, 5, 10 .. points).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots_difference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"

/* The least limit that holds a value: a few, so that the scale stands still
 * while the slider moves. */
static double
axis_limit(double value)
{
	static const double LIMITS[] = {1, 2, 5, 10, 20, 50};
	for (size_t i = 0; i < ARRAY_LEN(LIMITS); i++)
		if (value <= LIMITS[i])
			return LIMITS[i];
	return 100;
}

static void
add_tick(struct axis *axis, double at)
{
	char label[24];
	snprintf(label, sizeof label, at == 0 ? "%g" : "%+g", at);
	axis_add(axis, at, label, 0);
	axis->tick[axis->n - 1].guide = at == 0;
}

/* As far below 0 as above, so that 0 stays where it is. */
static struct axis
difference_points_axis(const struct chart *chart)
{
	struct axis axis = {.title = xstrdup(tr("difference, points"))};
	double most = 0;
	for (size_t i = 0; i < chart->n; i++)
		for (size_t j = 0; j < chart->series[i]->n; j++)
			most = fmax(most, fabs(chart->series[i]->y[j]));
	axis.high = axis_limit(most);
	axis.low = -axis.high;
	add_tick(&axis, axis.low);
	add_tick(&axis, 0);
	add_tick(&axis, axis.high);
	return axis;
}

/* At the points of a curve what it is more than another, where both are. */
static void
add_difference_of_curves(struct chart *strip, const struct chart *chart,
    const struct chart_series *a, const struct chart_series *b,
    struct chart_series look)
{
	struct chart_series *s =
	    chart_add(strip, look, a->n, "%s less %s", a->name, b->name);
	for (size_t i = 0; i < a->n; i++) {
		s->x[i] = a->x[i];
		s->y[i] = a->y[i] - chart_y_at(chart, b, a->x[i]);
	}
}

static struct axis
axis_copy(const struct axis *from)
{
	struct axis axis = *from;
	axis.title = xstrdup(from->title);
	axis.tick = xcalloc(from->n, sizeof *axis.tick);
	for (size_t i = 0; i < from->n; i++)
		axis.tick[i] = from->tick[i];
	return axis;
}

/* "measured 74 m/s" of "measured 74 m/s (2)". */
static int
short_name_length(const struct chart_series *s)
{
	return (int)strcspn(s->name, ",(") -
	       (s->name[strcspn(s->name, ",(")] == '(');
}

/* What is shown, whatever the numbers: "points; line: this less pin; marks:
 * measured 74 m/s less this", the prediction, which may be of another speed. */
static char *
title_of(const struct chart_series *other, const struct chart_series *measured)
{
	char *title = xstrdup(tr("points"));
	if (other != NULL)
		xlist(&title, "; ", tr("line: this less %s"),
		    strncmp(other->name, "pin", 3) == 0 ? tr("pin")
							: tr("the other"));
	if (measured != NULL)
		xlist(&title, "; ", tr("marks: %.*s less this"),
		    short_name_length(measured), measured->name);
	return title;
}

void
plots_difference(struct chart *chart, int rows, const bool *wanted)
{
	const struct chart_series *last = chart->series[chart->n - 1];
	const struct chart_series *other = NULL, *measured = NULL;
	struct chart *strip =
	    chart_new("", chart->about, axis_copy(&chart->x), (struct axis){0});
	for (size_t i = 0; i + 1 < chart->n; i++) {
		const struct chart_series *s = chart->series[i];
		if (s->series == SERIES_OTHER) {
			other = s;
			add_difference_of_curves(strip, chart, last, s, *last);
		} else if (wanted[i]) {
			measured = s;
			add_difference_of_curves(strip, chart, s, last, *s);
		}
	}
	free(strip->title);
	strip->title = title_of(other, measured);
	strip->strip = rows;
	strip->y = difference_points_axis(strip);
	if (strip->n > 0)
		chart->below = strip;
	else
		chart_free(strip);
}
