/* What goes with every command: where its results go, how long it takes, and
 * its part in undo and in the journal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/invocation.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/files.h"
#include "cmd/session/autosave.h"
#include "cmd/session/redirect.h"
#include "cmd/session/undo.h"

/* Returns the index of the option that names a file, or OPTIONS. */
static size_t
find_file_option(const struct args *args)
{
	const struct command_option *o;
	for (size_t i = 0; (o = command_option_at(args->command, i)) != NULL;
	     i++)
		if (value_is_file(o, &args->value[i]))
			return i;
	return OPTIONS;
}

/* Returns false with an error if the command would use files or the shell. */
static bool
check_allowed_in_safe_mode(
    const struct args *args, const struct words *words, struct error *error)
{
	const struct command *command = args->command;
	size_t option = find_file_option(args);
	if ((command->flags & COMMAND_FILES) && args->n_operand > 0)
		error_set(error, ERROR_USAGE,
		    "%s is not allowed: it uses files", command->name);
	else if (option < OPTIONS)
		error_set(error, ERROR_USAGE,
		    "%s= is not allowed: it names a file",
		    command_option_at(command, option)->name);
	else if (words->to != TO_SCREEN)
		error_set(error, ERROR_USAGE, "%s is not allowed",
		    words->to == TO_PIPE ? tr("a shell command")
					 : tr("writing to a file"));
	else
		return true;
	return error_set_hint(error,
	    "start the program without --safe to allow it: with --safe it "
	    "reads only the files of its command line and writes none");
}

static double
feed_speed_of_prediction(const struct session *s)
{
	return session_number_in_last_answer(s, "predict", "feed_mps");
}

bool
invocation_begin(struct session *s, const struct args *args,
    const struct words *words, struct place place, struct error *error)
{
	const struct command *command = args->command;
	if (s->safe && !check_allowed_in_safe_mode(args, words, error))
		return false;
	if (s->initial == NULL) {
		s->initial = xcalloc(1, sizeof *s->initial);
		*s->initial = s->set;
		journal_add_settings(s);
	}
	struct invocation *t = xcalloc(1, sizeof *t);
	*t = (struct invocation){.outer = s->invocation,
	    .command = command,
	    .place = place,
	    .column =
		words->to == TO_SCREEN ? words->column[0] : words->to_column,
	    .started = session_clock_seconds(),
	    .timed = s->set.timing,
	    .running = true,
	    .scripts = s->scripts};
	if (words->to != TO_SCREEN &&
	    redirect_is_allowed(command, words, error))
		t->redirect = redirect_open(s, command, words, error);
	if (words->to != TO_SCREEN && t->redirect == NULL) {
		error_set_place(error, place.file, place.line, t->column);
		free(t);
		return false;
	}
	t->label = journal_typed_command_text(command, words);
	t->line = journal_saved_command_text(args, words);
	t->state = journal_current_place(s).state;
	t->steps = undo_count_steps(s);
	t->uses = files_count_all_uses(s);
	t->asked = s->last_asked;
	t->fed = feed_speed_of_prediction(s);
	if (command->flags & COMMAND_CHANGES)
		t->before = snapshot_take_session(s);
	s->invocation = t;
	return true;
}

void
invocation_set_job_stopped(struct session *s, size_t steps)
{
	struct invocation *t = s->job.invocation;
	if (t == NULL)
		return;
	t->stopped = true;
	t->stopped_at = steps;
}

void
invocation_add_journal_options(struct session *s, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	FREED char *options = xvasprintf(format, ap);
	va_end(ap);
	xappend(&s->invocation->line, "%s", options);
}

/* True if the results of the command, or of a script that it is in, are
 * redirected. */
static bool
is_result_redirected(const struct invocation *t)
{
	while (t != NULL && t->redirect == NULL)
		t = t->outer;
	return t != NULL;
}

static bool
was_stopped_without_result(const struct invocation *t)
{
	return t->stopped && t->stopped_at == 0;
}

/* Adds lines that check that the files that the command read are unchanged.
 * Commands with digest= check the numbers themselves. */
static void
add_file_checks_to_journal(
    struct session *s, const struct invocation *t, const char *latest)
{
	uint64_t digest;
	size_t n = files_count_all_uses(s);
	if (command_option_index(t->command, "digest") < OPTIONS)
		return;
	for (size_t i = t->uses; i < n; i++) {
		const char *path = files_path_of_nth_read(s, i, &digest);
		if (path == NULL)
			continue;
		journal_add_file_check(s, latest, path, digest);
		latest = NULL;
	}
}

