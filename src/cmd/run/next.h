/* The next step from a sheet to its answer, for the prompt.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_NEXT_H
#define TIPSPEED_CMD_RUN_NEXT_H

#include "cmd/session/session.h"

/* The next step. */
struct next {
	/* line: the commands to run, or NULL if there are none to suggest.
	 * words: a question about them or, without a line, what to type. */
	const char *line, *words;
	/* next_print_answer_summary shows what the commands found. */
	bool brief;
	/* How far the session has come; another fit sets it back. */
	enum {
		NEXT_LOAD,
		NEXT_CHECK,
		NEXT_CALIBRATE,
		NEXT_VALIDATE,
		NEXT_ANSWER
	} stage;
};

/* Returns the next step; its `words` are NULL if there is nothing to say. */
struct next suggest_next_step(const struct session *s);

/* Prints what check, calibrate and validate found, in a few lines. */
void next_print_answer_summary(const struct session *s);

#endif
