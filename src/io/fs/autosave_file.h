/* Unsaved sessions: a script for each run of the program, in
 * $XDG_STATE_HOME/tipspeed, by default in ~/.local/state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FS_AUTOSAVE_FILE_H
#define TIPSPEED_IO_FS_AUTOSAVE_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

#include "base/error.h"

/* The file of this run of the program. */
struct autosave_file;

/* Does not make the file yet, and cannot fail. */
struct autosave_file *autosave_file_new(void);

/* Closes the file and keeps it; the next write makes another file. */
void autosave_file_close(struct autosave_file *kept);

/* As autosave_file_close, and frees kept, which may be NULL. */
void autosave_file_free(struct autosave_file *kept);

/* Replaces the content of the file with what `write` prints, entirely or not at
 * all.  The first call makes the file, and removes all but the newest five
 * files of runs that have ended.  On failure, returns false with an error of
 * kind ERROR_SYSTEM. */
bool autosave_file_write(struct autosave_file *kept,
    void (*write)(const void *data, FILE *out), const void *data,
    struct error *error);

/* Removes the file, if there is one. */
void autosave_file_remove(struct autosave_file *kept);

/* A file that a run of the program has left.  about: its first line, without "#
 * "; when: the time it was written. */
struct autosave_left {
	char *path, *about;
	struct timespec when;
};

/* Returns the files of runs that have ended, [n], newest first.  Free with
 * autosave_left_free.  Removes empty files, left by programs that were killed
 * at the wrong moment. */
struct autosave_left *autosave_list_left_files(size_t *n);
void autosave_left_free(struct autosave_left *file, size_t n);

#endif
