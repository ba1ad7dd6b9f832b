/* Recognises files of tipspeed's own results, which resemble a plant's sheets:
 * predictions must not be read as measurements.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_RESULTS_H
#define TIPSPEED_IO_SITEFILE_RESULTS_H

struct sheet;

/* The command whose results a sheet has, "predict": by the heading that all
 * tables for programs have, or by the sheet "About" of their workbooks.  NULL
 * for other sheets, and for a template, which is to be filled in.  The caller
 * frees. */
char *results_command(const struct sheet *sheet);

/* The same for a text file, by its first lines alone, so that many files can be
 * checked.  NULL where it cannot be read. */
char *results_command_in(const char *path);

#endif
