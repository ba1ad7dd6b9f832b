/* The next step from a sheet to its answer, for the prompt.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_NEXT_H
#define TIPSPEED_CMD_RUN_NEXT_H

#include "cmd/session/session.h"

/* The next step: a command line, or NULL if none fits, and a sentence for
 * people: a question or, without a line, what to type.  brief:
 * next_print_result_lines reports the results of the line's commands.  stage:
 * how far the session has progressed; another fit restarts it. */
struct next {
	const char *line, *words;
	bool brief;
	enum {
		NEXT_LOAD,
		NEXT_CHECK,
		NEXT_CALIBRATE,
		NEXT_VALIDATE,
		NEXT_ANSWER
	} stage;
};

/* Returns the next step; words is NULL if there is nothing to say. */
struct next next_step(const struct session *s);

/* Prints the results of check, calibrate and validate in a few lines. */
void next_print_result_lines(const struct session *s);

#endif
