/* What is made from the tables at build time: parts of the manual, and
 * completion of the command line by the shell.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_MANUAL_H
#define TIPSPEED_CMD_LANG_MANUAL_H

#include <stdio.h>

/* The COMMANDS section of tipspeed(1) in mdoc, from the command table. */
void manual_commands(FILE *out);

/* The items of the ENVIRONMENT and EXIT STATUS lists. */
void manual_environment(FILE *out);
void manual_status(FILE *out);

/* The breakage models, each with its parameters. */
void manual_models(FILE *out);

/* The texts of the tables for people, and one of another, as C that xgettext
 * reads. */
void manual_texts(FILE *out);
void manual_text(const char *text, FILE *out);

/* A file for bash-completion: the options of the command line with what they
 * take, the commands after -c, and files. */
void manual_bash(FILE *out);

#endif
