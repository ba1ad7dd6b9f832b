/* The question which of a sheet's tables are to be read.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_ASK_TABLES_H
#define TIPSPEED_IO_SITEFILE_SITE_ASK_TABLES_H

#include "io/sitefile/classify.h"
#include "io/sitefile/site_request.h"

/* Some tables [n] of one sheet in its order, the columns of all, and of those
 * tables the ones that are proposed, from the first to the last. */
struct tables {
	struct table *const *table;
	size_t n, first, last;
	const struct columns *all;
};

/* Proposes the tables that are most likely one site: the first with a feed, and
 * the tables of products next to it whose titles differ in their speeds
 * alone. */
void site_ask_tables_guess(struct tables *tables);

/* Fills *ask with the tables and the range of those that are proposed. */
void site_ask_tables_list(const struct tables *tables, struct site_ask *ask);

/* Returns the cells of a table as "A5:B17", of its first n_row rows with what
 * is above them, and below them where these are all.  The caller frees. */
char *site_ask_table_range(const struct table *t, size_t n_row);

#endif
