/* What tells models apart: the criterion, the error of runs held out, and that
 * a larger model begun at a smaller one ends where a search of its own does.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "fitted.h"

#include "core/model/breakage.h"
#include "core/posterior/discrepancy.h"
#include "core/check/league.h"

/* 12 ln(0.48 / 12) + 8 + 40 / 7, with the variance as the fourth parameter. */
static void
aicc_is_that_of_the_book(void **state)
{
	(void)state;
	double want = 12 * log(0.04) + 8 + 40.0 / 7;
	expect_near("AICc", league_aicc(0.48, 12, 3), want, 1e-12);
	assert_true(isnan(league_aicc(0.48, 5, 3)));
	assert_true(isfinite(league_aicc(0.48, 6, 3)));
	assert_true(isnan(league_aicc(0, 12, 3)));
}

/* Two runs of unlike length count alike. */
static void
rmse_is_the_mean_of_runs(void **state)
{
	(void)state;
	struct league_cell cell[] = {{0, -5, 0.5, 0.01}, {0, -6, 0.4, 0.01},
	    {0, -7, 0.3, 0.01}, {1, -5, 0.5, 0.01}};
	double p[] = {0.52, 0.42, 0.32, 0.54};
	expect_near(
	    "RMSE", league_rmse_over_runs(cell, 4, p), sqrt(0.001), 1e-12);
	p[1] = NAN;
	assert_true(isnan(league_rmse_over_runs(cell, 4, p)));
	assert_true(isnan(league_rmse_over_runs(cell, 0, p)));
}

/* The standard error of the difference is what made-up errors give it: shared
 * along each run's curve, and independent. */
static void
the_error_of_a_difference_is_that_of_made_up_samples(void **state)
{
	(void)state;
	enum { N = 20, TIMES = 4000 };
	struct league_cell cell[N];
	double a[N], b[N], sum = 0, squares = 0;
	const double i2 = HYPER[HYPER_OWN].median * HYPER[HYPER_OWN].median;
	const double s2 =
	    HYPER[HYPER_SHARED].median * HYPER[HYPER_SHARED].median;
	const double own = i2 / (i2 + s2);
	for (size_t i = 0; i < N; i++) {
		/* So near each other that the shared part is one number. */
		cell[i] = (struct league_cell){
		    i / 10, -5 - 1e-3 * (double)(i % 10), 0.5, 0.01};
		a[i] = 0.5 + 0.01 * (double)(i % 3);
		b[i] = 0.5;
	}
	struct league_difference want = league_error_difference(cell, N, a, b);
	for (size_t t = 0; t < TIMES; t++) {
		struct rng_key key = rng_make_key(5, t, 1);
		for (size_t i = 0; i < N; i++)
			cell[i].measured =
			    0.5 +
			    0.01 * sqrt(own) * rng_normal(key, (uint32_t)i) +
			    0.01 * sqrt(1 - own) *
				rng_normal(key, (uint32_t)(N + i / 10));
		double d = league_error_difference(cell, N, a, b).difference;
		sum += d / TIMES;
		squares += d * d / TIMES;
	}
	expect_near("mean", sum, want.difference, 0.05 * want.error);
	expect_near("error", sqrt(squares - sum * sum) / want.error, 1, 0.04);
}

/* A model that errs by 3 points misses runs whose samples err by 1 point, not
 * by 2; by 6 points it misses whatever the misfit says of the samples. */
static void
a_model_misses_what_no_sampling_explains(void **state)
{
	(void)state;
	for (double noise = 0.01; noise < 0.1; noise *= 2) {
		struct league_cell cell[] = {
		    {0, -5, 0.5, noise}, {0, -6, 0.4, noise}};
		double far[] = {0.56, 0.34}, some[] = {0.53, 0.37};
		double near[] = {0.515, 0.385};
		assert_true(league_is_prediction_poor(cell, 2, far));
		assert_true(league_is_prediction_poor(cell, 2, some) ==
			    (noise < 0.015));
		assert_false(league_is_prediction_poor(cell, 2, near));
		assert_false(league_is_prediction_poor(cell, 0, far));
	}
}

static struct league_model
entrant(size_t model, double aicc, double rmse)
{
	return (struct league_model){
	    .model = model, .aicc = aicc, .rmse = rmse};
}

/* Of models that differ by AICc alone. */
static void
extensions_of_the_best_are_no_rivals(void **state)
{
	(void)state;
	size_t grunditz = 0, energy = 1, vogel = 2;
	struct league_model m[] = {entrant(grunditz, -200, NAN),
	    entrant(energy, -195, NAN), entrant(vogel, -180, NAN)};
	assert_true(league_rule_out_models(m, 3, NULL, 0));
	assert_int_equal(m[0].standing, LEAGUE_BEST);
	assert_int_equal(m[1].standing, LEAGUE_POSSIBLE);
	assert_int_equal(m[2].standing, LEAGUE_OUT_AICC);
	m[2].aicc = -191;
	assert_false(league_rule_out_models(m, 3, NULL, 0));
	/* The larger is better, but not by enough: still one law. */
	m[1].aicc = -205;
	m[2].aicc = -180;
	assert_true(league_rule_out_models(m, 3, NULL, 0));
	assert_int_equal(m[1].standing, LEAGUE_BEST);
	/* None has one: nothing is told. */
	m[0].aicc = m[1].aicc = m[2].aicc = NAN;
	assert_false(league_rule_out_models(m, 3, NULL, 0));
}

/* The runs held out overrule AICc, and where both are certain and disagree
 * nothing is told. */
