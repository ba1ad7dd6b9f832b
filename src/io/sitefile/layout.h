/* Finds the sieve tables on a sheet, in either orientation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_LAYOUT_H
#define TIPSPEED_IO_SITEFILE_LAYOUT_H

#include "io/sitefile/sieve_size.h"
#include "io/sitefile/site_request.h"

/* One table, turned so that its sieves are rows and its samples columns.  All
 * rows have n_col cells; the first is the sieve.  head: the rows above, from
 * the top; row: from the first to the last sieve or pan; foot: the rows
 * immediately below.  number [n_col]: the number of each column in the sheet,
 * from 1, or of each line, if across.  titles: the number of head rows, from
 * the top, above the heading of the sieves.  after: the last line of the tables
 * above, with the remarks that follow them without a blank line, or 0.  text
 * [n_text]: headings made for a
 * long table; name [n_col]: the names of the samples in a long table, or NULL.
 * day [n_col]: the days of the samples, NULL where none is stated, of a table
 * whose headings were replaced; or NULL.
 *
 * site_title.h sets title, the single-cell lines immediately above the table,
 * in the order of the sheet, and strange, true if their words may mean another
 * machine or day; basis, what their words say of all its numbers, such as
 * WORD_PASSES | WORD_PERCENT, or 0 if they do not say it in one way.
 *
 * site_sieve.h sets mm [n_row], sieve sizes (0: pan; NAN: fault), from the
 * unit, and sorts the rows, coarsest first.  finest_first: the order on the
 * sheet.  lost: a row or a heading has a fault, so missing parts cannot be
 * judged. */
struct table {
	struct sheet *sheet;
	bool across, lost, finest_first;
	bool strange;
	bool below;     /* its sieves are written "< 16", "< 8" */
	bool unit_open; /* of its sieves */
	bool unsure;    /* only its ordered numbers suggest a sieve table */
	size_t n_col, n_head, n_row, n_foot, titles;
	size_t left, end;
	int after;
	struct row *head, *row, *foot;
	size_t *number;
	size_t n_text;
	char **text, **name, **day, *title;
	uint64_t basis;
	struct sieve_unit unit;
	double *mm;
};

/* The tables of a sheet [n], in order, and the rows outside any table
 * [n_heading].  read [n_heading]: what site_title.h found in them. */
struct layout {
	size_t n, n_heading;
	struct table *table;
	const struct row **heading;
	bool *read;
	struct cell beside; /* the first cell beside a table; text NULL: none */
};

/* A part of a sheet; box: zeros for all of it.  sieves [n_sieves]: the columns
 * (or lines) of sieves, if given; phi: the sizes are in phi. */
enum { LAYOUT_SIEVES = 8 };
struct layout_range {
	struct site_box box;
	size_t n_sieves, sieves[LAYOUT_SIEVES];
	bool phi;
};

/* Takes ownership of a text, frees it with the table, and returns it. */
char *layout_adopt_text(struct table *t, char *text);

/* Returns the headings of column c of a table, from the top, as one text.  The
 * caller frees it. */
char *layout_heading_text(const struct table *t, size_t c);

struct layout *layout_new_of_sheet(
    struct sheet *sheet, struct layout_range range);
void layout_free(struct layout *layout);
void layout_table_clear(struct table *t);

#endif
