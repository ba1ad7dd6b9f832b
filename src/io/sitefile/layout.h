/* Where the tables of sieves are on a sheet, whichever way they lie.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_LAYOUT_H
#define TIPSPEED_IO_SITEFILE_LAYOUT_H

#include "io/cells/sheet.h"

/* One table as if its sieves went down and its samples across.  All rows have
 * n_col cells, the first of which is the sieve's.  head: the rows above, from
 * the top; row: from the first to the last sieve or pan; foot: what stands
 * right below.  number [n_col]: of the column in the sheet, from 1; across: of
 * the line.  titles: how many of the heads, from the top, are above the line
 * that heads the sieves.  spread: its heads hold for the empty cells at their
 * right, too.  text [n_text]: what heads of a long table were made of; name
 * [n_col]: of such a one, what its samples are called, or NULL. */
struct block {
	struct sheet *sheet;
	bool across, is_long;
	size_t n_col, n_head, n_row, n_foot, titles;
	struct row *head, *row, *foot;
	size_t *number;
	size_t n_text;
	char **text, **name;
	bool unsure; /* no more than numbers in order tell it from others */
};

/* The tables of a sheet [n], in their order, and the rows that belong to none
 * [n_heading]. */
struct layout {
	size_t n, n_heading;
	struct block *block;
	const struct row **heading;
	bool across;
	struct cell beside; /* the first that is beside a table; or text NULL */
};

/* A part of a sheet: lines and columns from..to, each counted from 1; zeros are
 * all of it.  sieves [n_sieves]: the columns of sieves, or their lines, where
 * somebody says; phi: that they are in phi. */
enum { LAYOUT_SIEVES = 8 };
struct layout_range {
	int first_line, last_line, first_column, last_column;
	size_t n_sieves, sieves[LAYOUT_SIEVES];
	bool phi;
};

/* Keeps a text as long as the block; returns it. */
char *layout_keep(struct block *block, char *text);

/* The words that head column c of a block, from the top.  The caller frees. */
char *layout_head(const struct block *block, size_t c);

/* Heads the columns by hand: text [n_text] for those with the numbers; others
 * are dropped. */
void layout_name(struct block *block, const size_t *number,
    const char *const *text, size_t n_text);

struct layout *layout_new(struct sheet *sheet, struct layout_range range);
void layout_free(struct layout *layout);
void layout_block_clear(struct block *block);

#endif
