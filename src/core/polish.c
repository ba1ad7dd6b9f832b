/* Bounded Levenberg-Marquardt on the misfit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/polish.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

struct polish {
	struct misfit *misfit;
	size_t n;
	double *r, *J, *r_try, *J_try;
	gsl_matrix *A; /* the Jacobian's free columns over the damping */
	gsl_vector *b, *step, *residual, *tau;
	double scale[PARAM_COUNT]; /* largest column norms seen (More) */
};

struct polish *
polish_new(struct misfit *m)
{
	struct polish *s = xcalloc(1, sizeof *s);
	size_t n = m->n_residual;
	s->misfit = m;
	s->n = n;
	s->r = xdoubles(n);
	s->r_try = xdoubles(n);
	s->J = xdoubles(n * PARAM_COUNT);
	s->J_try = xdoubles(n * PARAM_COUNT);
	s->A = gsl_matrix_alloc(n + PARAM_COUNT, PARAM_COUNT);
	s->b = gsl_vector_alloc(n + PARAM_COUNT);
	s->residual = gsl_vector_alloc(n + PARAM_COUNT);
	s->step = gsl_vector_alloc(PARAM_COUNT);
	s->tau = gsl_vector_alloc(PARAM_COUNT);
	return s;
}

void
polish_free(struct polish *s)
{
	if (s == NULL)
		return;
	free(s->r);
	free(s->r_try);
	free(s->J);
	free(s->J_try);
	gsl_matrix_free(s->A);
	gsl_vector_free(s->b);
	gsl_vector_free(s->residual);
	gsl_vector_free(s->step);
	gsl_vector_free(s->tau);
	free(s);
}

/* Marks the parameters that may move: not fixed, and not on a bound that the
 * gradient pushes against.  Returns how many. */
static size_t
free_columns(const struct polish *s, const struct bounds *bounds,
    const struct params *p, size_t column[PARAM_COUNT])
{
	size_t n_free = 0;
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		double gradient = 0, norm = 0, x = p->at[j];
		for (size_t i = 0; i < s->n; i++) {
			double d = s->J[i * PARAM_COUNT + j];
			gradient += s->r[i] * d;
			norm += d * d;
		}
		bool held = bounds->lower[j] >= bounds->upper[j] ||
			    (x <= bounds->lower[j] && gradient > 0) ||
			    (x >= bounds->upper[j] && gradient < 0) ||
			    !(norm > 0);
		if (!held)
			column[n_free++] = j;
	}
	return n_free;
}

static void
update_scale(struct polish *s)
{
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		double norm = 0;
		for (size_t i = 0; i < s->n; i++) {
			double d = s->J[i * PARAM_COUNT + j];
			norm += d * d;
		}
		s->scale[j] = fmax(s->scale[j], sqrt(norm));
	}
}

/* Solves min |J d + r|^2 + damping |D d|^2 over the free columns. */
static void
damped_step(struct polish *s, const size_t *column, size_t n_free,
    double damping, double step[PARAM_COUNT])
{
	size_t rows = s->n + n_free;
	gsl_matrix_view A = gsl_matrix_submatrix(s->A, 0, 0, rows, n_free);
	gsl_vector_view b = gsl_vector_subvector(s->b, 0, rows);
	gsl_vector_view residual = gsl_vector_subvector(s->residual, 0, rows);
	gsl_vector_view x = gsl_vector_subvector(s->step, 0, n_free);
	gsl_vector_view tau = gsl_vector_subvector(s->tau, 0, n_free);
	gsl_matrix_set_zero(&A.matrix);
	gsl_vector_set_zero(&b.vector);
	for (size_t i = 0; i < s->n; i++) {
		for (size_t c = 0; c < n_free; c++)
			gsl_matrix_set(
			    &A.matrix, i, c, s->J[i * PARAM_COUNT + column[c]]);
		gsl_vector_set(&b.vector, i, -s->r[i]);
	}
	for (size_t c = 0; c < n_free; c++)
		gsl_matrix_set(&A.matrix, s->n + c, c,
		    sqrt(damping) * s->scale[column[c]]);
	memset(step, 0, PARAM_COUNT * sizeof *step);
	gsl_linalg_QR_decomp(&A.matrix, &tau.vector);
	gsl_linalg_QR_lssolve(
	    &A.matrix, &tau.vector, &b.vector, &x.vector, &residual.vector);
	for (size_t c = 0; c < n_free; c++)
		step[column[c]] = gsl_vector_get(&x.vector, c);
}

static struct params
moved(const struct params *p, const double step[PARAM_COUNT],
    const struct bounds *bounds)
{
	struct params q = *p;
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		double x = p->at[j] + step[j];
		x = x > bounds->lower[j] ? x : bounds->lower[j];
		q.at[j] = x < bounds->upper[j] ? x : bounds->upper[j];
	}
	return q;
}

static void
accept(struct polish *s)
{
	double *r = s->r, *J = s->J;
	s->r = s->r_try;
	s->r_try = r;
	s->J = s->J_try;
	s->J_try = J;
}

/* Every PATIENCE evaluations: whether so far above the rival's misfit more of
 * such gains are of no use. */
enum { PATIENCE = 8 };
static bool
is_hopeless(double before, double now, const struct polish_rival *rival)
{
	if (rival == NULL)
		return false;
	double above = now - rival->misfit;
	return above < 1e-9 * rival->misfit ||
	       rival->hope * (before - now) < above;
}

struct polish_result
polish_run(struct polish *s, const struct bounds *bounds, int max_steps,
    const struct polish_rival *rival, struct params *p)
{
	const double least_damping = 1e-14, most_damping = 1e12;
	double damping = 1e-2, grow = 2;
	size_t column[PARAM_COUNT];
	int small = 0;
	memset(s->scale, 0, sizeof s->scale);
	struct polish_result result = {
	    misfit_jacobian(s->misfit, p, s->r, s->J), 1, false, false};
	double before = result.misfit;
	while (result.evaluations < max_steps && !result.converged) {
		result.stopped = misfit_stopped(s->misfit);
		if (result.stopped)
			break;
		if (result.evaluations % PATIENCE == 0) {
			if (is_hopeless(before, result.misfit, rival))
				break;
			before = result.misfit;
		}
		update_scale(s);
		size_t n_free = free_columns(s, bounds, p, column);
		if (n_free == 0 || !isfinite(result.misfit)) {
			result.converged = n_free == 0;
			break;
		}
		double step[PARAM_COUNT];
		damped_step(s, column, n_free, damping, step);
		struct params q = moved(p, step, bounds);
		double trial =
		    misfit_jacobian(s->misfit, &q, s->r_try, s->J_try);
		result.evaluations++;
		if (!(trial < result.misfit)) {
			damping *= grow;
			grow *= 2;
			result.converged = damping > most_damping;
			continue;
		}
		double gain = (result.misfit - trial) / result.misfit;
		small = gain < 1e-13 ? small + 1 : 0;
		result.converged = small >= 3 || trial < 1e-28;
		*p = q;
		accept(s);
		result.misfit = trial;
		damping = fmax(damping / 5, least_damping);
		grow = 2;
	}
	return result;
}
