/* Selection (Eq 3): which fraction of each size breaks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SELECTION_H
#define TIPSPEED_CORE_SELECTION_H

#include <stddef.h>

#include "core/params.h"

/* Selection: fraction of each size that breaks in k impacts.
 *   S_i = 1 - exp(-f_mat k (x_i^alpha E - E0_min)), 0 where the bracket is
 *   negative
 * p parameters; k number of impacts, >= 0; E specific energy, J/kg;
 * x [n] sizes, m, > 0; S [n] out, in [0, 1].
 * Cannot fail.   Source: paper Eq 3.
 * D1: the minus sign and the floor at 0 are missing in print.
 * D2: x is in metres; in millimetres S would be 1 for every class. */
void selection(const struct params *p, double k, double E, const double *x,
    size_t n, double *S);

#endif
