/* show: the site in use, its curves and what the model makes of them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHOW_H
#define TIPSPEED_CMD_SHOW_H

#include <stdbool.h>

#include "cmd/command.h"
#include "cmd/session.h"

/* The parts of show that take the model apart; they need a site. */
command_run show_model, show_selection, show_appearance;

/* Where the store is and what it holds. */
command_run show_store;

#endif
