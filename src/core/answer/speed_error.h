/* The effect of errors in the stated tip speeds on an answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_SPEED_ERROR_H
#define TIPSPEED_CORE_ANSWER_SPEED_ERROR_H

#include "core/psd/site.h"

/* Returns the error in speed of the answer at tip speed v, in multiples of the
 * error of one stated speed: the errors of the runs, as in a straight line
 * through them in v^2, and the error of v itself:
 *   sqrt(1 + 1/n + (v^2 - m)^2 / sum (v_i^2 - m)^2),   m the mean of the v_i^2
 * Infinite where all runs have one speed and v is another. */
double speed_error_times(const struct site *site, double v);

#endif
