/* Reads workbooks of spreadsheet programs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_WORKBOOK_H
#define TIPSPEED_IO_CELLS_WORKBOOK_H

#include <stdbool.h>
#include <stddef.h>

#include "io/cells/grid.h"

/* True if the bytes begin with the signature of zip or of OLE (old workbooks
 * and workbooks with a password). */
bool workbook_is(const char *bytes, size_t n);

/* Reads an .xlsx, .xlsm or .ods file, recognised by its content, into a new
 * grid.  Returns false with one fault of kind ERROR_DATA if the file is of
 * another kind, damaged, encrypted or without content. */
bool workbook_read(const char *bytes, size_t n, struct grid *grid);

#endif
