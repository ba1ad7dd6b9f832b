/* Finds the paths in the words of a call by the rows of its command, and looks
 * for files beside the script that names them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/call_paths.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/session/files.h"
#include "io/cells/datetime.h"
#include "io/formats/standards.h"
#include "io/fs/file.h"

/* Returns the index of the option whose value is the word or the text after its
 * "=", or OPTIONS. */
static size_t
find_option_with_value(const struct args *args, const char *word)
{
	const char *equals = strchr(word, '=');
	const char *end = equals != NULL ? equals + 1 : word;
	size_t i = 0;
	while (i < OPTIONS && args->value[i].text != word &&
	       args->value[i].text != end)
		i++;
	return i;
}

static bool
is_path_operand(const struct args *args, const char *word)
{
	size_t i = 0, which;
	while (i < args->n_operand && args->operand[i] != word)
		i++;
	if (i == args->n_operand)
		return false;
	/* "assert feed.csv is 31e87511503a169f" */
	if (strcmp(args->command->name, "assert") == 0)
		return i == 0 && args->n_operand > 2 &&
		       strcmp(args->operand[1], "is") == 0;
	const char *verbs = args->command->operands.expect[0];
	bool verb = i == 0 && islower((unsigned char)word[0]) &&
		    verbs != NULL &&
		    text_find_word_in_list(verbs, word, &which);
	if (args->command->flags & COMMAND_FILES)
		return !verb;
	return (args->command->flags & COMMAND_SPEC) &&
	       !text_find_word_in_list("use list off", word, &which) &&
	       standards_is_file_path(word);
}

static bool
is_goal_setting(const struct command_option *o)
{
	return o->kind == VALUE_TEXT && strcmp(o->name, "goal") == 0;
}

const char *
call_path_in_word(const struct args *args, const char *word,
    const struct command_option **option)
{
	size_t k = find_option_with_value(args, word);
	*option = k < OPTIONS ? command_option_at(args->command, k) : NULL;
	if (*option == NULL)
		return is_path_operand(args, word) ? word : NULL;
	const char *value = args->value[k].text;
	bool path =
	    is_goal_setting(*option) ||
	    value_is_file(*option, &args->value[k]) ||
	    ((*option)->kind == VALUE_SPEC && standards_is_file_path(value));
	return path ? value : NULL;
}

/* As call_paths_map, with the files of envelopes in a goal, which may be the
 * name of one file. */
static char *
map_paths_of_goal(const char *goal,
    char *(*map)(const char *path, const void *of), const void *of)
{
	char *file = map(goal, of);
	if (file_exists(goal) || file_exists(file))
		return file;
	free(file);
	char *whole = xstrdup("");
	for (const char *at = goal; *at != '\0';) {
		size_t n = text_length_of_list_item(at);
		FREED char *copy = xstrndup(at, n);
		const char *part = text_trim(copy);
		FREED char *path = map(part, of);
		bool condition =
		    n < strlen(goal) && strpbrk(part, "<>=%") != NULL;
		if (!condition &&
		    (standards_is_file_path(part) || file_exists(path)))
			xappend(&whole, "%s", path);
		else
			xappend(&whole, "%.*s", (int)n, at);
		if (at[n] != '\0')
			xappend(&whole, "%c", at[n++]);
		at += n;
	}
	return whole;
}

char *
call_paths_map(const struct command_option *option, const char *paths,
    char *(*map)(const char *path, const void *of), const void *of)
{
	if (option != NULL && is_goal_setting(option))
		return map_paths_of_goal(paths, map, of);
	char *whole = xstrdup("");
	for (const char *at = paths, *next; at != NULL; at = next) {
		size_t length;
		double share;
		next = value_parse_feed_and_share(at, &length, &share);
		FREED char *one = xstrndup(at, length), *mapped = map(one, of);
		size_t rest = next != NULL ? (size_t)(next - at) : strlen(at);
		xappend(&whole, "%s%.*s", mapped, (int)(rest - length),
		    at + length);
	}
	return whole;
}

const char *
call_path_at_sign(const char *word)
{
	static const char *const UNIT[] = {"m/s"};
	struct datetime m;
	const char *at = strrchr(word, '@');
	bool name =
	    at == NULL || at == word || access(word, F_OK) == 0 ||
	    (strchr(at, '/') != NULL && text_file_ending(at, UNIT, 1) > 0 &&
		!datetime_parse(at + 1, &m));
	return name ? NULL : at;
}

size_t
call_path_length_of_file(const char *path)
{
	FREED char *name = xstrdup(path);
	for (char *end = name; end != NULL;) {
		if (access(name, F_OK) == 0)
			return strlen(name);
		char *at = strrchr(name, '@'), *equals = strrchr(name, '=');
		end =
		    at == NULL || (equals != NULL && equals > at) ? equals : at;
		if (end != NULL)
			*end = '\0';
	}
	return 0;
}

struct script_folder {
	const struct session *session;
	const char *folder;
};

static char *
path_beside_script(const char *path, const void *script)
{
	const struct script_folder *of = script;
	const char *name = path;
	while (strncmp(name, "./", 2) == 0)
		name += 2;
	FREED char *beside = xasprintf("%s/%s", of->folder, name);
	bool dots = strcmp(name, "") == 0 || strcmp(name, ".") == 0;
	/* A file that the session wrote is what a later line means. */
	FREED char *file = xstrndup(path, call_path_length_of_file(path));
	bool found = path[0] != '/' && !dots &&
		     call_path_length_of_file(beside) > 0 &&
		     (file[0] == '\0' || !files_is_written(of->session, file));
	return xstrdup(found ? beside : path);
}

/* True if the word names a file to write. */
static bool
is_word_written(const struct args *args, const struct command_option *option)
{
	static const char WRITERS[] = "save write export";
	size_t which;
	if (option != NULL)
		return strcmp(option->name, "out") == 0;
	return text_find_word_in_list(WRITERS, args->command->name, &which) ||
	       text_find_word_in_list(WRITERS, args->operand[0], &which);
}

bool
call_paths_find_in_folder(const struct session *s, const struct args *args,
    struct words *words, const char *folder)
{
	const struct script_folder script = {s, folder};
	/* The operands of args are the words as they were. */
	FREED char **was = xcalloc(words->n, sizeof *was);
	bool any = false;
	for (size_t i = 1; i < words->n; i++) {
		char *word = words->text[i];
		const struct command_option *o;
		const char *path = call_path_in_word(args, word, &o);
		if (path == NULL || is_word_written(args, o))
			continue;
		FREED char *found =
		    call_paths_map(o, path, path_beside_script, &script);
		if (strcmp(found, path) == 0)
			continue;
		words->text[i] =
		    xasprintf("%.*s%s", (int)(path - word), word, found);
		was[i] = word;
		any = true;
	}
	for (size_t i = 1; i < words->n; i++)
		free(was[i]);
	return any;
}
