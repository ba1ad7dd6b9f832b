/* Control charts of routine samples compared with their predictions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_CONTROL_CHART_H
#define TIPSPEED_CORE_CHECK_CONTROL_CHART_H

#include <stddef.h>
#include <stdint.h>

#include "core/posterior/posterior.h"

/* The two components of a sample that are charted.  Level: the mean of its
 * residuals (measured - predicted) over the sieves.  Tilt: the rise, from the
 * finest to the coarsest sieve, of the straight line in ln size through the
 * residuals, minus the part that is correlated with the mean.  Without drift
 * both have mean 0 and a variance that follows from the posterior. */
enum drift_component { DRIFT_LEVEL, DRIFT_TILT, DRIFT_COMPONENTS };

/* k, h: allowance and limit of the CUSUM, in standard deviations.  lambda:
 * weight of the newest sample in the EWMA; width: limit of the EWMA, in its own
 * standard deviations.  cuts: how many cuts the posterior's estimate of the
 * size of the errors counts as. */
struct drift_rule {
	double k, h, lambda, width, cuts;
};
extern const struct drift_rule DRIFT_RULE;

/* A sample.  size [n] m, coarsest first; residual [n] passing, 0..1.  The
 * draws' answers, truth [n * n_draw], have a row for each size, in the same
 * order in every sample; n_draw 0: the answers are certain.  error [n * n]:
 * covariance of the errors of one sample. */
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

/* One component after a sample.  value: passing, 0..1.  truth, error: its
 * standard deviations due to the draws and to the posterior's sampling error.
 * off: its distance from the prediction of the earlier samples, in standard
 * deviations.  score: as off, but the size of the errors is also estimated from
 * the earlier samples; without drift, scores are standard normal and
 * independent.  up, down: the two CUSUMs, both >= 0. */
struct drift_chart {
	double value, truth, error, off, score, ewma, ewma_limit, up, down;
};
struct drift_point {
	struct drift_chart chart[DRIFT_COMPONENTS];
	enum drift_state state;
};

/* Charts the samples cut [n] in order and fills point [n].  Returns the first
 * sample after which a chart is beyond its limit, or n if there is none, and
 * sets *since to the sample at which that chart's CUSUM began to rise.
 *
 * The unknown part of the truth is common to all samples, so their values are
 * correlated, and charts of the values themselves would signal more often than
 * stated.  `off` is the value minus its prediction from the earlier values,
 * divided by the standard deviation of that difference: L^-1 value, where L is
 * the Cholesky factor of the values' covariance.  The posterior gives only a
 * rough size for the errors of cuts.  off, divided by the root mean square of
 * the earlier values of off and rule->cuts values of 1 from the posterior, has
 * Student's t distribution; the score is the standard normal value of the same
 * probability.  After a signal, samples from `since` on are not used for
 * prediction, so that the drift itself is not predicted.  Source: Hawkins 1987,
 * Hawkins and Olwell 1998, section 7 (self-starting CUSUM); Page 1954; Roberts
 * 1959. */
size_t drift_compute_charts(const struct drift_cut *cut, size_t n,
    const struct drift_rule *rule, struct drift_point *point, size_t *since);

/* Returns the mean number of samples until a chart first signals if the level
 * has shifted by `shift` standard deviations, over 2000 simulated sequences.
 * Sequences longer than 20000 count as 20000. */
double drift_mean_run_length(
    const struct drift_rule *rule, double shift, uint64_t seed);

/* Returns the median number of samples until the level's chart first signals if
 * the level shifts by `shift`, a passing, after the first `known` of points
 * [n].  Simulates 401 sequences with errors as large as the points', from which
 * the charts learn in the same way.  Returns INFINITY if half of the sequences
 * have no signal within 200 samples. */
double drift_detection_delay(const struct drift_rule *rule,
    const struct drift_point *point, size_t n, size_t known, double shift,
    uint64_t seed);

/* drift_covariance_of_errors computes error [n * n], the covariance of the
 * errors of one sample of a product with passing [n] at size [n], averaged over
 * the draws.  drift_covariance_of_known_error does so for independent errors
 * with a standard deviation of 2 noise sqrt(P (1 - P)) at each sieve. */
void drift_covariance_of_errors(const struct posterior *p, const double *size,
    const double *passing, size_t n, double *error);
void drift_covariance_of_known_error(
    double noise, const double *passing, size_t n, double *error);

#endif
