/* Feeds mixed by mass, and the mean of several feeds, which a question uses
 * where it names no feed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_BLEND_H
#define TIPSPEED_CORE_PSD_BLEND_H

#include <stddef.h>

#include "core/psd/psd.h"

/* Returns the blend of feeds [n], each passing 1 on its coarsest sieve, in
 * parts by mass > 0 of any sum.  Its sieves are the sieves of all feeds,
 * coarsest first, as far down as every feed is known: to the coarsest of the
 * finest sieves, unless a feed passes nothing there.  Between its sieves a feed
 * is straight on log size.  psd_free. */
struct psd blend_new(
    const struct psd *const *feed, const double *part, size_t n);

/* Returns the mean of feeds [n], each passing 1 at its coarsest sieve; equal
 * feeds count once (D19).  Its sieves are the sieves of all feeds.  A feed is
 * read straight on log size between its own sieves, and below its finest it
 * falls as the others do there on average, so that a short sheet does not cut
 * the fines of all.  psd_free. */
struct psd blend_mean(const struct psd *const *feed, size_t n);

/* Returns the largest difference in passing, 0..1, between any two of the feeds
 * at a sieve at which both are known; sieve: that sieve, m, out.  0 where there
 * are none. */
double blend_spread(const struct psd *const *feed, size_t n, double *sieve);

#endif
