/* The columns of a sieve sheet: their roles, units and checks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_COLUMN_H
#define TIPSPEED_IO_SITEFILE_SITE_COLUMN_H

#include <stdbool.h>
#include <stddef.h>

#include "io/sitefile/column_header.h"
#include "io/sitefile/layout.h"

enum role { FEED, PRODUCT, SD, NO_ROLE };

enum unit_kind { PASSING, RETAINED, CUMULATIVE };
enum unit_scale { OF_100, OF_1, OF_MASS };

/* The quantity that a column's numbers are.  suffix: the text after the role in
 * a heading; words: the quantity for people; most: the greatest number; wanted:
 * what a fault says was expected. */
struct site_unit {
	const char *suffix, *words;
	enum unit_kind kind;
	enum unit_scale scale;
	double most;
	const char *wanted;
};

enum { SITE_N_UNIT = 9 };
extern const struct site_unit SITE_UNITS[SITE_N_UNIT];
extern const char *const SITE_ROLES[4];

/* Returns the index in SITE_UNITS of the unit of this kind and scale. */
size_t site_unit_index(enum unit_kind kind, enum unit_scale scale);

/* A column of a table that has a sample.  pct [n_row of the table]: passing in
 * %, or its standard deviation in percentage points; NAN if the cell is empty
 * or has a fault.  pan: the amount below the finest sieve, in the column's
 * unit, or NAN.  faulty: a cell has a fault, so it cannot be said what is
 * missing.  told_percent: a percentage among fractions was reported.  open: it
 * is not certain what the column is.  unlike: the reason is that it and another
 * product at its speed have different names, so they may not be repeats.
 * whose: the reason is that a row "Quarry" or "Crusher" names this site or
 * machine for it, and another one for another product; else NULL.  assumed:
 * what was assumed about the column, an empty line and then a line for each
 * assumption, or NULL.  below: for a feed whose coarsest sieve passes less than
 * 100 %, 1 + the row of that sieve; else 0.  top: the size, mm, that all of the
 * sample passes, if it is assumed or is the upper end of the coarsest class;
 * else 0.  to_next: its masses are those from the size of a row down to that
 * of the next, as the rows "-16 mm", "-11.2 mm" of a table have them. */
struct column {
	struct table *table;
	struct cell head;
	size_t at; /* its index in a row */
	enum role role;
	size_t unit;  /* its index in SITE_UNITS */
	double speed; /* m/s; 0 for the feed of all runs */
	double rpm;   /* the rpm that the speed was computed from, or 0 */
	size_t nth;   /* index among repeats of its role and speed */
	/* the number of the column that is read instead for this sample, or
	 * 0 */
	size_t twin;
	double *pct, top;
	size_t below;
	double pan;
	bool faulty, told_percent, open, unlike, to_next;
	char *assumed;
	const char *whose;
	struct head said; /* what its headings state */
};

/* All columns of a site, from one table or from several. */
struct columns {
	size_t n;
	struct column *column;
};

/* Reads the cells of c, converts them to c->pct, and checks each number and the
 * curve. */
void site_column_read_values(struct column *c);

/* Takes a column out of the list. */
void site_column_drop(struct columns *all, size_t i);

/* Returns the number of columns with that role in a table, or in all if t is
 * NULL. */
size_t site_column_count_by_role(
    const struct columns *all, const struct table *t, enum role role);

/* Returns the number of columns with that role and speed. */
size_t site_column_count_at_speed(
    const struct columns *all, enum role role, double speed);

/* The samples [n] of a table, not counting columns that repeat a sample in
 * another quantity.  only: the sample, if there is just one; feed, product: the
 * last of each; or NULL.  products: all are products with known speeds.  open:
 * one of them is open. */
struct table_samples {
	size_t n;
	const struct column *only, *feed, *product;
	bool products, open;
};
struct table_samples site_column_samples_of_table(
    const struct columns *all, const struct table *t);

/* Returns the nth column with that role and speed.  If there is only one, it
 * serves all repeats and is returned for each n.  Returns NULL if there is
 * none. */
struct column *site_column_find(
    const struct columns *all, enum role role, double speed, size_t nth);

/* Returns the number of sieves that have a value. */
size_t site_column_count_values(const struct column *c);

/* Returns the number in a row of the table as the sheet has it, or NAN. */
double site_column_value_in_row(const struct column *c, size_t row);

/* Returns the passing of a row, %, with the digits of the sheet; or, if it was
 * computed, with enough digits to differ from `other`. */
const char *site_column_passing_text(
    const struct column *c, size_t row, double other, char buf[static 32]);

/* Returns v rounded to a multiple of 1 / per_unit, but never -0. */
double round_to_step(double v, double per_unit);

#endif
