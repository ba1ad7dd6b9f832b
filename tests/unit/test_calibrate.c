/* Calibrations of made-up sites: curves are recovered, results do not hang on
 * seed or threads, and each option does what it says.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fitted.h"
#include "often.h"
#include "naive.h"

#include <stdatomic.h>

#include "core/search/misfit.h"
#include "core/search/sensitivity.h"

static const double NOISE = 0.005;

static struct calibrate_options
full_options(uint64_t seed)
{
	struct calibrate_options options = calibrate_options_default();
	options.seed = seed;
	return options;
}

/* A population that may end in a side valley, where that does not matter. */
static struct calibrate_options
small_options(uint64_t seed)
{
	struct calibrate_options options = full_options(seed);
	options.population = 600;
	options.generations = 80;
	return options;
}

/* Parameters are not: E0_min, alpha and f_mat trade off.  Össjö (row 5) breaks
 * nothing. */
static void
curves_are_recovered_at_the_speed_held_out(void **state)
{
	(void)state;
	static const size_t rows[] = {2, 5, 8, 9, 12, 17};
	for (size_t i = 0; i < ARRAY_LEN(rows); i++)
		for (uint64_t seed = 1; seed <= often(1, 2); seed++) {
			const struct table_row *row = &TABLE_3[rows[i]];
			struct site *site = made_site(row, NOISE, 10 * seed);
			struct calibrate_options o = full_options(seed);
			struct fit fit = fitted(site, &o);
			struct params truth = made_params(row);
			double found[20], exact[20];
			made_product(&site->run[1], &fit.params, found);
			made_product(&site->run[1], &truth, exact);
			double rms = psd_rms_difference(
			    found, exact, site->run[1].product.n, NULL);
			if (!(rms <= NOISE))
				fail_msg("%s, seed %d: off by %.3f points",
				    row->site, (int)seed, 100 * rms);
			site_free(site);
		}
}

static void
any_seed_finds_the_same_misfit(void **state)
{
	(void)state;
	static const size_t rows[] = {8, 17};
	for (size_t i = 0; i < ARRAY_LEN(rows); i++) {
		double first = 0;
		struct site *site = made_site(&TABLE_3[rows[i]], NOISE, 9);
		for (uint64_t seed = 1; seed <= 3; seed++) {
			struct calibrate_options o = full_options(seed);
			struct fit fit = fitted(site, &o);
			if (seed == 1)
				first = fit.misfit;
			expect_near("misfit", fit.misfit, first, 1e-6 * first);
		}
		site_free(site);
	}
}

/* Of every breakage model, and with more runs than the two of the default. */
static void
any_seed_ends_at_the_same_parameters(void **state)
{
	(void)state;
	static const bool ALL[3] = {true, true, true};
	struct site *site = made_site(&TABLE_3[TIERP], NOISE, 3);
	size_t models = often(1, breakage_count_models());
	for (unsigned model = 0; model < models; model++) {
		struct fit first = {0};
		for (uint64_t seed = 1; seed <= often(2, 5); seed++) {
			struct calibrate_options o = quick_options(seed);
			o.settings.breakage = model;
			o.bounds = bounds_default(model);
			o.train = model % 2 == 0 ? NULL : ALL;
			struct fit fit = fitted(site, &o);
			first = seed == 1 ? fit : first;
			assert_true(fit.converged);
			assert_memory_equal(
			    &fit.params, &first.params, sizeof fit.params);
			assert_true(fit.misfit == first.misfit);
		}
	}
	site_free(site);
}

static void
expect_same_fit(const struct fit *a, const struct fit *b)
{
	assert_memory_equal(&a->params, &b->params, sizeof a->params);
	assert_memory_equal(&a->misfit, &b->misfit, sizeof a->misfit);
	assert_int_equal(a->generations, b->generations);
	assert_int_equal(a->evaluations, b->evaluations);
	assert_int_equal(a->perturbations, b->perturbations);
	assert_int_equal(a->stop, b->stop);
}

