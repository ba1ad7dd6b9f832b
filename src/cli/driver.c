/* Commands return at once, so that every driver stays responsive.  This is the
 * loop that finishes what they have started.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/driver.h"

#include "base/xalloc.h"
#include "cmd/fit/job.h"
#include "cmd/run/line.h"
#include "cmd/session/script.h"
#include "cmd/session/invocation.h"
#include "cli/signals.h"

/* Ends the commands that a line has started, after an error or an interruption.
 * An interruption keeps the results so far. */
static void
end_commands_started_by_line(
    const struct driver *d, int status, const char *line, const char *name)
{
	struct error error = {.kind = (enum error_kind)status};
	bool ok = status == 0 || signals_get_ending_or_interrupt() != 0;
	if (!session_end_finished_commands(d->session, ok, &error) && ok)
		d->fail(d->of, &error, line, name);
}

/* Stops a line after a signal, and keeps the results so far.  Returns the exit
 * status. */
static int
stop_line_on_signal(
    const struct driver *d, const char *line, const char *name, int number)
{
	pager_hold_notes(d->pager);
	session_stop_job_for_user(d->session);
	end_commands_started_by_line(d, 0, line, name);
	pager_show_new_output(d->pager);
	if (d->interrupted != NULL)
		d->interrupted(name, number);
	return signals_exit_status();
}

/* Reports that a command did nothing, because it failed or a signal came first.
 * Returns the exit status. */
static int
report_failed_command(const struct driver *d, const struct error *e,
    const char *line, const char *name, int number)
{
	if (e->kind != ERROR_STOPPED)
		d->fail(d->of, e, line, name);
	else if (d->interrupted != NULL)
		d->interrupted(name, number);
	return signals_get_ending_or_interrupt() != 0 ? signals_exit_status()
						      : (int)e->kind;
}

/* Runs to their ends what the line's commands have started: the job, scripts,
 * the full screen.  Returns the exit status. */
static int
run_started_work_to_end(const struct driver *d, size_t depth, const char *line,
    const char *name, int number)
{
	struct session *s = d->session;
	if (!d->work(s))
		return stop_line_on_signal(d, line, name, number);
	pager_show_new_output(d->pager);
	int status = driver_run_scripts(d, depth);
	if (status == 0 && s->wants_tui && s->hooks.run_screen != NULL) {
		s->wants_tui = false;
		status = s->hooks.run_screen(s);
	}
	if (status != 0 || s->quit)
		end_commands_started_by_line(d, status, line, name);
	pager_show_new_output(d->pager);
	return status;
}

int
driver_run_line_to_end(
    const struct driver *d, const char *line, const char *name, int number)
{
	struct session *s = d->session;
	size_t at = 0, depth = s->scripts;
	int status = 0;
	do {
		struct error error = {0};
		pager_hold_notes(d->pager);
		bool ok =
		    session_run_line(s, line, at, name, number, &at, &error);
		pager_show_new_output(d->pager);
		if (!ok) {
			fflush(s->out);
			return report_failed_command(
			    d, &error, line, name, number);
		}
		if (d->watches && number == 0 && session_is_calibrating(s) &&
		    s->scripts == depth && line[at] == '\0')
			return 0;
		status = run_started_work_to_end(d, depth, line, name, number);
	} while (status == 0 && at > 0 && !s->quit);
	return status;
}

int
driver_run_scripts(const struct driver *d, size_t depth)
{
	struct session *s = d->session;
	int status = 0;
	while (status == 0 && s->scripts > depth && !s->quit &&
	       signals_get_ending_or_interrupt() == 0) {
		struct error error = {0};
		struct place place;
		FREED char *line = script_read_line(s, &place, &error);
		if (line != NULL && d->begins != NULL)
			d->begins(d->of, line);
		if (line != NULL && signals_get_ending_or_interrupt() == 0)
			status = driver_run_line_to_end(
			    d, line, place.file, place.line);
		else if (error.kind != ERROR_NONE)
			d->fail(d->of, &error, "", "");
		if (line == NULL)
			status = (int)error.kind;
	}
	script_close_to_depth(s, depth);
	return signals_get_ending_or_interrupt() != 0 ? signals_exit_status()
						      : status;
}
