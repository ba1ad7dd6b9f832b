/* Screens: the part of a product in a fraction such as 0/4.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_SCREENING_H
#define TIPSPEED_CORE_PSD_SCREENING_H

#include <stdbool.h>
#include <stddef.h>

#include "core/psd/psd.h"

/* How well a screen separates: the share of size d in the oversize is
 *   E(d) = 1 - (e^a - 1) / (e^(a d / d50) + e^a - 2)
 * a the sharpness, d50 = cut_size times the opening, the size that is split in
 * half.  Source: Whiten's efficiency curve without water (Napier-Munn et al.
 * 1996, Mineral comminution circuits, ch. 9).  sharpness 0: an ideal screen,
 * that cuts at d50. */
struct partition {
	double sharpness, cut_size;
};
extern const struct partition PARTITION_IDEAL;

/* Returns E(d), 0..1, of the size d, m, on a screen with that opening, m. */
double partition_oversize(
    const struct partition *partition, double opening, double d);

/* The material that passes the screen `coarse` and stays on the screen `fine`,
 * m; 0: no such screen.  All zeros: the whole product. */
struct fraction {
	double fine, coarse;
	struct partition partition;
};

/* True if the fraction removes anything. */
bool fraction_screens(const struct fraction *fraction);

/* Computes the share of each class that a screen sends to the oversize.
 * Classes lie between sizes [n] m, coarsest first, with mass that is uniform in
 * ln d: class i between i and i + 1, the last is the pan, of half the finest
 * size.  out [n], 0..1. */
void partition_classes(const struct partition *partition, double opening,
    const double *size, size_t n, double *out);

/* Computes the share of each class that a fraction keeps, for classes as in
 * partition_classes. */
void fraction_classes(
    const struct fraction *fraction, const double *size, size_t n, double *out);

/* Computes the part of a product with the share `kept` [n] of each class:
 * writes its curve to part, of the same n.  Returns the share of the product's
 * mass; where that is 0 the curve is 0.  Mass above the coarsest size is kept
 * as the class below it. */
double screening_part(
    const struct psd *product, const double *kept, struct psd *part);

#endif
