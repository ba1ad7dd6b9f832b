/* Lookup in the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/command.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "core/model/breakage.h"

/* In the order of help and manual. */
static const struct {
	const char *name;
	const struct command *command;
} GROUPS[] = {{N_("data"), TABLE_DATA}, {N_("calibration"), TABLE_FIT},
    {N_("answers"), TABLE_ANSWERS}, {N_("pictures"), TABLE_PICTURES},
    {N_("store"), TABLE_STORE}, {N_("model"), TABLE_MODEL},
    {N_("session"), TABLE_SESSION}};

const struct command *
command_next(const struct command *after)
{
	bool take = after == NULL;
	for (size_t g = 0; g < ARRAY_LEN(GROUPS); g++)
		for (const struct command *c = GROUPS[g].command;
		     c->name != NULL; c++) {
			if (take)
				return c;
			take = c == after;
		}
	return NULL;
}

const char *
command_group_name(const struct command *command)
{
	for (size_t g = 0; g < ARRAY_LEN(GROUPS); g++)
		for (const struct command *c = GROUPS[g].command;
		     c->name != NULL; c++)
			if (c == command)
				return GROUPS[g].name;
	return NULL;
}

static bool
has_two_word_alias(const struct command *command)
{
	return command->alias != NULL && strchr(command->alias, ' ') != NULL;
}

const char *
command_shown_name(const struct command *command)
{
	return has_two_word_alias(command) ? command->alias : command->name;
}

const char *
command_other_name(const struct command *command)
{
	return has_two_word_alias(command) ? command->name : command->alias;
}

/* True if the word is "NAME=.." for an option of the command, or a range for
 * the option that a bare word sets. */
static bool
is_option_or_bare_range(const struct command *command, const char *word)
{
	size_t n = strcspn(word, "=");
	FREED char *name = xstrndup(word, n);
	bool bare = word[n] == '\0' && strstr(word, "..") != NULL &&
		    command->bare != NULL;
	size_t i = command_option_index(command, bare ? command->bare : name);
	return bare ? i < OPTIONS &&
			  command_option_at(command, i)->kind == VALUE_NUMBERS
		    : word[n] != '\0' && i < OPTIONS;
}

const struct command *
command_find_by_options(
    const struct command *command, char *const *word, size_t n)
{
	const struct command *found = command;
	size_t most = 0;
	for (size_t k = 0; k < ARRAY_LEN(command->others); k++) {
		const struct command *other =
		    command->others[k] != NULL
			? command_find(command->others[k])
			: NULL;
		size_t taken = 0;
		for (size_t i = 0; i < n && other != NULL; i++)
			taken += !is_option_or_bare_range(command, word[i]) &&
				 is_option_or_bare_range(other, word[i]);
		found = taken > most ? other : found;
		most = taken > most ? taken : most;
	}
	return found;
}

const struct command *
command_find(const char *name)
{
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;)
		if (strcmp(c->name, name) == 0 ||
		    (c->alias != NULL && strcmp(c->alias, name) == 0))
			return c;
	return NULL;
}

/* True if a one-word name of the command begins with `start`. */
static bool
has_name_or_alias_beginning_with(const struct command *c, const char *start)
{
	size_t n = strlen(start);
	return strncmp(c->name, start, n) == 0 ||
	       (c->alias != NULL && !has_two_word_alias(c) &&
		   strncmp(c->alias, start, n) == 0);
}

const struct command *
command_find_abbreviated(const char *name, bool prompt)
{
	const struct command *found = command_find(name);
	if (found != NULL || !prompt)
		return found;
	/* q quits, as in full-screen mode and in pagers. */
	enum { LEAST = 2 };
	FREED char *start = text_fold_case_and_accents(name);
	bool leaves = strcmp(start, "q") == 0;
	size_t n = strlen(start) < LEAST && !leaves ? LEAST : 0;
	const struct command *exact = command_find(start);
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		if (!has_name_or_alias_beginning_with(c, start))
			continue;
		found = c;
		n++;
	}
	return exact != NULL ? exact : n == 1 ? found : NULL;
}

char *
command_names_beginning_with(const char *name)
{
	char *list = xstrdup("");
	FREED char *start = text_fold_case_and_accents(name);
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;)
		if (has_name_or_alias_beginning_with(c, start))
			xappend_to_list(&list, ", ", "%s", c->name);
	return list;
}

