/* Commands about the session itself: drop, reset, echo, timing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_MANAGE_H
#define TIPSPEED_CMD_MANAGE_H

#include <stdbool.h>

#include "cmd/command.h"
#include "cmd/session.h"

bool cmd_drop(struct session *, const struct args *, struct error *);
bool cmd_reset(struct session *, const struct args *, struct error *);
bool cmd_echo(struct session *, const struct args *, struct error *);
bool cmd_timing(struct session *, const struct args *, struct error *);

bool cmd_restore(struct session *, const struct args *, struct error *);

bool cmd_tui(struct session *, const struct args *, struct error *);

#endif
