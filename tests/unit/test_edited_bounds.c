/* A search whose bounds are edited in its midst goes on from where it is.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fitted.h"

static struct calibrate_options
options_for(unsigned threads, enum isa isa)
{
	struct calibrate_options o = calibrate_options_default();
	o.population = 800;
	o.generations = 120;
	o.threads = threads;
	o.isa = isa;
	return o;
}

static void
steps(struct calibration *c, size_t n)
{
	while (n-- > 0)
		calibration_step(c);
}

static struct bounds
with(struct bounds b, size_t j, double lower, double upper)
{
	b.lower[j] = lower;
	b.upper[j] = upper;
	return b;
}

static void
expect_inside(const struct bounds *b, const struct params *p)
{
	for (size_t j = 0; j < PARAM_COUNT; j++)
		assert_true(p->at[j] >= b->lower[j] && p->at[j] <= b->upper[j]);
}

/* Everything the search has ever held on to is within them at once. */
static void
narrower_bounds_hold_from_the_next_generation(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 6);
	struct calibrate_options o = options_for(1, ISA_BEST);
	struct calibration *c = calibration_new(site, &o);
	steps(c, 20);
	struct calibrate_status before = calibration_status(c);
	double middle = before.params.e0_min;
	struct bounds b = with(o.bounds, PARAM_E0_MIN, 0, middle / 2);
	calibration_set_bounds(c, &b);
	struct calibrate_status s = calibration_status(c);
	assert_int_equal(s.generation, 20);
	assert_true(s.params.e0_min == middle / 2);
	assert_true(isfinite(s.best) && s.best > before.best);
	for (size_t i = 21; i <= 40; i++) {
		size_t n;
		assert_int_equal(calibration_step(c), CALIBRATE_SEARCHING);
		const struct calibrate_generation *g =
		    calibration_generation_history(c, &n);
		assert_int_equal(n, i);
		expect_inside(&b, &g[n - 1].params);
		assert_true(g[n - 1].p90[PARAM_E0_MIN] <= middle / 2);
	}
	struct fit fit = fitted_by(c);
	assert_true(fit.params.e0_min <= middle / 2);
	assert_true(fit.on_bound[PARAM_E0_MIN]);
	assert_int_equal(fit.edits, 1);
	assert_int_equal(fit.edited_at, 20);
	o.bounds = b;
	struct fit anew = fitted_by(calibration_new(site, &o));
	expect_near("misfit", fit.misfit, anew.misfit, 1e-6 * anew.misfit);
	assert_int_equal(anew.edits, 0);
	site_free(site);
}

static void
wider_bounds_are_used(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 6);
	struct calibrate_options o = options_for(1, ISA_BEST);
	struct fit anew = fitted_by(calibration_new(site, &o));
	struct bounds wide = o.bounds;
	o.bounds = with(wide, PARAM_E0_MIN, 0, 10);
	struct calibration *c = calibration_new(site, &o);
	steps(c, 20);
	double best = calibration_status(c).best;
	calibration_set_bounds(c, &wide);
	assert_true(calibration_status(c).best == best);
	calibration_step(c);
	assert_true(calibration_status(c).best <= best);
	struct fit fit = fitted_by(c);
	assert_true(fit.params.e0_min > 11);
	expect_near("misfit", fit.misfit, anew.misfit, 1e-6 * anew.misfit);
	site_free(site);
}

/* A fixed value, then a free one again, in the midst of the polish. */
static void
the_polish_begins_again_within_them(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 6);
	struct calibrate_options o = options_for(1, ISA_BEST);
	struct fit usual = fitted_by(calibration_new(site, &o));
	struct calibration *c = calibration_new(site, &o);
	while (calibration_step(c) == CALIBRATE_SEARCHING)
		;
	steps(c, 6);
	struct bounds b = with(o.bounds, PARAM_ALPHA, 0.5, 0.5);
	calibration_set_bounds(c, &b);
	assert_true(calibration_best_fit(c).params.alpha == 0.5);
	steps(c, 3);
	assert_true(calibration_best_fit(c).params.alpha == 0.5);
	assert_true(calibration_best_fit(c).misfit > usual.misfit);
	calibration_set_bounds(c, &o.bounds);
	struct fit fit = fitted_by(c);
	assert_int_equal(fit.edits, 2);
	assert_int_equal(fit.edited_at, usual.generations);
	expect_near("misfit", fit.misfit, usual.misfit, 1e-6 * usual.misfit);
	site_free(site);
}

static struct fit
edited(const struct site *site, unsigned threads, enum isa isa)
{
	struct calibrate_options o = options_for(threads, isa);
	struct calibration *c = calibration_new(site, &o);
	struct bounds b = with(o.bounds, PARAM_F_MAT, 0.1, 0.9);
	steps(c, 9);
	calibration_set_bounds(c, &b);
	steps(c, 13);
	b = with(b, PARAM_E0_MIN, 2, 40);
	calibration_set_bounds(c, &b);
	return fitted_by(c);
}

static void
threads_and_instructions_do_not_change_a_bit(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 3);
	struct fit one = edited(site, 1, ISA_BEST);
	struct fit others[] = {edited(site, 1, ISA_BEST),
	    edited(site, 2, ISA_BEST), edited(site, 1, ISA_BASE)};
	for (size_t i = 0; i < ARRAY_LEN(others); i++) {
		assert_memory_equal(
		    &others[i].params, &one.params, sizeof one.params);
		assert_true(others[i].misfit == one.misfit);
		assert_int_equal(others[i].evaluations, one.evaluations);
	}
	site_free(site);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(narrower_bounds_hold_from_the_next_generation),
	    cmocka_unit_test(wider_bounds_are_used),
	    cmocka_unit_test(the_polish_begins_again_within_them),
	    cmocka_unit_test(threads_and_instructions_do_not_change_a_bit),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
