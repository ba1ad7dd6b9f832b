/* Numbers in sheets, as several countries write them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_NUMBER_H
#define TIPSPEED_IO_CELLS_NUMBER_H

#include "io/cells/sheet.h"

/* Decides the decimal sign of the whole sheet, by the majority of the
 * unambiguous numbers (80,5; 1.250,5), and then finds the number in each cell.
 * If no number is unambiguous, numbers such as 1,250 remain open. */
void number_decide(struct sheet *sheet);

/* As number_decide, but with a given decimal sign. */
void number_decimal(struct sheet *sheet, char sign);

/* Finds the number in each cell, with the decimal sign of the sheet. */
void number_find(struct sheet *sheet);

/* Returns the cell with another text in place of its own, read as a number. */
struct cell number_cell(
    const struct sheet *sheet, struct cell cell, char *text);

/* Reads the cell as a number with the decimal sign of the sheet, perhaps with
 * the other sign, blanks or apostrophes between thousands.  False, after a
 * fault, if the cell is no number. */
bool number_read(
    struct sheet *sheet, struct cell cell, const char *wanted, double *value);

/* As number_read, but false without a fault. */
bool number_of(struct cell cell, double *value);

/* True if the sign in a cell could be decimal or separate thousands, and the
 * sheet does not decide which. */
bool number_is_open(const struct sheet *sheet, struct cell cell);

#endif