/* True if later commands, which by default ask about the same as the latest
 * one, may answer otherwise than without the command. */
static bool
has_asked_otherwise(const struct session *s, const struct invocation *t)
{
	const struct last_asked *was = &t->asked, *now = &s->last_asked;
	double fed = feed_speed_of_prediction(s);
	return was->speed != now->speed || was->found_by != now->found_by ||
	       was->named != now->named ||
	       (now->named && !quantity_is_same(&was->of, &now->of)) ||
	       (fed != t->fed && !(isnan(fed) && isnan(t->fed)));
}

/* Adds the command's line to the journal.  If its results are redirected, a
 * saved script does not write them, but repeats what the command changed. */
static void
record_command_in_journal(
    struct session *s, const struct invocation *t, bool changed)
{
	static const char aside[] = " > /dev/null";
	bool elsewhere = is_result_redirected(t);
	/* A report asks, and then brings back what was asked before. */
	changed = changed || (s->document == NULL && has_asked_otherwise(s, t));
	/* A result on the screen does not give way to one that was not. */
	bool series = (t->command->flags & COMMAND_KEEPS_LAST) != 0 &&
		      journal_last_line_ends(s, aside) == elsewhere;
	const char *latest = series ? t->command->name : NULL;
	/* Answers during a calibration depend on the moment, settings do
	 * not. */
	bool between = session_is_calibrating(s) && s->job.invocation != t &&
		       (t->command->flags & COMMAND_SETTINGS) == 0;
	if ((t->command->flags & COMMAND_UNSAVED) || (elsewhere && !changed) ||
	    between || was_stopped_without_result(t))
		return;
	char pause[32] = "";
	if (t->stopped)
		snprintf(pause, sizeof pause, " pause=%zu", t->stopped_at);
	add_file_checks_to_journal(s, t, latest);
	journal_add_line(
	    s, latest, "%s%s%s", t->line, pause, elsewhere ? aside : "");
}

void
invocation_journal_prediction(struct session *s, const char *line)
{
	if (!is_result_redirected(s->invocation) && !session_is_calibrating(s))
		journal_add_slider_line(s, line);
	autosave_after_command(s, true, false);
}

/* Returns the number of undo steps when the outermost invocation began;
 * SIZE_MAX if t is the outermost. */
static size_t
undo_depth_at_outermost_call(const struct invocation *t)
{
	size_t floor = SIZE_MAX;
	for (t = t->outer; t != NULL; t = t->outer)
		floor = t->steps;
	return floor;
}

bool
invocation_is_over(const struct session *s)
{
	bool working =
	    session_is_calibrating(s) && s->job.invocation == s->invocation;
	return !working && !s->invocation->running &&
	       s->scripts <= s->invocation->scripts;
}

bool
invocation_end(struct session *s, bool ok, struct error *error)
{
	struct invocation *t = s->invocation;
	/* A check that fails still has an answer. */
	bool none = was_stopped_without_result(t);
	bool keep = (ok || error->kind == ERROR_CHECK) && !none;
	bool changed =
	    t->before != NULL && !none && snapshot_differs(t->before, s);
	s->invocation = t->outer;
	if (ok)
		record_command_in_journal(s, t, changed);
	if (t->redirect != NULL)
		redirect_close(s, t->redirect, keep, &t->late);
	if (ok && t->late.kind != ERROR_NONE) {
		*error = t->late;
		error_prefix_file_name(
		    error, t->place.file, t->place.line, t->column);
		ok = false;
	}
	if (changed && !t->joins)
		undo_push_step(s, t->before, t->steps,
		    undo_depth_at_outermost_call(t), t->label);
	else
		snapshot_free(t->before);
	if (changed)
		s->job.newest = t->stopped;
	if (t->timed && s->set.timing)
		session_print_note(s, "%s: %.3f s", t->command->name,
		    session_clock_seconds() - t->started);
	/* If it ran a script, the commands there may have numbered the state
	 * already. */
	if (changed && !(t->command->flags & COMMAND_APPEARANCE) &&
	    journal_current_place(s).state == t->state)
		journal_assign_state_number(s);
	autosave_after_command(s, ok, t->saved);
	free(t->label);
	free(t->line);
	free(t);
	return ok;
}

bool
session_end_finished_commands(struct session *s, bool ok, struct error *error)
{
	while (s->invocation != NULL && invocation_is_over(s))
		ok = invocation_end(s, ok, error);
	return ok;
}
