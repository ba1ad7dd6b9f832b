/* Parses a line into calls: splits it into commands, words and redirections,
 * parses values, and matches the words with the options and operands of a
 * command.  tipspeed(1), COMMAND LANGUAGE, has the grammar.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/parse.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

/* Returns the column of an offset.  Counts on from the offset asked about last,
 * so that the time is linear in the length of the line. */
static int
column_of_offset(const char *line, struct words *words, size_t offset)
{
	const char *p = line + words->reached;
	for (; p < line + offset; words->reached_column++)
		text_next_code_point(&p);
	words->reached = offset;
	return words->reached_column;
}

static bool
is_end_of_word(char c, bool verbatim)
{
	return isspace((unsigned char)c) || c == ';' ||
	       (!verbatim && (c == '>' || c == '|'));
}

/* Returns the offset of the closing quote of '...' or name='...', and that of
 * the opening quote in *open; 0 if the word is neither: within a word, ' is a
 * letter. */
static size_t
find_closing_single_quote(
    const char *line, size_t at, bool verbatim, size_t *open)
{
	size_t name = strspn(line + at, "abcdefghijklmnopqrstuvwxyz_");
	*open = line[at + name] == '=' ? at + name + 1 : at;
	if (line[*open] != '\'')
		return 0;
	size_t close = *open + 1 + strcspn(line + *open + 1, "'");
	bool ends = line[close] != '\0' &&
		    (line[close + 1] == '\0' ||
			is_end_of_word(line[close + 1], verbatim));
	return ends ? close : 0;
}

/* Copies the word at *at and moves *at past it.  Returns false if a quote is
 * not closed.  The caller frees the word in either case. */
static bool
parse_word_of_line(const char *line, size_t *at, bool verbatim, char **word)
{
	bool quoted = false;
	size_t i = *at, open;
	size_t close = find_closing_single_quote(line, *at, verbatim, &open);
	if (close > 0) {
		*word = xasprintf("%.*s%.*s", (int)(open - *at), line + *at,
		    (int)(close - open - 1), line + open + 1);
		*at = close + 1;
		return true;
	}
	for (;
	     line[i] != '\0' && (quoted || !is_end_of_word(line[i], verbatim));
	     i++)
		quoted = quoted != (line[i] == '"');
	*word = text_without_quotes(line + *at, i - *at);
	*at = i;
	return !quoted;
}

