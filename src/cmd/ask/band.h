/* How far a fit and its products are open, as commands say it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_BAND_H
#define TIPSPEED_CMD_ASK_BAND_H

#include "cmd/session/session.h"
#include "core/answer/predict.h"

/* The middle of the draws of parameter j of a fit's model, widened to hold the
 * fit's value. */
void band_parameter(const struct posterior *p, const struct session *s,
    const struct params *fit, size_t j, double range[static 2]);

/* Puts "interval": {"beta1":[low, high], .. "alpha":[low, high]}, or null where
 * there is none. */
void band_put_interval(struct fields *o, const struct session *s,
    const struct posterior *posterior, const struct params *fit);

/* Puts the ranges of the sizes, "level" and which runs inform the answer. */
void band_put(
    struct fields *o, const struct session *s, const struct prediction *p);

#endif
