/* Reads a site file, see tipspeed-site(5), and says what is wrong in it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITE_READ_H
#define TIPSPEED_IO_SITE_READ_H

#include "base/error.h"
#include "core/site.h"

/* Reads a site file.  On success a site with digest and path set, and nothing
 * added to errors.  On failure NULL and at least one fault: ERROR_SYSTEM when
 * the file cannot be read, otherwise all the independent faults of the sheet,
 * in file order, each of kind ERROR_DATA with its line and column.
 * errors: a list that the caller has zeroed, never NULL.
 *
 * Sizes are kept to 1e-9 mm and passings to 1e-12 %, which is what site_write
 * writes, so that a site and its saved copy have the same digest.  The rules
 * of psd.h hold in every run; feeds pass 1 on their coarsest sieve. */
struct site *site_read(const char *path, struct error_list *errors);

#endif