static void
threads_and_instructions_do_not_change_a_bit(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], NOISE, 3);
	for (uint64_t seed = 1; seed <= 2; seed++) {
		struct calibrate_options o = small_options(seed);
		struct fit one = fitted(site, &o), again = fitted(site, &o);
		expect_same_fit(&one, &again);
		o.threads = 2;
		struct fit two = fitted(site, &o);
		expect_same_fit(&one, &two);
		o.isa = ISA_BASE;
		struct fit base = fitted(site, &o);
		expect_same_fit(&one, &base);
	}
	struct calibrate_options o = small_options(1);
	o.polish = false;
	struct fit one = fitted(site, &o);
	o.seed = 2;
	struct fit other = fitted(site, &o);
	assert_true(one.misfit != other.misfit);
	site_free(site);
}

static void
a_search_ends_for_the_reason_it_gives(void **state)
{
	(void)state;
	static const struct {
		double tolerance;
		size_t stall, generations;
		enum calibrate_state stop;
		const char *name;
	} rows[] = {{0, 0, 40, CALIBRATE_GENERATIONS, "generations"},
	    {0.05, 20, 3, CALIBRATE_GENERATIONS, "generations"},
	    {1000, 0, 90, CALIBRATE_TOLERANCE, "tolerance"},
	    {0, 1, 90, CALIBRATE_STALLED, "stall"}};
	struct site *site = made_site(&TABLE_3[TIERP], NOISE, 4);
	for (size_t i = 0; i < ARRAY_LEN(rows); i++) {
		struct calibrate_options o = small_options(1);
		o.tolerance = rows[i].tolerance;
		o.stall = rows[i].stall;
		o.generations = rows[i].generations;
		o.polish = i % 2 == 0;
		struct fit fit = fitted(site, &o);
		assert_int_equal(fit.stop, rows[i].stop);
		assert_string_equal(
		    calibrate_state_name(fit.stop), rows[i].name);
		if (fit.stop == CALIBRATE_GENERATIONS)
			assert_int_equal(fit.generations, rows[i].generations);
		else
			assert_true(fit.generations < rows[i].generations);
		assert_true(fit.evaluations >= fit.generations * 600);
	}
	assert_string_equal(calibrate_state_name(CALIBRATE_STOPPED), "stopped");
	site_free(site);
}

static void
a_stopped_search_keeps_its_best(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], NOISE, 5);
	struct calibrate_options o = small_options(1);
	struct calibration *c = calibration_new(site, &o);
	double before = INFINITY;
	for (size_t i = 1; i <= 5; i++) {
		assert_int_equal(calibration_step(c), CALIBRATE_SEARCHING);
		struct calibrate_status s = calibration_status(c);
		assert_int_equal(s.generation, i);
		assert_true(s.best <= before && s.best <= s.median);
		before = s.best;
	}
	struct fit stopped = calibration_best_fit(c);
	struct params best = calibration_status(c).params;
	assert_int_equal(stopped.stop, CALIBRATE_STOPPED);
	assert_memory_equal(&stopped.params, &best, sizeof best);
	struct fit again = calibration_best_fit(c);
	expect_same_fit(&stopped, &again);
	calibration_free(c);
	site_free(site);
}

/* Whoever stops in the midst of the polish gets what the search had found, or
 * better. */
static void
expect_no_rise(const struct site *site, uint64_t seed)
{
	struct calibrate_options o = small_options(seed);
	o.population = 800;
	struct calibration *c = calibration_new(site, &o);
	while (calibration_step(c) == CALIBRATE_SEARCHING)
		;
	double before = calibration_best_fit(c).misfit;
	while (calibration_step(c) == CALIBRATE_POLISHING) {
		double now = calibration_best_fit(c).misfit;
		if (!(now <= before * (1 + 1e-9)))
			fail_msg("seed %d: misfit from %g to %g", (int)seed,
			    before, now);
		before = now;
	}
	calibration_free(c);
}

static void
the_result_never_gets_worse_in_the_polish(void **state)
{
	(void)state;
	for (size_t row = 0; row <= 12; row += 6) {
		struct site *site = made_site(&TABLE_3[row], NOISE, 9);
		for (uint64_t seed = 1; seed <= 3; seed++)
			expect_no_rise(site, seed);
		site_free(site);
	}
}

static double
largest_beta(const struct params *p)
{
	double largest = 0;
	for (size_t b = 0; b < 4; b++)
		largest = fmax(largest, fabs(p->beta[b]));
	return largest;
}

