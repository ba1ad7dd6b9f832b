/* Routine samples on control charts, against what is predicted for them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_CONTROL_CHART_H
#define TIPSPEED_CORE_CHECK_CONTROL_CHART_H

#include <stddef.h>
#include <stdint.h>

#include "core/posterior/posterior.h"

/* The two numbers of a sample that are followed: the mean of its residuals,
 * measured less predicted, over the sieves; and the rise of their straight line
 * in ln size from the finest to the coarsest sieve, less the part that this
 * rise has in common with the mean.  Both are known to be 0 but for a variance
 * that follows from the posterior. */
enum drift_component { DRIFT_LEVEL, DRIFT_TILT, DRIFT_COMPONENTS };

/* k, h: allowance and limit of the CUSUM, in standard deviations; lambda,
 * width: weight of the newest in the EWMA, and its limit in standard deviations
 * of its own; cuts: for how many cuts the posterior's size of the errors
 * counts, beside the size that the cuts themselves show. */
struct drift_rule {
	double k, h, lambda, width, cuts;
};
extern const struct drift_rule DRIFT_RULE;

/* A sample.  size [n] m, coarsest first; residual [n] passing, 0..1.  truth
 * [n * n_draw] row by size: the answers of the draws; draw i is the same draw
 * in every sample; n_draw 0: the answers are certain.  error [n * n]:
 * covariance of the error of one sample. */
struct drift_cut {
	size_t n;
	const double *size, *residual;
	size_t n_draw;
	const double *truth, *error;
};

enum drift_state {
	DRIFT_NONE,
	DRIFT_COARSER,
	DRIFT_FINER,
	DRIFT_FLATTER,
	DRIFT_STEEPER
};

/* One component after a sample.  value: passing, 0..1; truth, error: its
 * standard deviations by the draws and by the posterior's sampling; off: its
 * distance from the prediction of the earlier samples, in standard deviations;
 * score: as off, but with the size of the errors estimated from the earlier
 * samples too: standard normal without drift, and independent of the others.
 * down is positive. */
struct drift_chart {
	double value, truth, error, off, score, ewma, ewma_limit, up, down;
};
struct drift_point {
	struct drift_chart chart[DRIFT_COMPONENTS];
	enum drift_state state;
};

/* Follows samples [n] in their order, point [n] out.  Returns the first sample
 * after which a chart is beyond its limit, n where none is; *since: the sample
 * with which its CUSUM began to rise.
 *
 * The unknown part of the truth is common to all samples, so that their values
 * are correlated, and charts of the values would signal more often than stated.
 * `off` is the value less its prediction from the earlier values, over the
 * standard deviation that remains: L^-1 value, L the Cholesky factor of their
 * covariance.  The posterior gives a rough size of the errors of cuts: off,
 * over the root mean square of the earlier ones, to which the posterior adds
 * rule->cuts values of 1, has Student's t distribution, and the score is the
 * normal number of the same probability.  After a signal, samples after `since`
 * are not used to predict, lest the drift itself be predicted.   Source:
 * Hawkins 1987, Hawkins and Olwell 1998, section 7 (self-starting CUSUM); Page
 * 1954; Roberts 1959. */
size_t drift_run_charts(const struct drift_cut *cut, size_t n,
    const struct drift_rule *rule, struct drift_point *point, size_t *since);

/* Returns the mean number of samples to the first signal of any chart, where
 * the level has moved by `shift` standard deviations, over 2000 simulated
 * sequences.  Longer sequences than 20000 count as 20000. */
double drift_run_length(
    const struct drift_rule *rule, double shift, uint64_t seed);

/* Returns the median number of samples to the first signal of the level, where
 * the level moves by `shift`, passing, after the first `known` of points [n],
 * over 401 simulated sequences with errors as large as those of the points, on
 * which the charts learn as they did here.  Infinite where half of the
 * sequences have no signal after 200. */
double drift_detection_delay(const struct drift_rule *rule,
    const struct drift_point *point, size_t n, size_t known, double shift,
    uint64_t seed);

/* drift_error: computes the covariance of the error of one sample of a product,
 * passing [n] at size [n], mean over the draws: [n * n] out.
 * drift_known_error: of an error with a standard deviation of
 * 2 noise sqrt(P (1 - P)), independent at each sieve. */
void drift_error(const struct posterior *p, const double *size,
    const double *passing, size_t n, double *error);
void drift_known_error(
    double noise, const double *passing, size_t n, double *error);

#endif
