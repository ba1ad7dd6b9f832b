/* Singular values by one-sided Jacobi: rotates columns in pairs until all are
 * orthogonal.  Uses only double arithmetic and square roots, which round
 * identically everywhere.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/numeric/svd.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "core/numeric/elementary.h"

/* Columns shorter than this, relative to all of A, are rounding errors of 0 and
 * have no direction. */
static const double NOTHING = 1e-17;

enum { SWEEPS_MOST = 60 };

static void
svd_rotate_columns(double *a, double *b, size_t n, double c, double s)
{
	for (size_t i = 0; i < n; i++) {
		double x = a[i], y = b[i];
		a[i] = c * x - s * y;
		b[i] = s * x + c * y;
	}
}

/* Makes two columns orthogonal.  Returns false if they already were. */
static bool
svd_orthogonalise_two_columns(double *a, double *b, size_t rows, double *va,
    double *vb, size_t n, double least)
{
	double aa = el_dot(a, a, rows), bb = el_dot(b, b, rows),
	       ab = el_dot(a, b, rows);
	double rounding = (double)rows * DBL_EPSILON;
	bool straight = fabs(ab) <= rounding * sqrt(aa) * sqrt(bb);
	if (straight || aa <= least || bb <= least)
		return false;
	double zeta = (bb - aa) / (2 * ab);
	double t = 1 / (fabs(zeta) + sqrt(1 + zeta * zeta));
	t = zeta < 0 ? -t : t;
	double c = 1 / sqrt(1 + t * t);
	svd_rotate_columns(a, b, rows, c, c * t);
	svd_rotate_columns(va, vb, n, c, c * t);
	return true;
}

static void
svd_swap_columns(double *a, double *b, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		double x = a[i];
		a[i] = b[i];
		b[i] = x;
	}
}

/* Divides a column by its length and makes the largest element of its direction
 * positive. */
static void
svd_normalise_column(double *u, size_t rows, double *v, size_t n, double sigma)
{
	size_t most = 0;
	for (size_t i = 1; i < n; i++)
		if (fabs(v[i]) > fabs(v[most]))
			most = i;
	double sign = v[most] < 0 ? -1 : 1;
	for (size_t i = 0; i < n; i++)
		v[i] *= sign;
	for (size_t i = 0; i < rows; i++)
		u[i] = sigma > 0 ? sign * u[i] / sigma : 0;
}

void
svd_decompose(double *A, size_t rows, size_t n, double *V, double *sigma)
{
	double least = NOTHING * NOTHING * el_dot(A, A, rows * n);
	bool turned = true;
	for (size_t i = 0; i < n * n; i++)
		V[i] = i % (n + 1) == 0;
	for (size_t k = 0; k < SWEEPS_MOST && turned; k++) {
		turned = false;
		for (size_t a = 0; a + 1 < n; a++)
			for (size_t b = a + 1; b < n; b++)
				turned |= svd_orthogonalise_two_columns(
				    A + a * rows, A + b * rows, rows, V + a * n,
				    V + b * n, n, least);
	}
	for (size_t c = 0; c < n; c++)
		sigma[c] = sqrt(el_dot(A + c * rows, A + c * rows, rows));
	for (size_t c = 0; c < n; c++) {
		size_t most = c;
		for (size_t d = c + 1; d < n; d++)
			if (sigma[d] > sigma[most])
				most = d;
		svd_swap_columns(sigma + c, sigma + most, 1);
		if (most != c) {
			svd_swap_columns(A + c * rows, A + most * rows, rows);
			svd_swap_columns(V + c * n, V + most * n, n);
		}
		svd_normalise_column(
		    A + c * rows, rows, V + c * n, n, sigma[c]);
	}
}
