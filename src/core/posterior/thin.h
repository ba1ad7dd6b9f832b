/* Thinning: a few draws that represent many.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_THIN_H
#define TIPSPEED_CORE_POSTERIOR_THIN_H

#include <stddef.h>

#include "core/posterior/draws.h"
#include "core/psd/site.h"

/* Candidates come in batches of POSTERIOR_DRAWS; of all candidates,
 * POSTERIOR_DRAWS are kept.  Free with thin_free. */
struct thin;
struct thin *thin_new(const struct site *site, size_t batches);
void thin_free(struct thin *t);

/* Adds the next batch with its answers at sieves of the site and at five speeds
 * across site_default_speed_range. */
void thin_add_posterior_batch(struct thin *t, const struct posterior *batch);

/* Chooses the draws to keep, half of them from the first half of the batches,
 * and returns their indices in the sequence of all batches.  They have the same
 * mean answers as all draws and the same share of answers on either side of
 * each end of the usual band. */
void thin_choose_draws(struct thin *t, size_t chosen[static POSTERIOR_DRAWS]);

/* Sets the share q of the kept draws that are linear between measured speeds.
 *
 * D25: between two measured speeds, an answer averages two possible courses of
 * the truth: as drawn, or along a straight line in v^2.  With P the product as
 * drawn, a share q of the draws are
 *   P(v_a) + (P(v_b) - P(v_a)) (v^2 - v_a^2) / (v_b^2 - v_a^2)
 * through the next measured speeds below and above; all others are P(v).  The
 * weights are the best for an average of two estimates,
 *   q = 0.75 missed^2 / (missed^2 + 0.15^2)
 *   missed^2 = sum (change of the correction)^2 / sum (change of the answer)^2
 * over the sieves and from each measured speed to the next, using the means of
 * the draws.  Between two measured speeds, a model errs in proportion to the
 * share of the change between them that it misses; the straight line errs by
 * the curvature of the truth, for which 0.15 stands.  However wrong the model
 * is, a quarter of the draws stay as drawn, because the line may be equally
 * wrong; the band then covers both.  Nothing changes at and beyond the measured
 * speeds, and passings still do not fall with the speed. */
void thin_set_linear_draw_share(const struct thin *t, struct posterior *p);

#endif
