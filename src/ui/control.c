/* The driver of the full screen: lines, scripts, jobs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/control.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/command.h"
#include "cmd/fit.h"
#include "cmd/light.h"
#include "cmd/job.h"
#include "cmd/line.h"
#include "cmd/parse.h"
#include "cmd/pin.h"
#include "cmd/predict.h"
#include "cmd/quantities.h"
#include "cmd/script.h"
#include "cmd/invocation.h"
#include "ui/above.h"
#include "ui/dialogue.h"
#include "ui/driver.h"
#include "ui/folder.h"
#include "ui/limits.h"
#include "ui/pane.h"
#include "ui/pump.h"
#include "ui/screen.h"
#include "ui/second.h"
#include "ui/track.h"
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

/* "4 of 15: validate", and what a search of it is at; the caller frees. */
static char *
under_way_words(const struct tui *t)
{
	const struct session *s = t->session;
	char *words = xasprintf("%s  %s", tr("WORKING"), t->under_way);
	if (session_busy(s) && !s->job.fits) {
		char *at = s->job.rounds->at(s);
		xappend(&words, "\n%s", at);
		free(at);
	}
	if (session_busy(s)) {
		xlist(&words, "\n", tr("generation %zu of %zu"),
		    calibration_status(s->job.calibration).generation,
		    s->job.options.generations);
	}
	return words;
}

/* In the midst of a script no page can be drawn: what it would show changes
 * with every command. */
static void
draw_under_way(struct tui *t, bool begins)
{
	const double often = 0.1; /* s; what is over by then is not shown */
	double now = session_clock();
	if (t->under_way == NULL || t->ways->stopped == NULL ||
	    now - t->ran_from < often ||
	    (!begins && now - t->drawn_at < often) || t->ways->is_away())
		return;
	view_text(t, under_way_words(t));
	t->ways->show(t);
	view_close(t);
	t->drawn_at = now;
	if (t->ways->stopped(t)) {
		raise(SIGINT);
		pump_let_in();
	}
}

/* See struct driver: the line after which somebody looks for Esc again. */
static void
begins_line(void *of, const char *line)
{
	struct tui *t = of;
	struct script_place at = script_place(t->session);
	if (t->under_way == NULL)
		t->ran_from = session_clock();
	free(t->under_way);
	t->under_way = at.of > 0
			   ? xasprintf(tr("%zu of %zu: %s"), at.at, at.of, line)
			   : xstrdup(line);
	draw_under_way(t, true);
}

/* No progress but that. */
static bool
work(struct session *s)
{
	while (session_busy(s) && pump_signal() == 0) {
		session_step(s);
		draw_under_way(open, false);
	}
	return pump_signal() == 0;
}

/* The command of a line; NULL where it has several, or none of that name. */
static const struct command *
command_of(const char *line)
{
	size_t at = strspn(line, " \t"), n = strcspn(line + at, " \t>|");
	if (strchr(line, ';') != NULL)
		return NULL;
	char *word = xstrndup(line + at, n);
	const struct command *command = command_called(word, true);
	free(word);
	return command;
}

/* What is left to say of a script at its end: of one that was stopped, and of a
 * session that is there again. */
static void
end_under_way(struct tui *t, bool restores, bool ok)
{
	if (t->under_way == NULL)
		return;
	view_close(t);
	if (pump_signal() == SIGINT) {
		pump_forget_interrupt();
		hush(t);
		tui_say(t, false,
		    "stopped at %s: what was done before stays, u undoes it",
		    t->under_way);
	} else if (ok) {
		const struct entry *entry = tui_entry(t);
		const size_t n = t->session->n_entry;
		if (restores)
			hush(t);
		char *words =
		    entry == NULL
			? xstrdup(tr("no site is loaded"))
			: xasprintf(
			      tr_n("%zu site is loaded, %s is in use",
				  "%zu sites are loaded, %s is in use", n),
			      n, entry->key);
		tui_say(t, false, "%s: %s",
		    restores ? tr("restored") : tr("the script has run"),
		    words);
		free(words);
	}
	t->told = true;
	free(t->under_way);
	t->under_way = NULL;
}

