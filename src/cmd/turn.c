/* What goes with every command: where its results go, how long it takes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/turn.h"

#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/redirect.h"
#include "cmd/script.h"
#include "cmd/snapshot.h"

/* Turns nest: a script's commands run within the turn of its source. */
struct turn {
	struct turn *outer;
	const struct command *command;
	struct redirect *redirect; /* or NULL */
	struct place place;        /* of the redirection */
	int column;
	double started;
	bool timed;
	size_t scripts;                 /* that were open when it began */
	const struct calibration *busy; /* a job of others under way then */
};

static bool
put_place(const struct turn *t, struct error *error)
{
	snprintf(error->file, sizeof error->file, "%s", t->place.file);
	error->line = t->place.line;
	error->column = t->column;
	return false;
}

bool
turn_begin(struct session *s, const struct command *command,
    const struct args *args, const struct words *words, struct place place,
    struct error *error)
{
	(void)args;
	if (s->first == NULL) {
		s->first = xcalloc(1, sizeof *s->first);
		*s->first = choices_take(s);
	}
	struct turn *t = xcalloc(1, sizeof *t);
	*t = (struct turn){.outer = s->turn,
	    .command = command,
	    .place = place,
	    .column = words->to_column,
	    .started = session_clock(),
	    .timed = s->timing,
	    .scripts = script_depth(s),
	    .busy = session_busy(s) ? s->job.calibration : NULL};
	if (words->to != TO_SCREEN)
		t->redirect = redirect_open(s, words, error);
	if (words->to != TO_SCREEN && t->redirect == NULL) {
		put_place(t, error);
		free(t);
		return false;
	}
	s->turn = t;
	return true;
}

bool
turn_over(const struct session *s)
{
	bool working = session_busy(s) && s->job.calibration != s->turn->busy;
	return !working && script_depth(s) <= s->turn->scripts;
}

bool
turn_end(struct session *s, bool ok, struct error *error)
{
	struct turn *t = s->turn;
	/* The report of a check that says no is a result. */
	bool keep = ok || error->kind == ERROR_CHECK;
	struct error late = {0};
	s->turn = t->outer;
	if (t->redirect != NULL &&
	    !redirect_close(s, t->redirect, keep, &late) && ok) {
		*error = late;
		ok = put_place(t, error);
	}
	if (t->timed && s->timing)
		session_note(s, "%s: %.3f s", t->command->name,
		    session_clock() - t->started);
	free(t);
	return ok;
}

bool
session_settle(struct session *s, bool ok, struct error *error)
{
	while (s->turn != NULL && turn_over(s))
		ok = turn_end(s, ok, error);
	return ok;
}
