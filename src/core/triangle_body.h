/* Triangles and covariances by rows, whose innermost loops go along a row: a
 * compiler makes vectors of them that add in the order written, so that the
 * bits are the same for each instruction set.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/discrepancy.h"

/* Row i less what the rows above it take, in the order of these rows. */
static inline void
take_above(double *U, size_t n, size_t i)
{
	double *restrict row = U + i * n;
	size_t k = 0;
	for (; k + 4 <= i; k += 4) {
		const double *a = U + k * n, *b = a + n, *c = b + n, *d = c + n;
		double p = a[i], q = b[i], r = c[i], s = d[i];
		for (size_t j = i; j < n; j++)
			row[j] =
			    row[j] - p * a[j] - q * b[j] - r * c[j] - s * d[j];
	}
	for (; k < i; k++) {
		const double *a = U + k * n;
		double p = a[i];
		for (size_t j = i; j < n; j++)
			row[j] -= p * a[j];
	}
}

static void
cholesky(double *U, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		take_above(U, n, i);
		double *row = U + i * n, diagonal = sqrt(row[i]);
		row[i] = diagonal;
		for (size_t j = i + 1; j < n; j++)
			row[j] /= diagonal;
	}
}

static void
forward(const double *U, size_t n, double *restrict d)
{
	for (size_t k = 0; k < n; k++) {
		const double *row = U + k * n;
		double z = d[k] /= row[k];
		for (size_t j = k + 1; j < n; j++)
			d[j] -= row[j] * z;
	}
}

/* Cell i with those from it on; of_f, of_error: covariances of its size with
 * the others. */
static inline void
covariance_row(const struct cell_columns *c, size_t i,
    const double *restrict of_f, const double *restrict of_error,
    double *restrict row)
{
	const double *restrict h = c->h, *restrict t = c->term[0],
			       *restrict u = c->term[1],
			       *restrict v = c->term[2];
	const int64_t *restrict size = c->size, *restrict run = c->run;
	double own_h = h[i], own_t = t[i], own_u = u[i], own_v = v[i];
	int64_t own_run = run[i];
	for (size_t j = i + 1; j < c->n; j++) {
		double K = of_f[size[j]] *
			   (own_t * t[j] + own_u * u[j] + own_v * v[j]);
		double error = of_error[size[j]];
		row[j] = (K + (run[j] == own_run ? error : 0)) * (own_h * h[j]);
	}
	double K =
	    of_f[size[i]] * (own_t * own_t + own_u * own_u + own_v * own_v);
	row[i] = (K + of_error[size[i]] + c->own) * (own_h * own_h) +
		 DISCREPANCY_ROUNDING * DISCREPANCY_ROUNDING;
}

/* Runs have the same sieves, mostly: the exponentials are of pairs of sizes,
 * and not of pairs of cells. */
static void
covariance(
    const struct cell_columns *c, const double hyper[static HYPERS], double *U)
{
	double *restrict f = c->pair[0], *restrict error = c->pair[1];
	size_t pairs = 0;
	for (size_t s = 0; s < c->sizes; s++)
		for (size_t k = 0; k <= s; k++)
			f[pairs++] = c->log_size[s] - c->log_size[k];
	for (size_t i = 0; i < pairs; i++) {
		double apart = f[i];
		f[i] = discrepancy_covariance(apart, hyper);
		error[i] = discrepancy_shared(apart, hyper);
	}
	for (size_t s = 0; s < c->sizes; s++) {
		for (size_t k = 0; k < c->sizes; k++) {
			size_t more = s > k ? s : k, less = s > k ? k : s;
			size_t pair = more * (more + 1) / 2 + less;
			c->f[k] = f[pair];
			c->error[k] = error[pair];
		}
		for (size_t i = 0; i < c->n; i++)
			if (c->size[i] == (int64_t)s)
				covariance_row(
				    c, i, c->f, c->error, U + i * c->n);
	}
}

const struct triangle TRIANGLE_NAME = {covariance, cholesky, forward};
