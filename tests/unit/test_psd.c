/* Sieve curves read both ways, their rules, and the exp and log they stand on.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>

#include "made.h"

#include "core/numeric/elementary.h"

static double SIZES[] = {22.4e-3, 16e-3, 11.2e-3, 8e-3, 4e-3, 1e-3, 63e-6};
static double PASSINGS[] = {1, 1, 0.9, 0.6, 0.3, 0.3, 0.05};
static const struct psd CURVE = {7, SIZES, PASSINGS};

static void
passing_is_read_straight_on_log_size(void **state)
{
	(void)state;
	for (size_t i = 0; i < CURVE.n; i++)
		assert_true(psd_passing(&CURVE, SIZES[i]) == PASSINGS[i]);
	for (size_t i = 0; i + 1 < CURVE.n; i++)
		for (double t = 0.1; t < 1; t += 0.2) {
			double x = SIZES[i] * pow(SIZES[i + 1] / SIZES[i], t);
			double want =
			    PASSINGS[i] + t * (PASSINGS[i + 1] - PASSINGS[i]);
			expect_near(
			    "passing", psd_passing(&CURVE, x), want, 1e-14);
		}
}

/* Between 4 and 1 mm lies nothing, between 1 and 0.063 mm a quarter. */
static void
the_widest_gap_counts_where_mass_lies_in_it(void **state)
{
	(void)state;
	assert_int_equal(psd_sieve_above_widest_gap(&CURVE), 5);
	struct psd upper = {6, SIZES, PASSINGS};
	assert_int_equal(psd_sieve_above_widest_gap(&upper), 6);
	double size[] = {5, 2, 0.7}, passing[] = {1, 0.9, 0.5};
	struct psd gaps = {2, size, passing};
	assert_int_equal(psd_sieve_above_widest_gap(&gaps), 2);
	gaps.n = 3;
	assert_int_equal(psd_sieve_above_widest_gap(&gaps), 1);
}

/* A power law at sieves two octaves apart: between them the curve comes closer
 * than the straight line by far, and it keeps what was measured. */
static void
a_curve_is_smooth_where_sieves_lie_far_apart(void **state)
{
	(void)state;
	double size[] = {32e-3, 16e-3, 4e-3, 1e-3, 0.7e-3}, passing[5];
	struct psd psd = {5, size, passing};
	for (size_t i = 0; i < 5; i++)
		passing[i] = sqrt(size[i] / size[0]);
	struct psd curve = psd_add_points_on_cubic(&psd);
	double worst = 0, straight = 0;
	assert_int_equal(curve.n, 1 + 2 + 4 + 4 + 1);
	for (size_t i = 0; i < 5; i++)
		assert_true(
		    psd_passing_at_sieve(&curve, size[i]) == passing[i]);
	for (size_t i = 0; i < curve.n; i++) {
		double x = curve.size[i], want = sqrt(x / size[0]);
		assert_true(
		    i == 0 || (x < curve.size[i - 1] &&
				  curve.passing[i] <= curve.passing[i - 1]));
		worst = fmax(worst, fabs(curve.passing[i] - want));
		straight = fmax(straight, fabs(psd_passing(&psd, x) - want));
	}
	assert_true(straight > 0.03 && worst < 0.008);
	psd_free(&curve);
	psd.n = 2;
	curve = psd_add_points_on_cubic(&psd);
	assert_true(psd_is_same(&psd, &curve));
	psd_free(&curve);
	struct psd upper = {4, SIZES, PASSINGS};
	curve = psd_add_points_on_cubic(&upper);
	assert_true(psd_is_same(&upper, &curve));
	psd_free(&curve);
}

static void
outside_the_sieves_the_end_values_hold(void **state)
{
	(void)state;
	assert_true(psd_passing(&CURVE, 1) == 1);
	assert_true(psd_passing(&CURVE, 1e-9) == 0.05);
	double size = 4e-3, passing = 0.6;
	struct psd one = {1, &size, &passing};
	assert_true(psd_passing(&one, 1e-3) == 0.6);
	assert_true(psd_passing(&one, 4e-3) == 0.6);
	assert_true(psd_passing(&one, 9e-3) == 0.6);
}

