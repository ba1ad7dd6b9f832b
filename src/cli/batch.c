/* The plain driver: reads lines, runs them, prints errors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/batch.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "base/text.h"
#include "base/tr.h"
#include "cmd/session/autosave.h"
#include "cmd/session/script.h"
#include "cli/driver.h"
#include "cli/ask.h"
#include "cli/progress.h"
#include "cli/signals.h"
#include "cli/terminal.h"

/* Prints the line at fault, cut to fit the screen, and a caret below the
 * column. */
static void
print_line_with_caret(const char *line, int column, FILE *out)
{
	enum { MOST = 72 };
	int rows, columns;
	terminal_size(&rows, &columns);
	int room = columns < MOST + 8 ? columns - 8 : MOST, wide = 0, at = 0;
	int i = 1;
	const char *p = line;
	char shown[TEXT_SHOWN];
	for (; i <= column - room * 5 / 9 && *p != '\0'; i++)
		text_next_code_point(&p);
	fputs("  ", out);
	for (; *p != '\0' && wide < room; i++) {
		bool tab = *p == '\t';
		int its = text_escape_next_character(&p, shown);
		wide += tab ? 1 : its;
		at = i < column ? wide : at;
		fputs(tab ? " " : shown, out);
	}
	fprintf(out, "\n  %*s^\n", at, "");
}

static void
print_error_and_line(
    void *of, const struct error *e, const char *line, const char *name)
{
	struct error bare = *e;
	(void)of;
	bare.hint[0] = '\0';
	error_print(&bare, stderr);
	if (e->line > 0 && strcmp(e->file, name) == 0)
		print_line_with_caret(line, e->column, stderr);
	error_print_hint(e, stderr);
}

/* Reports an interruption.  Not used at a prompt, where the user sees it. */
static void
print_interrupted(const char *name, int number)
{
	text_print_escaped(name, stderr);
	fprintf(stderr, tr(":%d: interrupted\n"), number);
}

static struct driver
make_batch_driver(struct session *s)
{
	return (struct driver){.session = s,
	    .fail = print_error_and_line,
	    .interrupted = print_interrupted,
	    .work = progress_run_job};
}

int
batch_run_line(
    struct session *s, const char *line, int number, struct pager *pager)
{
	struct driver d = make_batch_driver(s);
	d.pager = pager;
	d.interrupted = pager != NULL ? NULL : print_interrupted;
	return driver_run_line_to_end(&d, line, ERROR_TYPED, number);
}

/* The output of a line, which is printed only if the line fails, before its
 * error. */
struct quiet {
	FILE *to;
	char *said;
	size_t n;
	bool shown;
};

static void
print_captured_messages(struct quiet *q)
{
	fflush(q->to);
	if (!q->shown)
		fputs(q->said, stderr);
	q->shown = true;
}

static void
print_messages_and_error(
    void *of, const struct error *e, const char *line, const char *name)
{
	print_captured_messages(of);
	print_error_and_line(NULL, e, line, name);
}

int
batch_run_line_quietly(struct session *s, const char *line, int number)
{
	struct quiet q = {.shown = false};
	struct driver d = make_batch_driver(s);
	FILE *out = s->out, *notes = s->notes;
	d.of = &q;
	d.fail = print_messages_and_error;
	d.interrupted = NULL;
	s->out = s->notes = q.to = text_open_memory(&q.said, &q.n);
	int status = driver_run_line_to_end(&d, line, ERROR_TYPED, number);
	s->out = out;
	s->notes = notes;
	if (status != 0)
		print_captured_messages(&q);
	fclose(q.to);
	free(q.said);
	return status;
}

static int
run_open_scripts(struct session *s, size_t depth)
{
	const struct driver d = make_batch_driver(s);
	return driver_run_scripts(&d, depth);
}

int
batch_run_script_stream(struct session *s)
{
	size_t depth = s->scripts;
	script_open_stream(s, stdin, "stdin");
	return run_open_scripts(s, depth);
}

int
batch_run_script_text(struct session *s, const char *text, int line)
{
	size_t depth = s->scripts;
	script_open_text(s, text, "-c", line);
	return run_open_scripts(s, depth);
}

int
batch_run_script_file(struct session *s, const char *path)
{
	size_t depth = s->scripts;
	struct error error = {0};
	if (script_open(s, path, &error))
		return run_open_scripts(s, depth);
	error_print(&error, stderr);
	return (int)error.kind;
}

void
batch_make_session_interactive(struct session *s)
{
	FREED char *offer = autosave_begin(s);
	if (offer != NULL)
		session_print_note(s, "%s", offer);
	s->hooks.confirm = ask_confirm;
	s->hooks.ask = ask_question;
	s->prompt = true;
	s->typed_depth = s->scripts;
}

/* Prompts on standard error.  Standard output is not a terminal here, or else
 * readline would prompt. */
static void
print_prompt(struct session *s, bool continues)
{
	const char *key =
	    s->n_entry > 0 ? session_current_site_entry(s)->key : "";
	fprintf(stderr, "%s> ",
	    continues        ? ""
	    : key[0] != '\0' ? key
			     : "tipspeed");
}

int
batch_run_typed_lines(struct session *s)
{
	FREED char *line = NULL;
	size_t n = 0, room = 0;
	struct error error = {0};
	batch_make_session_interactive(s);
	for (int number = 1; !s->quit; signals_clear_interrupt()) {
		print_prompt(s, n > 0);
		size_t from = n;
		enum text_line got = text_read_line(&line, &n, &room, stdin);
		bool more =
		    got == TEXT_LINE && script_remove_line_end(line, from);
		if (got != TEXT_LINE)
			fputc('\n', stderr);
		if (got == TEXT_TOO_LONG) {
			script_set_error_long_line(ERROR_TYPED, number, &error);
			error_print(&error, stderr);
		}
		if (got != TEXT_LINE &&
		    signals_get_ending_or_interrupt() != SIGINT)
			break;
		n = more ? from + strlen(line + from) : 0;
		if (got == TEXT_END)
			clearerr(stdin);
		if (got == TEXT_LINE && !more)
			batch_run_line(s, line, number++, NULL);
		if (signals_is_end_wanted())
			break;
	}
	return signals_is_end_wanted() ? signals_exit_status()
				       : (int)error.kind;
}
