/* Handlers record signals; loops act on them where they wait.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/signals.h"

#include <math.h>
#include <poll.h>
#include <sys/select.h>
#include <unistd.h>

#include "base/xalloc.h"

/* ending: the first signal that ends the program, or 0. */
static volatile sig_atomic_t interrupted, ending, asked, watching, stopped,
    woken, resized;

/* The signal mask while the program waits, which lets all handled signals
 * in. */
static sigset_t let_in;

static void
on_ending_signal(int signal)
{
	if (signal == SIGINT)
		interrupted = 1;
	else if (ending == 0)
		ending = signal;
}

static void
on_progress_report_signal(int signal)
{
	asked = signal;
}

static void
on_file_size_limit(int signal)
{
	(void)signal;
}

void
signals_catch(void)
{
	struct sigaction action = {.sa_handler = on_ending_signal}, was;
	sigemptyset(&action.sa_mask);
	sigaction(SIGINT, &action, NULL);
	sigaction(SIGTERM, &action, NULL);
	sigaction(SIGHUP, &action, &was);
	/* nohup; the full screen needs it at the end of its terminal. */
	if (was.sa_handler == SIG_IGN && !isatty(STDIN_FILENO))
		sigaction(SIGHUP, &was, NULL);
	/* A write beyond the limit then fails as on a full disk.  A handler,
	 * because shells started by the program would inherit SIG_IGN. */
	action.sa_handler = on_file_size_limit;
	sigaction(SIGXFSZ, &action, NULL);
	action.sa_handler = on_progress_report_signal;
	action.sa_flags = SA_RESTART;
	sigaction(SIGUSR1, &action, NULL);
}

static void
on_terminal_signal(int signal)
{
	*(signal == SIGTSTP     ? &stopped
	    : signal == SIGCONT ? &woken
				: &resized) = 1;
}

void
signals_block(void)
{
	static const int ANSWERED[] = {
	    SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGCONT, SIGWINCH};
	sigset_t held;
	sigemptyset(&held);
	for (size_t i = 0; i < ARRAY_LEN(ANSWERED); i++)
		sigaddset(&held, ANSWERED[i]);
	sigprocmask(SIG_BLOCK, &held, &let_in);
}

void
signals_unblock(void)
{
	sigprocmask(SIG_SETMASK, &let_in, NULL);
}

bool
signals_wait_for_input_with_mask(const sigset_t *mask, double seconds)
{
	struct timespec time = {0};
	bool ends = isfinite(seconds);
	if (ends) {
		time.tv_sec = (time_t)seconds;
		time.tv_nsec = (long)(1e9 * (seconds - floor(seconds)));
	}
	fd_set in;
	FD_ZERO(&in);
	FD_SET(STDIN_FILENO, &in);
	return pselect(STDIN_FILENO + 1, &in, NULL, NULL, ends ? &time : NULL,
		   mask) > 0;
}

/* Signals that came earlier end the wait at once. */
bool
signals_wait_for_input(double seconds)
{
	if (signals_get_ending_or_interrupt() != 0 || stopped || woken ||
	    resized)
		return false;
	return signals_wait_for_input_with_mask(&let_in, seconds);
}

void
signals_deliver_blocked(void)
{
	sigset_t held;
	sigprocmask(SIG_SETMASK, &let_in, &held);
	sigprocmask(SIG_SETMASK, &held, NULL);
}

void
signals_set_suspend_handler(bool note)
{
	struct sigaction now,
	    action = {.sa_handler = note ? on_terminal_signal : SIG_DFL};
	sigaction(SIGTSTP, NULL, &now);
	if (now.sa_handler != SIG_IGN)
		sigaction(SIGTSTP, &action, NULL);
}

void
signals_catch_terminal(struct sigaction was[static 3])
{
	struct sigaction action = {.sa_handler = on_terminal_signal};
	sigaction(SIGTSTP, NULL, &was[0]);
	sigaction(SIGCONT, &action, &was[1]);
	sigaction(SIGWINCH, &action, &was[2]);
	signals_set_suspend_handler(true);
}

void
signals_uncatch_terminal(const struct sigaction was[static 3])
{
	sigaction(SIGTSTP, &was[0], NULL);
	sigaction(SIGCONT, &was[1], NULL);
	sigaction(SIGWINCH, &was[2], NULL);
}

int
signals_take_terminal_events(void)
{
	int news = (stopped ? SIGNALS_STOP : 0) | (woken ? SIGNALS_WAKE : 0) |
		   (resized ? SIGNALS_SIZE : 0);
	stopped = woken = resized = 0;
	return news;
}

void
signals_suspend_program(void)
{
	struct sigaction was, usual = {.sa_handler = SIG_DFL};
	sigaction(SIGTSTP, &usual, &was);
	raise(SIGTSTP);
	signals_deliver_blocked();
	sigaction(SIGTSTP, &was, NULL);
}

int
signals_get_ending_or_interrupt(void)
{
	return ending != 0 ? ending : interrupted ? SIGINT : 0;
}

bool
signals_is_end_wanted(void)
{
	return ending != 0;
}

void
signals_clear_interrupt(void)
{
	interrupted = 0;
}

int
signals_exit_status(void)
{
	int signal = signals_get_ending_or_interrupt();
	return signal != 0 ? 128 + signal : 0;
}

bool
signals_usr1_since_last_call(void)
{
	bool was = asked != 0;
	asked = 0;
	return was;
}

void
signals_set_stop_on_key(bool keys)
{
	watching = keys;
}

bool
signals_is_stop_wanted(void)
{
	sigset_t held;
	struct pollfd in = {.fd = STDIN_FILENO, .events = POLLIN};
	if (signals_get_ending_or_interrupt() != 0)
		return true;
	sigpending(&held);
	return sigismember(&held, SIGINT) || sigismember(&held, SIGTERM) ||
	       sigismember(&held, SIGHUP) || (watching && poll(&in, 1, 0) > 0);
}
