/* Completion: what may stand at the cursor, from the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_COMPLETE_H
#define TIPSPEED_CMD_RUN_COMPLETE_H

#include <stddef.h>

#include "cmd/session/session.h"

/* One thing that may stand there.  text: as it is typed, with its quotes.
 * append: what comes next once it is chosen: a space, '=' after an option, or
 * '\0' where the word itself goes on (a folder). */
struct candidate {
	char *text;
	char append;
};

/* In the order of their text, each once.  start: offset in the line of the word
 * (or of the part of it, as after '=' or a comma) whose place they take. */
struct completion {
	size_t start, n;
	struct candidate *candidate;
};

/* What may stand at the cursor, an offset into line.  What is after the cursor
 * does not matter.  Reads the session and, for files, the folders; changes
 * nothing and cannot fail.  Free with completion_free. */
struct completion *complete(
    const struct session *s, const char *line, size_t cursor);
void completion_free(struct completion *completion);

#endif
