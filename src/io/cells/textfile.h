/* Reads a text file as a UTF-8 string, or reports why it cannot.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_TEXTFILE_H
#define TIPSPEED_IO_CELLS_TEXTFILE_H

#include <stdio.h>

#include "base/error.h"

/* Opens a file or a pipe for reading.  Waits at most a minute, or until a
 * signal, for something to be written to a pipe.  Returns NULL, with the reason
 * in *why, if the file cannot be opened or is a device other than /dev/null,
 * since a device may have no end. */
FILE *textfile_open(const char *path, const char **why);

/* Returns what to do about a file that cannot be read.  The caller frees it. */
char *textfile_hint_after_failed_open(const char *path);

/* The size of the largest file that is read.  TEXTFILE_SHEET: a user's sheet;
 * TEXTFILE_OWN: a file that the program itself may have written. */
enum textfile_bytes {
	TEXTFILE_SHEET = 10 * 1000 * 1000,
	TEXTFILE_OWN = 1000 * 1000 * 1000
};

/* Returns the content of a file of at most `most` bytes, *n bytes, which the
 * caller frees.  Returns NULL with one fault if the file cannot be read
 * (ERROR_SYSTEM) or is larger, which is checked before reading it. */
char *textfile_read_bytes(const char *path, enum textfile_bytes most, size_t *n,
    struct error_list *errors);

/* Returns the bytes as UTF-8 with composed letters (encoding.h), without a byte
 * order mark; the caller frees the text.  *note gets what to check if the
 * encoding was guessed, else "".  Returns NULL with one fault if the bytes are
 * not text or are blank. */
char *textfile_decode(const char *path, const char *bytes, size_t n,
    const char **note, struct error_list *errors);

/* Reads and decodes a file, as textfile_read_bytes and textfile_decode do. */
char *textfile_read(
    const char *path, enum textfile_bytes most, struct error_list *errors);

/* Joins the lines of a file built into the program; a NULL ends the list.  The
 * caller frees the text. */
char *textfile_join_built_in_lines(const char *const *line);

#endif
