/* The sheets of a text file or a workbook.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_CELLS_SOURCE_H
#define TIPSPEED_IO_CELLS_SOURCE_H

#include "io/cells/sheet.h"

/* sheet [n]: the only sheet of a text file, or the visible sheets of a
 * workbook.  note: how the file was read ("read as Windows-1252"), or "".
 * text: the text file, which its sheet borrows; NULL for a workbook. */
struct source {
	size_t n;
	struct sheet **sheet;
	char *note, *text;
};

/* The size of the largest sheet that source_read_sheets accepts, as members of
 * struct sheet_limits.  A site has a column for each sample, and each is
 * compared with all others. */
enum { SOURCE_MOST_COLUMNS = 4000, SOURCE_MOST_CELLS = 2000 * 256 };

/* Reads a file.  Faults are added to errors, to which the sheets keep a pointer
 * and may add later.  Returns false after a fault that leaves nothing to read.
 * The caller frees *source in either case. */
bool source_read_sheets(
    const char *path, struct error_list *errors, struct source *source);

/* As source_read_sheets, but for a text in memory.  path: what faults call
 * it. */
bool source_read_from_memory(const char *path, const char *text,
    struct error_list *errors, struct source *source);

/* As source_read_sheets, but for a plant's log, which may have many more lines.
 */
bool source_read_plant_log_sheets(
    const char *path, struct error_list *errors, struct source *source);
void source_free(struct source *source);

#endif