const char *
command_nearest_name(const char *typed)
{
	/* Names from other programs. */
	static const char *const OTHERS[][2] = {{"close", "drop"},
	    {"delete", "drop"}, {"feed", "set feed"}, {"full", "tui"},
	    {"full screen", "tui"}, {"fullscreen", "tui"}, {"goal", "set goal"},
	    {"open", "load"}, {"q", "quit"}, {"remove", "drop"}, {"rm", "drop"},
	    {"run", "calibrate"}, {"speed", "predict"}, {"store", "store list"},
	    {"unload", "drop"}};
	const char *nearest = NULL;
	FREED char *name = text_fold_case_and_accents(typed);
	size_t least = 3; /* more edits than this is another word */
	for (size_t i = 0; i < ARRAY_LEN(OTHERS); i++)
		if (strcmp(OTHERS[i][0], name) == 0)
			return OTHERS[i][1];
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		size_t d = text_edit_distance(c->name, name);
		size_t n = strlen(name);
		if (n >= 3 && strncmp(c->name, name, n) == 0)
			d = 1;
		if (d < least) {
			least = d;
			nearest = c->name;
		}
	}
	return nearest;
}

/* Appends the parameters of a model that no model before it has. */
static void
add_command_options_of_params(
    const struct breakage *model, struct command_option *row)
{
	bool own = model != BREAKAGES[0] && !model->bypass;
	for (size_t j = 0; j < model->n; j++) {
		const struct param_info *p = &model->parameter[j];
		size_t i = 0;
		while (i < OPTIONS && row[i].name != NULL &&
		       strcmp(row[i].name, p->name) != 0)
			i++;
		assert(i < OPTIONS);
		if (row[i].name != NULL)
			continue;
		row[i] = (struct command_option){.name = p->name,
		    .kind = VALUE_NUMBER,
		    .unit = strcmp(p->unit, "-") == 0 ? "" : p->unit,
		    .least = p->least,
		    .most = p->most,
		    .fallback = "",
		    .brief = own ? xasprintf(tr("%s, model %s"), tr(p->meaning),
				       model->name)
				 : xstrdup(p->meaning)};
	}
}

/* Returns option i of `params`, which takes the parameters of all models; makes
 * the rows of these on first use. */
static const struct command_option *
params_command_option_at(size_t i)
{
	static struct command_option row[OPTIONS + 1];
	bool made = row[0].name != NULL;
	for (size_t m = 0; !made && m < breakage_count_models(); m++)
		add_command_options_of_params(BREAKAGES[m], row);
	return &row[i];
}

const struct command_option *
command_own_option_at(const struct command *command, size_t i)
{
	const struct command_option *o =
	    command->flags & COMMAND_PARAMS ? params_command_option_at(i)
	    : command->option != NULL       ? &command->option[i]
					    : NULL;
	return o != NULL && o->name != NULL ? o : NULL;
}

/* Returns option i of several lists, counted through; NULL after the last. */
static const struct command_option *
option_at_index(const struct command_option *const *list, size_t i)
{
	for (; *list != NULL; list++)
		for (const struct command_option *o = *list; o->name != NULL;
		     o++)
			if (i-- == 0)
				return o;
	return NULL;
}

const struct command_option *
command_option_at(const struct command *command, size_t i)
{
	size_t own = 0;
	while (own <= i && command_own_option_at(command, own) != NULL)
		own++;
	return own > i ? command_own_option_at(command, i)
		       : option_at_index(command->shared, i - own);
}

const struct command_option *
command_shared_option_at(size_t i)
{
	static const struct command_option *const ALL[] = {SHARED_RPM,
	    SHARED_FEED, SHARED_MACHINE, SHARED_SIEVES, SHARED_CUT, NULL};
	return option_at_index(ALL, i);
}

char *
command_shared_option_names(const struct command *command)
{
	char *list = xstrdup("");
	const struct command_option *o;
	for (size_t i = 0; (o = option_at_index(command->shared, i)) != NULL;
	     i++)
		xappend_to_list(&list, ", ", "%s", o->name);
	return list;
}

size_t
command_option_index(const struct command *command, const char *name)
{
	const struct command_option *o;
	for (size_t i = 0; (o = command_option_at(command, i)) != NULL; i++)
		if (strcmp(o->name, name) == 0)
			return i;
	return OPTIONS;
}

bool
command_takes_speeds(const struct command *command)
{
	const char *usage = command->operands.usage;
	return usage != NULL && strstr(usage, "SPEED") != NULL &&
	       (command->flags & COMMAND_FILES) == 0;
}

