/* The loop of the full screen: draws, waits, handles keys, and runs what is
 * due.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/tui.h"

#include <math.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <curses.h>

#include "base/xalloc.h"
#include "cmd/session/autosave.h"
#include "tui/widgets/response_strip.h"
#include "tui/keymap.h"
#include "tui/control.h"
#include "tui/frame.h"
#include "tui/input.h"
#include "cli/manpage.h"
#include "cli/signals.h"
#include "cli/restore.h"
#include "tui/screen.h"
#include "cli/terminal.h"
#include "tui/tui_state.h"
#include "cli/history.h"
#include "tui/watch.h"
#include "tui/word.h"
#include "tui/view.h"

/* Pasted text has ended when nothing more has come for so long, s. */
static const double PASTE_PAUSE = 2;

/* Returns how long to wait, s, for the next thing that is due: a generation, a
 * part of the strip or of page Sites, a held key or the end of pasted text.
 * INFINITY: until something happens. */
static double
seconds_until_next_due(const struct tui *t)
{
	double left = t->paste.on ? PASTE_PAUSE : INFINITY;
	bool asks = t->question != NULL || t->inquiry != NULL;
	if (!asks && session_is_calibrating(t->session) && !t->held)
		left = t->ui.pace == PACE_FULL
			   ? 0
			   : fmin(left, t->due - session_clock_seconds());
	if (!asks)
		left = fmin(left, fmin(strip_seconds_to_wait(t),
				      word_key_delay_seconds_left(t)));
	bool now = t->put_back.is || (!asks && t->view.rows_left);
	return left > 0 && !now ? left : 0;
}

/* Leaves the terminal to another program.  ^Z then stops that too, because the
 * shell waits for both. */
static void
release_terminal(struct tui *t)
{
	t->away = true;
	screen_suspend_curses();
	signals_set_suspend_handler(false);
	signals_unblock();
}

static void
reclaim_terminal(struct tui *t)
{
	signals_block();
	signals_set_suspend_handler(true);
	signals_clear_interrupt();
	screen_resume_curses();
	t->away = false;
}

static void
suspend_program(struct tui *t)
{
	double left = session_clock_seconds();
	screen_suspend_curses();
	signals_suspend_program();
	signals_clear_interrupt();
	screen_resume_curses();
	t->started += session_clock_seconds() - left;
}

/* Handles everything typed and dragged so far, so that only the newest speed is
 * predicted. */
static void
handle_typed_keys(struct tui *t)
{
	int code;
	bool special;
	while (!t->leave && !t->session->quit &&
	       signals_get_ending_or_interrupt() == 0 &&
	       input_read_next_key(t, &code, &special)) {
		keymap_handle_key(t, code, special);
		signals_deliver_blocked();
	}
	if (word_key_delay_seconds_left(t) <= 0)
		keymap_run_delayed_key(t);
	/* The end mark of the paste never came: what is typed is keys again. */
	if (t->paste.on && session_clock_seconds() - t->pasted >= PASTE_PAUSE)
		input_end_paste(t);
}

/* Ends the program if its terminal was closed without a hang-up, because
 * reading it would go on for ever. */
static void
end_if_terminal_is_gone(void)
{
	struct pollfd in = {.fd = STDIN_FILENO, .events = POLLIN};
	if (poll(&in, 1, 0) <= 0 || !(in.revents & (POLLHUP | POLLERR)))
		return;
	/* pselect lets no signal in while there is something to read. */
	raise(SIGHUP);
	signals_deliver_blocked();
}

/* Draws a frame and waits until something happens. */
static void
draw_and_wait_for_input(struct tui *t)
{
	frame_draw(t);
	signals_set_stop_on_key(false);
	signals_wait_for_input(seconds_until_next_due(t));
	end_if_terminal_is_gone();
	int news = signals_take_terminal_events();
	if (news & SIGNALS_STOP) {
		suspend_program(t);
		news = signals_take_terminal_events();
	}
	if (news & (SIGNALS_WAKE | SIGNALS_SIZE))
		screen_resize();
}

/* Waits for a key that answers a question.  Returns false on a signal. */
static bool
wait_for_answer_key(struct tui *t, int *code, bool *special)
{
	bool done = false;
	while (!done && signals_get_ending_or_interrupt() == 0) {
		draw_and_wait_for_input(t);
		done = input_read_next_key(t, code, special);
		if (done && *special && *code == KEY_MOUSE) {
			keymap_handle_question_mouse(t);
			done = false;
		} else if (done && !*special && *code == SUSPEND) {
			done = false;
			raise(SIGTSTP);
		}
	}
	return done;
}

/* Returns true if Esc or ^C was pressed.  Other keys pressed meanwhile are
 * lost. */
static bool
is_stop_key_pressed(struct tui *t)
{
	int code;
	bool special, stops = false;
	signals_deliver_blocked();
	while (input_read_next_key(t, &code, &special))
		stops = stops ||
			(!special && (code == ESCAPE || code == INTERRUPT));
	return stops;
}

static void
run_screen_loop(struct tui *t)
{
	while (!t->leave && !t->session->quit &&
	       signals_get_ending_or_interrupt() == 0) {
		t->clock = session_clock_seconds();
		signals_set_stop_on_key(true);
		view_update(t);
		draw_and_wait_for_input(t);
		t->clock = session_clock_seconds();
		handle_typed_keys(t);
		signals_set_stop_on_key(true);
		watch_run_due_fit_steps(t);
		signals_set_stop_on_key(false);
	}
}

/* Leaves the terminal to man(1), which needs it for itself. */
static bool
show_manual_page(const char *page)
{
	release_terminal(control_current_screen());
	bool shown = manpage_show(page);
	reclaim_terminal(control_current_screen());
	return shown;
}

int
tui_run(struct session *s)
{
	static const struct tui_callbacks ON_TERMINAL = {wait_for_answer_key,
	    frame_draw, release_terminal, reclaim_terminal,
	    is_stop_key_pressed};
	struct sigaction was[3];
	struct tui t;
	bool history = typed_history_is_open();
	/* Before ncurses starts, because it may print that the history cannot
	 * be kept. */
	if (!history)
		typed_history_open(!s->safe);
	terminal_record_settings();
	signals_block();
	signals_catch_terminal(was);
	bool opened = screen_open(terminal_has_colour());
	if (opened) {
		control_open_screen(&t, s, &ON_TERMINAL);
		s->hooks.show_manual_page = show_manual_page;
		FREED char *offer = autosave_begin(s);
		if (offer != NULL)
			tui_set_message(&t, false, "%s", offer);
		run_screen_loop(&t);
		const char *stopped = tui_stop_fit(&t);
		control_close_screen(&t);
		screen_close();
		restore_disarm_tty();
		if (stopped[0] != '\0')
			session_print_note(s, "%s", stopped);
	}
	signals_uncatch_terminal(was);
	signals_unblock();
	if (!history)
		typed_history_close();
	if (!opened) {
		session_print_note(s,
		    "this terminal cannot show full-screen mode: "
		    "check TERM, or use 'predict' without it");
		return ERROR_SYSTEM;
	}
	return signals_exit_status();
}
