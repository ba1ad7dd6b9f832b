/* Writes a site file, see tipspeed-site(5), which site_read reads back.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_WRITE_H
#define TIPSPEED_IO_SITEFILE_SITE_WRITE_H

#include <stdbool.h>
#include <stdio.h>

#include "base/error.h"
#include "core/psd/site.h"

/* Writes the sheet, with commas, decimal points, LF and no byte order mark.
 * Sizes are in mm with up to 9 decimals, passings and standard deviations in %
 * with up to 12; a product of which no more than 1 % passes any sieve is
 * written as fractions.  A site from site_read reads back with the same digest.
 * Sieves within 1e-9 mm of each other share a row.  Returns the number of rows
 * with sieves.  The caller checks `out` for errors. */
size_t site_write(const struct site *site, FILE *out);

/* As site_write, but to a file, entirely or not at all (file.h).  *rows gets
 * the number of rows with sieves. */
bool site_save(const struct site *site, const char *path, size_t *rows,
    struct error *error);

#endif
