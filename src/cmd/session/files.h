/* The files that the session has read and written, so that results do not
 * overwrite the sheets behind them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_FILES_H
#define TIPSPEED_CMD_SESSION_FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "cmd/session/session.h"

/* files_note_read notes a file that a command is about to read;
 * files_note_written one that it has written. */
void files_note_read(struct session *s, const char *path);
void files_note_written(struct session *s, const char *path);

/* Notes the script that contains the session: it was saved to that script, if
 * saved, or else restored from it. */
void files_set_session_script(struct session *s, const char *path, bool saved);

/* Returns the script noted by files_set_session_script, or NULL; saved: out, or
 * NULL. */
const char *files_session_script(const struct session *s, bool *saved);

/* True if path is writable and is neither a file that the session has read
 * (sheet, script, envelope, store), under any name, nor the script that
 * contains it.  Otherwise sets an error of kind ERROR_SYSTEM. */
bool files_may_write(
    const struct session *s, const char *path, struct error *error);

/* As files_may_write, but false with an error of kind ERROR_USAGE also if the
 * file exists and the call does not have replace=on. */
bool files_may_overwrite(const struct session *s, const struct args *args,
    const char *path, struct error *error);

/* Asks the user before replacing a file that the session did not write.
 * Returns false with an error if the user declines.  Nothing is asked in a
 * script. */
bool files_confirm_replace(
    struct session *s, const char *path, struct error *error);

/* Computes the digest of a regular file's bytes.  Returns false if it cannot be
 * read. */
bool files_compute_digest(const char *path, uint64_t *digest);

/* files_count_uses returns how many times files were read or written;
 * files_path_if_read returns the path in use `number`, counted from 0, and
 * the digest at that time, or NULL if it was written, has no digest, or was
 * read again later. */
size_t files_count_uses(const struct session *s);
const char *files_path_if_read(
    const struct session *s, size_t number, uint64_t *digest);

void files_free(struct files *files);

#endif