/* Of the site with that key. */
static struct numbers
numbers_of(const struct session *s, const char *key, const struct prediction *p)
{
	static const double sizes[NUMBERS_FRACTIONS] = {0.063e-3, 2e-3, 4e-3};
	struct numbers n = {.speed = p->speed};
	if (p->product.n == 0)
		return n;
	snprintf(n.site, sizeof n.site, "%s", key);
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct site *site = s->entry[i].site;
		if (strcmp(s->entry[i].key, key) == 0 &&
		    p->feed_run < site->n_run &&
		    answers_sampled(site, p->feed_run))
			n.feed = site->run[p->feed_run].speed;
	}
	for (size_t i = 0; i < 3; i++)
		n.size[i] = answers_size(p, i);
	n.break_mm = answers_size(p, ANSWERS_BREAK);
	for (size_t i = 0; i < NUMBERS_FRACTIONS; i++)
		n.passing[i] = psd_covers(&p->product, sizes[i])
				   ? 100 * psd_passing(&p->product, sizes[i])
				   : NAN;
	return n;
}

/* What the session has pinned. */
static void
look_at_pin(struct tui *t)
{
	const struct pin *pin = t->session->pin;
	t->kept = pin != NULL ? pin->p : (struct prediction){0};
	t->pin = numbers_of(t->session, pin != NULL ? pin->key : "", &t->kept);
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
	t->n_row = 0;
	tui_forget_parity(&t->parity);
	t->looked++;
	above_look(t);
	look_at_pin(t);
	tui_untouch(t);
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

/* The page and the quantity that are set. */
static void
take_looks(struct tui *t)
{
	static const struct partition SHARP = {0, 1};
	const struct choices *set = &t->session->set;
	struct error error = {0};
	if (!quantities_read(set->quantity, &SHARP, &t->quantity, &error))
		t->quantity = above_usual();
	t->page = (enum page)set->page;
	tui_untouch(t);
}

/* Sets those that are shown, so that they are saved and shown again. */
static void
set_looks(struct tui *t)
{
	static const char *const NAMES[PAGES] = {
	    "predict", "fit", "data", "parity", "sites"};
	struct session *s = t->session;
	struct error error = {0};
	size_t next;
	char *quantity = quantities_typed(&t->quantity);
	char *line =
	    xasprintf("set page %s quantity \"%s\"", NAMES[t->page], quantity);
	hush(t);
	if (s->set.page != t->page || strcmp(s->set.quantity, quantity) != 0)
		session_line(s, line, 0, "typed", 0, &next, &error);
	free(quantity);
	free(line);
}

/* Whether a line has set others than there were; what is undone has not. */
static bool
sets_looks(const struct choices *was, const struct choices *is)
{
	return was->page != is->page ||
	       strcmp(was->quantity, is->quantity) != 0;
}

/* The line has begun what takes long. */
static void
begin_job(struct tui *t, const char *line)
{
	const struct command *command = command_of(line);
	const struct job *job = &t->session->job;
	t->job = command != NULL ? command->name : NULL;
	t->held = false;
	t->generation = 0;
	t->due = t->started = t->clock;
	if (calibration_status(job->calibration).generation == 0)
		t->ran = 0;
	if (job->fits && !job->rounds->alone) {
		t->page = PAGE_SITES;
		tui_untouch(t);
		t->focus = &page_sites;
	}
}

static bool
run(struct tui *t, const char *line)
{
	struct session *s = t->session;
	const struct choices was = s->set;
	bool was_busy = session_busy(s);
	char site[sizeof t->now.site] = "";
	if (tui_entry(t) != NULL)
		snprintf(site, sizeof site, "%s", tui_entry(t)->key);
	hush(t);
	const struct driver d = {.session = s,
	    .of = t,
	    .fail = say_error,
	    .begins = begins_line,
	    .work = work,
	    .watches = true};
	/* A signal is no error: what was found before it stays. */
	bool ok = driver_line(&d, line, "typed", 0) == 0 || pump_signal() != 0;
	end_under_way(t, command_of(line) == command_find("restore"), ok);
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
	/* Another answer is shown where other runs correct the model. */
	if (s->set.correction != was.correction)
		t->asked.tenths = 0;
	if (sets_looks(&was, &s->set) && strcmp(line, "undo") != 0 &&
	    strcmp(line, "redo") != 0)
		take_looks(t);
	tui_keep_feed(t);
	control_look(t);
	if (session_busy(s) && !was_busy)
		begin_job(t, line);
	return ok;
}

bool
control_run(struct tui *t, const char *line)
{
	free(t->command);
	t->command = xstrdup(line);
	t->message[0] = '\0';
	bool ok = run(t, line);
	t->failed = !ok;
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
	t->failed = !ok;
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
	fputs(tr("\n"
		 "[Return: back]"),
	    stdout);
	fflush(stdout);
	/* ^C has ended the shell command. */
	pump_forget_interrupt();
	pump_answer(NULL);
}

/* Whether the page Predict shows all that a line asks: the site's product at a
 * speed, with a feed and a machine of its own. */
static bool
only_moves(const char *line)
{
	static const char *const MORE[] = {
	    " rotor_mm=", " cascade=", " k=", " sieves=", " cut="};
	if (strncmp(line, "predict", 7) != 0 || strchr(line, '>') != NULL)
		return false;
	for (size_t i = 0; i < ARRAY_LEN(MORE); i++)
		if (strstr(line, MORE[i]) != NULL)
			return false;
	const char *feed = strstr(line, "feed=");
	if (feed == NULL)
		return true;
	double speed;
	char *word = xstrndup(feed + 5, strcspn(feed + 5, " ;"));
	bool own = value_number(word, "m/s", &speed);
	free(word);
	return own;
}

/* What a line does to a search that is under way. */
enum meeting {
	MEETS_NONE,   /* goes on beside it; what is no command does nothing */
	MEETS_BOUNDS, /* has it go on within these */
	MEETS_END     /* stops it */
};

static enum meeting
meeting(const struct tui *t, const char *line)
{
	const struct command *command = command_of(line);
	if (!session_busy(t->session))
		return MEETS_NONE;
	if (command == NULL)
		return strchr(line, ';') == NULL ? MEETS_NONE : MEETS_END;
	bool bounds = command == command_find("bounds");
	bool asks = strpbrk(line + strspn(line, " \t"), " \t") == NULL;
	if (command->flags & COMMAND_BESIDE || (bounds && asks))
		return MEETS_NONE;
	return bounds ? MEETS_BOUNDS : MEETS_END;
}

/* Whether a search may be stopped for a line: it is not to leave a fit that is
 * half finished in the place of another unasked. */
static bool
may_stop(struct tui *t, const char *line)
{
	struct session *s = t->session;
	const struct entry *fitting = session_fitting(s);
	if (command_of(line) == command_find("quit") || fitting == NULL ||
	    !fitting->has_fit ||
	    s->hooks.confirm(s,
		"this stops the calibration: is its best so far to replace "
		"the fit there was?"))
		return true;
	tui_say(t, false,
	    "the calibration goes on, the command was not run: s stops it, u "
	    "brings the former fit back");
	return false;
}

/* On within bounds that were edited in a search; where it was paused the user
 * says when. */
static void
go_on_within(struct tui *t, bool edited)
{
	bool on = t->session->job.paused;
	if (control_run(t, on ? "continue" : "calibrate") && on && edited)
		tui_say(t, false, "continues within the new bounds");
}

/* Says more behind what a line has said, where no text has opened. */
static void
say_more(struct tui *t, const char *more)
{
	char *said = xstrdup(t->message);
	if (t->viewer.text == NULL)
		tui_say(t, t->bad, "%s%s%s", said, said[0] != '\0' ? "; " : "",
		    more);
	free(said);
}

/* What a line that was run has said; of a search that it began the page
 * tells. */
static void
tell(struct tui *t, const char *line, bool ok, bool began)
{
	bool moved_only = only_moves(line);
	fflush(t->said);
	/* What a check found, the other faults of a sheet. */
	if (!ok && t->said_n > 0)
		text_wrap(t->message, 0, 78, t->said);
	if (!began && (ok ? !moved_only : t->said_n > 0))
		show_said(t);
}

static void
run_typed(struct tui *t, const char *line)
{
	if (line[strspn(line, " \t")] == '\0')
		return;
	struct session *s = t->session;
	const struct bounds before = s->set.bounds;
	const bool was_busy = session_busy(s);
	const char *useless = was_busy ? s->job.rounds->useless : NULL;
	bool searching = was_busy && !t->held;
	enum meeting meets = meeting(t, line);
	if (command_of(line) == command_find("screen")) {
		draw_screen(t, line);
		return;
	}
	if (meets == MEETS_END && !may_stop(t, line))
		return;
	if (meets != MEETS_NONE)
		control_keep(t);
	if (command_of(line) == command_find("save"))
		set_looks(t);
	/* Only a shell command may write past the session's streams. */
	bool aside = strchr(line, '|') != NULL && !t->aside && !s->safe;
	if (aside)
		t->ways->leave();
	bool ok = control_run(t, line);
	if (aside) {
		await_return();
		t->ways->come_back();
	}
	bool edited = memcmp(&before, &s->set.bounds, sizeof before) != 0;
	if (searching && (meets == MEETS_BOUNDS || edited) &&
	    !session_busy(s)) {
		go_on_within(t, edited);
		return;
	}
	if (ok && edited)
		tui_say(t, false, "f calibrates within these bounds");
	bool beside = was_busy && meets == MEETS_NONE;
	tell(t, line, ok, session_busy(s) && !beside);
	/* Who has moved the slider may have meant that. */
	if (ok && command_of(line) == command_find("undo"))
		say_more(t, tr("U brings it back (moves of the slider are not "
			       "undone)"));
	else if (was_busy && meets == MEETS_END && !session_busy(s))
		say_more(t,
		    useless != NULL
			? useless
			: tr("the calibration was stopped, its best is kept"));
}

/* Whether a command answers for one speed; pictures, data that are shown and
 * changes are of what they say. */
static bool
asks_at_speed(const struct command *command)
{
	const char *group = command_group(command);
	return command_option_index(command, "speed") < OPTIONS &&
	       strcmp(group, "pictures") != 0 && strcmp(group, "data") != 0 &&
	       !(command->flags & COMMAND_CHANGES);
}

/* Whether a line has a speed among its operands, as in "compare pinned 72". */
static bool
names_speed(const struct command *asked, const char *rest)
{
	bool named = false;
	char *copy = xstrndup(rest, strcspn(rest, ">|")), *save = NULL;
	double v;
	for (char *word = strtok_r(copy, " \t", &save); word != NULL;
	     word = strtok_r(NULL, " \t", &save))
		named |= value_number(word, "m/s", &v);
	free(copy);
	return named && asked->operands.usage != NULL &&
	       strstr(asked->operands.usage, "SPEED") != NULL;
}

/* What a typed line means with the slider somewhere, see tui_where.  A question
 * about one speed is about that of the slider, where it is asked of no other:
 * "spec FILE" gets it.  The caller frees. */
static char *
meant_by(const char *line, const char *where)
{
	size_t from = strspn(line, " \t"), n = strcspn(line + from, " \t>|");
	const char *word = line + from, *rest = word + n;
	rest += strspn(rest, " \t");
	char *name = xstrndup(word, n);
	const struct command *asked = command_called(name, true);
	free(name);
	if (asked == NULL || !asks_at_speed(asked))
		return xstrdup(line);
	/* A speed may also stand alone. */
	bool bare = asked->bare == NULL || strcmp(asked->bare, "speed") == 0;
	bool said =
	    strchr(line, ';') != NULL || strstr(line, "speed=") != NULL ||
	    strstr(line, "rpm=") != NULL ||
	    (bare && *rest >= '0' && *rest <= '9') || names_speed(asked, rest);
	bool own = strstr(line, "feed=") != NULL ||
		   command_option_index(asked, "feed") == OPTIONS;
	size_t length = own ? strcspn(where, " ") : strlen(where);
	if (!said)
		return xasprintf("%s %.*s%s%s", asked->name, (int)length, where,
		    *rest != '\0' ? " " : "", rest);
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
control_show(struct tui *t, const char *line)
{
	if (control_run(t, line))
		show_said(t);
}

void
control_predict(struct tui *t)
{
	struct session *s = t->session;
	const struct entry *entry = tui_entry(t);
	track_wished(t, false);
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
	/* What a search had on its way is nothing to count from. */
	if (!t->formed &&
	    (t->clock - t->moved > PAUSE || t->pause.site[0] == '\0' ||
		strcmp(t->pause.site, entry->key) != 0))
		t->pause = t->now;
	t->formed = forming;
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
		t->failed = false;
	}
	if (!first && !told)
		t->message[0] = '\0';
	tui_keep_feed(t);
	t->asked.tenths = t->tenths;
	t->asked.feed_run = tui_feed(t);
	t->now = numbers_of(s, entry->key, &t->shown);
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
	bool alone = s->job.rounds->alone;
	const char *useless = s->job.rounds->useless;
	session_pause(s);
	session_settle(s, true, &error);
	t->ran = tui_searched(t);
	t->held = false;
	t->asked.tenths = 0;
	control_look(t);
	tui_say(t, false, "%s",
	    useless != NULL ? useless
	    : alone
		? tr("stopped, the best is kept: Space continues, f starts "
		     "again, both within the current bounds; u undoes it")
		: tr("stopped: the sites calibrated so far keep their fits; u "
		     "undoes it"));
}

/* The last calibration of several: their table is what they end with. */
static void
finish_all(struct tui *t)
{
	struct error error = {0};
	if (!session_settle(t->session, true, &error))
		say_error(t, &error, "", "");
	else
		tui_say(t, false,
		    "all sites are calibrated: Enter opens one, :validate all "
		    "compares them with their held-out runs");
	t->held = false;
	control_look(t);
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
		    t->page == PAGE_FIT
			? N_("calibrated: %s, RMSE %.2f points, %zu "
			     "generations; Tab, arrows: show them")
			: N_("calibrated: %s, RMSE %.2f points, %zu "
			     "generations"),
		    light_verdict(t->session, entry, NULL),
		    100 * entry->fit.rmse, entry->fit.generations);
}

