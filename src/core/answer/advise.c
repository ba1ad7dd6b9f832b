/* Regresses an answer on the principal components of one more sample, over the
 * draws, by singular value decomposition.  R^2 is adjusted for the number of
 * components.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/advise.h"

#include <math.h>

#include "base/xalloc.h"
#include "core/numeric/elementary.h"
#include "core/numeric/svd.h"
#include "core/posterior/posterior.h"

enum { N = POSTERIOR_DRAWS, MOST = 8 };

/* Returns a copy of the rows with their means subtracted. */
static double *
subtract_row_means(const double *row, size_t n)
{
	double *to = xcalloc_doubles(n * N);
	for (size_t i = 0; i < n; i++) {
		double mean = 0;
		for (size_t d = 0; d < N; d++)
			mean += row[i * N + d] / N;
		for (size_t d = 0; d < N; d++)
			to[i * N + d] = row[i * N + d] - mean;
	}
	return to;
}

double
advise_variance_share_removed(
    const double *answer, const double *sample, size_t n)
{
	FREED double *U = subtract_row_means(sample, n),
		     *y = subtract_row_means(answer, 1);
	FREED double *V = xcalloc_doubles(n * n), *sigma = xcalloc_doubles(n);
	double all = el_dot(y, y, N), known = 0, best = 0;
	svd_decompose(U, N, n, V, sigma);
	for (size_t k = 0; k < n && k < MOST && all > 0; k++) {
		if (sigma[k] <= 1e-9 * sigma[0])
			break;
		double along = el_dot(U + k * N, y, N);
		known += along * along / all;
		double spare = N - 2 - (double)k;
		best = fmax(best, 1 - (1 - known) * (N - 1) / spare);
	}
	return fmin(best, 1);
}
