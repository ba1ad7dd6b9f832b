/* What led to the session's state and results, as lines of a script.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_JOURNAL_H
#define TIPSPEED_CMD_SESSION_JOURNAL_H

#include <stddef.h>
#include <stdint.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

/* A place in the journal.  start: where the last reset left it.  state: number
 * of the session's state there, which undo and redo restore. */
struct mark {
	size_t n, start, state;
};

struct mark journal_place(const struct session *s);

/* Lines cut off the end of the journal, to be put back later. */
struct tail {
	size_t n;
	char **line;
	struct mark from, to; /* the journal before the lines and after them */
};

struct tail journal_cut_after(struct session *s, struct mark mark);
void journal_paste(struct session *s, struct tail *tail);
void tail_free(struct tail *tail);

/* Adds a line.  latest: the name of a command whose former line it replaces, if
 * that is the last; or NULL. */
void journal_add(struct session *s, const char *latest, const char *line, ...)
    __attribute__((format(printf, 3, 4)));

/* Adds, before the line of a command, a line that checks that the file the
 * command is about to read is unchanged, by a digest of its bytes.  latest: see
 * journal_add. */
void journal_check(
    struct session *s, const char *latest, const char *path, uint64_t digest);

/* Gives the session's state a new number. */
void journal_new_state(struct session *s);

/* What came before is no part of the session any more. */
void journal_restart(struct session *s);

/* Adds lines for what the command line has set. */
void journal_settings(struct session *s);

/* Appends " WORD" to a line, in quotes where it would not be read as one. */
void journal_append_word(char **line, const char *word);

/* Returns the call as a line that means the same in any folder and script: full
 * name, absolute paths.  pause= is left out; it is added with the step at which
 * the job did stop.  The caller frees. */
char *journal_line(const struct args *args, const struct words *words);

/* Returns "load FILE@SPEED.. digest=HEX" for a site read from n files; speed:
 * of the samples of each file, m/s, 0 where not given. */
char *journal_load(const struct site *site, size_t n, const char *const *path,
    const double *speed);

/* Returns the call as typed, with the command's full name.  The caller
 * frees. */
char *journal_label(const struct command *command, const struct words *words);

/* False with an error if a file name contains bytes that a script cannot. */
bool journal_can_be_saved(const struct session *s, struct error *error);

/* Prints the session as a script, without the heading. */
void journal_put(const struct session *s, FILE *out);

struct journal *journal_new(void);
void journal_free(struct journal *journal);

#endif
