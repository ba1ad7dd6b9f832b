/* Keeps the unsaved session in a file, so that it is not lost however the
 * program ends.  Drivers with a user at a terminal call autosave_begin first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_AUTOSAVE_H
#define TIPSPEED_CMD_SESSION_AUTOSAVE_H

#include <stdbool.h>

#include "base/error.h"
#include "cmd/session/session.h"

/* Starts autosaving: until the session is saved, each command that changes
 * something also writes the session to a file in the user's folder
 * (autosave_file.h).  The current state counts as saved.  Does nothing with
 * --safe or with a store in memory.  Returns a message about the last unsaved
 * session, or NULL.  The caller frees it. */
char *autosave_begin(struct session *s);

/* Called after each command.  saved: the session has been saved to a file of
 * the user's. */
void autosave_after_command(struct session *s, bool ok, bool saved);

/* Called when the session ends.  Notes an error if the session could not be
 * kept. */
void autosave_end(struct session *s);

/* Returns the path of the newest unsaved session, which the running command is
 * about to restore; the file is removed once its session is kept elsewhere.
 * Returns NULL with an error if there is none.  The caller frees it. */
char *autosave_newest_path(struct session *s, struct error *error);

/* Shows the list of unsaved sessions.  Returns true. */
bool autosave_show_sessions(struct session *s);

#endif
