/* The driver of the full screen: lines, scripts, jobs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/control.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/command.h"
#include "cmd/fit.h"
#include "cmd/light.h"
#include "cmd/fit.h"
#include "cmd/light.h"
#include "cmd/job.h"
#include "cmd/line.h"
#include "cmd/predict.h"
#include "cmd/script.h"
#include "cmd/invocation.h"
#include "ui/dialogue.h"
#include "ui/driver.h"
#include "ui/pump.h"
#include "ui/screen.h"
#include "ui/typed.h"
#include "ui/view.h"

/* session->hooks.confirm and `screen` have no argument to pass it by. */
static struct tui *open;

/* A slider that stood still for so long has paused, s. */
static const double PAUSE = 0.7;

/* Forgets what was said before; what is said next is for this screen, which
 * has no use for escapes. */
static void
hush(struct tui *t)
{
	struct screen screen = {.drawing = screen_charset() != CHARSET_ASCII};
	screen_size(&screen.rows, &screen.columns);
	t->session->screen = screen;
	rewind(t->said);
	fflush(t->said);
}

/* See struct driver: the line itself stands on the screen. */
static void
say_error(void *t, const struct error *e, const char *line, const char *name)
{
	char place[sizeof e->file + 32] = "";
	(void)line, (void)name;
	if (e->line > 0)
		snprintf(place, sizeof place, "%s:%d:%d: ", e->file, e->line,
		    e->column);
	tui_say(t, true, "%s%s%s%s", place, e->text,
	    e->hint[0] != '\0' ? ": " : "", e->hint);
}

/* No progress but that of the page. */
static bool
work(struct session *s)
{
	while (session_busy(s) && pump_signal() == 0)
		session_step(s);
	return pump_signal() == 0;
}

static void
take_numbers(struct tui *t)
{
	static const double sizes[NUMBERS_FRACTIONS] = {0.063e-3, 2e-3, 4e-3};
	const struct entry *entry = tui_entry(t);
	t->now = (struct numbers){0};
	if (entry == NULL || t->shown.product.n == 0)
		return;
	snprintf(t->now.site, sizeof t->now.site, "%s", entry->key);
	t->now.speed = t->shown.speed;
	for (size_t i = 0; i < 3; i++)
		t->now.size[i] = answers_size(&t->shown, i);
	t->now.break_mm = answers_size(&t->shown, ANSWERS_BREAK);
	for (size_t i = 0; i < NUMBERS_FRACTIONS; i++)
		t->now.passing[i] =
		    psd_covers(&t->shown.product, sizes[i])
			? 100 * psd_passing(&t->shown.product, sizes[i])
			: NAN;
}

static void
forget(struct tui *t)
{
	prediction_free(&t->shown);
	t->shown = (struct prediction){0};
	t->now = (struct numbers){0};
	t->asked.tenths = 0;
}

/* What the session is like after any command. */
void
control_look(struct tui *t)
{
	const struct session *s = t->session;
	const struct entry *entry = tui_entry(t);
	t->session->wants_tui = false;
	t->rows_at = 0;
	if (isnan(session_known(s, "predict", "speed")))
		forget(t);
	if (t->site_at >= s->n_entry)
		t->site_at = s->current;
	if (t->cross_at >= t->shown.product.n)
		t->cross_at = 0;
	t->holdout = entry != NULL && entry->has_fit
			 ? 100 * fit_holdout_rmse(entry)
			 : NAN;
	tui_look_at(t, t->generation);
}

