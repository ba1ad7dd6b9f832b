/* Prints questions on standard error and reads answers from the terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/ask.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cli/signals.h"
#include "cli/terminal.h"

/* Signals that end the wait are let in only while it waits for input.
 * Otherwise, one that arrived just before the read would be recorded, and the
 * read would still wait.  ^Z works all the time. */
int
ask_wait_for_line(char **line)
{
	static const int ENDS[] = {SIGINT, SIGTERM, SIGHUP};
	sigset_t held, was;
	int first = EOF;
	unsigned char c = 0;
	sigemptyset(&held);
	for (size_t i = 0; i < ARRAY_LEN(ENDS); i++)
		sigaddset(&held, ENDS[i]);
	sigprocmask(SIG_BLOCK, &held, &was);
	while (c != '\n' && signals_get_ending_or_interrupt() == 0) {
		if (!signals_wait_for_input_with_mask(&was, INFINITY))
			continue;
		ssize_t got = read(STDIN_FILENO, &c, 1);
		if (got == 0 || (got < 0 && errno != EINTR))
			break;
		first = got > 0 && first == EOF ? c : first;
		if (got > 0 && c != '\n' && line != NULL)
			xappend(line, "%c", c);
	}
	sigprocmask(SIG_SETMASK, &was, NULL);
	return c == '\n' ? first : EOF;
}

bool
ask_confirm(struct session *s, const char *question, bool yes)
{
	(void)s;
	text_print_escaped(question, stderr);
	char y = tr_yes_letter(), n = tr_letter_for_no();
	fprintf(
	    stderr, " [%c/%c] ", yes ? toupper(y) : y, yes ? n : toupper(n));
	int c = ask_wait_for_line(NULL);
	if (c == EOF)
		fputc('\n', stderr);
	return tr_is_yes((char[]){(char)c, '\0'}) || (yes && c == '\n');
}

int
question_wrap_width(void)
{
	int rows, columns;
	terminal_size(&rows, &columns);
	return columns < 100 ? columns - 1 : 99;
}

/* Prints the table and what else stands above the questions about it. */
static void
print_table_above_questions(const struct user_question *q, int columns)
{
	text_print_wrapped(q->about, 0, columns, stderr);
	for (size_t r = 0; q->ask->n > 0 && r <= q->ask->n; r++) {
		FREED char *line = user_question_row_text(q, r, columns);
		text_print_escaped(line, stderr);
		fputc('\n', stderr);
	}
	if (q->ask->n == 0)
		return;
	text_print_wrapped(
	    q->ask->tables ? tr("Enter accepts what is in [ ]; or type the "
				"numbers of tables, such as 2 or 1-2, or "
				"cells, such as A5:B17; ^C gives up")
	    : q->ask->across
		? tr("Enter accepts what is in [ ], - leaves a line out, "
		     "^C gives up")
		: tr("Enter accepts what is in [ ], - leaves a column "
		     "out, ^C gives up"),
	    0, columns, stderr);
}

/* Prints on standard error, because the session's notes are held back until the
 * command ends. */
char *
ask_question_with_reader(struct session *s, const struct user_question *q,
    char *(*read)(const char *text))
{
	int columns = question_wrap_width();
	(void)s;
	if (q->wrong[0] != '\0')
		text_print_wrapped(q->wrong, 0, columns, stderr);
	if (q->first)
		print_table_above_questions(q, columns);
	fflush(stderr);
	bool offers = q->offered[0] != '\0';
	FREED char *asks = xasprintf("%s%s%s%s: ", q->text, offers ? " [" : "",
	    q->offered, offers ? "]" : "");
	char *shown = text_with_control_escaped(asks), *answer = read(shown);
	free(shown);
	return answer;
}

static char *
prompt_for_line(const char *text)
{
	text_print_escaped(text, stderr);
	char *line = xstrdup("");
	if (ask_wait_for_line(&line) != EOF && text_is_utf8(line, strlen(line)))
		return line;
	free(line);
	fputc('\n', stderr);
	return NULL;
}

char *
ask_question(struct session *s, const struct user_question *q)
{
	return ask_question_with_reader(s, q, prompt_for_line);
}
