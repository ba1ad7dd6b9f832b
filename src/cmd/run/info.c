/* help, apropos, man, version, quit: print the command table, the manual and
 * the version.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <assert.h>
#include <gsl/gsl_version.h>
#include <jansson.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"
#include "cmd/lang/table.h"
#include "cmd/lang/usage.h"
#include "config.h"
#include "core/numeric/isa.h"
#include "plot/picture.h"

/* Returns where help goes: people read it, so it goes to the notes if results
 * are JSON or CSV. */
static FILE *
help_output_stream(const struct session *s)
{
	return ANSWER_FORMATS[s->set.format].exact ? s->notes : s->out;
}

/* Prints help for a new user. */
static void
print_getting_started(const struct session *s)
{
	const int width = session_text_width(s);
	FILE *out = help_output_stream(s);
	text_print_wrapped(
	    tr("In the order of work, for the site file quarry.csv:"), 0, width,
	    out);
	text_print_wrapped(
	    "  load quarry.csv, check, calibrate, validate, predict 74", 0,
	    width, out);
	fputc('\n', out);
	const char *last = "";
	FREED char *groups = xstrdup("");
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		if (c->flags & COMMAND_DAILY)
			usage_print_command_brief(c, width, out);
		if (strcmp(command_group_name(c), last) != 0)
			xappend_to_list(
			    &groups, ", ", "%s", command_group_name(c));
		last = command_group_name(c);
	}
	FREED char *line = xasprintf(tr("groups: %s"), groups);
	fputc('\n', out);
	text_print_wrapped(line, 0, width, out);
	text_print_wrapped(
	    tr("help all lists all commands, help GROUP those of a group, "
	       "help COMMAND explains one, help options what many take, "
	       "help trust the light; apropos WORD searches."),
	    0, width, out);
	text_print_wrapped(
	    tr("undo undoes the last change, quit exits; man tutorial is for "
	       "the first hour."),
	    0, width, out);
}

static bool
is_command_group(const char *name)
{
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;)
		if (strcmp(command_group_name(c), name) == 0)
			return true;
	return false;
}

/* text: may be NULL, which contains nothing. */
static bool
folded_text_contains(const char *text, const char *folded)
{
	FREED char *here = text_fold_case_and_accents(text != NULL ? text : "");
	return strstr(here, folded) != NULL;
}

/* True if anything that the table says about the command contains the word. */
static bool
command_help_has_word(const struct command *c, const char *folded)
{
	const char *const text[] = {
	    c->name, c->brief, c->text, c->more, c->operands.usage, c->alias};
	bool found = false;
	for (size_t i = 0; i < ARRAY_LEN(text); i++)
		found = found || folded_text_contains(text[i], folded);
	const struct command_option *o;
	for (size_t i = 0; !found && (o = command_option_at(c, i)) != NULL; i++)
		found = folded_text_contains(o->name, folded) ||
			folded_text_contains(o->brief, folded) ||
			folded_text_contains(option_choices(o), folded);
	return found;
}

/* Prints the commands whose help contains a word; returns their number. */
static size_t
print_commands_with_word(const struct session *s, const char *word)
{
	FREED char *folded = text_fold_case_and_accents(word);
	size_t found = 0;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;)
		if (command_help_has_word(c, folded)) {
			usage_print_command_brief(
			    c, session_text_width(s), help_output_stream(s));
			found++;
		}
	return found;
}

static bool
error_unknown_help_topic(const char *name, struct error *error)
{
	const char *near = command_nearest_name(name);
	if (breakage_find_by_name(name) < breakage_count_models())
		return error_set(error, ERROR_USAGE,
		    "'%s' is a breakage model, not a command\nrun 'show "
		    "models', or 'man model'",
		    name);
	return error_set(error, ERROR_USAGE,
	    near != NULL
		? N_("there is no command '%s'\ndid you mean '%s'?")
		: N_("there is no command '%s', and no help mentions it\n"
		     "run 'help all' for the commands"),
	    name, near != NULL ? near : name);
}

/* Finds a command by a name of two words, its own or that of other programs:
 * "full screen". */
static const struct command *
find_two_word_command(const char *words)
{
	const struct command *command = command_find(words);
	const char *other =
	    command != NULL ? NULL : command_nearest_name(words);
	return other != NULL ? command_find(other) : command;
}

