/* Compares models calibrated on the same runs: Akaike's criterion, and their
 * errors at runs that were held out.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_LEAGUE_H
#define TIPSPEED_CORE_CHECK_LEAGUE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/search/calibrate.h"

/* Akaike's information criterion, corrected for few data, of least squares with
 * an unknown variance:
 *   AICc = n ln(E / n) + 2 K + 2 K (K + 1) / (n - K - 1),   K = p + 1
 * E misfit over n cells, p parameters; K counts the variance as one more.  NAN
 * where n is not above K + 1, or E is 0.
 * Source: Hurvich and Tsai (1989), Biometrika 76; Burnham and Anderson (2002),
 * Model Selection and Multimodel Inference, section 2.4. */
double league_aicc(double misfit, size_t cells, size_t parameters);

/* Returns the number of parameters that a fit found: all that were searched,
 * without the free scale of a gauge that no bound holds. */
size_t league_count_fitted(const struct fit *fit, const struct bounds *bounds);

/* A passing of a run that was held out, 0..1; log_size: ln of its sieve, m;
 * noise: standard deviation of its sampling error.  The cells of a run follow
 * one another. */
struct league_cell {
	size_t run;
	double log_size, measured, noise;
};

/* Returns the root mean square, over the runs, of the RMSE of predicted [n];
 * NAN with no cell, or where a cell has no prediction. */
double league_rmse(
    const struct league_cell *cell, size_t n, const double *predicted);

/* difference: the squared errors of a less the squared errors of b, summed over
 * all cells; error: the standard error of this sum, from the sampling error of
 * the cells alone.  The error of a run's cells is partly shared along its
 * curve, in the shares of the priors of HYPER (D13). */
struct league_pair {
	double difference, error;
};
struct league_pair league_compare(
    const struct league_cell *cell, size_t n, const double *a, const double *b);

/* True if a errs more than b by more than twice league_pair's error and 0.1
 * points of RMSE. */
bool league_errs_more(
    const struct league_cell *cell, size_t n, const double *a, const double *b);

/* A model to be compared.  model: its index in BREAKAGES.  standing: out. */
enum league_standing {
	LEAGUE_BEST,     /* errs least where held out; of such the least AICc */
	LEAGUE_POSSIBLE, /* not distinguishable from the best */
	LEAGUE_OUT_AICC, /* ruled out by AICc, */
	LEAGUE_OUT_ERROR /* or by its error at the runs held out */
};
struct league_model {
	size_t model;
	bool energies; /* with collision energies (D15): a law of its own */
	double aicc, rmse;
	const double *predicted; /* [n] of the cells */
	enum league_standing standing;
};

/* Ranks models [n_model] and returns whether the data can tell them apart.
 * The best model errs least at the cells held out; of the models whose RMSE
 * there is no more than 0.1 points above the least, and of all where no run was
 * held out, it has the least AICc.
 * A model is ruled out if it errs more than the best at the cells held out; or
 * if its AICc is more than 10 above the best's, unless its RMSE there is
 * smaller, however little: AICc assumes that errors are independent and of one
 * size, and the errors of sieves are not.  The data can tell the models apart
 * where all that remain are the simplest of them and models that extend it,
 * none errs less than the best by more than sampling explains, and none has an
 * AICc more than 10 below that of the best. */
bool league_rank(struct league_model *model, size_t n_model,
    const struct league_cell *cell, size_t n);

#endif
