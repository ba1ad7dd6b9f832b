/* Parses a line of text into calls of commands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_PARSE_H
#define TIPSPEED_CMD_LANG_PARSE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "cmd/lang/command.h"

/* The origin of a line, for messages.  prompt: it was typed at a prompt, where
 * names of commands may be abbreviated.  column: that of the command's first
 * character; 0 if not known. */
struct place {
	const char *file;
	int line;
	bool prompt;
	int column;
};

/* Target of a command's results. */
enum target { TO_SCREEN, TO_FILE, TO_APPEND, TO_PIPE };

/* The words of one command and the columns where they start (from 1).  command:
 * the one that the first word names, or NULL.  typed: the words as typed in the
 * line; NULL after an error.  next: the offset in the
 * line at which the next command may begin.  target: the file for TO_FILE (">")
 * and TO_APPEND (">>"), or the shell command for TO_PIPE; to_column: the column
 * of > or |. */
struct words {
	size_t n;
	char *text[OPERANDS];
	int column[OPERANDS];
	const struct command *command;
	char *typed;
	size_t next;
	enum target to;
	char *target;
	int to_column;
	size_t reached; /* an offset in the line, and its column */
	int reached_column;
};

/* Splits the command that begins at line + from into words at spaces; "quoted"
 * words stay whole ("" within quotes is one quote).  The command ends at ; or #
 * or the end of the line.  Returns false on an open quote, too many words or a
 * faulty redirection.  Always free with words_free. */
bool words_split(const char *line, size_t from, struct place place,
    struct words *words, struct error *error);
void words_free(struct words *words);

/* Replaces the n words from `first` on with a copy of one text. */
void words_replace_by_one(
    struct words *words, size_t first, size_t n, const char *text);

/* Checks every value against the table of the command that is meant.  args
 * borrows from words; always free with args_free. */
const struct command *parse_call(const struct words *words, struct place place,
    struct args *args, struct error *error);
void args_free(struct args *args);

/* Parses word as the option's value, which borrows it; the caller frees
 * value->list.  On failure, returns false with an error that states what was
 * expected and suggests what may have been meant. */
bool value_parse(const struct command_option *option, const char *word,
    struct value *value, struct error *error);

/* Parses a number, with or without its unit: 69, 69m/s. */
bool value_parse_number(const char *word, const char *unit, double *value);

/* True for "72", "72m/s" and "1500rpm". */
bool value_is_speed(const char *word);

/* Parses the first feed of a blend "a.csv*0.6+b.csv*40%": length of its name,
 * and share; without a share, the length of the whole text and NAN.  Returns
 * the next feed, or NULL after the last. */
const char *value_parse_blend_feed(
    const char *text, size_t *length, double *share);

#endif
