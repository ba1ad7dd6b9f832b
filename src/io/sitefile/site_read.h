/* Reads the sheets of a site, see tipspeed-site(5), and reports what is wrong
 * or open in them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_READ_H
#define TIPSPEED_IO_SITEFILE_SITE_READ_H

#include "base/error.h"
#include "core/psd/site.h"
#include "io/sitefile/site_request.h"

/* Reads a site.  On success a site with digest and path (of the first file)
 * set, and nothing added to errors.  On failure NULL and at least one fault:
 * ERROR_SYSTEM when a file cannot be read, otherwise all the independent faults
 * of the sheets, in file order, each of kind ERROR_DATA with its line and
 * column; where something is open, one fault says so and *ask holds the
 * question.  errors: a list that the caller has zeroed, never NULL.  ask:
 * zeroed by the caller, who clears it, or NULL.
 *
 * Sizes are kept to 1e-9 mm and passings to 1e-12 %, which is what site_write
 * writes, so that a site and its saved copy have the same digest.  The rules
 * of psd.h hold in every run; feeds pass 1 on their coarsest sieve. */
struct site *site_read_as(const struct site_request *request,
    struct error_list *errors, struct site_ask *ask);

/* The same for one file, without options. */
struct site *site_read(const char *path, struct error_list *errors);

#endif
