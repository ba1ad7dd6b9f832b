/* Bounded Levenberg-Marquardt on the misfit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/polish.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

struct polish {
	struct misfit *misfit;
	size_t n, width; /* of rows, the model's n */
	double *r, *J, *r_try, *J_try;
	/* The Jacobian's free columns and -r over the damping and 0. */
	double (*A)[PARAMS_MOST + 1];
	double scale[PARAMS_MOST]; /* largest column norms seen (More) */
};

struct polish *
polish_new(struct misfit *m)
{
	struct polish *s = xcalloc(1, sizeof *s);
	size_t n = m->n_residual;
	s->misfit = m;
	s->n = n;
	s->width = m->of->n;
	s->r = xdoubles(n);
	s->r_try = xdoubles(n);
	s->J = xdoubles(n * s->width);
	s->J_try = xdoubles(n * s->width);
	s->A = xcalloc(n + s->width, sizeof *s->A);
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
	free(s->A);
	free(s);
}

/* Marks the parameters that may move: not fixed, and not on a bound that the
 * gradient pushes against.  Returns how many. */
static size_t
free_columns(const struct polish *s, const struct bounds *bounds,
    const struct params *p, size_t column[PARAMS_MOST])
{
	size_t n_free = 0;
	for (size_t j = 0; j < s->width; j++) {
		double gradient = 0, norm = 0, x = p->at[j];
		for (size_t i = 0; i < s->n; i++) {
			double d = s->J[i * s->width + j];
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
	for (size_t j = 0; j < s->width; j++) {
		double norm = 0;
		for (size_t i = 0; i < s->n; i++) {
			double d = s->J[i * s->width + j];
			norm += d * d;
		}
		s->scale[j] = fmax(s->scale[j], sqrt(norm));
	}
}

/* Brings column c of A [rows] to `top` and zeros below it, by the reflection
 * that the column becomes; the n columns after it go through the same. */
static void
reflect(
    double (*A)[PARAMS_MOST + 1], size_t rows, size_t c, size_t n, double top)
{
	double along[PARAMS_MOST + 1] = {0};
	A[c][c] -= top;
	for (size_t i = c; i < rows; i++)
		for (size_t k = c + 1; k <= c + n; k++)
			along[k] += A[i][c] * A[i][k];
	double half = -top * A[c][c]; /* of the column's square */
	for (size_t i = c; i < rows; i++)
		for (size_t k = c + 1; k <= c + n; k++)
			A[i][k] -= A[i][c] * (along[k] / half);
}

/* x [n] with the least |A x - b|, where b is column n of A [rows], by
 * Householder's reflections; A is used up.  Of our own, because a library's
 * last bits differ between its versions and processors, and perturbations go on
 * from them. */
static void
least_squares(double (*A)[PARAMS_MOST + 1], size_t rows, size_t n, double *x)
{
	double top[PARAMS_MOST] = {0};
	for (size_t c = 0; c < n; c++) {
		double norm = 0;
		for (size_t i = c; i < rows; i++)
			norm += A[i][c] * A[i][c];
		top[c] = A[c][c] > 0 ? -sqrt(norm) : sqrt(norm);
		if (norm > 0)
			reflect(A, rows, c, n - c, top[c]);
	}
	for (size_t c = n; c-- > 0;) {
		x[c] = A[c][n];
		for (size_t k = c + 1; k < n; k++)
			x[c] -= A[c][k] * x[k];
		x[c] = top[c] != 0 ? x[c] / top[c] : 0;
	}
}

/* Solves min |J d + r|^2 + damping |D d|^2 over the free columns. */
static void
damped_step(struct polish *s, const size_t *column, size_t n_free,
    double damping, double step[PARAMS_MOST])
{
	double x[PARAMS_MOST];
	memset(s->A, 0, (s->n + n_free) * sizeof *s->A);
	for (size_t i = 0; i < s->n; i++) {
		for (size_t c = 0; c < n_free; c++)
			s->A[i][c] = s->J[i * s->width + column[c]];
		s->A[i][n_free] = -s->r[i];
	}
	for (size_t c = 0; c < n_free; c++)
		s->A[s->n + c][c] = sqrt(damping) * s->scale[column[c]];
	least_squares(s->A, s->n + n_free, n_free, x);
	memset(step, 0, PARAMS_MOST * sizeof *step);
	for (size_t c = 0; c < n_free; c++)
		step[column[c]] = x[c];
}

static struct params
moved(const struct params *p, const double step[PARAMS_MOST],
    const struct bounds *bounds)
{
	struct params q = *p;
	for (size_t j = 0; j < breakage_of(p)->n; j++) {
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
	       rival->gains * (before - now) < above;
}

struct polish_result
polish_run(struct polish *s, const struct bounds *bounds, int max_steps,
    const struct polish_rival *rival, struct params *p)
{
	const double least_damping = 1e-14, most_damping = 1e12;
	double damping = 1e-2, grow = 2;
	size_t column[PARAMS_MOST];
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
		double step[PARAMS_MOST];
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
