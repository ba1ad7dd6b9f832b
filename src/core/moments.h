/* The products of the paper's model from a few integrals of S dF, which spares
 * evaluating B; used through its row of BREAKAGES.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MOMENTS_H
#define TIPSPEED_CORE_MOMENTS_H

#include "core/continuous.h"

/* Room for n edges; free() it. */
struct moments *moments_new(size_t n);

/* See breakage.h, product.  own of the breaker is a struct appearance of beta
 * scaled to 1. */
void moments_product(struct continuous *c, double *passing, double *d_passing);

#endif
