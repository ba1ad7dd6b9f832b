/* The plain driver: reads lines, pumps the session's job, prints progress.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/batch.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/script.h"

/* The status of a program that a signal ended, as shells count it. */
static int
status_of(int signal)
{
	return 128 + signal;
}

static volatile sig_atomic_t interrupted;

static void
on_interrupt(int signal)
{
	interrupted = signal;
}

void
batch_catch_interrupt(void)
{
	struct sigaction action = {.sa_handler = on_interrupt};
	sigemptyset(&action.sa_mask);
	sigaction(SIGINT, &action, NULL);
	sigaction(SIGTERM, &action, NULL);
	sigaction(SIGHUP, &action, NULL);
}

/* The line at fault, cut to fit a screen, and a caret under the column. */
static void
print_caret(const char *line, int column, FILE *out)
{
	enum { BEFORE = 40, SHOWN = 72 };
	int skip = column > BEFORE ? column - BEFORE : 0, shown = 0;
	const char *p = line;
	for (int i = 0; i < skip && *p != '\0'; i++)
		for (p++; (*p & 0xC0) == 0x80; p++)
			;
	fputs("  ", out);
	for (; *p != '\0' && shown < SHOWN; shown++) {
		fputc(*p == '\t' ? ' ' : *p, out);
		for (p++; (*p & 0xC0) == 0x80; p++)
			fputc(*p, out);
	}
	fprintf(out, "\n  %*s^\n", column - skip - 1, "");
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

/* What a terminal shows while a calibration runs: one line, four times a
 * second; elsewhere a row at generation 1 and every ten. */
struct progress {
	bool terminal;
	double shown;
	size_t row;
	int width;
};

static void
progress_line(struct progress *p, const struct calibrate_status *st)
{
	double now = session_clock();
	if (now - p->shown < 0.25)
		return;
	p->shown = now;
	char text[128];
	if (st->state == CALIBRATE_POLISHING)
		snprintf(text, sizeof text, "  polish %zu  best %.4g",
		    st->starts_done, st->best);
	else
		snprintf(text, sizeof text,
		    "  generation %zu  best %.4g  median %.4g  stall %zu",
		    st->generation, st->best, st->median, st->stall);
	int width = text_width(text);
	fprintf(stderr, "\r%s%*s", text,
	    p->width > width ? p->width - width : 0, "");
	p->width = width;
	fflush(stderr);
}

static void
progress_row(struct progress *p, const struct calibrate_status *st)
{
	bool due = st->generation == 1 || st->generation % 10 == 0;
	if (st->state == CALIBRATE_POLISHING || !due ||
	    st->generation == p->row)
		return;
	p->row = st->generation;
	fprintf(stderr, "  generation %4zu  best %.6g  median %.6g\n",
	    st->generation, st->best, st->median);
}

static void
progress(struct session *s, struct progress *p)
{
	if (!session_busy(s) || s->notes == NULL)
		return;
	struct calibrate_status st = calibration_status(s->job.calibration);
	if (p->terminal)
		progress_line(p, &st);
	else
		progress_row(p, &st);
}

/* Runs the job to its end.  False when it was interrupted. */
static bool
pump(struct session *s)
{
	struct progress p = {
	    .terminal = isatty(STDERR_FILENO) != 0, .shown = session_clock()};
	while (session_busy(s) && !interrupted) {
		session_step(s);
		progress(s, &p);
	}
	if (p.width > 0)
		fprintf(stderr, "\r%*s\r", p.width, "");
	if (!interrupted)
		return true;
	session_pause(s);
	return false;
}

static int run_scripts(struct session *s, size_t depth);

/* Ends what the line has under way after an error or an interruption; the
 * latter keeps the results so far. */
static void
give_up(struct session *s, int status, const char *line, const char *name)
{
	struct error error = {.kind = (enum error_kind)status};
	bool ok = status == 0 || interrupted;
	if (!session_settle(s, ok, &error) && ok)
		print_error(&error, line, name);
}

static int
run_line(struct session *s, const char *line, const char *name, int number)
{
	size_t at = 0, depth = script_depth(s);
	do {
		struct error error = {0};
		if (!session_line(s, line, at, name, number, &at, &error)) {
			fflush(s->out);
			print_error(&error, line, name);
			return (int)error.kind;
		}
		if (!pump(s)) {
			give_up(s, 0, line, name);
			fprintf(stderr, "%s:%d: interrupted\n", name, number);
			return status_of(interrupted);
		}
		int status = run_scripts(s, depth);
		if (status != 0 || s->quit)
			give_up(s, status, line, name);
		if (status != 0)
			return status;
	} while (at > 0 && !s->quit);
	return 0;
}

/* Runs the scripts that are open beyond `depth` of them. */
static int
run_scripts(struct session *s, size_t depth)
{
	int status = 0;
	while (status == 0 && script_depth(s) > depth && !s->quit &&
	       !interrupted) {
		struct error error = {0};
		struct place place;
		char *line = script_line(s, &place, &error);
		if (line != NULL)
			status = run_line(s, line, place.file, place.line);
		else if (error.kind != ERROR_NONE)
			print_error(&error, "", "");
		if (line == NULL)
			status = (int)error.kind;
		free(line);
	}
	script_close(s, depth);
	return interrupted ? status_of(interrupted) : status;
}

int
batch_stream(struct session *s, FILE *in, const char *name)
{
	size_t depth = script_depth(s);
	script_open_stream(s, in, name);
	return run_scripts(s, depth);
}

int
batch_text(struct session *s, const char *text, const char *name, int line)
{
	size_t depth = script_depth(s);
	script_open_text(s, text, name, line);
	return run_scripts(s, depth);
}

int
batch_file(struct session *s, const char *path)
{
	size_t depth = script_depth(s);
	struct error error = {0};
	if (script_open(s, path, &error))
		return run_scripts(s, depth);
	error_print(&error, stderr);
	return (int)error.kind;
}

/* A signal other than ^C: the terminal or the system wants the program gone. */
static bool
ended(void)
{
	return interrupted != 0 && interrupted != SIGINT;
}

static void
print_prompt(struct session *s, bool goes_on)
{
	if (goes_on)
		fputs("> ", s->out);
	else if (s->n_entry > 0)
		fprintf(s->out, "tipspeed %s> ", session_entry(s)->key);
	else
		fputs("tipspeed> ", s->out);
	fflush(s->out);
}

int
batch_typed(struct session *s)
{
	char *piece = NULL, *line = xstrdup("");
	size_t room = 0;
	s->prompt = true;
	for (int number = 1; !s->quit; interrupted = 0) {
		print_prompt(s, line[0] != '\0');
		ssize_t got = getline(&piece, &room, stdin);
		bool more = got >= 0 && script_goes_on(piece);
		if (got < 0)
			fputc('\n', s->out);
		if (got < 0 && interrupted != SIGINT)
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
		run_line(s, line, "typed", number++);
		line[0] = '\0';
		if (ended())
			break;
	}
	free(piece);
	free(line);
	return ended() ? status_of(interrupted) : 0;
}
