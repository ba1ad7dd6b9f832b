/* Keeps the commands that succeeded as lines that can be run again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/journal.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/session/settings.h"
#include "io/formats/standards.h"

struct journal {
	size_t n, start;
	size_t state, states; /* the current state; how many there were */
	char **line;
};

struct mark
journal_current_place(const struct session *s)
{
	const struct journal *j = s->journal;
	return (struct mark){j->n, j->start, j->state};
}

void
journal_number_new_state(struct session *s)
{
	s->journal->state = ++s->journal->states;
}

static void
append_journal_line(struct journal *j, char *line)
{
	j->line = xrealloc(j->line, j->n + 1, sizeof *j->line);
	j->line[j->n++] = line;
}

struct removed_lines
journal_remove_lines_after(struct session *s, struct mark mark)
{
	struct removed_lines tail = {
	    .from = mark, .to = journal_current_place(s)};
	struct journal *j = s->journal;
	tail.line = xcalloc(j->n + 1, sizeof *tail.line);
	for (size_t i = mark.n; i < j->n; i++)
		tail.line[tail.n++] = j->line[i];
	j->n = mark.n < j->n ? mark.n : j->n;
	j->start = mark.start;
	j->state = mark.state;
	return tail;
}

void
journal_put_back_lines(struct session *s, struct removed_lines *tail)
{
	struct journal *j = s->journal;
	/* Lines may have been added since these were removed. */
	if (tail->to.start != tail->from.start)
		j->start = j->n + tail->to.start - tail->from.n;
	j->state = tail->to.state;
	for (size_t i = 0; i < tail->n; i++)
		append_journal_line(j, tail->line[i]);
	free(tail->line);
	*tail = (struct removed_lines){0};
}

void
removed_lines_free(struct removed_lines *tail)
{
	for (size_t i = 0; i < tail->n; i++)
		free(tail->line[i]);
	free(tail->line);
}

struct journal *
journal_new(void)
{
	return xcalloc(1, sizeof(struct journal));
}

void
journal_free(struct journal *j)
{
	for (size_t i = 0; i < j->n; i++)
		free(j->line[i]);
	free(j->line);
	free(j);
}

/* True for the line "predict 74" and the name predict. */
static bool
is_call_of(const char *line, const char *name)
{
	size_t n = strlen(name);
	return strncmp(line, name, n) == 0 &&
	       (line[n] == '\0' || line[n] == ' ');
}

/* Removes the last line if it is a call of the command `latest`, and the assert
 * lines that check the files that it read. */
static void
remove_last_call_of(struct journal *j, const char *latest)
{
	if (latest == NULL || j->n <= j->start ||
	    !is_call_of(j->line[j->n - 1], latest))
		return;
	free(j->line[--j->n]);
	while (j->n > j->start && is_call_of(j->line[j->n - 1], "assert"))
		free(j->line[--j->n]);
}

void
journal_add_line(struct session *s, const char *latest, const char *line, ...)
{
	struct journal *j = s->journal;
	remove_last_call_of(j, latest);
	va_list ap;
	va_start(ap, line);
	append_journal_line(j, xvasprintf(line, ap));
	va_end(ap);
}

/* True for a line that names no more than a speed and the run of a feed, as the
 * slider's do: "predict speed=74.0 feed=69". */
static bool
names_only_speeds(const char *line)
{
	static const char *const KEYS[] = {"speed=", "rpm=", "feed="};
	for (line += strcspn(line, " "); *line == ' ';) {
		line++;
		for (size_t i = 0; i < ARRAY_LEN(KEYS); i++)
			if (strncmp(line, KEYS[i], strlen(KEYS[i])) == 0)
				line += strlen(KEYS[i]);
		size_t number = strspn(line, "0123456789.");
		line += number;
		line += strncmp(line, "rpm", 3) == 0 ? 3 : 0;
		if (number == 0)
			return false;
	}
	return *line == '\0';
}

void
journal_add_slider_line(
    struct session *s, const char *command, const char *line)
{
	const struct journal *j = s->journal;
	bool replaces = j->n > 0 && names_only_speeds(j->line[j->n - 1]);
	journal_add_line(s, replaces ? command : NULL, "%s", line);
}

void
journal_discard_all_lines(struct session *s)
{
	s->journal->start = s->journal->n;
}

void
journal_add_settings(struct session *s)
{
	if (s->set.seed != 1)
		journal_add_line(s, NULL, "seed %" PRIu64, s->set.seed);
	for (const struct command_option *r = SETTINGS; r->name != NULL; r++) {
		FREED char *text = settings_value_text(r, &s->set);
		if (r->fallback[0] != '\0' && strcmp(text, r->fallback) != 0)
			journal_add_line(s, NULL, "set %s %s", r->name, text);
	}
}

void
journal_append_word(char **line, const char *word)
{
	bool plain = word[0] != '\0' && strpbrk(word, " \t;#\"|>\\") == NULL;
	FREED char *quoted = text_in_quotes(word);
	xappend(line, " %s", plain ? word : quoted);
}

/* Appends a path as an absolute one; does not resolve links. */
static void
append_absolute_path(char **word, const char *path)
{
	char folder[4096];
	bool rooted = path[0] == '/' || getcwd(folder, sizeof folder) == NULL;
	while (strncmp(path, "./", 2) == 0)
		path += 2;
	xappend(word, "%s%s%s", rooted ? "" : folder, rooted ? "" : "/", path);
}

/* Appends a path, or each path of a blend of feeds, as option `key` unless that
 * is NULL. */
