/* The history: lines typed at the prompt, kept from one session to the next.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_HISTORY_H
#define TIPSPEED_CLI_HISTORY_H

#include <stdbool.h>

/* Reads the history into readline.  If with_file is false, lines are kept only
 * in memory.  The same happens, after a remark on stderr, if the file cannot be
 * used. */
void typed_history_open(bool with_file);

/* Adds a line, in memory and at the end of the file.  Called before the line is
 * run, so that it is kept however the program ends.  Lines of simultaneous
 * sessions are in the order in which they were typed. */
void typed_history_add(const char *line);

void typed_history_close(void);

/* True if the history is open. */
bool typed_history_is_open(void);

/* For searches of the history for the text before the cursor, by PgUp and PgDn.
 * history_search_add_to_readline gives our searches the names of readline's,
 * before the user's settings are read; history_search_bind_keys gives them,
 * after that, the keys of readline's. */
void history_search_add_to_readline(void);
void history_search_bind_keys(void);

#endif
