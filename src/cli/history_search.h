/* PgUp and PgDn: the history searched for what stands before the cursor.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_HISTORY_SEARCH_H
#define TIPSPEED_CLI_HISTORY_SEARCH_H

/* Puts searches of our own under readline's names, before the user's settings
 * are read; then under the keys that readline itself gave its own. */
void typed_search_names(void);
void typed_search_keys(void);

#endif
