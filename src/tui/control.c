/* Opens the full screen on a session, runs lines, and updates the screen
 * afterwards.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/control.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/lang/command.h"
#include "cmd/session/invocation.h"
#include "cmd/fit/job.h"
#include "cmd/run/line.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/quantity_words.h"
#include "core/psd/rotor_speed.h"
#include "tui/widgets/response_strip.h"
#include "tui/widgets/dialog.h"
#include "cli/driver.h"
#include "tui/folder.h"
#include "tui/pane.h"
#include "cli/ask.h"
#include "cli/signals.h"
#include "tui/captured.h"
#include "tui/view.h"
#include "tui/screen.h"
#include "tui/widgets/track.h"
#include "tui/script_progress.h"
#include "tui/widgets/viewer.h"

/* The hooks of a session and `screen` have no argument for it. */
static struct tui *open;

/* Runs a job to its end and draws its progress.  Signals are held on the
 * screen, and let in between two steps. */
static bool
run_job_to_end(struct session *s)
{
	while (session_is_calibrating(s) && signals_pending() == 0) {
		session_step_job(s);
		script_progress_draw(open);
		signals_deliver_blocked();
	}
	return signals_pending() == 0;
}

/* For hooks.stop: long commands ask during a line, and Esc is then looked
 * for.  The threads of a search ask too, but draw nothing, and so does a search
 * that goes on after the screen was closed. */
static bool
control_is_stop_wanted(void)
{
	if (open != NULL && !session_is_calibrating(open->session))
		script_progress_draw(open);
	return signals_is_stop_wanted();
}

const struct command *
control_command_of_line(const char *line)
{
	static const char ENDS[] = " \t>|";
	if (strchr(line, ';') != NULL)
		return NULL;
	line += strspn(line, " \t");
	size_t n = strcspn(line, ENDS), gap = strspn(line + n, " \t");
	FREED char *word = xstrndup(line, n);
	FREED char *both = xasprintf("%s %.*s", word,
	    (int)strcspn(line + n + gap, ENDS), line + n + gap);
	const struct command *command = command_find(both);
	if (command == NULL)
		command = command_find_abbreviated(word, true);
	return command;
}

void
control_refresh_screen(struct tui *t)
{
	const struct session *s = t->session;
	t->session->wants_tui = false;
	view_mark_changed(t);
	tui_clear_hits(t);
	if (t->ui.list[PAGE_SITES].at >= s->n_entry)
		t->ui.list[PAGE_SITES].at = s->current;
	if (t->ui.crosshair_sieve >= t->view.shown.product.n)
		t->ui.crosshair_sieve = 0;
	tui_show_generation(t, t->ui.generation);
}

/* Takes the page and the quantity from the settings. */
static void
apply_page_settings(struct tui *t)
{
	static const struct partition SHARP = {0, 1};
	const struct settings *set = &t->session->set;
	struct error error = {0};
	if (!quantities_parse_one(
		set->quantity, &SHARP, &t->ui.quantity, &error))
		t->ui.quantity = strip_default_quantity();
	t->ui.page = (enum page)set->page;
	tui_clear_hits(t);
}

/* Returns the page as a value of `set page`.  The caller frees it. */
static char *
page_setting_text(enum page page)
{
	const struct settings set = {.page = page};
	const struct command_option *row = SETTINGS;
	while (strcmp(row->name, "page") != 0)
		row++;
	return settings_value_text(row, &set);
}

void
control_store_page_settings(struct tui *t)
{
	struct session *s = t->session;
	struct error error = {0};
	size_t next;
	FREED char *page = page_setting_text(t->ui.page);
	FREED char *quantity = quantities_typed_text(&t->ui.quantity);
	FREED char *line =
	    xasprintf("set page %s quantity \"%s\"", page, quantity);
	captured_discard_output(t);
	if (s->set.page != t->ui.page || strcmp(s->set.quantity, quantity) != 0)
		session_run_line(s, line, 0, ERROR_TYPED, 0, &next, &error);
}

