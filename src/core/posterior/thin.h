/* Thinning: a few draws that represent many.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_THIN_H
#define TIPSPEED_CORE_POSTERIOR_THIN_H

#include <stddef.h>

#include "core/posterior/draws.h"
#include "core/psd/site.h"

/* Candidates come in batches of POSTERIOR_DRAWS; POSTERIOR_DRAWS of them are
 * kept.  thin_free. */
struct thin;
struct thin *thin_new(const struct site *site, size_t batches);
void thin_free(struct thin *t);

/* Adds the next batch by its answers at five speeds, from the slowest to the
 * fastest of site_reach, at sieves of the site. */
void thin_add(struct thin *t, const struct posterior *batch);

/* Chooses the draws to keep: their indices out, counted from the first batch
 * on, half of them from the first half of the batches.  They have the mean
 * answers of all draws, and at each end of the usual band the same share of
 * answers on either side as all draws. */
void thin_choose(struct thin *t, size_t chosen[static POSTERIOR_DRAWS]);

/* Sets the share q of the draws kept that are straight, for the same feed and
 * sieves.
 *
 * D25: between two measured speeds an answer is an average over two ways in
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
void thin_set_straight(const struct thin *t, struct posterior *p);

#endif
