/* The journal: the script that leads to the session's state and results.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_JOURNAL_H
#define TIPSPEED_CMD_SESSION_JOURNAL_H

#include <stddef.h>
#include <stdint.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"
#include "cmd/session/session.h"
#include "io/sitefile/site_request.h"

/* A place in the journal. */
struct mark {
	/* n: the number of lines.  start: the same at the last reset.  state:
	 * the number of the session's state, which undo and redo restore. */
	size_t n, start, state;
};

struct mark journal_current_place(const struct session *s);

/* Lines removed from the end of the journal, which may be put back later. */
struct removed_lines {
	size_t n;
	char **line;
	struct mark from, to; /* places before and after the lines */
};

struct removed_lines journal_remove_lines_after(
    struct session *s, struct mark mark);
void journal_restore_lines(struct session *s, struct removed_lines *tail);
void removed_lines_free(struct removed_lines *tail);

/* Adds a line.  If the last line is a call of the command `latest`, it is
 * replaced; latest may be NULL. */
void journal_add_line(struct session *s, const char *latest, const char *line,
    ...) __attribute__((format(printf, 3, 4)));

/* True if there is a last line, and it ends so. */
bool journal_last_line_ends(const struct session *s, const char *end);

/* Adds a line of the slider, a call of predict, in place of one that asked no
 * more than it does.  Other questions stay. */
void journal_add_slider_line(struct session *s, const char *line);

/* Adds a line that checks by its digest that a file is still the same, to come
 * before the line of the command that reads it.  latest: as for
 * journal_add_line. */
void journal_add_file_check(
    struct session *s, const char *latest, const char *path, uint64_t digest);

/* Gives the state of the session a new number. */
void journal_assign_state_number(struct session *s);

/* Starts anew: the lines so far are no longer part of the session. */
void journal_discard_all_lines(struct session *s);

/* Adds lines for what the command line of the program has set. */
void journal_add_settings(struct session *s);

/* Appends " WORD" to a line, quoted if necessary. */
void journal_append_quoted_word(char **line, const char *word);

/* Returns the call as a line that means the same in any folder and script: with
 * full name and absolute paths.  Leaves out pause=, which is added when the job
 * stops, with the step at which it does.  The caller frees it. */
char *journal_saved_command_text(
    const struct args *args, const struct words *words);

/* Returns "load FILE@SPEED.. digest=HEX" for what was read.  The caller frees
 * it. */
char *journal_load_command_text(
    uint64_t digest, const struct site_request *request);

/* Returns the call as typed, but with the full name of the command.  The caller
 * frees it. */
char *journal_typed_command_text(
    const struct command *command, const struct words *words);

/* Returns false with an error if a file name contains bytes that a script
 * cannot contain. */
bool journal_can_be_saved(const struct session *s, struct error *error);

/* Prints the session as a script, without its heading.  folder: that of the
 * script, as a path without links; files in it, or below it, are named relative
 * to it.  NULL: all are named by absolute paths. */
void journal_write_script(
    const struct session *s, const char *folder, FILE *out);

struct journal *journal_new(void);
void journal_free(struct journal *journal);

#endif
