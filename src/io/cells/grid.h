/* The sheets of a workbook of any format while it is being read.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_GRID_H
#define TIPSPEED_IO_CELLS_GRID_H

#include "io/cells/sheet.h"

/* The non-empty sheets of a workbook.  note: remarks for the user ("sheet Log
 * is not read: ..."), or "".  A sheet beyond `most` is skipped, because a
 * workbook may contain a plant's log beside the sieves. */
struct sheets {
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

struct sheets sheets_new(
    const char *path, struct sheet_limits most, struct error_list *errors);

/* Frees the sheets that no caller has taken over. */
void sheets_clear(struct sheets *grid);

/* Begin and end a sheet.  Cells can be added only within a sheet. */
void sheets_begin_sheet(struct sheets *grid, const char *name);
void sheets_end_sheet(struct sheets *grid);

/* Adds a cell to the sheet, at the line and column set in `where`.  Ignores an
 * empty cell and returns false.  The text becomes one line without spaces at
 * its ends, with composed letters.  A sheet with more than 100 kB in a cell is
 * skipped. */
bool sheets_put_text(struct sheets *grid, struct cell where, const char *text);

/* Adds a number as its cell shows it.  unit: "%" if the cell shows a hundred
 * times the value, another unit, or "". */
bool sheets_put_number(
    struct sheets *grid, struct cell where, double value, const char *unit);
bool sheets_put_date(struct sheets *grid, struct cell where, const char *text);

/* Adds a formula without a result.  The formula becomes the text of the
 * cell. */
bool sheets_put_formula(
    struct sheets *grid, struct cell where, const char *formula);

/* sheets_note adds a remark on the workbook.  After 20 remarks it only counts
 * them; sheets_note_omitted_count adds that count at the end. */
void sheets_note(struct sheets *grid, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void sheets_note_omitted_count(struct sheets *grid);

/* Adds the remark that the workbook has more than `most` sheets. */
void sheets_note_more_sheets(struct sheets *grid, int most);

#endif
