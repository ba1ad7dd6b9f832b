/* The sheets of a workbook while they are read, independent of its kind.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_GRID_H
#define TIPSPEED_IO_CELLS_GRID_H

#include "io/cells/sheet.h"

/* The non-empty sheets of a workbook.  note: remarks for the user ("sheet Log
 * is not read: ..."), or "".  A sheet that is beyond the limits of struct sheet
 * is left out: a workbook may have a plant's log beside its sieves. */
struct grid {
	const char *path; /* borrowed, as is errors */
	struct sheet_limits most;
	struct error_list *errors;
	size_t n;
	struct sheet **sheet;
	char *note;
	size_t n_note;
	struct sheet *now;   /* the one that is being read */
	const char *too_big; /* why it is left out, or NULL */
	size_t bytes;        /* of its texts */
	bool unsolved, hidden;
};

struct grid grid_new(
    const char *path, struct sheet_limits most, struct error_list *errors);

/* Frees the sheets that were not taken over. */
void grid_clear(struct grid *grid);

/* Begins and ends a sheet.  Nothing may be put between two sheets. */
void grid_begin(struct grid *grid, const char *name);
void grid_end(struct grid *grid);

/* A cell of the sheet; line and column are set.  False for an empty cell, which
 * is ignored.  Text becomes one line without spaces at its ends, its letters
 * composed; a sheet with more than 100 kB in a cell is left out. */
bool grid_put_text(struct grid *grid, struct cell where, const char *text);

/* A number as shown: unit "%" for one whose cell shows a hundred times as much,
 * another unit, or "". */
bool grid_put_number(
    struct grid *grid, struct cell where, double value, const char *unit);
bool grid_put_date(struct grid *grid, struct cell where, const char *text);

/* A formula without its result; the cell has the formula as its text. */
bool grid_put_formula(
    struct grid *grid, struct cell where, const char *formula);

/* Notes that the sheet has hidden rows or columns, which are read. */
void grid_hidden(struct grid *grid);

/* Adds a remark on the workbook; after 20 they are only counted, and grid_notes
 * adds the count in the end. */
void grid_note(struct grid *grid, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void grid_notes(struct grid *grid);

/* Notes that the workbook has more sheets than `most`. */
void grid_more(struct grid *grid, int most);

#endif
