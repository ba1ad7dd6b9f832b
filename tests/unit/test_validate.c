/* What stands beside a calibration: made-up sites, their digest, predictions,
 * and the comparison with runs held out.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "made.h"
#include "naive.h"
#include "rules.h"

#include "core/model/breakage.h"
#include "core/model/selection.h"
#include "core/search/misfit.h"
#include "core/answer/predict.h"
#include "core/check/validate.h"

static void
made_up_runs_are_the_models_products(void **state)
{
	(void)state;
	for (size_t row = 0; row < ARRAY_LEN(TABLE_3); row++) {
		struct params p = made_params(&TABLE_3[row]);
		struct site *site = made_site(&TABLE_3[row], 0, row);
		double exact[20];
		assert_int_equal(site->n_run, 3);
		for (size_t r = 0; r < 3; r++) {
			const struct run *run = &site->run[r];
			assert_true(run->speed == 69 + 5 * (double)r);
			made_product(run, &p, exact);
			for (size_t i = 0; i < run->product.n; i++)
				expect_near("product", run->product.passing[i],
				    exact[i], 0.50001e-4);
			assert_true(keeps_rules(&run->feed));
		}
		site_free(site);
	}
}

static void
made_up_feeds_have_the_form_stated(void **state)
{
	(void)state;
	struct site *one = made_site(&TABLE_3[1], 0, 1);
	const struct psd *feed = &one->run[0].feed;
	expect_near("coarsest", feed->size[0], 22.4e-3, 1e-12);
	assert_true(feed->passing[0] == 1);
	expect_near("top", psd_passing(feed, 11.2e-3), 0.9, 1e-12);
	expect_near("5.6 mm", psd_passing(feed, 5.6e-3), 0.45, 1e-12);
	expect_near("0.063 mm", feed->size[feed->n - 1], 63e-6, 1e-12);
	for (size_t r = 1; r < 3; r++)
		assert_memory_equal(one->run[r].feed.passing, feed->passing,
		    feed->n * sizeof *feed->passing);
	assert_false(one->individual_feeds);
	struct site *each = made_site(&TABLE_3[TIERP], 0, 1);
	assert_true(each->individual_feeds);
	assert_true(
	    each->run[0].feed.passing[4] != each->run[1].feed.passing[4]);
	site_free(one);
	site_free(each);
}

/* 2 noise sqrt(P (1 - P)), over many seeds; P around 0.5. */
static void
made_up_noise_has_the_deviation_asked_for(void **state)
{
	(void)state;
	enum { SEEDS = 300 };
	struct site *exact = made_site(&TABLE_3[1], 0, 1);
	const struct psd *product = &exact->run[1].product;
	size_t i = 0;
	while (product->passing[i] > 0.6)
		i++;
	double p = product->passing[i], sum = 0, squares = 0;
	for (uint64_t seed = 1; seed <= SEEDS; seed++) {
		struct site *site = made_site(&TABLE_3[1], 0.005, seed);
		const struct psd *noisy = &site->run[1].product;
		double d = noisy->passing[i] - p;
		sum += d;
		squares += d * d;
		assert_true(keeps_rules(noisy));
		site_free(site);
	}
	double sd = 2 * 0.005 * sqrt(p * (1 - p));
	expect_near("mean", sum / SEEDS, 0, 4 * sd / sqrt(SEEDS));
	expect_near("deviation", sqrt(squares / SEEDS), sd, 0.17 * sd);
	site_free(exact);
}

static void
made_up_noise_keeps_the_rules_of_a_curve(void **state)
{
	(void)state;
	for (uint64_t seed = 1; seed <= 40; seed++) {
		struct site *site = made_site(&TABLE_3[seed % 19], 0.08, seed);
		for (size_t r = 0; r < 3; r++) {
			const struct psd *product = &site->run[r].product;
			assert_true(keeps_rules(product));
		}
		site_free(site);
	}
}

