/* The least determined direction of a fit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/flat.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"

/* Marks the parameters that may move and gives the length of their ranges. */
static size_t
movable(const struct params *p, const struct bounds *b,
    size_t column[PARAM_COUNT], double range[PARAM_COUNT])
{
	size_t n = 0, largest = 0;
	for (size_t j = 1; j < 4; j++)
		if (fabs(p->beta[j]) > fabs(p->beta[largest]))
			largest = j;
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		double x = params_get(p, j);
		range[j] = b->upper[j] - b->lower[j];
		bool fixed = !(range[j] > 0);
		bool bound =
		    j >= PARAM_F_MAT &&
		    fmin(x - b->lower[j], b->upper[j] - x) <= 1e-6 * range[j];
		if (j < PARAM_F_MAT)
			range[j] = 2 * fabs(p->beta[largest]);
		if (!fixed && !bound && j != largest && range[j] > 0)
			column[n++] = j;
	}
	return n;
}

struct flat
flat_direction(
    struct misfit *m, const struct params *p, const struct bounds *bounds)
{
	struct flat flat = {{0}, 0};
	size_t column[PARAM_COUNT], rows = m->n_residual;
	double range[PARAM_COUNT];
	size_t n = movable(p, bounds, column, range);
	if (n == 0 || rows < n)
		return flat;
	double *r = xdoubles(rows), *J = xdoubles(rows * PARAM_COUNT);
	double misfit = misfit_jacobian(m, p, r, J);
	gsl_matrix *A = gsl_matrix_alloc(rows, n);
	gsl_matrix *V = gsl_matrix_alloc(n, n);
	gsl_vector *sigma = gsl_vector_alloc(n), *work = gsl_vector_alloc(n);
	for (size_t i = 0; i < rows; i++)
		for (size_t c = 0; c < n; c++)
			gsl_matrix_set(A, i, c,
			    J[i * PARAM_COUNT + column[c]] * range[column[c]]);
	gsl_linalg_SV_decomp(A, V, sigma, work);
	double step =
	    sqrt(0.1 * misfit) / fmax(gsl_vector_get(sigma, n - 1), 1e-12);
	for (size_t c = 0; c < n; c++) {
		double part = step * gsl_matrix_get(V, c, n - 1);
		flat.part[column[c]] = part;
		flat.reach = fmax(flat.reach, fabs(part));
	}
	gsl_matrix_free(A);
	gsl_matrix_free(V);
	gsl_vector_free(sigma);
	gsl_vector_free(work);
	free(r);
	free(J);
	return flat;
}
