/* Eq 4 and what follows from it for a size.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/energy.h"

#include "core/breakage.h"

double
energy_specific(double v)
{
	return v * v / 2;
}

double
energy_break_size(const struct params *p, double v)
{
	return breakage_of(p)->break_size(p, energy_specific(v));
}