/* Returns true if the page or the quantity is another. */
static bool
differs_in_page_or_quantity(
    const struct settings *was, const struct settings *is)
{
	return was->page != is->page ||
	       strcmp(was->quantity, is->quantity) != 0;
}

/* Shows the job that a line has started. */
static void
show_job_begun(struct tui *t, const char *line)
{
	const struct command *command = control_command_of_line(line);
	const struct job *job = &t->session->job;
	t->job = command != NULL ? command->name : NULL;
	t->held = false;
	t->ui.generation = 0;
	t->due = t->started = t->clock;
	if (calibration_status(job->calibration).generation == 0)
		t->ran = 0;
	if (job->fits && !job->type->alone) {
		t->ui.page = PAGE_SITES;
		tui_clear_hits(t);
	}
}

void
control_say_speed_off_slider(struct tui *t, double speed)
{
	struct slider_range range = tui_slider_range(t);
	const bool in_rpm = range.rotor > 0;
	const double per_unit = in_rpm ? 1 : 10;
	double typed = answers_speed_number(tui_site(t), speed);
	FREED char *rpm = rotor_speed_rpm_text(tui_known_rotor(t), speed, NAN);
	tui_say(t, true,
	    in_rpm ? N_("%.1f m/s%s is off the slider: type :set slider "
			"%.0f..%.0frpm")
		   : N_("%.1f m/s%s is off the slider: type :set slider "
			"%.0f..%.0f"),
	    speed, rpm, fmin(floor(typed), range.least / per_unit),
	    fmax(ceil(typed), range.most / per_unit));
}

static void
move_slider_to_answer_speed(struct tui *t, const char *line, bool ok)
{
	struct slider_range range = tui_slider_range(t);
	double said =
	    session_answer_number(t->session, "predict find", "speed");
	const struct command *ran = control_command_of_line(line);
	bool asks =
	    ran == command_find("predict") || ran == command_find("find");
	if (slider_has_speed(range, said))
		tui_move_slider_to(t, said);
	else if (isfinite(said) && ok && asks)
		control_say_speed_off_slider(t, said);
	if (tui_current_entry(t) != NULL &&
	    !slider_has_speed(range, t->ui.speed))
		tui_move_slider_to(
		    t, answers_default_speed(tui_current_entry(t)));
}

static bool
control_run_line(struct tui *t, const char *line)
{
	struct session *s = t->session;
	const struct settings was = s->set;
	bool was_busy = session_is_calibrating(s);
	char site[sizeof t->view.current.site] = "";
	if (tui_current_entry(t) != NULL)
		snprintf(site, sizeof site, "%s", tui_current_entry(t)->key);
	captured_discard_output(t);
	const struct driver d = {.session = s,
	    .of = t,
	    .fail = captured_show_error,
	    .begins = script_progress_start_line,
	    .work = run_job_to_end,
	    .watches = true};
	script_progress_start_typed_line(t, line);
	/* A signal is no error: what was found before it stays. */
	bool ok = driver_run_line(&d, line, ERROR_TYPED, 0) == 0 ||
		  signals_pending() != 0;
	script_progress_end(
	    t, control_command_of_line(line) == command_find("restore"), ok);
	move_slider_to_answer_speed(t, line, ok);
	bool other = tui_current_entry(t) != NULL &&
		     strcmp(site, tui_current_entry(t)->key);
	if (other) {
		t->ui.list[PAGE_SITES].at = s->current;
		t->ui.feed = 0;
	}
	if (differs_in_page_or_quantity(&was, &s->set) &&
	    strcmp(line, "undo") != 0 && strcmp(line, "redo") != 0)
		apply_page_settings(t);
	tui_set_feed_from_answer(t);
	if (strcmp(s->set.feed, was.feed) != 0)
		tui_set_feed_from_setting(t);
	control_refresh_screen(t);
	if (session_is_calibrating(s) && !was_busy)
		show_job_begun(t, line);
	return ok;
}

