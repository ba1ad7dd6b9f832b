/* The command table: its groups, in the order of help and manual.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

#include "base/xalloc.h"

static const struct command *const GROUPS[] = {TABLE_DATA, TABLE_FIT,
    TABLE_ANSWERS, TABLE_PICTURES, TABLE_STORE, TABLE_MODEL, TABLE_SESSION};

const struct command *
command_next(const struct command *after)
{
	bool take = after == NULL;
	for (size_t g = 0; g < ARRAY_LEN(GROUPS); g++)
		for (const struct command *c = GROUPS[g]; c->name != NULL;
		     c++) {
			if (take)
				return c;
			take = c == after;
		}
	return NULL;
}
