/* Feeds mixed by mass.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_BLEND_H
#define TIPSPEED_CORE_PSD_BLEND_H

#include "core/psd/psd.h"

/* The blend of feeds [n], each passing 1 on its coarsest sieve, in parts by
 * mass > 0 of any sum.  Its sieves are those of all feeds, coarsest first, as
 * far down as every feed is known: that of the coarsest finest sieve, unless a
 * feed passes nothing there.  Between its sieves a feed is straight on log
 * size.  psd_free. */
struct psd blend_new(
    const struct psd *const *feed, const double *part, size_t n);

#endif
