/* The job, pumped.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/pump.h"

#include <errno.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/draw/plots.h"
#include "cmd/fit/job.h"
#include "cli/terminal.h"

static volatile sig_atomic_t noted, asked, watching, stopped, woken, resized;

/* Signals that are let in while the program waits. */
static sigset_t let_in;

static void
on_signal(int signal)
{
	if (noted == 0 || noted == SIGINT)
		noted = signal;
}

static void
on_ask(int signal)
{
	asked = signal;
}

static void
on_file_size(int signal)
{
	(void)signal;
}

void
pump_catch_signals(void)
{
	struct sigaction action = {.sa_handler = on_signal};
	sigemptyset(&action.sa_mask);
	sigaction(SIGINT, &action, NULL);
	sigaction(SIGTERM, &action, NULL);
	sigaction(SIGHUP, &action, NULL);
	/* The write then fails, as on a full disk; shells that are started get
	 * the usual end by it, which SIG_IGN would not give back. */
	action.sa_handler = on_file_size;
	sigaction(SIGXFSZ, &action, NULL);
	action.sa_handler = on_ask;
	action.sa_flags = SA_RESTART;
	sigaction(SIGUSR1, &action, NULL);
}

static void
on_terminal(int signal)
{
	*(signal == SIGTSTP     ? &stopped
	    : signal == SIGCONT ? &woken
				: &resized) = 1;
}

void
pump_hold_signals(void)
{
	static const int ANSWERED[] = {
	    SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGCONT, SIGWINCH};
	sigset_t held;
	sigemptyset(&held);
	for (size_t i = 0; i < ARRAY_LEN(ANSWERED); i++)
		sigaddset(&held, ANSWERED[i]);
	sigprocmask(SIG_BLOCK, &held, &let_in);
}

void
pump_free_signals(void)
{
	sigprocmask(SIG_SETMASK, &let_in, NULL);
}

static bool
wait_with(const sigset_t *mask, double seconds)
{
	struct timespec time = {0};
	bool ends = isfinite(seconds);
	if (ends) {
		time.tv_sec = (time_t)seconds;
		time.tv_nsec = (long)(1e9 * (seconds - floor(seconds)));
	}
	fd_set in;
	FD_ZERO(&in);
	FD_SET(STDIN_FILENO, &in);
	return pselect(STDIN_FILENO + 1, &in, NULL, NULL, ends ? &time : NULL,
		   mask) > 0;
}

/* What was let in before is not to wait for what comes next. */
bool
pump_wait(double seconds)
{
	if (noted != 0 || stopped || woken || resized)
		return false;
	return wait_with(&let_in, seconds);
}

void
pump_let_in(void)
{
	sigset_t held;
	sigprocmask(SIG_SETMASK, &let_in, &held);
	sigprocmask(SIG_SETMASK, &held, NULL);
}

void
pump_note_stop(bool note)
{
	struct sigaction now,
	    action = {.sa_handler = note ? on_terminal : SIG_DFL};
	sigaction(SIGTSTP, NULL, &now);
	if (now.sa_handler != SIG_IGN)
		sigaction(SIGTSTP, &action, NULL);
}

void
pump_take_terminal(struct sigaction was[static 3])
{
	struct sigaction action = {.sa_handler = on_terminal};
	sigaction(SIGTSTP, NULL, &was[0]);
	sigaction(SIGCONT, &action, &was[1]);
	sigaction(SIGWINCH, &action, &was[2]);
	pump_note_stop(true);
}

void
pump_give_terminal(const struct sigaction was[static 3])
{
	sigaction(SIGTSTP, &was[0], NULL);
	sigaction(SIGCONT, &was[1], NULL);
	sigaction(SIGWINCH, &was[2], NULL);
}

int
pump_news(void)
{
	int news = (stopped ? PUMP_STOP : 0) | (woken ? PUMP_WAKE : 0) |
		   (resized ? PUMP_SIZE : 0);
	stopped = woken = resized = 0;
	return news;
}

void
pump_suspend(void)
{
	struct sigaction was, usual = {.sa_handler = SIG_DFL};
	sigaction(SIGTSTP, &usual, &was);
	raise(SIGTSTP);
	pump_let_in();
	sigaction(SIGTSTP, &was, NULL);
}

int
pump_signal(void)
{
	return noted;
}

bool
pump_ended(void)
{
	return noted != 0 && noted != SIGINT;
}

void
pump_forget_interrupt(void)
{
	/* Between the two, another signal may come. */
	if (noted == SIGINT)
		noted = 0;
}

