/* Sends the results of one command to a file or to a shell command.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_REDIRECT_H
#define TIPSPEED_CMD_SESSION_REDIRECT_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

struct redirect;

/* True if the command has results of the kind that the file name in words asks
 * for.  Otherwise sets an error that says what to write instead. */
bool redirect_is_allowed(const struct command *command,
    const struct words *words, struct error *error);

/* Starts to collect the session's results for the file or shell command in
 * words, in the format that the file name implies.  Returns NULL, with an error
 * of kind ERROR_SYSTEM, if the file cannot be written. */
struct redirect *redirect_open(struct session *s, const struct command *command,
    const struct words *words, struct error *error);

/* Ends the redirection.  keep: write all that was collected, otherwise nothing.
 * Returns false if writing or the shell command failed. */
bool redirect_close(struct session *s, struct redirect *redirect, bool keep,
    struct error *error);

#endif