bool
control_run_and_show(struct tui *t, const char *line)
{
	free(t->command);
	t->command = xstrdup(line);
	t->message[0] = '\0';
	bool ok = control_run_line(t, line);
	t->failed = !ok;
	if (!ok)
		viewer_show_long_message(t);
	return ok;
}

struct tui *
control_current_screen(void)
{
	return open;
}

/* Frees all that a state owns. */
static void
free_tui_state(struct tui *t)
{
	if (t->captured != NULL)
		fclose(t->captured);
	free(t->captured_text);
	edit_end(&t->line);
	viewer_close(t);
	free(t->closed);
	free(t->command);
	folder_free(&t->picker.folder);
	free(t->picker.preview);
	view_free(t);
	hits_free(&t->hits);
}

static bool
control_confirm(struct session *s, const char *question, bool yes)
{
	int code = 0;
	bool special = false;
	if (open->away)
		return ask_confirm(s, question, yes);
	open->question = question;
	bool got = open->callbacks->answer(open, &code, &special);
	open->question = NULL;
	return got && !special && (code == 'y' || code == 'Y');
}

static char *
control_ask_question(struct session *s, const struct user_question *q)
{
	return open->away ? ask_question(s, q) : dialog_ask(open, q);
}

/* For hooks.announce: draws page Fit before the draws are computed with which a
 * search ends. */
static void
show_fit_page_before_draws(const char *what)
{
	if (open->callbacks->show == NULL || open->ui.page != PAGE_FIT ||
	    !session_is_calibrating(open->session) || open->computing != NULL)
		return;
	open->computing = what;
	open->callbacks->show(open);
	open->computing = NULL;
}

/* Returns the speed last asked about or, if the slider cannot show it, the
 * usual speed of the site. */
static double
first_slider_speed(const struct tui *t)
{
	const double usual = 74;
	const struct entry *e = tui_current_entry(t);
	if (slider_has_speed(tui_slider_range(t), t->session->last_asked.speed))
		return t->session->last_asked.speed;
	return e != NULL ? answers_default_speed(e) : usual;
}

void
control_open_screen(
    struct tui *t, struct session *s, const struct tui_callbacks *callbacks)
{
	*t = (struct tui){.session = s,
	    .callbacks = callbacks,
	    .aside = callbacks->leave == NULL,
	    .ui = {.list[PAGE_SITES].at = s->current,
		.pace = PACE_AUTO,
		.picture = PLOT_SEARCH,
		.crosshair_passing = 50},
	    .mouse = screen_set_mouse(true),
	    .view.holdout = NAN,
	    .before = {s->out, s->notes, s->hooks, s->prompt, s->typed_depth,
		s->screen}};
	tui_move_slider_to(t, first_slider_speed(t));
	s->hooks.confirm = control_confirm;
	s->hooks.ask = control_ask_question;
	s->prompt = true;
	s->typed_depth = s->scripts;
	s->hooks.show_manual_page = NULL;
	s->hooks.announce = show_fit_page_before_draws;
	s->hooks.stop = control_is_stop_wanted;
	s->hooks.run_screen = NULL;
	tui_set_feed_from_answer(t);
	t->captured = text_open_memory(&t->captured_text, &t->captured_n);
	s->out = s->notes = t->captured;
	apply_page_settings(t);
	control_refresh_screen(t);
	open = t;
}

void
control_close_screen(struct tui *t)
{
	struct session *s = t->session;
	struct error error = {0};
	if (!t->aside)
		control_store_page_settings(t);
	open = NULL;
	s->out = t->before.out;
	s->notes = t->before.notes;
	s->hooks = t->before.hooks;
	s->prompt = t->before.prompt;
	s->typed_depth = t->before.typed_at;
	s->screen = t->before.screen;
	if (session_is_calibrating(s)) {
		session_stop_job_for_user(s);
		session_end_finished_commands(s, true, &error);
	}
	free_tui_state(t);
}
