/* assert: a plant check in a script.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASSERT_H
#define TIPSPEED_CMD_ASSERT_H

#include <stdbool.h>

#include "cmd/command.h"
#include "cmd/session.h"

bool cmd_assert(struct session *, const struct args *, struct error *);

/* What an assertion may name, from index 0; NULL behind the last. */
const char *assert_name(size_t index);

#endif
