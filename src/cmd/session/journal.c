/* Keeps the commands that succeeded as lines that can be run again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/journal.h"

#include <inttypes.h>
#include <limits.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/session/call_paths.h"
#include "cmd/session/settings.h"
#include "io/fs/file.h"

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
journal_assign_state_number(struct session *s)
{
	s->journal->state = ++s->journal->states;
}

static void
append_journal_line(struct journal *j, char *line)
{
	j->line = xgrow_by_one(j->line, j->n, sizeof *j->line);
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
journal_restore_lines(struct session *s, struct removed_lines *tail)
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
is_call_of_command(const char *line, const char *name)
{
	size_t n = strlen(name);
	return strncmp(line, name, n) == 0 &&
	       (line[n] == '\0' || line[n] == ' ');
}

/* Removes the last line if it is a call of the command `latest`, and the assert
 * lines that check the files that it read. */
static void
remove_last_line_if_call(struct journal *j, const char *latest)
{
	if (latest == NULL || j->n <= j->start ||
	    !is_call_of_command(j->line[j->n - 1], latest))
		return;
	free(j->line[--j->n]);
	while (
	    j->n > j->start && is_call_of_command(j->line[j->n - 1], "assert"))
		free(j->line[--j->n]);
}

bool
journal_last_line_ends(const struct session *s, const char *end)
{
	const struct journal *j = s->journal;
	return j->n > j->start && text_ends_with(j->line[j->n - 1], end);
}

void
journal_add_line(struct session *s, const char *latest, const char *line, ...)
{
	struct journal *j = s->journal;
	remove_last_line_if_call(j, latest);
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
		size_t number = strspn(line, "0123456789");
		number += line[number] == '.' ? 1 : 0;
		number += strspn(line + number, "0123456789");
		line += number;
		line += strncmp(line, "rpm", 3) == 0 ? 3 : 0;
		if (number == 0)
			return false;
	}
	return *line == '\0';
}

void
journal_add_slider_line(struct session *s, const char *line)
{
	const struct journal *j = s->journal;
	bool replaces = j->n > 0 && names_only_speeds(j->line[j->n - 1]);
	journal_add_line(s, replaces ? "predict" : NULL, "%s", line);
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
journal_append_quoted_word(char **line, const char *word)
{
	bool plain = word[0] != '\0' && strpbrk(word, " \t;#\"|>\\") == NULL;
	FREED char *quoted = text_add_quotes(word);
	xappend(line, " %s", plain ? word : quoted);
}

/* Stands before each path in a line, so that a script in a folder above it can
 * have it relative to that folder. */
enum { PATH_BEGINS = '\1' };

/* Returns the path as an absolute one after PATH_BEGINS.  Does not resolve
 * links, unless it leads out of a folder, which another one may lead to. */
static char *
absolute_path(const char *path, const void *unused)
{
	(void)unused;
	char folder[PATH_MAX];
	while (strncmp(path, "./", 2) == 0)
		path += 2;
	const char *name = file_name_without_folders(path);
	/* The name of a shipped file, such as vsi-69. */
	if (name == path && call_path_length_of_file(path) == 0)
		return xstrdup(path);
	FREED char *real = strstr(path, "../") != NULL && name > path
			       ? file_real_folder(path)
			       : NULL;
	if (real != NULL)
		return xasprintf("%c%s/%s", PATH_BEGINS, real, name);
	bool rooted = path[0] == '/' || getcwd(folder, sizeof folder) == NULL;
	return xasprintf("%c%s%s%s", PATH_BEGINS, rooted ? "" : folder,
	    rooted ? "" : "/", path);
}

/* Appends a path, or the paths in the value of an option, unless o is NULL.
 * key: with the option's name. */
static void
append_paths(
    char **line, const struct command_option *o, bool key, const char *path)
{
	FREED char *paths = call_paths_map(o, path, absolute_path, NULL);
	FREED char *whole = o != NULL && key
				? xasprintf("%s=%s", o->name, paths)
				: xstrdup(paths);
	journal_append_quoted_word(line, whole);
}

void
journal_add_file_check(
    struct session *s, const char *latest, const char *path, uint64_t digest)
{
	struct journal *j = s->journal;
	char *line = xstrdup("assert");
	append_paths(&line, NULL, false, path);
	xappend(&line, " is %016" PRIx64, digest);
	remove_last_line_if_call(j, latest);
	bool known = false;
	for (size_t i = j->start; i < j->n; i++)
		known = known || strcmp(j->line[i], line) == 0;
	if (known)
		free(line);
	else
		append_journal_line(j, line);
}

char *
journal_saved_command_text(const struct args *args, const struct words *words)
{
	char *line = xstrdup(args->command->name);
	for (size_t i = 1; i < words->n; i++) {
		const char *word = words->text[i];
		const struct command_option *o;
		const char *path = call_path_in_word(args, word, &o);
		size_t which;
		/* pause= is added at the end, and the sheet of out= exists. */
		if (o != NULL &&
		    text_find_word_in_list("pause out", o->name, &which))
			continue;
		if (path != NULL)
			append_paths(&line, o, path != word, path);
		else
			journal_append_quoted_word(&line, word);
	}
	return line;
}

char *
journal_load_command_text(uint64_t digest, const struct site_request *q)
{
	char *line = xstrdup("load");
	for (size_t i = 0; i < q->n; i++) {
		FREED char *word = site_request_file_text(q, i);
		append_paths(&line, NULL, false, word);
	}
	xappend(&line, " digest=%016" PRIx64, digest);
	return line;
}

char *
journal_typed_command_text(
    const struct command *command, const struct words *words)
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
	FREED char *kind =
	    site_provenance_first_clause(site, "provenance not stated");
	FREED char *line = xasprintf("# %s: %s", site->name, kind);
	for (char *p = line; *p != '\0'; p++)
		*p = *p == '\\' ? ' ' : *p;
	text_print_escaped(line, out);
	fputc('\n', out);
}

