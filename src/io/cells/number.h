/* Numbers in sheets, in the notations of several countries.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_NUMBER_H
#define TIPSPEED_IO_CELLS_NUMBER_H

#include "io/cells/sheet.h"

/* Chooses the decimal sign of the whole sheet by the majority of unambiguous
 * numbers (80,5; 1.250,5), then finds the number in each cell.  If all numbers
 * are ambiguous, such as 1,250, the sign stays open (sheet->open). */
void number_detect_decimal_sign(struct sheet *sheet);

/* As number_detect_decimal_sign, but with a given decimal sign. */
void number_set_decimal_sign(struct sheet *sheet, char sign);

/* Finds the number in each cell, with the decimal sign of the sheet. */
void number_parse_all_cells(struct sheet *sheet);

/* Returns a copy of the cell with another text and the number in it.  The text
 * is not copied. */
struct cell number_reparse_cell_with_text(
    const struct sheet *sheet, struct cell cell, char *text);

/* Reads the number in a cell, with the decimal sign of the sheet; the other
 * sign, spaces or apostrophes may separate thousands.  If the cell is not a
 * number, returns false and adds the fault that `wanted` was expected. */
bool number_read_cell(
    struct sheet *sheet, struct cell cell, const char *wanted, double *value);

/* As number_read_cell, but adds no fault. */
bool number_value_of_cell(struct cell cell, double *value);

/* Returns the length in bytes of the thousands separator at s, or 0 if there is
 * none.  It knows those that are valid with either decimal sign: spaces,
 * including no-break spaces, and apostrophes. */
size_t number_thousands_separator_bytes(const char *s);

/* True if the sign in a cell's number may be decimal or separate thousands, and
 * the rest of the sheet does not tell which. */
bool number_is_ambiguous(const struct sheet *sheet, struct cell cell);

#endif
