/* The sheets of a workbook of any format while it is being read.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_GRID_H
#define TIPSPEED_IO_CELLS_GRID_H

#include "io/cells/sheet.h"

/* The non-empty sheets of a workbook.  note: remarks for the user ("sheet Log
 * is not read: ..."), or "".  A sheet beyond `most` is skipped, because a
 * workbook may contain a plant's log beside the sieves. */
struct grid {
	const char *path; /* borrowed, as errors is */
	struct sheet_limits most;
	struct error_list *errors;
	size_t n;
	struct sheet **sheet;
	char *note;
	size_t n_note;
	struct sheet *now;   /* the sheet being read */
	const char *too_big; /* why `now` is skipped, or NULL */
	size_t bytes;        /* of the texts of `now` */
	bool unsolved;       /* `now` has formulas without results */
	bool hidden;         /* it has hidden rows or columns, which are read */
};

struct grid grid_new(
    const char *path, struct sheet_limits most, struct error_list *errors);

/* Frees the sheets that no caller has taken over. */
void grid_clear(struct grid *grid);

/* Begin and end a sheet.  Cells can be added only within a sheet. */
void grid_begin_sheet(struct grid *grid, const char *name);
void grid_end_sheet(struct grid *grid);

/* Adds a cell to the sheet, at the line and column set in `where`.  Ignores an
 * empty cell and returns false.  The text becomes one line without spaces at
 * its ends, with composed letters.  A sheet with more than 100 kB in a cell is
 * skipped. */
bool grid_put_text(struct grid *grid, struct cell where, const char *text);

/* Adds a number as its cell shows it.  unit: "%" if the cell shows a hundred
 * times the value, another unit, or "". */
bool grid_put_number(
    struct grid *grid, struct cell where, double value, const char *unit);
bool grid_put_date(struct grid *grid, struct cell where, const char *text);

/* Adds a formula without a result.  The formula becomes the text of the
 * cell. */
bool grid_put_formula_text(
    struct grid *grid, struct cell where, const char *formula);

/* grid_note adds a remark on the workbook.  After 20 remarks it only counts
 * them; grid_note_omitted_count adds that count at the end. */
void grid_note(struct grid *grid, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void grid_note_omitted_count(struct grid *grid);

/* Adds the remark that the workbook has more than `most` sheets. */
void grid_note_more_sheets(struct grid *grid, int most);

#endif
