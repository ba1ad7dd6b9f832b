/* A command under way: from its first word to the end of its job or script.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_TURN_H
#define TIPSPEED_CMD_SESSION_TURN_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

struct invocation;

/* Called before a command runs.  False if its results cannot be sent to their
 * target. */
bool invocation_begin(struct session *s, const struct args *args,
    const struct words *words, struct place place, struct error *error);

/* Called when the innermost command's function has returned.  Lines run before
 * that are invocations within its own. */
void invocation_set_ran(struct session *s);

/* True when the innermost command's function has returned, and no job or script
 * of it is left. */
bool invocation_is_over(const struct session *s);

/* Notes that the job was stopped after `steps` steps, so that a saved script
 * stops it there; 0: the job gave no result. */
void invocation_stopped(struct session *s, size_t steps);

/* Makes the running command's changes part of the undo step before. */
void invocation_join_undo(struct session *s);

/* Saves the running command with this option, which it was not given. */
void invocation_adds(struct session *s, const char *option, const char *value);

/* Saves the running command as this line instead. */
void invocation_reads(struct session *s, const char *line);

/* Makes the running command fail at its end, although its results stay: they
 * cover a part of what was asked. */
void invocation_fails(struct session *s, const struct error *error);

/* Notes that once the running command succeeds, a file of the user's contains
 * the session as it then is. */
void invocation_saved(struct session *s);

/* Saves the line of a question that ran without an invocation of its own, in
 * place of a preceding line of that command. */
void invocation_asked(struct session *s, const char *command, const char *line);

/* Ends the innermost command and delivers its results.  ok: it succeeded; else
 * error says why not, and is kept.  Returns false if it failed, or the results
 * could not be delivered. */
bool invocation_end(struct session *s, bool ok, struct error *error);

/* Ends the commands whose job or script has ended; session_line does so before
 * the next command.  A driver that does not continue the line calls
 * session_settle.  ok: they succeeded. */
bool session_settle(struct session *s, bool ok, struct error *error);

#endif
