/* The plain driver: reads lines, runs them, prints errors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/batch.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/keep.h"
#include "cmd/script.h"
#include "ui/pump.h"
#include "ui/terminal.h"
#include "ui/tui.h"

/* The line at fault, cut to fit a screen, and a caret under the column. */
static void
print_caret(const char *line, int column, FILE *out)
{
	enum { MOST = 72 };
	int rows, columns;
	terminal_size(&rows, &columns);
	int room = columns < MOST + 8 ? columns - 8 : MOST, wide = 0, at = 0;
	int i = 1;
	const char *p = line;
	char shown[TEXT_SHOWN];
	for (; i <= column - room * 5 / 9 && *p != '\0'; i++)
		text_next(&p);
	fputs("  ", out);
	for (; *p != '\0' && wide < room; i++) {
		bool tab = *p == '\t';
		int its = text_show(&p, shown);
		wide += tab ? 1 : its;
		at = i < column ? wide : at;
		fputs(tab ? " " : shown, out);
	}
	fprintf(out, "\n  %*s^\n", at, "");
}

static void
print_error(const struct error *e, const char *line, const char *name)
{
	struct error bare = *e;
	bare.hint[0] = '\0';
	error_print(&bare, stderr);
	if (e->line > 0 && strcmp(e->file, name) == 0)
		print_caret(line, e->column, stderr);
	error_print_hint(e, stderr);
}

static int run_scripts(struct session *s, size_t depth, struct page *page);

/* Ends what the line has under way after an error or an interruption; the
 * latter keeps the results so far. */
static void
give_up(struct session *s, int status, const char *line, const char *name)
{
	struct error error = {.kind = (enum error_kind)status};
	bool ok = status == 0 || pump_signal() != 0;
	if (!session_settle(s, ok, &error) && ok)
		print_error(&error, line, name);
}

/* After a signal: what was found stays. */
static int
interrupt(struct session *s, const char *line, const char *name, int number,
    struct page *page)
{
	page_hold(page);
	session_pause(s);
	give_up(s, 0, line, name);
	page_show(page);
	/* At a prompt one sees that. */
	if (page == NULL) {
		text_put(name, stderr);
		fprintf(stderr, ":%d: interrupted\n", number);
	}
	return pump_status();
}

int
batch_line(struct session *s, const char *line, const char *name, int number,
    struct page *page)
{
	size_t at = 0, depth = script_depth(s);
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
		if (!pump_run(s))
			return interrupt(s, line, name, number, page);
		page_show(page);
		int status = run_scripts(s, depth, page);
		if (status == 0 && s->wants_tui) {
			s->wants_tui = false;
			status = tui_run(s);
		}
		if (status != 0 || s->quit)
			give_up(s, status, line, name);
		page_show(page);
		if (status != 0)
			return status;
	} while (at > 0 && !s->quit);
	return 0;
}

/* Runs the scripts that are open beyond `depth` of them. */
static int
run_scripts(struct session *s, size_t depth, struct page *page)
{
	int status = 0;
	while (status == 0 && script_depth(s) > depth && !s->quit &&
	       pump_signal() == 0) {
		struct error error = {0};
		struct place place;
		char *line = script_line(s, &place, &error);
		if (line != NULL)
			status =
			    batch_line(s, line, place.file, place.line, page);
		else if (error.kind != ERROR_NONE)
			print_error(&error, "", "");
		if (line == NULL)
			status = (int)error.kind;
		free(line);
	}
	script_close(s, depth);
	return pump_signal() != 0 ? pump_status() : status;
}

int
batch_stream(struct session *s, FILE *in, const char *name)
{
	size_t depth = script_depth(s);
	script_open_stream(s, in, name);
	return run_scripts(s, depth, NULL);
}

int
batch_text(struct session *s, const char *text, const char *name, int line)
{
	size_t depth = script_depth(s);
	script_open_text(s, text, name, line);
	return run_scripts(s, depth, NULL);
}

int
batch_file(struct session *s, const char *path)
{
	size_t depth = script_depth(s);
	struct error error = {0};
	if (script_open(s, path, &error))
		return run_scripts(s, depth, NULL);
	error_print(&error, stderr);
	return (int)error.kind;
}

void
batch_attend(struct session *s)
{
	char *offer = keep_begin(s);
	if (offer != NULL)
		session_note(s, "%s", offer);
	free(offer);
	s->confirm = pump_confirm;
	s->prompt = true;
	s->typed_at = script_depth(s);
}

/* On standard error: standard output is no terminal here, else readline would
 * be asked. */
static void
print_prompt(struct session *s, bool goes_on)
{
	const char *key = s->n_entry > 0 ? session_entry(s)->key : "";
	fprintf(stderr, "%s> ",
	    goes_on          ? ""
	    : key[0] != '\0' ? key
			     : "tipspeed");
}

int
batch_typed(struct session *s)
{
	char *line = NULL;
	size_t n = 0, room = 0, from = 0;
	struct error error = {0};
	batch_attend(s);
	for (int number = 1; !s->quit; pump_forget_interrupt()) {
		print_prompt(s, from > 0);
		enum text_line got = text_line(&line, &n, &room, stdin);
		bool more = got == TEXT_LINE && script_goes_on(line + from);
		if (got != TEXT_LINE)
			fputc('\n', stderr);
		if (got == TEXT_TOO_LONG) {
			script_too_long("typed", number, &error);
			error_print(&error, stderr);
		}
		if (got != TEXT_LINE && pump_signal() != SIGINT)
			break;
		n = from = more ? from + strlen(line + from) : 0;
		if (got == TEXT_END)
			clearerr(stdin);
		if (got == TEXT_LINE && !more)
			batch_line(s, line, "typed", number++, NULL);
		if (pump_ended())
			break;
	}
	free(line);
	return pump_ended() ? pump_status() : (int)error.kind;
}
