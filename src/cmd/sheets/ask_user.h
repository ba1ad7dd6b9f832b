/* Asks the user about a sheet, and interprets the answers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_ASK_USER_H
#define TIPSPEED_CMD_SHEETS_ASK_USER_H

#include "cmd/session/session.h"
#include "io/sitefile/site_request.h"

/* One question.  about: what it is about, a sentence.  ask: its columns are the
 * table shown with it (n 0: none); the question is about column `at`.  text:
 * the question; offered: the answer of an empty line, or "".  hint: other
 * possible answers.  wrong: why the last answer was not accepted, or "".
 * first: no question about the same table came before. */
struct inquiry {
	const char *about;
	const struct site_ask *ask;
	size_t at;
	const char *text, *offered, *hint, *wrong;
	bool first;
};

/* The user's answers, as options of load: the caller frees the texts; NULL and
 * zeros where nothing was asked. */
struct inquired {
	char *columns, *samples, *sheet, *range;
	char decimal;
	double rotor, top; /* m, mm */
};

/* Asks by session->hooks.question until everything open is answered; false if
 * there is no user, or the user gives up.  trouble: the fault that says what is
 * open.  said: zeroed by the caller. */
bool ask_open_question(struct session *s, const struct site_ask *ask,
    const struct error *trouble, struct inquired *said);

/* Asks which of two words is meant, "day" or "month"; their first letters will
 * do.  second: whether it is the second.  False if there is no user, or the
 * user gives up. */
bool ask_either(struct session *s, const struct error *trouble,
    const char *text, const char *const either[2], bool *second);

/* Returns row 0..ask->n of the table as a line of at most `columns` screen
 * columns, the heads first; text that is too long ends in "..".  The caller
 * frees. */
char *inquiry_row(const struct inquiry *q, size_t row, int columns);

#endif
