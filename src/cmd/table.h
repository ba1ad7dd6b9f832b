/* The command table's parts, one file a group.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_TABLE_H
#define TIPSPEED_CMD_TABLE_H

#include "cmd/command.h"

/* Each ends with a name of NULL. */
extern const struct command TABLE_DATA[], TABLE_MODEL[], TABLE_FIT[],
    TABLE_ANSWERS[], TABLE_STORE[], TABLE_PICTURES[], TABLE_SESSION[];

#define LAST_OPTION                                      \
	{                                                \
		NULL, VALUE_TEXT, "", 0, 0, NULL, "", "" \
	}

#endif
