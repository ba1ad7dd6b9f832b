/* The history: lines typed at the prompt, kept from one session to the next.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_HISTORY_H
#define TIPSPEED_CLI_HISTORY_H

#include <stdbool.h>

/* Reads the history into readline.  If it cannot be read or written, prints one
 * remark to stderr and keeps lines only in memory, as without with_file. */
void typed_history_open(bool with_file);

/* Adds a line, in memory and at the end of the file.  Called before the line is
 * run, so that it is kept however the program ends.  Lines of simultaneous
 * sessions are in the order in which they were typed. */
void typed_history_add(const char *line);

void typed_history_close(void);

/* True if the history is open. */
bool typed_history_is_open(void);

/* PgUp and PgDn search the history for the text before the cursor:
 * history_search_name_functions gives our searches readline's names for them,
 * before the user's settings are read; history_search_bind_keys, after the
 * settings, the keys that readline uses for its own searches. */
void history_search_name_functions(void);
void history_search_bind_keys(void);

#endif
