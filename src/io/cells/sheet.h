/* A CSV sheet as a grid of cells, each knowing its place in the file.  What
 * the cells mean is left to the reader of the sheet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_SHEET_H
#define TIPSPEED_IO_CELLS_SHEET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "base/error.h"

/* The kind of a workbook's cell; all cells of a text file are CELL_TEXT. */
enum cell_kind { CELL_TEXT, CELL_NUMBER, CELL_DATE };

/* What number.c reads a cell as: words or a date; a sign for no number, such as
 * "-"; a number, alone or before a unit, "97,5 %", "42 g"; a trace, "<0.1". */
enum cell_value {
	AS_NONE,
	AS_ABSENT,
	AS_NUMBER,
	AS_PERCENT,
	AS_GRAMS,
	AS_TRACE
};

/* text: without spaces at both ends, never NULL; of CELL_NUMBER as text_exact
 * writes it, then a unit that the cell is shown with: "97.5 %", "69 m/s"; of
 * CELL_DATE "2026-05-03T10:15", "2026-05-03" or "10:15".  column: of its first
 * character, counted from 1 in characters, not bytes; in a workbook 1 is A.
 * number: 97.5 of one shown as 97.5 %; NAN where the value has none. */
struct cell {
	char *text;
	int line, column;
	enum cell_kind kind;
	enum cell_value value;
	double number;
};

/* n: cells up to the last that is not empty, 1 or more.  n_all: with the empty
 * ones that spreadsheets add at the end.  end: column after the line. */
struct row {
	size_t n, n_all;
	struct cell *cell;
	int line, end;
};

/* A line that starts with #, borrowed from the text of the sheet; in a workbook
 * a row whose first cell does, which is text. */
struct comment {
	int line;
	const char *text;
	struct row row; /* of a workbook */
};

/* cells: of a grid of all rows, each as long as the longest; 0: of rows with
 * 256 cells. */
struct sheet_limits {
	size_t rows, cells;
};

/* Blank lines are left out of row[], and lines that start with # are in
 * comment[] instead.  n_fault counts the faults reported so far; lost: a line
 * is not in row[]; too_large: nor is what comes after it, so that the rest is
 * not read. */
struct sheet {
	char *path;
	char *name;       /* in a workbook; "" of a text */
	char separator;   /* ',', ';' or tab */
	char decimal;     /* decimal sign of its numbers; '\0': none has one */
	bool mixed;       /* a second decimal sign was reported */
	struct cell open; /* a number that may have one, or thousands:
			   * 1,250; text is NULL where there is none */
	bool lost, too_large;
	struct sheet_limits most;
	size_t n_row, room, most_line, n_fault; /* room: for rows */
	size_t wide;                            /* cells of the longest row */
	struct row *row;
	size_t n_comment;
	struct comment *comment;
	struct error_list *errors; /* borrowed */
};

/* Splits a text of UTF-8 with LF, CRLF or CR line ends, within limits and at
 * most 256 cells a line.  The text is changed, and must outlive the sheet.
 * Faults are put into errors (never NULL): a line with wrong quotes is left
 * out, one beyond the limits ends the sheet. */
struct sheet *sheet_new(const char *path, char *text, struct sheet_limits most,
    struct error_list *errors);
void sheet_free(struct sheet *sheet);

/* The same for a text that the program itself may have written, without limits
 * on lines. */
struct sheet *sheet_new_own(
    const char *path, char *text, struct error_list *errors);

/* A sheet of a workbook, with tabs between its cells where a message shows one.
 * sheet_put: one more cell, in any order, whose text it takes.  sheet_end: all
 * are there; until then no row is a comment. */
struct sheet *sheet_begin(const char *path, const char *name,
    struct sheet_limits most, struct error_list *errors);
void sheet_put(struct sheet *sheet, struct cell cell);
void sheet_end(struct sheet *sheet);

/* What sheet_put takes: another row or a cell in this column. */
bool sheet_has_room(const struct sheet *sheet, struct cell cell);

/* Makes a row of comment i, in the order of the lines, which the # is part
 * of. */
void sheet_uncomment(struct sheet *sheet, size_t i);

/* Cell i of a row; an empty one at the end of the line when there is none. */
struct cell sheet_cell(const struct row *row, size_t i);

/* One more fault of kind ERROR_DATA, text and hint as for error_set, put in its
 * place among those of the same file: the list holds the first faults of the
 * file, whatever the order in which they are found.  Returns false. */
bool sheet_fault(struct sheet *sheet, struct cell where, const char *format,
    ...) __attribute__((format(printf, 3, 4)));

/* How many bytes of a long text a message shows; a cut never falls inside a
 * character. */
int sheet_cut(const char *text);

/* The fault "expected WANTED, got 'CELL'", the cell cut when long, with a
 * hint (NULL: none).  Returns false. */
bool sheet_wanted(struct sheet *sheet, struct cell found, const char *wanted,
    const char *hint, ...) __attribute__((format(printf, 4, 5)));

/* Writes a cell so that it reads back: in quotes where needed, and not as a
 * formula. */
void sheet_write_cell(const char *text, char separator, FILE *out);

#endif
