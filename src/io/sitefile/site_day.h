/* The days on which samples were taken, as their headings state them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_DAY_H
#define TIPSPEED_IO_SITEFILE_SITE_DAY_H

#include "io/sitefile/layout.h"

/* Returns the day, and the time if stated, on which the sample in column c of a
 * table was taken: "2026-05-03 10:15".  If it is not clear which number is the
 * day, returns it as the sheet has it, "5/3/2026 10:15".  Returns NULL if the
 * headings state no day, or two.  The caller frees it. */
char *site_day_of_sample(const struct table *t, size_t c);

/* Returns the day of column c, or its heading with a day, if that cannot be
 * read, such as "17/11/26"; else NULL.  The other function does so for a key
 * and its value above the tables. */
const char *site_find_unreadable_day(const struct table *t, size_t c);
const char *site_unreadable_day_of_line(const struct row *row);

/* Returns the column of a long table that has the day of each row's sample, or
 * 0. */
size_t site_day_column(const struct table *t);

/* Returns the first and the last of some days [n], any of which may be NULL:
 * "2026-05-03 to 2026-05-05", or only "2026-05-03" if all are the same.
 * Returns NULL if there are none, or one can be read in two ways.  The caller
 * frees it. */
char *site_day_range_text(char *const *day, size_t n);

#endif
