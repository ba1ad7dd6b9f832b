/* The full screen's loop: waits, takes keys, moves the session, draws.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/tui.h"

#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <unistd.h>

#include <curses.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/keep.h"
#include "cmd/script.h"
#include "ui/act.h"
#include "ui/conduct.h"
#include "ui/input.h"
#include "ui/manpage.h"
#include "ui/pane.h"
#include "ui/paste.h"
#include "ui/pump.h"
#include "ui/repl.h"
#include "ui/rescue.h"
#include "ui/rows.h"
#include "ui/screen.h"
#include "ui/shot.h"
#include "ui/tui_state.h"
#include "ui/typed.h"
#include "ui/view.h"

/* What is pasted has ended where nothing more came for so long, s. */
static const double PASTE_PAUSE = 2;

static bool with_colour;
static volatile sig_atomic_t resized, stopping;
/* Signals that are let in while the program waits. */
static sigset_t let_in;
/* session->confirm has no argument to pass it by. */
static struct tui *asked;
static bool aside; /* somebody else has the terminal */

void
tui_choose(bool colour)
{
	with_colour = colour;
}

const struct entry *
tui_entry(const struct tui *t)
{
	const struct session *s = t->session;
	return s->n_entry > 0 ? &s->entry[s->current] : NULL;
}

struct slider_range
tui_range(const struct tui *t)
{
	const struct entry *entry = tui_entry(t);
	return slider_range(entry != NULL ? entry->site : NULL);
}

size_t
tui_feed(const struct tui *t)
{
	const struct site *site = tui_entry(t)->site;
	size_t kept = site_run_at(site, t->feed);
	return kept < site->n_run ? kept
				  : site_run_nearest(site, t->tenths / 10.0);
}

void
tui_keep_feed(struct tui *t)
{
	double feed = session_known(t->session, "predict", "feed_mps");
	if (isfinite(feed))
		t->feed = feed;
}

char *
tui_where(const struct tui *t)
{
	const struct entry *entry = tui_entry(t);
	double speed = t->tenths / 10.0;
	if (entry == NULL || !entry->site->individual_feeds ||
	    tui_feed(t) == site_run_nearest(entry->site, speed))
		return xasprintf("speed=%.1f", speed);
	return xasprintf(
	    "speed=%.1f feed=%g", speed, entry->site->run[tui_feed(t)].speed);
}

static void
on_resize(int signal)
{
	resized = signal;
}

