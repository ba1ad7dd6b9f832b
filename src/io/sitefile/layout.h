/* Finds the tables of sieves on a sheet, in either orientation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_LAYOUT_H
#define TIPSPEED_IO_SITEFILE_LAYOUT_H

#include "io/sitefile/sieve_size.h"

/* One table, turned so that its sieves are rows and its samples columns.  All
 * rows have n_col cells, the first of which is the sieve's.  head: the rows
 * above, from the top; row: from the first to the last sieve or pan; foot: the
 * rows right below.  number [n_col]: number of the column in the sheet, from 1;
 * across: number of the line.  titles: how many of the heads, from the top, are
 * above the line that heads the sieves.  text [n_text]: the texts made for the
 * heads of a long table; name [n_col]: in a long table the names of its
 * samples, or NULL.
 *
 * site_title.h sets these: title, the lines of one cell right above the table,
 * in the order of the sheet; strange: they have words that may mean another
 * machine or day.
 *
 * site_sieve.h sets these: mm [n_row], sieve sizes, 0 for the pan, NAN for a
 * fault, from the unit; rows are then coarsest first.  finest_first: the order
 * on the sheet.  lost: a row or a head has a fault, so that missing parts
 * cannot be judged. */
struct table {
	struct sheet *sheet;
	bool across, is_long, lost, finest_first;
	bool strange;
	bool unsure; /* only numbers in order mark it as a table of sieves */
	size_t n_col, n_head, n_row, n_foot, titles;
	struct row *head, *row, *foot;
	size_t *number;
	size_t n_text;
	char **text, **name, *title;
	struct sieve_unit unit;
	double *mm;
};

/* The tables of a sheet [n], in their order, and the rows that belong to no
 * table [n_heading]. */
struct layout {
	size_t n, n_heading;
	struct table *table;
	const struct row **heading;
	bool across;
	struct cell beside; /* the first beside a table; text NULL: none */
};

/* A part of a sheet: lines and columns from first to last, each counted from 1;
 * zeros for the whole sheet.  sieves [n_sieves]: the columns of sieves, or
 * their lines, if given; phi: the sizes are in phi. */
enum { LAYOUT_SIEVES = 8 };
struct layout_range {
	int first_line, last_line, first_column, last_column;
	size_t n_sieves, sieves[LAYOUT_SIEVES];
	bool phi;
};

/* Takes over a text, which is freed with the table; returns it. */
char *layout_own_text(struct table *t, char *text);

/* Returns the headings of column c of a table, from the top, as one text.  The
 * caller frees. */
char *layout_head_text(const struct table *t, size_t c);

/* Sets headings given by hand: text [n_text] for the columns with these
 * numbers; other columns are dropped. */
void layout_set_names(struct table *t, const size_t *number,
    const char *const *text, size_t n_text);

struct layout *layout_new(struct sheet *sheet, struct layout_range range);
void layout_free(struct layout *layout);
void layout_table_clear(struct table *t);

#endif
