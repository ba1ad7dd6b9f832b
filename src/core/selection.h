/* Selection (Eq 3): which fraction of each size breaks.  The search
 * has it for lanes, in kernel_body.h; test_kernel holds the two together.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SELECTION_H
#define TIPSPEED_CORE_SELECTION_H

#include "core/elementary.h"

/* Selection: fraction of a size that breaks in k impacts.
 *   S = 1 - exp(-f_mat k (x^alpha E - E0_min)), 0 where the bracket is negative
 * q f_mat, e0_min, alpha; k number of impacts, >= 0; E specific energy, J/kg;
 * log_x ln of the size in m.  d [3]: its derivatives by q are added; or NULL.
 * Returns S in [0, 1].  Cannot fail.   Source: paper Eq 3.
 * D1: the minus sign and the floor at 0 are missing in print.
 * D2: x is in metres; in millimetres S would be 1 for every class. */
static inline double
selection(const double q[static 3], double k, double E, double log_x, double *d)
{
	double w = el_exp(q[2] * log_x), f = q[0] * k;
	double over = w * E - q[1];
	if (!(over > 0))
		return 0;
	double S = -el_expm1(-f * over), kept = 1 - S;
	if (d != NULL) {
		d[0] += k * over * kept;
		d[1] += -f * kept;
		d[2] += f * E * w * log_x * kept;
	}
	return S;
}

/* ln x at which the exponent f_mat k (x^alpha E - E0_min) reaches the value
 * given; -1000 or 1000 where no size of this world has it. */
double selection_size_at(
    const double q[static 3], double k, double E, double exponent);

/* Break size: where S begins.
 *   x* = (E0_min / E)^(1 / alpha)
 * Returns m: 0 where every size breaks, INFINITY where none does (as with
 * alpha = 0 and E <= E0_min).   Source: Eq 3 at S = 0. */
double selection_break_size(const double q[static 3], double E);

/* Eq 3 with its numbers; the caller frees. */
char *selection_text(const double q[static 3], double k);

#endif
