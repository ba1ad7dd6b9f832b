/* A command under way: from its first word to the end of its job or script.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_TURN_H
#define TIPSPEED_CMD_SESSION_TURN_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

struct invocation;

/* Before a command runs.  False where its results cannot go where it says. */
bool invocation_begin(struct session *s, const struct args *args,
    const struct words *words, struct place place, struct error *error);

/* The innermost command itself has done its part.  Until then lines that it
 * runs are invocations within its own. */
void invocation_ran(struct session *s);

/* True when the innermost command has done its part, and has no job and no
 * script left. */
bool invocation_over(const struct session *s);

/* The job was stopped after so many steps: a saved script stops it there; 0: it
 * came to nothing. */
void invocation_stopped(struct session *s, size_t steps);

/* What the command that runs changes is undone with the step before it. */
void invocation_joins(struct session *s);

/* The command that runs is saved with this option, which it was not given. */
void invocation_adds(struct session *s, const char *option, const char *value);

/* The command that runs is saved as this line instead. */
void invocation_reads(struct session *s, const char *line);

/* The command that runs fails in the end, though its results stay: they are of
 * a part of what was asked. */
void invocation_fails(struct session *s, const struct error *error);

/* When the command that runs has done what it should, a file of the user's has
 * the session as it then is. */
void invocation_saved(struct session *s);

/* A command that only asked was done without an invocation of its own: its line
 * is saved instead of the one before of that name. */
void invocation_asked(struct session *s, const char *command, const char *line);

/* The innermost command is over: its results are handed over.  ok: it did what
 * it should; else error says why not, and is kept.  Returns false when it did
 * not, or the results could not be handed over. */
bool invocation_end(struct session *s, bool ok, struct error *error);

/* Ends the commands whose job or script is over; session_line does so before
 * the next command.  A driver that does not go on with the line calls
 * it. ok: they did what they should. */
bool session_settle(struct session *s, bool ok, struct error *error);

#endif
