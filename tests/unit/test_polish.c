/* The misfit, in the plainest way, and the polish that goes to its bottom.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "made.h"
#include "naive.h"

#include "core/search/misfit.h"
#include "core/search/polish.h"
#include "core/search/settle.h"

/* Replaces the products by the model's own, neither noisy nor rounded. */
static void
make_exact(struct site *site, const struct params *truth)
{
	for (size_t r = 0; r < site->n_run; r++)
		made_product(
		    &site->run[r], truth, site->run[r].product.passing);
}

static const bool OUTER[3] = {true, false, true};

static void
polish_goes_to_the_bottom_of_an_exact_valley(void **state)
{
	(void)state;
	for (size_t row = 0; row < ARRAY_LEN(TABLE_3); row++) {
		struct site *site = made_site(&TABLE_3[row], 0, 1);
		struct params truth = made_params(&TABLE_3[row]), p = truth;
		make_exact(site, &truth);
		p.beta[0] += 0.02;
		p.beta[2] *= 1.2;
		p.f_mat *= 0.99;
		p.e0_min *= 0.995;
		p.alpha *= 0.999;
		struct misfit *m = misfit_new(
		    site, OUTER, NULL, false, model_settings_default());
		struct polish *polish = polish_new(m);
		struct bounds bounds = bounds_default(0);
		double before = misfit_of_params(m, &p);
		struct polish_result r =
		    polish_minimise_misfit(polish, &bounds, 300, NULL, &p);
		if (!(r.misfit < 1e-20))
			fail_msg("row %zu: misfit %g after %d", row, r.misfit,
			    r.evaluations);
		assert_true(r.converged && r.evaluations <= 300);
		/* Össjö breaks nothing, so nothing can be told from it. */
		if (before > 0) {
			expect_near("f_mat", p.f_mat, truth.f_mat, 1e-7);
			expect_near("E0_min", p.e0_min, truth.e0_min, 1e-7);
			expect_near("alpha", p.alpha, truth.alpha, 1e-7);
		}
		polish_free(polish);
		misfit_free(m);
		site_free(site);
	}
}

static void
polish_is_never_worse_and_keeps_to_the_bounds(void **state)
{
	(void)state;
	struct draw draw = draw_start(51);
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 2);
	struct misfit *m =
	    misfit_new(site, OUTER, NULL, false, model_settings_default());
	struct polish *polish = polish_new(m);
	for (int k = 0; k < 60; k++) {
		struct bounds b = bounds_default(0);
		struct params p = made_any_params(&draw);
		size_t held = (size_t)(k % PARAM_COUNT);
		b.lower[PARAM_ALPHA] = 0.5;
		b.upper[PARAM_E0_MIN] = 25;
		p.alpha = fmax(p.alpha, 0.5);
		p.e0_min = fmin(p.e0_min, 25);
		b.lower[held] = b.upper[held] = p.at[held];
		double before = misfit_of_params(m, &p);
		struct polish_result r =
		    polish_minimise_misfit(polish, &b, 30, NULL, &p);
		assert_true(r.misfit <= before);
		expect_near("misfit", r.misfit, misfit_of_params(m, &p),
		    1e-12 * before);
		assert_true(r.evaluations <= 30);
		for (size_t j = 0; j < PARAM_COUNT; j++)
			assert_true(
			    p.at[j] >= b.lower[j] && p.at[j] <= b.upper[j]);
	}
	polish_free(polish);
	misfit_free(m);
	site_free(site);
}

/* A start on a bound that the data push away from comes off it. */
static void
polish_leaves_a_bound_that_does_not_hold_it(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[0], 0, 1);
	struct params truth = made_params(&TABLE_3[0]), p = truth;
	make_exact(site, &truth);
	struct misfit *m =
	    misfit_new(site, OUTER, NULL, false, model_settings_default());
	struct polish *polish = polish_new(m);
	struct bounds b = bounds_default(0);
	p.alpha = b.upper[PARAM_ALPHA];
	p.e0_min = 19;
	struct polish_result r =
	    polish_minimise_misfit(polish, &b, 300, NULL, &p);
	assert_true(r.misfit < 1e-20);
	expect_near("alpha", p.alpha, truth.alpha, 1e-7);
	p.alpha = b.lower[PARAM_ALPHA] = 0.92;
	r = polish_minimise_misfit(polish, &b, 300, NULL, &p);
	expect_near("alpha", p.alpha, truth.alpha, 1e-7);
	b.lower[PARAM_ALPHA] = 0;
	b.upper[PARAM_ALPHA] = 0.9; /* now the truth is out of reach */
	p.alpha = 0.85;
	r = polish_minimise_misfit(polish, &b, 300, NULL, &p);
	assert_true(r.misfit > 1e-12 && p.alpha == 0.9);
	polish_free(polish);
	misfit_free(m);
	site_free(site);
}

