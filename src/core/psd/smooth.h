/* The distance of a point of a curve from its neighbours.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_SMOOTH_H
#define TIPSPEED_CORE_PSD_SMOOTH_H

#include <stddef.h>

#include "core/psd/psd.h"

/* Returns the passing at sieve i less the passing of the straight line, on log
 * size, between its two neighbours: -1..1; NAN at the two ends, which have one
 * neighbour. */
double smooth_bend(const struct psd *psd, size_t i);

/* The most unusual point of n curves: its curve bends there unlike the other
 * curves at the same three sieves.  A true curve may bend by 10 points and more
 * (at its top size, at the break size), but curves of one crusher do so
 * together, and a typing error occurs in one curve alone.  off: its bend less
 * the mean bend of the others, passing -1..1; 0 where no point can be checked.
 * others: their number; where it is 0, off is the bend itself.  Of two curves
 * that differ, the curve with the larger bend is returned. */
struct smooth_outlier {
	size_t curve, sieve, others;
	double off;
};

struct smooth_outlier smooth_outlier(const struct psd *const *curve, size_t n);

#endif
