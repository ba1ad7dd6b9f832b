/* The sheets of a file of any kind.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_SOURCE_H
#define TIPSPEED_IO_CELLS_SOURCE_H

#include "io/cells/sheet.h"

/* sheet [n]: the only one of a text, or the visible ones of a workbook.  note:
 * how it was read ("read as Windows-1252"), or "". */
struct source {
	size_t n;
	struct sheet **sheet;
	char *note, *text;
};

/* The largest sheet that source_read takes: cells in a grid of its rows, each
 * as long as the longest. */
enum { SOURCE_MOST_CELLS = 2000 * 256 };

/* Reads a file.  errors: as for site_read; the sheets go on adding to it.
 * False after a fault that leaves nothing to look at.  The caller frees in
 * either case. */
bool source_read(
    const char *path, struct error_list *errors, struct source *source);

/* The same for a text in memory; path: its name in faults. */
bool source_read_text(const char *path, const char *text,
    struct error_list *errors, struct source *source);

/* The same for a plant's log, which may have many more lines. */
bool source_read_log(
    const char *path, struct error_list *errors, struct source *source);
void source_free(struct source *source);

#endif
