/* What the reader of a sheet passed over, so that nobody believes it was read.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITE_LEFT_OUT_H
#define TIPSPEED_IO_SITE_LEFT_OUT_H

#include "core/site.h"
#include "io/site_column.h"

/* Fills in site->left_out and site->named from a table that was read without a
 * fault. */
void site_left_out(struct site *site, const struct table *t);

#endif