static bool
error_unclosed_quote(struct place place, int column, struct error *error)
{
	return error_set_at(error, ERROR_USAGE, place.file, place.line, column,
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

/* Takes the rest of the line as a shell command. */
static bool
parse_pipe(const char *line, size_t i, struct words *words)
{
	FREED char *rest = xstrdup(line + i + 1);
	words->to = TO_PIPE;
	words->target = xstrdup(text_trim(rest));
	words->next = i + strlen(line + i);
	return words->target[0] != '\0' && words->target[0] != '|';
}

/* Parses "> FILE" or ">> FILE" at *at and moves *at past it. */
static bool
parse_redirection_file(const char *line, size_t *at, struct place place,
    struct words *words, struct error *error)
{
	bool append = line[*at + 1] == '>';
	words->to = append ? TO_APPEND : TO_FILE;
	*at = skip_blanks(line, *at + (append ? 2 : 1));
	int column = column_of_offset(line, words, *at);
	bool stream = line[*at] == '&';
	if (!parse_word_of_line(line, at, false, &words->target))
		return error_unclosed_quote(place, column, error);
	/* "2>&1" of a shell names no file. */
	if (words->target[0] == '\0' || stream)
		return error_set_at(error, ERROR_USAGE, place.file, place.line,
		    words->to_column,
		    "expected a file name after %s\n"
		    "write: predict 74 > product.csv",
		    append ? ">>" : ">");
	*at = skip_blanks(line, *at);
	if (line[*at] == '\0' || line[*at] == ';' || line[*at] == '#')
		return true;
	return error_set_at(error, ERROR_USAGE, place.file, place.line,
	    column_of_offset(line, words, *at),
	    "expected nothing after the file '%s'\n"
	    "quote a name with spaces: > \"my file.csv\"; use one > or | in a "
	    "command",
	    words->target);
}

static bool
parse_redirection(const char *line, size_t *at, struct place place,
    struct words *words, struct error *error)
{
	char sign = line[*at];
	words->to_column = column_of_offset(line, words, *at);
	if (words->n == 0)
		return error_set_at(error, ERROR_USAGE, place.file, place.line,
		    words->to_column, "expected a command before %c", sign);
	if (sign == '>')
		return parse_redirection_file(line, at, place, words, error);
	bool good = parse_pipe(line, *at, words);
	*at = words->next;
	if (good)
		return true;
	return error_set_at(error, ERROR_USAGE, place.file, place.line,
	    words->to_column,
	    "expected a shell command after |\n"
	    "write: sweep | less");
}

void
words_replace_by_one(
    struct words *words, size_t first, size_t n, const char *text)
{
	size_t rest = words->n - first - n;
	char *joined = xstrdup(text);
	for (size_t i = first; i < first + n; i++)
		free(words->text[i]);
	words->text[first] = joined;
	memmove(&words->text[first + 1], &words->text[first + n],
	    rest * sizeof words->text[0]);
	memmove(&words->column[first + 1], &words->column[first + n],
	    rest * sizeof words->column[0]);
	words->n = first + 1 + rest;
}

/* If the first two words are the name of a command, "store list", joins them.
 * The words "set" and "seed=4" become "set seed" and "4". */
static void
join_command_name(struct words *words)
{
	bool set = strcmp(words->text[0], "set") == 0;
	size_t n = strcspn(words->text[1], set ? "=" : "");
	bool value = words->text[1][n] == '=';
	FREED char *name =
	    xasprintf("%s %.*s", words->text[0], (int)n, words->text[1]);
	const struct command *command = command_find(name);
	if (command == NULL)
		return;
	words_replace_by_one(words, 0, value ? 1 : 2, name);
	if (value)
		words_replace_by_one(words, 1, 1, words->text[1] + n + 1);
	words->command = command;
}

/* Joins a unit to the number before it: "72 m/s", or "1640 rpm" where m/s are
 * expected. */
static void
join_unit_to_number(struct words *words)
{
	const struct command *command = words->command;
	const char *word = words->text[words->n - 2];
	const char *unit = words->text[words->n - 1];
	const char *equals = strchr(word, '=');
	const char *number = equals != NULL ? equals + 1 : word;
	const char *before = (command->flags & COMMAND_SETTINGS) != 0
				 ? words->text[words->n - 3]
				 : command->bare;
	FREED char *name = equals != NULL
			       ? xstrndup(word, (size_t)(equals - word))
			       : xstrdup(before != NULL ? before : "");
	size_t i = command_option_index(command, name);
	const char *wanted = i < OPTIONS ? command_option_at(command, i)->unit
			     : command_takes_speeds(command) ? "m/s"
							     : "";
	bool turns =
	    text_is_same_folded(unit, "rpm") && strcmp(wanted, "m/s") == 0;
	if (wanted[0] == '\0' ||
	    (!turns && !text_is_same_folded(wanted, unit)) || *number < '0' ||
	    *number > '9')
		return;
	FREED char *joined = xasprintf("%s%s", word, unit);
	words_replace_by_one(words, words->n - 2, 2, joined);
}

static bool
ends_in_sign(const char *word)
{
	size_t n = strlen(word);
	return n > 0 && strchr("<>=", word[n - 1]) != NULL;
}

/* Returns the last condition in a word that may be "limits=P80 < 5,P20": what
 * follows the last comma and, for an option that takes a text, its =.  Returns
 * NULL if the word cannot have a condition. */
static const char *
last_condition_of_word(const struct words *words)
{
	const char *word = words->text[words->n - 1];
	const struct command *command = command_find_by_options(
	    words->command, words->text + 1, words->n - 1);
	const char *equals = strchr(word, '='), *comma = strrchr(word, ',');
	FREED char *name = xstrndup(word, strcspn(word, "="));
	size_t i = command_option_index(command, name);
	bool text = equals != NULL && i < OPTIONS &&
		    command_option_at(command, i)->kind == VALUE_TEXT;
	if (!text && (command->flags & COMMAND_CONDITIONS) == 0)
		return NULL;
	return comma != NULL ? comma + 1 : text ? equals + 1 : word;
}

/* True if the > at `at` belongs to a limit, as in "P80 > 5", rather than to a
 * redirection: not after a condition that has its limit already.  If the
 * command is unknown, >= counts as a limit, so that the error is about the
 * command. */
static bool
is_limit_not_redirection(const char *line, size_t at, const struct words *words)
{
	if (words->command == NULL)
		return words->n > 1 && words->n < OPERANDS &&
		       strncmp(line + at, ">=", 2) == 0;
	if (words->n < 2 || words->n == OPERANDS || line[at] != '>')
		return false;
	const char *last = last_condition_of_word(words);
	if (last == NULL || strpbrk(last, " <>=") != NULL ||
	    ends_in_sign(words->text[words->n - 2]))
		return false;
	at += line[at + 1] == '=' ? 2 : 1;
	at = skip_blanks(line, at);
	size_t n = strcspn(line + at, " \t;,%<>|");
	FREED char *number = xstrndup(line + at, n);
	double limit;
	return value_parse_number(number, "mm", &limit);
}

/* Ends the last word, which begins at `from`, after the first condition in it:
 * "P80<5,P20>1" is two words, as "P80<5, P20>1" is. */
static void
end_word_after_condition(
    const char *line, size_t from, size_t *at, struct words *words)
{
	char *word = words->text[words->n - 1];
	size_t sign = strcspn(word, "<>=");
	FREED char *name = xstrndup(word, sign);
	bool quoted = strncmp(word, line + from, *at - from) != 0;
	if (words->n < 2 || quoted || words->command == NULL ||
	    (words->command->flags & COMMAND_CONDITIONS) == 0 ||
	    command_option_index(words->command, name) < OPTIONS)
		return;
	size_t begin = ends_in_sign(words->text[words->n - 2]) ? 0 : sign;
	size_t n = begin + text_length_of_list_item(word + begin);
	if (word[n] == '\0')
		return;
	word[n + 1] = '\0';
	*at = from + n + 1;
}

/* Adds to the last word, which begins at `from`, a limit that follows without a
 * blank: "P80>5" is one word as "P80<5" is.  Returns false if a quote is not
 * closed. */
static bool
parse_limits_of_word(
    const char *line, size_t from, size_t *at, struct words *words)
{
	bool ok = true;
	end_word_after_condition(line, from, at, words);
	while (ok && is_limit_not_redirection(line, *at, words)) {
		size_t sign = line[*at + 1] == '=' ? 2 : 1;
		char **word = &words->text[words->n - 1];
		FREED char *before = *word, *rest = NULL;
		*at += sign;
		ok = parse_word_of_line(line, at, false, &rest);
		*word =
		    xasprintf("%s%s%s", before, sign == 1 ? ">" : ">=", rest);
		end_word_after_condition(line, from, at, words);
	}
	return ok;
}

static bool
parse_and_add_word(const char *line, size_t *at, struct place place,
    bool verbatim, struct words *words, struct error *error)
{
	int column = column_of_offset(line, words, *at);
	if (words->n == OPERANDS)
		return error_set_at(error, ERROR_USAGE, place.file, place.line,
		    column, "more than %d words", (int)OPERANDS);
	size_t i = words->n++, from = *at;
	words->column[i] = column;
	if (!parse_word_of_line(line, at, verbatim, &words->text[i]) ||
	    !parse_limits_of_word(line, from, at, words))
		return error_unclosed_quote(place, column, error);
	if (i == 0)
		words->command =
		    command_find_abbreviated(words->text[0], place.prompt);
	if (i == 1)
		join_command_name(words);
	if (words->n > 2 && words->command != NULL && !verbatim)
		join_unit_to_number(words);
	return true;
}

bool
words_split_line(const char *line, size_t from, struct place place,
    struct words *words, struct error *error)
{
	size_t i = skip_blanks(line, from), begin = i, end = i;
	words->n = 0;
	words->command = NULL;
	words->typed = NULL;
	words->to = TO_SCREEN;
	words->target = NULL;
	words->next = from;
	words->reached = place.column > 0 ? from : 0;
	words->reached_column = place.column > 0 ? place.column : 1;
	while (line[i] != '\0' && line[i] != '#' && line[i] != ';') {
		bool verbatim = words->command != NULL &&
				(words->command->flags & COMMAND_VERBATIM) != 0;
		bool sign = line[i] == '>' || line[i] == '|';
		bool ok = true;
		if (sign && is_limit_not_redirection(line, i, words)) {
			size_t n = line[i + 1] == '=' ? 2 : 1;
			words->column[words->n] =
			    column_of_offset(line, words, i);
			words->text[words->n++] = xstrndup(line + i, n);
			i += n;
		} else if (sign && !verbatim) {
			ok = parse_redirection(line, &i, place, words, error);
		} else {
			ok = parse_and_add_word(
			    line, &i, place, verbatim, words, error);
		}
		if (!ok)
			return false;
		end = words->to == TO_SCREEN ? i : end;
		i = skip_blanks(line, i);
	}
	words->typed = xstrndup(line + begin, end - begin);
	words->next = line[i] == ';' ? i + 1 : i + strlen(line + i);
	column_of_offset(line, words, words->next);
	return true;
}

bool
words_end_in_comment(const char *line)
{
	bool ok = true;
	size_t i = skip_blanks(line, 0);
	while (ok && line[i] != '\0' && line[i] != '#' && line[i] != '|') {
		FREED char *word = NULL;
		if (line[i] == ';' || line[i] == '>')
			i++;
		else
			ok = parse_word_of_line(line, &i, false, &word);
		i = skip_blanks(line, i);
	}
	return ok && line[i] == '#';
}

void
words_free(struct words *words)
{
	for (size_t i = 0; i < words->n; i++)
		free(words->text[i]);
	free(words->target);
	free(words->typed);
	words->target = words->typed = NULL;
	words->n = 0;
}

/* Removes the unit at the end of a number: "74m/s", "11.2 mm", "74 M/S". */
static void
strip_unit(char *text, const char *unit)
{
	size_t n = strlen(text), m = strlen(unit);
	if (m > 0 && n > m && text_is_same_folded(text + n - m, unit))
		text[n - m] = '\0';
}

bool
value_parse_number(const char *word, const char *unit, double *value)
{
	FREED char *text = xstrdup(word);
	strip_unit(text, unit);
	return text_parse_typed_number(text, value);
}

bool
value_is_speed(const char *word)
{
	double v;
	return value_parse_number(word, "m/s", &v) ||
	       value_parse_number(word, "rpm", &v);
}

const char *
value_parse_feed_and_share(const char *text, size_t *length, double *share)
{
	for (const char *star = strchr(text, '*'); star != NULL;
	     star = strchr(star + 1, '*')) {
		size_t n = strspn(star + 1, "0123456789.");
		bool percent = star[1 + n] == '%';
		const char *end = star + 1 + n + (percent ? 1 : 0);
		FREED char *number = xstrndup(star + 1, n);
		bool ok = (*end == '+' || *end == '\0') &&
			  text_parse_number(number, share);
		if (!ok)
			continue;
		*length = (size_t)(star - text);
		*share /= percent ? 100 : 1;
		return *end == '+' ? end + 1 : NULL;
	}
	*length = strlen(text);
	*share = NAN;
	return NULL;
}

/* Control rooms show rpm. */
static const char RPM_HINT[] =
    N_("is this rpm? '%.*s rpm' works if the rotor is known: m/s = 3.1416 x "
       "rotor diameter (m) x rpm / 60");

/* Adds a hint if a number is written in a way that is usual elsewhere.  Returns
 * false. */
static bool
hint_decimal_format(
    const struct command_option *option, const char *word, struct error *error)
{
	FREED char *copy = xstrdup(word);
	char *comma = strchr(copy, ',');
	char *dash = copy[0] != '\0' ? strchr(copy + 1, '-') : NULL;
	double low, high;
	strip_unit(copy, option->unit);
	if (strcmp(option->unit, "m/s") == 0 &&
	    strspn(word, "0123456789") > 0 && strstr(word, "rpm") != NULL) {
		error_set_hint(
		    error, RPM_HINT, (int)strspn(word, "0123456789."), word);
	} else if (comma != NULL) {
		*comma = '.';
		bool right = text_parse_number(copy, &low);
		error_set_hint(
		    error, "use a decimal point: %s", right ? copy : "11.2");
	} else if (dash != NULL) {
		*dash = '\0';
		bool range = text_parse_number(copy, &low) &&
			     text_parse_number(dash + 1, &high);
		if (range && option->kind == VALUE_NUMBERS)
			error_set_hint(error,
			    "write a range with two points: %s..%s", copy,
			    dash + 1);
		else if (range && strcmp(option->unit, "m/s") == 0)
			error_set_hint(error,
			    "for several speeds: sweep %s..%s", copy, dash + 1);
	}
	return false;
}

static bool
parse_number_in_limits(const struct command_option *option, const char *word,
    double *value, struct error *error)
{
	/* In a list, commas separate numbers. */
	bool list = option->kind == VALUE_NUMBERS && strchr(word, ',') != NULL;
	bool ok = !list && value_parse_number(word, option->unit, value);
	const char *in = option->unit[0] != '\0' ? tr(" in ") : "";
	const char *space = option->unit[0] != '\0' ? " " : "";
	bool comma = option->kind == VALUE_NUMBER && strchr(word, ',') != NULL;
	if (!ok) {
		error_set(error, ERROR_USAGE,
		    "%s: expected a number%s%s, got '%s'", option->name,
		    comma ? "" : in, comma ? "" : option->unit, word);
		return hint_decimal_format(option, word, error);
	}
	if (*value < option->least || *value > option->most) {
		error_set(error, ERROR_USAGE,
		    "expected %s from %g to %g%s%s, got %s", option->name,
		    option->least, option->most, space, option->unit, word);
		return *value > option->most &&
		       strcmp(option->unit, "m/s") == 0 &&
		       error_set_hint(error, RPM_HINT,
			   (int)strspn(word, "0123456789."), word);
	}
	return true;
}

static bool
parse_and_append_number(const struct command_option *option, const char *word,
    struct value *value, struct error *error)
{
	double v;
	if (!parse_number_in_limits(option, word, &v, error))
		return false;
	value->list = xgrow_by_one(value->list, value->n, sizeof v);
	value->list[value->n++] = v;
	return true;
}

/* The most numbers in a value: each may become a prediction, which takes
 * memory. */
enum { NUMBERS_MOST = 2000 };

/* Parses a..b or a..b:step; the step is 1 by default. */
static bool
parse_range_of_speeds(const struct command_option *option, char *word,
    char *dots, struct value *value, struct error *error)
{
	double from, to, step = 1;
	char *colon = strchr(dots + 2, ':');
	if (colon == NULL && strchr(dots, ',') != NULL)
		return error_set(error, ERROR_USAGE,
		    "%s: expected a range alone, got '%s'\n"
		    "write a step after a colon, and a decimal point: "
		    "65..85:2.5",
		    option->name, word);
	*dots = '\0';
	if (colon != NULL)
		*colon = '\0';
	struct command_option step_of = *option;
	step_of.name = tr("the step");
	step_of.least = 0.001;
	bool ok = parse_number_in_limits(option, word, &from, error) &&
		  parse_number_in_limits(option, dots + 2, &to, error) &&
		  (colon == NULL || parse_number_in_limits(
					&step_of, colon + 1, &step, error));
	if (!ok)
		return false;
	double steps = floor((to - from) / step + 1e-9);
	if (colon != NULL)
		*colon = ':';
	if (steps < 0)
		return error_set(error, ERROR_USAGE,
		    "%s: expected a range from low to high, got %g to %g\n"
		    "write %g..%g%s",
		    option->name, from, to, to, from,
		    colon != NULL ? colon : "");
	if (steps >= NUMBERS_MOST)
		return error_set(error, ERROR_USAGE,
		    "%s: expected a range of at most %d steps, got %.0f\n"
		    "use a larger step, or several parts",
		    option->name, (int)NUMBERS_MOST, steps);
	for (double i = 0; i <= steps; i++) {
		value->list = xgrow_by_one(value->list, value->n, sizeof from);
		value->list[value->n++] = from + i * step;
	}
	return true;
}

/* Adds the hint to a list or range that cannot be read.  Returns false. */
static bool
hint_list_format(
    const struct command_option *option, const char *word, struct error *error)
{
	const char *comma = strchr(word, ','), *dots = strstr(word, "..");
	if (comma != NULL && dots != NULL &&
	    (comma < dots || strchr(word, ':') != NULL)) {
		FREED char *points = xstrdup(word);
		for (char *c = points; *c != '\0'; c++)
			*c = *c == ',' ? '.' : *c;
		error_set_hint(error, "use a decimal point: %s", points);
	} else if (error->hint[0] == '\0' && strcmp(option->unit, "m/s") == 0) {
		error_set_hint(
		    error, "write a list, 65,74,85, or a range, 65..85:5");
	}
	return false;
}

static bool
parse_list_of_numbers(const struct command_option *option, const char *word,
    struct value *value, struct error *error)
{
	size_t all;
	if (option->choices != NULL &&
	    text_find_word_in_list(option->choices, word, &all))
		return true;
	FREED char *text = xstrdup(word);
	char *dots = strstr(text, "..");
	bool ok = true;
	if (dots != NULL) {
		ok = parse_range_of_speeds(option, text, dots, value, error);
	} else {
		for (char *part = text; ok && part != NULL;) {
			char *comma = strchr(part, ',');
			if (comma != NULL)
				*comma = '\0';
			ok =
			    parse_and_append_number(option, part, value, error);
			part = comma != NULL ? comma + 1 : NULL;
		}
	}
	if (!ok)
		return hint_list_format(option, word, error);
	if (value->n > NUMBERS_MOST)
		return error_set(error, ERROR_USAGE,
		    "%s: expected at most %d numbers, got %zu\n"
		    "leave some out, or give them in several parts",
		    option->name, (int)NUMBERS_MOST, value->n);
	return true;
}

static bool
error_expected_whole_number(
    const struct command_option *option, const char *word, struct error *error)
{
	FREED char *limits = command_option_valid_values_text(option);
	return error_set(error, ERROR_USAGE,
	    "%s: expected a whole number, %s; got '%s'", option->name, limits,
	    word);
}

/* Sets the error for an option without a value.  Returns false. */
static bool
error_option_without_value(
    const struct command_option *option, struct error *error)
{
	FREED char *limits = command_option_valid_values_text(option);
	return error_set(error, ERROR_USAGE, "%s: expected a value: %s",
	    option->name, limits);
}

static bool
error_wrong_choice(
    const struct command_option *option, const char *word, struct error *error)
{
	if (word[0] == '\0')
		return error_option_without_value(option, error);
	error_set(error, ERROR_USAGE, "%s: expected one of %s; got '%s'",
	    option->name, option_choices(option), word);
	char *copy = xstrdup(option_choices(option)), *save = NULL;
	FREED char *folded = text_fold_case_and_accents(word);
	for (char *choice = strtok_r(copy, " ", &save); choice != NULL;
	     choice = strtok_r(NULL, " ", &save))
		if (text_edit_distance(choice, folded) <= strlen(choice) / 3)
			error_set_hint(error, "did you mean '%s'?", choice);
	free(copy);
	return false;
}

bool
value_parse(const struct command_option *option, const char *word,
    struct value *value, struct error *error)
{
	value->text = word;
	switch (option->kind) {
	case VALUE_NUMBER:
		return parse_number_in_limits(
		    option, word, &value->number, error);
	case VALUE_FEED:
		if (value_parse_number(word, option->unit, &value->number))
			return parse_number_in_limits(
			    option, word, &value->number, error);
		return word[0] != '\0' ||
		       error_option_without_value(option, error);
	case VALUE_NUMBERS:
		return parse_list_of_numbers(option, word, value, error);
	case VALUE_WHOLE:
		if (text_parse_whole_number(word, &value->whole) &&
		    value->whole <= INT64_MAX &&
		    (double)value->whole >= option->least &&
		    (double)value->whole <= option->most)
			return true;
		return error_expected_whole_number(option, word, error);
	case VALUE_CHOICE: {
		FREED char *choice = xstrdup(word);
		strip_unit(choice, option->unit);
		return text_find_word_in_list(
			   option_choices(option), choice, &value->choice) ||
		       error_wrong_choice(option, word, error);
	}
	default:
		return word[0] != '\0' ||
		       error_set(error, ERROR_USAGE, "%s: expected a value",
			   option->name);
	}
}

/* True if "set NAME" sets what the command, "set" or "set seed", does not. */
static bool
is_set_by_other_command(const struct command *command, const char *name)
{
	const char *shown = command_shown_name(command);
	FREED char *other = xasprintf("set %s", name);
	return strcspn(shown, " ") == 3 && strncmp(shown, "set", 3) == 0 &&
	       (command_find(other) != NULL ||
		   command_option_index(command_find("set"), name) < OPTIONS);
}

/* Returns the usage in a few lines; that of `set` would be ten. */
static char *
usage_for_error(const struct command *command)
{
	return (command->flags & COMMAND_SETTINGS) != 0
		   ? xstrdup(tr("set SETTING VALUE; 'set' lists them"))
		   : command_usage_text(command);
}

/* value: that of the option. */
static void
error_unknown_option(const struct command *command, const char *name,
    const char *value, struct error *error)
{
	if (is_set_by_other_command(command, name)) {
		error_set(error, ERROR_USAGE,
		    "expected '%s' in a command of its own, got it in '%s'\n"
		    "write: set %s %s",
		    name, command_shown_name(command), name, value);
		return;
	}
	error_set(error, ERROR_USAGE, "%s has no option '%s'",
	    command_shown_name(command), name);
	const struct command_option *o;
	for (size_t i = 0; (o = command_option_at(command, i)) != NULL; i++) {
		size_t far = text_edit_distance(o->name, name);
		if (far > 2 || far >= strlen(name))
			continue;
		error_set_hint(error, "did you mean '%s'?", o->name);
		return;
	}
	FREED char *usage = usage_for_error(command);
	error_set_hint(error, "usage: %s", usage);
	if ((command->flags & COMMAND_FILES) != 0 && strchr(value, '.') != NULL)
		error_set_hint(error, "for a file of that name write ./%s=%s",
		    name, value);
}

/* Parses the value of an option, which was not given before. */
static bool
parse_named_option(
    const char *name, const char *value, struct args *args, struct error *error)
{
	size_t i = command_option_index(args->command, name);
	if (i == OPTIONS) {
		error_unknown_option(args->command, name, value, error);
		return false;
	}
	if (args->value[i].given)
		return error_set(error, ERROR_USAGE,
		    "%s is given twice\n"
		    "leave out one of the two",
		    name);
	args->value[i].given = true;
	return value_parse(
	    command_option_at(args->command, i), value, &args->value[i], error);
}

/* Returns false with an error for an operand such as "p80", or "P80=5.5" as in
 * a table's heading. */
static bool
check_operand_is_no_option(
    const struct command *command, const char *word, struct error *error)
{
	size_t n = strcspn(word, "=");
	FREED char *cut = xstrndup(word, n),
		   *name = text_fold_case_and_accents(cut);
	size_t i = command_option_index(command, name);
	if (i == OPTIONS)
		return true;
	if (word[n] == '=')
		return error_set(error, ERROR_USAGE,
		    "expected an option in lower case, got '%s'\n"
		    "write %s%s",
		    word, name, word + n);
	error_option_without_value(command_option_at(command, i), error);
	return error_set_hint(error, "write %s=VALUE", name);
}

/* Parses one word after the command's name: key=value, the value of the bare
 * option, or an operand. */
static bool
parse_one_command_argument(
    const char *word, int column, struct args *args, struct error *error)
{
	const struct command *command = args->command;
	const char *equals = strchr(word, '=');
	size_t key = equals != NULL ? (size_t)(equals - word) : 0;
	bool is_key =
	    key > 0 &&
	    strspn(word, "abcdefghijklmnopqrstuvwxyz0123456789_") == key;
	if (is_key && command_option_at(command, 0) != NULL) {
		FREED char *name = xstrndup(word, key);
		return parse_named_option(name, equals + 1, args, error);
	}
	size_t bare = command->bare != NULL
			  ? command_option_index(command, command->bare)
			  : OPTIONS;
	if (bare < OPTIONS && !args->value[bare].given &&
	    (command->operands.most == 0 || value_is_speed(word)))
		return (equals == NULL ||
			   check_operand_is_no_option(command, word, error)) &&
		       parse_named_option(command->bare, word, args, error);
	args->column[args->n_operand] = column;
	args->operand[args->n_operand++] = word;
	return true;
}

/* Stores a value in the member of args for its option, see rows.h. */
static void
store_option_value_in_args(const struct command_option *o,
    const struct value *value, struct args *args)
{
	void *member = (char *)args + o->offset;
	const char *words = o->choices != NULL ? o->choices : "";
	bool off_on = strcmp(words, "off on") == 0;
	bool on_off = strcmp(words, "on off") == 0;
	if (off_on || on_off)
		*(bool *)member = value->choice == off_on;
	else if (o->kind == VALUE_CHOICE)
		*(unsigned *)member = (unsigned)value->choice;
	else if (o->kind == VALUE_NUMBER)
		*(double *)member = value->number;
	else if (o->kind == VALUE_WHOLE)
		*(uint64_t *)member = value->whole;
	else if (o->kind == VALUE_NUMBERS)
		*(struct number_list *)member =
		    (struct number_list){value->n, value->list};
	else
		*(const char **)member = value->text;
}

/* Takes the fallbacks of options that were not given, and stores all values in
 * their members.  Those of settings and of parameters are stored by cmd_set and
 * cmd_params. */
static bool
store_option_values_in_args(struct args *args, struct error *error)
{
	const struct command *command = args->command;
	const struct command_option *o;
	bool ok = true;
	for (size_t i = 0; ok && (o = command_option_at(command, i)) != NULL;
	     i++) {
		struct value *value = &args->value[i];
		if (!value->given && o->fallback[0] != '\0')
			ok = value_parse(o, o->fallback, value, error);
		if (o->offset > 0 && (command->flags & COMMAND_SETTINGS) == 0 &&
		    value->text != NULL)
			store_option_value_in_args(o, value, args);
	}
	return ok;
}

/* Returns the word as it has to be typed: with a space it needs quotes. */
static char *
word_as_typed(const char *word)
{
	return strchr(word, ' ') != NULL ? text_add_quotes(word)
					 : xstrdup(word);
}

static bool
check_number_of_operands(const struct args *args, struct error *error)
{
	static const char *const FILES[] = {".csv", ".xlsx", ".json", ".md",
	    ".html", ".pdf", ".svg", ".png", ".txt"};
	const struct command *command = args->command;
	const char *kinds = command->operands.expect[0];
	const char *more = args->n_operand > command->operands.most
			       ? args->operand[command->operands.most]
			       : NULL;
	if (more == NULL && args->n_operand >= command->operands.least)
		return true;
	if (more != NULL && !check_operand_is_no_option(command, more, error))
		return false;
	size_t speed = command_option_index(command, "speed");
	if (more != NULL && command->operands.most == 0 &&
	    value_is_speed(more) && speed < OPTIONS && args->value[speed].given)
		return error_set(error, ERROR_USAGE,
		    "expected one speed, got %s and %s\n"
		    "write a command for each: %s speed=%s; %s speed=%s",
		    args->value[speed].text, more, command->name,
		    args->value[speed].text, command->name, more);
	FREED char *usage = usage_for_error(command);
	FREED char *file = word_as_typed(more != NULL ? more : "");
	error_set(error, ERROR_USAGE,
	    more != NULL ? N_("%s: unexpected word '%s'\n"
			      "usage: %s")
			 : N_("%s: expected %s\n"
			      "usage: %s"),
	    command_shown_name(command),
	    more != NULL ? more : command->operands.usage, usage);
	if (more != NULL && (command->flags & COMMAND_FILES) == 0 &&
	    text_file_ending(more, FILES, ARRAY_LEN(FILES)) < ARRAY_LEN(FILES))
		error_set_hint(error, "for a file of results write > %s", file);
	else if (more == NULL && kinds != NULL &&
		 islower((unsigned char)*kinds))
		error_set_hint(error, "write one of: %s", kinds);
	return false;
}

/* If an option and its value at the column of the error are two words, as in
 * "speed 74", or there are spaces around =, as in "speed = 74", "speed =74" and
 * "speed= 74", replaces the hint. */
static void
hint_option_in_two_words(const struct command *command,
    const struct words *words, int column, struct error *error)
{
	bool set = (command->flags & COMMAND_SETTINGS) != 0;
	for (size_t i = 2; i < words->n; i++) {
		const char *name = words->text[i - 1], *word = words->text[i];
		size_t n = strlen(name), signs = word[0] == '=';
		bool ends = n > 0 && name[n - 1] == '=';
		bool alone = signs == 1 && word[1] == '\0';
		const char *value = !alone             ? word + signs
				    : i + 1 < words->n ? words->text[i + 1]
						       : "..";
		FREED char *key = xstrndup(name, ends ? n - 1 : n);
		bool here = signs == 0 && !set &&
			    (words->column[i - 1] == column ||
				words->column[i] == column);
		const char *of = here ? strchr(value, '=') : NULL;
		FREED char *quoted = word_as_typed(of != NULL ? of + 1 : value);
		if (!(signs == 1 || ends || here) ||
		    command_option_index(command, key) == OPTIONS)
			continue;
		error_set_hint(
		    error, "write it as one word: %s=%s", key, quoted);
		if (here && strcmp(key, "at") == 0)
			error_set_hint(error,
			    "write speed=%s for a speed, at=%s for a size",
			    quoted, quoted);
	}
}

static void
error_command_not_found(const char *name, bool prompt, struct error *error)
{
	FREED char *several = command_names_beginning_with(name);
	bool one = prompt && several[0] != '\0';
	const char *near = one ? several : command_nearest_name(name);
	double speed;
	error_set(error, ERROR_USAGE, "there is no command '%s'", name);
	if (value_parse_number(name, "m/s", &speed))
		error_set_hint(error, "did you mean 'predict %s'?", name);
	else if (prompt && strchr(several, ',') != NULL)
		error_set_hint(error, "did you mean one of %s?", several);
	else if (near != NULL)
		error_set_hint(error, "did you mean '%s'?", near);
	else
		error_set_hint(error, "run 'help' for the commands");
}

/* Parses the words after the command's name.  On failure, sets *column to that
 * of the faulty word. */
static bool
parse_command_arguments(const struct words *words, struct args *args,
    int *column, struct error *error)
{
	const struct command *command = args->command;
	bool set = (command->flags & COMMAND_SETTINGS) != 0;
	for (size_t i = 1; i < words->n; i++) {
		const char *word = words->text[i];
		bool last = i + 1 == words->n;
		bool pair = set && !last && strchr(word, '=') == NULL;
		/* "set method" without its value */
		size_t named =
		    set && last ? command_option_index(command, word) : OPTIONS;
		*column = words->column[i];
		bool ok = pair ? parse_named_option(
				     word, words->text[i + 1], args, error)
			  : named < OPTIONS
			      ? error_option_without_value(
				    command_option_at(command, named), error)
			      : parse_one_command_argument(
				    word, *column, args, error);
		if (!ok)
			return false;
		i += pair;
	}
	*column = args->n_operand > command->operands.most
		      ? args->column[command->operands.most]
		      : words->column[0];
	return check_number_of_operands(args, error) &&
	       store_option_values_in_args(args, error);
}

/* True if one of the words is this operand, or this option, "at=". */
static bool
has_needed_word(const struct words *words, const char *needed)
{
	size_t n = strcspn(needed, "= "), i = 1;
	n += needed[n] == '=';
	while (i < words->n && strncmp(words->text[i], needed, n) != 0)
		i++;
	return i < words->n;
}

/* Returns false with an error for an option that has no effect without a word
 * that the line does not have. */
static bool
check_words_that_options_need(
    const struct words *words, const struct args *args, struct error *error)
{
	const struct command_option *o;
	for (size_t i = 0; (o = command_option_at(args->command, i)) != NULL;
	     i++) {
		const char *needs = o->needs;
		if (needs == NULL || !args->value[i].given ||
		    has_needed_word(words, needs) ||
		    (words->to == TO_FILE && strchr(needs, '>') != NULL))
			continue;
		FREED char *line = xstrdup(words->typed);
		for (const char *at = needs; *at >= 'a';) {
			size_t n = strcspn(at, " ");
			if (!has_needed_word(words, at))
				xappend(&line, " %.*s", (int)n, at);
			at += n + strspn(at + n, " ");
		}
		return error_set(error, ERROR_USAGE,
		    "%s= has no effect without %.*s\n"
		    "write: %s; or leave out %s=",
		    o->name, (int)strcspn(needs, "0123456789 "), needs, line,
		    o->name);
	}
	return true;
}

const struct command *
parse_command_words(const struct words *words, struct place place,
    struct args *args, struct error *error)
{
	memset(args, 0, sizeof *args);
	int column = words->column[0];
	if (words->command == NULL) {
		error_command_not_found(words->text[0], place.prompt, error);
	} else {
		args->command = command_find_by_options(
		    words->command, words->text + 1, words->n - 1);
		if (parse_command_arguments(words, args, &column, error) &&
		    check_words_that_options_need(words, args, error))
			return args->command;
		hint_option_in_two_words(args->command, words, column, error);
	}
	error_set_place(error, place.file, place.line, column);
	return NULL;
}

void
args_free(struct args *args)
{
	for (size_t i = 0; i < OPTIONS; i++)
		free(args->value[i].list);
	memset(args->value, 0, sizeof args->value);
}