/* From wherever near the bottom, with the misfit no larger, and what is on a
 * bound still there. */
static void
settling_ends_at_the_same_bits(void **state)
{
	(void)state;
	struct draw draw = draw_start(77);
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 2);
	struct misfit *m =
	    misfit_new(site, OUTER, NULL, false, model_settings_default());
	struct polish *polish = polish_new(m);
	for (int k = 0; k < 2; k++) {
		struct bounds b = bounds_default(0);
		struct params p = made_params(&TABLE_3[TIERP]), first;
		b.upper[PARAM_ALPHA] = k == 0 ? 1.3 : 0.9;
		p.alpha = fmin(p.alpha, b.upper[PARAM_ALPHA]);
		struct polish_result r =
		    polish_minimise_misfit(polish, &b, 1000, NULL, &p);
		assert_true(r.converged);
		if (k == 1)
			assert_true(p.alpha == 0.9);
		for (int i = 0; i < 8; i++) {
			struct params q = p;
			for (size_t j = 0; j < PARAM_COUNT; j++) {
				double by = draw_between(&draw, -1e-7, 1e-7);
				bool held = j == PARAM_ALPHA && k == 1;
				q.at[j] *= held ? 1 : 1 + by;
			}
			params_scale_largest_beta_to_1(&q);
			assert_true(settle_at_stationary_point(m, &b, &q));
			assert_true(
			    misfit_of_params(m, &q) <= r.misfit * (1 + 1e-12));
			assert_true(q.alpha == 0.9 || k == 0);
			if (i == 0)
				first = q;
			assert_memory_equal(&q, &first, sizeof q);
		}
	}
	polish_free(polish);
	misfit_free(m);
	site_free(site);
}

/* Where fewer passings are compared than parameters move, or nothing breaks,
 * nothing is moved. */
static void
what_is_open_is_not_settled(void **state)
{
	(void)state;
	for (int k = 0; k < 2; k++) {
		const struct table_row *row = &TABLE_3[k == 0 ? TIERP : 5];
		struct site *site = made_site(row, 0, 2);
		struct params p = made_params(row), before = p;
		struct bounds b = bounds_default(0);
		make_exact(site, &p);
		site->run[0].product.n = k == 0 ? 3 : site->run[0].product.n;
		site->run[2].product.n = k == 0 ? 3 : site->run[2].product.n;
		struct misfit *m = misfit_new(
		    site, OUTER, NULL, false, model_settings_default());
		assert_false(settle_at_stationary_point(m, &b, &p));
		assert_memory_equal(&p, &before, sizeof p);
		misfit_free(m);
		site_free(site);
	}
}

static void
misfit_is_a_sum_of_weighted_squares(void **state)
{
	(void)state;
	const bool train[3] = {true, false, true};
	const double weight[3] = {3, 100, 0.5};
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 3);
	struct params p = made_params(&TABLE_3[TIERP]);
	struct run *slow = &site->run[0];
	slow->product_sd = xcalloc_doubles(slow->product.n);
	for (size_t i = 0; i < slow->product.n; i++)
		slow->product_sd[i] = 0.01 + 0.001 * (double)i;
	double plain = 0, by_sd = 0, of_feed = 0, n = 0, passing[20];
	for (size_t r = 0; r < 3; r += 2) {
		const struct run *run = &site->run[r];
		naive_continuous(&run->feed, run->product.size, run->product.n,
		    &p, run->speed, 40000, passing);
		for (size_t i = 0; i < run->product.n; i++, n++) {
			double d = run->product.passing[i] - passing[i];
			double sd = r == 0 ? run->product_sd[i] : 1;
			plain += d * d;
			by_sd += weight[r] * (d / sd) * (d / sd);
			d = run->product.passing[i] -
			    psd_passing(&run->feed, run->product.size[i]);
			of_feed += weight[r] * (d / sd) * (d / sd);
		}
	}
	struct model_settings settings = model_settings_default();
	struct misfit *m = misfit_new(site, train, NULL, false, settings);
	expect_near("misfit", misfit_of_params(m, &p), plain, 1e-4 * plain);
	expect_near("rmse", misfit_rmse(m, &p), sqrt(plain / n), 1e-6);
	assert_int_equal(m->n_residual, n);
	misfit_free(m);
	m = misfit_new(site, train, weight, true, settings);
	expect_near("by sd", misfit_of_params(m, &p), by_sd, 1e-4 * by_sd);
	expect_near(
	    "of feed", misfit_of_feed_as_product(m), of_feed, 1e-9 * of_feed);
	expect_near("rmse", misfit_rmse(m, &p), sqrt(plain / n), 1e-6);
	misfit_free(m);
	site_free(site);
}