static bool
run(struct tui *t, const char *line)
{
	struct session *s = t->session;
	bool was_busy = session_busy(s);
	char site[sizeof t->now.site] = "";
	if (tui_entry(t) != NULL)
		snprintf(site, sizeof site, "%s", tui_entry(t)->key);
	hush(t);
	const struct driver d = {.session = s,
	    .of = t,
	    .fail = say_error,
	    .work = work,
	    .watches = true};
	/* A signal is no error: what was found before it stays. */
	bool ok = driver_line(&d, line, "typed", 0) == 0 || pump_signal() != 0;
	struct slider_range range = tui_range(t);
	double said = session_known(s, "predict find", "speed");
	if (slider_has(range, said))
		t->tenths = slider_tenths(range, said);
	if (tui_entry(t) != NULL && !slider_has(range, t->tenths / 10.0))
		t->tenths = slider_tenths(range, answers_usual(tui_entry(t)));
	bool other = tui_entry(t) != NULL && strcmp(site, tui_entry(t)->key);
	if (other) {
		t->asked.tenths = 0;
		t->site_at = s->current;
		t->feed = 0;
	}
	tui_keep_feed(t);
	control_look(t);
	if (session_busy(s) && !was_busy) {
		t->held = false;
		t->generation = 0;
		t->due = t->started = t->clock;
		if (calibration_status(s->job.calibration).generation == 0)
			t->ran = 0;
	}
	return ok;
}

bool
control_run(struct tui *t, const char *line)
{
	free(t->command);
	t->command = xstrdup(line);
	t->message[0] = '\0';
	bool ok = run(t, line);
	if (!ok)
		view_message(t);
	return ok;
}

/* One line is a message, more are shown on the whole screen. */
static void
show_said(struct tui *t)
{
	fflush(t->said);
	size_t n = t->said_n;
	while (n > 0 && t->said_text[n - 1] == '\n')
		n--;
	char *text = xstrndup(t->said_text, n);
	if (strchr(text, '\n') != NULL) {
		view_text(t, text);
		return;
	}
	if (n > 0)
		tui_say(t, false, "%s", text);
	free(text);
}

/* Whether a line asks for a picture of the screen. */
static bool
is_screen(const char *line)
{
	char word[16];
	size_t at = strspn(line, " \t"), n = strcspn(line + at, " \t>;|");
	if (strchr(line, ';') != NULL || n == 0 || n >= sizeof word)
		return false;
	memcpy(word, line + at, n);
	word[n] = '\0';
	return command_called(word, true) == command_find("screen");
}

/* Stops no search, and the screen stays as it stands until it is drawn. */
static void
draw_screen(struct tui *t, const char *line)
{
	struct error error = {0};
	size_t next;
	hush(t);
	bool ok = session_line(t->session, line, 0, "typed", 0, &next, &error);
	free(t->command);
	t->command = xstrdup(line);
	t->message[0] = '\0';
	if (ok)
		show_said(t);
	else
		say_error(t, &error, line, "typed");
}

/* What a shell command wrote stays until it is read. */
static void
await_return(void)
{
	fputs("\n"
	      "[Return: back]",
	    stdout);
	fflush(stdout);
	/* ^C has ended the shell command. */
	pump_forget_interrupt();
	pump_answer(NULL);
}

static void
run_typed(struct tui *t, const char *line)
{
	if (line[strspn(line, " \t")] == '\0')
		return;
	struct session *s = t->session;
	const struct bounds before = s->set.bounds;
	bool searching = session_busy(s) && !t->held;
	if (is_screen(line)) {
		draw_screen(t, line);
		return;
	}
	control_keep(t);
	/* Only a shell command may write past the session's streams. */
	bool aside = strchr(line, '|') != NULL && !t->aside && !s->safe;
	if (aside)
		t->ways->leave();
	bool ok = control_run(t, line);
	if (aside) {
		await_return();
		t->ways->come_back();
	}
	/* Bounds edited in a search: on within them. Where it was paused the
	 * user says when. */
	if (searching && memcmp(&before, &s->set.bounds, sizeof before) != 0 &&
	    !session_busy(s)) {
		bool on = s->job.paused;
		if (control_run(t, on ? "continue" : "calibrate") && on)
			tui_say(t, false, "continues within the new bounds");
		return;
	}
	if (ok && memcmp(&before, &s->set.bounds, sizeof before) != 0)
		tui_say(t, false, "f calibrates within these bounds");
	bool moved_only =
	    strncmp(line, "predict", 7) == 0 && strchr(line, '>') == NULL;
	fflush(t->said);
	/* What a check found, the other faults of a sheet. */
	if (!ok && t->said_n > 0)
		text_wrap(t->message, 0, 78, t->said);
	if (!session_busy(s) && (ok ? !moved_only : t->said_n > 0))
		show_said(t);
}