static void
a_fit_says_where_it_is_from(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], NOISE, 6);
	struct calibrate_options o = small_options(7);
	struct calibration *c = calibration_new(site, &o);
	calibration_step(c);
	struct params early = calibration_status(c).params;
	assert_true(largest_beta(&early) == 1);
	calibration_free(c);
	struct fit fit = fitted(site, &o);
	double feed = 0, squares = 0, passing[20];
	size_t n = 0;
	for (size_t r = 0; r < 3; r += 2) {
		const struct run *run = &site->run[r];
		made_product(run, &fit.params, passing);
		for (size_t i = 0; i < run->product.n; i++, n++) {
			double d = run->product.passing[i] - passing[i];
			double f =
			    run->product.passing[i] -
			    naive_passing(&run->feed, run->product.size[i]);
			squares += d * d;
			feed += f * f;
		}
	}
	expect_near("misfit", fit.misfit, squares, 1e-12);
	expect_near("rmse", fit.rmse, sqrt(squares / (double)n), 1e-12);
	expect_near("feed's misfit", fit.feed_misfit, feed, 1e-12);
	assert_true(largest_beta(&fit.params) == 1);
	assert_int_equal(fit.n_residual, n);
	assert_int_equal(fit.seed, 7);
	assert_true(fit.perturbations > 0);
	assert_int_equal(fit.population, 600);
	assert_int_equal(fit.settings.method, METHOD_CONTINUOUS);
	site_free(site);
}

static void
bounds_hold_and_are_told(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], NOISE, 6);
	struct calibrate_options o = small_options(1);
	struct fit fit = fitted(site, &o);
	assert_false(fit.on_bound[PARAM_E0_MIN]);
	o.bounds.upper[PARAM_E0_MIN] = 10;
	fit = fitted(site, &o);
	assert_true(fit.params.e0_min == 10);
	assert_true(fit.on_bound[PARAM_E0_MIN]);
	o.bounds = bounds_default(0);
	o.bounds.lower[PARAM_F_MAT] = o.bounds.upper[PARAM_F_MAT] = 1.2;
	o.bounds.lower[PARAM_ALPHA] = o.bounds.upper[PARAM_ALPHA] = 0.97;
	fit = fitted(site, &o);
	assert_true(fit.params.f_mat == 1.2 && fit.params.alpha == 0.97);
	assert_false(fit.on_bound[PARAM_F_MAT]);
	assert_false(fit.on_bound[PARAM_ALPHA]);
	site_free(site);
}

static void
other_runs_may_train(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], NOISE, 7);
	const bool slow[3] = {true, true, false}, all[3] = {true, true, true};
	size_t n = site->run[0].product.n;
	struct calibrate_options o = full_options(1);
	struct fit outer = fitted(site, &o);
	assert_int_equal(outer.n_residual, 2 * n);
	o.train = slow;
	struct fit slower = fitted(site, &o);
	assert_int_equal(slower.n_residual, 2 * n);
	assert_true(slower.misfit != outer.misfit);
	o.train = all;
	struct fit three = fitted(site, &o);
	assert_int_equal(three.n_residual, 3 * n);
	assert_true(three.misfit > fmax(outer.misfit, slower.misfit));
	site_free(site);
}

static void
weights_of_runs_and_sieves_count(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], NOISE, 8);
	const bool slow[3] = {true, false, false};
	const double only_slow[3] = {1, 1, 0};
	struct calibrate_options o = full_options(1);
	struct fit plain = fitted(site, &o);
	o.run_weight = only_slow;
	struct fit weighted = fitted(site, &o);
	o.run_weight = NULL;
	o.train = slow;
	struct fit alone = fitted(site, &o);
	expect_near(
	    "weight 0", weighted.misfit, alone.misfit, 1e-6 * alone.misfit);
	o.train = NULL;
	o.by_sd = true; /* of a sheet that states none: nothing changes */
	struct fit none = fitted(site, &o);
	expect_near("no sd", none.misfit, plain.misfit, 1e-9 * plain.misfit);
	for (size_t r = 0; r < 3; r++) {
		size_t n = site->run[r].product.n;
		site->run[r].product_sd = xcalloc_doubles(n);
		for (size_t i = 0; i < n; i++)
			site->run[r].product_sd[i] = 0.005;
	}
	struct fit same = fitted(site, &o);
	double scaled = plain.misfit / (0.005 * 0.005);
	expect_near("same sd", same.misfit, scaled, 1e-6 * scaled);
	expect_near("rmse", same.rmse, plain.rmse, 1e-6 * plain.rmse);
	site_free(site);
}

