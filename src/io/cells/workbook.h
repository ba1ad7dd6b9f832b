/* Workbooks of spreadsheet programs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_WORKBOOK_H
#define TIPSPEED_IO_CELLS_WORKBOOK_H

#include <stdbool.h>
#include <stddef.h>

#include "io/cells/grid.h"

/* Whether bytes are a workbook, or some file like it, by what they begin with:
 * zip, or OLE, which are old workbooks and those with a password. */
bool workbook_is(const char *bytes, size_t n);

/* Reads an .xlsx, .xlsm or .ods, told by what is in it, into grid, which is
 * new.  False and one fault of kind ERROR_DATA when it is none that can be
 * read, is damaged or locked, or has no sheet with anything in it. */
bool workbook_read(const char *bytes, size_t n, struct grid *grid);

#endif
