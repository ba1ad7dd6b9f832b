/* Validation: predicted against measured products at speeds held out.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_VALIDATE_H
#define TIPSPEED_CORE_VALIDATE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/params.h"
#include "core/site.h"

/* Sizes in m, NAN where the size lies outside the sieves. */
struct validate_size {
	double passing; /* 0.2, 0.5, 0.8 */
	double measured, predicted;
};

/* One run against the model.  rmse and the differences are passing, 0..1.
 * The null models that anyone has without a model: the feed itself, and the
 * measured training products interpolated straight in v^2 (NAN with fewer than
 * two training runs). */
struct validation {
	size_t run;
	double speed;
	bool holdout;               /* not among the training runs */
	size_t n_sieve, n_left_out; /* compared; finer than the feed tells */
	double misfit, rmse;
	double worst_sieve, worst_difference; /* m; predicted - measured */
	struct validate_size size[PSD_SIZES];
	double feed_rmse, interpolation_rmse;
};

/* Compares the run of that index.  train [n_run]: the runs trained on.  The run
 * must have a product with a covered sieve (asserted). */
struct validation validate_run(const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings);

/* True when the model at this run is worse than interpolating the measured
 * training products. */
bool validation_loses(const struct validation *v);

/* Passing of the null model at a size: the measured products of the training
 * runs next below and above, straight in v^2; beyond them, on the line through
 * the outer two.  NAN with fewer than two, or where one has no such size. */
double validate_interpolation(
    const struct site *site, const bool *train, double speed, double x);

#endif
