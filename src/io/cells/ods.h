/* Reads workbooks of LibreOffice (OpenDocument 1.0 to 1.4, spreadsheet).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_ODS_H
#define TIPSPEED_IO_CELLS_ODS_H

#include "io/cells/archive.h"
#include "io/cells/grid.h"

/* Reads all sheets that are not hidden.  Returns NULL, or what is wrong with
 * the workbook, as a text that the caller frees. */
char *ods_read(struct archive *archive, struct grid *grid);

#endif
