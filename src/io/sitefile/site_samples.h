/* Columns and samples that the user describes (columns=, samples=).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H
#define TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H

#include "base/error.h"
#include "io/sitefile/site_column.h"

/* Columns [n] by number, or samples [n] by name, with what the user says of
 * each.  found: the sample is in the sheet.  others: not all of the columns are
 * those of sieves; else the samples keep their headings. */
struct samples {
	size_t n;
	struct sample {
		size_t number;
		char *name, *text;
		bool found;
	} * item;
	bool others;
};

/* Parses "S01=feed, S02=@70 retained_pct" (NULL: no sample is named).  On
 * failure, returns false with a usage error. */
bool samples_parse_option(
    struct samples *samples, const char *text, struct error *error);

/* As samples_parse_option, but for columns: "1=sieve um, 3=feed retained_g".
 * Notes those of sieves in *range. */
bool samples_parse_columns_option(struct samples *samples, const char *text,
    struct layout_range *range, struct error *error);
void samples_clear(struct samples *samples);

/* Heads the columns of a table as the user names them, and drops others.
 * Returns the meanings of the heading of its sieves, or 0. */
uint64_t samples_set_column_headings(
    const struct samples *columns, struct table *t);

/* Returns the cell with the name of the sample in column c, of a row of
 * headings labelled "Sample" or the like; NULL if there is none. */
const struct cell *samples_name_of_column(const struct table *t, size_t c);

/* Returns the text that distinguishes the sample in column c from others in the
 * table: its name if those of all differ, else its cell in the first heading
 * row whose cells all differ, or its whole heading.  The caller frees it. */
char *samples_label_of_column(const struct table *t, size_t c);

/* True if each sample in a table has a distinct name. */
bool samples_have_distinct_names(const struct table *t);

/* Returns the name of a sheet or, if it is a file of text, that of the file. */
const char *samples_sheet_label(const struct sheet *sheet);

/* True if a sample has the name of a sheet: all columns of it are of that
 * sample. */
bool samples_name_sheet(
    const struct samples *samples, const struct sheet *sheet);

/* Gives a column the role, speed and quantity of its sample.  Other facts in
 * its headings remain; a contradiction is a fault.  Returns false if the sample
 * is not named. */
bool samples_apply_to_column(struct samples *samples, struct column *c);

/* Reports the first named sample that the table does not contain. */
void samples_report_missing(
    const struct samples *samples, const struct table *t);

#endif
