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

/* The quantity of a column's numbers.  suffix: as it follows the role in a
 * heading; words: for people, and as columns= has them. */
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

/* The index of one in SITE_UNITS. */
size_t site_unit_find(enum unit_kind kind, enum unit_scale scale);

/* pct [n_row of the table]: passing in %, or standard deviation of passing in
 * percentage points; NAN where the cell is empty or at fault.  pan: what the
 * column has below the finest sieve, in its unit, or NAN.  faulty: a cell is at
 * fault, so that what is missing cannot be judged.  open: what it is is left
 * open; no_role: because it has no role; assumed: what was assumed without
 * being stated, in lines, or NULL.  below: of a feed, 1 + the row of its
 * coarsest sieve where that passes less than all; top: the size, mm, that is
 * then assumed to pass all; else 0. */
struct column {
	struct table *table;
	struct cell head;
	size_t at; /* place in a row */
	enum role role;
	size_t unit;  /* index in the table of units */
	double speed; /* m/s; 0 for the feed of all runs */
	double rpm;   /* where the speed follows from it */
	size_t nth;   /* of its role and speed, from 0: repeats */
	size_t twin;  /* number of the column with the same sample, or 0 */
	double *pct, top;
	size_t below;
	double pan;
	bool faulty, told_percent, open, no_role;
	char *assumed;
	struct head said; /* what heads it */
};

/* All columns that a site is made of, of one table or of several. */
struct columns {
	size_t n;
	struct column *column;
};

/* Reads the cells of c, converts them to c->pct and checks them one by one and
 * as a curve. */
void site_column_values(struct column *c);

/* How many columns have that role and speed. */
size_t site_column_repeats(
    const struct columns *all, enum role role, double speed);

/* The nth column of that role and speed, or the only one, which serves all
 * repeats; NULL where there is none. */
struct column *site_column_find(
    const struct columns *all, enum role role, double speed, size_t nth);

/* Number of sieves with a value. */
size_t site_column_count(const struct column *c);

/* The number that the sheet has in a row, NAN where there is none. */
double site_column_raw(const struct column *c, size_t row);

/* The passing of a row, %, with the digits of the sheet; of masses, with as
 * many as distinguish it from `other`. */
const char *site_column_pct(
    const struct column *c, size_t row, double other, char buf[static 32]);

/* v in whole steps of 1 / per_unit, never -0. */
double site_column_round(double v, double per_unit);

#endif
