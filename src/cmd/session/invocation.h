/* A command in progress, from its first word until its job or script has ended.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_INVOCATION_H
#define TIPSPEED_CMD_SESSION_INVOCATION_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

struct redirect;
struct snapshot;

/* A command in progress, and what is needed at its end.  Invocations nest: the
 * commands of a script run within that of `source`. */
struct invocation {
	struct invocation *outer;
	const struct command *command;
	struct redirect *redirect; /* or NULL */
	struct place place;
	int column;              /* of the redirection, or of the command */
	char *label, *line;      /* as typed; for the journal */
	struct snapshot *before; /* or NULL if it changes nothing */
	size_t state;            /* of the journal when it began */
	size_t steps;            /* that could be undone when it began */
	size_t uses;             /* of files until it began */
	struct last_asked asked; /* when it began */
	double fed;   /* m/s: the feed of the latest prediction then, or NAN */
	bool joins;   /* is undone with the step before */
	bool stopped; /* its calibration was stopped */
	size_t stopped_at; /* after so many steps; 0: no result */
	/* Makes it fail at its end; the results are kept, but lack a part. */
	struct error late;
	double started; /* session_clock_seconds */
	bool timed;
	bool running; /* its function has not returned */
	/* If it succeeds, the session is in a file of the user's. */
	bool saved;
	size_t scripts; /* that were open when it began */
};

/* Called before a command runs.  Returns false with an error if its results
 * cannot be sent to their target, or if --safe forbids it. */
bool invocation_begin(struct session *s, const struct args *args,
    const struct words *words, struct place place, struct error *error);

/* True if the function of the innermost command has returned, and neither a job
 * nor a script of its own is left. */
bool invocation_is_over(const struct session *s);

/* Notes that the job was stopped after so many steps, so that a saved script
 * stops it there too; 0: it gave no result. */
void invocation_set_job_stopped(struct session *s, size_t steps);

/* Appends options, such as " digest=HEX", to the line that the journal will
 * have of the running command. */
void invocation_add_journal_options(struct session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds to the journal the line of a prediction that no command asked for, see
 * journal_add_slider_line. */
void invocation_journal_prediction(struct session *s, const char *line);

/* Ends the innermost command, and writes its results where they go.  ok: the
 * command succeeded; otherwise the error says why not, and is kept.  Returns
 * false if it failed or the results could not be written. */
bool invocation_end(struct session *s, bool ok, struct error *error);

/* Ends the commands whose job or script has ended.  session_run_line does so
 * before the next command; a driver that does not continue the line calls this.
 * ok: the commands succeeded. */
bool session_end_finished_commands(
    struct session *s, bool ok, struct error *error);

#endif
