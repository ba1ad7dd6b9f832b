/* What the program reads from its command line and environment, and what it
 * ends with, as data: for getopt, --help, the manual and shell completion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_USAGE_H
#define TIPSPEED_CMD_LANG_USAGE_H

#include <stdio.h>

#include "cmd/lang/command.h"

/* An option of the command line.  code: what getopt_long returns for it, the
 * letter where it has one.  argument: its name in usage, or NULL.  choices:
 * what the argument may be, between spaces, or NULL. */
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

/* Ends with a code of 0.  One without a name has its letter only. */
extern const struct usage_option USAGE_OPTIONS[];

/* A variable or an exit status and what it means; ends with a name of NULL. */
struct usage_word {
	const char *name, *meaning;
};

extern const struct usage_word USAGE_ENVIRONMENT[], USAGE_STATUS[];

/* The list of commands by group; of one group, or of all for NULL. */
void usage_list(const char *group, FILE *out);

/* The options that are told once for many commands. */
void usage_shared(FILE *out);

/* A command in one line; all that the table says of it; the lines of its
 * example, each after the margin. */
void usage_brief(const struct command *command, FILE *out);
void usage_command(const struct command *command, FILE *out);
void usage_example(
    const struct command *command, const char *margin, FILE *out);

/* The text of --help. */
void usage_print(FILE *out);

#endif
