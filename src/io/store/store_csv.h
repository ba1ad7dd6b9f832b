/* Materials as a CSV sheet, for moving them between stores and for backups.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_STORE_CSV_H
#define TIPSPEED_IO_STORE_STORE_CSV_H

#include <stdbool.h>

#include "base/error.h"
#include "io/store/material.h"

/* Writes a line of column names and a line for each material, with exact
 * numbers, to a file, entirely or not at all.  Reading such a sheet and writing
 * it again gives the same bytes. */
bool store_csv_write_file(
    const struct material_list *list, const char *path, struct error *error);

/* Reads such a sheet, with its columns in any order.  there: materials whose
 * names must not occur in it, or NULL.  On failure, returns false and adds all
 * faults of the sheet, each with line and column, to errors, which the caller
 * has zeroed; list then has some of the rows. */
bool store_csv_read_file(const char *path, const struct material_list *there,
    struct material_list *list, struct error_list *errors);

#endif
