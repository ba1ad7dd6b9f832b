/* Finds the word at the cursor, what the command table expects there, and the
 * candidates for it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/run/complete.h"

#include <assert.h>
#include <ctype.h>
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "io/fs/file.h"
#include "io/fs/shipped.h"
#include "io/formats/standards.h"

struct work {
	const struct session *session;
	struct completion *result;
	/* The word so far, without quotes; folded: and without case and
	 * accents. */
	char *typed, *folded;
	/* The word began with a quote. */
	bool quoted;
};

/* Skips texts with control characters, because readline prints candidates as
 * they are. */
static void
add_completion(struct work *w, const char *text, char append)
{
	struct completion *c = w->result;
	FREED char *shown = text_with_control_escaped(text);
	if (strcmp(shown, text) != 0)
		return;
	c->candidate = xgrow_by_one(c->candidate, c->n, sizeof *c->candidate);
	c->candidate[c->n++] = (struct candidate){xstrdup(text), append};
}

static void
add_completion_if_matching(struct work *w, const char *text, char append)
{
	if (strncmp(text, w->typed, strlen(w->typed)) == 0)
		add_completion(w, text, append);
}

/* True if a name in lower case begins as typed, ignoring case and accents. */
static bool
begins_as_typed(const struct work *w, const char *name)
{
	return strncmp(name, w->folded, strlen(w->folded)) == 0;
}

/* Offers the first word of a name, unless it was offered before. */
static void
offer_command_word_once(struct work *w, const char *name)
{
	FREED char *word = xstrndup(name, strcspn(name, " "));
	bool there = false;
	for (size_t i = 0; i < w->result->n && !there; i++)
		there = strcmp(w->result->candidate[i].text, word) == 0;
	if (!there)
		add_completion_if_matching(w, word, ' ');
}

static void
complete_with_commands(struct work *w)
{
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		offer_command_word_once(w, c->name);
		if (c->alias != NULL)
			offer_command_word_once(w, c->alias);
	}
}

/* Offers the second word of names whose first word is `first`. */
static void
complete_with_second_words(struct work *w, const char *first)
{
	size_t n = strlen(first);
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;)
		if (c->alias != NULL && strncmp(c->alias, first, n) == 0 &&
		    c->alias[n] == ' ')
			add_completion_if_matching(w, c->alias + n + 1, ' ');
}

static void
complete_with_command_groups(struct work *w)
{
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;)
		add_completion_if_matching(w, command_group_name(c), ' ');
}

static void
complete_with_assertable_names(struct work *w)
{
	for (size_t i = 0; i < ANSWERS_ASSERTED; i++)
		add_completion_if_matching(w, ASSERTED_NAMES[i].name, ' ');
}

static void
complete_with_parameters(struct work *w)
{
	const struct breakage *of = BREAKAGES[w->session->set.model.breakage];
	for (size_t j = 0; j < of->n; j++)
		add_completion_if_matching(w, of->parameter[j].name, ' ');
}

/* Ignores case and accents, as `use` does. */
static void
complete_with_loaded_sites(struct work *w)
{
	for (size_t i = 0; i < w->session->n_entry; i++)
		if (begins_as_typed(w, w->session->entry[i].key))
			add_completion(w, w->session->entry[i].key, ' ');
}

static void
complete_with_run_speeds(struct work *w)
{
	if (w->session->n_entry == 0)
		return;
	const struct site *site = w->session->entry[w->session->current].site;
	for (size_t r = 0; r < site->n_run; r++) {
		if (site_run_repeats_speed(site, r))
			continue;
		FREED char *text = xasprintf("%g", site->run[r].speed);
		add_completion_if_matching(w, text, ' ');
	}
}

/* Quotes a name with characters that would end the word. */
static void
add_material_completion(void *data, const char *name)
{
	struct work *w = data;
	bool quotes = w->quoted || name[strcspn(name, " ;|<>")] != '\0';
	FREED char *text = quotes ? xasprintf("\"%s\"", name) : xstrdup(name);
	add_completion(w, text, ' ');
}

/* Ignores case and accents, as `recall` does.  Offers only so many as one would
 * read. */
