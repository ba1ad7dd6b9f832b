/* Completion of the program's command line by the shell.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHELL_H
#define TIPSPEED_CMD_SHELL_H

#include <stdio.h>

/* A file for bash-completion: the options of the command line with what they
 * take, the commands behind -c, and files. */
void shell_bash(FILE *out);

#endif
