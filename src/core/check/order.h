/* Whether two products contradict that a faster rotor breaks more (D23).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_ORDER_H
#define TIPSPEED_CORE_CHECK_ORDER_H

#include <stdbool.h>

#include "core/psd/psd.h"

/* By how much the slower run's product is finer than the faster run's, passing
 * 0..1.  most: the largest difference, at the sieve `at`, m; mean: over their
 * common sieves. */
struct order {
	double most, at, mean;
};
struct order order_of(const struct psd *slow, const struct psd *fast);

/* ORDER_NOTABLE: worth a remark, but sampling may explain it.  order_wrong:
 * more than sampling explains, at one sieve or in the mean.  Of 180 sheets with
 * a noise of 1 point, 29 exceed ORDER_NOTABLE somewhere, and 3 are called
 * wrong. */
#define ORDER_NOTABLE 0.02
bool order_wrong(const struct order *o);

#endif