static void
twins_have_the_same_digest(void **state)
{
	(void)state;
	struct site *ubbarp = made_site(&TABLE_3[0], 0.005, 3);
	struct site *gasgruvan = made_site(&TABLE_3[18], 0.005, 3);
	struct site *other = made_site(&TABLE_3[0], 0.005, 4);
	free(ubbarp->name);
	ubbarp->name = xstrdup("Ubbarp");
	assert_true(ubbarp->digest == gasgruvan->digest);
	assert_true(ubbarp->digest == site_digest(ubbarp));
	assert_true(ubbarp->digest != other->digest);
	site_free(ubbarp);
	site_free(gasgruvan);
	site_free(other);
}

static void
any_number_changes_the_digest(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 3);
	struct run *run = &site->run[1];
	run->product_sd = xcalloc_doubles(run->product.n);
	double *numbers[] = {&run->speed, &run->feed.size[3],
	    &run->feed.passing[5], &run->product.size[2],
	    &run->product.passing[4], &run->product_sd[1]};
	uint64_t before = site_digest(site);
	for (size_t i = 0; i < ARRAY_LEN(numbers); i++) {
		double was = *numbers[i];
		*numbers[i] = was + 1e-9;
		assert_true(site_digest(site) != before);
		*numbers[i] = was;
		assert_true(site_digest(site) == before);
	}
	run->product.n--;
	assert_true(site_digest(site) != before);
	site_free(site);
}

static void
runs_are_found_by_speed(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 3);
	assert_int_equal(site_run_at_speed(site, 74), 1);
	assert_int_equal(site_run_at_speed(site, 74.0005), 1);
	assert_int_equal(site_run_at_speed(site, 74.1), 3);
	site_free(site);
}

/* One run has a product on other sieves than the rest. */
static void
a_prediction_is_on_all_sieves_the_feed_covers(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 3);
	struct params p = made_params(&TABLE_3[TIERP]);
	struct psd *product = &site->run[2].product;
	product->size[3] = 6.3e-3;
	product->size[product->n - 1] = 45e-6;
	struct prediction a =
	    predict_with_model_alone(site, &p, model_settings_default(), 77, 1);
	assert_int_equal(a.product.n, site->run[1].feed.n + 1);
	assert_true(keeps_rules(&a.product));
	assert_true(keeps_rules(&a.feed));
	double exact[20], x = selection_break_size_at_energy(
			      &p, specific_energy_at_speed(77));
	naive_continuous(&site->run[1].feed, a.product.size, a.product.n, &p,
	    77, 20000, exact);
	for (size_t i = 0; i < a.product.n; i++) {
		expect_near("product", a.product.passing[i], exact[i], 2e-6);
		expect_near("feed", a.feed.passing[i],
		    naive_passing(&site->run[1].feed, a.product.size[i]),
		    1e-14);
	}
	/* The size is read straight between the sheet's sieves (D20). */
	expect_near("P50", a.p50, psd_size_at_passing(&a.product, 0.5), 1e-15);
	assert_true(a.p20 < a.p50 && a.p50 < a.p80);
	assert_true(a.break_size == x && a.energy == 77 * 77 / 2.0);
	assert_true(a.selected > 0.2);
	assert_true(a.selected < 1 - psd_passing(&site->run[1].feed, x));
	assert_false(a.no_daughters);
	prediction_free(&a);
	p.beta[1] = p.beta[3] = -1;
	a = predict_with_model_alone(site, &p, model_settings_default(), 77, 1);
	assert_true(a.no_daughters);
	assert_memory_equal(
	    a.product.passing, a.feed.passing, a.feed.n * sizeof(double));
	prediction_free(&a);
	site_free(site);
}

static void
speeds_outside_the_training_runs_extrapolate(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 3);
	const bool outer[3] = {true, false, true};
	const bool slow[3] = {true, true, false};
	assert_false(predict_is_extrapolation(site, outer, 74));
	assert_false(predict_is_extrapolation(site, outer, 69));
	assert_false(predict_is_extrapolation(site, outer, 79));
	assert_true(predict_is_extrapolation(site, outer, 79.1));
	assert_true(predict_is_extrapolation(site, outer, 68.9));
	assert_true(predict_is_extrapolation(site, slow, 75));
	site_free(site);
}

