/* Prepares the bytes that signal handlers write, because a handler must not
 * allocate memory or call ncurses.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/restore.h"

#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

#include <curses.h>

#include "base/xalloc.h"

/* Signals that end a program that does not catch them; TERM, HUP and INT are
 * caught. */
static const int FAULTS[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGQUIT,
    SIGSYS, SIGTRAP, SIGXCPU, SIGALRM, SIGUSR2};

/* The bytes that turn the mouse off. */
#define MOUSE_OFF "\033[?1002l\033[?1000l\033[?1006l"

static struct {
	volatile sig_atomic_t open;
	struct termios usual;
	/* full: the full screen is open; messages on it go with it. */
	bool known, full;
	char bytes[256];
	size_t n;
	struct sigaction was[ARRAY_LEN(FAULTS)];
	/* For a fault caused by an overflow of the usual stack. */
	char stack[16384];
} terminal;

static void
restore_terminal(void)
{
	if (!terminal.open)
		return;
	terminal.open = 0;
	/* A program in the background would be stopped when it sets the
	 * terminal. */
	sigset_t out;
	sigemptyset(&out);
	sigaddset(&out, SIGTTOU);
	sigprocmask(SIG_BLOCK, &out, NULL);
	ssize_t written = write(STDOUT_FILENO, terminal.bytes, terminal.n);
	(void)written;
	if (terminal.known)
		tcsetattr(STDIN_FILENO, TCSADRAIN, &terminal.usual);
}

static void
on_fatal_signal(int signal)
{
	restore_terminal();
	struct sigaction usual = {.sa_handler = SIG_DFL};
	sigaction(signal, &usual, NULL);
	raise(signal);
}

/* Called at exit.  The only exit with the terminal in use is that of xalloc. */
static void
on_exit_restore_terminal(void)
{
	static const char say[] =
	    "tipspeed: ended with its screen open: out of memory\n";
	if (!terminal.open)
		return;
	restore_terminal();
	ssize_t written =
	    terminal.full ? write(STDERR_FILENO, say, sizeof say - 1) : 0;
	(void)written;
}

void
terminal_record_settings(void)
{
	terminal.known = tcgetattr(STDIN_FILENO, &terminal.usual) == 0;
}

/* Adds bytes, without the pauses "$<..>" that old terminals needed. */
static void
add_terminal_reset_bytes(const char *text)
{
	if (text == NULL || text == (const char *)-1)
		return;
	while (*text != '\0' && terminal.n < sizeof terminal.bytes) {
		const char *end =
		    strncmp(text, "$<", 2) == 0 ? strchr(text, '>') : NULL;
		if (end != NULL)
			text = end + 1;
		else
			terminal.bytes[terminal.n++] = *text++;
	}
}

static void
catch_fatal_signals(void)
{
	static bool asked;
	stack_t stack = {
	    .ss_sp = terminal.stack, .ss_size = sizeof terminal.stack};
	sigaltstack(&stack, NULL);
	struct sigaction action = {
	    .sa_handler = on_fatal_signal, .sa_flags = (int)SA_ONSTACK};
	sigemptyset(&action.sa_mask);
	for (size_t i = 0; i < ARRAY_LEN(FAULTS); i++) {
		sigaction(FAULTS[i], &action, &terminal.was[i]);
		if (terminal.was[i].sa_handler == SIG_IGN)
			sigaction(FAULTS[i], &terminal.was[i], NULL);
	}
	if (!asked)
		atexit(on_exit_restore_terminal);
	asked = true;
	terminal.open = 1;
}

void
restore_arm_tty_for_screen(void)
{
	terminal.n = 0;
	terminal.full = true;
	if (tigetstr("kmous") != NULL && tigetstr("kmous") != (char *)-1)
		add_terminal_reset_bytes(MOUSE_OFF);
	const char *cup = tigetstr("cup");
	if (strncmp(cup, "\033[", 2) == 0)
		add_terminal_reset_bytes("\033[?2004l");
	add_terminal_reset_bytes(tigetstr("rmkx"));
	add_terminal_reset_bytes(tigetstr("sgr0"));
	add_terminal_reset_bytes(tigetstr("cnorm"));
	if (tigetstr("rmcup") != NULL)
		add_terminal_reset_bytes(tigetstr("rmcup"));
	else
		add_terminal_reset_bytes(tparm(tigetstr("cup"), LINES - 1, 0));
	add_terminal_reset_bytes("\r\n");
	catch_fatal_signals();
}

void
restore_arm_tty_for_prompt(const char *bytes)
{
	terminal_record_settings();
	terminal.n = 0;
	terminal.full = false;
	add_terminal_reset_bytes(bytes);
	catch_fatal_signals();
}

void
restore_disarm_tty(void)
{
	terminal.open = 0;
	for (size_t i = 0; i < ARRAY_LEN(FAULTS); i++)
		sigaction(FAULTS[i], &terminal.was[i], NULL);
}

void
restore_reset_terminal(void)
{
	static const char bytes[] =
	    MOUSE_OFF "\033[?1l\033>\033[?2004l\033[0m\033[?25h\033[?1049l\r";
	struct termios t;
	ssize_t written = write(STDOUT_FILENO, bytes, sizeof bytes - 1);
	(void)written;
	if (tcgetattr(STDIN_FILENO, &t) != 0)
		return;
	t.c_iflag |= ICRNL | BRKINT | IXON;
	t.c_iflag &= ~(tcflag_t)(INLCR | IGNCR);
	t.c_oflag |= OPOST | ONLCR;
	t.c_lflag |= ISIG | ICANON | IEXTEN | ECHO | ECHOE | ECHOK;
	t.c_cc[VINTR] = 3;
	t.c_cc[VQUIT] = 28;
	t.c_cc[VEOF] = 4;
	t.c_cc[VSUSP] = 26;
	t.c_cc[VLNEXT] = 22;
	t.c_cc[VDISCARD] = 15;
	t.c_cc[VMIN] = 1;
	t.c_cc[VTIME] = 0;
	tcsetattr(STDIN_FILENO, TCSANOW, &t);
}
