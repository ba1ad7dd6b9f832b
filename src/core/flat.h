/* Directions in which the data say next to nothing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_FLAT_H
#define TIPSPEED_CORE_FLAT_H

#include "core/misfit.h"
#include "core/params.h"

/* The direction in which the misfit rises least at a fitted point, to second
 * order. part [PARAMS_MOST]: how far each parameter goes along it, in shares of
 * its search range, for a rise of a tenth of the misfit; 0 for parameters that
 * are fixed or on a bound. reach: the longest of these steps. */
struct flat {
	double part[PARAMS_MOST];
	double reach;
};

/* The last direction of sensitivity.h.  Cannot fail. */
struct flat flat_direction(
    struct misfit *m, const struct params *p, const struct bounds *bounds);

#endif
