/* Feeds mixed by mass, and the mean of several feeds, which answers a question
 * that names no feed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_BLEND_H
#define TIPSPEED_CORE_PSD_BLEND_H

#include <stddef.h>

#include "core/psd/psd.h"

/* Returns the sieves of all curves [n], coarsest first, each once, with
 * passings of 0.  Free with psd_free. */
struct psd blend_list_sieves(const struct psd *const *curve, size_t n);

/* Returns the blend of feeds [n], each passing 1 on its coarsest sieve, in
 * parts by mass, each > 0, with any sum.  Its sieves are those of all feeds,
 * coarsest first, down to the size at which every feed is known: the coarsest
 * of the feeds' finest sieves, ignoring feeds that pass nothing there.  Each
 * feed is interpolated linearly in log size.  Free with psd_free. */
struct psd blend_new(
    const struct psd *const *feed, const double *part, size_t n);

/* Returns the mean of feeds [n], each passing 1 at its coarsest sieve;
 * identical feeds count once (D19).  Its sieves are those of all the feeds.
 * Each feed is interpolated linearly in log size between its own sieves; below
 * its finest it is assumed to fall as the others do on average, so a sheet that
 * ends early does not cut off the fines of the mean.  Free with psd_free. */
struct psd blend_mean_of_feeds(const struct psd *const *feed, size_t n);

/* Returns the largest difference in passing, 0..1, between any two of the feeds
 * at a sieve at which both are known, or 0 if there is no such sieve.  Sets
 * *sieve to that sieve, m, or to 0. */
double blend_largest_feed_difference(
    const struct psd *const *feed, size_t n, double *sieve);

#endif
