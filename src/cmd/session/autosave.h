/* Autosaves a session, so that it is not lost however the program ends.
 * Drivers with a user at a terminal call autosave_begin first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_AUTOSAVE_H
#define TIPSPEED_CMD_SESSION_AUTOSAVE_H

#include <stdbool.h>

#include "base/error.h"
#include "cmd/session/session.h"

/* Starts autosaving: until the session is saved, each command that changes
 * something also writes it to a file in the user's folder (autosave_file.h).
 * The current state counts as saved.  Nothing is written with --safe or with a
 * store in memory.  Returns a message about the last session, or NULL.  The
 * caller frees it. */
char *autosave_begin(struct session *s);

/* Called after each command.  saved: the user has saved the session to a
 * file. */
void autosave_after_command(struct session *s, bool ok, bool saved);

/* Called when the session ends.  Prints an error if the session could not be
 * kept. */
void autosave_end(struct session *s);

/* Returns the path of the newest unsaved session, for the running command to
 * restore; the file is then removed.  Returns NULL with an error if there is
 * none.  The caller frees it. */
char *autosave_newest_path(struct session *s, struct error *error);

/* Lists the sessions that can be restored.  Returns true. */
bool autosave_show_list(struct session *s);

#endif