/* What ends the wait is let in only while there is nothing to read: one that
 * came just before would be noted, and the read would wait on.  ^Z keeps its
 * usual effect all the time. */
int
pump_answer(char **line)
{
	static const int ENDS[] = {SIGINT, SIGTERM, SIGHUP};
	sigset_t held, was;
	int first = EOF;
	unsigned char c = 0;
	sigemptyset(&held);
	for (size_t i = 0; i < ARRAY_LEN(ENDS); i++)
		sigaddset(&held, ENDS[i]);
	sigprocmask(SIG_BLOCK, &held, &was);
	while (c != '\n' && pump_signal() == 0) {
		if (!wait_with(&was, INFINITY))
			continue;
		ssize_t got = read(STDIN_FILENO, &c, 1);
		if (got == 0 || (got < 0 && errno != EINTR))
			break;
		first = got > 0 && first == EOF ? c : first;
		if (got > 0 && c != '\n' && line != NULL)
			xappend(line, "%c", c);
	}
	sigprocmask(SIG_SETMASK, &was, NULL);
	return c == '\n' ? first : EOF;
}

bool
pump_confirm(struct session *s, const char *question)
{
	(void)s;
	text_put(question, stderr);
	fputs(" [y/N] ", stderr);
	int c = pump_answer(NULL);
	if (c == EOF)
		fputc('\n', stderr);
	return c == 'y' || c == 'Y';
}

/* What stands above the questions of a table. */
static void
show_table(const struct inquiry *q, int columns)
{
	text_wrap(q->about, 0, columns, stderr);
	for (size_t r = 0; q->ask->n > 0 && r <= q->ask->n; r++) {
		char *line = inquiry_row(q, r, columns);
		text_put(line, stderr);
		fputc('\n', stderr);
		free(line);
	}
	if (q->ask->n > 0)
		text_wrap("Enter accepts what is in [ ], - leaves a column "
			  "out, ^C gives up",
		    0, columns, stderr);
}

/* Past the notes of the session, which wait for the end of the command. */
char *
pump_ask(
    struct session *s, const struct inquiry *q, char *(*read)(const char *text))
{
	int rows, columns;
	(void)s;
	terminal_size(&rows, &columns);
	columns = columns < 100 ? columns - 1 : 99;
	if (q->wrong[0] != '\0')
		text_wrap(q->wrong, 0, columns, stderr);
	if (q->first)
		show_table(q, columns);
	fflush(stderr);
	bool offers = q->offered[0] != '\0';
	char *asks = xasprintf("%s%s%s%s: ", q->text, offers ? " [" : "",
	    q->offered, offers ? "]" : "");
	char *shown = text_shown(asks), *answer = read(shown);
	free(shown);
	free(asks);
	return answer;
}

static char *
read_plain(const char *text)
{
	text_put(text, stderr);
	char *line = xstrdup("");
	if (pump_answer(&line) != EOF && text_is_utf8(line, strlen(line)))
		return line;
	free(line);
	fputc('\n', stderr);
	return NULL;
}

char *
pump_question(struct session *s, const struct inquiry *q)
{
	return pump_ask(s, q, read_plain);
}

int
pump_status(void)
{
	return noted != 0 ? 128 + noted : 0;
}

void
pump_watch(bool keys)
{
	watching = keys;
}

bool
pump_waited_for(void)
{
	sigset_t held;
	struct pollfd in = {.fd = STDIN_FILENO, .events = POLLIN};
	if (noted != 0)
		return true;
	sigpending(&held);
	return sigismember(&held, SIGINT) || sigismember(&held, SIGTERM) ||
	       sigismember(&held, SIGHUP) || (watching && poll(&in, 1, 0) > 0);
}

/* What a terminal shows while a calibration runs: one line, four times a
 * second; elsewhere a row at generation 1 and every ten, of what takes long or
 * is to be told in detail. */
struct progress {
	bool terminal;
	double shown;
	size_t row;
};

/* Columns of the progress that is on the screen, and rows of what is watched
 * above it. */
static int on_screen, rows_above;

