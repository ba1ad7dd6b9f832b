/* What a sample takes away from the variance of an answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "made.h"

#include <math.h>

#include "core/answer/advise.h"
#include "core/posterior/posterior.h"

enum { N = POSTERIOR_DRAWS, ROWS = 12 };

static double
normal(uint32_t at)
{
	return rng_normal(rng_make_key(5, 1, 9), at);
}

/* Draws of an answer, and of passings that hold a share of it with noise. */
static void
fill(double share, double *answer, double *sample)
{
	for (uint32_t d = 0; d < N; d++) {
		answer[d] = 3 + normal(d);
		for (uint32_t i = 0; i < ROWS; i++)
			sample[i * N + d] = 0.2 + 0.01 * normal(N + i * N + d);
		/* Three sieves tell it, by different amounts. */
		for (uint32_t i = 0; i < 3; i++)
			sample[i * N + d] +=
			    share * (0.05 + 0.02 * i) * (answer[d] - 3);
	}
}

static void
test_share(void **state)
{
	(void)state;
	double answer[N], sample[ROWS * N];
	fill(1, answer, sample);
	/* Signal 0.05, 0.07, 0.09 over noise of 0.01: 1 - 1 / 156. */
	assert_true(fabs(advise_variance_share_removed(answer, sample, ROWS) -
			 0.9936) < 0.004);
	fill(0.1, answer, sample);
	/* 1 - 1 / 2.55 at best. */
	double some = advise_variance_share_removed(answer, sample, ROWS);
	assert_true(some > 0.45 && some < 0.7);
	fill(0, answer, sample);
	assert_true(advise_variance_share_removed(answer, sample, ROWS) < 0.05);
}

/* As many sieves as you like of pure noise explain nothing. */
static void
test_noise(void **state)
{
	(void)state;
	enum { MANY = 60 };
	static double sample[MANY * N];
	double answer[N];
	for (uint32_t d = 0; d < N; d++)
		answer[d] = normal(d);
	for (uint32_t i = 0; i < MANY * N; i++)
		sample[i] = normal(N + i);
	assert_true(advise_variance_share_removed(answer, sample, MANY) < 0.05);
}

/* An answer that is the same in all draws, and rows that never change. */
static void
test_constant(void **state)
{
	(void)state;
	double answer[N], sample[ROWS * N] = {0};
	for (uint32_t d = 0; d < N; d++)
		answer[d] = 2;
	assert_true(advise_variance_share_removed(answer, sample, ROWS) == 0);
	for (uint32_t d = 0; d < N; d++)
		answer[d] = normal(d);
	assert_true(advise_variance_share_removed(answer, sample, ROWS) == 0);
	for (uint32_t d = 0; d < N; d++)
		sample[d] = answer[d];
	assert_true(
	    advise_variance_share_removed(answer, sample, ROWS) > 0.999);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_share),
	    cmocka_unit_test(test_noise),
	    cmocka_unit_test(test_constant),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
