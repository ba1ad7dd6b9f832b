/* How many of the draws are straight between two measured speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_STRAIGHT_H
#define TIPSPEED_CORE_POSTERIOR_STRAIGHT_H

#include "core/posterior/draws.h"
#include "core/psd/psd.h"

/* D25: between two measured speeds an answer is an average over two ways in
 * which the truth may continue: as the draws have it, or along their straight
 * lines in v^2.  A share q of the draws are, with P the product as drawn,
 *   P(v_a) + (P(v_b) - P(v_a)) (v^2 - v_a^2) / (v_b^2 - v_a^2)
 * through the next measured speeds below and above, all others P(v).  The
 * weights are those by which two estimates are averaged best,
 *   q = 0.75 missed^2 / (missed^2 + 0.15^2)
 *   missed^2 = sum (change of the correction)^2 / sum (change of the answer)^2
 * over the sieves and from each measured speed to the next, by the means of the
 * draws: between two measured speeds a model errs in proportion to the share of
 * the change that it misses from one to the other; the straight line errs by
 * the bend of the truth, for which 0.15 stands.  A quarter of the draws stay
 * however wrong the model is, as the line may be as wrong, so that the band
 * holds both.  At the measured speeds and beyond them nothing changes; anything
 * that rises with the speed still rises. */

/* Returns q for a feed at sieves [n], coarsest first; 0 with fewer than two
 * speeds. */
double straight_share(const struct posterior *p, const struct psd *feed,
    const double *sieve, size_t n);

#endif
