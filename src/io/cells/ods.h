/* Reads LibreOffice workbooks (OpenDocument 1.0 to 1.4, spreadsheet).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_ODS_H
#define TIPSPEED_IO_CELLS_ODS_H

#include "io/cells/archive.h"
#include "io/cells/grid.h"

/* Reads all visible sheets into the grid.  Returns NULL, or a description of
 * the fault, which the caller frees. */
char *ods_read(struct archive *archive, struct sheets *grid);

#endif
