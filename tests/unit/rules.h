/* The rules of psd.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_RULES_H
#define TIPSPEED_TESTS_RULES_H

#include <math.h>

#include "core/psd/psd.h"

/* Sizes fall and are above 0, passing lies within 0..1 and never rises. */
static inline bool
keeps_rules(const struct psd *psd)
{
	for (size_t i = 0; i < psd->n; i++) {
		double x = psd->size[i], p = psd->passing[i];
		if (!(x > 0 && isfinite(x)) || !(p >= 0 && p <= 1))
			return false;
		if (i > 0 && (x >= psd->size[i - 1] || p > psd->passing[i - 1]))
			return false;
	}
	return true;
}

#endif
