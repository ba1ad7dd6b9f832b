/* Cells that stand out: swapped digits are found, sound curves are left alone.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/psd.h"

#include <stdlib.h>

#include "made.h"

enum { RUNS = 3 };

static struct psd_outlier
outlier_of(const struct site *site)
{
	const struct psd *curve[RUNS];
	for (size_t r = 0; r < RUNS; r++)
		curve[r] = &site->run[r].product;
	return psd_find_outlier(curve, RUNS);
}

static void
a_straight_line_does_not_bend(void **state)
{
	(void)state;
	double size[4] = {8, 4, 2, 1}, passing[4] = {0.9, 0.6, 0.3, 0};
	struct psd line = {4, size, passing};
	expect_near("line", psd_deviation_from_chord(&line, 1), 0, 1e-12);
	passing[2] = 0.4;
	expect_near("bend", psd_deviation_from_chord(&line, 2), 0.1, 1e-12);
	expect_near("bend", psd_deviation_from_chord(&line, 1), -0.05, 1e-12);
	assert_true(isnan(psd_deviation_from_chord(&line, 0)));
	assert_true(isnan(psd_deviation_from_chord(&line, 3)));
	const struct psd *alone = &line;
	struct psd_outlier o = psd_find_outlier(&alone, 1);
	assert_true(o.sieve == 2 && o.others == 0);
	expect_near("off", o.off, 0.1, 1e-12);
	line.n = 2;
	assert_true(psd_find_outlier(&alone, 1).off == 0);
}

static void
sound_sites_are_left_alone(void **state)
{
	(void)state;
	for (size_t row = 0; row < 19; row++)
		for (uint64_t seed = 1; seed <= 20; seed++) {
			struct site *site =
			    made_site(&TABLE_3[row], 0.005, seed);
			assert_true(fabs(outlier_of(site).off) < 0.1);
			site_free(site);
		}
}

/* The number with its two digits before the point swapped: 74.5 is 47.5. */
static double
swapped(double passing)
{
	double pct = 100 * passing, whole = floor(pct);
	double tens = floor(whole / 10), ones = whole - 10 * tens;
	return (10 * ones + tens + (pct - whole)) / 100;
}

/* Wherever the swap leaves the order of the passings as it was and is off by 27
 * points or more, the very cell is named. */
static void
swapped_digits_are_found(void **state)
{
	(void)state;
	size_t tried = 0;
	for (size_t row = 0; row < 19; row++) {
		struct site *site = made_site(&TABLE_3[row], 0.005, 9);
		for (size_t r = 0; r < RUNS; r++) {
			struct psd *p = &site->run[r].product;
			for (size_t i = 1; i + 1 < p->n; i++) {
				double was = p->passing[i];
				double now = swapped(was);
				if (was < 0.1 || fabs(now - was) < 0.26 ||
				    now > p->passing[i - 1] ||
				    now < p->passing[i + 1])
					continue;
				p->passing[i] = now;
				struct psd_outlier o = outlier_of(site);
				assert_int_equal(o.curve, r);
				assert_int_equal(o.sieve, i);
				assert_true(fabs(o.off) > 0.14);
				p->passing[i] = was;
				tried++;
			}
		}
		site_free(site);
	}
	assert_true(tried > 5);
}

/* Runs on other sieves say nothing of each other. */
static void
only_the_same_sieves_are_compared(void **state)
{
	(void)state;
	double a[4] = {8, 4, 2, 1}, b[4] = {8, 5, 2, 1};
	double p[4] = {0.9, 0.6, 0.5, 0}, q[4] = {0.9, 0.8, 0.3, 0};
	struct psd one = {4, a, p}, two = {4, b, q};
	const struct psd *curve[2] = {&one, &two};
	assert_int_equal(psd_find_outlier(curve, 2).others, 0);
	two.size = a;
	assert_int_equal(psd_find_outlier(curve, 2).others, 1);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_straight_line_does_not_bend),
	    cmocka_unit_test(sound_sites_are_left_alone),
	    cmocka_unit_test(swapped_digits_are_found),
	    cmocka_unit_test(only_the_same_sieves_are_compared),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
