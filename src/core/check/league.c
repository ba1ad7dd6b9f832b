/* AICc, and squared errors at held-out runs with their sampling error; ranks
 * models by both (Burnham and Anderson 2002).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/check/league.h"

#include <math.h>

#include "core/check/trust.h"
#include "core/model/breakage.h"
#include "core/posterior/discrepancy.h"

/* A model is ruled out if its AICc is larger by FAR, or if its errors are
 * larger by ERRORS standard errors and its RMSE by LEAST, 0..1.  A smaller
 * difference in RMSE has no practical use, however certain it is. */
static const double FAR = 10, ERRORS = 2, LEAST = 0.001;

/* A smaller difference in RMSE does not count. */
static const double ROUNDING = 1e-5;

double
league_aicc(double misfit, size_t cells, size_t parameters)
{
	double n = (double)cells, K = (double)parameters + 1;
	if (!(n > K + 1) || !(misfit > 0))
		return NAN;
	return n * log(misfit / n) + 2 * K + 2 * K * (K + 1) / (n - K - 1);
}

size_t
league_count_fitted_params(const struct fit *fit, const struct bounds *bounds)
{
	size_t gauge = breakage_model_of_params(&fit->params)->gauge;
	bool scale = gauge > 0;
	for (size_t j = 0; j < gauge; j++)
		scale = scale && bounds->lower[j] < bounds->upper[j];
	return fit->parameters - scale;
}

/* Returns the index after the last cell of the run of cell `from`. */
static size_t
end_of_run_cells(const struct league_cell *cell, size_t n, size_t from)
{
	size_t to = from;
	while (to < n && cell[to].run == cell[from].run)
		to++;
	return to;
}

double
league_rmse_over_runs(
    const struct league_cell *cell, size_t n, const double *predicted)
{
	double sum = 0, runs = 0;
	for (size_t from = 0, to; from < n; from = to, runs++) {
		double squares = 0;
		to = end_of_run_cells(cell, n, from);
		for (size_t i = from; i < to; i++)
			squares += pow(predicted[i] - cell[i].measured, 2);
		sum += squares / (double)(to - from);
	}
	return runs > 0 ? sqrt(sum / runs) : NAN;
}

/* The difference is (a - m)^2 - (b - m)^2 = (a - b) (a + b - 2 m), so an error
 * of m is multiplied by -2 (a - b). */
struct league_difference
league_error_difference(
    const struct league_cell *cell, size_t n, const double *a, const double *b)
{
	double prior[HYPERS], difference = 0, variance = 0;
	for (size_t i = 0; i < HYPERS; i++)
		prior[i] = HYPER[i].median;
	double own = prior[HYPER_OWN] * prior[HYPER_OWN];
	double all = own + discrepancy_shared_covariance(0, prior);
	for (size_t i = 0; i < n; i++) {
		double apart = a[i] - b[i];
		difference += apart * (a[i] + b[i] - 2 * cell[i].measured);
		variance += own / all * pow(apart * cell[i].noise, 2);
		for (size_t j = 0; j < n; j++) {
			double z = cell[i].log_size - cell[j].log_size;
			if (cell[i].run == cell[j].run)
				variance +=
				    discrepancy_shared_covariance(z, prior) /
				    all * apart * cell[i].noise *
				    (a[j] - b[j]) * cell[j].noise;
		}
	}
	return (struct league_difference){difference, 2 * sqrt(variance)};
}

bool
league_is_error_clearly_larger(
    const struct league_cell *cell, size_t n, const double *a, const double *b)
{
	struct league_difference p = league_error_difference(cell, n, a, b);
	return p.difference > ERRORS * p.error &&
	       league_rmse_over_runs(cell, n, a) >
		   league_rmse_over_runs(cell, n, b) + LEAST;
}

bool
league_is_prediction_poor(
    const struct league_cell *cell, size_t n, const double *predicted)
{
	double variance = 0, error = league_rmse_over_runs(cell, n, predicted);
	for (size_t i = 0; i < n; i++)
		variance += cell[i].noise * cell[i].noise / (double)n;
	return error > FIT_POOR &&
	       error > ERRORS * fmin(sqrt(variance), FIT_POOR);
}

/* Compares by AICc, or by RMSE at held-out runs if neither model has an AICc.
 * A model with an AICc is better than one without. */
static bool
is_better_model(const struct league_model *a, const struct league_model *b)
{
	if (isnan(a->aicc) || isnan(b->aicc))
		return isnan(a->aicc) && isnan(b->aicc) ? a->rmse < b->rmse
							: isnan(b->aicc);
	return a->aicc < b->aicc;
}

/* Returns the best model by AICc among those whose RMSE at held-out runs is
 * within LEAST of the smallest.  Without held-out runs all models compete. */
static struct league_model *
find_best_model(struct league_model *model, size_t n)
{
	struct league_model *best = NULL;
	double least = INFINITY;
	for (size_t i = 0; i < n; i++)
		least = fmin(least, model[i].rmse);
	for (size_t i = 0; i < n; i++) {
		bool errs =
		    isfinite(least) && !(model[i].rmse <= least + LEAST);
		if (!errs && (best == NULL || is_better_model(&model[i], best)))
			best = &model[i];
	}
	return best;
}

/* True if all models that remain extend the one with the fewest parameters. */
static bool
are_models_extensions_of_smallest(const struct league_model *model, size_t n)
{
	const struct league_model *least = NULL;
	for (size_t i = 0; i < n; i++)
		if (model[i].standing <= LEAGUE_POSSIBLE &&
		    (least == NULL || BREAKAGES[model[i].model]->n <
					  BREAKAGES[least->model]->n))
			least = &model[i];
	for (size_t i = 0; i < n; i++)
		if (model[i].standing <= LEAGUE_POSSIBLE &&
		    &model[i] != least &&
		    (model[i].energies || least->energies ||
			!breakage_is_extension_of(
			    model[i].model, least->model)))
			return false;
	return true;
}

bool
league_rule_out_models(struct league_model *model, size_t n_model,
    const struct league_cell *cell, size_t n)
{
	struct league_model *best = find_best_model(model, n_model);
	bool agree = true;
	for (size_t i = 0; i < n_model; i++) {
		struct league_model *m = &model[i];
		const double *p = m->predicted, *q = best->predicted;
		bool spared = m->rmse < best->rmse - ROUNDING;
		m->standing = m == best ? LEAGUE_BEST
			      : league_is_error_clearly_larger(cell, n, p, q)
				  ? LEAGUE_OUT_ERROR
			      : m->aicc > best->aicc + FAR && !spared
				  ? LEAGUE_OUT_AICC
				  : LEAGUE_POSSIBLE;
		agree = agree &&
			!league_is_error_clearly_larger(cell, n, q, p) &&
			!(best->aicc > m->aicc + FAR);
	}
	return agree && are_models_extensions_of_smallest(model, n_model);
}