/* What a typed line means with the slider somewhere, see tui_where.  A question
 * about one speed is about that of the slider, where it is asked of no other:
 * "spec FILE" gets it.  The caller frees. */
static char *
meant_by(const char *line, const char *where)
{
	static const char *const ASK[] = {"predict", "spec", "guess", "why"};
	size_t from = strspn(line, " \t"), n = strcspn(line + from, " \t>|");
	const char *word = line + from, *rest = word + n;
	rest += strspn(rest, " \t");
	/* A speed may also stand alone. */
	bool said = strchr(line, ';') != NULL ||
		    strstr(line, "speed=") != NULL ||
		    (*rest >= '0' && *rest <= '9');
	size_t length =
	    strstr(line, "feed=") != NULL ? strcspn(where, " ") : strlen(where);
	for (size_t i = 0; !said && i < ARRAY_LEN(ASK); i++)
		if (strlen(ASK[i]) == n && strncmp(word, ASK[i], n) == 0)
			return xasprintf("%s %.*s%s%s", ASK[i], (int)length,
			    where, *rest != '\0' ? " " : "", rest);
	return xstrdup(line);
}

void
control_typed(struct tui *t, const char *line)
{
	char *where = tui_where(t);
	char *meant = meant_by(line, where);
	if (!t->aside && line[strspn(line, " \t")] != '\0')
		typed_add(line);
	run_typed(t, meant);
	t->told = t->message[0] != '\0';
	view_message(t);
	free(where);
	free(meant);
}

void
control_predict(struct tui *t)
{
	struct session *s = t->session;
	const struct entry *entry = tui_entry(t);
	bool told = t->told;
	t->told = false;
	bool forming = entry != NULL && session_busy(s) &&
		       s->job.entry == s->current &&
		       calibration_status(s->job.calibration).generation > 0;
	if (entry == NULL || (!entry->has_params && !forming))
		return;
	bool first = t->asked.tenths == 0;
	if (t->asked.tenths == t->tenths && t->asked.feed_run == tui_feed(t))
		return;
	if (t->clock - t->moved > PAUSE || t->pause.site[0] == '\0' ||
	    strcmp(t->pause.site, entry->key) != 0)
		t->pause = t->now;
	if (!first)
		t->moved = t->clock;
	char *where = tui_where(t);
	char *line = xasprintf("predict %s", where);
	struct error error = {0};
	prediction_free(&t->shown);
	t->shown = (struct prediction){0};
	if (!predict_step(
		s, t->tenths / 10.0, tui_feed(t), line, &t->shown, &error))
		say_error(t, &error, line, "typed");
	if ((!first && !told) || t->command == NULL) {
		free(t->command);
		t->command = xstrdup(line);
	}
	if (!first && !told)
		t->message[0] = '\0';
	tui_keep_feed(t);
	t->asked.tenths = t->tenths;
	t->asked.feed_run = tui_feed(t);
	take_numbers(t);
	free(where);
	free(line);
}

void
control_keep(struct tui *t)
{
	struct session *s = t->session;
	if (!session_busy(s))
		return;
	struct error error = {0};
	session_pause(s);
	session_settle(s, true, &error);
	t->ran = tui_searched(t);
	t->held = false;
	t->asked.tenths = 0;
	control_look(t);
	tui_say(t, false,
	    "stopped, the best is kept: Space continues, f starts again, both "
	    "within the current bounds; u undoes it");
}

