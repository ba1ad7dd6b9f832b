/* Words as options and operands of a command.  The grammar is that of
 * tipspeed(1), COMMAND LANGUAGE.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/parse.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

static void
unknown_option(
    const struct command *command, const char *name, struct error *error)
{
	error_set(
	    error, ERROR_USAGE, "%s has no option '%s'", command->name, name);
	const struct command_option *o;
	for (size_t i = 0; (o = command_option_at(command, i)) != NULL; i++) {
		if (text_distance(o->name, name) > 2)
			continue;
		error_hint(error, "did you mean '%s'?", o->name);
		return;
	}
	char *usage = command_usage(command);
	error_hint(error, "usage: %s", usage);
	free(usage);
}

/* Index of the option so called; OPTIONS, with an error, where there is none or
 * it has been given. */
static size_t
new_option(const struct args *args, const char *name, struct error *error)
{
	size_t i = command_option_index(args->command, name);
	if (i == OPTIONS)
		unknown_option(args->command, name, error);
	else if (args->value[i].given)
		error_set(error, ERROR_USAGE, "%s is given twice", name);
	else
		return i;
	return OPTIONS;
}

static bool
take_value(size_t i, const char *word, struct args *args, struct error *error)
{
	args->value[i].given = true;
	return value_take(
	    command_option_at(args->command, i), word, &args->value[i], error);
}

/* One word behind the command's name: key=value, the bare option or an
 * operand. */
static bool
take_argument(const char *word, struct args *args, struct error *error)
{
	const struct command *command = args->command;
	const char *equals = strchr(word, '=');
	size_t key = equals != NULL ? (size_t)(equals - word) : 0;
	bool is_key =
	    key > 0 &&
	    strspn(word, "abcdefghijklmnopqrstuvwxyz0123456789_") == key;
	size_t i = OPTIONS;
	if (is_key && command_option_at(command, 0) != NULL) {
		char *name = xstrndup(word, key);
		i = new_option(args, name, error);
		free(name);
		if (i == OPTIONS)
			return false;
		word = equals + 1;
	} else if (command->bare != NULL) {
		size_t bare = command_option_index(command, command->bare);
		i = args->value[bare].given ? OPTIONS : bare;
	}
	if (i < OPTIONS)
		return take_value(i, word, args, error);
	args->operand[args->n_operand++] = word;
	return true;
}

/* True, with the error, when a name stands alone at the end: "set method". */
static bool
lacks_value(
    const struct command *command, const char *name, struct error *error)
{
	size_t i = command_option_index(command, name);
	return i < OPTIONS &&
	       !value_wanted(command_option_at(command, i), error);
}

/* "method classes" where "method=classes" would do. */
static bool
take_pair(
    const char *name, const char *word, struct args *args, struct error *error)
{
	size_t i = new_option(args, name, error);
	return i < OPTIONS && take_value(i, word, args, error);
}

static bool
take_fallbacks(struct args *args, struct error *error)
{
	const struct command_option *o;
	bool ok = true;
	for (size_t i = 0;
	     ok && (o = command_option_at(args->command, i)) != NULL; i++)
		if (!args->value[i].given && o->fallback[0] != '\0')
			ok = value_take(o, o->fallback, &args->value[i], error);
	return ok;
}

/* True, with the error, for "69 m/s". */
static bool
is_lone_unit(const struct args *args, const char *word, struct error *error)
{
	const struct command_option *o;
	for (size_t i = 0; (o = command_option_at(args->command, i)) != NULL;
	     i++) {
		if (!args->value[i].given || o->unit[0] == '\0' ||
		    strcmp(o->unit, word) != 0)
			continue;
		error_set(error, ERROR_USAGE,
		    "expected no space before the unit\n"
		    "write %s%s",
		    args->value[i].text, word);
		return true;
	}
	return false;
}

