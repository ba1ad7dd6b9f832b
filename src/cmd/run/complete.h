/* Completion at the cursor, from the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_COMPLETE_H
#define TIPSPEED_CMD_RUN_COMPLETE_H

#include <stddef.h>

#include "cmd/session/session.h"

/* One way to complete a word. */
struct candidate {
	/* As one would type it, with quotes if it needs them. */
	char *text;
	/* The character to add once it is chosen: a space, '=' after an option,
	 * or '\0' if the word goes on, as after a folder. */
	char append;
};

/* The candidates, sorted, without duplicates. */
struct completion {
	/* start: the offset in the line of the word that they replace, or of
	 * the part of it after '=' or a comma. */
	size_t start, n;
	struct candidate *candidate;
};

/* Returns the candidates at the cursor, an offset into the line.  Ignores the
 * text after it.  Reads the session and, for files, folders; changes nothing,
 * and cannot fail.  Free with completion_free. */
struct completion *find_completions_at_cursor(
    const struct session *s, const char *line, size_t cursor);
void completion_free(struct completion *completion);

#endif
