/* Completion at the cursor, from the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_COMPLETE_H
#define TIPSPEED_CMD_RUN_COMPLETE_H

#include <stddef.h>

#include "cmd/session/session.h"

/* A candidate.  text: as typed, with quotes.  append: the character to add once
 * it is chosen: a space, '=' after an option, or '\0' if the word continues (a
 * folder). */
struct candidate {
	char *text;
	char append;
};

/* The candidates in alphabetical order, without duplicates.  start: offset in
 * the line of the word that they replace (or of its part after '=' or a
 * comma). */
struct completion {
	size_t start, n;
	struct candidate *candidate;
};

/* Returns the candidates at the cursor, an offset into line.  Text after the
 * cursor is ignored.  Reads the session and, for files, folders; changes
 * nothing and cannot fail.  Free with completion_free. */
struct completion *complete_at_cursor(
    const struct session *s, const char *line, size_t cursor);
void completion_free(struct completion *completion);

#endif
