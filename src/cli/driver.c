/* Commands return at once, which keeps every driver responsive; the loop is
 * here.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/driver.h"

#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/fit/job.h"
#include "cmd/run/line.h"
#include "cmd/session/script.h"
#include "cmd/session/invocation.h"
#include "cli/signals.h"

/* Ends the commands that a line has started, after an error or an interruption;
 * the latter keeps the results so far. */
static void
driver_give_up(
    const struct driver *d, int status, const char *line, const char *name)
{
	struct error error = {.kind = (enum error_kind)status};
	bool ok = status == 0 || signals_pending() != 0;
	if (!session_end_finished_commands(d->session, ok, &error) && ok)
		d->fail(d->of, &error, line, name);
}

/* Stops the line after a signal, with the results so far. */
static int
driver_interrupt(
    const struct driver *d, const char *line, const char *name, int number)
{
	pager_hold(d->pager);
	session_pause(d->session);
	driver_give_up(d, 0, line, name);
	pager_show(d->pager);
	if (d->interrupted != NULL)
		d->interrupted(name, number);
	return signals_status();
}

/* Reports that a command did nothing: it failed, or a signal came first. */
static int
driver_fail(const struct driver *d, const struct error *e, const char *line,
    const char *name, int number)
{
	if (e->kind != ERROR_STOPPED)
		d->fail(d->of, e, line, name);
	else if (d->interrupted != NULL)
		d->interrupted(name, number);
	return signals_pending() != 0 ? signals_status() : (int)e->kind;
}

/* Runs to its end what the commands so far have started. */
static int
driver_finish_work(const struct driver *d, size_t depth, const char *line,
    const char *name, int number)
{
	struct session *s = d->session;
	if (!d->work(s))
		return driver_interrupt(d, line, name, number);
	pager_show(d->pager);
	int status = driver_scripts(d, depth);
	if (status == 0 && s->wants_tui && s->hooks.run_screen != NULL) {
		s->wants_tui = false;
		status = s->hooks.run_screen(s);
	}
	if (status != 0 || s->quit)
		driver_give_up(d, status, line, name);
	pager_show(d->pager);
	return status;
}

int
driver_line(
    const struct driver *d, const char *line, const char *name, int number)
{
	struct session *s = d->session;
	size_t at = 0, depth = s->scripts;
	int status = 0;
	do {
		struct error error = {0};
		pager_hold(d->pager);
		bool ok = session_line(s, line, at, name, number, &at, &error);
		pager_show(d->pager);
		if (!ok) {
			fflush(s->out);
			return driver_fail(d, &error, line, name, number);
		}
		if (d->watches && number == 0 && session_busy(s) &&
		    s->scripts == depth && line[at] == '\0')
			return 0;
		status = driver_finish_work(d, depth, line, name, number);
	} while (status == 0 && at > 0 && !s->quit);
	return status;
}

int
driver_scripts(const struct driver *d, size_t depth)
{
	struct session *s = d->session;
	int status = 0;
	while (status == 0 && s->scripts > depth && !s->quit &&
	       signals_pending() == 0) {
		struct error error = {0};
		struct place place;
		FREED char *line = script_line(s, &place, &error);
		if (line != NULL && d->begins != NULL)
			d->begins(d->of, line);
		if (line != NULL && signals_pending() == 0)
			status = driver_line(d, line, place.file, place.line);
		else if (error.kind != ERROR_NONE)
			d->fail(d->of, &error, "", "");
		if (line == NULL)
			status = (int)error.kind;
	}
	script_close(s, depth);
	return signals_pending() != 0 ? signals_status() : status;
}
