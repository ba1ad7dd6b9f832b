/* Reads the sheets of a site, see tipspeed-site(5), and reports what is wrong
 * or ambiguous in them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_READ_H
#define TIPSPEED_IO_SITEFILE_SITE_READ_H

#include "base/error.h"
#include "core/psd/site.h"
#include "io/sitefile/site_request.h"

/* Reads a site.  On success, returns it with digest and path (of the first
 * file) set, and adds no errors.  On failure, returns NULL and at least one
 * fault: ERROR_SYSTEM if a file cannot be read; otherwise all independent
 * faults of the sheets, in file order, each an ERROR_DATA with line and column.
 * An open question is reported as one fault, and also fills *ask.  errors:
 * zeroed by the caller, never NULL.  ask: zeroed and later cleared by the
 * caller, or NULL.
 *
 * Sizes are rounded to 1e-9 mm and passings to 1e-12 %, as site_write prints
 * them, so a site and its saved copy have the same digest.  Every run satisfies
 * the rules of psd.h; feeds pass 1 on their coarsest sieve. */
struct site *site_read_with_options(const struct site_request *request,
    struct error_list *errors, struct site_ask *ask);

/* As site_read_with_options, for one file, without options. */
struct site *site_read(const char *path, struct error_list *errors);

#endif
