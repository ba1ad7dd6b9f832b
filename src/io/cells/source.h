/* The sheets of a file, whatever kind of file it is.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_SOURCE_H
#define TIPSPEED_IO_CELLS_SOURCE_H

#include "io/cells/sheet.h"

/* sheet [n]: one of a text, each of a workbook's that can be seen.  note: what
 * was done to read it ("read as Windows-1252"), or "". */
struct source {
	size_t n;
	struct sheet **sheet;
	char *note, *text;
};

/* What a sheet is that source_read takes: of a grid of its rows, each as long
 * as the longest. */
enum { SOURCE_MOST_CELLS = 2000 * 256 };

/* Reads a file.  errors: as for site_read; the sheets go on adding to it.
 * False after a fault that leaves nothing to look at.  The caller frees in
 * either case. */
bool source_read(
    const char *path, struct error_list *errors, struct source *source);

/* The same of a text that is in memory; path: what faults call it. */
bool source_read_text(const char *path, const char *text,
    struct error_list *errors, struct source *source);

/* The same of a plant's log, which has many more lines. */
bool source_read_log(
    const char *path, struct error_list *errors, struct source *source);
void source_free(struct source *source);

#endif
