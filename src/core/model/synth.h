/* Synthetic runs from known parameters.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_SYNTH_H
#define TIPSPEED_CORE_MODEL_SYNTH_H

#include <stdint.h>

#include "core/model/params.h"
#include "core/psd/site.h"

struct synth {
	double top_size; /* m */
	struct params params;
	bool individual_feeds; /* a feed for each run, else one for all */
	double n;              /* exponent of the feed below the top size */
	double noise;          /* standard deviation at 50 % passing, 0..1 */
	uint64_t seed;
	size_t n_speed;
	const double *speed; /* m/s, rising */
};

/* Returns a site with a run at each speed; its strings are empty.
 *
 * Feed: 100 % passes twice the top size and 90 % the top size, linear in log
 * size between; below that, 90 (d/D)^n, on the EN 933 sieves down to 0.063 mm,
 * rounded to 0.01 %.  In an individual feed, n is multiplied by 1 + 0.05 z, z
 * standard normal.  Product: that of the model, method continuous, k = 1, plus
 * a normal error on each sieve with standard deviation 2 noise sqrt(P (1 - P)),
 * as for a share P counted in a sample.  No passing then exceeds that of the
 * next coarser sieve; all are rounded to 0.01 %.
 *
 * The errors depend on the seed and on the numbers above, not on names: two
 * sites with the same numbers (departure D9) get the same runs. */
struct site *synth_make_site(const struct synth *synth);

#endif
