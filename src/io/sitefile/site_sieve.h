/* The sieves of a table: their openings, order and unit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_SIEVE_H
#define TIPSPEED_IO_SITEFILE_SITE_SIEVE_H

#include <stdint.h>

#include "io/sitefile/site_column.h"

/* How certain the unit of the sieves is. */
enum sieve_certainty {
	SIEVES_SAID,    /* the sheet states it */
	SIEVES_ASSUMED, /* mm or um, because standard sieves have these
			 * openings */
	SIEVES_OPEN     /* several units are possible */
};

/* Finds the unit of a table's sieves, and sorts the rows of the table, coarsest
 * first.  told: the meanings (lexicon.h) of the heading that the user gave the
 * sieves, or 0. */
enum sieve_certainty site_sieve_find_unit_and_sort(
    struct table *t, uint64_t told);

/* Returns the heading cell of the sieves or, if there is none, the first
 * sieve's cell. */
struct cell site_sieve_heading_cell(const struct table *t);

/* Reports sizes that are wrong, out of order or duplicate. */
void site_sieve_read_and_check(struct table *t);

/* Returns the number of rows before a second table with the same sieves, which
 * follows without an empty line; n_row if there is none.  *again gets the first
 * row of that table. */
size_t site_sieve_rows_before_repeat(const struct table *t, size_t *again);

/* Returns the unit of a table's sieves: "mm", "um", "in", "Tyler mesh". */
const char *site_sieve_unit_text(const struct table *t);

/* Returns a size in mm, rounded to 9 decimals, or NAN after a fault.  unit: mm;
 * wanted: what a fault says was expected. */
double site_sieve_read_mm(
    struct sheet *sheet, struct cell cell, double unit, const char *wanted);

/* Turns comments that begin with #4, # 4 or another ASTM E11 number back into
 * rows. */
void site_sieve_uncomment_astm_rows(struct sheet *sheet);

#endif
