/* Compares models calibrated on the same runs, by Akaike's criterion and by
 * their errors on held-out runs.
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
 * Returns NAN if n <= K + 1 or E is 0.
 * Source: Hurvich and Tsai (1989), Biometrika 76; Burnham and Anderson (2002),
 * Model Selection and Multimodel Inference, section 2.4. */
double league_aicc(double misfit, size_t cells, size_t parameters);

/* Returns the number of parameters fitted: all that were searched, minus one
 * for the free scale of a gauge, unless bounds fix a parameter of the gauge. */
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
 * NAN if there are no cells or a cell has no prediction. */
double league_rmse_over_runs(
    const struct league_cell *cell, size_t n, const double *predicted);

/* difference: the squared errors of a minus those of b, summed over all cells;
 * error: the standard error of this sum, due to the sampling errors of the
 * cells alone.  Part of these errors is shared along the curve of a run, in the
 * proportion of the priors in HYPER (D13). */
struct league_difference {
	double difference, error;
};
struct league_difference league_error_difference(
    const struct league_cell *cell, size_t n, const double *a, const double *b);

/* True if the errors of a exceed those of b clearly: by more than twice
 * league_difference's error, and by more than 0.1 points of RMSE. */
bool league_is_error_clearly_larger(
    const struct league_cell *cell, size_t n, const double *a, const double *b);

/* True if the predictions miss the held-out runs by more than FIT_POOR and by
 * more than twice the sampling error.  The sampling error is taken to be at
 * most FIT_POOR, because it is estimated from a misfit.  If this is true, the
 * model describes these runs badly, even if all other models are worse. */
bool league_is_prediction_poor(
    const struct league_cell *cell, size_t n, const double *predicted);

/* A model to be compared.  model: its index in BREAKAGES.  standing: set by
 * league_rule_out_models. */
enum league_standing {
	LEAGUE_BEST,     /* the best; see league_rule_out_models */
	LEAGUE_POSSIBLE, /* not distinguishable from the best */
	LEAGUE_OUT_AICC, /* ruled out by its AICc */
	LEAGUE_OUT_ERROR /* ruled out by its error on the held-out runs */
};
struct league_model {
	size_t model;
	bool energies; /* with collision energies (D15), which count as another
		        * law */
	double aicc, rmse;
	const double *predicted; /* [n] of the cells */
	enum league_standing standing;
};

/* Ranks models [n_model] and returns true if the data can tell them apart.  The
 * best model has the smallest AICc of those whose held-out RMSE is within 0.1
 * points of the smallest, or of all if no run was held out.  A model is ruled
 * out if its held-out error is clearly larger than the best's
 * (league_is_error_clearly_larger).  It is also ruled out if its AICc is more
 * than 10 above the best's, unless its held-out RMSE is even slightly smaller:
 * AICc assumes that errors are independent and of equal size, and those of
 * sieves are not.  The data can tell the models apart if all that remain are
 * one model and extensions of it, no model's error is clearly smaller than the
 * best's, and no AICc is more than 10 below the best's. */
bool league_rule_out_models(struct league_model *model, size_t n_model,
    const struct league_cell *cell, size_t n);

#endif
