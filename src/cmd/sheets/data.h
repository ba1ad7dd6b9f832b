/* Commands about sheets: load, sites, use, check, synth, write.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_DATA_H
#define TIPSPEED_CMD_SHEETS_DATA_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/session/session.h"

/* False, with an error, where a file is there already and the call does not say
 * replace=on, or where it is none to be replaced, see files.h. */
bool data_may_write(const struct session *s, const struct args *args,
    const char *path, struct error *error);

#endif
