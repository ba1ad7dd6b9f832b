/* Texts generated from the tables at build time: parts of the manual, and shell
 * completion of the command line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_MANUAL_H
#define TIPSPEED_CMD_LANG_MANUAL_H

#include <stdio.h>

/* Prints the COMMANDS section of tipspeed(1) in mdoc, from the command
 * table. */
void manual_commands(FILE *out);

/* Print the items of ENVIRONMENT and EXIT STATUS, and of TRUST in
 * tipspeed-model(7). */
void manual_environment(FILE *out);
void manual_status(FILE *out);
void manual_trust(FILE *out);

/* Prints the breakage models, each with its parameters. */
void manual_models(FILE *out);

/* manual_texts prints the tables' texts for people, and manual_text any other
 * text, as C for xgettext. */
void manual_texts(FILE *out);
void manual_text(const char *text, FILE *out);

/* Prints a file for bash-completion: command-line options with their arguments,
 * commands after -c, and files. */
void manual_bash(FILE *out);

#endif
