/* Maps parameters to unbounded coordinates and back, with the logarithm of the
 * Jacobian determinant: beta by a projection of the sphere, the others as
 * shares of their range, by an approximate normal distribution function.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/coordinates.h"

#include <math.h>
#include <string.h>

#include "core/numeric/elementary.h"

/* Maps a number x to a share 0..1, approximately by the normal distribution,
 * and gives -ln of the derivative (Bowling and others 2009). */
static const double LINEAR = 1.5976, CUBIC = 0.07056;

static double
share_from_coordinate(double x)
{
	return 1 / (1 + el_exp(-x * (LINEAR + CUBIC * x * x)));
}

static double
minus_log_share_density(double x)
{
	double rise = x * (LINEAR + CUBIC * x * x), at = el_exp(-fabs(rise));
	return fabs(rise) + 2 * el_log(1 + at) -
	       el_log(LINEAR + 3 * CUBIC * x * x);
}

static double
logistic(double x)
{
	return 1 / (1 + el_exp(-x));
}

/* Keeps a share away from 0 and 1, whose coordinates would be infinite. */
static double
clamp_share_off_0_and_1(double share)
{
	const double least = 1e-3;
	return fmin(fmax(share, least), 1 - least);
}

/* Returns the coordinate of a share, by Newton's method on a cubic that rises
 * everywhere. */
static double
share_to_unbounded_coordinate(double share)
{
	share = clamp_share_off_0_and_1(share);
	double rise = el_log(share / (1 - share)), x = rise / LINEAR;
	for (size_t i = 0; i < 20; i++)
		x -= (x * (LINEAR + CUBIC * x * x) - rise) /
		     (LINEAR + 3 * CUBIC * x * x);
	return x;
}

static bool
coordinates_is_param_free(const struct bounds *b, size_t j)
{
	return b->upper[j] > b->lower[j];
}

struct coordinates
coordinates_new_about_fit(const struct params *fit, const struct bounds *bounds,
    const struct model_settings *settings, double middle)
{
	const struct breakage *of = breakage_model_of_params(fit);
	size_t f = of->strength;
	struct coordinates c = {.of = of,
	    .fit = *fit,
	    .settings = *settings,
	    .bounds = *bounds,
	    .middle = middle,
	    .least = el_log(bounds->lower[f + 1]) - middle,
	    .most = el_log(bounds->upper[f + 1]) - middle};
	double squares = 0;
	c.largest = c.most / bounds->upper[f + 2];
	c.by_slope = coordinates_is_param_free(bounds, f) &&
		     coordinates_is_param_free(bounds, f + 1) &&
		     coordinates_is_param_free(bounds, f + 2) && c.largest < 0;
	for (size_t j = 0; j < of->gauge; j++) {
		squares += fit->at[j] * fit->at[j];
		if (fabs(fit->at[j]) > fabs(fit->at[c.held]))
			c.held = j;
	}
	for (size_t j = 0; j < of->gauge; j++)
		c.pole[j] = fit->at[j] / sqrt(squares);
	c.sign = c.pole[c.held] < 0 ? -1 : 1;
	return c;
}

/* Reflects [gauge] numbers in place, so that the pole and the axis of the held
 * parameter change places. */
static void
coordinates_swap_pole_and_axis(const struct coordinates *c, double *w)
{
	double product = 0, squares = 0, normal[PARAMS_MOST];
	for (size_t j = 0; j < c->of->gauge; j++) {
		normal[j] = c->pole[j] - (j == c->held ? c->sign : 0);
		product += normal[j] * w[j];
		squares += normal[j] * normal[j];
	}
	for (size_t j = 0; j < c->of->gauge && squares > 1e-20; j++)
		w[j] -= 2 * product / squares * normal[j];
}

/* True if p(u) is above 0 anywhere. */
static bool
has_any_progeny(const struct coordinates *c, const double *gauge)
{
	double whole = 0;
	for (size_t j = 0; j < c->of->gauge; j++)
		whole += gauge[j];
	if (whole > 0 || gauge[0] > 0)
		return true;
	struct params p = c->fit;
	struct breaker b;
	memcpy(p.at, gauge, c->of->gauge * sizeof *gauge);
	breaker_set_params(&b, &p, &c->settings);
	breaker_set_speed(&b, sqrt(2 * el_exp(c->middle)));
	return breaker_has_progeny(&b);
}

/* Computes the gauge at x and returns its part of the prior. */
static double
betas_from_coordinates(const struct coordinates *c, const double *x, double *at)
{
	double squares = 0;
	for (size_t j = 0; j < c->of->gauge; j++)
		squares += j == c->held ? 0 : x[j] * x[j] / 4;
	for (size_t j = 0; j < c->of->gauge; j++)
		at[j] = j == c->held ? c->sign * (1 - squares) / (1 + squares)
				     : x[j] / (1 + squares);
	coordinates_swap_pole_and_axis(c, at);
	if (!(c->sign * at[c->held] > 0) || !has_any_progeny(c, at))
		return INFINITY;
	return (double)(c->of->gauge - 1) * el_log(1 + squares);
}