/* Writes a line.  folder, unless NULL: paths in it, or below it, are written
 * relative to it. */
static void
write_journal_line(const char *line, const char *folder, FILE *out)
{
	FREED char *quoted = folder != NULL ? text_add_quotes(folder) : NULL;
	size_t n = folder != NULL ? strlen(quoted) - 2 : 0;
	for (const char *p = line; *p != '\0'; p++) {
		if (*p != PATH_BEGINS) {
			fputc(*p, out);
			continue;
		}
		if (folder == NULL || strncmp(p + 1, quoted + 1, n) != 0 ||
		    p[1 + n] != '/')
			continue;
		p += n + 1;
		/* A bare word may have another meaning than a file. */
		size_t name = strcspn(p + 1, " \"+*@=,;");
		if (memchr(p + 1, '.', name) == NULL &&
		    memchr(p + 1, '/', name) == NULL)
			fputs("./", out);
	}
	fputc('\n', out);
}

void
journal_write_script(const struct session *s, const char *folder, FILE *out)
{
	const struct journal *j = s->journal;
	fputs("# A site file whose numbers have changed is refused.\n", out);
	for (size_t i = 0; i < s->n_entry; i++)
		write_script_provenance(out, s->entry[i].site);
	for (size_t i = j->start; i < j->n; i++)
		write_journal_line(j->line[i], folder, out);
}

bool
journal_can_be_saved(const struct session *s, struct error *error)
{
	const struct journal *j = s->journal;
	for (size_t i = j->start; i < j->n; i++) {
		if (text_is_utf8(j->line[i], strlen(j->line[i])) &&
		    strpbrk(j->line[i], "\r\n") == NULL)
			continue;
		FREED char *line = xstrdup("");
		for (const char *p = j->line[i]; *p != '\0'; p++)
			if (*p != PATH_BEGINS)
				xappend(&line, "%c", *p);
		return error_set(error, ERROR_DATA,
		    "cannot write '%.200s' into a script: a name in it is not "
		    "UTF-8 or has a line break\n"
		    "rename the file and load it again",
		    line);
	}
	return true;
}