/* Straight in v^2 through the two runs given. */
static double
naive_between(const struct run *a, const struct run *b, double v, double x)
{
	double A = a->speed * a->speed, B = b->speed * b->speed;
	double t = (v * v - A) / (B - A);
	return (1 - t) * naive_passing(&a->product, x) +
	       t * naive_passing(&b->product, x);
}

static void
interpolation_is_straight_in_v_squared(void **state)
{
	(void)state;
	static const struct {
		bool train[3];
		double v;
		size_t a, b;
	} rows[] = {{{true, false, true}, 74, 0, 2},
	    {{true, true, true}, 71, 0, 1}, {{true, true, true}, 78, 1, 2},
	    {{true, true, true}, 74, 0, 1}, {{true, true, true}, 60, 0, 1},
	    {{true, true, true}, 85, 1, 2}, {{true, true, false}, 79, 0, 1},
	    {{false, true, true}, 69, 1, 2}, {{true, false, true}, 90, 0, 2}};
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 3);
	for (size_t i = 0; i < ARRAY_LEN(rows); i++)
		for (double x = 70e-6; x < 0.03; x *= 1.7)
			expect_near("passing",
			    validate_interpolate_passing(
				site, rows[i].train, rows[i].v, x),
			    naive_between(&site->run[rows[i].a],
				&site->run[rows[i].b], rows[i].v, x),
			    1e-13);
	const bool one[3] = {true, false, false};
	assert_true(isnan(validate_interpolate_passing(site, one, 74, 4e-3)));
	assert_true(isnan(
	    validate_interpolate_passing(site, rows[0].train, 74, 50e-6)));
	site->run[2].product.n = 0;
	assert_true(
	    isnan(validate_interpolate_passing(site, rows[0].train, 74, 4e-3)));
	site_free(site);
}

/* Tierp measured twice at 69 m/s, and at 79: the second of three runs is moved
 * to the first one's speed. */
static struct site *
site_with_repeat(void)
{
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 3);
	site->run[1].speed = site->run[0].speed;
	return site;
}

static void
repeats_train_together_and_are_averaged(void **state)
{
	(void)state;
	struct site *site = site_with_repeat();
	const struct run *run = site->run;
	const bool slow[3] = {true, true, false};
	bool train[3];
	double a = run[0].speed, b = run[2].speed, v = 72;
	assert_int_equal(misfit_mark_default_training(site, train), 3);
	assert_true(train[0] && train[1] && train[2]);
	for (double x = 70e-6; x < 0.03; x *= 1.7) {
		double mean = (psd_passing(&run[0].product, x) +
				  psd_passing(&run[1].product, x)) /
			      2;
		double t = (v * v - a * a) / (b * b - a * a);
		expect_near("passing",
		    validate_interpolate_passing(site, train, v, x),
		    mean + t * (psd_passing(&run[2].product, x) - mean), 1e-13);
		assert_true(
		    isnan(validate_interpolate_passing(site, slow, v, x)));
	}
	struct params p = made_params(&TABLE_3[TIERP]);
	double *ways = validate_predict_by_all_ways(
	    site, 2, slow, &p, model_settings_default(), NULL);
	size_t n = misfit_count_covered_sieves(&run[2]);
	for (size_t i = 0; i < n; i++)
		expect_near("nearest", ways[VALIDATE_NEAREST * n + i],
		    (psd_passing(&run[0].product, run[2].product.size[i]) +
			psd_passing(&run[1].product, run[2].product.size[i])) /
			2,
		    1e-15);
	free(ways);
	site_free(site);
}

