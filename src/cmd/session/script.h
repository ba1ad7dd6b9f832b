/* The scripts a session is reading, one within the other.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SCRIPT_H
#define TIPSPEED_CMD_SESSION_SCRIPT_H

#include <stdbool.h>
#include <stdio.h>

#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

/* Each opens a script within the one that is read now; the driver takes its
 * lines until it is at its end.  File: false where it cannot be read, or there
 * are 16 already.  Stream: borrowed.  Text: all its lines are called `line`. */
bool script_open(struct session *s, const char *path, struct error *error);
void script_open_stream(struct session *s, FILE *in, const char *name);
void script_open_text(
    struct session *s, const char *text, const char *name, int line);

/* The next line of the innermost, continued ones joined; the caller frees.
 * NULL at its end, which closes it, and where it cannot be read or is no text:
 * then with an error.  place is valid until the script is closed. */
char *script_line(struct session *s, struct place *place, struct error *error);

/* The which-th command of how many the line read last of the innermost is;
 * `of` 0 where that is not known, as of a stream. */
struct script_place {
	size_t at, of;
};
struct script_place script_place(const struct session *s);

/* Closes the innermost ones until `depth` are left. */
void script_close(struct session *s, size_t depth);

/* The error of a line that would not end; false. */
bool script_too_long(const char *name, int line, struct error *error);

/* Cuts the line end off; true when the line goes on (it ended in \). */
bool script_goes_on(char *line);

#endif
