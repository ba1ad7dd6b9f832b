/* Words, options and values.  The grammar is that of tipspeed(1), COMMANDS.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/parse.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

static bool
is_choice(const char *choices, const char *word, size_t *index)
{
	size_t i = 0, n = strlen(word);
	for (const char *c = choices; *c != '\0'; i++) {
		size_t length = strcspn(c, " ");
		if (length == n && strncmp(c, word, n) == 0) {
			*index = i;
			return true;
		}
		c += length;
		c += strspn(c, " ");
	}
	return false;
}

/* Cuts a unit off the end of a number: "74m/s", "11.2 mm". */
static void
cut_unit(char *text, const char *unit)
{
	size_t n = strlen(text), u = strlen(unit);
	if (u > 0 && n > u && strcmp(text + n - u, unit) == 0)
		text[n - u] = '\0';
}

static bool
number(const struct command_option *option, const char *word, double *value,
    struct error *error)
{
	char *text = xstrdup(word);
	cut_unit(text, option->unit);
	bool ok = text_number(text, value);
	free(text);
	const char *in = option->unit[0] != '\0' ? " in " : "";
	const char *space = option->unit[0] != '\0' ? " " : "";
	if (!ok && option->kind == VALUE_NUMBER && strchr(word, ',') != NULL) {
		error_set(error, ERROR_USAGE,
		    "%s wants a number, not '%s': a comma is no decimal sign "
		    "here",
		    option->name, word);
		return error_hint(error, "write a point: 11.2");
	}
	if (!ok)
		return error_set(error, ERROR_USAGE,
		    "%s wants a number%s%s, not '%s'", option->name, in,
		    option->unit, word);
	if (*value < option->least || *value > option->most)
		return error_set(error, ERROR_USAGE,
		    "%s wants %g to %g%s%s, not %s", option->name,
		    option->least, option->most, space, option->unit, word);
	return true;
}

static bool
add_number(const struct command_option *option, const char *word,
    struct value *value, struct error *error)
{
	double v;
	if (!number(option, word, &v, error))
		return false;
	value->list = xrealloc(value->list, value->n + 1, sizeof v);
	value->list[value->n++] = v;
	return true;
}

/* a..b or a..b:step; the step defaults to 1. */
static bool
range(const struct command_option *option, char *word, char *dots,
    struct value *value, struct error *error)
{
	enum { MOST = 2000 };
	double from, to, step = 1;
	char *colon = strchr(dots + 2, ':');
	*dots = '\0';
	if (colon != NULL)
		*colon = '\0';
	struct command_option step_of = *option;
	step_of.name = "the step";
	step_of.least = 0.001;
	bool ok = number(option, word, &from, error) &&
		  number(option, dots + 2, &to, error) &&
		  (colon == NULL || number(&step_of, colon + 1, &step, error));
	if (!ok)
		return false;
	double steps = floor((to - from) / step + 1e-9);
	if (steps < 0)
		return error_set(error, ERROR_USAGE,
		    "%s: a range goes from low to high, not from %g to %g",
		    option->name, from, to);
	if (steps >= MOST)
		return error_set(error, ERROR_USAGE,
		    "%s: a range has at most %d steps, not %.0f", option->name,
		    (int)MOST, steps);
	for (double i = 0; i <= steps; i++) {
		value->list = xrealloc(value->list, value->n + 1, sizeof from);
		value->list[value->n++] = from + i * step;
	}
	return true;
}

static bool
numbers(const struct command_option *option, const char *word,
    struct value *value, struct error *error)
{
	char *text = xstrdup(word);
	char *dots = strstr(text, "..");
	bool ok = true;
	if (dots != NULL) {
		ok = range(option, text, dots, value, error);
	} else {
		for (char *part = text; ok && part != NULL;) {
			char *comma = strchr(part, ',');
			if (comma != NULL)
				*comma = '\0';
			ok = add_number(option, part, value, error);
			part = comma != NULL ? comma + 1 : NULL;
		}
	}
	free(text);
	if (ok && value->n == 0)
		return error_set(error, ERROR_USAGE,
		    "%s wants numbers (65,74 or 65..85:5)", option->name);
	return ok;
}

static bool
wrong_whole(
    const struct command_option *option, const char *word, struct error *error)
{
	char *limits = command_limits(option);
	error_set(error, ERROR_USAGE, "%s wants a whole number, %s; not '%s'",
	    option->name, limits, word);
	free(limits);
	return false;
}

static bool
take_value(const struct command_option *option, const char *word,
    struct value *value, struct error *error)
{
	value->text = word;
	switch (option->kind) {
	case VALUE_NUMBER:
		return number(option, word, &value->number, error);
	case VALUE_NUMBERS:
		return numbers(option, word, value, error);
	case VALUE_WHOLE:
		if (text_whole(word, &value->whole) &&
		    (double)value->whole >= option->least &&
		    (double)value->whole <= option->most)
			return true;
		return wrong_whole(option, word, error);
	case VALUE_CHOICE:
		if (is_choice(option->choices, word, &value->choice))
			return true;
		return error_set(error, ERROR_USAGE,
		    "%s wants one of: %s; not '%s'", option->name,
		    option->choices, word);
	default:
		return word[0] != '\0' || error_set(error, ERROR_USAGE,
					      "%s wants a value", option->name);
	}
}

static bool
unknown_option(
    const struct command *command, const char *name, struct error *error)
{
	error_set(
	    error, ERROR_USAGE, "%s has no option '%s'", command->name, name);
	const struct command_option *o = command->option;
	for (; o != NULL && o->name != NULL; o++)
		if (text_distance(o->name, name) <= 2)
			return error_hint(error, "did you mean '%s'?", o->name);
	char *usage = command_usage(command);
	error_hint(error, "usage: %s", usage);
	free(usage);
	return false;
}

