/* The scripts that a session is reading, one within the other.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SCRIPT_H
#define TIPSPEED_CMD_SESSION_SCRIPT_H

#include <stdbool.h>
#include <stdio.h>

#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

/* Open a script within the one being read; the driver reads it to its end.
 * script_open returns false with an error if the file cannot be read or 16
 * scripts are open.  script_open_stream borrows the stream.  script_open_text
 * reads lines that all have the number `line`. */
bool script_open(struct session *s, const char *path, struct error *error);
void script_open_stream(struct session *s, FILE *in, const char *name);
void script_open_text(
    struct session *s, const char *text, const char *name, int line);

/* Returns the next line of the innermost script, joined with its continuations;
 * the caller frees it.  At the end, closes the script and returns NULL.
 * Returns NULL with an error if the script cannot be read or is not text.
 * place is valid until the script is closed. */
char *script_read_line(
    struct session *s, struct place *place, struct error *error);

/* Returns the folder of the innermost script, if its name is `file` and it is a
 * file in another folder than the working one; else NULL.  The caller frees
 * it. */
char *script_other_folder(const struct session *s, const char *file);

/* Where the innermost script is: its last line read was command `at` of `of`;
 * `of` is 0 if that is not known, as for a stream. */
struct script_place {
	size_t at, of;
};
struct script_place script_command_position(const struct session *s);

/* Closes the innermost scripts until `depth` remain. */
void script_close_to_depth(struct session *s, size_t depth);

/* Sets the error for a line that is too long.  Returns false. */
bool script_set_error_long_line(
    const char *name, int line, struct error *error);

/* Removes the line break from a line, which begins at `from`, after those that
 * it continues.  Returns true if it ends in \, which becomes a space, and the
 * next one continues it.  A comment does not continue. */
bool script_remove_line_end(char *line, size_t from);

#endif
