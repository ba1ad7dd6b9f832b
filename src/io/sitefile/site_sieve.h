/* The sieves of a table: openings, order, unit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_SIEVE_H
#define TIPSPEED_IO_SITEFILE_SITE_SIEVE_H

#include <stdint.h>

#include "io/sitefile/site_column.h"

/* The certainty of the unit of the sieves. */
enum sieve_certainty {
	SIEVES_SAID,    /* the sheet states it */
	SIEVES_ASSUMED, /* mm or um, as the openings are those of sieves */
	SIEVES_OPEN     /* several units are possible */
};

/* Finds the unit of a table's sieves and sorts its rows, coarsest first.  told:
 * the unit in the words of a heading given by hand, see lexicon.h, or 0. */
enum sieve_certainty site_sieve_find(struct table *t, uint64_t told);

/* Returns the cell that heads the sieves, or the cell of the first sieve. */
struct cell site_sieve_heading(const struct table *t);

/* Reports sizes that are wrong, out of order or repeated. */
void site_sieve_check(struct table *t);

/* Returns the number of rows before another table with the same sieves that
 * follows without an empty line; n_row: no table follows.  again: out, the
 * first row of the other table. */
size_t site_sieve_end(const struct table *t, size_t *again);

/* Returns the unit of a table's sieves: "mm", "um", "in", "Tyler mesh". */
const char *site_sieve_unit(const struct table *t);

/* Reads a size in mm to 9 decimals; NAN after a fault. */
double site_sieve_mm(
    struct sheet *sheet, struct cell cell, double unit, const char *wanted);

/* Turns lines that begin with #4, # 4 or another number of ASTM E11, which the
 * sheet took for comments, into rows. */
void site_sieve_numbers(struct sheet *sheet);

#endif
