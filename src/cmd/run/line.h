/* Lines of a session: it is made to run them, and drivers hand them in.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_LINE_H
#define TIPSPEED_CMD_RUN_LINE_H

#include "cmd/session/session.h"

struct session *session_new(FILE *out, FILE *notes);
void session_free(struct session *s);

/* Runs the commands of one line.  place names it in errors.  Stops at the first
 * error, and after a command that started a job, opened a script or asks for
 * the full screen: then *next is where to go on (an offset into line) after it,
 * otherwise 0. */
bool session_line(struct session *s, const char *line, size_t from,
    const char *file, int number, size_t *next, struct error *error);

#endif
