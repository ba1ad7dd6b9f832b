/* Re-evaluates, with the kernel, the candidates that a generation kept, and
 * takes percentiles of their residuals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/candidates.h"

#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_sort_double.h>

#include "base/xalloc.h"
#include "core/model/selection.h"
#include "core/search/kernel.h"
#include "core/search/misfit.h"

enum { MOST = CALIBRATE_KEPT };

/* Returns the quantile of sorted [n] at a share, 0..1. */
static double
quantile_of_sorted(const double *sorted, size_t n, double share)
{
	return sorted[(size_t)(share * (double)(n - 1) + 0.5)];
}

static struct params
params_of_kept_candidate(const struct calibrate_generation *g, size_t i)
{
	struct params p = {.breakage = g->params.breakage};
	for (size_t j = 0; j < breakage_model_of_params(&p)->n; j++)
		p.at[j] = (double)g->kept[j][i];
	return p;
}

/* Computes the candidates' differences [m->n_residual][MOST] by the search's
 * scheme. */
static void
evaluate_kept_candidates(const struct misfit *m, enum isa isa,
    const struct calibrate_generation *g, double *difference)
{
	struct kernel *kernel = kernel_new(m, isa, 1);
	double misfit[MOST], *theta[PARAMS_MOST] = {NULL};
	for (size_t j = 0; j < m->of->n; j++) {
		theta[j] = xcalloc_doubles(MOST);
		for (size_t i = 0; i < g->n_kept; i++)
			theta[j][i] = (double)g->kept[j][i];
		/* The kernel also reads lanes beyond the last candidate. */
		for (size_t i = g->n_kept; i < MOST; i++)
			theta[j][i] = theta[j][0];
	}
	kernel_evaluate_candidates(kernel, (const double *const *)theta, 0,
	    g->n_kept, 0,
	    &(struct kernel_out){
		.misfit = misfit, .difference = difference, .stride = MOST});
	for (size_t j = 0; j < m->of->n; j++)
		free(theta[j]);
	kernel_free(kernel);
}

static void
compute_break_size_quartiles_of_candidates(struct candidates *c,
    const struct model_settings *settings, const struct calibrate_generation *g,
    double speed)
{
	double size[MOST] = {0};
	c->speed = speed;
	for (size_t i = 0; i < g->n_kept; i++) {
		struct params p = params_of_kept_candidate(g, i);
		size[i] = params_break_size_by_impacts(&p, settings, speed);
	}
	gsl_sort(size, 1, g->n_kept);
	for (size_t k = 0; k < 3; k++)
		c->break_size[k] =
		    quantile_of_sorted(size, g->n_kept, 0.25 * (double)(k + 1));
}

struct candidates
candidates_compute_residuals(const struct site *site, const bool *train,
    struct model_settings settings, enum isa isa,
    const struct calibrate_generation *g, const struct params *best)
{
	settings.breakage = (unsigned)g->params.breakage;
	struct misfit *m = misfit_new(site, train, NULL, false, settings);
	struct candidates c = {.n = m->n_residual,
	    .cell = xcalloc(m->n_residual + 1, sizeof *c.cell)};
	FREED double *difference = xcalloc_doubles(m->n_residual * MOST);
	FREED double *of_best = xcalloc_doubles(m->n_residual);
	evaluate_kept_candidates(m, isa, g, difference);
	misfit_weighted_differences(m, best, of_best);
	size_t k = 0;
	for (size_t r = 0; r < m->n_run; r++)
		for (size_t i = 0; i < m->run[r].n; i++, k++) {
			double *d = difference + k * MOST;
			gsl_sort(d, 1, g->n_kept);
			c.cell[k] =
			    (struct candidates_cell){.run = m->run[r].run,
				.size = m->run[r].sieve[i],
				.p10 = quantile_of_sorted(d, g->n_kept, 0.1),
				.median = quantile_of_sorted(d, g->n_kept, 0.5),
				.p90 = quantile_of_sorted(d, g->n_kept, 0.9),
				.best = of_best[k]};
		}
	compute_break_size_quartiles_of_candidates(
	    &c, &settings, g, m->run[0].speed);
	misfit_free(m);
	return c;
}

void
candidates_clear(struct candidates *c)
{
	free(c->cell);
	*c = (struct candidates){0};
}

const struct candidates_cell *
candidates_worst_fitted_passing(const struct candidates *c)
{
	const struct candidates_cell *worst = c->cell;
	for (size_t k = 1; k < c->n; k++)
		if (fabs(c->cell[k].median) > fabs(worst->median))
			worst = &c->cell[k];
	return worst;
}

void
candidates_p10_p90_of_param(
    const struct calibrate_generation *g, size_t j, double *p10, double *p90)
{
	double value[MOST] = {0};
	for (size_t i = 0; i < g->n_kept; i++) {
		struct params p = params_of_kept_candidate(g, i);
		params_scale_largest_beta_to_1(&p);
		value[i] = p.at[j];
	}
	gsl_sort(value, 1, g->n_kept);
	*p10 = quantile_of_sorted(value, g->n_kept, 0.1);
	*p90 = quantile_of_sorted(value, g->n_kept, 0.9);
}
