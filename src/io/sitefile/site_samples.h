/* Columns and samples that the user describes (columns=, samples=).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H
#define TIPSPEED_IO_SITEFILE_SITE_SAMPLES_H

#include "base/error.h"
#include "io/sitefile/site_column.h"

/* What the user says of columns [n], by number, or of samples [n], by name.
 * found: the sample is in the sheet.  others: columns other than sieves are
 * among them; if not, the samples keep their headings. */
struct samples {
	size_t n;
	struct sample {
		size_t number;
		char *name, *text;
		bool found;
	} * item;
	bool others;
};

/* Parses "S01=feed, S02=@70 retained_pct", or NULL, which names no samples.  On
 * failure, returns false with a usage error. */
bool samples_parse_option(
    struct samples *samples, const char *text, struct error *error);

/* As samples_parse_option, but for columns: "1=sieve um, 3=feed retained_g".
 * Stores the columns of sieves in *range. */
bool samples_parse_columns_option(struct samples *samples, const char *text,
    struct layout_range *range, struct error *error);
void samples_clear(struct samples *samples);

/* Replaces the headings of a table by what the user says of its columns, and
 * drops the others; if only sieves are named, does neither.  Returns the
 * meanings of what is said of the sieves, or 0. */
uint64_t samples_set_column_headings(struct samples *columns, struct table *t);

/* Returns the name of the sample in column c, a cell in a row of headings
 * labelled "Sample" or the like; NULL if there is none. */
const struct cell *samples_name_of_column(const struct table *t, size_t c);

/* Returns the text that tells the sample in column c from the others of the
 * table: its name in a long table; else its cell in a row of headings that are
 * all different, if possible a row of names; else its whole heading.  The
 * caller frees it. */
char *samples_label_of_column(const struct table *t, size_t c);

/* True if each sample in a table has a distinct name. */
bool samples_have_distinct_names(const struct table *t);

/* Returns the name of a sheet or, for a text file, of the file. */
const char *samples_sheet_label(const struct sheet *sheet);

/* True if samples= names a sheet, so that all its columns are of that
 * sample. */
bool samples_is_sheet_named(
    const struct samples *samples, const struct sheet *sheet);

/* Gives a column the role, speed and quantity that samples= states for it.
 * Other facts in its headings remain; a contradiction is a fault.  Returns
 * false if the sample is not named there. */
bool samples_apply_to_column(struct samples *samples, struct column *c);

/* Reports the first sample named in samples=, or column in columns=, that was
 * not found.  t: the table whose samples the fault lists. */
void samples_report_missing(
    const struct samples *samples, const struct table *t);

#endif
