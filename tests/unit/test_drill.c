/* The hidden plant of a drill.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "made.h"

#include <stdbool.h>
#include <stdlib.h>

#include "core/check/drill.h"

/* Of any seed: there are speeds that meet both conditions, and just beyond them
 * one is not met. */
static void
every_drill_can_be_won(void **state)
{
	(void)state;
	for (uint64_t seed = 0; seed < 40; seed++) {
		struct drill_plant p = drill_plant(seed, seed % 2);
		double least = p.hard ? 1.5 : 3, P[2];
		const double size[2] = {
		    p.condition[0].size, p.condition[1].size};
		assert_true(p.fastest - p.slowest > least);
		assert_true(p.slowest > DRILL_SLOWEST + 1);
		assert_true(p.fastest < DRILL_FASTEST - 1);
		for (double v = 60; v <= 90; v += 0.5) {
			drill_truth(&p, v, size, 2, P);
			bool met = P[0] >= p.condition[0].passing &&
				   P[1] <= p.condition[1].passing;
			if (fabs(drill_margin(&p, v)) > 1e-6)
				assert_true(met == (drill_margin(&p, v) > 0));
		}
	}
}

static void
samples_err_about_the_truth(void **state)
{
	(void)state;
	enum { MANY = 60 };
	struct drill_plant p = drill_plant(3, true);
	struct site *feed = drill_feed(&p);
	assert_true(feed->n_run == 1 && feed->run[0].product.n == 0);
	assert_true(feed->run[0].speed == 0);
	double truth, size = 2e-3, mean = 0, square = 0;
	drill_truth(&p, 71, &size, 1, &truth);
	for (size_t n = 0; n < MANY; n++) {
		struct site *a = drill_sample(&p, 71, n);
		struct site *b = drill_sample(&p, 71, n);
		double off = psd_at_sieve(&a->run[0].product, size) - truth;
		assert_memory_equal(a->run[0].product.passing,
		    b->run[0].product.passing,
		    a->run[0].product.n * sizeof(double));
		mean += off / MANY;
		square += off * off / MANY;
		site_free(a);
		site_free(b);
	}
	double sd = 2 * p.made.noise * sqrt(truth * (1 - truth));
	expect_near("mean", mean, 0, 3 * sd / sqrt(MANY));
	expect_near("sd", sqrt(square), sd, 0.3 * sd);
	site_free(feed);
}

static void
seeds_make_other_plants(void **state)
{
	(void)state;
	struct drill_plant a = drill_plant(1, false), b = drill_plant(2, false);
	struct drill_plant again = drill_plant(1, false);
	assert_true(a.slowest == again.slowest && a.fastest == again.fastest);
	assert_true(a.made.params.f_mat != b.made.params.f_mat);
	assert_true(drill_plant(1, true).made.params.breakage == 1);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(every_drill_can_be_won),
	    cmocka_unit_test(samples_err_about_the_truth),
	    cmocka_unit_test(seeds_make_other_plants)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
