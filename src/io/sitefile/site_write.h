/* Writes a site file, see tipspeed-site(5), that site_read reads back.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_WRITE_H
#define TIPSPEED_IO_SITEFILE_SITE_WRITE_H

#include <stdbool.h>
#include <stdio.h>

#include "base/error.h"
#include "core/psd/site.h"

/* Writes the sheet: comma, decimal point, LF, no byte order mark; sizes in mm
 * to 9 decimals, passing and standard deviations in % to 12; a product that
 * passes 1 % or less everywhere as fractions.  A site that came from site_read
 * reads back with the same digest.  Sieves nearer than 1e-9 mm are one row.
 * Returns the number of rows of sieves.  The caller checks `out` for errors. */
size_t site_write(const struct site *site, FILE *out);

/* As site_write, to a file, whole or not at all, see file.h. */
bool site_save(const struct site *site, const char *path, size_t *rows,
    struct error *error);

#endif
