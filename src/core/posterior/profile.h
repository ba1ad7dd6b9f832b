/* The profile of the misfit over one parameter.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_PROFILE_H
#define TIPSPEED_CORE_POSTERIOR_PROFILE_H

#include "core/search/misfit.h"

/* Computes the lowest misfit [n] with parameter j held at each of x [n],
 * rising, and the others refitted within the bounds, by a polish from the
 * neighbouring result, outward from the fit.  p: the fit.  For a parameter in
 * the gauge the gauge's largest parameter is also held, and the others stay
 * within its size (D4); the profile of the largest itself is flat. */
void profile_misfit(struct misfit *m, const struct params *p,
    const struct bounds *bounds, size_t j, const double *x, size_t n,
    double *misfit);

/* Returns the density of draws [n] at x, using Gaussian kernels with the width
 * of Silverman's rule, reflected at the bounds.
 * Source: Silverman (1986), Density Estimation, section 3.4.2. */
double profile_density_of_draws(
    const double *draw, size_t n, double lower, double upper, double x);

#endif
