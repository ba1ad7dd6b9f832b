/* Long (tidy) tables: each line is one number, with its sieve and its sample.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_LAYOUT_LONG_H
#define TIPSPEED_IO_SITEFILE_LAYOUT_LONG_H

#include <stdbool.h>
#include <stdint.h>

#include "io/sitefile/layout.h"

/* Turns a long table, with a line for each sieve of each sample, into one with
 * a column for each sample; leaves other tables unchanged.  False, with a
 * fault, if there are too many samples.  told: the words of a heading of sieves
 * given by hand, or 0. */
bool layout_widen(struct table *t, uint64_t told);

#endif
