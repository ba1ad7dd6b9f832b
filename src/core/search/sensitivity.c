/* Singular values of the scaled Jacobian of a fit (svd.h), and the direction of
 * least change.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/sensitivity.h"

#include <math.h>

#include "base/xalloc.h"
#include "core/numeric/svd.h"

bool
sensitivity_is_param_on_bound(
    const struct bounds *b, const struct params *p, size_t j)
{
	double x = p->at[j], range = b->upper[j] - b->lower[j];
	double near = fmin(x - b->lower[j], b->upper[j] - x);
	return j >= breakage_model_of_params(p)->gauge && range > 0 &&
	       near <= 1e-6 * range;
}

/* Lists the parameters that may move, and sets all ranges. */
static void
list_params_that_may_move(struct sensitivity *s, const struct params *p,
    const struct bounds *b, bool inward)
{
	size_t held = params_index_of_largest_beta(p);
	for (size_t j = 0; j < breakage_model_of_params(p)->n; j++) {
		bool fixed = !(b->upper[j] > b->lower[j]);
		s->range[j] = bounds_scale_of_param(b, p, j);
		if (!fixed && j != held && s->range[j] > 0 &&
		    (inward || !sensitivity_is_param_on_bound(b, p, j)))
			s->column[s->n++] = j;
	}
}

static void
decompose_jacobian(struct sensitivity *s, const double *J, size_t width,
    size_t rows, double *basis)
{
	size_t n = s->n;
	FREED double *A = xcalloc_doubles(n * rows);
	double V[PARAMS_MOST * PARAMS_MOST];
	for (size_t c = 0; c < n; c++)
		for (size_t i = 0; i < rows; i++)
			A[c * rows + i] = J[i * width + s->column[c]] *
					  s->range[s->column[c]];
	svd_decompose(A, rows, n, V, s->sigma);
	for (size_t i = 0; i < n; i++)
		for (size_t c = 0; c < n; c++)
			s->direction[i][c] = V[i * n + c];
	for (size_t i = 0; basis != NULL && i < rows; i++)
		for (size_t c = 0; c < n; c++)
			if (s->sigma[c] > 1e-9 * s->sigma[0])
				basis[i * PARAMS_MOST + c] = A[c * rows + i];
}

struct sensitivity
sensitivity_of_misfit(struct misfit *m, const struct params *p,
    const struct bounds *bounds, bool inward, double *basis)
{
	struct sensitivity s = {0};
	size_t rows = m->n_residual, width = m->of->n;
	FREED double *r = xcalloc_doubles(rows),
		     *J = xcalloc_doubles(rows * width);
	s.misfit = misfit_jacobian(m, p, r, J);
	list_params_that_may_move(&s, p, bounds, inward);
	for (size_t i = 0; basis != NULL && i < rows * PARAMS_MOST; i++)
		basis[i] = 0;
	if (s.n > 0)
		decompose_jacobian(&s, J, width, rows, basis);
	return s;
}

struct flat_direction
sensitivity_flattest_direction(
    struct misfit *m, const struct params *p, const struct bounds *bounds)
{
	struct flat_direction flat = {{0}, 0};
	struct sensitivity s = sensitivity_of_misfit(m, p, bounds, false, NULL);
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
