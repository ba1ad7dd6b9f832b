/* What comes next between a sheet and its answer, for the prompt.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_NEXT_H
#define TIPSPEED_CMD_RUN_NEXT_H

#include "cmd/session/session.h"

/* The one thing to do now, as a command line, NULL where there is no such one,
 * and a sentence for people: a question, or without a line what to type.
 * brief: of the line's commands next_told has what came of them.  stage: the
 * further on, the larger; of another fit it begins anew. */
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

/* words is NULL where there is nothing to say. */
struct next next_step(const struct session *s);

/* Says in a few lines what came of check, calibrate and validate. */
void next_told(const struct session *s);

#endif
