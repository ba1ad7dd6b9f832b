/* Counts of what the program says of itself: what is promised, and how often it
 * was so.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BENCH_COUNTS_H
#define TIPSPEED_BENCH_COUNTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/posterior/posterior.h"
#include "core/search/calibrate.h"

/* Each prints its table for n cases of a kind; false: outside its limits. */
bool count_drift(size_t n);
bool count_guess(size_t n);
bool count_params(size_t n);
bool count_power(size_t n);
bool count_speeds(size_t n);

/* Prints a share in per cent with its standard error; whether it lies within
 * least..most but for three standard errors. */
bool counts_share(size_t inside, size_t n, double least, double most);

/* Calibrates a site on all its runs and draws; posterior_free. */
struct posterior *counts_calibrate(
    const struct site *site, uint64_t seed, struct fit *fit);

#endif
