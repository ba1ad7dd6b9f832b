/* Feeds mixed by mass, and the mean of several, which a question has where none
 * is named.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_BLEND_H
#define TIPSPEED_CORE_PSD_BLEND_H

#include <stddef.h>

#include "core/psd/psd.h"

/* The blend of feeds [n], each passing 1 on its coarsest sieve, in parts by
 * mass > 0 of any sum.  Its sieves are those of all feeds, coarsest first, as
 * far down as every feed is known: that of the coarsest finest sieve, unless a
 * feed passes nothing there.  Between its sieves a feed is straight on log
 * size.  psd_free. */
struct psd blend_new(
    const struct psd *const *feed, const double *part, size_t n);

/* The mean of feeds [n], each passing 1 at its coarsest sieve, of which those
 * that are the same count once (D19).  Its sieves are those of all of them; a
 * feed is read straight on log size between its own, and below its finest as
 * the others fall there on average, so that a short sheet does not cut the
 * fines of all.  psd_free. */
struct psd blend_mean(const struct psd *const *feed, size_t n);

/* The largest difference in passing, 0..1, between any two of the feeds at a
 * sieve that both know, and that sieve, m; 0 where there are none. */
double blend_spread(const struct psd *const *feed, size_t n, double *sieve);

#endif