/* True, with the error, for "p80" and for "P80=5.5", as tables head it. */
static bool
is_lone_option(
    const struct command *command, const char *word, struct error *error)
{
	size_t n = strcspn(word, "=");
	char *cut = xstrndup(word, n), *name = text_fold(cut);
	bool is = command_option_index(command, name) < OPTIONS;
	if (is && word[n] == '=') {
		error_set(error, ERROR_USAGE,
		    "expected an option in lower case, got '%s'\n"
		    "write %s%s",
		    word, name, word + n);
	} else if (is) {
		error_set(error, ERROR_USAGE,
		    "expected a value for %s\n"
		    "write %s=VALUE",
		    name, name);
	}
	free(cut);
	free(name);
	return is;
}

static bool
check_operands(const struct args *args, struct error *error)
{
	const struct command *command = args->command;
	const char *more = args->n_operand > command->operands.most
			       ? args->operand[command->operands.most]
			       : NULL;
	if (more == NULL && args->n_operand >= command->operands.least)
		return true;
	if (more != NULL && is_lone_unit(args, more, error))
		return false;
	if (more != NULL && is_lone_option(command, more, error))
		return false;
	char *usage = command_usage(command);
	error_set(error, ERROR_USAGE,
	    more != NULL ? "%s: unexpected word '%s'\n"
			   "usage: %s"
			 : "%s: expected %s\n"
			   "usage: %s",
	    command->name, more != NULL ? more : command->operands.usage,
	    usage);
	free(usage);
	return false;
}

/* "speed = 74", "speed =74" and "speed= 74" for an option want another hint
 * than each of their words. */
static void
hint_blanks(const struct command *command, const struct words *words,
    struct error *error)
{
	for (size_t i = 2; command != NULL && i < words->n; i++) {
		const char *name = words->text[i - 1], *word = words->text[i];
		size_t n = strlen(name), signs = word[0] == '=';
		bool ends = n > 0 && name[n - 1] == '=';
		bool alone = signs == 1 && word[1] == '\0';
		const char *value = !alone             ? word + signs
				    : i + 1 < words->n ? words->text[i + 1]
						       : "..";
		char *key = xstrndup(name, ends ? n - 1 : n);
		if ((signs == 1 || ends) &&
		    command_option_index(command, key) < OPTIONS)
			error_hint(error,
			    "write it without spaces around =: %s=%s", key,
			    value);
		free(key);
	}
}

/* Adds the place of word i to an error that has none. */
static void
put_place(struct error *error, struct place place,
    const struct command *command, const struct words *words, size_t i)
{
	hint_blanks(command, words, error);
	error_place(error, place.file, place.line, words->column[i]);
}

static void
unknown_command(const char *name, bool prompt, struct error *error)
{
	char *several = command_candidates(name);
	bool one = prompt && several[0] != '\0';
	const char *near = one ? several : command_nearest(name);
	error_set(error, ERROR_USAGE, "there is no command '%s'", name);
	if (prompt && strchr(several, ',') != NULL)
		error_hint(error, "did you mean one of %s?", several);
	else if (near != NULL)
		error_hint(error, "did you mean '%s'?", near);
	else
		error_hint(error, "run 'help' for the commands");
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
		put_place(error, place, NULL, words, 0);
		return NULL;
	}
	args->command = command;
	for (size_t i = 1; i < words->n; i++) {
		if (command->setting != NULL && i + 1 == words->n &&
		    lacks_value(command, words->text[i], error)) {
			put_place(error, place, command, words, i);
			return NULL;
		}
		bool pair = command->setting != NULL && i + 1 < words->n &&
			    strchr(words->text[i], '=') == NULL;
		bool ok = pair ? take_pair(words->text[i], words->text[i + 1],
				     args, error)
			       : take_argument(words->text[i], args, error);
		if (!ok) {
			put_place(error, place, command, words, i);
			return NULL;
		}
		i += pair;
	}
	if (!check_operands(args, error) || !take_fallbacks(args, error)) {
		size_t at = 0;
		for (size_t i = 1;
		     i < words->n && args->n_operand > command->operands.most;
		     i++)
			if (words->text[i] ==
			    args->operand[command->operands.most])
				at = i;
		put_place(error, place, command, words, at);
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
