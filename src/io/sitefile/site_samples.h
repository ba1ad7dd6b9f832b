/* Samples that the user names, with their roles (samples=).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H
#define TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H

#include "base/error.h"
#include "io/sitefile/site_column.h"

/* Samples [n] by name.  text: the description of each, as in columns= but
 * without the word product; found: true if the sample is in the sheet. */
struct samples {
	size_t n;
	char **name, **text;
	bool *found;
};

/* Parses "S01=feed, S02=@70 retained_pct" (NULL: no sample is named).  On
 * failure, returns false with a usage error. */
bool samples_parse(
    struct samples *samples, const char *text, struct error *error);
void samples_clear(struct samples *samples);

/* Cuts off the next part of a list that commas separate, and returns it, or
 * NULL after the last; *rest moves after it.  The comma of a number, as in
 * @63,6, separates nothing. */
char *samples_next_item(char **rest);

/* Returns the text that distinguishes the sample in column c from others in the
 * table: its name in a long table, else its cell in the first heading row whose
 * cells all differ, or its whole heading.  The caller frees it. */
char *samples_label_of_column(const struct table *t, size_t c);

/* True if each sample in a table has a distinct name. */
bool samples_have_distinct_names(const struct table *t);

/* Gives a column the role, speed and quantity of its sample.  Other facts in
 * its headings remain; a contradiction is a fault.  Returns false if the sample
 * is not named. */
bool samples_apply_to_column(struct samples *samples, struct column *c);

/* Reports the first named sample that the table does not contain. */
void samples_report_missing(
    const struct samples *samples, const struct table *t);

#endif
