/* A sheet, of a CSV file or a workbook, as a grid of cells with their places in
 * the file.  The reader of the sheet decides what the cells mean.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_SHEET_H
#define TIPSPEED_IO_CELLS_SHEET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/error.h"

/* The kind of a workbook's cell; all cells of a text file are CELL_TEXT. */
enum cell_kind { CELL_TEXT, CELL_NUMBER, CELL_DATE };

/* How number.c reads a cell: as words or a date; as a sign for no number, such
 * as "-"; as a number, alone or before a unit, "97,5 %", "42 g"; as a trace,
 * "<0.1". */
enum cell_value {
	AS_NONE,
	AS_ABSENT,
	AS_NUMBER,
	AS_PERCENT,
	AS_GRAMS,
	AS_TRACE
};

/* text: without spaces at both ends, never NULL.  For CELL_NUMBER it is the
 * number as text_exact writes it, then the unit that the cell is shown with:
 * "97.5 %", "69 m/s".  For CELL_DATE it is "2026-05-03T10:15", "2026-05-03" or
 * "10:15".  column: place of the first character, counted from 1 in characters,
 * not bytes; in a workbook 1 is A.  number: 97.5 for a cell shown as 97.5 %;
 * NAN if the cell has no number. */
struct cell {
	char *text;
	int line, column;
	enum cell_kind kind;
	enum cell_value value;
	double number;
};

/* n: cells up to the last that is not empty, 1 or more.  n_all: cells including
 * the empty ones that spreadsheets add at the end.  end: column after the
 * line. */
struct row {
	size_t n, n_all;
	struct cell *cell;
	int line, end;
};

/* A line that starts with #, borrowed from the text of the sheet; in a workbook
 * a row whose first cell is a text that starts with #. */
struct comment {
	int line;
	const char *text;
	struct row row; /* in a workbook */
};

/* rows: most rows.  cells: most cells in a grid of all rows, each as long as
 * the longest; 0: as many as those rows with 256 cells each. */
struct sheet_limits {
	size_t rows, cells;
};

/* Blank lines are left out of row[], and lines that start with # are in
 * comment[] instead.  n_fault: the number of faults reported so far.  lost: a
 * line is missing from row[].  too_large: so is everything after that line,
 * which is not read. */
struct sheet {
	char *path;
	char *name;       /* in a workbook; "" for a text */
	char separator;   /* ',', ';' or tab */
	char decimal;     /* decimal sign of its numbers; '\0': none has one */
	bool mixed;       /* a second decimal sign was reported */
	struct cell open; /* a number whose sign may be decimal or separate
			   * thousands, 1,250; text NULL: there is none */
	bool lost, too_large;
	struct sheet_limits most;
	size_t n_row, room, most_line, n_fault; /* room for rows */
	size_t wide;                            /* cells of the longest row */
	struct row *row;
	size_t n_comment;
	struct comment *comment;
	struct error_list *errors; /* borrowed */
};

/* Splits a text in UTF-8 with LF, CRLF or CR line ends into cells, within the
 * limits and with at most 256 cells a line.  The text is changed, and must
 * outlive the sheet.  Faults are put into errors (never NULL): a line with
 * wrong quotes is left out, a line beyond the limits ends the sheet. */
struct sheet *sheet_new(const char *path, char *text, struct sheet_limits most,
    struct error_list *errors);
void sheet_free(struct sheet *sheet);

/* As sheet_new, for a text that the program itself may have written, without
 * limits on lines. */
struct sheet *sheet_new_own(
    const char *path, char *text, struct error_list *errors);

/* Make a sheet of a workbook; messages show its rows with tabs between cells.
 * sheet_put adds a cell, in any order, and takes over its text.  sheet_end ends
 * the sheet after its last cell; before that no row is a comment. */
struct sheet *sheet_begin(const char *path, const char *name,
    struct sheet_limits most, struct error_list *errors);
void sheet_put(struct sheet *sheet, struct cell cell);
void sheet_end(struct sheet *sheet);

/* True if sheet_put can add the cell: another row, or a cell in this column, is
 * within the limits. */
bool sheet_has_room(const struct sheet *sheet, struct cell cell);

/* Turns comment i into a row, in the order of the lines; the # is part of the
 * row. */
void sheet_uncomment(struct sheet *sheet, size_t i);

/* Returns cell i of a row, or an empty cell at the end of the line if the row
 * is shorter. */
struct cell sheet_cell(const struct row *row, size_t i);

/* Adds a fault of kind ERROR_DATA, text and hint as for error_set, in its place
 * among the faults of the same file: the list contains the first faults of the
 * file, in whatever order they are found.  Returns false. */
bool sheet_fault(struct sheet *sheet, struct cell where, const char *format,
    ...) __attribute__((format(printf, 3, 4)));

/* Returns how many bytes of a long text a message shows; a cut never falls
 * inside a character. */
int sheet_cut_length(const char *text);

/* Adds the fault "expected WANTED, got 'CELL'", the cell cut if it is long,
 * with a hint (NULL: none).  Returns false. */
bool sheet_fault_expected(struct sheet *sheet, struct cell found,
    const char *wanted, const char *hint, ...)
    __attribute__((format(printf, 4, 5)));

/* Writes a cell that reads back as the same text: in quotes where needed, and
 * never as a formula. */
void sheet_write_cell(const char *text, char separator, FILE *out);

#endif
