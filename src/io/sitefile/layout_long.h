/* Long (tidy) tables, in which each line has one number, with its sieve and its
 * sample.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_LAYOUT_LONG_H
#define TIPSPEED_IO_SITEFILE_LAYOUT_LONG_H

#include <stdbool.h>
#include <stdint.h>

#include "io/sitefile/layout.h"

/* Turns a long table into one with a column for each sample; leaves other
 * tables unchanged.  Returns false with a fault if there are too many samples.
 * told: the meanings of the heading that the user gave the sieves, or 0. */
bool layout_long_to_wide(struct table *t, uint64_t told);

#endif
