/* Reads the parts of a zip archive; workbooks are zip archives.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_ARCHIVE_H
#define TIPSPEED_IO_CELLS_ARCHIVE_H

#include <stdbool.h>
#include <stddef.h>

/* An archive in memory. */
struct archive;

/* What is unpacked of another's archive at most, in all, so that a small file
 * cannot exhaust memory. */
enum { ARCHIVE_MOST_BYTES = 50 * 1000 * 1000 };

/* Opens the archive in bytes [n], which must outlive it, to unpack at most so
 * many bytes.  Returns NULL if they are not a zip archive, with the reason in
 * *wrong, which the caller frees. */
struct archive *archive_open(
    const char *bytes, size_t n, size_t most, char **wrong);
void archive_close(struct archive *archive);

/* True if the archive contains a part with this name, ignoring case. */
bool archive_has_entry(const struct archive *archive, const char *name);

/* Returns the name of a part, counted from 0, or NULL after the last. */
const char *archive_entry_name(const struct archive *archive, size_t i);

/* Returns the total unpacked size of the parts, in bytes, as the archive states
 * it. */
double archive_unpacked_size(const struct archive *archive);

/* Returns the content of a part, *n bytes and a NUL, which the caller frees.
 * Returns NULL, with the reason in *wrong as above, if the part is missing,
 * encrypted, damaged or too large. */
char *archive_unpack_entry(
    struct archive *archive, const char *name, size_t *n, char **wrong);

#endif
