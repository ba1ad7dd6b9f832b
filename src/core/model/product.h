/* Product (Eq 2): the material that leaves the crusher, for a feed and a tip
 * speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_PRODUCT_H
#define TIPSPEED_CORE_MODEL_PRODUCT_H

#include <stdbool.h>
#include <stddef.h>

#include "core/model/params.h"
#include "core/psd/psd.h"

/* A workspace that turns parameters into products of one feed on a fixed list
 * of sieves.  Set the parameters once, then compute the product at any speed.
 * Neither step can fail, and only the first product allocates.
 *
 * Method `continuous`: with the feed linear in log size between its sieves,
 *   P(s) = F(s) + integral over x > s of S(x) B(s/x) dF(x)
 * the limit of Eq 2 for fine classes.  S is integrated by Gauss-Legendre on
 * panels that end at every sieve, at the break size and at a few values of the
 * exponent.  In the paper's model, B between the zeros of p(u) is a combination
 * of 1, 1/x, 1/x^2, 1/x^3 and ln x (breakage_grunditz.c), with an error below
 * 1e-7 (tested against 1e-6); the other models tabulate B (tested against
 * 1e-5).
 *
 * Method `classes`: the paper to the letter, P = B S f + (I - S) f on the
 * classes of the feed's sieves.  The size of a class is the geometric mean of
 * its sieves, that of the pan half the finest sieve (D5); passings at other
 * sieves are interpolated linearly in log size. */
struct model;

/* feed: passes 1 on its coarsest sieve (asserted); copied.  sieve [n] m, in any
 * order; each must be covered by the feed (psd_covers_size). */
struct model *model_new(const struct psd *feed, const double *sieve, size_t n,
    struct model_settings settings);
void model_free(struct model *model);

void model_set_params(struct model *model, const struct params *p);

/* Computes the product's passing [n], 0..1, sieve by sieve, at tip speed v
 * (m/s).
 *   Source: paper Eq 2. */
void model_compute_product(struct model *model, double v, double *passing);

/* As model_compute_product, and computes d_passing [n * model's n]: a row for
 * each sieve, with the derivatives with respect to the parameters in the order
 * of their table.  Exact for `continuous`, central differences for `classes`.
 */
void model_jacobian(
    struct model *model, double v, double *passing, double *d_passing);

/* False if product = feed at v because no particle has progeny in another class
 * (`classes`) or p(u) is 0 everywhere (`continuous`). */
bool model_is_feed_broken(struct model *model, double v);

/* Returns the mass fraction of the feed that is selected for breakage at v,
 * 0..1, not counting the share that bypasses the rotor. */
double model_broken_feed_share(struct model *model, double v);

#endif
