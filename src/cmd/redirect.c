/* Keeps what a command prints until it is done, then hands it over: so a
 * command that fails leaves a file as it was.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/redirect.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/files.h"
#include "config.h"
#include "io/book.h"
#include "io/file.h"
#include "plot/picture.h"

struct redirect {
	enum target to;
	char *target;
	FILE *memory, *out; /* what is kept; where results went before */
	char *text;
	size_t n;
	enum answer_format form, before;
	struct screen screen; /* before, too */
	size_t rows;
	struct book *book, *outer; /* a workbook, and that before */
	char *line;                /* the command */
};

/* The form that the end of a file's name asks for. */
static enum answer_format
form_of(const char *path, enum answer_format other)
{
	for (size_t i = 0; i < ARRAY_LEN(ANSWER_FORMATS); i++)
		if (ANSWER_FORMATS[i].end != NULL &&
		    text_ends(path, ANSWER_FORMATS[i].end))
			return (enum answer_format)i;
	return other;
}

struct redirect *
redirect_open(struct session *s, const struct words *words, struct error *error)
{
	if (words->to != TO_PIPE && !files_may_write(s, words->target, error))
		return NULL;
	if (words->to == TO_FILE && !files_may_replace(s, words->target, error))
		return NULL;
	bool is_book =
	    words->to == TO_FILE && text_ends(words->target, ".xlsx");
	struct book *book = is_book ? book_new(error) : NULL;
	if (is_book && book == NULL)
		return NULL;
	struct redirect *r = xcalloc(1, sizeof *r);
	r->book = book;
	r->outer = s->book;
	s->book = book;
	r->line = xstrdup("");
	for (size_t i = 0; i < words->n; i++)
		xlist(&r->line, " ", "%s", words->text[i]);
	r->memory = text_memory(&r->text, &r->n);
	r->to = words->to;
	r->target = xstrdup(words->target);
	r->out = s->out;
	r->before = s->set.format;
	r->form = r->to == TO_PIPE ? s->set.format
				   : form_of(r->target, s->set.format);
	/* Commands that draw have numbers for csv. */
	if (is_book)
		r->form = ANSWER_CSV;
	r->screen = s->screen;
	r->rows = s->rows;
	s->rows = 0;
	s->screen = (struct screen){0};
	s->file = r->to == TO_PIPE ? NULL : r->target;
	s->out = r->memory;
	s->set.format = r->form;
	return r;
}

/* Excel takes a file without the mark for one in the letters of its country,
 * and shows the O of Ossjo as two.  It stands at the beginning only. */
static void
put_mark(struct redirect *r)
{
	struct stat about;
	bool there = stat(r->target, &about) == 0;
	if (there &&
	    (!S_ISREG(about.st_mode) || (r->to == TO_END && about.st_size > 0)))
		return;
	char *text = xcalloc(r->n + 4, 1);
	memcpy(text, "\xEF\xBB\xBF", 3);
	memcpy(text + 3, r->text, r->n);
	free(r->text);
	r->text = text;
	r->n += 3;
}

/* "12 rows" of a table, "24 lines" of other text; a picture has neither. */
static char *
extent(const struct redirect *r, size_t rows)
{
	enum picture_form form;
	if (picture_form_of(r->target, &form))
		return xstrdup("an image");
	bool lines = rows == 0 || r->form == ANSWER_JSON;
	size_t n = lines ? 0 : rows;
	for (size_t i = 0; lines && i < r->n; i++)
		n += r->text[i] == '\n';
	return xasprintf(
	    "%zu %s%s", n, lines ? "line" : "row", n == 1 ? "" : "s");
}

static bool
write_file(struct session *s, struct redirect *r, struct error *error)
{
	bool whole = r->to == TO_FILE;
	bool (*write)(const char *, enum file_rights, const char *, size_t,
	    struct error *) = whole ? file_replace : file_append;
	if (!write(r->target, FILE_SHARED, r->text, r->n, error))
		return false;
	struct stat about;
	if (stat(r->target, &about) != 0 || !S_ISREG(about.st_mode))
		return true;
	char *what = extent(r, s->rows);
	files_wrote(s, r->target);
	session_note(
	    s, whole ? "wrote %s: %s" : "added to %s: %s", r->target, what);
	free(what);
	return true;
}

