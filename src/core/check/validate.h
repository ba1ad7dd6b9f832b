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
 * itself.  In the order in which they are shown; of two that are equally good
 * the first wins. */
enum validate_way {
	VALIDATE_MODEL,
	VALIDATE_CORRECTED,
	VALIDATE_INTERPOLATION,
	VALIDATE_NEAREST,
	VALIDATE_FEED,
	VALIDATE_WAYS,
	VALIDATE_NULL = VALIDATE_INTERPOLATION /* the first null model */
};

/* One run against what each way predicts for it: RMSE of passing, 0..1, NAN
 * where it has no answer at one of the sieves; P20, P50, P80, m, NAN outside
 * the sieves.  misfit and worst are the model's. */
struct validation {
	size_t run;
	double speed;
	bool holdout;               /* not among the training runs */
	size_t n_sieve, n_left_out; /* compared; finer than the feed tells */
	double misfit;
	double worst_sieve, worst_difference; /* m; predicted - measured */
	double measured[PSD_SIZES];           /* P20, P50, P80, m */
	double rmse[VALIDATE_WAYS], size[VALIDATE_WAYS][PSD_SIZES];
	double line[2]; /* speeds that interpolation goes through, or NAN */
	double nearest; /* training speed, m/s, or NAN */
};

/* Compares the run of that index.  train [n_run]: the runs trained on.
 * corrected: that answer's passings at the covered sieves, or NULL for none.
 * The run must have a product with a covered sieve (asserted). */
struct validation validate_run(const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings,
    const double *corrected);

/* Passing, 0..1, that one way predicts for the run at its covered sieves, out
 * [misfit_covered], NAN where it has no answer, as for VALIDATE_CORRECTED,
 * which is made of draws. */
void validate_passing(const struct site *site, size_t run, const bool *train,
    const struct params *p, struct model_settings settings,
    enum validate_way way, double *out);

/* The way with the smallest RMSE. */
enum validate_way validate_winner(const double rmse[static VALIDATE_WAYS]);

/* True when the model at this run is worse than interpolating the measured
 * training products. */
bool validation_loses(const struct validation *v);

/* True when interpolation goes beyond the two speeds it has: there it is the
 * line through the two nearest. */
bool validation_extrapolates(const struct validation *v);

/* Passing of the null model at a size: the measured products of the training
 * speeds next below and above, straight in v^2; beyond them, on the line
 * through the two nearest.  Repeats at a speed are averaged.  NAN with fewer
 * than two speeds, or where one has no such size. */
double validate_interpolation(
    const struct site *site, const bool *train, double speed, double x);

/* Of one size over many runs: mean and root mean square of the relative errors
 * (predicted - measured) / measured; and the coefficient of determination, 1 -
 * sum (predicted - measured)^2 / sum (measured - their mean)^2.  n: runs where
 * both are known; NAN with none, r2 where all are of one size. */
struct validate_score {
	size_t n;
	double bias, rms, r2;
};

/* The score of a way at size i of PSD_PASSING over runs v [n]. */
struct validate_score validate_score(const struct validation *const *v,
    size_t n, enum validate_way way, size_t i);

#endif
