/* Recognises tipspeed's own results: they resemble a plant's sheets, but
 * predictions must not be read as measurements.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_RESULTS_H
#define TIPSPEED_IO_SITEFILE_RESULTS_H

struct sheet;

/* Returns the name of the command whose results a sheet contains, such as
 * "predict": from the heading of CSV output, or from the sheet "About" of a
 * workbook.  Returns NULL for other sheets, and for a template to be filled in.
 * The caller frees it. */
char *command_that_made_sheet(const struct sheet *sheet);

/* As command_that_made_sheet, for a file, also of JSON.  Reads only the first
 * lines of a text file, and a workbook only if it is small, so it is fast for
 * many files.  Returns NULL if the file cannot be read. */
char *command_that_made_file(const char *path);

#endif
