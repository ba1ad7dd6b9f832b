/* The options, environment variables and exit statuses of the program, as data
 * for getopt, --help, the manual and shell completion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_USAGE_H
#define TIPSPEED_CMD_LANG_USAGE_H

#include <stdio.h>

#include "cmd/lang/command.h"

struct usage_option {
	/* What getopt_long returns: the option's letter, if it has one. */
	int code;
	/* name: NULL if the option has only a letter.  argument: its name in
	 * the usage text, or NULL.  choices: the values that it may have,
	 * separated by spaces, or NULL. */
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

/* The last has a code of 0. */
extern const struct usage_option USAGE_OPTIONS[];

/* A variable, an exit status or a light, and what it means.  The last in a list
 * has a NULL name. */
struct usage_word {
	const char *name, *meaning;
};

extern const struct usage_word USAGE_ENVIRONMENT[], USAGE_STATUS[],
    USAGE_TRUST[];

/* Prints the list of the commands in a group, or in all groups if group is
 * NULL.  width: here and below, the columns that text is wrapped to. */
void usage_print_command_list(const char *group, int width, FILE *out);

/* Prints the options that many commands share. */
void usage_print_shared_options(int width, FILE *out);

/* Explains the light at the end of answers. */
void usage_print_trust_lights(int width, FILE *out);

/* usage_print_command_brief prints a command's name and what it does;
 * usage_print_command_help all that the table has about it; usage_print_example
 * the lines of its example, each after the margin. */
void usage_print_command_brief(
    const struct command *command, int width, FILE *out);
void usage_print_command_help(
    const struct command *command, int width, FILE *out);
void usage_print_example(
    const struct command *command, const char *margin, FILE *out);

/* Prints the text of --help. */
void usage_print_program_help(FILE *out);

#endif
