/* A command in progress, from its first word to the end of its job or script.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_TURN_H
#define TIPSPEED_CMD_SESSION_TURN_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

struct invocation;

/* Called before a command runs.  Returns false if its results cannot be sent to
 * their target. */
bool invocation_begin(struct session *s, const struct args *args,
    const struct words *words, struct place place, struct error *error);

/* Called when the innermost command's function has returned.  Lines run before
 * then are nested invocations. */
void invocation_set_ran(struct session *s);

/* True if the innermost command's function has returned and none of its jobs
 * and scripts remain. */
bool invocation_is_over(const struct session *s);

/* Notes that the job was stopped after `steps` steps, so that a saved script
 * will stop it there; 0: the job gave no result. */
void invocation_stopped(struct session *s, size_t steps);

/* Makes the running command's changes part of the previous undo step. */
void invocation_join_undo(struct session *s);

/* Adds options, " digest=HEX", to the running command's line in the journal. */
void invocation_add_options(struct session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Replaces the running command's line in the journal. */
void invocation_reads(struct session *s, const char *line);

/* Makes the running command fail at its end but keep its results, which cover
 * only part of the request. */
void invocation_fails(struct session *s, const struct error *error);

/* Notes that, if the running command succeeds, the session will be saved in a
 * file of the user's. */
void invocation_saved(struct session *s);

/* Saves the line of a question that ran without an invocation of its own; it
 * replaces an immediately preceding line of that command. */
void invocation_asked(struct session *s, const char *command, const char *line);

/* Ends the innermost command and delivers its results.  ok: it succeeded;
 * otherwise error gives the reason and is preserved.  Returns false if it
 * failed or the results could not be delivered. */
bool invocation_end(struct session *s, bool ok, struct error *error);

/* Ends the commands whose job or script has ended.  session_line does so before
 * the next command; a driver that does not continue the line calls this.  ok:
 * they succeeded. */
bool session_end_finished_commands(
    struct session *s, bool ok, struct error *error);

#endif