static const char *
option_placeholder(const struct command_option *o)
{
	switch (o->kind) {
	case VALUE_NUMBER:
		return "X";
	case VALUE_NUMBERS:
		return "X,X..";
	case VALUE_WHOLE:
		return "N";
	case VALUE_CHOICE:
		return option_choices(o);
	case VALUE_FILE:
		return "FILE";
	case VALUE_FEED:
		return "V|FILE";
	case VALUE_SPEC:
		return "NAME";
	default:
		return "TEXT";
	}
}

char *
command_usage_text(const struct command *command)
{
	char *usage = xstrdup(command_shown_name(command));
	if (command->operands.usage != NULL)
		xappend(&usage, " %s", command->operands.usage);
	const struct command_option *o;
	for (size_t i = 0; (o = command_own_option_at(command, i)) != NULL;
	     i++) {
		FREED char *part =
		    xasprintf(" [%s=%s]", o->name, option_placeholder(o));
		for (char *p = part + 1; *p != '\0'; p++)
			if (*p == ' ')
				*p = '|';
		xappend(&usage, "%s", part);
	}
	return usage;
}

/* Returns a limit as text; "" if it is so large that there is none. */
static char *
option_limit_text(double limit)
{
	if (fabs(limit) > 1e15)
		return xstrdup("");
	return xasprintf(fabs(limit) >= 1e5 ? "%.0f" : "%g", limit);
}

const char *
option_choices(const struct command_option *o)
{
	return o->kind == VALUE_CHOICE && o->choices == NULL
		   ? breakage_model_names()
		   : o->choices;
}

char *
command_option_valid_values_text(const struct command_option *o)
{
	if (o->kind == VALUE_TEXT)
		return xstrdup("text");
	if (o->kind == VALUE_FILE)
		return xstrdup(tr("file"));
	if (o->kind == VALUE_SPEC)
		return xstrdup(tr("name or file"));
	if (o->kind == VALUE_CHOICE) {
		char *list = xstrdup("");
		for (const char *c = option_choices(o); *c != '\0'; c++)
			xappend(&list, *c == ' ' ? ", " : "%c", *c);
		if (o->unit[0] != '\0')
			xappend(&list, " %s", o->unit);
		return list;
	}
	FREED char *least = option_limit_text(o->least),
		   *most = option_limit_text(o->most);
	const char *blank = o->unit[0] != '\0' ? " " : "";
	FREED char *range =
	    most[0] != '\0'
		? xasprintf(tr("%s to %s%s%s"), least, most, blank, o->unit)
		: xasprintf(tr("%s or more%s%s"), least, blank, o->unit);
	return o->kind == VALUE_FEED ? xasprintf(tr("%s, or file"), range)
	       : strcmp(o->unit, "m/s") == 0 ? xasprintf(tr("%s or rpm"), range)
					     : xstrdup(range);
}

char *
command_option_help_text(const struct command_option *o)
{
	FREED char *limits = command_option_valid_values_text(o);
	return xasprintf(
	    o->fallback[0] != '\0' ? tr("%s (%s), default %s") : "%s (%s)%s",
	    tr(o->brief), limits, o->fallback);
}

/* As a feed, a number is never 0, see SHARED_FEED. */
bool
value_is_file(const struct command_option *option, const struct value *value)
{
	bool feed = option->kind == VALUE_FEED && value->number == 0;
	return value->given && ((option->kind == VALUE_FILE &&
				    strcmp(value->text, "off") != 0) ||
				   (feed && strcmp(value->text, "mean") != 0));
}

/* Returns the index of the option whose value is this member, or OPTIONS. */
static size_t
option_index_of_member(const struct args *args, const void *member)
{
	size_t offset = (size_t)((const char *)member - (const char *)args);
	const struct command_option *o;
	for (size_t i = 0; (o = command_option_at(args->command, i)) != NULL;
	     i++)
		if (o->offset == offset)
			return i;
	return OPTIONS;
}

bool
args_is_given(const struct args *args, const void *member)
{
	size_t i = option_index_of_member(args, member);
	return i < OPTIONS && args->value[i].given;
}

const char *
args_value_text(const struct args *args, const void *member)
{
	size_t i = option_index_of_member(args, member);
	assert(i < OPTIONS);
	return args->value[i].text;
}

const char *
args_option_name(const struct args *args, const void *member)
{
	size_t i = option_index_of_member(args, member);
	assert(i < OPTIONS);
	return command_option_at(args->command, i)->name;
}
