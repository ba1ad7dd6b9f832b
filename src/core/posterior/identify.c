/* Standard deviations, correlations and break sizes of the draws, compared with
 * the prior.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/identify.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>

#include "core/model/breakage.h"
#include "core/model/selection.h"
#include "core/posterior/ensemble.h"

enum { DRAWS = POSTERIOR_DRAWS };

static const double DETERMINED = 0.1, POORLY = 0.5;

/* A draw nearer to a bound than EDGE of the range is on the bound, and so is a
 * parameter if at least MANY of its draws are. */
static const double EDGE = 0.02, MANY = 0.2;

static void
copy_posterior_draws_of_param(
    const struct posterior *p, size_t j, double value[static DRAWS])
{
	for (size_t d = 0; d < DRAWS; d++)
		value[d] = p->draw[d].params.at[j];
}

static int
bound_where_posterior_lies(const double *value, double lower, double upper)
{
	double edge = EDGE * (upper - lower), low = 0, high = 0;
	for (size_t d = 0; d < DRAWS; d++) {
		low += value[d] <= lower + edge;
		high += value[d] >= upper - edge;
	}
	return low >= MANY * DRAWS ? -1 : high >= MANY * DRAWS;
}

/* Computes the first n parameters of a draw, scaled to a vector of length 1. */
static void
unit_vector_of_draw_params(
    const struct posterior *p, size_t d, size_t n, double *unit)
{
	double squares = 0;
	for (size_t j = 0; j < n; j++)
		squares += pow(p->draw[d].params.at[j], 2);
	for (size_t j = 0; j < n; j++)
		unit[j] = p->draw[d].params.at[j] / sqrt(squares);
}

/* Returns how far the draws scatter around their mean direction, for n
 * parameters of which only the direction matters: the RMS sine of the angle,
 * divided by that of random directions. */
static double
scatter_of_draw_directions(const struct posterior *p, size_t n)
{
	double mean[PARAMS_MOST] = {0}, unit[PARAMS_MOST], length = 0, sum = 0;
	for (size_t d = 0; d < DRAWS; d++) {
		unit_vector_of_draw_params(p, d, n, unit);
		for (size_t j = 0; j < n; j++)
			mean[j] += unit[j];
	}
	for (size_t j = 0; j < n; j++)
		length += mean[j] * mean[j];
	for (size_t d = 0; d < DRAWS; d++) {
		double along = 0;
		unit_vector_of_draw_params(p, d, n, unit);
		for (size_t j = 0; j < n; j++)
			along += unit[j] * mean[j] / sqrt(length);
		sum += fmax(1 - along * along, 0) / DRAWS;
	}
	return sqrt(sum / (1 - 1 / (double)n));
}

struct identify_param
identify_summarise_param(const struct posterior *p, size_t j)
{
	double value[DRAWS];
	const struct bounds *b = &p->bounds;
	const struct breakage *of = BREAKAGES[p->settings.breakage];
	const struct param_info *info = &of->parameter[j];
	double range = j < of->gauge ? 2 : b->upper[j] - b->lower[j];
	copy_posterior_draws_of_param(p, j, value);
	struct identify_param a = {.mean = gsl_stats_mean(value, 1, DRAWS),
	    .sd = gsl_stats_sd(value, 1, DRAWS),
	    .prior = info->spread > 0 ? info->spread : range / sqrt(12)};
	bool moves =
	    b->upper[j] > b->lower[j] && a.sd > 1e-9 * fmax(fabs(a.mean), 1e-9);
	a.ratio = moves ? a.sd / a.prior : NAN;
	/* Scaling may make one of the gauge's parameters 1 in all draws, but
	 * that does not mean that the data determine it. */
	if (j < of->gauge) {
		a.ratio = scatter_of_draw_directions(p, of->gauge);
		moves = a.ratio > 1e-9;
	}
	a.grade = !moves                 ? IDENTIFY_FIXED
		  : a.ratio < DETERMINED ? IDENTIFY_DETERMINED
		  : a.ratio < POORLY     ? IDENTIFY_POORLY
					 : IDENTIFY_NOT;
	a.bound = moves && j >= of->gauge ? bound_where_posterior_lies(
						value, b->lower[j], b->upper[j])
					  : 0;
	return a;
}

struct identify_pair
identify_correlate_params(const struct posterior *p, size_t i, size_t j)
{
	double a[DRAWS], b[DRAWS], work[2 * DRAWS];
	copy_posterior_draws_of_param(p, i, a);
	copy_posterior_draws_of_param(p, j, b);
	if (!(gsl_stats_sd(a, 1, DRAWS) > 0 && gsl_stats_sd(b, 1, DRAWS) > 0))
		return (struct identify_pair){NAN, NAN};
	return (struct identify_pair){gsl_stats_correlation(a, 1, b, 1, DRAWS),
	    gsl_stats_spearman(a, 1, b, 1, DRAWS, work)};
}

double
identify_larger_of_rank_or_linear(struct identify_pair pair)
{
	return fabs(pair.rank) > fabs(pair.linear) ? pair.rank : pair.linear;
}

struct identify_break
identify_summarise_break_size(const struct posterior *p, double v, double size)
{
	double value[DRAWS], sum[3] = {0};
	struct identify_break a = {0};
	for (size_t d = 0; d < DRAWS; d++) {
		value[d] = params_break_size_by_impacts(
		    &p->draw[d].params, &p->settings, v);
		a.below += (value[d] < size) / (double)DRAWS;
		if (!isfinite(value[d]))
			continue;
		sum[0]++;
		sum[1] += value[d];
		sum[2] += value[d] * value[d];
	}
	a.mean = sum[0] > 0 ? sum[1] / sum[0] : INFINITY;
	a.sd = sqrt(fmax(sum[2] / sum[0] - a.mean * a.mean, 0));
	ensemble_middle_interval(value, 0.8, &a.low, &a.high);
	return a;
}
