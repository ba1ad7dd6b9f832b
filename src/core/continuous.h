/* The method `continuous`; used through product.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CONTINUOUS_H
#define TIPSPEED_CORE_CONTINUOUS_H

#include "core/appearance.h"
#include "core/params.h"
#include "core/psd.h"

struct continuous;

/* See model_new. */
struct continuous *continuous_new(
    const struct psd *feed, const double *sieve, size_t n, double k);
void continuous_free(struct continuous *c);

/* See model_set, model_jacobian (d_passing may be NULL) and model_selected. */
void continuous_set(struct continuous *c, const struct params *p);
void continuous_product(
    struct continuous *c, double v, double *passing, double *d_passing);
double continuous_selected(struct continuous *c, double v);

#endif
