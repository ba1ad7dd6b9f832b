/* Eq 4 and what follows from it for a size.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/energy.h"

#include <math.h>

#include "core/elementary.h"

double
energy_specific(double v)
{
	return v * v / 2;
}

double
energy_break_size(const struct params *p, double v)
{
	double E = energy_specific(v);
	if (p->e0_min <= 0)
		return E > 0 ? 0 : INFINITY;
	if (E <= 0)
		return INFINITY;
	double log_ratio = el_log(p->e0_min / E);
	if (p->alpha * 700 <= fabs(log_ratio))
		return log_ratio < 0 ? 0 : INFINITY;
	return el_exp(log_ratio / p->alpha);
}
