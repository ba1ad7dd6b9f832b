/* Reads lines from files, streams and the command line.  The driver runs them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/script.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/session/files.h"
#include "cmd/lang/parse.h"
#include "cmd/lang/table.h"
#include "io/cells/textfile.h"
#include "io/fs/file.h"

struct script {
	struct script *outer;
	FILE *in;
	bool borrowed;
	char *name, *text; /* text: what `in` reads, unless it is a file */
	int number;        /* of the last line read */
	bool one_number;   /* all lines have this number */
	struct script_place at;
};

static struct script *
push_script(struct session *s, FILE *in, const char *name)
{
	struct script *script = xcalloc(1, sizeof *script);
	script->outer = s->script;
	script->in = in;
	script->name = xstrdup(name);
	s->script = script;
	s->scripts++;
	return script;
}

static bool
is_line_with_command(const char *line)
{
	line += strspn(line, " \t\r\n");
	return *line != '\0' && *line != '#';
}

/* Returns the number of commands in a stream; 0 if it cannot be read twice. */
static size_t
count_script_commands(FILE *in)
{
	FREED char *line = NULL;
	size_t n = 0, from = 0, room = 0, commands = 0;
	long begin = ftell(in);
	bool more = false;
	if (begin < 0)
		return 0;
	while (text_read_line(&line, &n, &room, in) == TEXT_LINE) {
		commands += !more && is_line_with_command(line);
		more = script_remove_line_end(line, from);
		n = from = more ? from + strlen(line + from) : 0;
	}
	return fseek(in, begin, SEEK_SET) == 0 ? commands : 0;
}

bool
script_open(struct session *s, const char *path, struct error *error)
{
	enum { DEEPEST = 16 };
	if (s->scripts >= DEEPEST)
		return error_set(error, ERROR_USAGE,
		    "expected scripts nested at most %d deep\n"
		    "does %s source itself?",
		    (int)DEEPEST, path);
	files_record_read(s, path);
	const char *why;
	FILE *in = textfile_open(path, &why);
	if (in == NULL) {
		FREED char *hint = textfile_hint_after_failed_open(path);
		return error_set(error, ERROR_SYSTEM,
		    "cannot read script %s: %s\n%s", path, why, hint);
	}
	push_script(s, in, path)->at.of = count_script_commands(in);
	return true;
}

void
script_open_stream(struct session *s, FILE *in, const char *name)
{
	push_script(s, in, name)->borrowed = true;
}

void
script_open_text(
    struct session *s, const char *text, const char *name, int line)
{
	struct script *script = push_script(s, NULL, name);
	script->text = xstrdup(text);
	script->in = fmemopen(script->text, strlen(text), "r");
	script->number = line;
	script->one_number = true;
}

void
script_close_to_depth(struct session *s, size_t depth)
{
	while (s->scripts > depth) {
		struct script *script = s->script;
		s->script = script->outer;
		s->scripts--;
		if (script->in != NULL && !script->borrowed)
			fclose(script->in);
		free(script->name);
		free(script->text);
		free(script);
	}
}

bool
script_remove_line_end(char *line, size_t from)
{
	char *last = line + from;
	size_t n = strcspn(last, "\r\n");
	last[n] = '\0';
	bool more = n > 0 && last[n - 1] == '\\' &&
		    (strchr(last, '#') == NULL || !words_end_in_comment(line));
	if (more)
		last[n - 1] = ' ';
	return more;
}

static bool
check_script_is_text(const struct script *script, const char *piece, size_t n,
    struct error *error)
{
	if (text_is_utf8(piece, n))
		return true;
	return error_set_at(error, ERROR_USAGE, script->name, script->number, 1,
	    "expected UTF-8 text, got a binary file\n"
	    "is it a site file or a program? a script has one command a line");
}

bool
script_set_error_long_line(const char *name, int line, struct error *error)
{
	return error_set_at(error, ERROR_USAGE, name, line, 1,
	    "expected lines of at most 10 MB, got a longer one\n"
	    "is it a site file or a program? a script has one command a line");
}

/* Returns the next line, joined with its continuations, and sets *first to its
 * number.  NULL at the end or on an error.  The caller frees it. */
static char *
read_continued_line(struct script *script, int *first, struct error *error)
{
	char *line = NULL;
	size_t n = 0, room = 0, from = 0;
	enum text_line got = TEXT_LINE;
	bool more = true, good = true, any = false;
	while (
	    more && good &&
	    (got = text_read_line(&line, &n, &room, script->in)) == TEXT_LINE) {
		script->number += !script->one_number;
		good =
		    check_script_is_text(script, line + from, n - from, error);
		/* Some editors begin a file with a byte order mark. */
		if (!any && script->number == 1 &&
		    strncmp(line, "\xEF\xBB\xBF", 3) == 0)
			memmove(line, line + 3, n - 2);
		if (!any)
			*first = script->number;
		any = true;
		more = script_remove_line_end(line, from) && good;
		n = from += strlen(line + from);
	}
	if (got == TEXT_TOO_LONG)
		good = script_set_error_long_line(
		    script->name, script->number + !script->one_number, error);
	else if (good && more && ferror(script->in))
		good = error_set_at(error, ERROR_SYSTEM, script->name, 0, 0,
		    "cannot be read: %s", strerror(errno));
	if (good && any)
		return line;
	free(line);
	return NULL;
}

char *
script_read_line(struct session *s, struct place *place, struct error *error)
{
	struct script *script = s->script;
	*place = (struct place){.file = script->name};
	char *line = script->in != NULL
			 ? read_continued_line(script, &place->line, error)
			 : NULL;
	if (line == NULL && error->kind == ERROR_NONE)
		script_close_to_depth(s, s->scripts - 1);
	else if (line != NULL)
		script->at.at += is_line_with_command(line);
	return line;
}

char *
script_other_folder(const struct session *s, const char *file)
{
	const struct script *script = s->script;
	if (script == NULL || script->borrowed || script->text != NULL ||
	    strcmp(script->name, file) != 0)
		return NULL;
	size_t n = (size_t)(file_name_without_folders(file) - file);
	return n > 1 ? xstrndup(file, n - 1) : NULL;
}

struct script_place
script_command_position(const struct session *s)
{
	return s->script != NULL ? s->script->at : (struct script_place){0};
}

bool
cmd_source(struct session *s, const struct args *args, struct error *error)
{
	return script_open(s, args->operand[0], error);
}
