/* correlation: a grid of the correlations of the parameters over the draws.
 * profile: the misfit along one parameter with the others refitted, beside the
 * density of the draws.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/outlook.h"
#include "cmd/draw/site_chart.h"
#include "core/posterior/identify.h"
#include "core/posterior/profile.h"

/* Returns the draws of a site, or NULL with an error. */
static const struct posterior *
posterior_or_error(
    const struct session *s, const struct entry *entry, struct error *error)
{
	if (!answers_require_params(s, entry, error))
		return NULL;
	const struct posterior *p = posterior_even_if_correction_off(s, entry);
	if (p == NULL)
		band_set_error_missing(s, entry, error);
	return p;
}

/* Sets column to the indices of the parameters that are not held fixed, and
 * returns their number. */
static size_t
find_free_parameters(
    const struct posterior *p, size_t column[static PARAMS_MOST])
{
	size_t n = 0;
	for (size_t j = 0; j < BREAKAGES[p->settings.breakage]->n; j++)
		if (identify_summarise_param(p, j).grade != IDENTIFY_FIXED)
			column[n++] = j;
	return n;
}

/* Returns an axis with a tick for each parameter, from left to right or, for
 * the vertical axis (`up`), from the top down. */
static struct axis
parameter_name_axis(
    const struct posterior *p, const size_t *column, size_t n, bool up)
{
	const struct breakage *of = BREAKAGES[p->settings.breakage];
	struct axis axis = {.title = xstrdup("parameter"),
	    .names = true,
	    .low = 0.5,
	    .high = (double)n + 0.5};
	for (size_t k = 0; k < n; k++)
		axis_add_tick(&axis, (double)(up ? n - k : k + 1),
		    of->parameter[column[k]].name, 0);
	return axis;
}

/* Adds a series of the cells with positive or with negative correlations. */
static void
add_correlation_series(struct chart *chart, const struct posterior *p,
    const size_t *column, size_t n, bool positive)
{
	struct chart_series *s = chart_append_series(chart,
	    (struct chart_series){
		.series = positive ? SERIES_PREDICTED : SERIES_KIND_1,
		.mark = positive ? '+' : '-'},
	    n * n,
	    positive ? N_("rise together")
		     : N_("one falls as the other rises"));
	s->n = 0;
	s->field = xcalloc(n * n + 1, sizeof *s->field);
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j < n; j++) {
			double r = i == j ? 1
					  : identify_larger_of_rank_or_linear(
						identify_correlate_params(
						    p, column[i], column[j]));
			if ((r >= 0) != positive)
				continue;
			s->x[s->n] = (double)(j + 1);
			s->y[s->n] = (double)(n - i);
			s->field[s->n].value = i == j ? NAN : r;
			s->field[s->n++].label =
			    i == j ? xstrdup("1") : xasprintf("%+.2f", r);
		}
}

struct chart *
plots_parameter_correlations(
    struct session *s, const struct plot_request *q, struct error *error)
{
	size_t column[PARAMS_MOST];
	const struct posterior *p =
	    posterior_or_error(s, q->asked.entry, error);
	if (p == NULL)
		return NULL;
	size_t n = find_free_parameters(p, column);
	if (n < 2) {
		error_set(error, ERROR_USAGE,
		    "correlation: expected two free parameters or more, got "
		    "%zu\n"
		    "run 'bounds default' and 'calibrate'",
		    n);
		return NULL;
	}
	struct chart *chart = site_chart_new(q->asked.entry->site,
	    parameter_name_axis(p, column, n, false),
	    parameter_name_axis(p, column, n, true), "correlations of %d draws",
	    POSTERIOR_DRAWS);
	add_correlation_series(chart, p, column, n, true);
	add_correlation_series(chart, p, column, n, false);
	chart_add_note(chart,
	    "of the draws or of their ranks, whichever is stronger; above 0.9 "
	    "the data determine only a combination of the two");
	return chart;
}

