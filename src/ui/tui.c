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
#include "ui/frame.h"
#include "ui/input.h"
#include "ui/manpage.h"
#include "ui/pages.h"
#include "ui/paste.h"
#include "ui/pump.h"
#include "ui/rescue.h"
#include "ui/screen.h"
#include "ui/terminal.h"
#include "ui/tui_state.h"
#include "ui/typed.h"
#include "ui/view.h"

/* What is pasted has ended where nothing more came for so long, s. */
static const double PASTE_PAUSE = 2;

static volatile sig_atomic_t resized, stopping;
/* Signals that are let in while the program waits. */
static sigset_t let_in;
static bool aside; /* somebody else has the terminal */

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

static void
leave(void)
{
	aside = true;
	screen_leave();
	answer_stop(false);
	sigprocmask(SIG_SETMASK, &let_in, NULL);
}

static void
come_back(void)
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
	frame_draw(t);
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
answer(struct tui *t)
{
	enum { STOP = 26 };
	int code = 0;
	bool special = false, done = false;
	if (aside)
		return pump_confirm(t->session, t->question) ? 'y' : 0;
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

static void
loop(struct tui *t)
{
	while (!t->leave && !t->session->quit && pump_signal() == 0) {
		t->clock = session_clock();
		pump_watch(true);
		conduct_predict(t);
		pages_update(t);
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
	leave();
	bool shown = manpage_show(page);
	come_back();
	return shown;
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
	static const struct tui_ways WAYS = {answer, leave, come_back};
	struct signals was;
	struct tui t;
	bool history = typed_is_open();
	/* What it says of a history that cannot be kept is not for ncurses. */
	if (!history)
		typed_open(!s->safe);
	rescue_note();
	hold_signals(&was);
	bool opened = screen_open(terminal_colour());
	if (opened) {
		conduct_begin(&t, s, &WAYS);
		s->show_page = show_page;
		offer_last(&t);
		loop(&t);
		conduct_end(&t);
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