/* The calibration has come to its end. */
static void
finish(struct tui *t)
{
	struct error error = {0};
	if (!session_settle(t->session, true, &error))
		say_error(t, &error, "", "");
	t->held = false;
	control_look(t);
	const struct entry *entry = tui_entry(t);
	if (entry != NULL && entry->has_fit && error.kind == ERROR_NONE)
		tui_say(t, false,
		    "calibrated: %s, RMSE %.2f points, %zu generations%s",
		    light_verdict(t->session, entry, NULL),
		    100 * entry->fit.rmse, entry->fit.generations,
		    t->page == PAGE_FIT ? "; Tab, arrows: show them" : "");
}

void
control_pump(struct tui *t)
{
	static const double FRAME = 0.02; /* s, at full pace */
	struct session *s = t->session;
	if (!session_busy(s) || t->held)
		return;
	double began = session_clock();
	if (t->pace < PACE_FULL && t->clock < t->due)
		return;
	do
		session_step(s);
	while (session_busy(s) && t->pace == PACE_FULL && pump_signal() == 0 &&
	       (t->aside ||
		   (!pump_waited_for() && session_clock() - began < FRAME)));
	if (t->pace < PACE_FULL)
		t->due = t->clock + 1 / PACES[t->pace];
	t->asked.tenths = 0;
	if (!session_busy(s))
		finish(t);
}

const struct tui *
control_open(void)
{
	return open;
}

static bool
confirm(struct session *s, const char *question)
{
	int code = 0;
	bool special = false;
	if (open->ways->is_away != NULL && open->ways->is_away())
		return pump_confirm(s, question);
	open->question = question;
	bool got = open->ways->answer(open, &code, &special);
	open->question = NULL;
	return got && !special && (code == 'y' || code == 'Y');
}

static char *
question(struct session *s, const struct inquiry *q)
{
	bool away = open->ways->is_away != NULL && open->ways->is_away();
	return away ? pump_question(s, q) : dialogue_ask(open, q);
}

/* The speed last predicted, else the usual one of the site. */
static int
first_speed(const struct session *s)
{
	double speed = session_known(s, "predict find", "speed");
	const struct entry *e = s->n_entry > 0 ? &s->entry[s->current] : NULL;
	struct slider_range range = slider_range(e != NULL ? e->site : NULL);
	if (slider_has(range, speed))
		return slider_tenths(range, speed);
	return e != NULL ? slider_tenths(range, answers_usual(e)) : 740;
}

void
control_begin(struct tui *t, struct session *s, const struct tui_ways *ways)
{
	enum { PACE = 4 };
	*t = (struct tui){.session = s,
	    .ways = ways,
	    .aside = ways->leave == NULL,
	    .tenths = first_speed(s),
	    .site_at = s->current,
	    .mouse = screen_mouse(true),
	    .pace = PACE,
	    .picture = PLOT_PSD,
	    .level = 50,
	    .holdout = NAN,
	    .before = {
		s->out, s->notes, s->hooks, s->prompt, s->typed_at, s->screen}};
	s->hooks.confirm = confirm;
	s->hooks.question = question;
	s->prompt = true;
	s->typed_at = s->scripts;
	s->hooks.show_page = NULL;
	s->hooks.run_screen = NULL;
	tui_keep_feed(t);
	t->said = text_memory(&t->said_text, &t->said_n);
	s->out = s->notes = t->said;
	control_look(t);
	open = t;
}

void
control_end(struct tui *t)
{
	struct session *s = t->session;
	open = NULL;
	s->out = t->before.out;
	s->notes = t->before.notes;
	s->hooks = t->before.hooks;
	s->prompt = t->before.prompt;
	s->typed_at = t->before.typed_at;
	s->screen = t->before.screen;
	control_keep(t);
	fclose(t->said);
	free(t->said_text);
	typing_end(&t->typing);
	view_close(t);
	prediction_free(&t->shown);
	free(t->command);
	prediction_free(&t->kept);
	free(t->row);
}
