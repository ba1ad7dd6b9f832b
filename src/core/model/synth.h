/* Synthetic runs from known parameters.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_SYNTH_H
#define TIPSPEED_CORE_MODEL_SYNTH_H

#include <stdint.h>

#include "core/model/params.h"
#include "core/psd/site.h"

/* The data from which a synthetic site is made. */
struct synth {
	double top_size; /* m */
	struct params params;
	bool individual_feeds; /* one feed per run, else one for all */
	double n;              /* exponent of the feed below the top size */
	double noise;          /* passing, 0..1: standard deviation at 50 % */
	uint64_t seed;
	size_t n_speed;
	const double *speed; /* m/s, rising */
};

/* A site with runs at each speed; strings are left empty.
 *
 * Feed: 100 % passes twice the top size, 90 % the top size, straight on log
 * size between; below it 90 (d/D)^n, on the EN 933 sieves down to 0.063 mm, to
 * 0.01 %.  An individual feed has n times 1 + 0.05 z, z standard normal.
 * Product: the model's, method continuous, k = 1; on each sieve a normal error
 * of standard deviation 2 noise sqrt(P (1 - P)), as when P is a share counted
 * in a sample; then no passing above that of the next coarser sieve, to 0.01 %.
 *
 * The errors depend on the seed and on the numbers above, not on names: two
 * sites with the same numbers (departure D9) get the same runs. */
struct site *synth_site(const struct synth *synth);

#endif
