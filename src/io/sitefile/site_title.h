/* The titles of tables: lines of words immediately above them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_TITLE_H
#define TIPSPEED_IO_SITEFILE_SITE_TITLE_H

#include "io/sitefile/classify.h"

/* Moves what lines outside the tables say of single samples, such as "S2:
 * product at 65 m/s", into the headings of these samples (here S2), and takes
 * the lines out of the layout. */
void title_move_lines_to_headings(struct layout *layout);

/* Returns the table that a line stands above, and below all earlier tables;
 * NULL if there is none. */
const struct table *title_find_table_below_line(
    const struct layout *layout, const struct row *row);

/* Returns the first day, "2026-05-03", stated in the lines between a table and
 * the tables above it; or, if t is NULL, in any line outside tables.  Returns
 * NULL if there is none.  before: the day that an earlier call returned, which
 * is then returned again, or NULL.  *differ becomes true if a line states
 * another day.  The caller frees the day. */
char *title_find_day(const struct layout *layout, const struct table *t,
    char *before, bool *differ);

/* True if a line above a second or later table of a sheet states its speed with
 * a key.  Then lines above the first table are about that one alone. */
bool title_has_speed_per_table(const struct layout *layout);

/* Returns the meanings of the words around a table (its title, the name of its
 * sheet or of the file at path) that tell feed from product.  Sets speed and
 * rpm of *near if the title states them. */
uint64_t title_read_role_and_speed(const struct layout *layout, struct table *t,
    const char *path, struct surroundings *near);

/* True if the titles of two tables differ only in speed.  Above the first there
 * may be further lines, about all of the sheet. */
bool title_differs_only_in_speed(const struct table *a, const struct table *b);

/* True if a table's title mentions limits or a mean, so that its numbers are
 * not samples. */
bool title_mentions_limits_or_mean(const struct table *t);

/* Returns the line of the table's title that mentions the feed, or its last
 * line.  The caller frees it. */
char *title_feed_or_last_line(const struct table *t);

/* True if tables are one site although words in their titles may mean several
 * sites: one has the feed (not needed if parts), and each of the others has one
 * product, with a title that differs from those of the other products only in a
 * speed with its unit.  Two tables may also be one with the feed and one with
 * all products. */
bool titles_are_speed_series(struct table *const *table, size_t n,
    const struct columns *all, bool parts);

/* True if each of several tables is a test with its own feed and product, and
 * its own speed, which the title or the name of the sheet states; and these
 * titles and names differ only in speeds, dates and test numbers. */
bool titles_are_separate_tests(
    struct table *const *table, size_t n, const struct columns *all);

#endif
