/* Redirects the results of one command into a file or a shell command.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_REDIRECT_H
#define TIPSPEED_CMD_SESSION_REDIRECT_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

struct redirect;

/* True if the command has results for the file that the words name; else an
 * error that says what to write instead. */
bool redirect_allowed(const struct command *command, const struct words *words,
    struct error *error);

/* From now on collects the session's results for the target of words, in the
 * format that the file's name asks for.  NULL, with an error of kind
 * ERROR_SYSTEM, where the file cannot be written. */
struct redirect *redirect_open(struct session *s, const struct command *command,
    const struct words *words, struct error *error);

/* Sends results where they were sent before.  keep: the collected results are
 * delivered, all or none of them.  False if delivery or the shell command
 * failed. */
bool redirect_close(struct session *s, struct redirect *redirect, bool keep,
    struct error *error);

#endif
