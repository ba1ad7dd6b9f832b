/* Creates sessions and runs the lines that drivers pass to them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_LINE_H
#define TIPSPEED_CMD_RUN_LINE_H

#include "cmd/session/session.h"

struct session *session_new(FILE *out, FILE *notes);
void session_free(struct session *s);

/* Runs the commands in one line, from the offset `from`.  file, number: where
 * the line is, for errors.  Stops at the first error, and after a command that
 * started a job, opened a script or asked for the full screen: *next is then
 * the offset at which to continue, otherwise 0. */
bool session_run_line(struct session *s, const char *line, size_t from,
    const char *file, int number, size_t *next, struct error *error);

#endif