static void
complete_with_material_names(struct work *w)
{
	enum { MOST = 200 };
	struct material_list paper = {0};
	struct error error = {0};
	store_visit_names_with_prefix(w->session->store, w->typed, MOST,
	    add_material_completion, w, &error);
	material_add_table3_to_list(&paper);
	for (size_t i = 0; i < paper.n; i++)
		if (begins_as_typed(w, paper.item[i].name))
			add_material_completion(w, paper.item[i].name);
	material_list_free(&paper);
}

/* Ignores case.  Quotes all names, because they contain spaces. */
static void
complete_with_envelope_names(struct work *w)
{
	struct standards *all = standards_read_built_in();
	for (size_t i = 0; i < all->n; i++) {
		FREED char *name =
		    text_fold_case_and_accents(all->spec[i]->name);
		FREED char *quoted = xasprintf("\"%s\"", all->spec[i]->name);
		if (begins_as_typed(w, name))
			add_completion(w, quoted, ' ');
	}
	standards_free(all);
}

static void
add_file_completion(struct work *w, const char *path)
{
	struct stat status;
	bool folder = stat(path, &status) == 0 && S_ISDIR(status.st_mode);
	bool quotes =
	    w->quoted || path[strcspn(path, " ;|<>")] != '\0' || path[0] == '#';
	/* After a folder the quote stays open, for the rest of the path. */
	FREED char *text = xasprintf("%s%s%s%s", quotes ? "\"" : "", path,
	    folder ? "/" : "", quotes && !folder ? "\"" : "");
	add_completion(w, text, folder ? '\0' : ' ');
}

static void
complete_with_files(struct work *w)
{
	if (w->session->safe)
		return;
	const char *tail = file_name_without_folders(w->typed);
	size_t head = (size_t)(tail - w->typed);
	FREED char *folder = head > 0 ? xstrndup(w->typed, head) : xstrdup(".");
	DIR *dir = opendir(folder);
	if (dir == NULL)
		return;
	for (struct dirent *e; (e = readdir(dir)) != NULL;) {
		const char *name = e->d_name;
		bool hidden = name[0] == '.' && tail[0] != '.';
		bool self = strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
		/* A name that contains a quote cannot be typed. */
		if (hidden || self || strchr(name, '"') != NULL ||
		    strncmp(name, tail, strlen(tail)) != 0)
			continue;
		FREED char *path =
		    xasprintf("%.*s%s", (int)head, w->typed, e->d_name);
		add_file_completion(w, path);
	}
	closedir(dir);
}

/* Offers the shipped sites, which load finds by name, if the word is not empty
 * and no file matches it. */
static void
complete_with_shipped_sites(struct work *w)
{
	static const char END[] = ".csv";
	bool other = w->session->safe || w->typed[0] == '\0';
	for (size_t i = 0; i < w->result->n; i++)
		other = other || w->result->candidate[i].append != '=';
	FREED char *path = shipped_sites_folder();
	DIR *dir = other ? NULL : opendir(path);
	for (struct dirent *e; dir != NULL && (e = readdir(dir)) != NULL;) {
		FREED char *name = xstrdup(e->d_name);
		if (text_ends_with(name, END) && begins_as_typed(w, name)) {
			name[strlen(name) - strlen(END)] = '\0';
			add_completion(w, name, ' ');
		}
	}
	if (dir != NULL)
		closedir(dir);
}

/* The words in capitals of the command table, and what offers candidates for
 * each. */
static const struct {
	const char *word;
	void (*offer)(struct work *);
} KINDS[] = {{"ANSWER", complete_with_assertable_names},
    {"COMMAND", complete_with_commands}, {"FILE", complete_with_files},
    {"GROUP", complete_with_command_groups},
    {"MATERIAL", complete_with_material_names},
    {"PARAMETER", complete_with_parameters},
    {"SHIPPED", complete_with_shipped_sites},
    {"SITE", complete_with_loaded_sites},
    {"SPEC", complete_with_envelope_names},
    {"SPEED", complete_with_run_speeds}};

