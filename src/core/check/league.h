/* Comparison of models calibrated on the same runs, by Akaike's criterion and
 * by their errors on held-out runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_LEAGUE_H
#define TIPSPEED_CORE_CHECK_LEAGUE_H

#include <stdbool.h>
#include <stddef.h>

#include "core/search/calibrate.h"

/* Returns Akaike's information criterion, corrected for small samples, for
 * least squares with unknown variance:
 *   AICc = n ln(E / n) + 2 K + 2 K (K + 1) / (n - K - 1),   K = p + 1
 * for the misfit E over n cells and p parameters; K also counts the variance.
 * NAN if n is not above K + 1 or E is 0.
 * Source: Hurvich and Tsai (1989), Biometrika 76; Burnham and Anderson (2002),
 * Model Selection and Multimodel Inference, section 2.4. */
double league_aicc(double misfit, size_t cells, size_t parameters);

/* Returns the number of parameters fitted: all that were searched, less one for
 * the free scale of a gauge, unless a bound fixes that scale. */
size_t league_count_fitted_params(
    const struct fit *fit, const struct bounds *bounds);

/* A passing, 0..1, of a held-out run.  log_size: ln of its sieve, m; noise:
 * standard deviation of its sampling error.  The cells of a run are
 * adjacent. */
struct league_cell {
	size_t run;
	double log_size, measured, noise;
};

/* Returns the root mean square over the runs of the RMSE of predicted [n], or
 * NAN if there is no cell or a cell has no prediction. */
double league_rmse_over_runs(
    const struct league_cell *cell, size_t n, const double *predicted);

/* difference: the squared errors of a minus those of b, summed over all cells;
 * error: the standard error of this sum, from the sampling errors of the cells
 * alone.  Errors are partly shared along the curve of a run, in proportion to
 * the priors in HYPER (D13). */
struct league_difference {
	double difference, error;
};
struct league_difference league_compare_errors(
    const struct league_cell *cell, size_t n, const double *a, const double *b);

/* True if the errors of a exceed those of b by more than both twice
 * league_difference's error and 0.1 points of RMSE. */
bool league_errs_clearly_more(
    const struct league_cell *cell, size_t n, const double *a, const double *b);

/* True if the predictions miss the held-out runs by more than both FIT_POOR and
 * twice the sampling error, which is taken to be FIT_POOR at most, as it is
 * estimated from a misfit.  A model whose predictions do describes these runs
 * badly, even if all others are worse. */
bool league_misses_held_out_runs(
    const struct league_cell *cell, size_t n, const double *predicted);

/* A model to be compared.  model: its index in BREAKAGES.  standing: out. */
enum league_standing {
	LEAGUE_BEST,     /* smallest held-out error; among these, smallest
			  * AICc */
	LEAGUE_POSSIBLE, /* not distinguishable from the best */
	LEAGUE_OUT_AICC, /* ruled out by AICc, */
	LEAGUE_OUT_ERROR /* or by its error on the held-out runs */
};
struct league_model {
	size_t model;
	bool energies; /* with collision energies (D15): a law of its own */
	double aicc, rmse;
	const double *predicted; /* [n] of the cells */
	enum league_standing standing;
};

/* Ranks models [n_model] and returns true if the data can tell them apart.  The
 * best model has the smallest AICc of those whose held-out RMSE is within 0.1
 * points of the smallest, or of all if no run was held out.  A model is ruled
 * out if its held-out error is larger than the best's
 * (league_errs_clearly_more), or if its AICc is more than 10 above the best's,
 * unless its held-out RMSE is smaller, however slightly: AICc assumes
 * independent errors of equal size, and the errors of sieves are neither.  The
 * data can tell the models apart if those that remain are the simplest of them
 * and extensions of it, none has a smaller error than the best by more than
 * sampling explains, and none has an AICc more than 10 below the best's. */
bool league_rank_models(struct league_model *model, size_t n_model,
    const struct league_cell *cell, size_t n);

#endif
