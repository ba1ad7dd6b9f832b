/* Identifiability: which parameters the data determine, according to the
 * posterior's draws.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_IDENTIFY_H
#define TIPSPEED_CORE_POSTERIOR_IDENTIFY_H

#include "core/posterior/posterior.h"

/* Grades by the ratio of the standard deviation of a parameter's draws to the
 * prior's: determined below 0.1, poorly determined below 0.5. */
enum identify_grade {
	IDENTIFY_FIXED, /* by its bounds, or because others are scaled to it */
	IDENTIFY_DETERMINED,
	IDENTIFY_POORLY,
	IDENTIFY_NOT
};

/* The draws of a parameter.  prior: the standard deviation of its prior, which
 * is normal if the model's table gives a spread, else uniform within the bounds
 * (from -1 to 1 in the gauge, as reported).  ratio: sd over prior; all
 * parameters in the gauge have the same ratio, for the direction: the RMS sine
 * of the angle to the mean direction, over its value for random directions.
 * bound: -1 or 1 if at least a fifth of the draws lie within a fiftieth of the
 * range from the lower or upper bound, else 0. */
struct identify_param {
	double mean, sd, prior, ratio;
	enum identify_grade grade;
	int bound;
};

struct identify_param identify_summarise_param(
    const struct posterior *p, size_t j);

/* Correlations between the draws of two parameters, by value (Pearson) and by
 * rank (Spearman); NAN if either is constant. */
struct identify_pair {
	double linear, rank;
};
struct identify_pair identify_correlate_params(
    const struct posterior *p, size_t i, size_t j);

/* Returns the correlation with the larger absolute value. */
double identify_larger_of_rank_or_linear(struct identify_pair pair);

/* The break size, m, at tip speed v: its mean, standard deviation and middle 80
 * %, over the draws in which something breaks.  below: the share of the draws
 * in which it is below a given size. */
struct identify_break {
	double mean, sd, low, high, below;
};
struct identify_break identify_summarise_break_size(
    const struct posterior *p, double v, double size);

#endif
