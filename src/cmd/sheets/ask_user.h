/* Asks the user about a sheet and interprets the answers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_ASK_USER_H
#define TIPSPEED_CMD_SHEETS_ASK_USER_H

#include "cmd/session/session.h"
#include "io/sitefile/site_request.h"

/* One question.  about: a sentence on the subject.  ask: the table shown with
 * the question has a row for each of its columns (n 0: no table); at: the
 * column asked about.  text: the question; offered: what an empty line means,
 * or ""; hint: other possible answers; wrong: why the last answer was not
 * accepted, or ""; first: this is the first question about the table. */
struct user_question {
	const char *about;
	const struct site_ask *ask;
	size_t at;
	const char *text, *offered, *hint, *wrong;
	bool first;
};

/* The user's answers, as options of load; NULL or 0 if not asked.  The caller
 * frees the texts. */
struct user_answers {
	char *columns, *samples, *sheet, *range;
	char decimal;
	double rotor, top; /* m, mm */
	bool month_first;
};

/* Asks, with session->hooks.ask, until all open questions are answered.
 * Returns false if there is no user or the user gives up.  trouble: the fault
 * that says what is open.  said: the answers so far, to which the new ones are
 * added. */
bool ask_open_questions(struct session *s, const struct site_ask *ask,
    const struct error *trouble, struct user_answers *said);

/* Asks whether the day or the month comes first in dates; the first letter
 * suffices.  Returns false if there is no user or the user gives up. */
bool ask_date_order(
    struct session *s, const struct error *trouble, bool *month_first);

/* Returns row 0..ask->n of the table as a line of at most `columns` screen
 * columns; row 0 has the headings.  Text that is too long ends in "..".  The
 * caller frees it. */
char *user_question_row_text(
    const struct user_question *q, size_t row, int columns);

#endif
