/* The sheets of a workbook of any format while it is being read.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_GRID_H
#define TIPSPEED_IO_CELLS_GRID_H

#include "io/cells/sheet.h"

/* The non-empty sheets of a workbook.  note: remarks for the user ("sheet Log
 * is not read: ..."), or "".  n_note: how many remarks there were, including
 * those left out of note.  A sheet larger than `most` is skipped without a
 * fault, because a workbook may hold a plant's log as well as the analyses. */
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
	size_t bytes;        /* total length of the texts in `now` */
	bool unsolved;       /* `now` has formulas without results */
	/* `now` has hidden rows or columns, read too */
	bool hidden;
};

struct sheets sheets_new(
    const char *path, struct sheet_limits most, struct error_list *errors);

/* Frees the sheets and the note.  Not called if they have been moved
 * elsewhere. */
void sheets_clear(struct sheets *grid);

/* Begin and end a sheet.  Cells can be added only in between. */
void sheets_begin_sheet(struct sheets *grid, const char *name);
void sheets_end_sheet(struct sheets *grid);

/* Adds a text to the current sheet, at the line and column of `where`.  It
 * becomes one line, without spaces at its ends, with composed letters
 * (encoding.h).  Returns false, and adds nothing, if it is empty.  More than
 * 100 kB in a cell makes the sheet be skipped. */
bool sheets_put_text(struct sheets *grid, struct cell where, const char *text);

/* Adds a number.  unit: what its cell shows after it, or "".  With "%", the
 * cell shows a hundred times the value, and that is what is added. */
bool sheets_put_number(
    struct sheets *grid, struct cell where, double value, const char *unit);

/* Adds a date, 2026-05-03 or 2026-05-03T10:15:00: without seconds if they are
 * zero, and without time at midnight. */
bool sheets_put_date(struct sheets *grid, struct cell where, const char *text);

/* Adds a formula that has no result.  The cell's text is the formula itself. */
bool sheets_put_formula(
    struct sheets *grid, struct cell where, const char *formula);

/* sheets_add_note adds a remark on the workbook.  From the 21st on, remarks are
 * only counted; sheets_add_count_of_omitted_notes adds how many at the end. */
void sheets_add_note(struct sheets *grid, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void sheets_add_count_of_omitted_notes(struct sheets *grid);

/* Adds the remark that sheets beyond the first `most` are not read. */
void sheets_note_too_many_sheets(struct sheets *grid, int most);

#endif