static void
complete_with_words_of_kind(struct work *w, const char *word)
{
	size_t i = 0;
	while (i < ARRAY_LEN(KINDS) && strcmp(KINDS[i].word, word) != 0)
		i++;
	assert(i < ARRAY_LEN(KINDS));
	KINDS[i].offer(w);
}

/* Offers the words in a list; those in capitals are looked up in KINDS. */
static void
complete_with_words_of_list(struct work *w, const char *list)
{
	FREED char *copy = xstrdup(list);
	char *save = NULL;
	for (char *word = strtok_r(copy, " ", &save); word != NULL;
	     word = strtok_r(NULL, " ", &save))
		if (isupper((unsigned char)word[0]))
			complete_with_words_of_kind(w, word);
		else
			add_completion_if_matching(w, word, ' ');
}

static void
complete_with_operand_values(
    struct work *w, const struct command *command, size_t i)
{
	size_t last = 0;
	while (last + 1 < EXPECTS && command->operands.expect[last + 1] != NULL)
		last++;
	const char *list = command->operands.expect[i < last ? i : last];
	if (i < command->operands.most && list != NULL)
		complete_with_words_of_list(w, list);
}

/* further: after a comma, where a word that stands for all numbers may not
 * follow. */
static void
complete_with_option_values(
    struct work *w, const struct command_option *o, bool further)
{
	if (option_choices(o) != NULL && !further)
		complete_with_words_of_list(w, option_choices(o));
	else if (o->kind == VALUE_FILE || o->kind == VALUE_FEED ||
		 o->kind == VALUE_SPEC)
		complete_with_files(w);
	if (o->kind == VALUE_SPEC)
		complete_with_envelope_names(w);
	if (strcmp(o->unit, "m/s") == 0)
		complete_with_run_speeds(w);
}

static void
complete_with_unused_options(struct work *w, const struct args *used)
{
	const struct command *command = used->command;
	const struct command_option *o;
	for (size_t i = 0; (o = command_option_at(command, i)) != NULL; i++) {
		if (used->value[i].given)
			continue;
		add_completion_if_matching(w, o->name,
		    (command->flags & COMMAND_SETTINGS) != 0 ? ' ' : '=');
		if (command->bare != NULL &&
		    strcmp(o->name, command->bare) == 0)
			complete_with_option_values(w, o, false);
	}
	complete_with_operand_values(w, command, used->n_operand);
}

/* Takes a word in the line, up to the cursor, as what was typed. */
static void
set_word_to_complete(struct work *w, const char *word)
{
	free(w->typed);
	free(w->folded);
	w->quoted = word[0] == '"';
	w->typed = text_without_quotes(word, strlen(word));
	w->folded = text_fold_case_and_accents(w->typed);
}

/* Limits the completion to the part of the word after `behind`. */
static void
set_word_to_complete_after(struct work *w, const char *line, const char *behind)
{
	w->result->start = (size_t)(behind - line) + 1;
	set_word_to_complete(w, behind + 1);
}

/* Returns the option that the word is a value of, because it names the option
 * (*named) or is the bare one; otherwise NULL. */
static const struct command_option *
find_option_of_typed_value(
    const struct args *used, const char *typed, bool *named)
{
	const struct command *command = used->command;
	size_t key = strcspn(typed, "="), i = OPTIONS;
	FREED char *name = xstrndup(typed, key);
	if (typed[key] == '=')
		i = command_option_index(command, name);
	*named = i < OPTIONS;
	if (!*named && command->bare != NULL)
		i = command_option_index(command, command->bare);
	return *named || (i < OPTIONS && !used->value[i].given)
		   ? command_option_at(command, i)
		   : NULL;
}

/* Returns the setting whose value is next, as after "set method "; or NULL. */
static const struct command_option *
setting_awaiting_value(const struct args *used, const char *last)
{
	size_t i = command_option_index(used->command, last);
	return (used->command->flags & COMMAND_SETTINGS) != 0 && i < OPTIONS &&
		       !used->value[i].given
		   ? command_option_at(used->command, i)
		   : NULL;
}