static void
runs_held_out_count_more(void **state)
{
	(void)state;
	enum { N = 12 };
	struct league_cell cell[N];
	double good[N], bad[N];
	for (size_t i = 0; i < N; i++) {
		cell[i] =
		    (struct league_cell){0, -4 - 0.5 * (double)i, 0.5, 0.003};
		good[i] = 0.501;
		bad[i] = 0.53;
	}
	struct league_model m[] = {
	    entrant(0, -200, 0.03), entrant(2, -205, 0.001)};
	m[0].predicted = bad;
	m[1].predicted = good;
	assert_true(league_rule_out_models(m, 2, cell, N));
	assert_int_equal(m[0].standing, LEAGUE_OUT_ERROR);
	m[0].aicc = -220;
	assert_false(league_rule_out_models(m, 2, cell, N));
	assert_int_equal(m[0].standing, LEAGUE_OUT_ERROR);
	assert_int_equal(m[1].standing, LEAGUE_BEST);
	/* Alike to 0.1 points, and AICc decides. */
	m[0].rmse = m[1].rmse + 0.0009;
	m[0].predicted = good;
	league_rule_out_models(m, 2, cell, N);
	assert_int_equal(m[0].standing, LEAGUE_BEST);
	assert_true(league_is_error_clearly_larger(cell, N, bad, good));
	assert_false(league_is_error_clearly_larger(cell, N, good, bad));
	for (size_t i = 0; i < N; i++)
		cell[i].noise = 0.1;
	assert_false(league_is_error_clearly_larger(cell, N, bad, good));
}

static void
models_extend_each_other(void **state)
{
	(void)state;
	assert_true(breakage_is_extension_of(1, 0));
	assert_true(
	    breakage_is_extension_of(4, 3) && breakage_is_extension_of(4, 1));
	assert_false(breakage_is_extension_of(0, 1));
	assert_false(breakage_is_extension_of(0, 0));
	assert_false(breakage_is_extension_of(2, 0));
	struct params p = made_params(&TABLE_3[TIERP]);
	struct params q = breakage_params_in_wider_model(&p, 4);
	assert_true(params_value_by_name(&q, "alpha") == p.alpha);
	assert_true(params_value_by_name(&q, "gamma") == 0);
	assert_true(params_value_by_name(&q, "bypass") == 0);
}

static void
what_changes_nothing_is_left_out(void **state)
{
	(void)state;
	struct params p = made_params(&TABLE_3[TIERP]);
	struct params wide = breakage_params_in_wider_model(
	    &p, breakage_find_by_name("grunditz-t10"));
	wide.at[breakage_parameter_index(
	    breakage_model_of_params(&wide), "e_ref")] = 2700;
	struct params q = breakage_params_in_narrower_model(&wide);
	assert_int_equal(q.breakage, p.breakage);
	assert_memory_equal(
	    q.at, p.at, breakage_model_of_params(&p)->n * sizeof *q.at);
	wide.at[breakage_parameter_index(
	    breakage_model_of_params(&wide), "gamma")] = 0.1;
	q = breakage_params_in_narrower_model(&wide);
	assert_int_equal(q.breakage, breakage_find_by_name("grunditz-energy"));
	assert_true(params_value_by_name(&q, "gamma") == 0.1);
	assert_true(params_value_by_name(&q, "e_ref") == 2700);
	wide.at[breakage_parameter_index(
	    breakage_model_of_params(&wide), "kappa")] = 0.1;
	assert_int_equal(
	    breakage_params_in_narrower_model(&wide).breakage, wide.breakage);
}

static struct fit
calibrated(const struct site *site, size_t model, const struct params *start)
{
	struct calibrate_options o = calibrate_options_default();
	o.population = 4000;
	o.settings.breakage = (unsigned)model;
	o.bounds = bounds_default(model);
	o.start = start;
	return fitted(site, &o);
}

static void
a_start_ends_where_a_search_does(void **state)
{
	(void)state;
	for (size_t row = 1; row < 3; row++) {
		struct site *site = made_site(&TABLE_3[row], 0.005, 3);
		struct fit small = calibrated(site, 0, NULL);
		for (size_t model = 1; model < 5; model += 2) {
			struct fit from =
			    calibrated(site, model, &small.params);
			struct fit own = calibrated(site, model, NULL);
			assert_true(from.misfit <= small.misfit);
			expect_near(
			    "misfit", from.misfit / own.misfit, 1, 1e-6);
		}
		site_free(site);
	}
}

/* The free scale of beta is no parameter, unless a bound holds it. */
static void
the_scale_of_beta_does_not_count(void **state)
{
	(void)state;
	struct fit fit = {.parameters = 7};
	struct bounds b = bounds_default(0);
	assert_int_equal(league_count_fitted_params(&fit, &b), 6);
	b.lower[2] = b.upper[2] = 1;
	fit.parameters = 6;
	assert_int_equal(league_count_fitted_params(&fit, &b), 6);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(aicc_is_that_of_the_book),
	    cmocka_unit_test(rmse_is_the_mean_of_runs),
	    cmocka_unit_test(a_model_misses_what_no_sampling_explains),
	    cmocka_unit_test(
		the_error_of_a_difference_is_that_of_made_up_samples),
	    cmocka_unit_test(extensions_of_the_best_are_no_rivals),
	    cmocka_unit_test(runs_held_out_count_more),
	    cmocka_unit_test(models_extend_each_other),
	    cmocka_unit_test(what_changes_nothing_is_left_out),
	    cmocka_unit_test(a_start_ends_where_a_search_does),
	    cmocka_unit_test(the_scale_of_beta_does_not_count)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