/* The job of these is over. */
static void
finish_rounds(struct tui *t, const struct rounds *rounds)
{
	struct error error = {0};
	if (rounds->at == NULL) {
		(rounds->alone ? finish : finish_all)(t);
		return;
	}
	t->held = false;
	control_look(t);
	show_said(t);
	if (!session_settle(t->session, true, &error))
		say_error(t, &error, "", "");
	else if (t->viewer.text != NULL) {
		t->viewer.report = true;
		tui_say(t, false, "%s: done, V shows it again",
		    t->job != NULL ? t->job : t->command);
	}
}

/* Whether the search is over and what is drawn of its end under way. */
static bool
is_drawing(const struct session *s)
{
	return session_busy(s) &&
	       calibration_status(s->job.calibration).state >=
		   CALIBRATE_TOLERANCE;
}

void
control_hold(struct tui *t, bool hold)
{
	if (hold == t->held)
		return;
	t->ran = tui_searched(t);
	t->held = hold;
	t->due = t->started = t->clock;
}

void
control_step(struct tui *t)
{
	if (!session_busy(t->session))
		return;
	const struct rounds *rounds = t->session->job.rounds;
	do
		session_step(t->session);
	while (session_busy(t->session) && is_drawing(t->session));
	t->asked.tenths = 0;
	if (!session_busy(t->session))
		finish_rounds(t, rounds);
}

