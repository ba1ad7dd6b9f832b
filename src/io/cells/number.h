/* Numbers of sheets, as several countries write them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_NUMBER_H
#define TIPSPEED_IO_CELLS_NUMBER_H

#include "io/cells/sheet.h"

/* Decides for the whole sheet which sign is the decimal one, by those numbers
 * that leave no choice (80,5; 1.250,5), of which most count, and then what each
 * cell is as a number.  Where there are none, numbers such as 1,250 stay
 * open. */
void number_decide(struct sheet *sheet);

/* The same with a decimal sign that somebody states. */
void number_decimal(struct sheet *sheet, char sign);

/* Finds what each cell is as a number, with the decimal sign of the sheet. */
void number_find(struct sheet *sheet);

/* The cell with another text, in the place of its own. */
struct cell number_cell(
    const struct sheet *sheet, struct cell cell, char *text);

/* The cell as a number with the decimal sign of the sheet, perhaps with the
 * other sign, blanks or apostrophes between thousands.  A fault and false when
 * it is none. */
bool number_read(
    struct sheet *sheet, struct cell cell, const char *wanted, double *value);

/* The same, but false without a fault. */
bool number_of(struct cell cell, double *value);

/* Whether it could have a decimal sign or thousands, and the sheet does not
 * tell which. */
bool number_is_open(const struct sheet *sheet, struct cell cell);

#endif
