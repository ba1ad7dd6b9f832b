/* Writes files: replaces them entirely or not at all, and appends to them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FS_FILE_H
#define TIPSPEED_IO_FS_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/error.h"

/* Permissions of a new file, before the umask; an existing file keeps its
 * own. */
enum file_rights { FILE_SHARED = 0666, FILE_PRIVATE = 0600 };

/* Replaces the contents of a file with n bytes.  These are written to a new
 * file in the same folder, which is renamed to path only once all of them are
 * on disk.  A symbolic link is kept, and the file it points to is replaced.  A
 * path that is not a regular file (/dev/null, a FIFO) is written to directly.
 * On failure, returns false with an error of kind ERROR_SYSTEM and leaves the
 * old file untouched.  Only SIGKILL can leave the new file behind; the next
 * call in that folder removes it. */
bool file_replace_contents(const char *path, enum file_rights rights,
    const char *bytes, size_t n, struct error *error);

/* As file_replace_contents, with the text that `write` prints, which is
 * collected in memory first. */
bool file_replace_using_writer(const char *path, enum file_rights rights,
    void (*write)(const void *data, FILE *out), const void *data,
    struct error *error);

/* Appends n bytes to a file, in one write if the system accepts them all.  On
 * failure, returns false with an error of kind ERROR_SYSTEM, and leaves the
 * file as it was. */
bool file_append_bytes(const char *path, enum file_rights rights,
    const char *bytes, size_t n, struct error *error);

/* True if there is a file at the path, and not a folder. */
bool file_exists(const char *path);

/* Returns the part of a path after its folders; borrowed. */
const char *file_name_without_folders(const char *path);

/* Returns the folder of a file as an absolute path without links, or NULL if
 * there is no such folder.  The caller frees it. */
char *file_real_folder(const char *path);

/* True if a file's name ends like that of a sheet, as one of the words of
 * FILE_SHEET_ENDINGS. */
extern const char FILE_SHEET_ENDINGS[];
bool file_has_sheet_ending(const char *path);

/* Returns false with an error if a file's name ends like that of another form
 * than CSV: spreadsheet programs call text in a workbook damaged. */
bool file_check_csv_name(const char *path, struct error *error);

/* Returns false, with the error that replacing the file, or appending to it,
 * would give, if path is a folder or not writable.  To be called before a long
 * calibration. */
bool file_check_writable(const char *path, bool append, struct error *error);

#endif
