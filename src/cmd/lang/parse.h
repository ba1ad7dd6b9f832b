/* From a line of text to calls of commands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_PARSE_H
#define TIPSPEED_CMD_LANG_PARSE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "cmd/lang/command.h"

/* Where a line comes from, for messages.  prompt: it was typed at a prompt,
 * where names of commands may be cut short.  column: of the character that a
 * command begins at, where it is known; else 0. */
struct place {
	const char *file;
	int line;
	bool prompt;
	int column;
};

/* Where the results of a command go. */
enum target { TO_SCREEN, TO_FILE, TO_END, TO_PIPE };

/* The words of one command and the characters they start at (from 1).
 * typed: the words as they stand in the line; NULL of one at fault.
 * next: the offset in the line at which the next command may begin.
 * target: file of TO_FILE (">") and TO_END (">>"), shell command of TO_PIPE;
 * to_column: where > or | stands. */
struct words {
	size_t n;
	char *text[OPERANDS];
	int column[OPERANDS];
	char *typed;
	size_t next;
	enum target to;
	char *target;
	int to_column;
	size_t reached; /* an offset in the line, and its column */
	int reached_column;
};

/* Splits the command that begins at line + from: words between spaces, "quoted"
 * ones whole ("" within quotes is one quote), up to ; or # or the end.  False
 * on an open quote, too many words or a faulty redirection.  Free with
 * words_free in any case. */
bool words_split(const char *line, size_t from, struct place place,
    struct words *words, struct error *error);
void words_free(struct words *words);

/* Finds the command and checks every value against its table.  args borrows
 * from words; free with args_free in any case. */
const struct command *parse_call(const struct words *words, struct place place,
    struct args *args, struct error *error);
void args_free(struct args *args);

/* Reads word as the option's value, which borrows it; value->list is the
 * caller's.  False, with an error that says what was wanted and a hint at what
 * was meant. */
bool value_take(const struct command_option *option, const char *word,
    struct value *value, struct error *error);

/* A number, with its unit or without: 69, 69m/s. */
bool value_number(const char *word, const char *unit, double *value);

/* The first feed of a blend "a.csv*0.6+b.csv*40%": how long its name is, and
 * its share; NAN, and all of the text, where it has none.  Returns the next
 * one, or NULL after the last. */
const char *value_feed(const char *text, size_t *length, double *share);

#endif