static void
classes_are_calibrated_too(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 9);
	struct calibrate_options o = small_options(1);
	o.settings.method = METHOD_CLASSES;
	struct fit fit = fitted(site, &o);
	const bool ends[3] = {true, false, true};
	struct misfit *m = misfit_new(site, ends, NULL, false, o.settings);
	double misfit = misfit_of_params(m, &fit.params);
	expect_near("misfit", fit.misfit, misfit, 1e-9 * misfit);
	assert_int_equal(fit.settings.method, METHOD_CLASSES);
	assert_true(fit.misfit < 0.02 * fit.feed_misfit);
	misfit_free(m);
	site_free(site);
}

static atomic_int looks, next_stop;

/* In the midst of generations and of batches, but ever more rarely, as one
 * that is stopped begins anew. */
static bool
now_and_then(void)
{
	int look = atomic_fetch_add(&looks, 1);
	if (look < atomic_load(&next_stop))
		return false;
	atomic_store(&next_stop, look + look / 8 + 1);
	return true;
}

static void
a_step_that_is_stopped_is_made_anew(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], NOISE, 9);
	struct calibrate_options o = small_options(1);
	struct fit whole = fitted(site, &o);
	o.stop = now_and_then;
	o.threads = 2;
	struct calibration *c = calibration_new(site, &o);
	size_t idle[2] = {0}, before = 0;
	for (bool over = false; !over;) {
		enum calibrate_state was = calibration_status(c).state;
		over = calibration_step(c) >= CALIBRATE_TOLERANCE;
		size_t step = calibration_status(c).step;
		idle[was == CALIBRATE_POLISHING] += step == before;
		before = step;
	}
	struct fit fit = calibration_best_fit(c);
	assert_true(idle[0] > 5 && idle[1] > 5);
	assert_memory_equal(&fit.params, &whole.params, sizeof fit.params);
	assert_int_equal(fit.evaluations, whole.evaluations);
	assert_int_equal(fit.perturbations, whole.perturbations);
	calibration_free(c);
	site_free(site);
}

/* Half a per cent of the range from it is no bound. */
static void
near_a_bound_is_not_on_it(void **state)
{
	(void)state;
	static const struct {
		double alpha;
		bool on;
	} AT[] = {{1, true}, {1 - 5e-7, true}, {1 - 2e-6, false},
	    {0.995, false}, {0.005, false}, {5e-7, true}, {0, true}};
	struct bounds b = bounds_default(0);
	struct params p = {.beta = {1000, 0, 0, 0}, .f_mat = 1};
	assert_false(sensitivity_is_param_on_bound(&b, &p, 0));
	for (size_t i = 0; i < ARRAY_LEN(AT); i++) {
		p.alpha = AT[i].alpha;
		assert_int_equal(
		    sensitivity_is_param_on_bound(&b, &p, PARAM_ALPHA),
		    AT[i].on);
	}
	b.lower[PARAM_ALPHA] = b.upper[PARAM_ALPHA] = p.alpha;
	assert_false(sensitivity_is_param_on_bound(&b, &p, PARAM_ALPHA));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(curves_are_recovered_at_the_speed_held_out),
	    cmocka_unit_test(any_seed_finds_the_same_misfit),
	    cmocka_unit_test(any_seed_ends_at_the_same_parameters),
	    cmocka_unit_test(threads_and_instructions_do_not_change_a_bit),
	    cmocka_unit_test(a_search_ends_for_the_reason_it_gives),
	    cmocka_unit_test(a_stopped_search_keeps_its_best),
	    cmocka_unit_test(the_result_never_gets_worse_in_the_polish),
	    cmocka_unit_test(a_fit_says_where_it_is_from),
	    cmocka_unit_test(bounds_hold_and_are_told),
	    cmocka_unit_test(near_a_bound_is_not_on_it),
	    cmocka_unit_test(other_runs_may_train),
	    cmocka_unit_test(weights_of_runs_and_sieves_count),
	    cmocka_unit_test(classes_are_calibrated_too),
	    cmocka_unit_test(a_step_that_is_stopped_is_made_anew),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
