/* Plots of the model itself: selection, appearance, and the materials.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/plots.h"
#include "core/elementary.h"
#include "core/energy.h"
#include "io/units.h"

enum { SAMPLES = 241 };

/* Value i of SAMPLES between low and high, evenly on the log. */
static double
sample(double low, double high, size_t i)
{
	return low * pow(high / low, (double)i / (SAMPLES - 1));
}

static void
add_selection(struct chart *chart, const struct session *s,
    const struct params *params, double speed, struct chart_series look)
{
	struct chart_series *series =
	    chart_add(chart, look, SAMPLES, "%g m/s", speed);
	struct breaker b;
	breaker_set(&b, params, s->set.model.k);
	breaker_at(&b, speed);
	for (size_t i = 0; i < SAMPLES; i++) {
		series->x[i] = sample(chart->x.low, chart->x.high, i);
		series->y[i] = 100 * b.model->selection(
					 &b, el_log(series->x[i] / 1000), NULL);
	}
	double mm = 1000 * energy_break_size(params, speed);
	chart_add_rule(chart,
	    look.series == SERIES_OTHER ? SERIES_OTHER : SERIES_BREAK, mm,
	    "break size %.2f mm at %g m/s", mm, speed);
}

struct chart *
plots_selection(
    struct session *s, const struct plot_request *q, struct error *error)
{
	const struct site *site = session_entry(s)->site;
	double speed = isnan(q->speed) ? answers_middle(site) : q->speed;
	struct params params;
	if (!plots_params(s, q, &params, error))
		return NULL;
	const struct psd *feed = &site->run[site_run_nearest(site, speed)].feed;
	double *size = xdoubles(feed->n);
	for (size_t i = 0; i < feed->n; i++)
		size[i] = units_mm(feed->size[i]);
	struct chart *chart =
	    plots_site_chart(site, axis_sieves("size, mm", size, feed->n),
		axis_percent("share that breaks S(x), %"),
		"selection function (Eq 3)");
	free(size);
	if (!isnan(q->other_speed))
		add_selection(chart, s, &params, q->other_speed,
		    (struct chart_series){.series = SERIES_OTHER,
			.line = CHART_LONG,
			.ascii = '%'});
	add_selection(chart, s, &params, speed, PLOTS_CURVE);
	return chart;
}

struct chart *
plots_appearance(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct params params;
	if (!plots_params(s, q, &params, error))
		return NULL;
	if (s->set.model.appearance != APPEARANCE_RATIO) {
		error_set(error, ERROR_USAGE,
		    "only the appearance function of the form ratio can be "
		    "drawn\n"
		    "run 'show appearance' for the matrix of any form");
		return NULL;
	}
	const struct site *site = session_entry(s)->site;
	double speed = isnan(q->speed) ? answers_middle(site) : q->speed;
	struct breaker b;
	breaker_set(&b, &params, s->set.model.k);
	breaker_at(&b, speed);
	struct chart *chart = plots_site_chart(site,
	    axis_log("progeny / parent u, -", 0.001, 1),
	    axis_percent("finer than u B(u), %"), "appearance function (Eq 1)");
	struct chart_series *curve =
	    chart_add(chart, PLOTS_CURVE, SAMPLES, "B(u)");
	for (size_t i = 0; i < SAMPLES; i++) {
		curve->x[i] = sample(chart->x.low, chart->x.high, i);
		curve->y[i] = 100 * answers_finer(&b, curve->x[i], site);
	}
	return chart;
}

/* Materials of one rock, in a series of their own. */
static void
add_rock(struct chart *chart, const struct stored_list *list, const char *rock)
{
	struct chart_series look = plots_look(chart->n);
	look.line = CHART_MARKS;
	struct chart_series *series = chart_add(
	    chart, look, list->n, "%s", rock[0] != '\0' ? rock : "not stated");
	series->n = 0;
	for (size_t i = 0; i < list->n; i++) {
		if (!text_same(list->item[i].rock, rock))
			continue;
		series->x[series->n] =
		    params_value(&list->item[i].params, "f_mat");
		series->y[series->n++] =
		    params_value(&list->item[i].params, "e0_min");
	}
}

/* The first of its rock in the list. */
static bool
is_first(const struct stored_list *list, size_t at)
{
	for (size_t i = 0; i < at; i++)
		if (text_same(list->item[i].rock, list->item[at].rock))
			return false;
	return true;
}

static void
add_own(struct chart *chart, const struct entry *entry)
{
	struct chart_series *own = chart_add(chart,
	    (struct chart_series){.series = SERIES_PREDICTED, .mark = '#'}, 1,
	    "%s", entry->site->name);
	own->x[0] = params_value(&entry->params, "f_mat");
	own->y[0] = params_value(&entry->params, "e0_min");
}

struct chart *
plots_map(struct session *s, const struct plot_request *q, struct error *error)
{
	(void)q;
	struct stored_list list = {0};
	if (!store_list_all(s->store, &list, error))
		return NULL;
	const struct entry *entry = s->n_entry > 0 ? session_entry(s) : NULL;
	if (entry != NULL && !entry->has_params)
		entry = NULL;
	double f_mat = 0, low = INFINITY, high = 0;
	for (size_t i = 0; i < list.n + (entry != NULL); i++) {
		const struct params *p =
		    i < list.n ? &list.item[i].params : &entry->params;
		f_mat = fmax(f_mat, params_value(p, "f_mat"));
		low = fmin(low, params_value(p, "e0_min"));
		high = fmax(high, params_value(p, "e0_min"));
	}
	struct chart *chart = chart_new("materials by rock",
	    "Table 3 of Grunditz et al. (2021) and the user's own fits",
	    axis_linear("f_mat, kg/(J m)", 0, f_mat),
	    axis_linear("e0_min, J m/kg", low, high));
	for (size_t i = 0; i < list.n; i++)
		if (is_first(&list, i))
			add_rock(chart, &list, list.item[i].rock);
	if (entry != NULL)
		add_own(chart, entry);
	stored_list_free(&list);
	return chart;
}
