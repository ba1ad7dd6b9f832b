/* The profile of the misfit over one parameter.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_PROFILE_H
#define TIPSPEED_CORE_POSTERIOR_PROFILE_H

#include "core/search/misfit.h"

/* Computes misfit [n]: the lowest misfit with parameter j held at each of x
 * [n], rising, and the others refitted within the bounds.  Works outward from
 * the fit p, with a polish that starts at the neighbouring result.  If j is in
 * the gauge, the gauge's largest parameter is also held, and the others do not
 * exceed it (D4); the profile of the largest itself is flat. */
void profile_misfit(struct misfit *m, const struct params *p,
    const struct bounds *bounds, size_t j, const double *x, size_t n,
    double *misfit);

/* Returns the density of draws [n] at x, using Gaussian kernels with the width
 * of Silverman's rule, reflected at the bounds.
 * Source: Silverman (1986), Density Estimation, section 3.4.2. */
double profile_kde_of_draws(
    const double *draw, size_t n, double lower, double upper, double x);

#endif
