/* PgUp and PgDn: search the history for the text before the cursor.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_HISTORY_SEARCH_H
#define TIPSPEED_CLI_HISTORY_SEARCH_H

/* history_search_name_functions gives our searches readline's names for them,
 * before the user's settings are read; history_search_bind_keys, after the
 * settings, the keys that readline uses for its own searches. */
void history_search_name_functions(void);
void history_search_bind_keys(void);

#endif
