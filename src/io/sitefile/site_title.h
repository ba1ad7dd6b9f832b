/* The titles of tables: lines of words immediately above them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_TITLE_H
#define TIPSPEED_IO_SITEFILE_SITE_TITLE_H

#include "io/sitefile/classify.h"

/* Moves what lines outside the tables say of single samples, "S2: product at 65
 * m/s", into the headings S2, and takes these lines out of the layout. */
void title_take_key_of_samples(struct layout *layout);

/* Returns the table above which a line stands, below all earlier tables; NULL
 * if there is none. */
const struct table *title_table_below(
    const struct layout *layout, const struct row *row);

/* Returns the first day, "2026-05-03", stated in the lines between the earlier
 * tables and a table, or for NULL in all lines outside tables; NULL: none.
 * before: the day that an earlier call returned, which is then returned again,
 * or NULL.  differ: set if a line states another day.  The caller frees the
 * day. */
char *title_find_day(const struct layout *layout, const struct table *t,
    char *before, bool *differ);

/* True if a line above a further table of a sheet states its speed with a key:
 * lines above the first are then about the first alone. */
bool title_has_speed_per_table(const struct layout *layout);

/* Returns the meanings of the words around a table (its title, the name of its
 * sheet or of the file at path) that distinguish feed from product.  near: its
 * speed and rpm are set if the title states them. */
uint64_t title_words_and_speed(const struct layout *layout, struct table *t,
    const char *path, struct surroundings *near);

/* True if two titles contain different names of machines, days and the like:
 * each has some that the other lacks. */
bool title_names_differ(const char *a, const char *b);

/* True if the titles of two tables differ only in speed; the first may have
 * lines above that are about all of a sheet. */
bool title_differs_only_in_speed(const struct table *a, const struct table *b);

/* True if a title mentions limits or a mean, so the table has no sample. */
bool title_tells_limits_or_mean(const struct table *t);

/* Returns the line of the table's title that mentions the feed, or its last
 * line.  The caller frees it. */
char *title_feed_or_last_line(const struct table *t);

/* True if tables are one site although words in their titles may mean several:
 * one has the feed (not needed if parts), and each other one has a product,
 * with a title that differs from those of the other products only in a speed
 * with its unit. */
bool titles_are_speed_series(struct table *const *table, size_t n,
    const struct columns *all, bool parts);

/* True if each of several tables is a test, with its own feed and product and
 * with a speed stated in the title or the name of the sheet, and these differ
 * only in speeds, dates and test numbers. */
bool titles_are_separate_tests(
    struct table *const *table, size_t n, const struct columns *all);

#endif
