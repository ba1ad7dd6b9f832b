/* A sheet from a CSV file or a workbook, as a grid of cells with their
 * positions in the file.  The code that reads the sheet decides what the cells
 * mean.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_SHEET_H
#define TIPSPEED_IO_CELLS_SHEET_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

/* The kind of a cell in a workbook.  All cells of a text file are CELL_TEXT. */
enum cell_kind { CELL_TEXT, CELL_NUMBER, CELL_DATE };

/* How number.c reads a cell.  AS_NONE: as words or a date; AS_ABSENT: as a mark
 * for a missing number, such as "-"; AS_NUMBER: as a number; AS_PERCENT and
 * AS_GRAMS: as a number with its unit, "97,5 %", "42 g"; AS_TRACE: as an amount
 * too small to weigh, such as "trace" or "<0.1". */
enum cell_value {
	AS_NONE,
	AS_ABSENT,
	AS_NUMBER,
	AS_PERCENT,
	AS_GRAMS,
	AS_TRACE
};

/* text: without spaces at the ends, never NULL.  For CELL_NUMBER it is the
 * number as text_shortest_exact_number writes it, then the unit that the cell
 * shows: "97.5 %", "69 m/s"; for CELL_DATE "2026-05-03T10:15", "2026-05-03" or
 * "10:15".  column: the place of the first character in its line, from 1, in
 * characters, not bytes; in a workbook, 1 is column A.  number: 97.5 for a cell
 * shown as 97.5 %; NAN if the cell has no number. */
struct cell {
	char *text;
	int line, column;
	enum cell_kind kind;
	enum cell_value value;
	double number;
};

/* n: the number of cells up to the last non-empty one, at least 1.  n_all: the
 * number with the empty ones that spreadsheets add at the end.  end: the column
 * after the end of the line. */
struct row {
	size_t n, n_all;
	struct cell *cell;
	int line, end;
};

/* A line that starts with #, borrowed from the text of the sheet; in a
 * workbook, a row whose first cell is a text that starts with #. */
struct comment {
	int line;
	const char *text;
	struct row row; /* in a workbook */
};

/* The most rows, columns, cells (counting each row as long as the longest) and
 * bytes in a line of text; 0 stands for 256 columns, rows * columns cells and
 * 20000 bytes. */
struct sheet_limits {
	size_t rows, columns, cells, bytes;
};

/* A sheet.  Blank lines are not in row[]; lines that start with # are in
 * comment[] instead.  n_fault: the number of faults reported so far.  lost: a
 * line with a fault is missing from row[].  too_large: so is the rest of the
 * file, which was not read. */
struct sheet {
	char *path;
	char *name;     /* in a workbook; "" for a text file */
	char separator; /* ',', ';' or tab */
	char decimal;   /* the decimal sign, or '\0' if it is not known */
	bool mixed;     /* a second decimal sign was reported */
	/* if decimal is not known, the first number whose sign may be decimal
	 * or separate thousands, 1,250; text is NULL if there is none */
	struct cell open;
	bool lost, too_large;
	struct sheet_limits most;
	size_t n_row, n_fault;
	size_t wide; /* the number of cells in the longest row */
	struct row *row;
	size_t n_comment;
	struct comment *comment;
	struct error_list *errors; /* borrowed */
};

/* Splits a UTF-8 text with LF, CRLF or CR line ends into cells, within the
 * limits.  The text is modified and must outlive the sheet.  Faults are added
 * to errors (never NULL): a line with wrong quotes is skipped; a line beyond
 * the limits is reported, and the rest of the file is not read. */
struct sheet *sheet_new_from_text(const char *path, char *text,
    struct sheet_limits most, struct error_list *errors);
void sheet_free(struct sheet *sheet);

/* Make a sheet of a workbook.  Messages show its rows with tabs between cells.
 * sheet_set_cell adds a cell, in any order, and takes ownership of its text.
 * sheet_separate_comment_rows completes the sheet after the last cell; rows
 * that start with # become comments only then. */
struct sheet *sheet_new_empty(const char *path, const char *name,
    struct sheet_limits most, struct error_list *errors);
void sheet_set_cell(struct sheet *sheet, struct cell cell);
void sheet_separate_comment_rows(struct sheet *sheet);

/* True if adding the cell would not exceed the limits. */
bool sheet_has_room_for_cell(const struct sheet *sheet, struct cell cell);

/* Parses the address of a cell, "BC12".  Returns the text after it, or NULL if
 * it is not an address. */
const char *sheet_parse_cell_address(const char *text, int *column, int *line);

/* Turns comment i into a row, which begins with the # and goes where its line
 * belongs. */
void sheet_turn_comment_into_row(struct sheet *sheet, size_t i);

/* Returns cell i of a row.  If the row is shorter, returns an empty cell placed
 * at the end of its line. */
struct cell row_cell_at(const struct row *row, size_t i);

/* Adds a fault of kind ERROR_DATA, with text and hint as for error_set.  The
 * faults of a file stay in the order of its lines, so the list keeps the first
 * faults of the file in whatever order they are found.  Returns false. */
bool sheet_report_fault(struct sheet *sheet, struct cell where,
    const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Returns the number of bytes of a text that a message shows, ending between
 * characters. */
int sheet_truncated_text_length(const char *text);

/* Adds the fault "expected WANTED, got 'CELL'", with a long cell cut short, and
 * the hint, unless that is NULL.  Returns false. */
bool sheet_report_expected(struct sheet *sheet, struct cell found,
    const char *wanted, const char *hint, ...)
    __attribute__((format(printf, 4, 5)));

#endif
