/* The inverse of a prediction: the tip speed that gives a wanted product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_INVERSE_H
#define TIPSPEED_CORE_INVERSE_H

#include <stdbool.h>
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

/* Where a function that never falls with the speed crosses 0, between the
 * speeds from and to, m/s: the slowest speed at which it is 0 or more, to
 * 1e-9 m/s.  `from` where it is 0 or more there already, INFINITY where it is
 * below 0 even at `to`.  Passing never falls with the speed, so that what is
 * wanted of a product can be put so. */
double inverse_speed(
    double (*rises)(void *data, double v), void *data, double from, double to);

/* A grading envelope on the inverse's sieves, [n] each, passing 0..1; NAN where
 * there is no limit. */
struct envelope {
	const double *least, *most;
};

/* Where the product lies in an envelope: from slowest to fastest.  inside:
 * there is such a speed.  Where there is none, nearest is the speed that misses
 * it least, by `by` (passing, 0..1; above 0: too fine, below: too coarse) at
 * the sieve of index `worst`. */
struct window {
	bool inside;
	double slowest, fastest, nearest, by;
	size_t worst;
};

struct window inverse_window(struct inverse *inverse,
    const struct envelope *envelope, double from, double to);

/* How far the product at speed v lies out of the envelope, as `by` above: that
 * of the worst sieve; 0 inside. */
double inverse_outside(struct inverse *inverse, const struct envelope *envelope,
    double v, size_t *worst);

/* The share of the draws that lie in the envelope at speed v; NAN of a model
 * alone. */
double inverse_certainty(
    struct inverse *inverse, const struct envelope *envelope, double v);

/* The middle `level` (0..1) of the speeds at which the draws pass so much at
 * size x, between the speeds from and to: 0 and INFINITY where they do so below
 * and above these.  NAN of a model alone. */
void inverse_range(struct inverse *inverse, double x, double passing,
    double from, double to, double level, double range[static 2]);

#endif
