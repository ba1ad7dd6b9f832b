/* The part of the residuals along the curves that sampling errors do not
 * explain.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_LACK_OF_FIT_H
#define TIPSPEED_CORE_POSTERIOR_LACK_OF_FIT_H

#include "core/posterior/draws.h"
#include "core/search/misfit.h"

/* The discrepancy of D13 is smooth in speed.  No draw changes abruptly between
 * two runs, so if the true product does, the residuals at the runs would count
 * as sampling errors.  Of the residuals r [n] of the mean answer at a run,
 * coarsest sieve first, the share
 *   (sum r_i r_i+1 - (2 sigma_s)^2 sum h_i h_i+1) / sum r_i^2,  0 to 1
 * is attributed to the product instead (as James and Stein 1961 shrink means).
 * Independent errors of neighbours cancel in the first sum; the second sum is
 * the error that a sample may share along its curve.  sigma_s is the prior's
 * median or, at a site with repeats, which reveal it, the mean of the draws.
 *
 * Sets p->lack to this share of the residuals, over h, at the measured speeds
 * and the knots.  m: the runs that inform the draws. */
void lack_of_fit_compute(struct posterior *p, const struct misfit *m);

/* Adds to p->lack the smooth part of the residuals where the law is wrong.
 *
 * The less the model explains of the change with the speed, the more likely it
 * is that smooth residuals belong to the product and are not an error that a
 * sample shares along its curve.  Of the remaining residuals of all runs, the
 * share
 *   (1 - w^2) 2 sum r_i r_i+1 / sum r_i^2,  w = (0.75 - q) / 0.65,  0 to 1
 * is attributed to the product, where q is D25's (thin.h).  The share is 0 for
 * q up to 0.1, which plants that follow the model have.  Call after
 * thin_set_linear_draw_share. */
void lack_of_fit_add_smooth_part(struct posterior *p, const struct misfit *m);

#endif
