/* Newton's method on the gradient of the misfit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/settle.h"

#include <math.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/model/breakage.h"

enum { STEPS = 40 };

/* Shares of a parameter's range (bounds_scale_of_param).  Steps below AT_REST
 * are rounding errors; a step above BESIDE leaves the neighbourhood of the
 * start; second derivatives are differences over APART to either side; the last
 * steps begin at whole multiples of COARSE; a parameter nearer to a bound than
 * ON_BOUND is on it. */
static const double AT_REST = 1e-11, BESIDE = 1e-2, APART = 1e-6,
		    COARSE = 0x1p-24, ON_BOUND = 1e-9;
/* NOTHING: a rise of the misfit by this share is accepted, because derivatives
 * from a table of B are only as accurate as its steps.  EXACT: below this
 * misfit a fit has no residuals. */
static const double NOTHING = 1e-9, EXACT = 1e-24;

struct newton {
	struct misfit *misfit;
	const struct bounds *bounds;
	size_t n, column[PARAMS_MOST]; /* the parameters that move */
	double range[PARAMS_MOST];     /* of all parameters */
	double *r, *J, *r_beside, *J_beside;
	double H[PARAMS_MOST][PARAMS_MOST]; /* see compute_misfit_hessian */
};

/* Moves parameters that are on a bound, apart from rounding, onto it. */
static void
snap_params_to_bounds(const struct bounds *b, struct params *p)
{
	for (size_t j = 0; j < breakage_model_of_params(p)->n; j++) {
		double near = ON_BOUND * (b->upper[j] - b->lower[j]);
		if (p->at[j] - b->lower[j] < near)
			p->at[j] = b->lower[j];
		else if (b->upper[j] - p->at[j] < near)
			p->at[j] = b->upper[j];
	}
}

/* Lists the parameters that move: all except those on a bound and the largest
 * of the gauge, of which only the direction matters. */
static void
list_params_off_bounds(struct newton *w, const struct params *p)
{
	const struct breakage *of = breakage_model_of_params(p);
	size_t held = params_index_of_largest_beta(p);
	w->n = 0;
	for (size_t j = 0; j < of->n; j++) {
		double lower = w->bounds->lower[j], upper = w->bounds->upper[j];
		w->range[j] = bounds_scale_of_param(w->bounds, p, j);
		if (j != held && p->at[j] > lower && p->at[j] < upper)
			w->column[w->n++] = j;
	}
}

/* Computes g [n], half the gradient with parameters in units of their ranges.
 * Returns the misfit. */
static double
compute_misfit_gradient(struct newton *w, const struct params *p, double *g)
{
	size_t rows = w->misfit->n_residual, width = w->misfit->of->n;
	double misfit = misfit_jacobian(w->misfit, p, w->r, w->J);
	for (size_t c = 0; c < w->n; c++) {
		size_t j = w->column[c];
		g[c] = 0;
		for (size_t i = 0; i < rows; i++)
			g[c] += w->r[i] * w->J[i * width + j];
		g[c] *= w->range[j];
	}
	return misfit;
}

/* Adds the curvature of the residuals along a parameter to its row of H, from
 * the change of J between points on either side. */
static void
add_residual_curvature_row(struct newton *w, const struct params *p, size_t c)
{
	size_t rows = w->misfit->n_residual, width = w->misfit->of->n;
	for (int side = -1; side <= 1; side += 2) {
		struct params q = *p;
		q.at[w->column[c]] += side * APART * w->range[w->column[c]];
		misfit_jacobian(w->misfit, &q, w->r_beside, w->J_beside);
		for (size_t d = 0; d < w->n; d++) {
			size_t j = w->column[d];
			double sum = 0;
			for (size_t i = 0; i < rows; i++)
				sum += w->r[i] * w->J_beside[i * width + j];
			w->H[c][d] += side * sum * w->range[j] / (2 * APART);
		}
	}
}

/* Computes H, half the derivative of the gradient at the point of r and J, with
 * parameters in units of their ranges. */
