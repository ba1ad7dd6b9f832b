/* Every file that the program writes: replaced whole or not at all, or added
 * to at its end.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FS_FILE_H
#define TIPSPEED_IO_FS_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/error.h"

/* Permissions of a file that is new, before the umask; one that is there keeps
 * its own. */
enum file_rights { FILE_SHARED = 0666, FILE_PRIVATE = 0600 };

/* Replaces the content of path by n bytes.  They are written to a new file in
 * the same folder, which takes its name only when all of it is on the disk; a
 * symbolic link stays and the file that it points to is replaced.  Other than
 * regular files (/dev/null, a FIFO) are written to.  On failure false, an error
 * of kind ERROR_SYSTEM, and the old file untouched.  Only SIGKILL can leave the
 * new file behind, which the next call in that folder removes. */
bool file_replace(const char *path, enum file_rights rights, const char *bytes,
    size_t n, struct error *error);

/* The same with the output of write, collected in memory first. */
bool file_replace_by(const char *path, enum file_rights rights,
    void (*write)(const void *data, FILE *out), const void *data,
    struct error *error);

/* Adds n bytes to the end of a file, in one write where the system takes them
 * at once.  On failure false, an error of kind ERROR_SYSTEM, and the file as
 * long as it was. */
bool file_append(const char *path, enum file_rights rights, const char *bytes,
    size_t n, struct error *error);

/* False, with the same error as writing would give, where path is a folder or
 * may not be written: to be called before a long calibration. */
bool file_may_write(const char *path, struct error *error);

#endif
