/* Workbooks of spreadsheet programs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_WORKBOOK_H
#define TIPSPEED_IO_CELLS_WORKBOOK_H

#include <stdbool.h>
#include <stddef.h>

#include "io/cells/grid.h"

/* Whether bytes are a workbook, or a similar file, by their beginning: zip, or
 * OLE, which are old workbooks and those with a password. */
bool workbook_is(const char *bytes, size_t n);

/* Reads an .xlsx, .xlsm or .ods, recognised by its content, into grid, which is
 * new.  False and one fault of kind ERROR_DATA when it is none that can be
 * read, is damaged or locked, or has no sheet with anything in it. */
bool workbook_read(const char *bytes, size_t n, struct grid *grid);

#endif
