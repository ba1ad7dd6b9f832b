/* Finds the sieve tables on a sheet, in either orientation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_LAYOUT_H
#define TIPSPEED_IO_SITEFILE_LAYOUT_H

#include "io/sitefile/sieve_size.h"
#include "io/sitefile/site_request.h"

/* One table, turned so that its sieves are rows and its samples columns.  All
 * rows have n_col cells, the first of which is the sieve.  across: in the
 * sheet, the sieves are in one line.  head: the rows of headings, from the top;
 * the first `titles` of them are above the heading of the sieves.  row: from
 * the first to the last sieve or pan.  foot: the rows immediately below.
 * number [n_col]: the number of each column in the sheet, from 1; or of each
 * line, if across; column [n_col]: the same in the grid of layout.c, while it
 * makes the table.  left, end: the table has the columns of the sheet from left
 * to before end.  after: the last line of the tables above, with the remarks
 * that follow them without a blank line, or 0.  text [n_text]: texts that the
 * table owns.  name [n_col]: the names of the samples in a long table, or NULL;
 * site: rows of the names of their sites or machines, each from one column. day
 * [n_col]: if the headings were replaced, the day of each sample, or NULL if it
 * has none; else NULL.
 *
 * site_title.c sets title, the single-cell lines immediately above the table,
 * in the order of the sheet; strange, true if their words may mean another
 * machine or day; and basis, what their words say about all numbers of the
 * table, such as WORD_PASSES | WORD_PERCENT, or 0 if they say nothing or
 * contradict each other.
 *
 * site_sieve.c sets unit and mm [n_row], the sieve sizes (0: pan; NAN: fault),
 * and sorts the rows, coarsest first.  finest_first: the order on the sheet.
 * lost: a row or a heading has a fault, so that it cannot be said what is
 * missing. */
struct table {
	struct sheet *sheet;
	bool across, lost, finest_first;
	bool strange;
	bool below;     /* its sieves are written "< 16", "< 8" */
	bool unit_open; /* the unit of its sieves is an open question */
	bool unsure;    /* only its ordered numbers suggest a sieve table */
	size_t n_col, n_head, n_row, n_foot, n_site, titles;
	size_t left, end;
	int after;
	struct row *head, *row, *foot, *site;
	size_t *number, *column;
	size_t n_text;
	char **text, **name, **day, *title;
	uint64_t basis;
	struct sieve_unit unit;
	double *mm;
};

/* The tables of a sheet [n], in order, and the rows outside any table, heading
 * [n_heading].  read [n_heading]: whether site_title.c has read the row. */
struct layout {
	size_t n, n_heading;
	struct table *table;
	const struct row **heading;
	bool *read;
	/* the first cell beside a table; its text is NULL if there is none */
	struct cell beside;
};

/* A part of a sheet.  box: its cells; all zeros for the whole sheet.  sieves
 * [n_sieves]: the columns (or lines) that have sieves, if the user gave them;
 * phi: their sizes are in phi. */
enum { LAYOUT_SIEVES = 8 };
struct layout_range {
	struct cell_range box;
	size_t n_sieves, sieves[LAYOUT_SIEVES];
	bool phi;
};

/* Makes a text the table's, to be freed with it, and returns it. */
char *layout_adopt_text(struct table *t, char *text);

/* Returns the headings of column c of a table, from the top, as one text.  The
 * caller frees it. */
char *layout_column_heading_text(const struct table *t, size_t c);

/* Returns the line of a table's first heading or, without one, of its first
 * row. */
int layout_first_line_of_table(const struct table *t);

struct layout *layout_new_of_sheet(
    struct sheet *sheet, struct layout_range range);
void layout_free(struct layout *layout);
void layout_table_clear(struct table *t);

#endif
