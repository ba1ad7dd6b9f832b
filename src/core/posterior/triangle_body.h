/* Triangular matrices and covariances by rows.  Terms are added in the order
 * written, so all instruction sets give the same bits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/numeric/rng.h"
#include "core/posterior/discrepancy.h"
#include "core/search/lanes.h"

/* TAKEN columns are processed at a time, starting from the last. */
enum { TAKEN = 8, VECTORS = TAKEN / LANES };

/* Subtracts each row times its factor from TAKEN numbers of `to`, row by row.
 * row: the first row, with the next n numbers further on; p: the first row's
 * factor, with the next `step` numbers further on. */
static inline void
subtract_multiples_of_rows(double *to, const double *row, const double *p,
    size_t step, size_t n, size_t rows)
{
	lanes sum[VECTORS];
	for (size_t v = 0; v < VECTORS; v++)
		sum[v] = lanes_load(to + v * LANES);
	for (size_t k = 0; k < rows; k++)
		for (size_t v = 0; v < VECTORS; v++)
			sum[v] -=
			    p[k * step] * lanes_load(row + k * n + v * LANES);
	memcpy(to, sum, sizeof sum);
}

/* Subtracts from row i the contributions of the rows above it. */
static inline void
subtract_rows_above(double *U, size_t n, size_t i)
{
	double *row = U + i * n;
	size_t to = n;
	for (; to > i && to >= TAKEN; to -= TAKEN)
		subtract_multiples_of_rows(
		    row + to - TAKEN, U + to - TAKEN, U + i, n, n, i);
	for (size_t j = i; j < to; j++)
		for (size_t k = 0; k < i; k++)
			row[j] -= U[k * n + i] * U[k * n + j];
}

static void
cholesky(double *U, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		subtract_rows_above(U, n, i);
		double *row = U + i * n, diagonal = sqrt(row[i]);
		row[i] = diagonal;
		for (size_t j = i + 1; j < n; j++)
			row[j] /= diagonal;
	}
}

static void
solve_lower(const double *U, size_t n, double *d)
{
	size_t from = 0, to = n % TAKEN;
	for (; from < n; from = to, to += TAKEN) {
		for (size_t k = from; k < to; k++) {
			const double *row = U + k * n;
			double z = d[k] /= row[k];
			for (size_t j = k + 1; j < to; j++)
				d[j] -= row[j] * z;
		}
		for (size_t j = to; j < n; j += TAKEN)
			subtract_multiples_of_rows(
			    d + j, U + from * n + j, d + from, 1, n, to - from);
	}
}

/* Computes the covariances of cell i with itself and all later cells.  of_f,
 * of_error: the covariances of its size with all sizes. */
static inline void
fill_covariance_row(const struct cell_columns *c, size_t i,
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

static void
covariances_of_size_pairs(size_t n, const double hyper[static HYPERS],
    double *restrict f, double *restrict error)
{
	for (size_t i = 0; i < n; i++) {
		double apart = f[i];
		f[i] = discrepancy_covariance(apart, hyper);
		error[i] = discrepancy_shared_covariance(apart, hyper);
	}
}

/* Most runs have the same sieves, so exponentials are computed for pairs of
 * sizes, not for pairs of cells. */
static void
fill_cell_covariance(
    const struct cell_columns *c, const double hyper[static HYPERS], double *U)
{
	double *f = c->pair[0], *error = c->pair[1];
	size_t n = 0;
	for (size_t s = 0; s < c->sizes; s++)
		for (size_t k = 0; k <= s; k++)
			f[n++] = c->log_size[s] - c->log_size[k];
	covariances_of_size_pairs(n, hyper, f, error);
	for (size_t s = 0; s < c->sizes; s++) {
		for (size_t k = 0; k < c->sizes; k++) {
			size_t pair = discrepancy_index_of_pair(s, k);
			c->f[k] = f[pair];
			c->error[k] = error[pair];
		}
		for (size_t i = 0; i < c->n; i++)
			if (c->size[i] == (int64_t)s)
				fill_covariance_row(
				    c, i, c->f, c->error, U + i * c->n);
	}
}

/* Sums the same numbers in the same order as rng_normal. */
static void
compute_random_normals(
    struct rng_key key, uint32_t next, size_t n, double *restrict z)
{
	for (size_t i = 0; i < n; i++)
		z[i] = 0;
	for (uint32_t j = 0; j < 12; j++)
		for (uint32_t i = 0; i < (uint32_t)n; i++)
			z[i] += rng_uniform(key, 12 * (next + i) + j);
	for (size_t i = 0; i < n; i++)
		z[i] -= 6;
}

const struct triangle TRIANGLE_NAME = {covariances_of_size_pairs,
    fill_cell_covariance, cholesky, solve_lower, compute_random_normals};
