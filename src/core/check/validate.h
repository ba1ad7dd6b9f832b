/* Validation: compares predicted with measured products at held-out speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_VALIDATE_H
#define TIPSPEED_CORE_CHECK_VALIDATE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/model/params.h"
#include "core/posterior/posterior.h"
#include "core/psd/site.h"

/* The ways to predict: the model, the model corrected by the training runs, and
 * three null models: the measured training products interpolated linearly in
 * v^2, the product at the nearest training speed, and the feed itself.  They
 * are in the order in which they are shown; of equally good ways, the first is
 * the best. */
enum validate_way {
	VALIDATE_MODEL,
	VALIDATE_CORRECTED,
	VALIDATE_INTERPOLATION,
	VALIDATE_NEAREST,
	VALIDATE_FEED,
	VALIDATE_WAYS,
	VALIDATE_NULL = VALIDATE_INTERPOLATION /* the first null model */
};

/* One run compared with each prediction: the RMSE of passing, 0..1, or NAN if
 * the prediction lacks one of the sieves; P20, P50 and P80, m, or NAN outside
 * the sieves.  misfit and worst_* are the model's. */
struct validation {
	size_t run;
	double speed;
	bool holdout;               /* not among the training runs */
	size_t n_sieve, n_left_out; /* sieves compared; sieves ignored because
				     * the feed does not cover them */
	size_t n_idle; /* of n_sieve, idle (misfit.h): not in the RMSE */
	double misfit;
	double worst_sieve, worst_difference; /* m; predicted - measured */
	double measured[PSD_SIZES];           /* P20, P50, P80, m */
	double rmse[VALIDATE_WAYS], size[VALIDATE_WAYS][PSD_SIZES];
	double line[2]; /* speeds used for interpolation, or NAN */
	double nearest; /* training speed, m/s, or NAN */
};

/* Compares a run with its predictions, without the corrected answer.  train
 * [n_run]: the training runs.  The run must have a product with a covered sieve
 * (asserted). */
struct validation validate_run(const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings);

/* Returns the passings [VALIDATE_WAYS][n], 0..1, that the ways predict for the
 * run at its n covered sieves, or NAN if a way has no answer, as
 * VALIDATE_CORRECTED if corrected is NULL.  corrected: passings of the
 * corrected answer at these sieves.  The caller frees the result. */
double *validate_predict_by_all_ways(const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings,
    const double *corrected);

/* As validate_run, but from passing, the result of
 * validate_predict_by_all_ways. */
struct validation validate_run_from_predictions(const struct site *site,
    size_t run, const bool *train, const double *passing);

/* Returns the rmse of VALIDATE_MODEL alone.  top: that of misfit.h. */
double validate_rmse_of_model(const struct run *run, double top,
    const struct params *p, struct model_settings settings);

/* Returns the way with the smallest RMSE. */
enum validate_way validate_way_of_least_rmse(
    const double rmse[static VALIDATE_WAYS]);

/* True if the run was held out and the model predicts it worse than
 * interpolation between the measured training products does. */
bool validation_is_interpolation_better(const struct validation *v);

/* True if the run's speed is outside the two speeds used for interpolation. */
bool validation_is_extrapolated(const struct validation *v);

/* Returns the passing at size x, m, interpolated linearly in v^2 between the
 * measured products at the next training speeds below and above; beyond these
 * speeds, extrapolated from the nearest two.  Repeats at a speed are averaged.
 * Returns NAN if there are fewer than two speeds, or if a product used does not
 * cover x. */
double validate_interpolate_passing(
    const struct site *site, const bool *train, double speed, double x);

/* The score of one size over many runs.  bias, rms: mean and root mean square
 * of the relative errors (predicted - measured) / measured; r2: the coefficient
 * of determination, 1 - sum (predicted - measured)^2 / sum (measured - their
 * mean)^2.  n: the number of runs for which both sizes are known.  All scores
 * are NAN if n is 0; r2 is also NAN if all measured sizes are equal. */
struct validate_score {
	size_t n;
	double bias, rms, r2;
};

/* Returns the score of a way for size i of PSD_PASSING over runs v [n]. */
struct validate_score validate_score_at_size(const struct validation *const *v,
    size_t n, enum validate_way way, size_t i);

#endif
