/* Moves for the chains, guided by the covariance of earlier generations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_GUIDE_H
#define TIPSPEED_CORE_POSTERIOR_GUIDE_H

#include <stddef.h>
#include <stdint.h>

#include "core/numeric/rng.h"

/* Mean and covariance of `size` coordinates over the n generations added.  Both
 * are about an origin, to avoid a loss of digits. */
enum { GUIDE_MOST = 24 };
struct moments {
	double mean[GUIDE_MOST], cross[GUIDE_MOST][GUIDE_MOST];
};
struct guide {
	size_t size;
	double n, origin[GUIDE_MOST];
	struct moments of;
};
void guide_init(struct guide *g, size_t size, const double *origin);

/* Adds a generation with a weight.  x [chains]: the coordinates [size] of each
 * chain.  keep: the factor by which earlier generations lose weight. */
void guide_add_generation(struct guide *g, const double *const *x,
    size_t chains, double weight, double keep);

/* Adds the moments of another guide with the same origin, with the weight of
 * `generations` generations. */
void guide_merge_moments(
    struct guide *g, const struct guide *other, double generations);

/* A subset of the coordinates, without those that do not vary, and the factor
 * of their covariance. */
struct guide_subset {
	size_t n, at[GUIDE_MOST];
	double mean[GUIDE_MOST], L[GUIDE_MOST][GUIDE_MOST];
};
void guide_factor_subset(const struct guide *g, const size_t *at, size_t n,
    struct guide_subset *part);

/* Proposes a move from x to y.  In the basis of L, normally distributed
 * coordinates would be independent and standard normal; each is redrawn with
 * probability `share`.  Uses 2 n random numbers of the stream, starting at
 * number `next`.  Returns ln N(y) - ln N(x), which the acceptance of the move
 * must correct for. */
double guide_propose_mcmc_step(const struct guide_subset *part, double share,
    const double *x, double *y, struct rng_key key, uint32_t next);

/* Returns ln N(x), up to a constant. */
double guide_log_density(const struct guide_subset *part, const double *x);

#endif
