/* The reference feed of a question: the mean of those sampled.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_REFERENCE_H
#define TIPSPEED_CORE_PSD_REFERENCE_H

#include <stddef.h>

#include "core/psd/psd.h"

/* The mean of feeds [n], each passing 1 at its coarsest sieve; identical ones
 * count once (D19).  Its sieves are those of all of them; a feed is read
 * straight on log size between its own sieves, and below its finest falls as
 * the others do on average, so that a short sheet does not cut off the fines of
 * all.  psd_free. */
struct psd reference_mean(const struct psd *const *feed, size_t n);

/* The largest difference in passing, 0..1, between any two of the feeds at a
 * sieve that both know, and that sieve, m; 0 where there are none. */
double reference_spread(const struct psd *const *feed, size_t n, double *sieve);

#endif