static void
compute_misfit_hessian(struct newton *w, const struct params *p)
{
	size_t rows = w->misfit->n_residual, width = w->misfit->of->n;
	memset(w->H, 0, sizeof w->H);
	for (size_t c = 0; c < w->n; c++)
		add_residual_curvature_row(w, p, c);
	for (size_t c = 0; c < w->n; c++)
		for (size_t d = 0; d <= c; d++) {
			const double *a = w->J + w->column[c],
				     *b = w->J + w->column[d];
			double sum = 0;
			for (size_t i = 0; i < rows; i++)
				sum += a[i * width] * b[i * width];
			sum *= w->range[w->column[c]] * w->range[w->column[d]];
			sum += (w->H[c][d] + w->H[d][c]) / 2;
			w->H[c][d] = w->H[d][c] = sum;
		}
}

/* Replaces H with its Cholesky factor, on and below the diagonal.  Returns
 * false if it has none, for example if the data do not determine a
 * direction. */
static bool
factor_hessian(struct newton *w)
{
	const double open = 1e-13; /* share of the diagonal element */
	for (size_t c = 0; c < w->n; c++) {
		double least = open * w->H[c][c];
		for (size_t d = 0; d <= c; d++) {
			double sum = w->H[c][d];
			for (size_t k = 0; k < d; k++)
				sum -= w->H[c][k] * w->H[d][k];
			if (c == d && !(sum > least))
				return false;
			w->H[c][d] = c == d ? sqrt(sum) : sum / w->H[d][d];
		}
	}
	return true;
}

/* Computes H^-1 x in place. */
static void
solve_with_hessian(const struct newton *w, double *x)
{
	for (size_t c = 0; c < w->n; c++) {
		for (size_t k = 0; k < c; k++)
			x[c] -= w->H[c][k] * x[k];
		x[c] /= w->H[c][c];
	}
	for (size_t c = w->n; c-- > 0;) {
		for (size_t k = c + 1; k < w->n; k++)
			x[c] -= w->H[k][c] * x[k];
		x[c] /= w->H[c][c];
	}
}

/* Moves *p by Newton steps until the steps are only rounding errors.  Returns
 * false if it fails. */
static bool
newton_descend(struct newton *w, struct params *p)
{
	double g[PARAMS_MOST], before = INFINITY;
	double misfit = compute_misfit_gradient(w, p, g);
	compute_misfit_hessian(w, p);
	if (!isfinite(misfit) || !factor_hessian(w))
		return false;
	for (int i = 0; i < STEPS; i++) {
		double most = 0;
		solve_with_hessian(w, g);
		for (size_t c = 0; c < w->n; c++) {
			size_t j = w->column[c];
			p->at[j] -= g[c] * w->range[j];
			most = fmax(most, fabs(g[c]));
			if (!(p->at[j] > w->bounds->lower[j] &&
				p->at[j] < w->bounds->upper[j]))
				return false;
		}
		if (!(most < BESIDE))
			return false;
		if (most < AT_REST && most > before / 4)
			return true;
		before = most;
		compute_misfit_gradient(w, p, g);
	}
	return before < AT_REST;
}

/* Returns the nearest parameters that are whole multiples of COARSE. */
static struct params
round_params_to_few_digits(const struct newton *w, const struct params *p)
{
	struct params q = *p;
	for (size_t c = 0; c < w->n; c++) {
		size_t j = w->column[c];
		double unit = COARSE * w->range[j];
		double lower = w->bounds->lower[j];
		q.at[j] = lower + unit * round((p->at[j] - lower) / unit);
	}
	return q;
}

bool
settle_at_stationary_point(
    struct misfit *m, const struct bounds *bounds, struct params *p)
{
	size_t rows = m->n_residual, width = m->of->n;
	FREED double *room = xcalloc_doubles(2 * rows * (width + 1));
	struct newton w = {.misfit = m, .bounds = bounds};
	w.r = room;
	w.r_beside = w.r + rows;
	w.J = w.r_beside + rows;
	w.J_beside = w.J + rows * width;
	struct params near = *p;
	snap_params_to_bounds(bounds, &near);
	list_params_off_bounds(&w, &near);
	bool found = w.n > 0 && rows >= w.n && newton_descend(&w, &near);
	struct params q = round_params_to_few_digits(&w, &near);
	found = found && newton_descend(&w, &q) &&
		misfit_of_params(m, &q) <=
		    misfit_of_params(m, p) * (1 + NOTHING) + EXACT;
	if (found)
		*p = q;
	return found;
}
