/* Moves of the chains by the covariance of earlier generations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_GUIDE_H
#define TIPSPEED_CORE_POSTERIOR_GUIDE_H

#include <stddef.h>
#include <stdint.h>

#include "core/numeric/rng.h"

/* Mean and covariance of `size` coordinates over the generations added; earlier
 * ones count less. */
enum { GUIDE_MOST = 24 };
struct guide {
	double n, origin[GUIDE_MOST];
	double mean[GUIDE_MOST], cross[GUIDE_MOST][GUIDE_MOST];
};

/* Adds a generation: x [chains], each [size].  most: all generations together
 * count as at most so many. */
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

/* In the basis of L coordinates would be independent and standard normal, if
 * all were normal: each of these is drawn anew with probability `share`, from x
 * to y.  Takes 2 n random numbers of the key from `next` on.  Returns ln N(y) -
 * ln N(x), which the acceptance of the move corrects for. */
double guide_move(const struct guide_part *part, double share, const double *x,
    double *y, struct rng_key key, uint32_t next);

#endif
