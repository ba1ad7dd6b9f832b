/* The generated parts of the manual.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_MANUAL_H
#define TIPSPEED_CMD_MANUAL_H

#include <stdio.h>

/* The COMMANDS section of tipspeed(1) in mdoc, from the command table. */
void manual_commands(FILE *out);

/* The items of the ENVIRONMENT and EXIT STATUS lists. */
void manual_environment(FILE *out);
void manual_status(FILE *out);

#endif
