/* Questions about a sheet, put to the user, and what the answers
 * mean.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_ASK_USER_H
#define TIPSPEED_CMD_SHEETS_ASK_USER_H

#include "cmd/session/session.h"
#include "io/sitefile/site_request.h"

/* One question.  about: what it is about, a sentence.  ask: its columns are the
 * table shown with it (n 0: none), of which `at` is asked about.  text: the
 * question; offered: what an empty line stands for, or "".  hint: what else may
 * be answered.  wrong: why the last answer was none, or "".  first: no question
 * of the same table came before. */
struct inquiry {
	const char *about;
	const struct site_ask *ask;
	size_t at;
	const char *text, *offered, *hint, *wrong;
	bool first;
};

/* What somebody said, as load's options have it: texts are the caller's, NULL
 * and zeros where nothing was asked. */
struct inquired {
	char *columns, *samples, *sheet, *range;
	char decimal;
	double rotor, top; /* m, mm */
};

/* Asks session->hooks.question until all that is open has an answer; false:
 * nobody is there, or has given up.  trouble: the fault that says what is open.
 * said: zeroed by the caller. */
bool inquire(struct session *s, const struct site_ask *ask,
    const struct error *trouble, struct inquired *said);

/* Asks which of two it is, "day" or "month", or their first letters; false:
 * nobody is there, or has given up.  second: whether it is the second. */
bool inquire_either(struct session *s, const struct error *trouble,
    const char *text, const char *const either[2], bool *second);

/* Row 0..ask->n of the table as a line of at most so many screen columns, the
 * heads first; what is too long ends in "..".  The caller frees. */
char *inquiry_row(const struct inquiry *q, size_t row, int columns);

#endif