static void
on_stop(int signal)
{
	stopping = signal;
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

struct signals {
	struct sigaction resize, stop, go_on;
};

/* The loop answers a stop; who is given the terminal is stopped with the
 * program, as the shell waits for both. */
static void
answer_stop(bool in_loop)
{
	struct sigaction now,
	    action = {.sa_handler = in_loop ? on_stop : SIG_DFL};
	sigemptyset(&action.sa_mask);
	sigaction(SIGTSTP, NULL, &now);
	if (now.sa_handler != SIG_IGN)
		sigaction(SIGTSTP, &action, NULL);
}

static void
hold_signals(struct signals *was)
{
	struct sigaction action = {.sa_handler = on_resize};
	sigemptyset(&action.sa_mask);
	pump_hold_signals(&let_in);
	sigaction(SIGWINCH, &action, &was->resize);
	sigaction(SIGCONT, &action, &was->go_on);
	sigaction(SIGTSTP, NULL, &was->stop);
	answer_stop(true);
}

static void
give_signals_back(const struct signals *was)
{
	sigaction(SIGWINCH, &was->resize, NULL);
	sigaction(SIGCONT, &was->go_on, NULL);
	sigaction(SIGTSTP, &was->stop, NULL);
	sigprocmask(SIG_SETMASK, &let_in, NULL);
}

/* How long to wait, s, for the next generation that is due, or for the end of
 * what is pasted; INFINITY: for ever. */
static double
patience(const struct tui *t)
{
	double left = t->paste.on ? PASTE_PAUSE : INFINITY;
	if (t->question == NULL && session_busy(t->session) && !t->held)
		left = t->pace == PACE_FULL
			   ? 0
			   : fmin(left, t->due - session_clock());
	return left > 0 ? left : 0;
}

/* Waits for a key, a signal, or until it has lost its patience. */
static void
wait_for_something(const struct tui *t)
{
	double left = patience(t);
	struct timespec time = {0};
	if (isfinite(left)) {
		time.tv_sec = (time_t)left;
		time.tv_nsec = (long)(1e9 * (left - floor(left)));
	}
	fd_set in;
	FD_ZERO(&in);
	FD_SET(STDIN_FILENO, &in);
	pselect(STDIN_FILENO + 1, &in, NULL, NULL,
	    isfinite(left) ? &time : NULL, &let_in);
}

void
tui_step_aside(void)
{
	aside = true;
	screen_leave();
	answer_stop(false);
	sigprocmask(SIG_SETMASK, &let_in, NULL);
}

void
tui_step_back(void)
{
	pump_hold_signals(NULL);
	answer_stop(true);
	pump_forget_interrupt();
	screen_return();
	aside = false;
}

static void
stop_here(struct tui *t)
{
	double left = session_clock();
	stopping = 0;
	screen_leave();
	pump_suspend(&let_in);
	pump_forget_interrupt();
	screen_return();
	t->started += session_clock() - left;
}

/* Everything that was typed and dragged; only the newest speed is predicted. */
static void
take_keys(struct tui *t)
{
	int code;
	bool special;
	while (!t->leave && !t->session->quit &&
	       input_key(t, &let_in, &code, &special))
		act_key(t, code, special);
	/* Its end does not come: keys are keys again. */
	if (t->paste.on && session_clock() - t->pasted >= PASTE_PAUSE)
		paste_end(t);
}

/* A terminal that was closed under the program without a hang-up: reading it
 * would go round for ever. */
static void
notice_end(void)
{
	struct pollfd in = {.fd = STDIN_FILENO, .events = POLLIN};
	if (poll(&in, 1, 0) <= 0 || !(in.revents & (POLLHUP | POLLERR)))
		return;
	/* pselect lets no signal in while there is something to read. */
	raise(SIGHUP);
	pump_let_in(&let_in);
}

/* One frame, until something happens. */
static void
show(struct tui *t)
{
	pane_draw(t);
	pump_watch(false);
	wait_for_something(t);
	notice_end();
	if (stopping)
		stop_here(t);
	if (resized)
		screen_resize();
	resized = 0;
}

/* The key that answers; 0 at a signal.  The mouse answers nothing. */
static int
read_answer(struct tui *t)
{
	enum { STOP = 26 };
	int code = 0;
	bool special = false, done = false;
	while (!done && pump_signal() == 0) {
		show(t);
		done = input_key(t, &let_in, &code, &special);
		if (done && special && code == KEY_MOUSE) {
			MEVENT e;
			getmouse(&e);
			done = false;
		} else if (done && !special && code == STOP) {
			done = false;
			raise(SIGTSTP);
		}
	}
	return done && !special ? code : 0;
}

static bool
confirm(struct session *s, const char *question)
{
	struct tui *t = asked;
	if (aside)
		return pump_confirm(s, question);
	t->question = question;
	int code = 0;
	if (!t->aside) {
		code = read_answer(t);
	} else {
		pane_draw(t);
		code = shot_answer();
	}
	t->question = NULL;
	return code == 'y' || code == 'Y';
}

static void
loop(struct tui *t)
{
	while (!t->leave && !t->session->quit && pump_signal() == 0) {
		t->clock = session_clock();
		pump_watch(true);
		conduct_predict(t);
		rows_update(t);
		show(t);
		t->clock = session_clock();
		take_keys(t);
		pump_watch(true);
		conduct_pump(t);
		pump_watch(false);
	}
}

/* man(1) wants the terminal for itself. */
static bool
show_page(const char *page)
{
	tui_step_aside();
	bool shown = manpage_show(page);
	tui_step_back();
	return shown;
}

void
tui_begin(struct tui *t, struct session *s)
{
	enum { PACE = 4 };
	*t = (struct tui){.session = s,
	    .tenths = first_speed(s),
	    .site_at = s->current,
	    .mouse = screen_mouse(true),
	    .pace = PACE,
	    .picture = PLOT_PSD,
	    .level = 50,
	    .holdout = NAN,
	    .before = {s->out, s->notes, s->show_page, s->confirm, s->prompt,
		s->typed_at, s->screen}};
	asked = t;
	s->confirm = confirm;
	s->prompt = true;
	s->typed_at = script_depth(s);
	s->show_page = NULL;
	tui_keep_feed(t);
	conduct_begin(t);
	conduct_look(t);
	shot_of(t);
}

void
tui_end(struct tui *t)
{
	struct session *s = t->session;
	shot_of(NULL);
	s->out = t->before.out;
	s->notes = t->before.notes;
	s->show_page = t->before.show_page;
	s->confirm = t->before.confirm;
	s->prompt = t->before.prompt;
	s->typed_at = t->before.typed_at;
	s->screen = t->before.screen;
	conduct_keep(t);
	conduct_end(t);
	typing_end(&t->typing);
	view_close(t);
	free(t->command);
	prediction_free(&t->shown);
	prediction_free(&t->kept);
	free(t->row);
}

/* At the prompt there is nothing to do: it is what --linear asks for. */
static int
run_linear(struct session *s)
{
	if (!s->prompt)
		return repl_run(s, with_colour);
	session_note(s, "this is the prompt, which --linear asked for");
	return 0;
}

/* What was kept of the last session. */
static void
offer_last(struct tui *t)
{
	char *offer = keep_begin(t->session);
	if (offer != NULL)
		tui_say(t, false, "%s", offer);
	free(offer);
}

int
tui_run(struct session *s)
{
	struct signals was;
	struct tui t;
	bool history = typed_is_open();
	if (s->linear)
		return run_linear(s);
	/* What it says of a history that cannot be kept is not for ncurses. */
	if (!history)
		typed_open(!s->safe);
	rescue_note();
	hold_signals(&was);
	bool opened = screen_open(with_colour);
	if (opened) {
		tui_begin(&t, s);
		s->show_page = show_page;
		offer_last(&t);
		loop(&t);
		tui_end(&t);
		screen_close();
		rescue_done();
	}
	give_signals_back(&was);
	if (!history)
		typed_close();
	if (!opened) {
		session_note(s, "this terminal cannot show a full screen: is "
				"TERM right? 'predict' answers without one");
		return ERROR_SYSTEM;
	}
	return pump_status();
}
