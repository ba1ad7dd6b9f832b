/* Unsaved sessions: one script for each program run, in
 * $XDG_STATE_HOME/tipspeed, by default in ~/.local/state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FS_AUTOSAVE_FILE_H
#define TIPSPEED_IO_FS_AUTOSAVE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

#include "base/error.h"

/* The file of this program run. */
struct kept;

/* Makes no file yet, and cannot fail. */
struct kept *kept_new(void);

/* Closes the file and keeps it; the next write makes another file. */
void kept_close_file(struct kept *kept);

/* As kept_close_file, and frees kept, which may be NULL. */
void kept_free(struct kept *kept);

/* Replaces the content of the file with what `write` prints, entirely or not at
 * all.  The first call makes the file and removes all but the newest few left
 * by other runs.  On failure, returns false with an error of kind
 * ERROR_SYSTEM. */
bool kept_write(struct kept *kept, void (*write)(const void *data, FILE *out),
    const void *data, struct error *error);

/* Removes the file, if there is one. */
void kept_remove(struct kept *kept);

/* A file left by a program run.  about: its first line, without "# "; when: the
 * time it was written. */
struct kept_file {
	char *path, *about;
	time_t when;
};

/* Returns the files of runs that have ended, newest first: [n].  Free with
 * kept_files_free.  Removes empty files, left by programs killed at the wrong
 * moment. */
struct kept_file *kept_files(size_t *n);
void kept_files_free(struct kept_file *file, size_t n);

#endif
