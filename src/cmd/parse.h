/* From a line of text to calls of commands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PARSE_H
#define TIPSPEED_CMD_PARSE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "cmd/command.h"

/* Where a line comes from, for messages. */
struct place {
	const char *file;
	int line;
};

/* The words of one command and the characters they start at (from 1).
 * last: the offset in the line at which the next command may begin. */
struct words {
	size_t n;
	char *text[OPERANDS];
	int column[OPERANDS];
	size_t next;
};

/* Splits the command that begins at line + from: words between blanks, "quoted"
 * ones whole, up to ; or # or the end.  False on an open quote or too many
 * words.  Free with words_free in any case. */
bool words_split(const char *line, size_t from, struct place place,
    struct words *words, struct error *error);
void words_free(struct words *words);

/* Finds the command and checks every value against its table.  args borrows
 * from words; free with args_free in any case. */
const struct command *parse_call(const struct words *words, struct place place,
    struct args *args, struct error *error);
void args_free(struct args *args);

#endif
