/* Texts generated from the tables at build time: parts of the manual, and shell
 * completion of the command line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_MANUAL_H
#define TIPSPEED_CMD_LANG_MANUAL_H

#include <stdio.h>

/* Prints the COMMANDS section of tipspeed(1) in mdoc, from the command
 * table. */
void manual_print_commands(FILE *out);

/* Print the items of ENVIRONMENT and EXIT STATUS, and of TRUST in
 * tipspeed-model(7). */
void manual_print_environment(FILE *out);
void manual_print_exit_status(FILE *out);
void manual_print_trust_lights(FILE *out);

/* Prints the breakage models, each with its parameters. */
void manual_print_models(FILE *out);

/* manual_print_texts_for_xgettext prints the tables' texts for people, and
 * manual_print_text_for_xgettext any other text, as C for xgettext. */
void manual_print_texts_for_xgettext(FILE *out);
void manual_print_text_for_xgettext(const char *text, FILE *out);

/* Prints a file for bash-completion: command-line options with their arguments,
 * commands after -c, and files. */
void manual_print_bash_completion(FILE *out);

#endif
