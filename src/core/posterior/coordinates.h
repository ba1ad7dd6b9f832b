/* Coordinates of a model's parameters in which chains move freely.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_COORDINATES_H
#define TIPSPEED_CORE_POSTERIOR_COORDINATES_H

#include <stdbool.h>

#include "core/model/breakage.h"
#include "core/model/params.h"

/* Of a fit and what its model keeps within; plain data.
 *
 * Of the gauge only the direction counts: its coordinates are those of the
 * stereographic projection of a sphere, with the fit's direction in the middle,
 * so that none on the fit's side lies far out.
 *
 * Of Eq 3 the data tell the break size and how steeply S rises there, and much
 * less f_mat, e0_min and alpha, which compensate for each other.  So
 * coordinates (by_slope) are, each from minus to plus infinity, those of
 *   ln x* = (ln e0_min - ln E) / alpha,  from where it is largest,
 *   f_mat,  from bound to bound,
 *   alpha,  from where e0_min is at a bound or alpha at its own to the other;
 * or the three themselves, where one of them is held fixed. */
struct coordinates {
	const struct breakage *of;
	struct params fit;
	struct model_settings settings;
	struct bounds bounds;
	double middle;      /* ln of the mean energy E, J/kg */
	double least, most; /* ln of e0_min / E at its bounds */
	double largest;     /* ln x* */
	bool by_slope;
	size_t held;                    /* of the gauge: its sign stays */
	double sign, pole[PARAMS_MOST]; /* the fit's gauge, of length 1 */
};
struct coordinates coordinates_about(const struct params *fit,
    const struct bounds *bounds, const struct model_settings *settings,
    double middle);

/* Parameters at [n] of coordinates x [n].  Returns -ln of the prior's density
 * in x, but for a constant: uniform between the bounds, normal where the model
 * says so, and alike for all directions of the gauge on the fit's side in which
 * there are daughters.  INFINITY outside. */
double coordinates_params(
    const struct coordinates *c, const double *x, double *at);

/* The other way; what lies on a bound comes a little within. */
void coordinates_of(const struct coordinates *c, const double *at, double *x);

/* Brings those that are parameters and went over a bound back by as much as
 * they did. */
void coordinates_reflect(const struct coordinates *c, double *x);

#endif
