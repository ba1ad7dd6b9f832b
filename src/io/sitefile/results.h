/* Recognises files of tipspeed's own results, which resemble a plant's sheets:
 * predictions must not be read as measurements.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_RESULTS_H
#define TIPSPEED_IO_SITEFILE_RESULTS_H

struct sheet;

/* Returns the command whose results a sheet contains, "predict", from the
 * heading of all tables for programs, or from the sheet "About" of their
 * workbooks.  NULL for other sheets, and for a template, which is to be filled
 * in.  The caller frees. */
char *results_command(const struct sheet *sheet);

/* As results_command, for a file: of a text by its first lines alone, of
 * workbooks only small ones, so that many files can be checked.  NULL if it
 * cannot be read. */
char *results_command_in(const char *path);

#endif
