/* Workbooks of Excel (ECMA-376, Office Open XML, transitional and strict).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_XLSX_H
#define TIPSPEED_IO_CELLS_XLSX_H

#include "io/cells/archive.h"
#include "io/cells/grid.h"

/* Reads all worksheets that are not hidden.  Returns NULL, or what is wrong
 * with the workbook, as a text that the caller frees. */
char *xlsx_read(struct archive *archive, struct grid *grid);

#endif
