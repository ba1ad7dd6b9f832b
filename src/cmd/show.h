/* show: the site in use, its curves and what the model makes of them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHOW_H
#define TIPSPEED_CMD_SHOW_H

#include <stdbool.h>

#include "cmd/command.h"
#include "cmd/session.h"

bool cmd_show(struct session *, const struct args *, struct error *);

/* The parts of show that take the model apart; they need a site. */
bool show_model(struct session *, const struct args *, struct error *);
bool show_selection(struct session *, const struct args *, struct error *);
bool show_appearance(struct session *, const struct args *, struct error *);

/* Where the store is and what it holds. */
bool show_store(struct session *, const struct args *, struct error *);

#endif
