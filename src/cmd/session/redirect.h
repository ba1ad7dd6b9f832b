/* Redirects the results of one command to a file or a shell command.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_REDIRECT_H
#define TIPSPEED_CMD_SESSION_REDIRECT_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

struct redirect;

/* True if the command has results for the file named by words.  Otherwise sets
 * an error that suggests what to write. */
bool redirect_is_allowed(const struct command *command,
    const struct words *words, struct error *error);

/* Starts to collect the session's results for the target of words, in the
 * format that the file name implies.  Returns NULL, with an error of kind
 * ERROR_SYSTEM, if the file cannot be written. */
struct redirect *redirect_open(struct session *s, const struct command *command,
    const struct words *words, struct error *error);

/* Restores the previous target.  keep: deliver the collected results, all or
 * none.  Returns false if delivery or the shell command failed. */
bool redirect_close(struct session *s, struct redirect *redirect, bool keep,
    struct error *error);

#endif
