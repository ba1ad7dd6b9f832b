/* Recognises tipspeed's own results, which resemble a plant's sheets, as
 * predictions must not be read as measurements.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_RESULTS_H
#define TIPSPEED_IO_SITEFILE_RESULTS_H

struct sheet;

/* Returns the command whose results a sheet contains, such as "predict", from
 * the heading of tables for programs or from the sheet "About" of workbooks.
 * Returns NULL for other sheets and for a template to be filled in.  The caller
 * frees it. */
char *command_that_made_sheet(const struct sheet *sheet);

/* As command_that_made_sheet, for a file: a text by its first lines only, a
 * workbook only if it is small, which is fast for many files.  Returns NULL if
 * it cannot be read. */
char *command_that_made_file(const char *path);

#endif