static void
null_models_say_which_speeds_they_take(void **state)
{
	(void)state;
	static const struct {
		bool train[3];
		size_t run;
		double line[2], nearest;
		bool beyond;
	} rows[] = {{{true, false, true}, 1, {69, 79}, 69, false},
	    {{true, true, false}, 2, {69, 74}, 74, true},
	    {{false, true, true}, 0, {74, 79}, 74, true}};
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 3);
	struct params p = made_params(&TABLE_3[TIERP]);
	double out[20];
	for (size_t i = 0; i < ARRAY_LEN(rows); i++) {
		const struct run *run = &site->run[rows[i].run];
		struct validation v = validate_run(site, rows[i].run,
		    rows[i].train, &p, model_settings_default());
		assert_true(v.line[0] == rows[i].line[0] &&
			    v.line[1] == rows[i].line[1]);
		assert_true(v.nearest == rows[i].nearest);
		assert_true(validation_is_extrapolated(&v) == rows[i].beyond);
		size_t at = site_run_at_speed(site, v.nearest);
		for (size_t k = 0; k < v.n_sieve; k++)
			out[k] = naive_passing(
			    &site->run[at].product, run->product.size[k]);
		expect_near("nearest", v.rmse[VALIDATE_NEAREST],
		    psd_rms_difference(
			out, run->product.passing, v.n_sieve, NULL),
		    1e-12);
	}
	const bool one[3] = {true, false, false};
	struct validation v =
	    validate_run(site, 1, one, &p, model_settings_default());
	assert_true(isnan(v.line[1]));
	assert_true(isnan(v.rmse[VALIDATE_INTERPOLATION]));
	assert_true(isnan(v.size[VALIDATE_INTERPOLATION][1]));
	assert_true(v.nearest == 69);
	site_free(site);
}

static void
the_smallest_rmse_wins(void **state)
{
	(void)state;
	struct validation v = {.holdout = true};
	for (enum validate_way way = 0; way < VALIDATE_WAYS; way++)
		v.rmse[way] = 0.01;
	assert_int_equal(validate_way_of_least_rmse(v.rmse), VALIDATE_MODEL);
	for (enum validate_way way = VALIDATE_WAYS; way-- > 0;) {
		v.rmse[way] -= 0.001 * (double)(VALIDATE_WAYS - way);
		assert_int_equal(validate_way_of_least_rmse(v.rmse), way);
	}
	v.rmse[VALIDATE_MODEL] = 0.02;
	v.rmse[VALIDATE_CORRECTED] = v.rmse[VALIDATE_INTERPOLATION] = NAN;
	assert_int_equal(validate_way_of_least_rmse(v.rmse), VALIDATE_NEAREST);
	assert_false(validation_is_interpolation_better(&v));
}

/* Of 1, 2, 4 mm predicted 1.1, 1.8, 4: errors of 10, -10 and 0 %. */
static void
scores_are_of_relative_errors(void **state)
{
	(void)state;
	const double measured[] = {1, 2, 4, NAN, 3},
		     predicted[] = {1.1, 1.8, 4, 1, NAN};
	struct validation v[5] = {0};
	const struct validation *list[5];
	for (size_t k = 0; k < 5; k++) {
		v[k].measured[1] = measured[k];
		v[k].size[VALIDATE_FEED][1] = predicted[k];
		list[k] = &v[k];
	}
	struct validate_score s =
	    validate_score_at_size(list, 5, VALIDATE_FEED, 1);
	assert_int_equal(s.n, 3);
	expect_near("bias", s.bias, 0, 1e-15);
	expect_near("rms", s.rms, sqrt(0.02 / 3), 1e-15);
	expect_near("R2", s.r2, 1 - 0.05 / (14.0 / 3), 1e-14);
	s = validate_score_at_size(list, 1, VALIDATE_FEED, 1);
	expect_near("bias", s.bias, 0.1, 1e-15);
	assert_true(isnan(s.r2));
	s = validate_score_at_size(list, 0, VALIDATE_FEED, 1);
	assert_true(s.n == 0 && isnan(s.bias) && isnan(s.rms) && isnan(s.r2));
}

