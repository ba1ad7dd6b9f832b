/* Validation: predicted against measured products at held-out speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_VALIDATE_H
#define TIPSPEED_CORE_CHECK_VALIDATE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/model/params.h"
#include "core/posterior/posterior.h"
#include "core/psd/site.h"

/* The ways to predict: the model, the model corrected by the training runs, and
 * null models: the measured training products interpolated linearly in v^2, the
 * product at the nearest training speed, and the feed itself.  They are in the
 * order in which they are shown; of two equally good ways, the first wins. */
enum validate_way {
	VALIDATE_MODEL,
	VALIDATE_CORRECTED,
	VALIDATE_INTERPOLATION,
	VALIDATE_NEAREST,
	VALIDATE_FEED,
	VALIDATE_WAYS,
	VALIDATE_NULL = VALIDATE_INTERPOLATION /* the first null model */
};

/* One run compared with each prediction: RMSE of passing, 0..1, NAN if the
 * prediction lacks one of the sieves; P20, P50, P80, m, NAN outside the sieves.
 * misfit and worst_* are those of the model. */
struct validation {
	size_t run;
	double speed;
	bool holdout;               /* not among the training runs */
	size_t n_sieve, n_left_out; /* compared; ignored, as finer than the
				     * feed's sieves */
	size_t n_idle; /* of n_sieve, idle (misfit.h): not in the RMSE */
	double misfit;
	double worst_sieve, worst_difference; /* m; predicted - measured */
	double measured[PSD_SIZES];           /* P20, P50, P80, m */
	double rmse[VALIDATE_WAYS], size[VALIDATE_WAYS][PSD_SIZES];
	double line[2]; /* speeds used for interpolation, or NAN */
	double nearest; /* training speed, m/s, or NAN */
};

/* Compares a run with its predictions.  train [n_run]: the training runs.
 * corrected: passings of the corrected answer at the covered sieves, or NULL.
 * The run must have a product with a covered sieve (asserted). */
struct validation validate_run(const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings,
    const double *corrected);

/* Returns the passings, 0..1, that the ways predict for the run at its n
 * covered sieves, [VALIDATE_WAYS][n]; NAN where a way has no answer, as
 * VALIDATE_CORRECTED without draws.  corrected: as for validate_run.  The
 * caller frees the result. */
double *validate_predict_by_all_ways(const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings,
    const double *corrected);

/* As validate_run, but from the result of validate_predict_by_all_ways. */
struct validation validate_run_from_predictions(const struct site *site,
    size_t run, const bool *train, const double *passing);

/* Returns the way with the smallest RMSE. */
enum validate_way validate_best_way(const double rmse[static VALIDATE_WAYS]);

/* True if the model predicts this run worse than interpolation of the measured
 * training products does. */
bool validation_loses_to_interpolation(const struct validation *v);

/* True if the run is outside the two speeds used for interpolation. */
bool validation_extrapolates(const struct validation *v);

/* Returns the passing of the null model at size x: between the measured
 * products at the training speeds next below and above, linear in v^2; beyond
 * all of these, on the line through the two nearest.  Repeats at a speed are
 * averaged.  NAN if there are fewer than two speeds, or if a product used does
 * not cover x. */
double validate_interpolated_passing(
    const struct site *site, const bool *train, double speed, double x);

/* The score of one size over many runs: mean and root mean square of the
 * relative errors (predicted - measured) / measured; and the coefficient of
 * determination, 1 - sum (predicted - measured)^2 / sum (measured - their
 * mean)^2.  n: runs for which both sizes are known.  All are NAN without such a
 * run; r2 is also NAN if all measured sizes are equal. */
struct validate_score {
	size_t n;
	double bias, rms, r2;
};

/* Returns the score of a way at size i of PSD_PASSING over runs v [n]. */
struct validate_score validate_score_at_size(const struct validation *const *v,
    size_t n, enum validate_way way, size_t i);

#endif
