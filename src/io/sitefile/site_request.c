/* Frees the questions about a sheet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_request.h"

#include <stdlib.h>

void
site_ask_clear(struct site_ask *ask)
{
	for (size_t i = 0; i < ask->n; i++) {
		free(ask->column[i].head);
		free(ask->column[i].values);
		free(ask->column[i].guess);
	}
	free(ask->column);
	free(ask->settle);
	*ask = (struct site_ask){0};
}
