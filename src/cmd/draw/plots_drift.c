/* drift: plots each cut, EWMA and CUSUM (core/check/control_chart.h) as shares
 * of their limits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/routine.h"
#include "cmd/draw/site_chart.h"

/* Control charts are drawn as shares of their limits, so that one plot holds
 * them all: a point beyond 1 or -1 is a signal. */
static const struct {
	const char *name;
	struct chart_series look;
} SHOWN[] = {{N_("each cut (1: 3 sd)"),
		 {.series = SERIES_FEED, .line = CHART_MARKS, .mark = 'o'}},
    {"EWMA", {.series = SERIES_KIND_1, .line = CHART_DASHED, .ascii = '-'}},
    {N_("CUSUM finer"),
	{.series = SERIES_KIND_2, .line = CHART_SOLID, .ascii = '='}},
    {N_("CUSUM coarser"),
	{.series = SERIES_KIND_3, .line = CHART_SOLID, .ascii = '#'}},
    {N_("CUSUM of the tilt"),
	{.series = SERIES_KIND_4, .line = CHART_LONG, .ascii = '%'}}};

/* Computes the value of each series as a share of its limit, with its sign. */
static void
compute_drift_relative_to_limits(const struct drift_point *p,
    const struct drift_rule *rule, double share[static ARRAY_LEN(SHOWN)])
{
	const struct drift_chart *level = &p->chart[DRIFT_LEVEL];
	const struct drift_chart *tilt = &p->chart[DRIFT_TILT];
	share[0] = level->score / 3;
	share[1] = level->ewma / level->ewma_limit;
	share[2] = level->up / rule->h;
	share[3] = level->down > 0 ? -level->down / rule->h : 0;
	share[4] = (tilt->down > tilt->up ? -tilt->down : tilt->up) / rule->h;
}

static void
note_drift_state(struct chart *chart, const struct routine *r)
{
	const char *from = r->cut[0].when, *to = r->cut[r->n - 1].when;
	FREED char *words = drift_in_words(r);
	if (r->dated)
		chart_add_note(
		    chart, "cuts 1 to %zu: %s to %s", r->n, from, to);
	chart_add_note(chart, "up: finer than predicted; down: coarser");
	chart_add_note(chart, "%s", words);
}

/* Draws the control charts that `drift` computes. */
struct chart *
plots_control_charts(
    struct session *s, const struct plot_request *q, struct error *error)
{
	const struct entry *entry = q->asked.entry;
	if (!answers_require_params(s, entry, error))
		return NULL;
	struct routine *r =
	    control_charts_compute(s, entry, &DRIFT_RULE, error);
	if (r == NULL)
		return NULL;
	double low = -1.2, high = 1.2, last = (double)r->n + 1;
	double share[ARRAY_LEN(SHOWN)];
	for (size_t j = 0; j < r->n; j++) {
		compute_drift_relative_to_limits(&r->point[j], &r->rule, share);
		for (size_t i = 0; i < ARRAY_LEN(SHOWN); i++) {
			low = fmin(low, share[i]);
			high = fmax(high, share[i]);
		}
	}
	struct axis x = {.title = xstrdup(tr("cut")), .low = 0, .high = last};
	size_t step = r->n / 20 + 1;
	for (size_t j = 0; j < r->n; j += step) {
		FREED char *label = xasprintf("%zu", j + 1);
		axis_add_tick(&x, (double)(j + 1), label, 0);
	}
	struct chart *chart = site_chart_new(entry->site, x,
	    axis_new_linear(tr("share of the limit, -"), low, high),
	    "routine cuts against their predictions");
	chart_append_point_series(chart, SITE_CHART_LEVEL, 5,
	    (double[]){0, last, 0, 0, last}, (double[]){1, 1, NAN, -1, -1},
	    tr("limits"));
	for (size_t i = 0; i < ARRAY_LEN(SHOWN); i++)
		chart_append_series(
		    chart, SHOWN[i].look, r->n, "%s", tr(SHOWN[i].name));
	for (size_t j = 0; j < r->n; j++) {
		compute_drift_relative_to_limits(&r->point[j], &r->rule, share);
		for (size_t i = 0; i < ARRAY_LEN(SHOWN); i++) {
			chart->series[i + 1]->x[j] = (double)(j + 1);
			chart->series[i + 1]->y[j] = share[i];
		}
	}
	if (r->first < r->n)
		chart_add_vertical_rule(chart, SERIES_BREAK,
		    (double)(r->since + 1), "began at about cut %zu",
		    r->since + 1);
	note_drift_state(chart, r);
	control_charts_free(r);
	return chart;
}
