/* Commands about the model: params, bounds, set, seed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_MODEL_H
#define TIPSPEED_CMD_MODEL_H

#include <stdbool.h>

#include "cmd/command.h"
#include "cmd/session.h"

bool cmd_params(struct session *, const struct args *, struct error *);
bool cmd_bounds(struct session *, const struct args *, struct error *);
bool cmd_set(struct session *, const struct args *, struct error *);
bool cmd_seed(struct session *, const struct args *, struct error *);

#endif
