/* What led to the session's state and results, as lines of a script.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_JOURNAL_H
#define TIPSPEED_CMD_SESSION_JOURNAL_H

#include <stddef.h>
#include <stdint.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

/* A place in the journal; start: where the last reset left it.  state: the
 * number of what the session is like there, which undo and redo bring back. */
struct mark {
	size_t n, start, state;
};

struct mark journal_mark(const struct session *s);

/* Lines cut off the journal, to be put back. */
struct tail {
	size_t n;
	char **line;
	struct mark from, to; /* the journal before the lines and after them */
};

struct tail journal_cut(struct session *s, struct mark mark);
void journal_paste(struct session *s, struct tail *tail);
void tail_free(struct tail *tail);

/* Adds a line.  latest: the name of a command whose former line it replaces, if
 * that is the last; or NULL. */
void journal_add(struct session *s, const char *latest, const char *line, ...)
    __attribute__((format(printf, 3, 4)));

/* A line before that of a command: the file that it is about to read has to be
 * as it was, by a digest of its bytes.  latest: see journal_add. */
void journal_check(
    struct session *s, const char *latest, const char *path, uint64_t digest);

/* The session is as it never was before. */
void journal_changed(struct session *s);

/* What came before is no part of the session any more. */
void journal_restart(struct session *s);

/* Lines for what the command line has set. */
void journal_settings(struct session *s);

/* Appends " WORD" to a line, in quotes where it would not be read as one. */
void journal_word(char **line, const char *word);

/* The call as a line that means the same in any folder and script: full name,
 * absolute paths.  pause= is left out: it is put in as it turned out.  The
 * caller frees. */
char *journal_line(const struct args *args, const struct words *words);

/* "load FILE@SPEED.. digest=HEX" for a site that was read from n files, the
 * samples of each at a speed, m/s, where it was given (0). */
char *journal_load(const struct site *site, size_t n, const char *const *path,
    const double *speed);

/* The call as typed, with the command's full name.  The caller frees. */
char *journal_label(const struct command *command, const struct words *words);

/* Names of files may hold bytes that no script can: then false. */
bool journal_can_be_saved(const struct session *s, struct error *error);

/* The session as a script, but for a heading. */
void journal_put(const struct session *s, FILE *out);

struct journal *journal_new(void);
void journal_free(struct journal *journal);

#endif