static void
coordinates_from_betas(const struct coordinates *c, const double *at, double *x)
{
	double squares = 0;
	for (size_t j = 0; j < c->of->gauge; j++)
		squares += at[j] * at[j];
	for (size_t j = 0; j < c->of->gauge; j++)
		x[j] = at[j] / sqrt(squares);
	coordinates_swap_pole_and_axis(c, x);
	double along = c->sign * x[c->held];
	for (size_t j = 0; j < c->of->gauge; j++)
		x[j] *= 2 / (1 + fmax(along, 0));
	x[c->held] = 0;
}

/* Finds the range of alpha for a break size x*: alpha lies within its own
 * bounds, and e0_min within its bounds at either end. */
static void
alpha_range_at_break_size(
    const struct coordinates *c, double log_break, double *low, double *high)
{
	size_t alpha = c->of->strength + 2;
	*low = fmax(c->bounds.lower[alpha], c->most / log_break);
	*high = fmin(c->bounds.upper[alpha], c->least / log_break);
}

/* Computes f_mat, e0_min and alpha at x and returns their part of the prior:
 *   d e0_min = alpha e0_min d ln x*  at constant alpha,
 *   d ln x* = ln x* d ln(share of x). */
static double
strength_and_prior_from_coordinates(
    const struct coordinates *c, const double *x, double *at)
{
	size_t f = c->of->strength;
	double share = share_from_coordinate(x[f]),
	       log_break = c->largest / share, low, high;
	double hard = logistic(x[f + 1]);
	alpha_range_at_break_size(c, log_break, &low, &high);
	double alpha = low + (high - low) * share_from_coordinate(x[f + 2]);
	double e0 = el_exp(c->middle + alpha * log_break);
	at[f] = c->bounds.lower[f] +
		(c->bounds.upper[f] - c->bounds.lower[f]) * hard;
	at[f + 1] = e0;
	at[f + 2] = alpha;
	double density =
	    hard * (1 - hard) * alpha * (high - low) * e0 / (share * share);
	if (!(low < high) || !(density > 0))
		return INFINITY;
	return minus_log_share_density(x[f]) +
	       minus_log_share_density(x[f + 2]) - el_log(density);
}

static void
coordinates_from_strength_params(
    const struct coordinates *c, const double *at, double *x)
{
	size_t f = c->of->strength;
	double alpha = fmax(at[f + 2], 1e-3), e0 = fmax(at[f + 1], 1e-6), low,
	       high;
	double log_break = (el_log(e0) - c->middle) / alpha;
	double hard =
	    clamp_share_off_0_and_1((at[f] - c->bounds.lower[f]) /
				    (c->bounds.upper[f] - c->bounds.lower[f]));
	x[f] = share_to_unbounded_coordinate(c->largest / log_break);
	alpha_range_at_break_size(
	    c, c->largest / share_from_coordinate(x[f]), &low, &high);
	x[f + 1] = el_log(hard / (1 - hard));
	x[f + 2] = share_to_unbounded_coordinate((alpha - low) / (high - low));
}

static bool
is_coordinate_the_parameter(const struct coordinates *c, size_t j)
{
	size_t f = c->of->strength;
	return j >= c->of->gauge && !(c->by_slope && j >= f && j <= f + 2);
}

double
coordinates_to_params(const struct coordinates *c, const double *x, double *at)
{
	double sum = 0;
	for (size_t j = 0; j < c->of->n; j++) {
		const struct param_info *info = &c->of->parameter[j];
		at[j] = x[j];
		if (!is_coordinate_the_parameter(c, j))
			continue;
		double z =
		    info->spread > 0 ? (x[j] - info->start) / info->spread : 0;
		sum += z * z / 2;
		if (!(x[j] >= c->bounds.lower[j] && x[j] <= c->bounds.upper[j]))
			sum = INFINITY;
	}
	if (c->of->gauge > 0)
		sum += betas_from_coordinates(c, x, at);
	return c->by_slope ? sum + strength_and_prior_from_coordinates(c, x, at)
			   : sum;
}

void
coordinates_from_params(
    const struct coordinates *c, const double *at, double *x)
{
	memcpy(x, at, c->of->n * sizeof *x);
	if (c->of->gauge > 0)
		coordinates_from_betas(c, at, x);
	if (c->by_slope)
		coordinates_from_strength_params(c, at, x);
}

void
coordinates_reflect_at_bounds(const struct coordinates *c, double *x)
{
	for (size_t j = 0; j < c->of->n; j++) {
		double lower = c->bounds.lower[j], upper = c->bounds.upper[j];
		if (!is_coordinate_the_parameter(c, j))
			continue;
		if (x[j] < lower)
			x[j] = 2 * lower - x[j];
		if (x[j] > upper)
			x[j] = 2 * upper - x[j];
	}
}
