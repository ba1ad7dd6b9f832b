/* Finds the minimum of the misfit to the last bit, the same from every start.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_SETTLE_H
#define TIPSPEED_CORE_SEARCH_SETTLE_H

#include <stdbool.h>

#include "core/search/misfit.h"
#include "core/model/params.h"

/* Moves *p, a converged result of polish_minimise_misfit, to where the misfit's
 * gradient is 0.  Even a misfit exact to the last digit determines only half
 * the digits of the parameters; the gradient determines nearly all of them.
 * The last steps begin at parameters rounded to seven digits.  These are the
 * same for all starts, so the result is the same to the last bit.
 *
 * Parameters on a bound stay there, and the largest of the gauge (D4) does not
 * change.  Returns false and leaves *p unchanged if there is no such point
 * nearby: if the data do not determine a direction, at a crease of the misfit,
 * or if the misfit would be larger. */
bool settle_at_stationary_point(
    struct misfit *m, const struct bounds *bounds, struct params *p);

#endif