static void
append_path_of_option(char **line, const char *key, const char *path)
{
	FREED char *whole = key != NULL ? xasprintf("%s=", key) : xstrdup("");
	for (const char *at = path, *next; at != NULL; at = next) {
		size_t length;
		double share;
		next = value_parse_blend_feed(at, &length, &share);
		FREED char *one = xstrndup(at, length);
		append_absolute_path(&whole, one);
		size_t rest = next != NULL ? (size_t)(next - at) : strlen(at);
		xappend(&whole, "%.*s", (int)(rest - length), at + length);
	}
	journal_append_word(line, whole);
}

void
journal_add_file_check(
    struct session *s, const char *latest, const char *path, uint64_t digest)
{
	struct journal *j = s->journal;
	char *line = xstrdup("assert");
	append_path_of_option(&line, NULL, path);
	xappend(&line, " is %016" PRIx64, digest);
	remove_last_call_of(j, latest);
	bool known = false;
	for (size_t i = j->start; i < j->n; i++)
		known = known || strcmp(j->line[i], line) == 0;
	if (known)
		free(line);
	else
		append_journal_line(j, line);
}

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

/* True if the word is an operand and a path. */
static bool
is_path_operand(const struct args *args, const char *word)
{
	size_t i = 0, which;
	while (i < args->n_operand && args->operand[i] != word)
		i++;
	if (i == args->n_operand)
		return false;
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

/* True if a saved script leaves the option out: pause=, which is added at the
 * end, and out=, because by then its sheet exists. */
static bool
is_option_not_saved(const struct command_option *o)
{
	return strcmp(o->name, "pause") == 0 || strcmp(o->name, "out") == 0;
}

char *
journal_call_as_saved(const struct args *args, const struct words *words)
{
	char *line = xstrdup(args->command->name);
	for (size_t i = 1; i < words->n; i++) {
		const char *word = words->text[i], *value = word;
		size_t k = find_option_with_value(args, word);
		const struct command_option *o =
		    k < OPTIONS ? command_option_at(args->command, k) : NULL;
		if (o != NULL && is_option_not_saved(o))
			continue;
		if (o != NULL)
			value = args->value[k].text;
		bool path = o == NULL ? is_path_operand(args, word)
				      : value_is_file(o, &args->value[k]) ||
					    (o->kind == VALUE_SPEC &&
						standards_is_file_path(value));
		if (path)
			append_path_of_option(
			    &line, value != word ? o->name : NULL, value);
		else
			journal_append_word(&line, word);
	}
	return line;
}

char *
journal_line_to_load(
    uint64_t digest, size_t n, const char *const *path, const double *speed)
{
	char *line = xstrdup("load"), number[32];
	for (size_t i = 0; i < n; i++) {
		FREED char *word =
		    speed != NULL && speed[i] > 0
			? xasprintf("%s@%s", path[i],
			      text_shortest_exact_number(speed[i], number))
			: xstrdup(path[i]);
		append_path_of_option(&line, NULL, word);
	}
	xappend(&line, " digest=%016" PRIx64, digest);
	return line;
}

char *
journal_options_to_load(const struct site_request *q)
{
	char *text = xstrdup(""), number[32];
	if (q->columns != NULL)
		xappend(&text, " columns=\"%s\"", q->columns);
	if (q->samples != NULL)
		xappend(&text, " samples=\"%s\"", q->samples);
	if (q->sheet != NULL)
		xappend(&text, " sheet=\"%s\"", q->sheet);
	if (q->range != NULL)
		xappend(&text, " range=%s", q->range);
	if (q->decimal != '\0')
		xappend(&text, " decimal=%s",
		    q->decimal == ',' ? "comma" : "point");
	if (q->rotor > 0)
		xappend(&text, " rotor_mm=%.15g", 1000 * q->rotor);
	if (q->top > 0)
		xappend(&text, " top=%s",
		    text_shortest_exact_number(q->top, number));
	return text;
}

char *
journal_call_as_typed(const struct command *command, const struct words *words)
{
	char *label = xstrdup(command->name);
	for (size_t i = 1; i < words->n; i++)
		xappend(&label, " %s", words->text[i]);
	return label;
}

/* Writes where the site's data are from, for readers of the script, without
 * characters that would end or continue the comment. */
static void
write_script_provenance(FILE *out, const struct site *site)
{
	FREED char *kind = site_source_clause(site, "provenance not stated");
	FREED char *line = xasprintf("# %s: %s", site->name, kind);
	for (char *p = line; *p != '\0'; p++)
		*p = *p == '\\' ? ' ' : *p;
	text_print_escaped(line, out);
	fputc('\n', out);
}

void
journal_write_script(const struct session *s, FILE *out)
{
	const struct journal *j = s->journal;
	fputs("# A site file whose numbers have changed is refused.\n", out);
	for (size_t i = 0; i < s->n_entry; i++)
		write_script_provenance(out, s->entry[i].site);
	for (size_t i = j->start; i < j->n; i++)
		fprintf(out, "%s\n", j->line[i]);
}

bool
journal_can_be_saved(const struct session *s, struct error *error)
{
	const struct journal *j = s->journal;
	for (size_t i = j->start; i < j->n; i++) {
		if (text_is_utf8(j->line[i], strlen(j->line[i])) &&
		    strpbrk(j->line[i], "\r\n") == NULL)
			continue;
		return error_set(error, ERROR_DATA,
		    "cannot write '%.200s' into a script: a name in it is not "
		    "UTF-8 or has a line break\n"
		    "rename the file and load it again",
		    j->line[i]);
	}
	return true;
}
