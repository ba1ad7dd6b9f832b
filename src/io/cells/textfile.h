/* Reads a text file as a string of UTF-8, or reports why it is none.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_TEXTFILE_H
#define TIPSPEED_IO_CELLS_TEXTFILE_H

#include <stdio.h>

#include "base/error.h"

/* Opens a file or a pipe to read.  For a pipe it waits for a writer, at most a
 * minute or until a signal.  NULL, with the reason in *why, if the file cannot
 * be opened, and for devices other than /dev/null, which may have no end. */
FILE *textfile_open(const char *path, const char **why);

/* Returns the content of a file of at most 10 MB, *n bytes, which the caller
 * frees.  NULL and one fault if it cannot be read (ERROR_SYSTEM) or is larger,
 * which is found before it is read. */
char *textfile_bytes(const char *path, size_t *n, struct error_list *errors);

/* Returns the bytes as UTF-8 with composed letters, see encoding.h, without a
 * byte order mark; the caller frees.  note: what to check if the encoding was
 * guessed, or "".  NULL and one fault if they are not text, or blank. */
char *textfile_text(const char *path, const char *bytes, size_t n,
    const char **note, struct error_list *errors);

/* Calls textfile_bytes and textfile_text, without the note. */
char *textfile_read(const char *path, struct error_list *errors);

/* As textfile_read, for a file of up to 1000 MB that the program itself may
 * have written. */
char *textfile_read_own(const char *path, struct error_list *errors);

/* Joins the lines, up to NULL, of a file that was built into the program.  The
 * caller frees. */
char *textfile_lines(const char *const *line);

#endif
