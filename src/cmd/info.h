/* Commands about the program: help, apropos, man, version, quit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_INFO_H
#define TIPSPEED_CMD_INFO_H

#include <stdio.h>

#include "cmd/command.h"
#include "cmd/session.h"

/* The list of commands by group; of one group, or of all for NULL. */
void info_list(const char *group, FILE *out);

/* The lines of its example, each behind the margin. */
void info_example(const struct command *command, const char *margin, FILE *out);

#endif