/* What a profile is computed from: the misfit and the fit of the calibration,
 * in the calibration's model or, if only the model of the draws has the
 * parameter, in that. */
struct profile_data {
	const struct history *h;
	const struct posterior *p; /* NULL without draws */
	struct misfit *misfit;
	struct params fit;
	struct bounds bounds;
	size_t j;   /* index of the parameter in that model */
	size_t own; /* its index among the draws */
	const struct param_info *info;
};

static bool
prepare_param_profile(const struct session *s, const struct entry *entry,
    const char *name, struct profile_data *a, struct error *error)
{
	if (!answers_require_params(s, entry, error))
		return false;
	if (origin_fit_behind_params(entry) == NULL)
		return error_set(error, ERROR_USAGE,
		    "the parameters do not come from a calibration in this "
		    "session\n"
		    "run 'calibrate' first");
	*a = (struct profile_data){.h = entry->origin->history,
	    .p = posterior_even_if_correction_off(s, entry)};
	a->fit = a->h->fit.params;
	a->bounds = a->h->bounds;
	struct model_settings settings = a->h->fit.settings;
	if (a->p != NULL &&
	    breakage_parameter_index(breakage_model_of_params(&a->fit), name) ==
		breakage_model_of_params(&a->fit)->n) {
		a->fit = a->p->fit;
		a->bounds = a->p->bounds;
		settings = a->p->settings;
	}
	const struct breakage *of = breakage_model_of_params(&a->fit);
	a->j = breakage_parameter_index(of, name);
	if (a->j == of->n)
		return error_set(error, ERROR_USAGE,
		    "the model %s has no parameter %s\n"
		    "run 'params' for its parameters",
		    of->name, name);
	a->info = &of->parameter[a->j];
	a->own = a->p == NULL ? 0
			      : breakage_parameter_index(
				    BREAKAGES[a->p->settings.breakage], name);
	bool gauge = a->j < of->gauge;
	if ((gauge && fabs(a->fit.at[a->j]) == 1) ||
	    (!gauge && !(a->bounds.lower[a->j] < a->bounds.upper[a->j])))
		return error_set(error, ERROR_USAGE,
		    "%s is %s\nchoose another parameter: plot profile param=..",
		    name,
		    gauge
			? tr("the parameter that the rest of beta is scaled by")
			: tr("held fixed"));
	a->misfit = misfit_new(a->h->site, a->h->train, NULL, false, settings);
	if (gauge) {
		a->bounds.lower[a->j] = -1;
		a->bounds.upper[a->j] = 1;
	}
	return true;
}

/* Sets reach to the range to show: that of the draws and the fit and a quarter
 * more on each side, within the bounds; without draws, the bounds. */
static void
choose_profile_plot_range(
    const struct profile_data *a, const double *draw, double reach[static 2])
{
	reach[0] = a->bounds.lower[a->j];
	reach[1] = a->bounds.upper[a->j];
	if (draw == NULL)
		return;
	double low = a->fit.at[a->j], high = low;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
		low = fmin(low, draw[d]);
		high = fmax(high, draw[d]);
	}
	double more = (high - low) / 4;
	if (!(more > 0))
		return;
	reach[0] = fmax(reach[0], low - more);
	reach[1] = fmin(reach[1], high + more);
}

/* The values of a parameter at which a profile is computed. */
enum { VALUES = 31 };

/* Sets x to n values spread over the axis, within the bounds.  The fit's own
 * value replaces the nearest one. */
static void
choose_parameter_profile_values(
    const struct chart *chart, const struct profile_data *a, double *x)
{
	double step = (chart->x.high - chart->x.low) / (VALUES - 1);
	double fit = a->fit.at[a->j];
	for (size_t i = 0; i < VALUES; i++) {
		double at = chart->x.low + step * (double)i;
		if (fabs(at - fit) <= step / 2)
			at = fit;
		x[i] = fmin(
		    fmax(at, a->bounds.lower[a->j]), a->bounds.upper[a->j]);
	}
}

