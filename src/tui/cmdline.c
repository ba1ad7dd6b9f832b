/* Runs typed lines: adds the slider's speed to questions that name none, and
 * continues a search after its bounds were changed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/cmdline.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/lang/command.h"
#include "cmd/fit/job.h"
#include "cmd/run/line.h"
#include "cmd/lang/parse.h"
#include "cmd/session/undo.h"
#include "tui/acts.h"
#include "tui/control.h"
#include "cli/ask.h"
#include "cli/signals.h"
#include "tui/captured.h"
#include "cli/history.h"
#include "tui/widgets/viewer.h"
#include "tui/watch.h"

/* Draws a picture of the screen as it stands, without stopping a search. */
static void
run_screen_command(struct tui *t, const char *line)
{
	struct error error = {0};
	size_t next;
	captured_discard_output(t);
	bool ok = session_run_line(
	    t->session, line, 0, ERROR_TYPED, 0, &next, &error);
	xfree_and_set(&t->command, xstrdup(line));
	t->failed = !ok;
	t->message[0] = '\0';
	if (ok)
		captured_show_output(t);
	else
		captured_show_error(t, &error, line, ERROR_TYPED);
}

/* Waits for Return, so that the user can read the output of a shell command. */
static void
wait_for_return_key(void)
{
	fputs(tr("\n"
		 "[Return: back]"),
	    stdout);
	fflush(stdout);
	/* ^C has ended the shell command. */
	signals_clear_interrupt();
	ask_wait_for_line(NULL);
	/* So that the shell's prompt has a line of its own after the screen. */
	fputs("\n", stdout);
}

/* Returns the value of feed= in a line, as typed, or NULL.  The caller frees
 * it. */
static char *
feed_option_value_in_line(const char *line)
{
	const char *feed = strstr(line, " feed=");
	if (feed == NULL)
		return NULL;
	feed += strlen(" feed=");
	return xstrndup(feed, feed[0] == '"' ? strcspn(feed + 1, "\"") + 2
					     : strcspn(feed, " ;>|"));
}

/* Returns true if page Predict shows all that a line asks for: the product of
 * the site at a speed, on the feed and the machine of the page. */
static bool
is_command_answered_by_page_predict(const char *line)
{
	static const char *const MORE[] = {
	    " rotor_mm=", " cascade=", " k=", " sieves=", " cut="};
	if (strncmp(line, "predict", 7) != 0 || strchr(line, '>') != NULL)
		return false;
	for (size_t i = 0; i < ARRAY_LEN(MORE); i++)
		if (strstr(line, MORE[i]) != NULL)
			return false;
	FREED char *feed = feed_option_value_in_line(line);
	double speed;
	return feed == NULL || value_parse_number(feed, "m/s", &speed);
}

/* What a line does to a running search.  A line that is not a command does
 * nothing. */
enum job_effect { JOB_GOES_ON, JOB_TAKES_BOUNDS, JOB_STOPS };

static enum job_effect
effect_of_command_on_job(
    const struct tui *t, const char *line, const struct command *command)
{
	if (!session_is_calibrating(t->session))
		return JOB_GOES_ON;
	if (command == NULL)
		return strchr(line, ';') == NULL ? JOB_GOES_ON : JOB_STOPS;
	bool bounds = command == command_find("bounds");
	bool asks = strpbrk(line + strspn(line, " \t"), " \t") == NULL;
	if (command->flags & COMMAND_DURING_SEARCH || (bounds && asks))
		return JOB_GOES_ON;
	return bounds ? JOB_TAKES_BOUNDS : JOB_STOPS;
}

/* Returns true for a question about the site that is being calibrated, which
 * has no final parameters yet. */
static bool
is_command_blocked_by_fit(const struct tui *t, const struct command *command)
{
	const struct entry *fitting = session_entry_being_fitted(t->session);
	return fitting != NULL && fitting == tui_current_site_entry(t) &&
	       command != NULL && command->answer != NULL &&
	       (command->flags & COMMAND_NEEDS_PARAMS) &&
	       !(command->flags & COMMAND_CHANGES);
}

/* Continues a search within its bounds, which the line may have edited.  A
 * search that had been stopped says so. */
static void
resume_fit_within_bounds(struct tui *t, bool edited)
{
	bool on = t->session->job.paused;
	if (control_run_command_captured(t, on ? "continue" : "calibrate") &&
	    on && edited)
		tui_set_message(t, false, "continues within the new bounds");
}

/* After an answer for another feed, says that the pages keep theirs. */
static void
report_that_pages_keep_feed(struct tui *t, const char *line)
{
	FREED char *feed = feed_option_value_in_line(line);
	if (feed != NULL && strchr(line, '>') == NULL &&
	    strcmp(feed, t->session->set.feed) != 0)
		tui_set_message(t, false,
		    "the pages keep their feed: :set feed %s makes them use "
		    "this one",
		    feed);
}

/* Shows the output of a line that was run.  A search that it began is shown by
 * the page instead. */
static void
show_output_of_line(struct tui *t, const struct command *command,
    const char *line, bool ok, bool began)
{
	bool moved_only = is_command_answered_by_page_predict(line);
	fflush(t->captured);
	/* Besides the error, the output may list the faults of a check or a
	 * sheet. */
	if (!ok && t->captured_n > 0)
		text_print_wrapped(
		    t->message, 0, session_text_width(t->session), t->captured);
	if (!began && (ok ? !moved_only : t->captured_n > 0))
		captured_show_output(t);
	if (ok && !moved_only && command == command_find("predict"))
		report_that_pages_keep_feed(t, line);
}

