/* Singular values of the scaled Jacobian of a fit, by GSL, and the direction of
 * least change.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/sensitivity.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"

bool
sensitivity_on_bound(const struct bounds *b, const struct params *p, size_t j)
{
	double x = p->at[j], range = b->upper[j] - b->lower[j];
	double near = fmin(x - b->lower[j], b->upper[j] - x);
	return j >= breakage_of(p)->gauge && range > 0 && near <= 1e-6 * range;
}

/* Marks the parameters that may move and gives the length of their ranges. */
static void
find_movable(struct sensitivity *s, const struct params *p,
    const struct bounds *b, bool inward)
{
	size_t largest = 0, gauge = breakage_of(p)->gauge;
	for (size_t j = 1; j < gauge; j++)
		if (fabs(p->at[j]) > fabs(p->at[largest]))
			largest = j;
	for (size_t j = 0; j < breakage_of(p)->n; j++) {
		bool fixed = !(b->upper[j] > b->lower[j]);
		bool held = gauge > 0 && j == largest;
		s->range[j] = j < gauge ? 2 * fabs(p->at[largest])
					: b->upper[j] - b->lower[j];
		if (!fixed && !held && s->range[j] > 0 &&
		    (inward || !sensitivity_on_bound(b, p, j)))
			s->column[s->n++] = j;
	}
}

/* J [rows * width].  The decomposition wants no fewer rows than columns;
 * rows of 0 change nothing. */
static void
decompose(struct sensitivity *s, const double *J, size_t width, size_t rows,
    double *basis)
{
	size_t n = s->n;
	gsl_matrix *A = gsl_matrix_calloc(rows > n ? rows : n, n);
	gsl_matrix *V = gsl_matrix_alloc(n, n);
	gsl_vector *sigma = gsl_vector_alloc(n), *work = gsl_vector_alloc(n);
	for (size_t i = 0; i < rows; i++)
		for (size_t c = 0; c < n; c++)
			gsl_matrix_set(A, i, c,
			    J[i * width + s->column[c]] *
				s->range[s->column[c]]);
	gsl_linalg_SV_decomp(A, V, sigma, work);
	for (size_t i = 0; i < n; i++) {
		s->sigma[i] = gsl_vector_get(sigma, i);
		for (size_t c = 0; c < n; c++)
			s->direction[i][c] = gsl_matrix_get(V, c, i);
	}
	for (size_t i = 0; basis != NULL && i < rows; i++)
		for (size_t c = 0; c < n; c++)
			if (s->sigma[c] > 1e-9 * s->sigma[0])
				basis[i * PARAMS_MOST + c] =
				    gsl_matrix_get(A, i, c);
	gsl_matrix_free(A);
	gsl_matrix_free(V);
	gsl_vector_free(sigma);
	gsl_vector_free(work);
}

struct sensitivity
sensitivity_of(struct misfit *m, const struct params *p,
    const struct bounds *bounds, bool inward, double *basis)
{
	struct sensitivity s = {0};
	size_t rows = m->n_residual, width = m->of->n;
	double *r = xdoubles(rows), *J = xdoubles(rows * width);
	s.misfit = misfit_jacobian(m, p, r, J);
	find_movable(&s, p, bounds, inward);
	for (size_t i = 0; basis != NULL && i < rows * PARAMS_MOST; i++)
		basis[i] = 0;
	if (s.n > 0)
		decompose(&s, J, width, rows, basis);
	free(r);
	free(J);
	return s;
}

struct flat
sensitivity_flat(
    struct misfit *m, const struct params *p, const struct bounds *bounds)
{
	struct flat flat = {{0}, 0};
	struct sensitivity s = sensitivity_of(m, p, bounds, false, NULL);
	if (s.n == 0 || m->n_residual < s.n)
		return flat;
	size_t least = s.n - 1;
	double step = sqrt(0.1 * s.misfit) / fmax(s.sigma[least], 1e-12);
	for (size_t c = 0; c < s.n; c++) {
		double part = step * s.direction[least][c];
		flat.part[s.column[c]] = part;
		flat.reach = fmax(flat.reach, fabs(part));
	}
	return flat;
}
