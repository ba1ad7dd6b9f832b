/* The files that the session has read and written, so that its results do not
 * overwrite the sheets that they come from.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_FILES_H
#define TIPSPEED_CMD_SESSION_FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "cmd/session/session.h"

/* Call files_record_read when a command is about to read a file, and
 * files_record_written when it has written one. */
void files_record_read(struct session *s, const char *path);
void files_record_written(struct session *s, const char *path);

/* True if the session wrote this file, which is still there. */
bool files_is_written(const struct session *s, const char *path);

/* Notes the script that holds the session, because the session was saved to it,
 * if `saved`, or restored from it. */
void files_set_session_script_path(
    struct session *s, const char *path, bool saved);

/* Returns the script of files_set_session_script_path, or NULL.  *saved, unless
 * NULL: the session was saved to it. */
const char *files_session_script_path(const struct session *s, bool *saved);

/* True if the file can be replaced, or appended to, and is neither one that the
 * session has read (a sheet, script, envelope or the store), under whatever
 * name, nor the script that holds it.  Otherwise sets an error of kind
 * ERROR_SYSTEM. */
bool files_may_write(const struct session *s, const char *path, bool append,
    struct error *error);

/* Returns false, with an error of kind ERROR_USAGE, if the file exists and the
 * call does not say replace=on. */
bool files_check_replace(
    const struct args *args, const char *path, struct error *error);

/* file_check_csv_name, files_may_write and files_check_replace. */
bool files_may_overwrite(const struct session *s, const struct args *args,
    const char *path, struct error *error);

/* Writes a site file, if files_may_overwrite, and says so. */
bool files_write_site(struct session *s, const struct args *args,
    const struct site *site, const char *path, struct error *error);

/* Asks the user before a file is replaced that the session did not write.
 * Returns false with an error if the user declines.  Never in a script. */
bool files_confirm_replace(
    struct session *s, const char *path, struct error *error);

/* Computes the digest of a file's bytes.  Returns false if it is not a regular
 * file or cannot be read. */
bool files_compute_digest(const char *path, uint64_t *digest);

/* files_count_all_uses returns how many times files were read or written;
 * files_path_of_nth_read returns the path of use `number`, from 0, and its
 * digest then, or NULL if it was a write, has no digest, or was read again
 * later. */
size_t files_count_all_uses(const struct session *s);
const char *files_path_of_nth_read(
    const struct session *s, size_t number, uint64_t *digest);

struct files *files_new(void);
void files_free(struct files *files);

#endif
