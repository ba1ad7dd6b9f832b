/* The command line, the environment and the exit statuses of the program, as
 * data for getopt, --help, the manual and shell completion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_USAGE_H
#define TIPSPEED_CMD_LANG_USAGE_H

#include <stdio.h>

#include "cmd/lang/command.h"

/* A command-line option.  code: the value that getopt_long returns, which is
 * its letter if it has one.  argument: name of the argument in the usage text,
 * or NULL.  choices: values of the argument, separated by spaces, or NULL. */
struct usage_option {
	int code;
	const char *name, *argument, *choices, *brief;
};

enum {
	USAGE_FORMAT = 256,
	USAGE_SEED,
	USAGE_STORE,
	USAGE_LANG,
	USAGE_SAFE,
	USAGE_COLOR,
	USAGE_LINEAR,
	USAGE_RESET_TTY
};

/* Ends with a code of 0.  An option without a name has only its letter. */
extern const struct usage_option USAGE_OPTIONS[];

/* A variable, an exit status or a light with its meaning; lists end with a NULL
 * name. */
struct usage_word {
	const char *name, *meaning;
};

extern const struct usage_word USAGE_ENVIRONMENT[], USAGE_STATUS[],
    USAGE_TRUST[];

/* Prints the list of commands of one group, or of all groups for NULL. */
void usage_print_command_list(const char *group, FILE *out);

/* Prints the options that many commands share. */
void usage_print_shared_options(FILE *out);

/* Explains the light at the end of answers. */
void usage_print_trust_lights(FILE *out);

/* Print a command on one line; everything in the table about it; the lines of
 * its example, each after the margin. */
void usage_print_brief(const struct command *command, FILE *out);
void usage_print_command_help(const struct command *command, FILE *out);
void usage_print_example(
    const struct command *command, const char *margin, FILE *out);

/* Prints the text of --help. */
void usage_print_program_help(FILE *out);

#endif
