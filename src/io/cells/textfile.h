/* A text file as a string of UTF-8, or what it is instead.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_TEXTFILE_H
#define TIPSPEED_IO_CELLS_TEXTFILE_H

#include <stdio.h>

#include "base/error.h"

/* Opens a file to read; also a pipe, after waiting a minute at most, or until a
 * signal, for a writer.  NULL with the reason in *why where it cannot be
 * opened, and for devices other than /dev/null, which may have no end. */
FILE *textfile_open(const char *path, const char **why);

/* All of a file of at most 10 MB, *n bytes, which the caller frees.  NULL and
 * one fault when it cannot be read (ERROR_SYSTEM) or is larger, which is seen
 * before it is read. */
char *textfile_bytes(const char *path, size_t *n, struct error_list *errors);

/* These bytes as UTF-8 with composed letters, see encoding.h, without a byte
 * order mark; the caller frees.  note: what to check where the encoding was
 * guessed, or "".  NULL and one fault when they are not text, or blank. */
char *textfile_text(const char *path, const char *bytes, size_t n,
    const char **note, struct error_list *errors);

/* Both of these in one, without the note. */
char *textfile_read(const char *path, struct error_list *errors);

/* The same for a file that the program itself may have written, up to 1000
 * MB. */
char *textfile_read_own(const char *path, struct error_list *errors);

/* The lines of a file that was made part of the program, up to NULL, as one
 * text, which the caller frees. */
char *textfile_lines(const char *const *line);

#endif
