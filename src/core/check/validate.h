/* Validation: predicted against measured products at speeds held out.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_VALIDATE_H
#define TIPSPEED_CORE_CHECK_VALIDATE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/model/params.h"
#include "core/posterior/posterior.h"
#include "core/psd/site.h"

/* The ways to predict: the model, the model corrected by the training runs, and
 * null models, which need no model: the measured training products interpolated
 * straight in v^2, the product at the nearest training speed, and the feed
 * itself.  They are in the order in which they are shown; of two equally good
 * ways the first wins. */
enum validate_way {
	VALIDATE_MODEL,
	VALIDATE_CORRECTED,
	VALIDATE_INTERPOLATION,
	VALIDATE_NEAREST,
	VALIDATE_FEED,
	VALIDATE_WAYS,
	VALIDATE_NULL = VALIDATE_INTERPOLATION /* the first null model */
};

/* One run against the prediction of each way: RMSE of passing, 0..1, NAN where
 * the way has no answer at one of the sieves; P20, P50, P80, m, NAN outside the
 * sieves.  misfit and worst are the model's. */
struct validation {
	size_t run;
	double speed;
	bool holdout;               /* not among the training runs */
	size_t n_sieve, n_left_out; /* compared; finer than the feed was
				     * sieved */
	double misfit;
	double worst_sieve, worst_difference; /* m; predicted - measured */
	double measured[PSD_SIZES];           /* P20, P50, P80, m */
	double rmse[VALIDATE_WAYS], size[VALIDATE_WAYS][PSD_SIZES];
	double line[2]; /* speeds that interpolation goes through, or NAN */
	double nearest; /* training speed, m/s, or NAN */
};

/* Compares a run with its predictions.  train [n_run]: the runs trained on.
 * corrected: the corrected answer's passings at the covered sieves, or NULL for
 * none.  The run must have a product with a covered sieve (asserted). */
struct validation validate_run(const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings,
    const double *corrected);

/* Computes the passings, 0..1, that one way predicts for the run at its covered
 * sieves, out [misfit_covered]; NAN where the way has no answer, as
 * VALIDATE_CORRECTED, which is made of draws. */
void validate_passing(const struct site *site, size_t run, const bool *train,
    const struct params *p, struct model_settings settings,
    enum validate_way way, double *out);

/* Returns what each way predicts, as validate_passing, [VALIDATE_WAYS][n] over
 * the n covered sieves; `corrected` as for validate_run.  The caller frees. */
double *validate_passings(const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings,
    const double *corrected);

/* As validate_run, of passings that validate_passings returned. */
struct validation validate_predicted(const struct site *site, size_t run,
    const bool *train, const double *passing);

/* Returns the way with the smallest RMSE. */
enum validate_way validate_winner(const double rmse[static VALIDATE_WAYS]);

/* True when the model at this run is worse than interpolating the measured
 * training products. */
bool validation_loses_to_interpolation(const struct validation *v);

/* True when interpolation extends beyond its two speeds: there it is the line
 * through the two nearest. */
bool validation_extrapolates(const struct validation *v);

/* Returns the passing of the null model at size x: the measured products of the
 * training speeds next below and above, straight in v^2; beyond them, on the
 * line through the two nearest.  Repeats at a speed are averaged.  NAN with
 * fewer than two speeds, or where the product at one of them has no such
 * size. */
double validate_interpolation(
    const struct site *site, const bool *train, double speed, double x);

/* The score of one size over many runs: mean and root mean square of the
 * relative errors (predicted - measured) / measured; and the coefficient of
 * determination, 1 - sum (predicted - measured)^2 / sum (measured - their
 * mean)^2.  n: runs where both sizes are known; NAN with no run; r2 is also
 * NAN where all measured sizes are equal. */
struct validate_score {
	size_t n;
	double bias, rms, r2;
};

/* Returns the score of a way at size i of PSD_PASSING over runs v [n]. */
struct validate_score validate_score(const struct validation *const *v,
    size_t n, enum validate_way way, size_t i);

#endif
