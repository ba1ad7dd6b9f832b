/* What runs have along their curves beyond what sampling errs by.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_LACK_OF_FIT_H
#define TIPSPEED_CORE_POSTERIOR_LACK_OF_FIT_H

#include "core/posterior/draws.h"
#include "core/search/misfit.h"

/* The discrepancy of D13 is smooth in the speed: a product that sets in, bends
 * or leaps between two runs is none of its draws, and what is left at the runs
 * would count as errors of their samples.  Of what the mean answer leaves at a
 * run, r [n] along its curve, coarsest first, the share
 *   (sum r_i r_i+1 - (2 sigma_s)^2 sum h_i h_i+1) / sum r_i^2,  0 to 1
 * is taken for the product's own (as James and Stein 1961 shrink means):
 * independent errors of neighbours cancel in the first sum, and the second has
 * what a sample may err by along its curve, twice the prior's sigma_s; of a
 * site with repeats, which show sigma_s, twice the mean of the draws'.
 *
 * Sets p->lack: that share, over h, at the measured speeds and the knots.
 * m: the runs that inform the draws. */
void lack_of_fit_find(struct posterior *p, const struct misfit *m);

#endif
