/* Finds the tables of sieves on a sheet, in either orientation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_LAYOUT_H
#define TIPSPEED_IO_SITEFILE_LAYOUT_H

#include "io/sitefile/sieve_size.h"

/* One table as if its sieves went down and its samples across.  All rows have
 * n_col cells, the first of which is the sieve's.  head: the rows above, from
 * the top; row: from the first to the last sieve or pan; foot: what stands
 * right below.  number [n_col]: of the column in the sheet, from 1; across: of
 * the line.  titles: how many of the heads, from the top, are above the line
 * that heads the sieves.  text [n_text]: what heads of a long table were made
 * of; name [n_col]: of such a one, what its samples are called, or NULL.
 *
 * What site_sieve.h finds: mm [n_row], sieve sizes, 0 for the pan, NAN where at
 * fault, of the unit; rows are then coarsest first.  finest_first: as it was on
 * the sheet.  lost: a row or a head is at fault, so that what is missing cannot
 * be judged. */
struct table {
	struct sheet *sheet;
	bool across, is_long, lost, finest_first;
	bool unsure; /* no more than numbers in order tell it from others */
	size_t n_col, n_head, n_row, n_foot, titles;
	struct row *head, *row, *foot;
	size_t *number;
	size_t n_text;
	char **text, **name;
	struct sieve_unit unit;
	double *mm;
};

/* The tables of a sheet [n], in their order, and the rows that belong to none
 * [n_heading]. */
struct layout {
	size_t n, n_heading;
	struct table *table;
	const struct row **heading;
	bool across;
	struct cell beside; /* the first that is beside a table; or text NULL */
};

/* A part of a sheet: lines and columns from..to, each counted from 1; zeros for
 * all of it.  sieves [n_sieves]: the columns of sieves, or their lines, where
 * given; phi: they are in phi. */
enum { LAYOUT_SIEVES = 8 };
struct layout_range {
	int first_line, last_line, first_column, last_column;
	size_t n_sieves, sieves[LAYOUT_SIEVES];
	bool phi;
};

/* Takes a text over, to be freed with the table; returns it. */
char *layout_keep(struct table *t, char *text);

/* The headings of column c of a table, from the top, as one text.  The caller
 * frees. */
char *layout_head(const struct table *t, size_t c);

/* Sets headings given by hand: text [n_text] for the columns with these
 * numbers; other columns are dropped. */
void layout_name(struct table *t, const size_t *number, const char *const *text,
    size_t n_text);

struct layout *layout_new(struct sheet *sheet, struct layout_range range);
void layout_free(struct layout *layout);
void layout_table_clear(struct table *t);

#endif
