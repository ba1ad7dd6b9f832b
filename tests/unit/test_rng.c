/* Random numbers: uniform, and no stream like another.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "made.h"

static void
random_numbers_are_uniform(void **state)
{
	(void)state;
	enum { N = 20000, BINS = 20 };
	for (uint64_t seed = 0; seed < 8; seed++) {
		struct rng_key key = rng_make_key(seed, seed * 3, 5);
		double sum = 0, squares = 0, lag = 0, before = 0.5;
		size_t bin[BINS] = {0};
		for (uint32_t i = 0; i < N; i++) {
			double u = rng_uniform(key, i);
			assert_true(u > 0 && u < 1);
			sum += u;
			squares += (u - 0.5) * (u - 0.5);
			lag += (u - 0.5) * (before - 0.5);
			before = u;
			bin[(size_t)(u * BINS)]++;
		}
		/* Four standard deviations of each. */
		expect_near("mean", sum / N, 0.5, 4 * 0.2887 / sqrt(N));
		expect_near(
		    "variance", squares / N, 1.0 / 12, 4 * 0.0745 / sqrt(N));
		expect_near("lag", lag / N, 0, 4 / 12.0 / sqrt(N));
		for (size_t b = 0; b < BINS; b++)
			expect_near("bin", (double)bin[b], N / BINS,
			    4 * sqrt(N / BINS));
	}
}

static int
rising(const void *a, const void *b)
{
	uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
	return (x > y) - (x < y);
}

static void
no_two_streams_are_equal(void **state)
{
	(void)state;
	enum { N = 20 };
	static uint64_t first[N * N * N];
	size_t n = 0;
	for (uint64_t seed = 0; seed < N; seed++)
		for (uint64_t generation = 0; generation < N; generation++)
			for (uint64_t use = 0; use < N; use++) {
				struct rng_key key =
				    rng_make_key(seed, generation, use);
				first[n++] = (uint64_t)rng_random_bits(key, 0)
						 << 32 |
					     rng_random_bits(key, 1);
			}
	qsort(first, n, sizeof *first, rising);
	for (size_t i = 1; i < n; i++)
		assert_true(first[i] != first[i - 1]);
	struct rng_key key = rng_make_key(1, 2, 3);
	assert_true(rng_random_bits(key, 7) ==
		    rng_random_bits(rng_make_key(1, 2, 3), 7));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(random_numbers_are_uniform),
	    cmocka_unit_test(no_two_streams_are_equal),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
