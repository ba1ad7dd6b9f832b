/* How well other parameters than the fitted ones go with the data.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PLAUSIBLE_H
#define TIPSPEED_CORE_PLAUSIBLE_H

#include "core/misfit.h"
#include "core/params.h"
#include "core/sensitivity.h"

/* The noise of the data as a fit's differences show it, and what it leaves
 * open.
 *
 * A passing is a share of a sample, so the variance of its noise is taken to go
 * with P (1 - P), or to be as the sheet states where it weighs the sieves; its
 * size comes from the misfit,
 *   a^2 = 1.6 misfit / sum of h (1 - leverage),  h = 4 P (1 - P) weight^2
 * and no sieve is trusted to less than 0.1 point, also where made-up data are
 * perfect.  The fit counts all sieves alike, so its own noise is
 *   G = U' diag(a^2 h) U
 * in the directions U in which the parameters move the differences; across them
 * the variance is s^2, the mean of G's. */
struct plausible;

/* m and bounds must outlive it.  p: the fit, at its optimum. */
struct plausible *plausible_new(struct misfit *m, const struct params *p,
    const struct bounds *bounds, const struct sensitivity *s,
    const double *basis);
void plausible_free(struct plausible *f);

/* -ln of the probability of p, but for a constant; Student's, as the size of
 * the noise is itself known from nu differences or so only:
 *   (nu + n)/2 ln(1 + T / nu) + D/2 ln |gauge|^2
 *   T = (misfit - that of the fit - |e|^2) / s^2 + e' G^-1 e
 * where e = U' (differences at p - those of the fit); INFINITY outside the
 * bounds.  The last term makes all directions of beta alike (D4); D is the
 * number of its free ones and the one that is held, n of the parameters that
 * move. */
double plausible_level(struct plausible *f, const struct params *p);

/* s, in units of the weighted differences. */
double plausible_deviation(const struct plausible *f);

#endif
