/* The first column of a sieve sheet: sizes of the sieves and the pan.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITE_SIEVE_H
#define TIPSPEED_IO_SITE_SIEVE_H

#include "io/site_column.h"

/* mm in the unit that the row names when it begins a table (size_mm, size_um,
 * size_m); 0 when it does not begin one. */
double site_sieve_unit(const struct row *row);

/* Whether a cell has the word of such a row (size, Maskvidd) without a unit. */
bool site_sieve_word(const char *text);

/* A size in mm to 9 decimals, 0 where the cell says 0; NAN after a fault. */
double site_sieve_mm(
    struct sheet *sheet, struct cell cell, double unit, const char *wanted);

/* Makes rows of the lines below the head that begin with #4, # 4 or another
 * number of ASTM E11, which the sheet took for comments. */
void site_sieve_numbers(struct sheet *sheet, const struct row *head);

/* Reads t->mm and tells sizes that are wrong, out of order or there twice, and
 * rows with more cells than the head. */
void site_sieve_rows(struct table *t);

#endif
