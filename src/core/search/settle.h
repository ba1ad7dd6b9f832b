/* The bottom of a valley to the last digits, whoever came down to it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_SETTLE_H
#define TIPSPEED_CORE_SEARCH_SETTLE_H

#include <stdbool.h>

#include "core/search/misfit.h"
#include "core/model/params.h"

/* Moves *p, at rest within the bounds (polish.h), to where the misfit's
 * gradient is 0.  A misfit that is right to the last digit leaves half of
 * the digits of its parameters open; the gradient tells nearly all.  The last
 * of the way begins at parameters of seven digits, which are the same for
 * whoever comes near, so that what is found is the same to the last bit.
 *
 * Parameters on a bound stay there, and of the gauge (D4) the largest as it is.
 * False, and *p as it was, where no such place is found beside it: where data
 * leave a direction open, at a crease of the misfit, or where the misfit would
 * be larger. */
bool settle(struct misfit *m, const struct bounds *bounds, struct params *p);

#endif
