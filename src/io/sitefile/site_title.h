/* The titles of tables: lines of words right above them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_TITLE_H
#define TIPSPEED_IO_SITEFILE_SITE_TITLE_H

#include "io/sitefile/classify.h"

/* Whether a line says which sample one of the layout's tables has. */
bool title_heads_any(const struct layout *layout, const struct row *row);

/* Returns the meanings of the words that stand next to a table and tell feed
 * from product: its title, the name of its sheet or file (path).  near: its
 * speed and rpm are set if the title states them. */
uint64_t title_context(const struct layout *layout, struct table *t,
    const char *path, struct surroundings *near);

/* Whether the names of machines, days and the like that two titles have differ:
 * each has some that the other lacks. */
bool title_names_differ(const char *a, const char *b);

/* Whether two tables have titles that differ in their speeds alone. */
bool title_is_like(const struct table *a, const struct table *b);

/* Whether a title names limits or a mean: such a table has no sample. */
bool title_is_limit(const struct table *t);

/* Returns the line of the table's title that names the feed, or its last.  The
 * caller frees. */
char *title_line(const struct table *t);

/* Whether tables are one site though their titles have words that may mean
 * several: one has the feed (of parts none need have it), and each other one a
 * product, with a title that differs from those of the other products in the
 * number with a unit of speed alone. */
bool title_is_series(struct table *const *table, size_t n,
    const struct columns *all, bool parts);

/* Whether each of several tables is a test: a feed and a product of its own,
 * with a speed that the title or the name of the sheet states; and these differ
 * in speeds, dates and numbers of tests alone. */
bool title_is_tests(
    struct table *const *table, size_t n, const struct columns *all);

#endif