/* What the results rest on. */
static void
tell_about(struct session *s, const struct redirect *r)
{
	book_about(r->book, "program", "tipspeed " PACKAGE_VERSION);
	book_about(r->book, "command", r->line);
	if (!book_has_site(r->book) || s->n_entry == 0)
		return;
	const struct entry *entry = session_entry(s);
	const struct site *site = entry->site;
	char *label = session_label(site);
	char *speeds = session_speeds(site, ", ", NULL, true);
	book_about(r->book, "site", label);
	book_about(r->book, "file", site->path);
	book_about(r->book, "provenance", site->provenance);
	book_about(r->book, "speeds, m/s", speeds);
	book_about(r->book, "parameters", origin_words(entry));
	free(label);
	free(speeds);
	const struct breakage *model = BREAKAGES[entry->params.breakage];
	for (size_t j = 0; entry->has_params && j < model->n; j++) {
		const struct param_info *p = &model->parameter[j];
		char number[32];
		bool bare = strcmp(p->unit, "-") == 0;
		char *name = xasprintf(
		    "%s%s%s", p->name, bare ? "" : ", ", bare ? "" : p->unit);
		book_about(r->book, name,
		    text_exact(params_value(&entry->params, p->name), number));
		free(name);
	}
}

/* Puts the workbook in place of what was printed, which has no table. */
static bool
bind_book(struct session *s, struct redirect *r, struct error *error)
{
	if (book_sheets(r->book) == 0)
		return error_set(error, ERROR_USAGE,
		    "no table for a workbook (%s)\n"
		    "write > FILE.txt instead",
		    r->target);
	tell_about(s, r);
	free(r->text);
	r->text = book_finish(r->book, &r->n, error);
	r->book = NULL;
	return r->text != NULL;
}

/* How the shell command ended.  One that ^C ended passes it on. */
static bool
judge_shell(const struct redirect *r, int status, struct error *error)
{
	if (status == 0)
		return true;
	if (status != -1 && WIFEXITED(status))
		return error_set(error, ERROR_SYSTEM,
		    "the shell command '%s' ended with status %d\n"
		    "check the text after |: all of it goes to the shell",
		    r->target, WEXITSTATUS(status));
	error_set(error, ERROR_SYSTEM, "'%s' was ended by a signal", r->target);
	if (status != -1 && WTERMSIG(status) == SIGINT)
		raise(SIGINT);
	return false;
}

/* A reader that has seen enough ends the writing, not the program; ^C is for
 * the shell command, as in a shell. */
static bool
write_pipe(const struct redirect *r, struct error *error)
{
	struct sigaction ignore = {.sa_handler = SIG_IGN}, pipe, interrupt;
	sigemptyset(&ignore.sa_mask);
	fflush(r->out);
	FILE *out = popen(r->target, "w");
	if (out == NULL)
		return error_set(error, ERROR_SYSTEM, "cannot run '%s': %s",
		    r->target, strerror(errno));
	/* Nothing may be left to write when it is closed: that would hide how
	 * the command ended. */
	setvbuf(out, NULL, _IONBF, 0);
	sigaction(SIGPIPE, &ignore, &pipe);
	sigaction(SIGINT, &ignore, &interrupt);
	fwrite(r->text, 1, r->n, out);
	int status = pclose(out);
	sigaction(SIGPIPE, &pipe, NULL);
	sigaction(SIGINT, &interrupt, NULL);
	return judge_shell(r, status, error);
}

bool
redirect_close(
    struct session *s, struct redirect *r, bool keep, struct error *error)
{
	s->out = r->out;
	s->book = r->outer;
	s->screen = r->screen;
	s->file = NULL;
	/* Unless the command itself was to set it. */
	if (s->set.format == r->form)
		s->set.format = r->before;
	bool whole = fclose(r->memory) == 0, ok = true;
	if (keep && r->book != NULL)
		keep = ok = bind_book(s, r, error);
	else if (r->to != TO_PIPE && r->form == ANSWER_CSV &&
		 s->set.semicolon && r->n > 0)
		put_mark(r);
	if (keep && !whole)
		ok = error_set(error, ERROR_SYSTEM,
		    "the results for %s do not fit into memory", r->target);
	else if (keep)
		ok = r->to == TO_PIPE ? write_pipe(r, error)
				      : write_file(s, r, error);
	s->rows = r->rows;
	free(r->text);
	book_free(r->book);
	free(r->line);
	free(r->target);
	free(r);
	return ok;
}
