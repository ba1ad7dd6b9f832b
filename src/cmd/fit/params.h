/* Parameters of a site that were not calibrated on it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_PARAMS_H
#define TIPSPEED_CMD_FIT_PARAMS_H

#include "cmd/session/session.h"

/* Names of the appearance forms, in the order of the enum. */
extern const char *const APPEARANCE_NAMES[3];

/* Gives a site parameters that were not fitted to it and takes ownership of the
 * share in their origin. */
void set_site_params(struct session *s, struct entry *entry,
    const struct params *p, struct origin *origin);

#endif
