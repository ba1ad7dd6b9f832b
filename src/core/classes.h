/* The method `classes`; used through product.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CLASSES_H
#define TIPSPEED_CORE_CLASSES_H

#include <stdbool.h>

#include "core/params.h"
#include "core/psd.h"

struct classes;

/* See model_new. */
struct classes *classes_new(const struct psd *feed, const double *sieve,
    size_t n, struct model_settings settings);
void classes_free(struct classes *c);

/* See model_set, model_product, model_breaks and model_selected. */
void classes_set(struct classes *c, const struct params *p);
void classes_product(struct classes *c, double v, double *passing);
bool classes_breaks(const struct classes *c);
double classes_selected(struct classes *c, double v);

/* Sizes, m, of the n feed classes, coarsest first, the pan last (D5). */
void classes_sizes(const struct psd *feed, double *x);

#endif
