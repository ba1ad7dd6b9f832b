/* Products of one feed, to be asked at many speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_INVERSE_H
#define TIPSPEED_CORE_INVERSE_H

#include <stddef.h>

#include "core/ensemble.h"
#include "core/params.h"
#include "core/psd.h"

/* The products of one feed on a list of sieves, to be asked at many speeds: of
 * a model alone, or the mean of a posterior's draws.  product: its sieves, and
 * the passings at the speed asked for last. */
struct inverse {
	struct model *model;
	struct ensemble *ensemble; /* NULL: the model alone */
	struct psd product;
};

/* sieve [n] m, coarsest first, each covered by the feed.  posterior: NULL for
 * the model alone; else it must outlive the inverse. */
struct inverse inverse_new(const struct psd *feed, const double *sieve,
    size_t n, const struct params *p, struct model_settings settings,
    const struct posterior *posterior);
void inverse_free(struct inverse *inverse);

/* The product at speed v, m/s; borrowed. */
const struct psd *inverse_at(struct inverse *inverse, double v);

#endif
