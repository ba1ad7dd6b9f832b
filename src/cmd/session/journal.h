/* The journal: the lines of a script that led to the session's state and
 * results.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_JOURNAL_H
#define TIPSPEED_CMD_SESSION_JOURNAL_H

#include <stddef.h>
#include <stdint.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"
#include "io/sitefile/site_request.h"

/* A place in the journal.  start: the place after the last reset.  state:
 * number of the session's state at the place, which undo and redo restore. */
struct mark {
	size_t n, start, state;
};

struct mark journal_current_place(const struct session *s);

/* Lines removed from the end of the journal, to be put back later. */
struct removed_lines {
	size_t n;
	char **line;
	struct mark from, to; /* places before and after the lines */
};

struct removed_lines journal_remove_lines_after(
    struct session *s, struct mark mark);
void journal_put_back_lines(struct session *s, struct removed_lines *tail);
void removed_lines_free(struct removed_lines *tail);

/* Adds a line.  latest: the name of a command whose line is replaced if it is
 * the last; or NULL. */
void journal_add_line(struct session *s, const char *latest, const char *line,
    ...) __attribute__((format(printf, 3, 4)));

/* Adds, before the line of a command, a line that checks by digest that the
 * file to be read is unchanged.  latest: see journal_add_line. */
void journal_add_file_check(
    struct session *s, const char *latest, const char *path, uint64_t digest);

/* Gives the session's state a new number. */
void journal_number_new_state(struct session *s);

/* Discards all earlier lines, which are no longer part of the session. */
void journal_discard_all_lines(struct session *s);

/* Adds lines for the options of the command line. */
void journal_add_settings(struct session *s);

/* Appends " WORD" to a line, quoted if necessary. */
void journal_append_word(char **line, const char *word);

/* Returns the call as a line that means the same in any folder and script: full
 * name, absolute paths.  It omits pause=, which is added later with the actual
 * step at which the job stopped.  The caller frees it. */
char *journal_line_of_call(const struct args *args, const struct words *words);

/* Returns "load FILE@SPEED.. digest=HEX" for what was read from n files.
 * speed: of the samples in each file, m/s, or 0; or NULL. */
char *journal_load_line(
    uint64_t digest, size_t n, const char *const *path, const double *speed);

/* Returns the options of a request as they are typed, " sheet=\"B\" top=16".
 * The caller frees it. */
char *journal_load_options_text(const struct site_request *request);

/* Returns the call as typed, with the command's full name.  The caller frees
 * it. */
char *journal_call_as_typed(
    const struct command *command, const struct words *words);

/* Returns false with an error if a file name contains bytes that a script
 * cannot contain. */
bool journal_can_be_saved(const struct session *s, struct error *error);

/* Prints the session as a script, without the heading. */
void journal_write_script(const struct session *s, FILE *out);

struct journal *journal_new(void);
void journal_free(struct journal *journal);

#endif
