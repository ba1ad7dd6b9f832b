/* Coordinates of a model's parameters in which chains move freely.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_COORDINATES_H
#define TIPSPEED_CORE_POSTERIOR_COORDINATES_H

#include <stdbool.h>

#include "core/model/breakage.h"
#include "core/model/params.h"

/* The coordinates about a fit, with the bounds of its model; plain data.
 *
 * Only the direction of the gauge counts: its coordinates are those of the
 * stereographic projection of a sphere, with the fit's direction in the middle,
 * so that no direction on the fit's side lies far out.
 *
 * The data determine the break size of Eq 3 and how steeply S rises there, and
 * much less f_mat, e0_min and alpha, which compensate for each other.  So
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

/* Computes the parameters at [n] of coordinates x [n].  Returns -ln of the
 * prior's density in x, up to a constant: uniform between the bounds, normal
 * where the model's table gives a spread, and equal for all directions of the
 * gauge on the fit's side in which there are daughters.  INFINITY outside. */
double coordinates_params(
    const struct coordinates *c, const double *x, double *at);

/* Computes the coordinates of parameters; a value on a bound is moved a little
 * inside. */
void coordinates_of(const struct coordinates *c, const double *at, double *x);

/* Reflects at the bound each coordinate that is a parameter and lies beyond
 * it. */
void coordinates_reflect(const struct coordinates *c, double *x);

#endif
