/* Compares the height of text with the screen and runs the user's pager.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/pager.h"

#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cli/signals.h"
#include "cli/terminal.h"

/* The status of a shell that cannot find a program. */
enum { NO_PROGRAM = 127 };

/* Returns how many rows a text takes, with long lines folded. */
static int
count_wrapped_rows(const char *text, int columns)
{
	int rows = 0;
	FREED char *copy = xstrdup(text);
	for (char *line = copy, *end; line[0] != '\0'; line = end) {
		end = line + strcspn(line, "\n");
		if (*end == '\n')
			*end++ = '\0';
		int width = text_width_in_columns(line);
		rows += width > 0 ? (width + columns - 1) / columns : 1;
	}
	return rows;
}

/* Returns the command of the pager: the user's or else less, which shows its
 * keys in the last row, ends with the text, and may neither write files nor run
 * commands.  The caller frees it. */
static char *
pager_command(void)
{
	const char *own = getenv("TIPSPEED_PAGER"), *any = getenv("PAGER");
	if (own != NULL || any != NULL)
		return xstrdup(own != NULL ? own : any);
	return xasprintf("command -v less >/dev/null || exit 127; "
			 "LESSSECURE=1 exec less -EFRX '-Ps%s'",
	    tr("space continues, q quits"));
}

/* A handler, because the pager would inherit SIG_IGN. */
static void
on_signal_left_to_pager(int signal)
{
	(void)signal;
}

/* Ignores ^C, which is for the pager, and SIGPIPE, because the pager may end
 * before everything is written. */
static void
leave_signals_to_pager(struct sigaction was[2])
{
	struct sigaction action = {
	    .sa_handler = on_signal_left_to_pager, .sa_flags = SA_RESTART};
	sigemptyset(&action.sa_mask);
	sigaction(SIGINT, &action, &was[0]);
	sigaction(SIGPIPE, &action, &was[1]);
}

static bool
run_pager(const char *command, const char *text)
{
	struct sigaction was[2];
	fflush(stdout);
	leave_signals_to_pager(was);
	FILE *in = popen(command, "w");
	int status = -1;
	if (in != NULL) {
		fputs(text, in);
		status = pclose(in);
	}
	sigaction(SIGINT, &was[0], NULL);
	sigaction(SIGPIPE, &was[1], NULL);
	return status >= 0 &&
	       !(WIFEXITED(status) && WEXITSTATUS(status) == NO_PROGRAM);
}

/* True if a line was typed ahead.  A pager would take its letters for keys of
 * its own, and the prompt would not get it. */
static bool
is_line_typed_ahead(void)
{
	struct pollfd typed = {.fd = STDIN_FILENO, .events = POLLIN};
	return poll(&typed, 1, 0) > 0 && (typed.revents & POLLIN) != 0;
}

void
pager_begin_capture(struct pager *pager, struct session *s)
{
	*pager = (struct pager){.session = s, .out = s->out, .notes = s->notes};
	s->out = pager->file = text_open_memory(&pager->text, &pager->n);
}

void
pager_hold_notes(struct pager *pager)
{
	if (pager != NULL && isatty(STDERR_FILENO))
		pager->session->notes = pager->file;
}

void
pager_show_new_output(struct pager *pager)
{
	if (pager == NULL)
		return;
	int rows, columns;
	pager->session->notes = pager->notes;
	fflush(pager->file);
	const char *text = pager->text + pager->shown;
	pager->shown = pager->n;
	terminal_size(&rows, &columns);
	FREED char *command = pager_command();
	/* The output of a script, or of a session being restored, is not
	 * paged. */
	bool paged = !pager->session->set.unpaged && !pager->session->safe &&
		     pager->session->scripts <= pager->session->typed_depth &&
		     command[0] != '\0' && !terminal_is_dumb();
	/* The prompt takes a row, too. */
	bool tall = paged && !signals_is_end_wanted() &&
		    !is_line_typed_ahead() &&
		    count_wrapped_rows(text, columns) >= rows;
	if (!tall || !run_pager(command, text))
		fputs(text, stdout);
	fflush(stdout);
}

void
pager_end_capture(struct pager *pager)
{
	pager->session->out = pager->out;
	fclose(pager->file);
	free(pager->text);
}
