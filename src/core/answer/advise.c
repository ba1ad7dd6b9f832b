/* Regresses an answer on the principal components of one more sample, over the
 * draws: singular values by GSL, R^2 adjusted for the number of components.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/advise.h"

#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_statistics_double.h>

#include "core/posterior/posterior.h"

enum { N = POSTERIOR_DRAWS, MOST = 8 };

/* The rows about their means, as columns. */
static gsl_matrix *
centred(const double *row, size_t n)
{
	gsl_matrix *A = gsl_matrix_alloc(N, n);
	for (size_t i = 0; i < n; i++) {
		double mean = gsl_stats_mean(row + i * N, 1, N);
		for (size_t d = 0; d < N; d++)
			gsl_matrix_set(A, d, i, row[i * N + d] - mean);
	}
	return A;
}

double
advise_share(const double *answer, const double *sample, size_t n)
{
	gsl_matrix *U = centred(sample, n), *y = centred(answer, 1);
	gsl_matrix *V = gsl_matrix_alloc(n, n);
	gsl_vector *sigma = gsl_vector_alloc(n), *work = gsl_vector_alloc(n);
	gsl_vector_view target = gsl_matrix_column(y, 0);
	double all = gsl_blas_dnrm2(&target.vector), known = 0, best = 0;
	gsl_linalg_SV_decomp(U, V, sigma, work);
	for (size_t k = 0; k < n && k < MOST && all > 0; k++) {
		gsl_vector_view u = gsl_matrix_column(U, k);
		double along;
		if (gsl_vector_get(sigma, k) <= 1e-9 * gsl_vector_get(sigma, 0))
			break;
		gsl_blas_ddot(&u.vector, &target.vector, &along);
		known += along / all * (along / all);
		double spare = N - 2 - (double)k;
		best = fmax(best, 1 - (1 - known) * (N - 1) / spare);
	}
	gsl_matrix_free(U);
	gsl_matrix_free(V);
	gsl_matrix_free(y);
	gsl_vector_free(sigma);
	gsl_vector_free(work);
	return fmin(best, 1);
}
