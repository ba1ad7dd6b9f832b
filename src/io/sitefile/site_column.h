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

/* The quantity of a column's numbers.  suffix: text after the role in a
 * heading; words: for people, and for columns=. */
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

/* Returns the index of a unit in SITE_UNITS. */
size_t site_unit_index(enum unit_kind kind, enum unit_scale scale);

/* pct [n_row of the table]: passing in %, or standard deviation of passing in
 * percentage points; NAN if the cell is empty or has a fault.  pan: the amount
 * below the finest sieve, in the column's unit, or NAN.  faulty: a cell has a
 * fault, so missing values cannot be judged.  open: the meaning of the column
 * is open.  unlike: so it is because its name and that of another product at
 * its speed may be those of different products.  whose: so it is because this
 * site or machine, of a row "Quarry" or "Crusher", is another than that of some
 * other product; or NULL.  assumed: assumptions not
 * stated in the sheet, as lines after an empty one, or NULL.  below: for a feed
 * whose coarsest sieve passes less than all, 1 + the row of that sieve, else 0.
 * top: the size, mm, that then is assumed to pass all, or the upper one of the
 * coarsest class; else 0. */
struct column {
	struct table *table;
	struct cell head;
	size_t at; /* index in a row */
	enum role role;
	size_t unit;  /* index in the table of units */
	double speed; /* m/s; 0 for the feed of all runs */
	double rpm;   /* the rpm from which the speed was computed, if any */
	size_t nth;   /* index among repeats of its role and speed */
	size_t twin;  /* number of another column for the sample, or 0 */
	double *pct, top;
	size_t below;
	double pan;
	bool faulty, told_percent, open, unlike;
	char *assumed;
	const char *whose;
	struct head said; /* stated in its heading */
};

/* All columns of a site, from one table or from several. */
struct columns {
	size_t n;
	struct column *column;
};

/* Reads the cells of c, converts them to c->pct and checks them, singly and as
 * a curve. */
void site_column_read_values(struct column *c);

/* Returns the number of columns with that role in a table; NULL: in all. */
size_t site_column_count_role(
    const struct columns *all, const struct table *t, enum role role);

/* Returns the number of columns with that role and speed. */
size_t site_column_count_at_speed(
    const struct columns *all, enum role role, double speed);

/* The samples [n] of a table, without columns that repeat one in another
 * quantity.  only: the sample if there is one alone; feed, product: the last;
 * else NULL.  products: there are only products, and their speeds are known.
 * open: the meaning of one is. */
struct table_samples {
	size_t n;
	const struct column *only, *feed, *product;
	bool products, open;
};
struct table_samples site_column_samples_of_table(
    const struct columns *all, const struct table *t);

/* Returns the nth column with that role and speed, or the only one, which then
 * serves all repeats; NULL if there is none. */
struct column *site_column_find(
    const struct columns *all, enum role role, double speed, size_t nth);

/* Returns the number of sieves with a value. */
size_t site_column_count_values(const struct column *c);

/* Returns the number in a row of the sheet, or NAN. */
double site_column_number_in_row(const struct column *c, size_t row);

/* Returns the passing of a row, %, with the digits of the sheet or, if computed
 * from masses, with enough digits to distinguish it from `other`. */
const char *site_column_passing_text(
    const struct column *c, size_t row, double other, char buf[static 32]);

/* Returns v rounded to whole steps of 1 / per_unit, never -0. */
double site_column_round_to_step(double v, double per_unit);

#endif