/* Draws the refitted misfits as a likelihood with errors of unknown size,
 * E^(-n/2). */
static void
add_likelihood_curve(struct chart *chart, const struct profile_data *a)
{
	double x[VALUES], misfit[VALUES], least = INFINITY, near[2];
	choose_parameter_profile_values(chart, a, x);
	profile_misfit(a->misfit, &a->fit, &a->bounds, a->j, x, VALUES, misfit);
	for (size_t i = 0; i < VALUES; i++)
		least = fmin(least, misfit[i]);
	struct chart_series *s = chart_append_series(chart,
	    (struct chart_series){
		.series = SERIES_KIND_1, .line = CHART_SOLID, .ascii = '='},
	    VALUES, N_("misfit, others refitted"));
	double half = (double)misfit_count_changeable_passings(a->misfit) / 2;
	near[0] = INFINITY;
	near[1] = -INFINITY;
	for (size_t i = 0; i < VALUES; i++) {
		s->x[i] = x[i];
		s->y[i] = 100 * pow(least / misfit[i], half);
		if (misfit[i] > 1.1 * least)
			continue;
		near[0] = fmin(near[0], x[i]);
		near[1] = fmax(near[1], x[i]);
	}
	chart_add_note(chart,
	    "lowest misfit %.4g, within 10 %% of it from %.3g to %.3g; as a "
	    "likelihood, the misfit to the power -%g, which takes errors to be "
	    "independent",
	    least, near[0], near[1], half);
}

static void
add_posterior_density_curve(
    struct chart *chart, const struct profile_data *a, const double *draw)
{
	enum { POINTS = 101 };
	struct chart_series *s = chart_append_series(chart,
	    (struct chart_series){
		.series = SERIES_PREDICTED, .line = CHART_DASHED, .ascii = '#'},
	    POINTS, N_("draws"));
	double most = 0;
	for (size_t i = 0; i < POINTS; i++) {
		s->x[i] = chart->x.low + (chart->x.high - chart->x.low) *
					     (double)i / (POINTS - 1);
		s->y[i] = profile_kde_of_draws(draw, POSTERIOR_DRAWS,
		    a->bounds.lower[a->j], a->bounds.upper[a->j], s->x[i]);
		if (s->x[i] < a->bounds.lower[a->j] ||
		    s->x[i] > a->bounds.upper[a->j])
			s->y[i] = NAN;
		most = fmax(most, s->y[i]);
	}
	for (size_t i = 0; i < POINTS && most > 0; i++)
		s->y[i] *= 100 / most;
}

struct chart *
plots_parameter_profile(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct profile_data a;
	double draws[POSTERIOR_DRAWS], reach[2], *draw = NULL;
	if (!prepare_param_profile(s, q->asked.entry,
		q->param != NULL ? q->param : "e0_min", &a, error))
		return NULL;
	for (size_t d = 0; a.p != NULL && d < POSTERIOR_DRAWS; d++) {
		draw = draws;
		draws[d] = a.p->draw[d].params.at[a.own];
	}
	choose_profile_plot_range(&a, draw, reach);
	FREED char *title = xasprintf("%s, %s", a.info->name, a.info->unit);
	struct chart *chart = site_chart_new(q->asked.entry->site,
	    axis_new_linear(title, reach[0], reach[1]),
	    axis_new_percent(tr("relative to the most probable, %")),
	    "what the data say of %s", a.info->name);
	add_likelihood_curve(chart, &a);
	if (draw != NULL)
		add_posterior_density_curve(chart, &a, draw);
	chart_add_vertical_rule(chart, SERIES_BREAK, a.fit.at[a.j],
	    "calibrated %.4g", a.fit.at[a.j]);
	misfit_free(a.misfit);
	return chart;
}
