/* A line of text as commands, words and where the results go.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/parse.h"

/* Goes on from the last place asked for, so that a long line costs no more than
 * its length. */
static int
column_of(const char *line, struct words *words, size_t offset)
{
	const char *p = line + words->reached;
	for (; p < line + offset; words->reached_column++)
		text_next(&p);
	words->reached = offset;
	return words->reached_column;
}

static bool
ends_word(char c, bool verbatim)
{
	return isspace((unsigned char)c) || c == ';' ||
	       (!verbatim && (c == '>' || c == '|'));
}

/* Copies one word from *at on and moves *at behind it. False on an open quote;
 * the caller frees the word in any case. */
static bool
take_word(const char *line, size_t *at, bool verbatim, char **word)
{
	bool quoted = false;
	size_t i = *at;
	for (; line[i] != '\0' && (quoted || !ends_word(line[i], verbatim));
	     i++)
		quoted = quoted != (line[i] == '"');
	*word = text_unquoted(line + *at, i - *at);
	*at = i;
	return !quoted;
}

static bool
open_quote(struct place place, int column, struct error *error)
{
	return error_at(error, ERROR_USAGE, place.file, place.line, column,
	    "a quote (\") is not closed\n"
	    "add the closing \", or remove the opening one");
}

static size_t
skip_blanks(const char *line, size_t i)
{
	while (isspace((unsigned char)line[i]))
		i++;
	return i;
}

/* The rest of the line is the shell's. */
static bool
take_pipe(const char *line, size_t i, struct words *words)
{
	char *rest = xstrdup(line + i + 1);
	words->to = TO_PIPE;
	words->target = xstrdup(text_trim(rest));
	words->next = i + strlen(line + i);
	free(rest);
	return words->target[0] != '\0' && words->target[0] != '|';
}

/* "> FILE" or ">> FILE" at *at; *at is then behind it. */
static bool
take_file(const char *line, size_t *at, struct place place, struct words *words,
    struct error *error)
{
	bool append = line[*at + 1] == '>';
	words->to = append ? TO_END : TO_FILE;
	*at = skip_blanks(line, *at + (append ? 2 : 1));
	int column = column_of(line, words, *at);
	if (!take_word(line, at, false, &words->target))
		return open_quote(place, column, error);
	if (words->target[0] == '\0')
		return error_at(error, ERROR_USAGE, place.file, place.line,
		    words->to_column,
		    "expected a file name after %s\n"
		    "write: predict 74 > product.csv",
		    append ? ">>" : ">");
	*at = skip_blanks(line, *at);
	if (line[*at] == '\0' || line[*at] == ';' || line[*at] == '#')
		return true;
	return error_at(error, ERROR_USAGE, place.file, place.line,
	    column_of(line, words, *at),
	    "expected nothing after the file '%s'\n"
	    "quote a name with spaces: > \"my file.csv\"; use one > or | in a "
	    "command",
	    words->target);
}

static bool
take_redirection(const char *line, size_t *at, struct place place,
    struct words *words, struct error *error)
{
	char sign = line[*at];
	words->to_column = column_of(line, words, *at);
	if (words->n == 0)
		return error_at(error, ERROR_USAGE, place.file, place.line,
		    words->to_column, "expected a command before %c", sign);
	if (sign == '>')
		return take_file(line, at, place, words, error);
	bool good = take_pipe(line, *at, words);
	*at = words->next;
	if (good)
		return true;
	return error_at(error, ERROR_USAGE, place.file, place.line,
	    words->to_column,
	    "expected a shell command after |\n"
	    "write: sweep | less");
}

/* True where the first word names a command that takes > and | as words. */
static bool
is_verbatim(const struct words *words, struct place place)
{
	const struct command *command =
	    words->n > 0 ? command_called(words->text[0], place.prompt) : NULL;
	return command != NULL && (command->flags & COMMAND_VERBATIM) != 0;
}

static bool
add_word(const char *line, size_t *at, struct place place, bool verbatim,
    struct words *words, struct error *error)
{
	int column = column_of(line, words, *at);
	if (words->n == OPERANDS)
		return error_at(error, ERROR_USAGE, place.file, place.line,
		    column, "more than %d words", (int)OPERANDS);
	size_t i = words->n++;
	words->column[i] = column;
	return take_word(line, at, verbatim, &words->text[i]) ||
	       open_quote(place, column, error);
}

bool
words_split(const char *line, size_t from, struct place place,
    struct words *words, struct error *error)
{
	size_t i = skip_blanks(line, from);
	words->n = 0;
	words->to = TO_SCREEN;
	words->target = NULL;
	words->next = from;
	words->reached = place.column > 0 ? from : 0;
	words->reached_column = place.column > 0 ? place.column : 1;
	while (line[i] != '\0' && line[i] != '#' && line[i] != ';') {
		bool verbatim = is_verbatim(words, place);
		bool sign = line[i] == '>' || line[i] == '|';
		bool ok =
		    sign && !verbatim
			? take_redirection(line, &i, place, words, error)
			: add_word(line, &i, place, verbatim, words, error);
		if (!ok)
			return false;
		i = skip_blanks(line, i);
	}
	words->next = line[i] == ';' ? i + 1 : i + strlen(line + i);
	column_of(line, words, words->next);
	return true;
}

void
words_free(struct words *words)
{
	for (size_t i = 0; i < words->n; i++)
		free(words->text[i]);
	free(words->target);
	words->target = NULL;
	words->n = 0;
}
