/* Samples called by their names: what somebody says they are.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H
#define TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H

#include "base/error.h"
#include "io/sitefile/site_column.h"

/* Samples [n] by their names, what is said of each, as columns= has it but for
 * the word product, and whether it was found. */
struct samples {
	size_t n;
	char **name, **text;
	bool *found;
};

/* From "S01=feed, S02=@70 retained_pct" (NULL: nothing is said).  False with a
 * usage error. */
bool samples_read(
    struct samples *samples, const char *text, struct error *error);
void samples_clear(struct samples *samples);

/* What tells the sample of column c from the others of its table: its name in a
 * long table, else its cell in the first row of heads where all differ, or all
 * that heads it.  The caller frees. */
char *samples_label(const struct table *t, size_t c);

/* Whether each sample of a table has a name of its own. */
bool samples_are_apart(const struct table *t);

/* Gives a column the role, speed and quantity that are said of its sample; what
 * its heads state remains, and a fault tells where the two differ.  False where
 * nothing is said of it. */
bool samples_take(struct samples *samples, struct column *c);

/* Tells the first sample that was named and is not there. */
void samples_check(const struct samples *samples, const struct table *t);

#endif