/* One word behind the command's name: key=value, the bare option or an
 * operand. */
static bool
take_argument(const struct command *command, const char *word,
    struct args *args, struct error *error)
{
	const char *equals = strchr(word, '=');
	size_t key = equals != NULL ? (size_t)(equals - word) : 0;
	bool is_key =
	    key > 0 &&
	    strspn(word, "abcdefghijklmnopqrstuvwxyz0123456789_") == key;
	size_t i = OPTIONS;
	if (is_key && command->option != NULL) {
		char *name = xstrndup(word, key);
		i = command_option_index(command, name);
		bool ok = i < OPTIONS && !args->value[i].given;
		if (i == OPTIONS)
			unknown_option(command, name, error);
		else if (!ok)
			error_set(
			    error, ERROR_USAGE, "%s is given twice", name);
		free(name);
		if (!ok)
			return false;
		word = equals + 1;
	} else if (command->bare != NULL) {
		size_t bare = command_option_index(command, command->bare);
		i = args->value[bare].given ? OPTIONS : bare;
	}
	if (i < OPTIONS) {
		args->value[i].given = true;
		return take_value(
		    &command->option[i], word, &args->value[i], error);
	}
	args->operand[args->n_operand++] = word;
	return true;
}

/* True, with the error, when a name stands alone at the end: "set method". */
static bool
lacks_value(
    const struct command *command, const char *name, struct error *error)
{
	size_t i = command_option_index(command, name);
	if (i == OPTIONS)
		return false;
	char *limits = command_limits(&command->option[i]);
	error_set(error, ERROR_USAGE, "%s wants a value: %s", name, limits);
	free(limits);
	return true;
}

/* "method classes" where "method=classes" would do. */
static bool
take_pair(const struct command *command, const char *name, char *word,
    struct args *args, struct error *error)
{
	size_t i = command_option_index(command, name);
	if (i == OPTIONS)
		return unknown_option(command, name, error);
	if (args->value[i].given)
		return error_set(error, ERROR_USAGE, "%s is given twice", name);
	args->value[i].given = true;
	return take_value(&command->option[i], word, &args->value[i], error);
}

static bool
take_fallbacks(
    const struct command *command, struct args *args, struct error *error)
{
	for (size_t i = 0;
	     command->option != NULL && command->option[i].name != NULL; i++) {
		const struct command_option *o = &command->option[i];
		if (args->value[i].given || o->fallback[0] == '\0')
			continue;
		if (!take_value(o, o->fallback, &args->value[i], error))
			return false;
	}
	return true;
}

static bool
check_operands(
    const struct command *command, const struct args *args, struct error *error)
{
	if (args->n_operand >= command->least &&
	    args->n_operand <= command->most)
		return true;
	char *usage = command_usage(command);
	if (args->n_operand > command->most)
		error_set(error, ERROR_USAGE, "%s: '%s' is one word too many",
		    command->name, args->operand[command->most]);
	else
		error_set(error, ERROR_USAGE, "%s wants %s", command->name,
		    command->operands);
	error_hint(error, "usage: %s", usage);
	free(usage);
	return false;
}

/* Adds the place of word i to an error that has none. */
static void
put_place(struct error *error, struct place place, const struct words *words,
    size_t i)
{
	snprintf(error->file, sizeof error->file, "%s", place.file);
	error->line = place.line;
	error->column = words->column[i];
}

static void
unknown_command(const char *name, bool prompt, struct error *error)
{
	const char *near = command_nearest(name);
	char *several = command_candidates(name);
	error_set(error, ERROR_USAGE, "there is no command '%s'", name);
	if (prompt && strchr(several, ',') != NULL)
		error_hint(error, "it may begin %s", several);
	else if (near != NULL)
		error_hint(error, "did you mean '%s'?", near);
	else
		error_hint(error, "'help' lists the commands");
	free(several);
}

const struct command *
parse_call(const struct words *words, struct place place, struct args *args,
    struct error *error)
{
	memset(args, 0, sizeof *args);
	const struct command *command =
	    command_called(words->text[0], place.prompt);
	if (command == NULL) {
		unknown_command(words->text[0], place.prompt, error);
		put_place(error, place, words, 0);
		return NULL;
	}
	for (size_t i = 1; i < words->n; i++) {
		if (command->pairs && i + 1 == words->n &&
		    lacks_value(command, words->text[i], error)) {
			put_place(error, place, words, i);
			return NULL;
		}
		bool pair = command->pairs && i + 1 < words->n &&
			    strchr(words->text[i], '=') == NULL;
		bool ok =
		    pair ? take_pair(command, words->text[i],
			       words->text[i + 1], args, error)
			 : take_argument(command, words->text[i], args, error);
		if (!ok) {
			put_place(error, place, words, i);
			return NULL;
		}
		i += pair;
	}
	if (!check_operands(command, args, error) ||
	    !take_fallbacks(command, args, error)) {
		size_t at = 0;
		for (size_t i = 1;
		     i < words->n && args->n_operand > command->most; i++)
			if (words->text[i] == args->operand[command->most])
				at = i;
		put_place(error, place, words, at);
		return NULL;
	}
	return command;
}

void
args_free(struct args *args)
{
	for (size_t i = 0; i < OPTIONS; i++)
		free(args->value[i].list);
	memset(args->value, 0, sizeof args->value);
}
