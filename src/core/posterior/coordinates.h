/* Coordinates of a model's parameters in which chains move freely.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_COORDINATES_H
#define TIPSPEED_CORE_POSTERIOR_COORDINATES_H

#include <stdbool.h>

#include "core/model/breakage.h"
#include "core/model/params.h"

/* The coordinates about a fit, with the bounds of its model.  Plain data.
 *
 * Only the direction of the gauge matters: its coordinates are a stereographic
 * projection of the sphere of directions, centred on the fit's, so that all
 * directions on the fit's side lie close together.
 *
 * The data determine the break size of Eq 3 and the slope of S there well, but
 * f_mat, e0_min and alpha poorly, as these compensate for each other.
 * Therefore, if by_slope is true, there is a coordinate from minus to plus
 * infinity for each of ln x* = (ln e0_min - ln E) / alpha,  below its largest
 * value, f_mat,  between its bounds, alpha,  as far as its own bounds and those
 * of e0_min allow; otherwise these three parameters are their own coordinates,
 * because one of them is held fixed. */
struct coordinates {
	const struct breakage *of;
	struct params fit;
	struct model_settings settings;
	struct bounds bounds;
	double middle;      /* ln of the mean energy E, J/kg */
	double least, most; /* ln (e0_min / E) at the bounds of e0_min */
	double largest;     /* ln x* */
	bool by_slope;
	size_t held;                    /* the gauge's largest parameter, whose
					 * sign does not change */
	double sign, pole[PARAMS_MOST]; /* the fit's gauge, scaled to length
					 * 1 */
};
struct coordinates coordinates_new_about_fit(const struct params *fit,
    const struct bounds *bounds, const struct model_settings *settings,
    double middle);

/* Computes the parameters at [n] from coordinates x [n].  Returns -ln of the
 * prior density in x, up to a constant.  The prior is uniform between the
 * bounds, normal if the model's table gives a spread, and the same for all
 * directions of the gauge on the fit's side that have progeny; elsewhere the
 * result is INFINITY. */
double coordinates_to_params(
    const struct coordinates *c, const double *x, double *at);

/* Computes the coordinates of parameters.  A value on a bound is moved slightly
 * inside. */
void coordinates_from_params(
    const struct coordinates *c, const double *at, double *x);

/* Reflects, at their bounds, the coordinates that are parameters themselves. */
void coordinates_reflect_at_bounds(const struct coordinates *c, double *x);

#endif