static void
sizes_are_read_straight_on_log_size(void **state)
{
	(void)state;
	expect_near("P90", psd_size_at_passing(&CURVE, 0.9), 11.2e-3, 1e-17);
	expect_near("P75", psd_size_at_passing(&CURVE, 0.75),
	    sqrt(11.2 * 8) / 1e3, 1e-16);
	expect_near("P60", psd_size_at_passing(&CURVE, 0.6), 8e-3, 1e-17);
	expect_near("P5", psd_size_at_passing(&CURVE, 0.05), 63e-6, 1e-18);
	assert_true(
	    psd_passing(&CURVE, psd_size_at_passing(&CURVE, 0.3)) == 0.3);
	assert_true(psd_passing(&CURVE, psd_size_at_passing(&CURVE, 1)) == 1);
}

static void
sizes_outside_the_sieves_are_not_known(void **state)
{
	(void)state;
	assert_true(isnan(psd_size_at_passing(&CURVE, 0.049)));
	assert_true(isnan(psd_size_at_passing(&CURVE, 1.001)));
	struct psd coarse = {3, SIZES + 2, PASSINGS + 2},
		   none = {0, NULL, NULL};
	assert_true(isnan(psd_size_at_passing(&coarse, 0.901)));
	expect_near("P90", psd_size_at_passing(&coarse, 0.9), 11.2e-3, 1e-16);
	assert_true(isnan(psd_size_at_passing(&none, 0.5)));
}

/* A single sieve knows one size: its own. */
static void
one_sieve_knows_its_own_size(void **state)
{
	(void)state;
	double size = 4e-3, passing = 0.6;
	struct psd one = {1, &size, &passing};
	assert_true(isnan(psd_size_at_passing(&one, 0.5)));
	assert_true(isnan(psd_size_at_passing(&one, 0.7)));
	assert_true(psd_size_at_passing(&one, 0.6) == 4e-3);
}

static void
passing_to_size_to_passing_comes_back(void **state)
{
	(void)state;
	struct draw draw = draw_start(11);
	for (int k = 0; k < 300; k++) {
		struct psd psd = made_any_feed(&draw);
		for (int i = 0; i < 20; i++) {
			double p = draw_between(&draw, 0, 1);
			double x = psd_size_at_passing(&psd, p);
			if (p < psd.passing[psd.n - 1])
				assert_true(isnan(x));
			else
				expect_near(
				    "passing", psd_passing(&psd, x), p, 1e-13);
		}
		psd_free(&psd);
	}
}

static void
passing_never_rises_towards_finer_sizes(void **state)
{
	(void)state;
	struct draw draw = draw_start(12);
	for (int k = 0; k < 100; k++) {
		struct psd psd = made_any_feed(&draw);
		double before = 1;
		for (double x = 70e-3; x > 1e-6; x /= 1.01) {
			double p = psd_passing(&psd, x);
			assert_true(p <= before && p >= 0);
			before = p;
		}
		psd_free(&psd);
	}
}

static void
a_feed_covers_its_sieves_and_what_passes_nothing(void **state)
{
	(void)state;
	double passing[] = {1, 1, 0.9, 0.6, 0.3, 0.3, 0};
	struct psd ends_at_0 = {7, SIZES, passing}, none = {0, NULL, NULL};
	assert_true(psd_covers_size(&CURVE, 1));
	assert_true(psd_covers_size(&CURVE, 2e-3));
	assert_true(psd_covers_size(&CURVE, 63e-6));
	assert_false(psd_covers_size(&CURVE, 62e-6));
	assert_true(psd_covers_size(&ends_at_0, 62e-6));
	assert_true(psd_covers_size(&ends_at_0, 1e-9));
	assert_false(psd_covers_size(&none, 1e-3));
}

static void
a_copy_is_a_curve_of_its_own(void **state)
{
	(void)state;
	struct psd copy = psd_copy(&CURVE);
	assert_int_equal(copy.n, CURVE.n);
	assert_memory_equal(copy.size, SIZES, sizeof SIZES);
	assert_memory_equal(copy.passing, PASSINGS, sizeof PASSINGS);
	copy.size[0] = 1;
	assert_true(SIZES[0] == 22.4e-3);
	psd_free(&copy);
	assert_null(copy.size);
	struct psd none = {0, NULL, NULL};
	copy = psd_copy(&none);
	assert_int_equal(copy.n, 0);
	psd_free(&copy);
}

static void
rms_and_the_worst_sieve(void **state)
{
	(void)state;
	const double a[] = {1, 0.5, 0.2, 0.1}, b[] = {1, 0.4, 0.4, 0.1};
	size_t worst = 99;
	expect_near(
	    "rms", psd_rms_difference(a, b, 4, &worst), sqrt(0.05 / 4), 1e-16);
	assert_int_equal(worst, 2);
	expect_near(
	    "rms", psd_rms_difference(a, b, 2, NULL), sqrt(0.01 / 2), 1e-16);
	assert_true(isnan(psd_rms_difference(a, b, 0, NULL)));
}