static void
run_typed_line(struct tui *t, const struct command *command, const char *line)
{
	if (line[strspn(line, " \t")] == '\0')
		return;
	struct session *s = t->session;
	const struct bounds before = s->set.bounds;
	const bool was_busy = session_is_calibrating(s);
	const char *stopped = "";
	bool searching = was_busy && !t->held;
	enum job_effect effect = effect_of_command_on_job(t, line, command);
	if (command == command_find("screen")) {
		run_screen_command(t, line);
		return;
	}
	if (effect != JOB_GOES_ON)
		stopped = tui_stop_fit(t);
	bool paused = s->job.paused;
	size_t steps = undo_count_steps(s);
	if (command == command_find("save"))
		control_store_page_settings(t);
	/* Only a shell command may write past the session's streams. */
	bool aside = strchr(line, '|') != NULL && !t->aside && !s->safe;
	if (aside)
		t->callbacks->leave(t);
	bool ok = control_run_command_captured(t, line);
	if (aside) {
		wait_for_return_key();
		t->callbacks->come_back(t);
	}
	bool edited = memcmp(&before, &s->set.bounds, sizeof before) != 0;
	if (searching && (effect == JOB_TAKES_BOUNDS || edited) &&
	    !session_is_calibrating(s)) {
		resume_fit_within_bounds(t, edited);
		return;
	}
	if (ok && edited)
		tui_set_message(t, false, "f calibrates within these bounds");
	bool beside = was_busy && effect == JOB_GOES_ON;
	show_output_of_line(
	    t, command, line, ok, session_is_calibrating(s) && !beside);
	/* The user may have wanted to undo a move of the slider. */
	if (command == command_find("undo") && undo_count_steps(s) < steps)
		tui_append_to_message(
		    t, tr("U brings it back (moves of the slider are not "
			  "undone)"));
	else if (effect == JOB_STOPS && !session_is_calibrating(s) &&
		 s->job.paused == paused)
		tui_append_to_message(t, stopped);
}

/* Returns true if a command answers for one speed: it takes speed=, and does
 * not draw, show data or change anything. */
static bool
is_command_for_one_speed(const struct command *command)
{
	const char *group = command_group_name(command);
	return command_option_index(command, "speed") < OPTIONS &&
	       strcmp(group, "pictures") != 0 && strcmp(group, "data") != 0 &&
	       !(command->flags & COMMAND_CHANGES);
}

/* Returns true if a line has a speed among its operands, as in "compare pinned
 * 72". */
static bool
has_speed_operand(const struct command *asked, const char *rest)
{
	bool named = false;
	char *copy = xstrndup(rest, strcspn(rest, ">|")), *save = NULL;
	double v;
	for (char *word = strtok_r(copy, " \t", &save); word != NULL;
	     word = strtok_r(NULL, " \t", &save))
		named |= value_parse_number(word, "m/s", &v) ||
			 value_parse_number(word, "rpm", &v);
	free(copy);
	return named && asked->operands.usage != NULL &&
	       strstr(asked->operands.usage, "SPEED") != NULL;
}

/* Returns a typed line.  If its command `asked` (or NULL) asks about one speed
 * and the line names none, adds the slider's speed and feed
 * (tui_speed_and_feed_options).  The caller frees it. */
static char *
line_with_slider_speed(
    const char *line, const struct command *asked, const char *where)
{
	const char *rest = line + strspn(line, " \t");
	rest += strcspn(rest, " \t>|");
	rest += strspn(rest, " \t");
	if (asked == NULL || !is_command_for_one_speed(asked))
		return xstrdup(line);
	/* A speed may also stand alone. */
	bool bare = asked->bare == NULL || strcmp(asked->bare, "speed") == 0;
	bool said = strstr(line, "speed=") != NULL ||
		    strstr(line, "rpm=") != NULL ||
		    (bare && *rest >= '0' && *rest <= '9') ||
		    has_speed_operand(asked, rest);
	bool own = strstr(line, "feed=") != NULL ||
		   command_option_index(asked, "feed") == OPTIONS;
	size_t length = own ? strcspn(where, " ") : strlen(where);
	if (!said)
		return xasprintf("%s %.*s%s%s", asked->name, (int)length, where,
		    *rest != '\0' ? " " : "", rest);
	return xstrdup(line);
}

void
cmdline_run_line(struct tui *t, const char *line)
{
	FREED char *where = tui_speed_and_feed_options(t);
	const struct command *command = control_command_of_line(line);
	FREED char *meant = line_with_slider_speed(line, command, where);
	if (!t->aside && line[strspn(line, " \t")] != '\0')
		typed_history_add(line);
	if (text_is_same_folded(line, "help keys"))
		act_list_keys(t, NULL);
	else if (is_command_blocked_by_fit(t, command))
		tui_set_message(t, false,
		    "%s answers when the calibration ends; s stops it and "
		    "keeps the best",
		    command->name);
	else
		run_typed_line(t, command, meant);
	t->keep_message = t->message[0] != '\0';
	viewer_show_long_message(t);
}
