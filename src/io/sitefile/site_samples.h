/* Samples given by name, with their roles (samples=).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H
#define TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H

#include "base/error.h"
#include "io/sitefile/site_column.h"

/* Samples [n] by name.  text: what each sample is, as in columns= but without
 * the word product; found: true if the sample is in the sheet. */
struct samples {
	size_t n;
	char **name, **text;
	bool *found;
};

/* Reads "S01=feed, S02=@70 retained_pct" (NULL: no sample is named).  False
 * with a usage error. */
bool samples_read(
    struct samples *samples, const char *text, struct error *error);
void samples_clear(struct samples *samples);

/* Returns the text that distinguishes the sample of column c from others of its
 * table: its name in a long table, else its cell in the first row of headings
 * in which all cells differ, or its whole heading.  The caller frees. */
char *samples_label(const struct table *t, size_t c);

/* True if each sample of a table has a name of its own. */
bool samples_are_apart(const struct table *t);

/* Gives a column the role, speed and quantity of its sample; anything else that
 * its headings state remains, and a difference between the two is a fault.
 * False if its sample is not named. */
bool samples_take(struct samples *samples, struct column *c);

/* Reports the first named sample that the table does not contain. */
void samples_check(const struct samples *samples, const struct table *t);

#endif
