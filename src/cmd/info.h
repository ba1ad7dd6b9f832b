/* Commands about the program: help, apropos, man, version, quit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_INFO_H
#define TIPSPEED_CMD_INFO_H

#include <stdbool.h>
#include <stdio.h>

#include "cmd/command.h"
#include "cmd/session.h"

bool cmd_help(struct session *, const struct args *, struct error *);
bool cmd_apropos(struct session *, const struct args *, struct error *);
bool cmd_man(struct session *, const struct args *, struct error *);
bool cmd_version(struct session *, const struct args *, struct error *);
bool cmd_quit(struct session *, const struct args *, struct error *);

/* The list of commands by group; of one group, or of all for NULL. */
void info_list(const char *group, FILE *out);

/* All that the table says of one command. */
void info_command(const struct command *command, FILE *out);

#endif
