/* Numbers of sheets, as several countries write them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_NUMBER_H
#define TIPSPEED_IO_CELLS_NUMBER_H

#include "io/cells/sheet.h"

/* Decides the decimal sign for the whole sheet, by the majority of the
 * unambiguous numbers (80,5; 1.250,5), and then the number in each cell.  Where
 * there are none, numbers such as 1,250 stay open. */
void number_decide(struct sheet *sheet);

/* The same with a given decimal sign. */
void number_decimal(struct sheet *sheet, char sign);

/* Finds the number in each cell, with the decimal sign of the sheet. */
void number_find(struct sheet *sheet);

/* The cell with another text instead of its own. */
struct cell number_cell(
    const struct sheet *sheet, struct cell cell, char *text);

/* The cell as a number with the decimal sign of the sheet, perhaps with the
 * other sign, blanks or apostrophes between thousands.  A fault and false when
 * it is none. */
bool number_read(
    struct sheet *sheet, struct cell cell, const char *wanted, double *value);

/* The same, but false without a fault. */
bool number_of(struct cell cell, double *value);

/* Whether its sign could be decimal or separate thousands, and the sheet leaves
 * that open. */
bool number_is_open(const struct sheet *sheet, struct cell cell);

#endif
