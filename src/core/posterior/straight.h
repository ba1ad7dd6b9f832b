/* How much of an answer between two measured speeds is the straight line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_STRAIGHT_H
#define TIPSPEED_CORE_POSTERIOR_STRAIGHT_H

#include "core/posterior/draws.h"
#include "core/psd/psd.h"

/* D25: between two measured speeds a draw is, with P its product as drawn,
 *   (1 - q) P(v) + q (P(v_a) + (P(v_b) - P(v_a)) (v^2 - v_a^2) /
 *       (v_b^2 - v_a^2))
 * its own straight line through the next measured speeds below and above, with
 * the weight q: evenly spread over the draws, from 0 to the largest,
 *   min(1, 5 missed),  missed^2 = sum (change of the correction)^2 /
 *       sum (change of the answer)^2
 * over the sieves and from each measured speed to the next, by the means of the
 * draws.  A model with an effect of the speed that must be corrected at the
 * measured speeds is not reliable between them.  At the measured speeds and
 * beyond them nothing changes; anything that rises with the speed still
 * rises. */

/* Returns the largest weight, for a feed at sieves [n], coarsest first; 0 with
 * fewer than two speeds. */
double straight_most(const struct posterior *p, const struct psd *feed,
    const double *sieve, size_t n);

#endif
