/* Eq 3.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/selection.h"

#include <assert.h>

#include "core/elementary.h"

void
selection(const struct params *p, double k, double E, const double *x, size_t n,
    double *S)
{
	assert(k >= 0);
	for (size_t i = 0; i < n; i++) {
		assert(x[i] > 0);
		double over = el_pow(x[i], p->alpha) * E - p->e0_min;
		S[i] = over > 0 ? -el_expm1(-p->f_mat * k * over) : 0;
	}
}
