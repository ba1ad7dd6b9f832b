/* Singular values: the parts make the matrix again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/numeric/svd.h"

#include "made.h"

enum { MOST = 12 };

static void
fill(double *A, size_t n, uint64_t seed)
{
	struct rng_key key = rng_make_key(seed, 0, 0);
	for (size_t i = 0; i < n; i++)
		A[i] = rng_normal(key, (uint32_t)i);
}

static double
dot(const double *a, const double *b, size_t n)
{
	double sum = 0;
	for (size_t i = 0; i < n; i++)
		sum += a[i] * b[i];
	return sum;
}

/* Decomposes A [n * rows] and holds what the header says of the parts, sigma
 * being above 0 for the first `rank`. */
static void
holds(const double *A, size_t rows, size_t n, size_t rank)
{
	double U[MOST * MOST], V[MOST * MOST], sigma[MOST];
	double size = sqrt(dot(A, A, rows * n)), near = 1e-14 * size;
	memcpy(U, A, rows * n * sizeof *U);
	svd_decompose(U, rows, n, V, sigma);
	for (size_t a = 0; a < n; a++) {
		assert_true(sigma[a] >= 0);
		assert_true(a == 0 || sigma[a] <= sigma[a - 1]);
		assert_true((sigma[a] > near) == (a < rank));
		size_t most = 0;
		for (size_t i = 0; i < n; i++)
			if (fabs(V[a * n + i]) > fabs(V[a * n + most]))
				most = i;
		assert_true(V[a * n + most] > 0);
		for (size_t b = 0; b < n; b++) {
			expect_near(
			    "V", dot(V + a * n, V + b * n, n), a == b, 1e-14);
			if (a < rank && b < rank)
				expect_near("U",
				    dot(U + a * rows, U + b * rows, rows),
				    a == b, 1e-13);
		}
	}
	for (size_t c = 0; c < n; c++)
		for (size_t i = 0; i < rows; i++) {
			double sum = 0;
			for (size_t k = 0; k < rank; k++)
				sum +=
				    U[k * rows + i] * sigma[k] * V[k * n + c];
			expect_near("A", sum, A[c * rows + i], 4 * near);
		}
}

static void
any_shape_is_taken_apart(void **state)
{
	(void)state;
	double A[MOST * MOST];
	for (size_t rows = 1; rows <= MOST; rows++)
		for (size_t n = 1; n <= MOST; n++) {
			fill(A, rows * n, 100 * rows + n);
			holds(A, rows, n, rows < n ? rows : n);
		}
}

static void
columns_that_depend_on_others_have_sigma_0(void **state)
{
	(void)state;
	double A[MOST * MOST];
	fill(A, 3 * MOST, 1);
	for (size_t i = 0; i < MOST; i++) {
		A[3 * MOST + i] = A[i] - 2 * A[MOST + i];
		A[4 * MOST + i] = 0;
		A[5 * MOST + i] = 1e-3 * A[2 * MOST + i];
	}
	holds(A, MOST, 6, 3);
	memset(A, 0, sizeof A);
	holds(A, MOST, 4, 0);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(any_shape_is_taken_apart),
	    cmocka_unit_test(columns_that_depend_on_others_have_sigma_0),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
