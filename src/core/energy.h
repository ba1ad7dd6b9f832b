/* Energy of an impact (Eq 4) and the smallest size it breaks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ENERGY_H
#define TIPSPEED_CORE_ENERGY_H

#include "core/params.h"

/* Specific energy of a particle thrown at tip speed v.
 *   E = v^2 / 2
 * v rotor tip speed, m/s.  Returns J/kg.   Source: paper Eq 4. */
double energy_specific(double v);

/* Break size x*: the smallest size that can break at tip speed v, as the
 * parameters' model has it.
 * v m/s.  Returns m: 0 where every size breaks, INFINITY where none does. */
double energy_break_size(const struct params *p, double v);

#endif
