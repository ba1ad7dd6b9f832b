/* Describes how a site was read, in the two lines that load prints.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_DESCRIBE_H
#define TIPSPEED_IO_SITEFILE_SITE_DESCRIBE_H

#include "core/psd/site.h"
#include "io/sitefile/site_column.h"

/* Sets site->read_as to "sieves in column 1 (mm); feed, product@69, @79 in 2 to
 * 4 (% passing)", or to "" if the sheet has the form of tipspeed-site(5).  Adds
 * what was assumed about columns, such as "columns 2 to 4 as % passing", to
 * site->assumed. */
void site_describe_columns(struct table *const *table, size_t n_table,
    const struct columns *all, struct site *site);

#endif
