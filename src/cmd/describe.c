/* describe: a plot in sentences, made from the data that plot draws.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/pictures.h"
#include "cmd/table.h"

/* A chart being told. */
struct tale {
	const struct chart *chart;
	enum plot_kind kind;
	struct answer *answer;
};

/* " mm" of "size, mm"; "" where there is no unit. */
static char *
unit_of(const struct axis *axis)
{
	const char *unit = strrchr(axis->title, ',');
	bool none = unit == NULL || strcmp(unit, ", -") == 0;
	return xstrdup(none ? "" : unit + 1);
}

static void
say_axes(struct tale *t)
{
	const struct axis *axes[] = {&t->chart->x, &t->chart->y};
	static const char *const ways[] = {"Across", "Up"};
	bool rows = t->kind == PLOT_SPREAD; /* one row a parameter */
	for (size_t i = 0; i < ARRAY_LEN(axes) - rows; i++)
		answer_note(t->answer, "%s: %s, from %.4g to %.4g%s", ways[i],
		    axes[i]->title, axes[i]->low, axes[i]->high,
		    axes[i]->log ? " on a log scale" : "");
}

/* "; P20 1.08 mm, P50 2.81 mm, P80 5.28 mm" of a product or a feed. */
static char *
sizes_of(const struct tale *t, const struct chart_series *s)
{
	static const double PASSING[] = {20, 50, 80};
	char *text = xstrdup("");
	bool psd = t->kind == PLOT_PSD || t->kind == PLOT_SWEEP;
	for (size_t i = 0; psd && i < ARRAY_LEN(PASSING); i++) {
		double x = chart_at_y(t->chart, s, PASSING[i]);
		xappend(&text, "%s P%g ", i > 0 ? "," : ";", PASSING[i]);
		if (isnan(x))
			xappend(&text, "outside the sieves");
		else
			xappend(&text, "%.2f mm", x);
	}
	return text;
}

/* Where a curve begins and ends, from the left; flat ends are left out. */
static void
say_curve(struct tale *t, const struct chart_series *s)
{
	size_t n = s->n;
	bool falls = n > 1 && s->x[0] > s->x[n - 1];
	size_t first = falls ? n - 1 : 0, last = falls ? 0 : n - 1;
	size_t step = falls ? SIZE_MAX : 1;
	while (first != last &&
	       (isnan(s->y[first]) || s->y[first] == s->y[first + step]))
		first += step;
	while (first != last &&
	       (isnan(s->y[last]) || s->y[last] == s->y[last - step]))
		last -= step;
	char *x = unit_of(&t->chart->x), *y = unit_of(&t->chart->y);
	char *sizes = sizes_of(t, s);
	if (first == last)
		answer_note(t->answer, "%s: %.4g%s throughout", s->name,
		    s->y[first], y);
	else
		answer_note(t->answer,
		    "%s: from %.3g%s at %.3g%s to %.3g%s at %.3g%s%s", s->name,
		    s->y[first], y, s->x[first], x, s->y[last], y, s->x[last],
		    x, sizes);
	free(x);
	free(y);
	free(sizes);
}

/* Points of a map or of a comparison; all of them where they are few. */
static void
say_points(struct tale *t, const struct chart_series *s)
{
	enum { FEW = 6 };
	size_t shown = 0;
	char *text = xstrdup("");
	for (size_t i = 0; i < s->n && shown < FEW; i++) {
		if (isnan(s->y[i]))
			continue;
		xlist(&text, ";", " %.3g and %.3g", s->x[i], s->y[i]);
		shown++;
	}
	answer_note(t->answer, "%s, %zu point%s, across and up:%s%s", s->name,
	    s->n, s->n == 1 ? "" : "s", text, s->n > FEW ? " and more" : "");
	free(text);
}

/* The three points of a parameter in the spread: its ends, and the best. */
static void
say_spread(struct tale *t)
{
	const struct chart_series *s = &t->chart->series[0];
	const struct chart_series *best = &t->chart->series[1];
	for (size_t j = 0; j < best->n; j++) {
		const char *name = t->chart->y.tick[j].label;
		if (isnan(best->x[j]))
			answer_note(t->answer, "%s is held fixed", name);
		else
			answer_note(t->answer,
			    "%s: the middle 80 %% of the candidates from %.0f "
			    "to %.0f %% of its bounds, the best at %.0f %%",
			    name, s->x[3 * j], s->x[3 * j + 1], best->x[j]);
	}
}

/* Where the last curve, which lies on top, is furthest from another. */
static void
say_difference(struct tale *t, const struct chart_series *other)
{
	const struct chart_series *top = &t->chart->series[t->chart->n - 1];
	double most = 0, here = 0, there = 0, x = NAN;
	for (size_t i = 0; i < other->n; i++) {
		double y = chart_at(t->chart, top, other->x[i]);
		if (!(fabs(y - other->y[i]) > most))
			continue;
		most = fabs(y - other->y[i]);
		x = other->x[i];
		here = y;
		there = other->y[i];
	}
	char *x_unit = unit_of(&t->chart->x), *y_unit = unit_of(&t->chart->y);
	if (!isnan(x))
		answer_note(t->answer,
		    "%s and %s differ most at %.3g%s: %.3g and %.3g%s",
		    top->name, other->name, x, x_unit, here, there, y_unit);
	free(x_unit);
	free(y_unit);
}

static void
say_series(struct tale *t)
{
	const struct chart *c = t->chart;
	for (size_t i = 0; i < c->n; i++) {
		const struct chart_series *s = &c->series[i];
		if (s->line == CHART_MARKS)
			say_points(t, s);
		else if (s->series != SERIES_TEXT)
			say_curve(t, s);
	}
	for (size_t i = 0; i + 1 < c->n; i++)
		if (c->series[c->n - 1].line != CHART_MARKS)
			say_difference(t, &c->series[i]);
}

bool
cmd_describe(struct session *s, const struct args *args, struct error *error)
{
	struct plot_request request;
	struct chart *chart = pictures_chart(s, args, &request, error);
	if (chart == NULL)
		return false;
	struct tale t = {chart, request.kind, answer_new("describe")};
	answer_title(t.answer, "%s", chart->title);
	answer_sites(t.answer,
	    s->n_entry > 0 ? session_entry(s)->site->name : "", chart->about);
	fields_put(answer_fields(t.answer), "kind %s title %s data %s",
	    args->operand[0], chart->title, chart->about);
	say_axes(&t);
	if (request.kind == PLOT_SPREAD)
		say_spread(&t);
	else
		say_series(&t);
	for (size_t i = 0; i < chart->n_rule; i++)
		answer_note(t.answer, "A line from foot to top: %s",
		    chart->rule[i].name);
	for (size_t i = 0; i < chart->n_note; i++)
		answer_note(t.answer, "%s", chart->note[i]);
	chart_free(chart);
	return session_answer(s, t.answer);
}
