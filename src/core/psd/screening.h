/* Screens: the part of a product in a fraction such as 0/4.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_SCREENING_H
#define TIPSPEED_CORE_PSD_SCREENING_H

#include <stdbool.h>
#include <stddef.h>

#include "core/psd/psd.h"

/* How well a screen separates.  The share of the particles of size d that go to
 * the oversize is
 *   E(d) = 1 - (e^a - 1) / (e^(a d / d50) + e^a - 2)
 * where a is the sharpness and d50 = cut_size times the opening is the size
 * split in half.  Source: Whiten's efficiency curve without water (Napier-Munn
 * et al. 1996, Mineral comminution circuits, ch. 9).  sharpness 0: an ideal
 * screen, which cuts at d50. */
struct partition {
	double sharpness, cut_size;
};
extern const struct partition PARTITION_IDEAL;

/* Returns E(d), 0..1, for size d, m, on a screen with that opening, m. */
double partition_share_to_oversize(
    const struct partition *partition, double opening, double d);

/* The material that passes the screen `coarse` and stays on the screen `fine`,
 * m; 0 if there is no such screen.  All zeros: the whole product. */
struct fraction {
	double fine, coarse;
	struct partition partition;
};

/* True if the fraction removes anything. */
bool fraction_is_screened(const struct fraction *fraction);

/* Computes the share of each class that a screen sends to the oversize.  Class
 * i lies between size[i] and size[i + 1], with mass uniform in ln d; the last
 * is the pan, down to half the finest size.  size [n] m, coarsest first.  out
 * [n], 0..1. */
void partition_oversize_of_classes(const struct partition *partition,
    double opening, const double *size, size_t n, double *out);

/* Computes the share of each class that a fraction keeps, for classes as in
 * partition_oversize_of_classes. */
void fraction_share_of_each_class(
    const struct fraction *fraction, const double *size, size_t n, double *out);

/* Computes the part of a product that has the share `kept` [n] of each class
 * and writes its curve to part, which has the same n.  Returns its share of the
 * product's mass; if that is 0, the curve is 0.  Mass above the coarsest size
 * is kept like the class below it. */
double screening_compute_kept_part(
    const struct psd *product, const double *kept, struct psd *part);

#endif