static void
complete_with_options_or_values(
    struct work *w, const struct args *used, const char *line, const char *last)
{
	bool named;
	const struct command_option *o =
	    find_option_of_typed_value(used, w->typed, &named);
	const char *word = line + w->result->start;
	if (named)
		set_word_to_complete_after(w, line, strchr(word, '='));
	bool further =
	    o != NULL && o->kind == VALUE_NUMBERS && strchr(word, ',') != NULL;
	if (further)
		set_word_to_complete_after(w, line, strrchr(word, ','));
	const struct command_option *setting =
	    setting_awaiting_value(used, last);
	if (named)
		complete_with_option_values(w, o, further);
	else if (setting != NULL)
		complete_with_option_values(w, setting, false);
	else
		complete_with_unused_options(w, used);
}

static void
complete_after_given_words(struct work *w, const struct words *words,
    struct place place, const char *line)
{
	struct args used;
	struct error none = {0};
	size_t n = words->n; /* a command is named after help, too */
	if (n == 1 || (n == 2 && strcmp(words->text[0], "help") == 0))
		complete_with_second_words(w, words->text[n - 1]);
	parse_command_words(words, place, &used, &none);
	if (used.command != NULL)
		complete_with_options_or_values(
		    w, &used, line, words->text[words->n - 1]);
	args_free(&used);
}

/* Finds where the last command in a line begins, and its last word.  Returns
 * false if that is in a comment. */
static bool
find_start_of_last_word(const char *line, size_t *command, size_t *word)
{
	bool quoted = false, inside = false;
	size_t i = 0;
	*command = 0;
	for (; line[i] != '\0'; i++) {
		char c = line[i];
		bool ends = !quoted && (isspace((unsigned char)c) || c == ';');
		if (!inside && c == '#') {
			*word = strlen(line);
			return false;
		}
		if (c == '"')
			quoted = !quoted;
		if (!inside && !ends)
			*word = i;
		inside = !ends;
		if (ends && c == ';')
			*command = i + 1;
	}
	if (!inside)
		*word = i;
	return true;
}

static int
compare_completions(const void *a, const void *b)
{
	const struct candidate *p = a, *q = b;
	return strcmp(p->text, q->text);
}

static void
sort_distinct_completions(struct completion *c)
{
	size_t kept = 0;
	if (c->n > 1)
		qsort(c->candidate, c->n, sizeof *c->candidate,
		    compare_completions);
	for (size_t i = 0; i < c->n; i++)
		if (kept > 0 && compare_completions(&c->candidate[kept - 1],
				    &c->candidate[i]) == 0)
			free(c->candidate[i].text);
		else
			c->candidate[kept++] = c->candidate[i];
	c->n = kept;
}

/* line: the text up to the cursor. */
static void
complete_last_word(struct work *w, const char *line)
{
	size_t from;
	if (!find_start_of_last_word(line, &from, &w->result->start))
		return;
	size_t start = w->result->start;
	set_word_to_complete(w, line + start);
	FREED char *before = xstrndup(line + from, start - from);
	struct words words;
	struct error error = {0};
	struct place place = {.file = "", .prompt = true};
	bool ok = words_split_line(before, 0, place, &words, &error);
	if (words.to == TO_FILE || words.to == TO_APPEND) {
		if (words.target != NULL && words.target[0] == '\0')
			complete_with_files(w);
	} else if (ok && words.to == TO_SCREEN && words.n == 0) {
		complete_with_commands(w);
	} else if (ok && words.to == TO_SCREEN) {
		complete_after_given_words(w, &words, place, line);
	}
	words_free(&words);
	free(w->typed);
	free(w->folded);
	sort_distinct_completions(w->result);
}

struct completion *
find_completions_at_cursor(
    const struct session *s, const char *line, size_t cursor)
{
	struct work w = {.session = s};
	w.result = xcalloc(1, sizeof *w.result);
	w.result->start = cursor;
	FREED char *head = xstrndup(line, cursor);
	complete_last_word(&w, head);
	return w.result;
}

void
completion_free(struct completion *c)
{
	if (c == NULL)
		return;
	for (size_t i = 0; i < c->n; i++)
		free(c->candidate[i].text);
	free(c->candidate);
	free(c);
}
