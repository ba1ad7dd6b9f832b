/* Identifiability: which parameters the data determine, read off the draws of
 * the posterior.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_IDENTIFY_H
#define TIPSPEED_CORE_POSTERIOR_IDENTIFY_H

#include "core/model/params.h"
#include "core/posterior/posterior.h"

/* By the standard deviation of a parameter's draws over that of its prior:
 * determined below 0.1, poorly below 0.5. */
enum identify_grade {
	IDENTIFY_FIXED, /* held by a bound, or the one that others are scaled
			 * to */
	IDENTIFY_DETERMINED,
	IDENTIFY_POORLY,
	IDENTIFY_NOT
};

/* A parameter's draws.  prior: standard deviation of its prior, uniform within
 * the bounds (of a parameter in the gauge from -1 to 1, as it is reported), or
 * the normal one of its table.  ratio: sd over prior; of a parameter in the
 * gauge the ratio of their direction, equal for all: the sine of the angle to
 * the mean direction (RMS) over its value for random directions.  bound: -1 or
 * 1 where at least a fifth of the draws lie within the fiftieth of the range
 * next to the lower or upper bound, else 0. */
struct identify_param {
	double mean, sd, prior, ratio;
	enum identify_grade grade;
	int bound;
};

/* Returns the summary of parameter j of the posterior's model. */
struct identify_param identify_param(const struct posterior *p, size_t j);

/* Correlations of two parameters' draws, of their values (Pearson) and of their
 * ranks (Spearman); NAN where one of them never changes. */
struct identify_pair {
	double linear, rank;
};
struct identify_pair identify_pair(
    const struct posterior *p, size_t i, size_t j);

/* Returns the larger correlation by absolute value, with its sign. */
double identify_strongest(struct identify_pair pair);

/* The break size at a tip speed v: mean and standard deviation of the draws in
 * which something breaks, their middle 80 %, m; below: share of the draws in
 * which it lies below a size. */
struct identify_break {
	double mean, sd, low, high, below;
};
struct identify_break identify_break(
    const struct posterior *p, double v, double size);

#endif
