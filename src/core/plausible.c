/* The noise of a fit and what it leaves open.
 *
 * Taking misfit / (2 s^2) alone, as if all sieves were alike noisy, gave bands
 * far too narrow where the product passes 20 to 80 %.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/plausible.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/elementary.h"

struct plausible {
	struct misfit *misfit;
	const struct bounds *bounds;
	const double *basis; /* U, [n_residual * PARAMS_MOST] */
	double *own, *now;   /* differences of the fit and of another */
	double variance;     /* s^2 */
	double weight[PARAMS_MOST][PARAMS_MOST]; /* G^-1 */
	double directions;                       /* D */
	double least;                            /* misfit of the fit */
	double freedom;                          /* nu */
	size_t n, size; /* parameters that move; the model's n */
};

static double
leverage(const double *row)
{
	double sum = 0;
	for (size_t c = 0; c < PARAMS_MOST; c++)
		sum += row[c] * row[c];
	return sum;
}

/* Variance of each weighted difference's noise, [n_residual], and how many
 * equal ones would tell its size as well (Satterthwaite).  choice: the search
 * takes the best of several valleys, which swallows more of the noise than the
 * parameters of one valley do; found by counting on made-up sites, where bands
 * without it held 73 % instead of 80 %. */
static void
find_noise(struct plausible *f, double *noise)
{
	const double least = 0.001, choice = 1.6;
	const struct misfit *m = f->misfit;
	double left = 0, squares = 0;
	for (size_t r = 0, k = 0; r < m->n_run; r++)
		for (size_t i = 0; i < m->run[r].n; i++, k++) {
			double P = m->run[r].measured[i];
			double w = m->run[r].weight[i];
			noise[k] = m->run[r].by_sd ? m->run[r].run_weight
						   : 4 * w * w * P * (1 - P);
			double part =
			    noise[k] *
			    (1 - leverage(f->basis + k * PARAMS_MOST));
			left += part;
			squares += part * part;
		}
	double scale = left > 0 ? choice * f->least / left : 0;
	f->freedom = squares > 0 ? fmax(left * left / squares, 1) : 1;
	for (size_t r = 0, k = 0; r < m->n_run; r++)
		for (size_t i = 0; i < m->run[r].n; i++, k++) {
			double floor = least * m->run[r].weight[i];
			noise[k] = fmax(scale * noise[k], floor * floor);
		}
}

/* The inverse of G, and s^2. A direction that moves nothing has a row of 0,
 * where any weight will do. */
static void
weigh_directions(struct plausible *f, const double *noise)
{
	gsl_matrix *G = gsl_matrix_calloc(f->size, f->size);
	double trace = 0, rank = 0, sum = 0;
	for (size_t k = 0; k < f->misfit->n_residual; k++) {
		const double *u = f->basis + k * PARAMS_MOST;
		sum += noise[k];
		for (size_t a = 0; a < f->size; a++)
			for (size_t b = 0; b < f->size; b++)
				*gsl_matrix_ptr(G, a, b) +=
				    u[a] * noise[k] * u[b];
		trace += leverage(u) * noise[k];
		rank += leverage(u);
	}
	f->variance =
	    rank > 0 ? trace / rank : sum / (double)f->misfit->n_residual;
	for (size_t a = 0; a < f->size; a++)
		if (!(gsl_matrix_get(G, a, a) > 0))
			gsl_matrix_set(G, a, a, f->variance);
	gsl_linalg_cholesky_decomp1(G);
	gsl_linalg_cholesky_invert(G);
	for (size_t a = 0; a < f->size; a++)
		for (size_t b = 0; b < f->size; b++)
			f->weight[a][b] = gsl_matrix_get(G, a, b);
	gsl_matrix_free(G);
}

struct plausible *
plausible_new(struct misfit *m, const struct params *p,
    const struct bounds *bounds, const struct sensitivity *s,
    const double *basis)
{
	struct plausible *f = xcalloc(1, sizeof *f);
	*f = (struct plausible){.misfit = m,
	    .bounds = bounds,
	    .basis = basis,
	    .own = xdoubles(m->n_residual),
	    .now = xdoubles(m->n_residual),
	    .directions = m->of->gauge > 0,
	    .size = m->of->n,
	    .n = s->n};
	f->least = misfit_differences(m, p, f->own);
	find_noise(f, f->now);
	weigh_directions(f, f->now);
	for (size_t c = 0; c < s->n; c++)
		f->directions += s->column[c] < m->of->gauge;
	return f;
}

void
plausible_free(struct plausible *f)
{
	free(f->own);
	free(f->now);
	free(f);
}

double
plausible_deviation(const struct plausible *f)
{
	return sqrt(f->variance);
}

/* Whether the gauge, whose scale is free, can be scaled into its bounds. */
static bool
gauge_fits(const struct bounds *b, const struct params *p)
{
	const double slack = 1e-9;
	double least = 0, most = INFINITY;
	for (size_t j = 0; j < breakage_of(p)->gauge; j++) {
		double x = p->at[j];
		double lower = b->lower[j] / fabs(x);
		double upper = b->upper[j] / fabs(x);
		if (x == 0) {
			if (b->lower[j] > 0 || b->upper[j] < 0)
				return false;
			continue;
		}
		least = fmax(least, x > 0 ? lower : -upper);
		most = fmin(most, x > 0 ? upper : -lower);
	}
	return most > 0 && least <= most * (1 + slack);
}

static bool
is_within(const struct bounds *b, const struct params *p)
{
	for (size_t j = breakage_of(p)->gauge; j < breakage_of(p)->n; j++) {
		double x = p->at[j];
		if (x < b->lower[j] || x > b->upper[j])
			return false;
	}
	return gauge_fits(b, p);
}

double
plausible_level(struct plausible *f, const struct params *p)
{
	if (!is_within(f->bounds, p))
		return INFINITY;
	double squares = 0, along = 0, weighted = 0, e[PARAMS_MOST] = {0};
	double misfit = misfit_differences(f->misfit, p, f->now);
	if (!isfinite(misfit))
		return INFINITY;
	for (size_t k = 0; k < f->misfit->n_residual; k++)
		for (size_t c = 0; c < PARAMS_MOST; c++)
			e[c] += f->basis[k * PARAMS_MOST + c] *
				(f->now[k] - f->own[k]);
	for (size_t a = 0; a < f->size; a++) {
		along += e[a] * e[a];
		for (size_t b = 0; b < f->size; b++)
			weighted += e[a] * f->weight[a][b] * e[b];
	}
	for (size_t j = 0; j < f->misfit->of->gauge; j++)
		squares += p->at[j] * p->at[j];
	/* Seen from the plane in which the largest of the gauge is held,
	 * directions far out are rarer than on a sphere. */
	double far = squares > 0 ? f->directions / 2 * el_log(squares) : 0;
	double T = (misfit - f->least - along) / f->variance + weighted;
	double power = (f->freedom + (double)f->n) / 2;
	return power * el_log(1 + fmax(T, 0) / f->freedom) + far;
}