/* Largest error relative to the C library's value, in units of 2^-52 of it. */
static double
ulps(double got, double want)
{
	return fabs(got - want) / (fabs(want) * DBL_EPSILON);
}

static void
exp_is_within_2_ulp(void **state)
{
	(void)state;
	struct draw draw = draw_start(13);
	for (int i = 0; i < 60000; i++) {
		double reach = i % 3 == 0 ? 708 : i % 3 == 1 ? 40 : 1;
		double x = draw_between(&draw, -reach, reach);
		if (ulps(el_exp(x), exp(x)) > 2)
			fail_msg("exp(%.17g) = %.17g", x, el_exp(x));
	}
	assert_true(el_exp(0) == 1);
	assert_true(el_exp(-1e9) == el_exp(-708));
	assert_true(el_exp(1e9) == el_exp(708));
	assert_true(el_exp(-INFINITY) > 0 && el_exp(INFINITY) < INFINITY);
	assert_true(1 - el_exp(-38) == 1);
}

static void
expm1_keeps_its_digits_near_0(void **state)
{
	(void)state;
	struct draw draw = draw_start(14);
	for (int i = 0; i < 60000; i++) {
		double x = draw_log(&draw, 1e-300, 700);
		x = i % 2 == 0 ? x : -x;
		if (ulps(el_expm1(x), expm1(x)) > 2e-15 / DBL_EPSILON)
			fail_msg("expm1(%.17g) = %.17g", x, el_expm1(x));
	}
	assert_true(el_expm1(0) == 0);
	assert_true(el_expm1(1e-20) == 1e-20);
	assert_true(el_expm1(-1e-20) == -1e-20);
	assert_true(el_expm1(-700) == -1);
}

static void
log_is_within_2e_15(void **state)
{
	(void)state;
	struct draw draw = draw_start(15);
	for (int i = 0; i < 60000; i++) {
		double x = i % 2 == 0 ? draw_log(&draw, DBL_MIN, DBL_MAX)
				      : draw_between(&draw, 0.5, 2);
		if (i % 4 == 1) /* towards 1, where ln is small */
			x = 1 + (x - 1) * draw_log(&draw, 1e-15, 1);
		if (x != 1 &&
		    !(fabs(el_log(x) - log(x)) <= 2e-15 * fabs(log(x))))
			fail_msg("log(%.17g) = %.17g", x, el_log(x));
	}
	assert_true(el_log(1) == 0);
	assert_true(el_log(DBL_MIN) < -708 && el_log(DBL_MAX) < 710);
}

static void
powers_agree_with_the_c_library(void **state)
{
	(void)state;
	struct draw draw = draw_start(16);
	for (int i = 0; i < 20000; i++) {
		double x = draw_log(&draw, 1e-6, 0.1);
		double a = draw_between(&draw, 0, 1);
		double want = pow(x, a);
		expect_near("pow", el_pow(x, a), want, 1e-14 * want);
	}
	assert_true(el_pow(0.01, 0) == 1);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(passing_is_read_straight_on_log_size),
	    cmocka_unit_test(outside_the_sieves_the_end_values_hold),
	    cmocka_unit_test(a_curve_is_smooth_where_sieves_lie_far_apart),
	    cmocka_unit_test(sizes_are_read_straight_on_log_size),
	    cmocka_unit_test(sizes_outside_the_sieves_are_not_known),
	    cmocka_unit_test(one_sieve_knows_its_own_size),
	    cmocka_unit_test(passing_to_size_to_passing_comes_back),
	    cmocka_unit_test(passing_never_rises_towards_finer_sizes),
	    cmocka_unit_test(a_feed_covers_its_sieves_and_what_passes_nothing),
	    cmocka_unit_test(a_copy_is_a_curve_of_its_own),
	    cmocka_unit_test(rms_and_the_worst_sieve),
	    cmocka_unit_test(exp_is_within_2_ulp),
	    cmocka_unit_test(expm1_keeps_its_digits_near_0),
	    cmocka_unit_test(the_widest_gap_counts_where_mass_lies_in_it),
	    cmocka_unit_test(log_is_within_2e_15),
	    cmocka_unit_test(powers_agree_with_the_c_library),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
