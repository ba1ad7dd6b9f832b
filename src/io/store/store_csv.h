/* Materials as a CSV sheet, for moving them between stores and for backups.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_STORE_CSV_H
#define TIPSPEED_IO_STORE_STORE_CSV_H

#include <stdbool.h>

#include "base/error.h"
#include "io/store/material.h"

/* Writes a line of column names and a line for each material, numbers exact, to
 * a file, whole or not at all.  A sheet that was read is written with the same
 * bytes. */
bool store_csv_save(
    const struct stored_list *list, const char *path, struct error *error);

/* Reads such a sheet, in any order of its columns.  there: materials with names
 * that must not occur, or NULL.  On failure false, and all the faults of the
 * sheet in errors, which the caller has zeroed, each with its line and column;
 * list then contains some of the rows. */
bool store_csv_read(const char *path, const struct stored_list *there,
    struct stored_list *list, struct error_list *errors);

#endif
