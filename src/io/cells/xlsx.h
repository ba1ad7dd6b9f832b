/* Reads Excel workbooks (ECMA-376, Office Open XML, transitional and strict).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_XLSX_H
#define TIPSPEED_IO_CELLS_XLSX_H

#include "io/cells/archive.h"
#include "io/cells/grid.h"

/* Reads all visible worksheets.  Returns NULL, or a description of the fault,
 * which the caller frees. */
char *xlsx_read(struct archive *archive, struct sheets *grid);

#endif