static void
clear_line(void)
{
	if (rows_above > 0)
		fprintf(stderr, "\r\033[%dA\033[J", rows_above);
	on_screen = rows_above > 0 ? 0 : on_screen;
	rows_above = 0;
	if (on_screen > 0)
		fprintf(stderr, "\r%*s\r", on_screen, "");
	on_screen = 0;
}

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
	int rows, columns, width = text_width(text);
	terminal_size(&rows, &columns);
	int room = columns > 12 ? columns - 3 : 9; /* with the echo of ^C */
	if (width > room)
		text[width = room] = '\0';
	fprintf(stderr, "\r%s%*s", text,
	    on_screen > width ? on_screen - width : 0, "");
	on_screen = width;
	fflush(stderr);
}

static void
progress_row(
    struct session *s, struct progress *p, const struct calibrate_status *st)
{
	const double soon = 2; /* s */
	bool due = st->generation == 1 ||
		   (st->generation > 0 && st->generation % 10 == 0);
	if (st->state >= CALIBRATE_POLISHING || !due ||
	    st->generation == p->row ||
	    (!s->job.detail && session_clock() - s->job.started < soon))
		return;
	p->row = st->generation;
	fprintf(stderr, "  generation %4zu  best %.6g  median %.6g\n",
	    st->generation, st->best, st->median);
}

/* What can move its cursor up and clear below it. */
static bool
can_watch(const struct session *s, const struct progress *p)
{
	const char *term = getenv("TERM");
	return p->terminal && s->job.watch && s->job.fits && !s->linear &&
	       term != NULL && term[0] != '\0' && strcmp(term, "dumb") != 0;
}

/* All runs and what the best candidate makes of them, over the picture of the
 * generation before. */
static void
draw_watched(
    struct session *s, struct progress *p, const struct calibrate_status *st)
{
	enum { WIDEST = 100, HIGHEST = 22, LEAST = 8 };
	int rows, columns;
	struct error error = {0};
	struct plot_request request = plots_request(PLOT_RUNS);
	terminal_size(&rows, &columns);
	rows = rows - 2 < HIGHEST ? rows - 2 : HIGHEST;
	if (st->generation == p->row || rows < LEAST)
		return;
	p->row = st->generation;
	request.site = s->entry[s->job.entry].key;
	request.words = CHART_TITLE | CHART_LEGEND;
	request.charset = s->screen.drawing ? CHARSET_BRAILLE : CHARSET_ASCII;
	struct canvas *canvas = plots_draw(s, &request,
	    columns - 1 < WIDEST ? columns - 1 : WIDEST, rows, &error);
	if (canvas == NULL)
		return;
	clear_line();
	canvas_print(canvas, s->screen.colours, stderr);
	canvas_free(canvas);
	rows_above = rows;
	p->shown = 0;
}

/* A search would be over before it is seen: its first generations take a
 * moment each. */
static void
pace_watched(const struct session *s)
{
	enum { MOMENT_MS = 40 };
	const double long_s = 4;
	if (session_clock() - s->job.started < long_s)
		poll(NULL, 0, MOMENT_MS);
}

static void
watch(struct session *s, struct progress *p, const struct calibrate_status *st)
{
	size_t before = p->row;
	if (st->state == CALIBRATE_SEARCHING)
		draw_watched(s, p, st);
	progress_line(p, st);
	if (p->row != before)
		pace_watched(s);
}

static void
progress(struct session *s, struct progress *p)
{
	if (!session_busy(s) || s->notes == NULL)
		return;
	struct calibrate_status st = calibration_status(s->job.calibration);
	if (can_watch(s, p))
		watch(s, p, &st);
	else if (p->terminal)
		progress_line(p, &st);
	else
		progress_row(s, p, &st);
}

/* The answer to SIGUSR1. */
static void
answer(const struct session *s)
{
	struct calibrate_status st = calibration_status(s->job.calibration);
	clear_line();
	fprintf(stderr,
	    st.state == CALIBRATE_POLISHING
		? tr("%s: generation %zu of %zu, best %.4g, median %.4g, %.1f "
		     "s, polishing\n")
		: tr("%s: generation %zu of %zu, best %.4g, median %.4g, %.1f "
		     "s\n"),
	    s->entry[s->job.entry].key, st.generation,
	    s->job.options.generations, st.best, st.median,
	    session_clock() - s->job.started);
	asked = 0;
}

bool
pump_run(struct session *s)
{
	struct progress p = {
	    .terminal = isatty(STDERR_FILENO) != 0, .shown = session_clock()};
	asked = 0;
	s->hooks.tidy = p.terminal ? clear_line : NULL;
	while (session_busy(s) && noted == 0) {
		session_rounds(s);
		if (session_busy(s) && asked)
			answer(s);
		progress(s, &p);
	}
	clear_line();
	return noted == 0;
}
