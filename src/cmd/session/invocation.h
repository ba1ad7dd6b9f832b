/* A command in progress, from its first word to the end of its job or script.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_INVOCATION_H
#define TIPSPEED_CMD_SESSION_INVOCATION_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

struct redirect;
struct snapshot;

/* A command, and what remains to be done at its end.  Invocations nest: the
 * commands of a script run within that of its source. */
struct invocation {
	struct invocation *outer;
	const struct command *command;
	struct redirect *redirect; /* or NULL */
	struct place place;
	int column;              /* of the redirection, or of the command */
	char *label, *line;      /* as typed; for the journal */
	struct snapshot *before; /* or NULL where it changes nothing */
	size_t state;            /* of the journal when it began */
	size_t steps;            /* that could be undone then */
	size_t uses;             /* of files by then */
	bool joins;              /* is undone with the step before */
	bool stopped;            /* its calibration was, after */
	size_t stopped_at;       /* so many steps; 0: without a result */
	struct error late;       /* makes it fail at its end; its results,
				  * which lack a part, are kept */
	double started;
	bool timed;
	bool running;   /* its function has not returned */
	bool saved;     /* if it succeeds, the session is in one of the user's
			 * files */
	size_t scripts; /* that were open when it began */
};

/* Called before a command runs.  Returns false if its results cannot be sent to
 * their target. */
bool invocation_begin(struct session *s, const struct args *args,
    const struct words *words, struct place place, struct error *error);

/* True if the innermost command's function has returned and none of its jobs
 * and scripts remain. */
bool invocation_is_over(const struct session *s);

/* Notes that the job was stopped after `steps` steps, so that a saved script
 * will stop it there; 0: the job gave no result. */
void invocation_note_job_stopped(struct session *s, size_t steps);

/* Adds options, " digest=HEX", to the running command's line in the journal. */
void invocation_journal_options(struct session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Saves the line of a question that ran without an invocation of its own; it
 * replaces an immediately preceding line of that command. */
void invocation_journal_question(
    struct session *s, const char *command, const char *line);

/* Ends the innermost command and delivers its results.  ok: it succeeded;
 * otherwise error gives the reason and is preserved.  Returns false if it
 * failed or the results could not be delivered. */
bool invocation_end(struct session *s, bool ok, struct error *error);

/* Ends the commands whose job or script has ended.  session_run_line does so
 * before the next command; a driver that does not continue the line calls this.
 * ok: they succeeded. */
bool session_end_finished_commands(
    struct session *s, bool ok, struct error *error);

#endif
