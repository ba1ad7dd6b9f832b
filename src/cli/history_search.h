/* PgUp and PgDn: search the history for the text before the cursor.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_HISTORY_SEARCH_H
#define TIPSPEED_CLI_HISTORY_SEARCH_H

/* typed_search_names binds our searches to readline's names, before the user's
 * settings are read; typed_search_keys binds them, after the settings, to the
 * keys that readline uses for its own searches. */
void typed_search_names(void);
void typed_search_keys(void);

#endif