static void
validation_is_the_plain_comparison(void **state)
{
	(void)state;
	const bool train[3] = {true, false, true};
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 8);
	struct run *run = &site->run[1];
	struct params p = made_params(&TABLE_3[TIERP]);
	p.f_mat = 1.2;
	run->product.size[run->product.n - 1] = 45e-6;
	struct validation v =
	    validate_run(site, 1, train, &p, model_settings_default());
	size_t n = run->product.n - 1, worst = 0;
	double exact[20], sum = 0, feed = 0, between = 0, most = 0;
	naive_continuous(
	    &run->feed, run->product.size, n, &p, 74, 40000, exact);
	for (size_t i = 0; i < n; i++) {
		double x = run->product.size[i], m = run->product.passing[i];
		sum += (exact[i] - m) * (exact[i] - m);
		feed += pow(naive_passing(&run->feed, x) - m, 2);
		between += pow(
		    naive_between(&site->run[0], &site->run[2], 74, x) - m, 2);
		worst = fabs(exact[i] - m) > most ? i : worst;
		most = fmax(most, fabs(exact[i] - m));
	}
	assert_true(v.holdout && v.run == 1 && v.speed == 74);
	assert_int_equal(v.n_sieve, n);
	assert_int_equal(v.n_left_out, 1);
	expect_near("misfit", v.misfit, sum, 1e-6);
	expect_near(
	    "rmse", v.rmse[VALIDATE_MODEL], sqrt(sum / (double)n), 1e-6);
	expect_near(
	    "feed", v.rmse[VALIDATE_FEED], sqrt(feed / (double)n), 1e-12);
	expect_near("interpolation", v.rmse[VALIDATE_INTERPOLATION],
	    sqrt(between / (double)n), 1e-12);
	assert_true(v.worst_sieve == run->product.size[worst]);
	expect_near("worst", v.worst_difference,
	    exact[worst] - run->product.passing[worst], 1e-5);
	assert_true(validation_is_interpolation_better(&v) == (between < sum));
	v = validate_run(site, 0, train, &p, model_settings_default());
	assert_false(v.holdout || validation_is_interpolation_better(&v));
	site_free(site);
}

static void
validation_compares_p20_p50_and_p80(void **state)
{
	(void)state;
	const bool train[3] = {true, false, true};
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 8);
	struct params p = made_params(&TABLE_3[TIERP]);
	struct validation v =
	    validate_run(site, 1, train, &p, model_settings_default());
	struct psd found = psd_copy(&site->run[1].product);
	made_product(&site->run[1], &p, found.passing);
	for (size_t i = 0; i < 3; i++) {
		double passing = 0.2 + 0.3 * (double)i;
		expect_near("measured", v.measured[i],
		    psd_size_at_passing(&site->run[1].product, passing), 1e-12);
		expect_near("predicted", v.size[VALIDATE_MODEL][i],
		    psd_size_at_passing(&found, passing), 1e-12);
	}
	psd_free(&found);
	site_free(site);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(made_up_runs_are_the_models_products),
	    cmocka_unit_test(made_up_feeds_have_the_form_stated),
	    cmocka_unit_test(made_up_noise_has_the_deviation_asked_for),
	    cmocka_unit_test(made_up_noise_keeps_the_rules_of_a_curve),
	    cmocka_unit_test(twins_have_the_same_digest),
	    cmocka_unit_test(any_number_changes_the_digest),
	    cmocka_unit_test(runs_are_found_by_speed),
	    cmocka_unit_test(a_prediction_is_on_all_sieves_the_feed_covers),
	    cmocka_unit_test(speeds_outside_the_training_runs_extrapolate),
	    cmocka_unit_test(interpolation_is_straight_in_v_squared),
	    cmocka_unit_test(repeats_train_together_and_are_averaged),
	    cmocka_unit_test(null_models_say_which_speeds_they_take),
	    cmocka_unit_test(the_smallest_rmse_wins),
	    cmocka_unit_test(scores_are_of_relative_errors),
	    cmocka_unit_test(validation_is_the_plain_comparison),
	    cmocka_unit_test(validation_compares_p20_p50_and_p80),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
