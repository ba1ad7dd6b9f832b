/* Feeds mixed by mass, and the mean of several feeds, which a question uses
 * where it names no feed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_BLEND_H
#define TIPSPEED_CORE_PSD_BLEND_H

#include <stddef.h>

#include "core/psd/psd.h"

/* Returns the blend of feeds [n], each passing 1 on its coarsest sieve, in
 * parts by mass > 0 of any sum.  Its sieves are those of all feeds, coarsest
 * first, as far down as every feed is known: to the coarsest of the finest
 * sieves, unless a feed passes nothing there.  Between its sieves a feed is
 * interpolated linearly in log size.  Free with psd_free. */
struct psd blend_new(
    const struct psd *const *feed, const double *part, size_t n);

/* Returns the mean of feeds [n], each passing 1 at its coarsest sieve;
 * identical feeds count once (D19).  Its sieves are those of all the feeds.
 * Between its own sieves each feed is interpolated linearly in log size; below
 * its finest it is taken to fall as the others do there on average, so that a
 * sheet that ends early does not cut off the fines of the mean.  Free with
 * psd_free. */
struct psd blend_mean(const struct psd *const *feed, size_t n);

/* Returns the largest difference in passing, 0..1, between any two of the feeds
 * at a sieve at which both are known; sieve: that sieve, m, out.  0 where there
 * are none. */
double blend_spread(const struct psd *const *feed, size_t n, double *sieve);

#endif