/* Generations a second: fewer where the last one gained much. */
static double
pace_now(const struct tui *t)
{
	enum { QUICK = 40, USUAL = 12, SLOW = 4 };
	const double much = 0.2, little = 0.02;
	struct plots_past past = tui_past(t);
	const struct calibrate_generation *g = past.generation;
	if (t->pace != PACE_AUTO)
		return PACES[t->pace];
	if (past.n < 2 || past.polished)
		return USUAL;
	double gain = 1 - g[past.n - 1].best / g[past.n - 2].best;
	return gain >= much ? SLOW : gain >= little ? USUAL : QUICK;
}

void
control_pump(struct tui *t)
{
	static const double FRAME = 0.02; /* s, at full pace */
	struct session *s = t->session;
	if (!session_busy(s) || t->held)
		return;
	double began = session_clock();
	/* Of several nobody watches the generations. */
	const struct rounds *rounds = s->job.rounds;
	int pace = rounds->alone && !is_drawing(s) ? t->pace : PACE_FULL;
	size_t entry = s->job.entry;
	if (pace < PACE_FULL && t->clock < t->due)
		return;
	do {
		/* What each round says is not for a result. */
		if (rounds->at != NULL)
			hush(t);
		session_step(s);
	} while (session_busy(s) && pump_signal() == 0 &&
		 entry == s->job.entry &&
		 (pace == PACE_FULL || is_drawing(s)) &&
		 (t->aside ||
		     (!pump_waited_for() && session_clock() - began < FRAME)));
	if (pace < PACE_FULL)
		t->due = t->clock + 1 / pace_now(t);
	if (entry == s->current && rounds->at == NULL)
		t->asked.tenths = 0;
	if (!session_busy(s))
		finish_rounds(t, rounds);
	else if (rounds->at == NULL && entry != s->job.entry)
		control_look(t);
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

/* At the end of a search, before there is a result to draw. */
static void
begins(const char *what)
{
	if (open->ways->show == NULL || open->page != PAGE_FIT ||
	    !session_busy(open->session) || open->begun != NULL)
		return;
	open->begun = what;
	open->ways->show(open);
	open->begun = NULL;
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
	*t = (struct tui){.session = s,
	    .ways = ways,
	    .aside = ways->leave == NULL,
	    .tenths = first_speed(s),
	    .site_at = s->current,
	    .mouse = screen_mouse(true),
	    .pace = PACE_AUTO,
	    .picture = PLOT_SEARCH,
	    .level = 50,
	    .above = above_new(),
	    .holdout = NAN,
	    .before = {
		s->out, s->notes, s->hooks, s->prompt, s->typed_at, s->screen}};
	s->hooks.confirm = confirm;
	s->hooks.question = question;
	s->prompt = true;
	s->typed_at = s->scripts;
	s->hooks.show_page = NULL;
	s->hooks.begins = begins;
	s->hooks.run_screen = NULL;
	tui_keep_feed(t);
	t->said = text_memory(&t->said_text, &t->said_n);
	s->out = s->notes = t->said;
	take_looks(t);
	control_look(t);
	open = t;
}

void
control_end(struct tui *t)
{
	struct session *s = t->session;
	if (!t->aside)
		set_looks(t);
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
	free(t->closed);
	prediction_free(&t->shown);
	free(t->command);
	free(t->row);
	above_free(t->above);
	goals_clear(&t->goal);
	tui_forget_sheet(&t->sheet);
	tui_forget_parity(&t->parity);
	folder_free(&t->chooser.folder);
	free(t->chooser.preview);
	limits_free(t);
	second_free(t);
	touch_free(&t->touches);
}