static void
residuals_and_their_derivatives_make_the_misfit(void **state)
{
	(void)state;
	struct draw draw = draw_start(52);
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 4);
	struct misfit *m =
	    misfit_new(site, OUTER, NULL, false, model_settings_default());
	size_t n = m->n_residual;
	double *r = xcalloc_doubles(n), *J = xcalloc_doubles(n * PARAM_COUNT);
	for (int k = 0; k < 20; k++) {
		struct params p = made_params(&TABLE_3[TIERP]);
		p.beta[0] = draw_between(&draw, 0, 1);
		p.e0_min = draw_between(&draw, 10, 20);
		double sum = 0, misfit = misfit_jacobian(m, &p, r, J);
		for (size_t i = 0; i < n; i++)
			sum += r[i] * r[i];
		expect_near("squares", sum, misfit, 1e-14);
		expect_near("misfit", misfit_of_params(m, &p), misfit, 1e-14);
		for (size_t j = 0; j < PARAM_COUNT; j++) {
			double at = p.at[j], h = 1e-5, slope = 0;
			for (size_t i = 0; i < n; i++)
				slope += 2 * r[i] * J[i * PARAM_COUNT + j];
			p.at[j] = at + h;
			double up = misfit_of_params(m, &p);
			p.at[j] = at - h;
			double down = misfit_of_params(m, &p);
			p.at[j] = at;
			expect_near(PARAMS[j].name, slope,
			    (up - down) / (2 * h), 1e-6 + 1e-5 * fabs(slope));
		}
	}
	free(r);
	free(J);
	misfit_free(m);
	site_free(site);
}

/* Product sieves finer than the feed's finest are not compared. */
static void
sieves_that_the_feed_does_not_cover_are_left_out(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 5);
	struct psd *product = &site->run[0].product;
	size_t n = product->n;
	product->size[n - 1] = 45e-6;
	assert_int_equal(misfit_count_covered_sieves(&site->run[0]), n - 1);
	struct misfit *m =
	    misfit_new(site, OUTER, NULL, false, model_settings_default());
	assert_int_equal(m->n_residual, 2 * n - 1);
	misfit_free(m);
	bool train[3];
	assert_int_equal(misfit_mark_default_training(site, train), 2);
	assert_true(train[0] && !train[1] && train[2]);
	site->run[2].product.n = 0;
	assert_int_equal(misfit_mark_default_training(site, train), 2);
	assert_true(train[0] && train[1] && !train[2]);
	site->run[0].product.n = 0;
	assert_int_equal(misfit_mark_default_training(site, train), 1);
	assert_true(train[1]);
	site->run[1].product.n = 0;
	assert_int_equal(misfit_mark_default_training(site, train), 0);
	site_free(site);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(misfit_is_a_sum_of_weighted_squares),
	    cmocka_unit_test(residuals_and_their_derivatives_make_the_misfit),
	    cmocka_unit_test(sieves_that_the_feed_does_not_cover_are_left_out),
	    cmocka_unit_test(polish_goes_to_the_bottom_of_an_exact_valley),
	    cmocka_unit_test(polish_is_never_worse_and_keeps_to_the_bounds),
	    cmocka_unit_test(polish_leaves_a_bound_that_does_not_hold_it),
	    cmocka_unit_test(settling_ends_at_the_same_bits),
	    cmocka_unit_test(what_is_open_is_not_settled),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
