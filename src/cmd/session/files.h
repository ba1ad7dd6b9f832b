/* What the session has read and written: no result replaces a sheet that it was
 * made from.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_FILES_H
#define TIPSPEED_CMD_SESSION_FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "cmd/session/session.h"

/* Notes a file that a command is about to read, or has written. */
void files_reads(struct session *s, const char *path);
void files_wrote(struct session *s, const char *path);

/* Notes the script that holds the session: it was restored from it, or saved to
 * it. */
void files_holds(struct session *s, const char *path, bool saved);

/* That script, or NULL; saved: out, or NULL. */
const char *files_holder(const struct session *s, bool *saved);

/* True where path can be written and is nothing that the session has read
 * (sheet, script, envelope, store), by whatever name, nor holds it; else an
 * error of kind ERROR_SYSTEM. */
bool files_may_write(
    const struct session *s, const char *path, struct error *error);

/* The same of a file that is there already only where the call says replace=on;
 * else an error of kind ERROR_USAGE. */
bool files_may_overwrite(const struct session *s, const struct args *args,
    const char *path, struct error *error);

/* True unless path holds something that the session did not write, and somebody
 * who is asked wants to keep it.  Scripts are not asked for. */
bool files_may_replace(
    struct session *s, const char *path, struct error *error);

/* Digest of the bytes of a regular file; false where there is none to read. */
bool files_digest(const char *path, uint64_t *digest);

/* How many times a file was read so far, of which digests are known; and what
 * the one numbered i was then, i below that. */
size_t files_readings(const struct session *s);
const char *files_reading(const struct session *s, size_t i, uint64_t *digest);

void files_free(struct files *files);

#endif
