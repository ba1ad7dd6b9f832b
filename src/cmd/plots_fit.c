/* Plots of a search and of what it is worth: convergence, the spread of the
 * candidates, and predicted against measured sizes of all sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/plots.h"
#include "core/misfit.h"
#include "core/validate.h"

/* A misfit that a log axis can show. */
static double
shown_misfit(double misfit)
{
	return isfinite(misfit) && misfit > 0 ? misfit : NAN;
}

struct chart *
plots_convergence(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct plots_past past = plots_past(s);
	size_t last = plots_generation(s, q, &past, error);
	if (last == past.n)
		return NULL;
	double low = INFINITY, high = 0;
	for (size_t i = 0; i <= last; i++) {
		const struct calibrate_generation *g = &past.generation[i];
		low = fmin(low, shown_misfit(g->best));
		high = fmax(high, shown_misfit(g->best));
		high = fmax(high, shown_misfit(g->median));
	}
	if (!isfinite(low))
		low = high = 1;
	struct chart *chart = plots_site_chart(session_entry(s)->site,
	    axis_linear("generation", 1, (double)past.n),
	    axis_log("misfit, -", low, high), "the search, %zu generations",
	    last + 1);
	chart_add(chart, PLOTS_FEED, last + 1, "median candidate");
	chart_add(chart, PLOTS_CURVE, last + 1, "best");
	struct chart_series *median = &chart->series[0], *best = median + 1;
	for (size_t i = 0; i <= last; i++) {
		median->x[i] = best->x[i] = (double)(i + 1);
		median->y[i] = shown_misfit(past.generation[i].median);
		best->y[i] = shown_misfit(past.generation[i].best);
	}
	return chart;
}

/* One row for each parameter, the first on top, half a row within the ends; not
 * quite half, lest rounding put two into one row of cells. */
static struct axis
parameter_axis(const struct breakage *of)
{
	const double margin = 0.45;
	struct axis axis = {.title = xstrdup("parameter"),
	    .low = margin,
	    .high = (double)of->n + margin};
	for (size_t j = 0; j < of->n; j++)
		axis_add(&axis, (double)(of->n - j), of->parameter[j].name, 0);
	return axis;
}

/* Where a value lies within its bounds, %; NAN of a parameter held fixed. */
static double
share_of(const struct bounds *b, size_t j, double value)
{
	double range = b->upper[j] - b->lower[j];
	return range > 0 ? 100 * (value - b->lower[j]) / range : NAN;
}

struct chart *
plots_spread(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct plots_past past = plots_past(s);
	size_t i = plots_generation(s, q, &past, error);
	if (i == past.n)
		return NULL;
	const struct calibrate_generation *g = &past.generation[i];
	const struct breakage *of = breakage_of(&g->params);
	struct chart *chart = plots_site_chart(session_entry(s)->site,
	    axis_linear("position between the bounds, %", 0, 100),
	    parameter_axis(of), "candidates of generation %zu", i + 1);
	/* Two ends and a lift of the pen. */
	struct chart_series *spread = chart_add(chart,
	    (struct chart_series){
		.series = SERIES_MEASURED_1, .line = CHART_SOLID, .ascii = '='},
	    3 * of->n, "middle 80 %%");
	for (size_t j = 0; j < of->n; j++) {
		double ends[3] = {share_of(past.bounds, j, g->p10[j]),
		    share_of(past.bounds, j, g->p90[j]), NAN};
		for (size_t k = 0; k < 3; k++) {
			spread->x[3 * j + k] = k < 2 ? ends[k] : 0;
			spread->y[3 * j + k] =
			    isnan(ends[k]) ? NAN : (double)(of->n - j);
		}
	}
	struct chart_series *best = chart_add(chart,
	    (struct chart_series){.series = SERIES_PREDICTED, .mark = '#'},
	    of->n, "best");
	for (size_t j = 0; j < of->n; j++) {
		best->x[j] = share_of(past.bounds, j, g->params.at[j]);
		best->y[j] = isnan(best->x[j]) ? NAN : (double)(of->n - j);
	}
	return chart;
}

