/* The mass balance of a feed and its product, class by class.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_MASS_BALANCE_H
#define TIPSPEED_CORE_ANSWER_MASS_BALANCE_H

#include <stddef.h>

#include "core/model/params.h"
#include "core/psd/psd.h"

/* Class i lies between the feed's sieves i and i + 1; the last class passes the
 * finest sieve.  All arrays [n] are shares of the mass of the whole feed, 0..1:
 *   feed     = unbroken + within + left
 *   product  = unbroken + within + arrived
 * unbroken: did not break; within: broke but is still in the class; left: broke
 * into finer classes; arrived: came from coarser classes.  Feed and product
 * each add up to 1; left and arrived have equal sums. */
struct mass_balance {
	size_t n;
	double *feed, *unbroken, *within, *left, *arrived, *product;
	double broken; /* share of the whole feed that breaks */
};

/* Returns the mass balance of the model at tip speed v, m/s, computed class by
 * class, as Eq 2 is linear in the feed.  Free with mass_balance_free. */
struct mass_balance mass_balance_new(const struct psd *feed,
    const struct params *p, struct model_settings settings, double v);
void mass_balance_free(struct mass_balance *ledger);

/* Returns the index of the largest of a [n], or of a [n] - b [n] if b is not
 * NULL. */
size_t mass_balance_largest_class(const double *a, const double *b, size_t n);

#endif
