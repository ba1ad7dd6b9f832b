/* Opens the full screen on a session and runs lines.  While a line runs, shows
 * it over the page, at most ten times a second, so that Esc can interrupt it;
 * updates the screen afterwards.
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
#include "cmd/lang/parse.h"
#include "cmd/session/invocation.h"
#include "cmd/session/screen_pages.h"
#include "cmd/session/script.h"
#include "cmd/fit/job.h"
#include "cmd/run/line.h"
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
#include "tui/widgets/viewer.h"

#define PAGE_NAME(NUMBER, name, heading, key) #name,

/* The screen that is open, or NULL.  Static because neither the session's hooks
 * nor `screen` can be passed it. */
static struct tui *open;

/* Returns the line being run, "4 of 15: validate", with the state of its
 * search.  The caller frees it. */
static char *
running_line_progress_text(const struct tui *t)
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

/* Shows the running line instead of the page: during a script no page can be
 * drawn, because each command may change what the page shows. */
static void
draw_progress_if_due(struct tui *t, bool begins)
{
	/* s; a line that ends earlier is not shown */
	const double often = 0.1, patience = t->of_script ? often : 0.3;
	double now = session_clock_seconds();
	if (t->running_line == NULL || t->callbacks->stopped == NULL ||
	    now - t->ran_from < patience ||
	    (!begins && now - t->drawn_at < often) || t->away)
		return;
	viewer_show_text(t, running_line_progress_text(t));
	t->callbacks->show(t);
	viewer_close(t);
	t->drawn_at = now;
	if (t->callbacks->stopped(t)) {
		t->stopping = true;
		raise(SIGINT);
		signals_deliver_blocked();
	}
}

/* For struct driver: records and shows a line of a script before it is run. */
static void
record_and_show_script_line(void *of, const char *line)
{
	struct tui *t = of;
	struct script_place at = script_command_position(t->session);
	if (!t->of_script)
		t->ran_from = session_clock_seconds();
	t->of_script = true;
	xfree_and_set(&t->running_line,
	    at.of > 0 ? xasprintf(tr("%zu of %zu: %s"), at.at, at.of, line)
		      : xstrdup(line));
	draw_progress_if_due(t, true);
}

/* Clears what was drawn and says how the line or script has ended. */
static void
report_how_command_ended(struct tui *t, bool restores, bool ok)
{
	bool drawn = t->of_script || t->drawn_at >= t->ran_from;
	if (drawn)
		viewer_close(t);
	/* A signal from elsewhere ends the program, unless a script runs. */
	if ((t->of_script || t->stopping) &&
	    signals_get_ending_or_interrupt() == SIGINT) {
		signals_clear_interrupt();
		captured_discard_output(t);
		if (t->of_script)
			tui_set_message(t, false,
			    "stopped at %s: earlier changes stay; u undoes "
			    "them",
			    t->running_line);
		else
			tui_set_message(
			    t, false, "stopped: %s", t->running_line);
	} else if (ok && t->of_script) {
		const struct entry *entry = tui_current_site_entry(t);
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
		tui_set_message(t, false, "%s: %s",
		    restores ? tr("restored") : tr("the script has run"),
		    words);
	}
	t->keep_message = t->keep_message || drawn;
	xfree_and_set(&t->running_line, NULL);
}

/* Runs a job to its end and draws its progress.  On the screen signals are
 * blocked; here they are let in between two steps. */
static bool
run_job_to_end(struct session *s)
{
	while (session_is_calibrating(s) &&
	       signals_get_ending_or_interrupt() == 0) {
		session_step_job(s);
		draw_progress_if_due(open, false);
		signals_deliver_blocked();
	}
	return signals_get_ending_or_interrupt() == 0;
}

/* For hooks.stop: long commands call this, which then looks for Esc.  The
 * threads of a search call it too, but then nothing is drawn, nor for a search
 * that goes on after the screen was closed. */
static bool
control_is_stop_wanted(void)
{
	if (open != NULL && !session_is_calibrating(open->session))
		draw_progress_if_due(open, false);
	return signals_is_stop_wanted();
}

const struct command *
control_command_of_line(const char *line)
{
	const struct place place = {.file = ERROR_TYPED, .prompt = true};
	struct words words;
	struct error error = {0};
	words_split_line(line, 0, place, &words, &error);
	const struct command *command =
	    strchr(line, ';') == NULL ? words.command : NULL;
	words_free(&words);
	return command;
}

void
control_discard_outdated_state(struct tui *t)
{
	const struct session *s = t->session;
	t->session->wants_tui = false;
	view_discard_outdated(t);
	tui_clear_click_areas(t);
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
	const struct settings *set = &t->session->set;
	struct error error = {0};
	if (!quantities_parse_one(
		set->quantity, &PARTITION_IDEAL, &t->ui.quantity, &error))
		t->ui.quantity = response_strip_default_quantity();
	t->ui.page = (enum page)set->page;
	tui_clear_click_areas(t);
}

void
control_store_page_settings(struct tui *t)
{
	struct session *s = t->session;
	struct error error = {0};
	size_t next;
	static const char *const PAGE[] = {SCREEN_PAGES(PAGE_NAME)};
	FREED char *quantity = quantities_text_to_type(&t->ui.quantity);
	FREED char *line = xasprintf(
	    "set page %s quantity \"%s\"", PAGE[t->ui.page], quantity);
	captured_discard_output(t);
	if (s->set.page != t->ui.page || strcmp(s->set.quantity, quantity) != 0)
		session_run_line(s, line, 0, ERROR_TYPED, 0, &next, &error);
}

