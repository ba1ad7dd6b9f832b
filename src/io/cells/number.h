/* Numbers in sheets, in the notations of several countries.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_NUMBER_H
#define TIPSPEED_IO_CELLS_NUMBER_H

#include "io/cells/sheet.h"

/* Chooses the decimal sign of the whole sheet by the majority of unambiguous
 * numbers (80,5; 1.250,5), then finds the number in each cell.  Without an
 * unambiguous number, numbers such as 1,250 remain open. */
void number_choose_decimal_sign(struct sheet *sheet);

/* As number_choose_decimal_sign, but with a given decimal sign. */
void number_set_decimal_sign(struct sheet *sheet, char sign);

/* Finds the number in each cell, with the decimal sign of the sheet. */
void number_find_in_all_cells(struct sheet *sheet);

/* Returns the cell with its text replaced, read as a number. */
struct cell number_cell_from_text(
    const struct sheet *sheet, struct cell cell, char *text);

/* Reads the cell as a number with the decimal sign of the sheet; the other
 * sign, spaces or apostrophes may separate thousands.  Adds a fault and returns
 * false if the cell is not a number. */
bool number_read_cell(
    struct sheet *sheet, struct cell cell, const char *wanted, double *value);

/* As number_read_cell, but adds no fault. */
bool number_value_of_cell(struct cell cell, double *value);

/* Returns the length in bytes of a separator of thousands at s that is valid
 * with either decimal sign: a space, also one that does not break, or an
 * apostrophe; 0 if there is none. */
size_t number_thousands_separator_bytes(const char *s);

/* True if a sign in the cell could be decimal or separate thousands, and the
 * sheet does not show which. */
bool number_is_ambiguous(const struct sheet *sheet, struct cell cell);

#endif