/* Sizes measured and predicted, mm: P20, P50, P80 of each run held out.  about:
 * where the sites' data are from, each once. */
struct pairs {
	size_t n, n_site;
	char *about;
	double (*measured)[3], (*predicted)[3];
};

static void
add_about(struct pairs *pairs, const struct site *site)
{
	char *clause = site_source(site, "provenance not stated");
	if (strstr(pairs->about, clause) == NULL)
		xlist(&pairs->about, "; ", "%s", clause);
	free(clause);
}

static void
add_pairs(struct session *s, const struct entry *entry, struct pairs *pairs)
{
	size_t before = pairs->n;
	for (size_t run = 0; run < entry->site->n_run; run++) {
		if (entry->train[run] ||
		    misfit_covered(&entry->site->run[run]) == 0)
			continue;
		struct validation v = validate_run(entry->site, run,
		    entry->train, &entry->params, s->set.model);
		size_t n = pairs->n++;
		pairs->measured =
		    xrealloc(pairs->measured, n + 1, sizeof *pairs->measured);
		pairs->predicted =
		    xrealloc(pairs->predicted, n + 1, sizeof *pairs->predicted);
		for (size_t i = 0; i < 3; i++) {
			pairs->measured[n][i] = 1000 * v.size[i].measured;
			pairs->predicted[n][i] = 1000 * v.size[i].predicted;
		}
	}
	if (pairs->n == before)
		return;
	pairs->n_site++;
	add_about(pairs, entry->site);
}

static void
put_pairs(
    struct chart *chart, const struct pairs *pairs, double low, double high)
{
	static const char *const NAMES[] = {"P20", "P50", "P80"};
	struct chart_series *equal = chart_add(chart,
	    (struct chart_series){
		.series = SERIES_TEXT, .line = CHART_DOTTED, .ascii = '.'},
	    2, "as measured (1:1)");
	equal->x[0] = equal->y[0] = low;
	equal->x[1] = equal->y[1] = high;
	for (size_t i = 0; i < 3; i++) {
		struct chart_series look = plots_look(i);
		look.line = CHART_MARKS;
		struct chart_series *p =
		    chart_add(chart, look, pairs->n, "%s", NAMES[i]);
		for (size_t j = 0; j < pairs->n; j++) {
			p->x[j] = pairs->measured[j][i];
			p->y[j] = isnan(p->x[j]) ? NAN : pairs->predicted[j][i];
		}
	}
}

struct chart *
plots_parity(
    struct session *s, const struct plot_request *q, struct error *error)
{
	(void)q;
	struct pairs pairs = {.about = xstrdup("")};
	struct chart *chart = NULL;
	double low = INFINITY, high = 0;
	for (size_t i = 0; i < s->n_entry; i++)
		if (s->entry[i].has_params)
			add_pairs(s, &s->entry[i], &pairs);
	for (size_t j = 0; j < 3 * pairs.n; j++) {
		double both[] = {pairs.measured[j / 3][j % 3],
		    pairs.predicted[j / 3][j % 3]};
		for (size_t k = 0; k < 2; k++) {
			low = fmin(low, both[k]);
			high = fmax(high, both[k]);
		}
	}
	if (high > 0) {
		struct axis x = axis_log("measured, mm", low, high);
		struct axis y = axis_log("predicted, mm", low, high);
		char *title = xasprintf("sizes at held-out speeds, %zu site%s",
		    pairs.n_site, pairs.n_site == 1 ? "" : "s");
		chart = chart_new(title, pairs.about, x, y);
		free(title);
		put_pairs(chart, &pairs, x.low, x.high);
	} else {
		error_set(error, ERROR_USAGE,
		    "no loaded site has both parameters and a product at a "
		    "held-out speed\n"
		    "load sites with three speeds, then run 'calibrate all'");
	}
	free(pairs.about);
	free(pairs.measured);
	free(pairs.predicted);
	return chart;
}
