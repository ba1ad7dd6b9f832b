/* A hidden plant to train at: known to nobody but its seed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_DRILL_H
#define TIPSPEED_CORE_CHECK_DRILL_H

#include <stdbool.h>
#include <stdint.h>

#include "core/model/synth.h"

/* Speeds of samples and answers, m/s. */
enum { DRILL_SLOWEST = 60, DRILL_FASTEST = 90 };

/* A sieve, m, and what has to pass it: at least, or (most) at most. */
struct drill_condition {
	double size, passing; /* 0..1, to a tenth of a point */
	bool most;
};
enum { DRILL_CONDITIONS = 2 };

/* Easy: the paper's model and careful samples.  hard: progeny finer at higher
 * energy (gamma), samples that err by twice as much, and a window half as wide.
 * The product meets both conditions from slowest to fastest, m/s: a faster
 * rotor never makes a coarser product. */
struct drill_plant {
	uint64_t seed;
	bool hard;
	struct synth made; /* speeds and seed are of no account */
	struct drill_condition condition[DRILL_CONDITIONS];
	double slowest, fastest;
};

/* Made of the seed alone. */
struct drill_plant drill_plant(uint64_t seed, bool hard);

/* Its feed as a site; a sample of its product, the n-th, as another: alone, and
 * with the error of sampling.  The caller frees; strings are empty. */
struct site *drill_feed(const struct drill_plant *plant);
struct site *drill_sample(
    const struct drill_plant *plant, double speed, size_t n);

/* What truly passes sizes [n], m, coarsest first, at a speed: passing out. */
void drill_truth(const struct drill_plant *plant, double speed,
    const double *size, size_t n, double *passing);

/* How far a speed lies from the nearer end of those that meet the conditions,
 * m/s; negative outside them. */
double drill_margin(const struct drill_plant *plant, double speed);

#endif
