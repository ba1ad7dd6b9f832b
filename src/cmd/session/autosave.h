/* Keeps the unsaved part of a session, so that it is not lost however the
 * program ends.  Drivers with a user at a terminal call autosave_begin first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_AUTOSAVE_H
#define TIPSPEED_CMD_SESSION_AUTOSAVE_H

#include <stdbool.h>

#include "base/error.h"
#include "cmd/session/session.h"

/* Starts autosaving: from now on, after each command that changes something,
 * the session is written to a file in the user's folder, see autosave_file.h,
 * until it is saved.  Its current state counts as saved.  Nothing is written
 * with --safe, or where the store is to leave no trace.  Returns what to say
 * about the last session, or NULL; the caller frees. */
char *autosave_begin(struct session *s);

/* Called after each command.  saved: a file of the user's now contains the
 * session. */
void autosave_after_command(struct session *s, bool ok, bool saved);

/* Called at the session's end; notes an error if the session could not be
 * kept. */
void autosave_end(struct session *s);

/* Returns the path of the newest unsaved session, which the command that runs
 * restores, after which the file is removed.  NULL with an error where there is
 * none; the caller frees. */
char *autosave_last(struct session *s, struct error *error);

/* Lists the sessions that can be restored.  Returns true. */
bool autosave_list(struct session *s);

#endif
