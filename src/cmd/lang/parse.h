/* Parses a line of text into calls of commands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_PARSE_H
#define TIPSPEED_CMD_LANG_PARSE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "cmd/lang/command.h"

/* Where a line comes from, for messages. */
struct place {
	const char *file;
	int line;
	/* The line was typed at a prompt, where names of commands may be
	 * abbreviated. */
	bool prompt;
	/* The column of the command's first character; 0 if not known. */
	int column;
};

/* Where the results of a command go. */
enum target { TO_SCREEN, TO_FILE, TO_APPEND, TO_PIPE };

/* The words of one command. */
struct words {
	size_t n;
	char *text[OPERANDS];
	/* The column at which each word starts, from 1. */
	int column[OPERANDS];
	/* The command that the first word names, or NULL. */
	const struct command *command;
	/* The words as typed in the line; NULL after an error. */
	char *typed;
	/* The offset in the line at which the next command may begin. */
	size_t next;
	enum target to;
	/* The file for TO_FILE (">") and TO_APPEND (">>"), or the shell command
	 * for TO_PIPE; and the column of > or |. */
	char *target;
	int to_column;
	size_t reached; /* an offset in the line, and its column */
	int reached_column;
};

/* Splits the command that begins at line + from into words, at spaces.  Words
 * in double quotes stay whole, and "" within quotes is one quote.  The command
 * ends at ; or # or at the end of the line.  Returns false if a quote is open,
 * there are too many words, or a redirection is faulty.  Always free with
 * words_free. */
bool words_split_line(const char *line, size_t from, struct place place,
    struct words *words, struct error *error);
void words_free(struct words *words);

/* True if the line ends in a comment rather than in a command or in a shell
 * command after |. */
bool words_end_in_comment(const char *line);

/* Replaces n words, from `first` on, by one word. */
void words_replace_by_one(
    struct words *words, size_t first, size_t n, const char *text);

/* Parses the words into a call and checks each value against the table.
 * Returns the command that is meant, or NULL with an error.  args borrows from
 * words; always free with args_free. */
const struct command *parse_command_words(const struct words *words,
    struct place place, struct args *args, struct error *error);
void args_free(struct args *args);

/* Parses a word as a value of the option.  The value borrows the word; the
 * caller frees value->list.  Returns false with an error that says what was
 * expected and, if possible, what may have been meant. */
bool value_parse(const struct command_option *option, const char *word,
    struct value *value, struct error *error);

/* Parses a number with or without its unit: 69, 69m/s. */
bool value_parse_number(const char *word, const char *unit, double *value);

/* True for "72", "72m/s" and "1500rpm". */
bool value_is_speed(const char *word);

/* Parses the first feed of a blend "a.csv*0.6+b.csv*40%": the length of its
 * name, and its share.  Without a share, sets the length of the whole text and
 * NAN.  Returns the rest, which begins with the next feed, or NULL after the
 * last. */
const char *value_parse_feed_and_share(
    const char *text, size_t *length, double *share);

#endif
