/* Files of tipspeed's own results, which look much like sheets of a plant: what
 * was predicted must not come back as measured.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_RESULTS_H
#define TIPSPEED_IO_SITEFILE_RESULTS_H

struct sheet;

/* The command whose results a sheet has, "predict": by the head that all tables
 * for programs have, or by the sheet "About" of their workbooks.  NULL where it
 * has none, as a template, which is to be filled in.  The caller frees. */
char *results_command(const struct sheet *sheet);

/* The same of a file of text, by its first lines alone, as for many files.  One
 * that cannot be read has none. */
char *results_command_in(const char *path);

#endif
