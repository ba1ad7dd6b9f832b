/* The columns of a sieve sheet: what heads them, their units, their checks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITE_COLUMN_H
#define TIPSPEED_IO_SITE_COLUMN_H

#include <stdbool.h>
#include <stddef.h>

#include "io/sheet.h"

enum role { FEED, PRODUCT, SD };

enum unit_kind { PASSING, FRACTION, RETAINED_G, RETAINED_PCT, CUM_RETAINED };

/* What may follow the role in a head, and the largest value. */
struct site_unit {
	const char *suffix;
	enum unit_kind kind;
	double most;
	const char *wanted;
};

enum { SITE_N_UNIT = 6 };
extern const struct site_unit SITE_UNITS[SITE_N_UNIT];
extern const char *const SITE_ROLES[3];

/* pct [n_row of the table]: passing in %, or standard deviation of passing in
 * percentage points; NAN where the cell is empty or at fault.  pan: value in
 * the pan's row in the unit of the column, or NAN.  faulty: a cell is at fault,
 * so that what is missing cannot be judged. */
struct column {
	struct cell head;
	size_t at; /* place in a row */
	enum role role;
	size_t unit;  /* index in the table of units */
	double speed; /* m/s; 0 for the feed of all runs */
	size_t nth;   /* of its role and speed, from 0: repeats */
	double *pct;
	double pan;
	bool faulty, told_percent;
};

/* The rows below the line that begins with size_mm.  mm [n_row]: sieve sizes,
 * 0 for the pan, NAN where at fault.  total: the line of sums below them, or
 * NULL.  lost: a row or a header is at fault, so
 * that what is missing cannot be judged. */
struct table {
	struct sheet *sheet;
	const struct row *head;
	size_t n_row;
	const struct row *row, *total;
	double *mm;
	size_t n_column;
	struct column *column;
	bool lost, told_retained, told_cells, told_heads;
};

/* Role, unit and speed from c->head; a fault and false when they are not
 * understood, or are those of an earlier column of the table that this one
 * cannot repeat. */
bool site_column_head(struct table *t, struct column *c);

/* Reads the cells of c, converts them to c->pct and checks them one by one and
 * as a curve. */
void site_column_values(struct table *t, struct column *c);

/* How many columns have that role and speed. */
size_t site_column_repeats(const struct table *t, enum role role, double speed);

/* The nth column of that role and speed, or the only one, which serves all
 * repeats; NULL where there is none. */
struct column *site_column_find(
    const struct table *t, enum role role, double speed, size_t nth);

/* Number of sieves with a value. */
size_t site_column_count(const struct table *t, const struct column *c);

/* v in whole steps of 1 / per_unit, never -0. */
double site_column_round(double v, double per_unit);

#endif
