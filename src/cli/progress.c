/* Runs the job to its end and shows its progress in lines or as a plot.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/progress.h"

#include <poll.h>
#include <stdio.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/draw/plots.h"
#include "cmd/fit/job.h"
#include "cli/signals.h"
#include "cli/terminal.h"

/* What progress has been shown.  On a terminal it is one line, written at most
 * four times a second; shown is when, s.  Elsewhere, a row is printed for
 * generation 1 and every tenth one, if the search takes long or details are
 * wanted.  row: the generation last printed or plotted. */
struct progress {
	bool terminal;
	double shown;
	size_t row;
};

/* Columns of the line on the screen, and rows of the plot above it. */
static int on_screen, rows_above;

static void
clear_progress_line(void)
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
print_progress_line(const struct session *s, struct progress *p,
    const struct calibrate_status *st)
{
	double now = session_clock_seconds();
	if (now - p->shown < 0.25)
		return;
	p->shown = now;
	char text[128];
	if (s->job.calibration == NULL) {
		FREED char *at = s->job.type->task_words(s);
		snprintf(text, sizeof text, "  %s", at);
	} else if (st->state == CALIBRATE_POLISHING)
		snprintf(text, sizeof text,
		    tr("  calibrating: polishing, misfit %.4g"), st->best);
	else
		snprintf(text, sizeof text,
		    tr("  calibrating: generation %zu of at most %zu, misfit "
		       "%.4g"),
		    st->generation, s->job.options.generations, st->best);
	int rows, columns, width = text_width_in_columns(text);
	terminal_size(&rows, &columns);
	/* Leaves room for the echo of ^C. */
	int room = columns > 12 ? columns - 3 : 9;
	if (width > room)
		text[text_bytes_up_to_limit(text, (size_t)room)] = '\0';
	width = width > room ? room : width;
	fprintf(stderr, "\r%s%*s", text,
	    on_screen > width ? on_screen - width : 0, "");
	on_screen = width;
	fflush(stderr);
}

static void
print_generation_row_if_due(
    struct session *s, struct progress *p, const struct calibrate_status *st)
{
	const double soon = 2; /* s */
	bool due = st->generation == 1 ||
		   (st->generation > 0 && st->generation % 10 == 0);
	if (st->state >= CALIBRATE_POLISHING || !due ||
	    st->generation == p->row ||
	    (!s->job.detail && session_clock_seconds() - s->job.started < soon))
		return;
	p->row = st->generation;
	fprintf(stderr, tr("  generation %4zu  best %.6g  median %.6g\n"),
	    st->generation, st->best, st->median);
}

/* Draws all runs and what the best candidate predicts for them, over the plot
 * of the last generation. */
static void
draw_calibration_plot(
    struct session *s, struct progress *p, const struct calibrate_status *st)
{
	enum { WIDEST = 100, HIGHEST = 22, LEAST = 8 };
	int rows, columns;
	struct error error = {0};
	struct plot_request request = plots_default_request(PLOT_RUNS);
	terminal_size(&rows, &columns);
	rows = rows - 2 < HIGHEST ? rows - 2 : HIGHEST;
	if (st->generation == p->row || rows < LEAST)
		return;
	p->row = st->generation;
	request.site = s->entry[s->job.entry].key;
	request.words = CHART_TITLE | CHART_LEGEND;
	request.charset = s->screen.drawing ? CHARSET_BRAILLE : CHARSET_ASCII;
	struct canvas *canvas = plots_draw_canvas(s, &request,
	    columns - 1 < WIDEST ? columns - 1 : WIDEST, rows, &error);
	if (canvas == NULL)
		return;
	clear_progress_line();
	canvas_print(canvas, s->screen.colours, stderr);
	canvas_free(canvas);
	rows_above = rows;
	p->shown = 0;
}

/* Slows down the first seconds of a search, which would otherwise be over
 * before it is seen. */
static void
slow_down_plotted_search(const struct session *s)
{
	enum { MOMENT_MS = 40 };
	const double long_s = 4;
	if (session_clock_seconds() - s->job.started < long_s)
		poll(NULL, 0, MOMENT_MS);
}

static void
show_search_plot_and_progress(
    struct session *s, struct progress *p, const struct calibrate_status *st)
{
	size_t before = p->row;
	if (st->state == CALIBRATE_SEARCHING)
		draw_calibration_plot(s, p, st);
	print_progress_line(s, p, st);
	if (p->row != before)
		slow_down_plotted_search(s);
}

static void
print_progress(struct session *s, struct progress *p)
{
	if (!session_is_calibrating(s))
		return;
	struct calibrate_status st = calibration_status(s->job.calibration);
	/* For a plot, the terminal must be able to move its cursor up and to
	 * clear what is below it. */
	if (p->terminal && s->job.watch && s->job.fits && !s->linear &&
	    !terminal_is_dumb())
		show_search_plot_and_progress(s, p, &st);
	else if (p->terminal)
		print_progress_line(s, p, &st);
	else
		print_generation_row_if_due(s, p, &st);
}

/* Prints a line about the progress, for SIGUSR1. */
static void
print_progress_for_sigusr1(const struct session *s)
{
	struct calibrate_status st = calibration_status(s->job.calibration);
	clear_progress_line();
	if (s->job.calibration == NULL) {
		FREED char *at = s->job.type->task_words(s);
		fprintf(stderr, "%s\n", at);
		return;
	}
	fprintf(stderr,
	    st.state == CALIBRATE_POLISHING
		? tr("%s: generation %zu of %zu, best %.4g, median %.4g, %.1f "
		     "s, polishing\n")
		: tr("%s: generation %zu of %zu, best %.4g, median %.4g, %.1f "
		     "s\n"),
	    s->entry[s->job.entry].key, st.generation,
	    s->job.options.generations, st.best, st.median,
	    session_clock_seconds() - s->job.started);
}

bool
progress_run_job(struct session *s)
{
	struct progress p = {.terminal = isatty(STDERR_FILENO) != 0,
	    .shown = session_clock_seconds()};
	signals_usr1_since_last_call();
	s->hooks.clear_progress = p.terminal ? clear_progress_line : NULL;
	while (session_is_calibrating(s) &&
	       signals_get_ending_or_interrupt() == 0) {
		session_run_parallel_tasks(s);
		if (session_is_calibrating(s) && signals_usr1_since_last_call())
			print_progress_for_sigusr1(s);
		print_progress(s, &p);
	}
	clear_progress_line();
	return signals_get_ending_or_interrupt() == 0;
}
