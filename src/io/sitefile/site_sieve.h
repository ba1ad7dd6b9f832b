/* The sieves of a table: openings, order, unit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_SIEVE_H
#define TIPSPEED_IO_SITEFILE_SITE_SIEVE_H

#include <stdint.h>

#include "io/sitefile/site_column.h"

/* How sure the unit of the sieves is. */
enum sieve_certainty {
	SIEVES_SAID,    /* the sheet tells it */
	SIEVES_ASSUMED, /* mm or um, as the openings are those of sieves */
	SIEVES_OPEN     /* it could be several */
};

/* Finds the unit of a table's sieves and puts its rows coarsest first.  told:
 * the unit in the words of a heading given by hand, see lexicon.h, or 0. */
enum sieve_certainty site_sieve_find(struct table *t, uint64_t told);

/* The cell that heads the sieves, or the first of them. */
struct cell site_sieve_head(const struct table *t);

/* Reports sizes that are wrong, out of order or repeated. */
void site_sieve_check(struct table *t);

/* The number of rows before another table with the same sieves that follows
 * without an empty line; n_row: none does.  again: the first row of that other
 * one. */
size_t site_sieve_end(const struct table *t, size_t *again);

/* "mm", "um", "in", "Tyler mesh": of a table's sieves. */
const char *site_sieve_unit(const struct table *t);

/* A size in mm to 9 decimals; NAN after a fault. */
double site_sieve_mm(
    struct sheet *sheet, struct cell cell, double unit, const char *wanted);

/* Makes rows of the lines that begin with #4, # 4 or another number of ASTM
 * E11, which the sheet took for comments. */
void site_sieve_numbers(struct sheet *sheet);

#endif
