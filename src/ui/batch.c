/* The plain driver: reads lines, runs them, prints errors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/batch.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "ui/pump.h"
#include "ui/terminal.h"

/* The line at fault, cut to fit a screen, and a caret under the column. */
static void
print_caret(const char *line, int column, FILE *out)
{
	enum { MOST = 72 };
	int rows, columns;
	terminal_size(&rows, &columns);
	int room = columns < MOST + 8 ? columns - 8 : MOST, shown = 0;
	int before = room * 5 / 9, skip = column > before ? column - before : 0;
	const char *p = line;
	for (int i = 0; i < skip && *p != '\0'; i++)
		for (p++; (*p & 0xC0) == 0x80; p++)
			;
	fputs("  ", out);
	for (; *p != '\0' && shown < room; shown++) {
		fputc(*p == '\t' ? ' ' : *p, out);
		for (p++; (*p & 0xC0) == 0x80; p++)
			fputc(*p, out);
	}
	fprintf(out, "\n  %*s^\n", column > skip ? column - skip - 1 : 0, "");
}

static void
print_error(const struct error *e, const char *line, const char *name)
{
	struct error bare = *e;
	bare.hint[0] = '\0';
	error_print(&bare, stderr);
	if (e->line > 0 && strcmp(e->file, name) == 0)
		print_caret(line, e->column, stderr);
	if (e->hint[0] != '\0')
		fprintf(stderr, "  hint: %s\n", e->hint);
}

int
batch_line(struct session *s, const char *line, const char *name, int number,
    struct page *page)
{
	size_t at = 0;
	do {
		struct error error = {0};
		page_hold(page);
		bool ok = session_line(s, line, at, name, number, &at, &error);
		page_show(page);
		if (!ok) {
			fflush(s->out);
			print_error(&error, line, name);
			return (int)error.kind;
		}
		if (!pump_run(s)) {
			page_hold(page);
			session_pause(s);
			page_show(page);
			/* At a prompt one sees that. */
			if (page == NULL)
				fprintf(stderr, "%s:%d: interrupted\n", name,
				    number);
			return pump_status();
		}
		page_show(page);
	} while (at > 0 && !s->quit);
	return 0;
}

bool
batch_goes_on(char *line)
{
	size_t n = strcspn(line, "\r\n");
	line[n] = '\0';
	if (n == 0 || line[n - 1] != '\\')
		return false;
	line[n - 1] = ' ';
	return true;
}

static int
bad_bytes(const char *name, int number)
{
	fprintf(stderr,
	    "%s:%d:1: this is not text (a script is UTF-8 without NUL)\n"
	    "  hint: is it a site file or a program? a script holds "
	    "commands, one a line\n",
	    name, number);
	return ERROR_USAGE;
}

int
batch_stream(struct session *s, FILE *in, const char *name)
{
	char *piece = NULL, *line = xstrdup("");
	size_t room = 0;
	ssize_t got;
	int status = 0, number = 0, first = 1;
	while (status == 0 && !s->quit && pump_signal() == 0 &&
	       (got = getline(&piece, &room, in)) >= 0) {
		number++;
		if (!text_is_utf8(piece, (size_t)got)) {
			status = bad_bytes(name, number);
			break;
		}
		bool more = batch_goes_on(piece);
		/* Some editors begin UTF-8 with a byte order mark. */
		bool mark =
		    number == 1 && strncmp(piece, "\xEF\xBB\xBF", 3) == 0;
		char *joined = xasprintf("%s%s", line, piece + (mark ? 3 : 0));
		free(line);
		line = joined;
		if (more)
			continue;
		status = batch_line(s, line, name, first, NULL);
		first = number + 1;
		line[0] = '\0';
	}
	if (status == 0 && line[0] != '\0' && !s->quit)
		status = batch_line(s, line, name, first, NULL);
	free(piece);
	free(line);
	return pump_signal() != 0 ? pump_status() : status;
}

int
batch_text(struct session *s, const char *text, const char *name, int line)
{
	char *copy = xstrdup(text), *save = NULL;
	int status = 0;
	for (char *one = strtok_r(copy, "\r\n", &save);
	     one != NULL && status == 0 && !s->quit;
	     one = strtok_r(NULL, "\r\n", &save))
		status = batch_line(s, one, name, line, NULL);
	free(copy);
	return status;
}

int
batch_file(struct session *s, const char *path)
{
	FILE *in = fopen(path, "r");
	if (in == NULL) {
		fprintf(stderr, "%s: cannot read: %s\n", path, strerror(errno));
		return ERROR_SYSTEM;
	}
	int status = batch_stream(s, in, path);
	if (ferror(in)) {
		fprintf(stderr, "%s: cannot read: %s\n", path, strerror(errno));
		status = ERROR_SYSTEM;
	}
	fclose(in);
	return status;
}

/* On standard error: standard output is no terminal here, else readline would
 * be asked. */
static void
print_prompt(struct session *s, bool goes_on)
{
	if (goes_on)
		fputs("> ", stderr);
	else if (s->n_entry > 0)
		fprintf(stderr, "%s> ", session_entry(s)->key);
	else
		fputs("tipspeed> ", stderr);
}

int
batch_typed(struct session *s)
{
	char *piece = NULL, *line = xstrdup("");
	size_t room = 0;
	for (int number = 1; !s->quit; pump_forget_interrupt()) {
		print_prompt(s, line[0] != '\0');
		ssize_t got = getline(&piece, &room, stdin);
		bool more = got >= 0 && batch_goes_on(piece);
		if (got < 0)
			fputc('\n', stderr);
		if (got < 0 && pump_signal() != SIGINT)
			break;
		if (got < 0) {
			clearerr(stdin);
			line[0] = '\0';
			continue;
		}
		char *joined = xasprintf("%s%s", line, piece);
		free(line);
		line = joined;
		if (more)
			continue;
		batch_line(s, line, "typed", number++, NULL);
		line[0] = '\0';
		if (pump_ended())
			break;
	}
	free(piece);
	free(line);
	return pump_ended() ? pump_status() : 0;
}