bool
cmd_help(struct session *s, const struct args *args, struct error *error)
{
	const int width = session_text_width(s);
	FILE *out = help_output_stream(s);
	size_t n = args->n_operand;
	bool example = n > 1 && strcmp(args->operand[n - 1], "example") == 0;
	n -= example;
	const char *name = n > 0 ? args->operand[0] : NULL;
	FREED char *both =
	    n > 1 ? xasprintf("%s %s", name, args->operand[1]) : NULL;
	const struct command *command = both != NULL
					    ? find_two_word_command(both)
					: name != NULL ? command_find(name)
						       : NULL;
	if (n > 2 || (n == 2 && command == NULL))
		return error_set(error, ERROR_USAGE,
		    "help: expected 'example' after the command, got '%s'\n"
		    "write: help %s",
		    args->operand[n - 1], name);
	if (command != NULL && example)
		usage_print_example(command, "", out);
	else if (command != NULL)
		usage_print_command_help(command, width, out);
	else if (name == NULL)
		print_getting_started(s);
	else if (strcmp(name, "all") == 0 && !example)
		usage_print_command_list(NULL, width, out);
	else if (strcmp(name, "options") == 0 && !example)
		usage_print_shared_options(width, out);
	else if (strcmp(name, "trust") == 0 && !example)
		usage_print_trust_lights(width, out);
	else if (strcmp(name, "keys") == 0 && !example)
		text_print_wrapped(
		    tr("In full-screen mode, ? lists the keys of the page; "
		       "'man tui' has the keys of all pages."),
		    0, width, out);
	else if (is_command_group(name) && !example)
		usage_print_command_list(name, width, out);
	else
		return (!example && command_nearest_name(name) == NULL &&
			   print_commands_with_word(s, name) > 0) ||
		       error_unknown_help_topic(name, error);
	return true;
}

bool
cmd_apropos(struct session *s, const struct args *args, struct error *error)
{
	if (print_commands_with_word(s, args->operand[0]) > 0)
		return true;
	return error_set(error, ERROR_USAGE,
	    "nothing in the help mentions '%s'\n"
	    "run 'help' for the commands",
	    args->operand[0]);
}

/* Shows the help of a command if `man` has no page of that name. */
static bool
show_help_for_missing_man_page(const struct session *s,
    const struct command_option *page, const char *name, struct error *error)
{
	struct value value;
	const struct command *command = command_find(name);
	const char *near = command_nearest_name(name);
	if (command != NULL) {
		usage_print_command_help(
		    command, session_text_width(s), help_output_stream(s));
		return true;
	}
	value_parse(page, name, &value, error);
	if (error->hint[0] == '\0' && near != NULL)
		error_set_hint(error, "did you mean '%s'?", near);
	else if (error->hint[0] == '\0')
		error_set_hint(error, "name a command instead: man find");
	return false;
}

bool
cmd_man(struct session *s, const struct args *args, struct error *error)
{
	/* In the order of the option's choices. */
	static const char *const PAGES[] = {"tipspeed.1", "tipspeed-tutorial.7",
	    "tipspeed-tui.1", "tipspeed-site.5", "tipspeed-spec.5",
	    "tipspeed-model.7", "tipspeed-circuit.5"};
	const struct command_option *page = command_option_at(args->command, 0);
	const char *word = args->n_operand > 0 ? args->operand[0] : NULL;
	size_t i = args->page;
	if (word != NULL &&
	    !text_find_word_in_list(option_choices(page), word, &i))
		return show_help_for_missing_man_page(s, page, word, error);
	assert(i < ARRAY_LEN(PAGES));
	if (!s->safe && s->hooks.show_manual_page != NULL &&
	    s->hooks.show_manual_page(PAGES[i]))
		return true;
	usage_print_command_list(
	    NULL, session_text_width(s), help_output_stream(s));
	session_print_note(s,
	    "the page %s is shown at the prompt, without --safe, if man(1) is "
	    "installed; its source is in the folder man",
	    PAGES[i]);
	return true;
}

bool
cmd_version(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	struct answer *r = answer_new("version");
	answer_add_columns(r, "part, version");
	answer_add_name_value_row(r, "tipspeed", "%s", PACKAGE_VERSION);
	answer_add_name_value_row(r, "gsl", "%s", GSL_VERSION);
	answer_add_name_value_row(r, "jansson", "%s", JANSSON_VERSION);
	answer_add_name_value_row(r, "pictures", "%s", picture_list_formats());
	answer_add_name_value_row(
	    r, "instructions", "%s", isa_name(isa_usable_or_best(s->isa)));
	fields_put_values(answer_json_fields(r), "version %s", PACKAGE_VERSION);
	return session_show_answer(s, r);
}

bool
cmd_quit(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	s->quit = true;
	return true;
}
