/* What errors of the stated tip speeds do to an answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_SPEED_ERROR_H
#define TIPSPEED_CORE_ANSWER_SPEED_ERROR_H

#include "core/psd/site.h"

/* By how many times the error of one stated speed the answer at tip speed v is
 * off, in speed: those of the runs count as in a straight line through them, in
 * v^2, and that of v itself comes on top:
 *   sqrt(1 + 1/n + (v^2 - m)^2 / sum (v_i^2 - m)^2),   m the mean of the v_i^2
 * Infinite where all runs have one speed and v is another. */
double speed_error_times(const struct site *site, double v);

#endif
