/* Moves that know how the chains lie.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_GUIDE_H
#define TIPSPEED_CORE_POSTERIOR_GUIDE_H

#include <stddef.h>
#include <stdint.h>

#include "core/numeric/rng.h"

/* Mean and covariance of `size` coordinates, over the generations that it was
 * told of; those before count less. */
enum { GUIDE_MOST = 24 };
struct guide {
	double n, origin[GUIDE_MOST];
	double mean[GUIDE_MOST], cross[GUIDE_MOST][GUIDE_MOST];
};

/* Tells it of a generation: x [chains], each [size].
 * most: as so many generations count all, at most. */
void guide_add(struct guide *g, const double *const *x, size_t chains,
    size_t size, double most);

/* Some of the coordinates, those that vary, with the factor of their
 * covariance. */
struct guide_part {
	size_t n, at[GUIDE_MOST];
	double mean[GUIDE_MOST], L[GUIDE_MOST][GUIDE_MOST];
};
void guide_factor(
    const struct guide *g, const size_t *at, size_t n, struct guide_part *part);

/* Seen along L coordinates are independent and standard normal, were all as
 * normal as they are taken for: of these it draws each anew with probability
 * `share`, from x to y.  Takes 2 n random numbers of the key from `next` on.
 * Returns ln N(y) - ln N(x), which the probability of a move has to make up
 * for. */
double guide_move(const struct guide_part *part, double share, const double *x,
    double *y, struct rng_key key, uint32_t next);

#endif
