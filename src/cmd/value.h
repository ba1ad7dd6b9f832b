/* Values of options, checked against their row of the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_VALUE_H
#define TIPSPEED_CMD_VALUE_H

#include <stdbool.h>

#include "base/error.h"
#include "cmd/command.h"

/* Reads word as the option's value, which borrows it; value->list is the
 * caller's.  False, with an error that says what was wanted and a hint at what
 * was meant. */
bool value_take(const struct command_option *option, const char *word,
    struct value *value, struct error *error);

/* The error that there is none.  Returns false. */
bool value_wanted(const struct command_option *option, struct error *error);

#endif
