/* The parts of a zip archive, which is what workbooks are.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_ARCHIVE_H
#define TIPSPEED_IO_CELLS_ARCHIVE_H

#include <stdbool.h>
#include <stddef.h>

/* An archive in memory.  Of all its parts 50 MB are unpacked at most, so that a
 * small file cannot fill the memory. */
struct archive;

/* bytes [n] are borrowed.  NULL where they are no zip archive, with the reason
 * in *wrong, which the caller frees. */
struct archive *archive_open(const char *bytes, size_t n, char **wrong);
void archive_close(struct archive *archive);

/* Whether there is a part of that name, ignoring case. */
bool archive_has(const struct archive *archive, const char *name);

/* The unpacked size of its parts in bytes, as the archive states it. */
double archive_unpacked(const struct archive *archive);

/* A part, *n bytes and a NUL, which the caller frees.  NULL, with *wrong as
 * above, where there is none or it is locked, damaged or too large. */
char *archive_part(
    struct archive *archive, const char *name, size_t *n, char **wrong);

#endif
