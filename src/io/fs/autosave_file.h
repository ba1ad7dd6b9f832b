/* Sessions that were not saved: a script for each program that had one, in
 * $XDG_STATE_HOME/tipspeed, by default in ~/.local/state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FS_AUTOSAVE_FILE_H
#define TIPSPEED_IO_FS_AUTOSAVE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

#include "base/error.h"

/* The file of this program. */
struct kept;

/* Makes no file yet, and cannot fail. */
struct kept *kept_new(void);

/* Closes the file, which is kept; the next write makes another file. */
void kept_close_file(struct kept *kept);

/* As kept_close_file, and frees kept; NULL is allowed. */
void kept_free(struct kept *kept);

/* Replaces the content of the file by what `write` prints, whole or not at all.
 * The first call makes the file, and removes the oldest files left by other
 * programs beyond a few.  False with an error of kind ERROR_SYSTEM. */
bool kept_write(struct kept *kept, void (*write)(const void *data, FILE *out),
    const void *data, struct error *error);

/* Removes the file, if there is one. */
void kept_remove(struct kept *kept);

/* A file that a program left: its first line, without "# ", and when it was
 * written. */
struct kept_file {
	char *path, *about;
	time_t when;
};

/* Returns the files of programs that have ended, newest first: [n], to be freed
 * by kept_files_free.  Empty files, of programs killed at the wrong moment, are
 * removed. */
struct kept_file *kept_files(size_t *n);
void kept_files_free(struct kept_file *file, size_t n);

#endif