/* Shows the job that a line has started. */
static void
reset_view_for_new_job(struct tui *t, const char *line)
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
		tui_clear_click_areas(t);
	}
}

void
control_report_speed_off_slider(struct tui *t, double speed)
{
	struct slider_range range = tui_slider_range(t);
	const bool in_rpm = range.rotor > 0;
	const double per_unit = in_rpm ? 1 : 10;
	double typed = answers_speed_in_sheet_unit(tui_current_site(t), speed);
	FREED char *rpm =
	    rotor_speed_rpm_text(tui_rotor_diameter(t), speed, NAN);
	tui_set_message(t, true,
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
	    session_number_in_last_answer(t->session, "predict find", "speed");
	const struct command *ran = control_command_of_line(line);
	bool asks =
	    ran == command_find("predict") || ran == command_find("find");
	if (slider_has_speed(range, said))
		tui_set_slider_speed(t, said);
	else if (isfinite(said) && ok && asks)
		control_report_speed_off_slider(t, said);
	if (tui_current_site_entry(t) != NULL &&
	    !slider_has_speed(range, t->ui.speed))
		tui_set_slider_speed(
		    t, answers_default_speed(tui_current_site_entry(t)));
}

static bool
run_line_capturing_output(struct tui *t, const char *line)
{
	struct session *s = t->session;
	const struct settings was = s->set;
	bool was_busy = session_is_calibrating(s);
	char site[sizeof t->view.current.site] = "";
	if (tui_current_site_entry(t) != NULL)
		snprintf(
		    site, sizeof site, "%s", tui_current_site_entry(t)->key);
	captured_discard_output(t);
	const struct driver d = {.session = s,
	    .of = t,
	    .fail = captured_show_error,
	    .begins = record_and_show_script_line,
	    .work = run_job_to_end,
	    .watches = true};
	t->ran_from = session_clock_seconds();
	t->running_line = xstrdup(line);
	t->of_script = t->stopping = false;
	/* A signal is not an error: results found before it are kept. */
	bool ok = driver_run_line_to_end(&d, line, ERROR_TYPED, 0) == 0 ||
		  signals_get_ending_or_interrupt() != 0;
	report_how_command_ended(
	    t, control_command_of_line(line) == command_find("restore"), ok);
	move_slider_to_answer_speed(t, line, ok);
	bool other = tui_current_site_entry(t) != NULL &&
		     strcmp(site, tui_current_site_entry(t)->key);
	if (other) {
		t->ui.list[PAGE_SITES].at = s->current;
		t->ui.feed = 0;
	}
	if ((was.page != s->set.page ||
		strcmp(was.quantity, s->set.quantity) != 0) &&
	    strcmp(line, "undo") != 0 && strcmp(line, "redo") != 0)
		apply_page_settings(t);
	tui_set_feed_from_answer(t);
	if (strcmp(s->set.feed, was.feed) != 0)
		tui_set_feed_from_setting(t);
	control_discard_outdated_state(t);
	if (session_is_calibrating(s) && !was_busy)
		reset_view_for_new_job(t, line);
	return ok;
}

bool
control_run_command_captured(struct tui *t, const char *line)
{
	xfree_and_set(&t->command, xstrdup(line));
	t->message[0] = '\0';
	t->failed = false;
	bool ok = run_line_capturing_output(t, line);
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

static void
free_tui_state(struct tui *t)
{
	if (t->captured != NULL)
		fclose(t->captured);
	free(t->captured_text);
	edit_stop_editing(&t->line);
	viewer_close(t);
	free(t->closed);
	free(t->command);
	folder_free(&t->picker.folder);
	free(t->picker.preview);
	view_free(t);
	hits_free(&t->hits);
}

static bool
control_ask_to_confirm(struct session *s, const char *question, bool yes)
{
	int code = 0;
	bool special = false;
	if (open->away)
		return ask_confirm(s, question, yes);
	open->question = question;
	bool got = open->callbacks->answer(open, &code, &special);
	open->question = NULL;
	return got && !special && code < 128 &&
	       tr_is_yes((char[]){(char)code, '\0'});
}

static char *
control_ask_question(struct session *s, const struct user_question *q)
{
	return open->away ? ask_question(s, q) : dialog_ask(open, q);
}

/* For hooks.announce: draws page Fit before the draws at the end of a search
 * are computed. */
static void
show_fit_page_before_sampling(const char *what)
{
	if (open->callbacks->show == NULL || open->ui.page != PAGE_FIT ||
	    !session_is_calibrating(open->session) || open->computing != NULL)
		return;
	open->computing = what;
	open->callbacks->show(open);
	open->computing = NULL;
}

/* Returns the speed last asked about or, if that is off the slider, the usual
 * speed of the site. */
static double
initial_slider_speed(const struct tui *t)
{
	const double usual = 74;
	const struct entry *e = tui_current_site_entry(t);
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
	tui_set_slider_speed(t, initial_slider_speed(t));
	s->hooks.confirm = control_ask_to_confirm;
	s->hooks.ask = control_ask_question;
	s->prompt = true;
	s->typed_depth = s->scripts;
	s->hooks.show_manual_page = NULL;
	s->hooks.announce = show_fit_page_before_sampling;
	s->hooks.stop = control_is_stop_wanted;
	s->hooks.run_screen = NULL;
	tui_set_feed_from_answer(t);
	t->captured = text_open_memory(&t->captured_text, &t->captured_n);
	s->out = s->notes = t->captured;
	apply_page_settings(t);
	control_discard_outdated_state(t);
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
