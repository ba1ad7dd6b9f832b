/* What of a session was not saved, kept so that nothing that ends the program
 * loses it.  The drivers with somebody at a terminal begin with it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_AUTOSAVE_H
#define TIPSPEED_CMD_SESSION_AUTOSAVE_H

#include <stdbool.h>

#include "base/error.h"
#include "cmd/session/session.h"

/* From now on each command that changes something has the session written to a
 * file in the user's folder, see autosave_file.h, until it is saved.  Its
 * current state counts as saved.  Nothing is kept with --safe and where the
 * store is to leave no trace.  Returns what to say of the last session, or
 * NULL; the caller frees. */
char *keep_begin(struct session *s);

/* A command is over; saved: a file of the user's has the session. */
void keep_turn(struct session *s, bool ok, bool saved);

/* The session is over: says so where it could not be kept. */
void keep_end(struct session *s);

/* The newest file of a session that was not saved, to be restored by the
 * command that runs, after which it is removed.  NULL with an error where there
 * is none; the caller frees. */
char *keep_last(struct session *s, struct error *error);

/* Prints what there is to restore.  Returns true. */
bool keep_list(struct session *s);

#endif
