/* Draws the running command over the page, at most ten times a second, and lets
 * Esc interrupt it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/script_progress.h"

#include <signal.h>
#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/fit/job.h"
#include "cmd/session/script.h"
#include "cli/signals.h"
#include "tui/captured.h"
#include "tui/widgets/viewer.h"

/* Returns "4 of 15: validate", with the state of its search.  The caller frees
 * it. */
static char *
running_line_text(const struct tui *t)
{
	const struct session *s = t->session;
	char *words = xasprintf("%s  %s", tr("WORKING"), t->running_line);
	if (session_is_calibrating(s) && !s->job.fits) {
		FREED char *at = s->job.type->task_words(s);
		xappend(&words, "\n%s", at);
	}
	if (s->job.calibration != NULL && !s->job.paused) {
		xappend_to_list(&words, "\n", tr("generation %zu of %zu"),
		    calibration_status(s->job.calibration).generation,
		    s->job.options.generations);
	}
	return words;
}

/* During a script, no page can be drawn, because each command may change what
 * it shows. */
static void
draw_progress_if_due(struct tui *t, bool begins)
{
	/* s; what is over by then is not shown */
	const double often = 0.1, patience = t->of_script ? often : 0.3;
	double now = session_clock();
	if (t->running_line == NULL || t->callbacks->stopped == NULL ||
	    now - t->ran_from < patience ||
	    (!begins && now - t->drawn_at < often) || t->away)
		return;
	viewer_show_text(t, running_line_text(t));
	t->callbacks->show(t);
	viewer_close(t);
	t->drawn_at = now;
	if (t->callbacks->stopped(t)) {
		t->stopping = true;
		raise(SIGINT);
		signals_deliver_blocked();
	}
}

void
script_progress_start_typed_line(struct tui *t, const char *line)
{
	t->ran_from = session_clock();
	free(t->running_line);
	t->running_line = xstrdup(line);
	t->of_script = t->stopping = false;
}

void
script_progress_start_line(void *of, const char *line)
{
	struct tui *t = of;
	struct script_place at = script_position(t->session);
	if (!t->of_script)
		t->ran_from = session_clock();
	t->of_script = true;
	free(t->running_line);
	t->running_line =
	    at.of > 0 ? xasprintf(tr("%zu of %zu: %s"), at.at, at.of, line)
		      : xstrdup(line);
	draw_progress_if_due(t, true);
}

void
script_progress_draw(struct tui *t)
{
	draw_progress_if_due(t, false);
}

void
script_progress_end(struct tui *t, bool restores, bool ok)
{
	bool drawn = t->of_script || t->drawn_at >= t->ran_from;
	if (drawn)
		viewer_close(t);
	/* A signal from elsewhere ends the program, unless a script runs. */
	if ((t->of_script || t->stopping) && signals_pending() == SIGINT) {
		signals_forget_interrupt();
		captured_discard_output(t);
		if (t->of_script)
			tui_say(t, false,
			    "stopped at %s: what was done before stays, "
			    "u undoes it",
			    t->running_line);
		else
			tui_say(t, false, "stopped: %s", t->running_line);
	} else if (ok && t->of_script) {
		const struct entry *entry = tui_current_entry(t);
		const size_t n = t->session->n_entry;
		if (restores)
			captured_discard_output(t);
		FREED char *words =
		    entry == NULL
			? xstrdup(tr("no site is loaded"))
			: xasprintf(
			      tr_n("%zu site is loaded, %s is in use",
				  "%zu sites are loaded, %s is in use", n),
			      n, entry->key);
		tui_say(t, false, "%s: %s",
		    restores ? tr("restored") : tr("the script has run"),
		    words);
	}
	t->keep_message = t->keep_message || drawn;
	free(t->running_line);
	t->running_line = NULL;
}
