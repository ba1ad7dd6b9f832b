/* The question of which tables on a sheet to read.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_ASK_TABLES_H
#define TIPSPEED_IO_SITEFILE_SITE_ASK_TABLES_H

#include "io/sitefile/classify.h"
#include "io/sitefile/site_request.h"

/* Tables [n] of one sheet in order, the columns of all, and the proposed range
 * of tables, first to last. */
struct tables {
	struct table *const *table;
	size_t n, first, last;
	const struct columns *all;
};

/* Proposes the tables that are most likely one site: the first with a feed, and
 * the tables of products next to it whose titles differ only in speed. */
void site_ask_tables_guess(struct tables *tables);

/* Fills *ask with the tables and the proposed range. */
void site_ask_tables_list(const struct tables *tables, struct site_ask *ask);

/* Returns the cells of a table, "A5:B17": its first n_row rows with the rows
 * above and, if these are all of its rows, those below.  The caller frees the
 * text. */
char *site_ask_table_range(const struct table *t, size_t n_row);

#endif
