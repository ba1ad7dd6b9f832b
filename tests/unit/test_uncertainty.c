/* Fits that the data allow: do their bands hold the truth, and the bounds?
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "made.h"

#include <stdlib.h>

#include "core/calibrate.h"
#include "core/uncertainty.h"

/* A made-up site, calibrated at 69 and 79 m/s. */
struct fitted {
	struct site *site;
	struct misfit *misfit;
	struct calibrate_options options;
	struct fit fit;
	struct uncertainty *u;
};

static struct fitted
fitted(size_t row, double noise, uint64_t seed, const struct bounds *bounds)
{
	struct fitted f = {.site = made_site(&TABLE_3[row], noise, seed),
	    .options = calibrate_options_default()};
	f.options.population = 1000;
	f.options.seed = seed;
	if (bounds != NULL)
		f.options.bounds = *bounds;
	struct calibration *c = calibration_new(f.site, &f.options);
	while (calibration_step(c) < CALIBRATE_TOLERANCE)
		;
	f.fit = calibration_fit(c);
	calibration_free(c);
	f.misfit = calibrate_misfit(f.site, &f.options);
	f.u = uncertainty_new(
	    f.misfit, &f.fit.params, &f.options.bounds, f.options.seed);
	return f;
}

static void
fitted_free(struct fitted *f)
{
	free(f->u);
	misfit_free(f->misfit);
	site_free(f->site);
}

/* The fit's product and its band at the run held out, 74 m/s. */
static struct band
band_at_74(const struct fitted *f, struct psd *product)
{
	const struct run *run = &f->site->run[1];
	*product = psd_copy(&run->product);
	made_product(run, &f->fit.params, product->passing);
	return uncertainty_band(f->u, &f->fit.params, &run->feed, product,
	    f->options.settings, run->speed);
}

/* Counts the sieves at 74 m/s whose true passing the band holds; sieves that
 * pass all or next to nothing are left out. */
static void
count(const struct fitted *f, size_t row, double *inside, double *all)
{
	const struct run *run = &f->site->run[1];
	struct params truth = made_params(&TABLE_3[row]);
	double *passing = xdoubles(run->product.n);
	struct psd product;
	struct band band = band_at_74(f, &product);
	made_product(run, &truth, passing);
	for (size_t i = 0; i < band.n; i++) {
		double P = passing[i];
		assert_true(band.low[i] <= product.passing[i]);
		assert_true(product.passing[i] <= band.high[i]);
		if (P < 0.0005 || P > 0.9999)
			continue;
		*all += 1;
		*inside += band.low[i] <= P && P <= band.high[i];
	}
	band_free(&band);
	psd_free(&product);
	free(passing);
}

static void
bands_hold_the_truth_as_often_as_they_say(void **state)
{
	(void)state;
	static const size_t ROWS[6] = {1, 3, 6, TIERP, 12, 14};
	double inside = 0, all = 0, known = 0, asked = 0;
	for (size_t k = 0; k < ARRAY_LEN(ROWS); k++)
		for (uint64_t seed = 1; seed <= 10; seed++) {
			struct fitted f = fitted(ROWS[k], 0.005, seed, NULL);
			struct params truth = made_params(&TABLE_3[ROWS[k]]);
			count(&f, ROWS[k], &inside, &all);
			for (size_t j = PARAM_F_MAT; j < PARAM_COUNT; j++) {
				double x = truth.at[j];
				asked += 1;
				known += f.u->low[j] <= x && x <= f.u->high[j];
			}
			fitted_free(&f);
		}
	expect_near("sieves inside the band, %", 100 * inside / all, 80, 8);
	expect_near("parameters inside, %", 100 * known / asked, 78, 12);
}

static void
draws_keep_to_the_bounds_and_what_is_held(void **state)
{
	(void)state;
	struct bounds b = bounds_default(0);
	b.lower[PARAM_ALPHA] = b.upper[PARAM_ALPHA] = 0.96;
	b.upper[PARAM_F_MAT] = 0.8; /* the truth is 2.18 */
	b.upper[2] = 0;
	struct fitted f = fitted(TIERP, 0.005, 3, &b);
	for (size_t i = 0; i < UNCERTAINTY_DRAWS; i++) {
		const struct params *p = &f.u->draw[i];
		double largest = 0;
		assert_true(p->alpha == 0.96);
		assert_true(p->f_mat <= 0.8 && p->f_mat >= b.lower[4]);
		assert_true(p->e0_min >= 0 && p->e0_min <= 30);
		assert_true(p->beta[2] <= 0);
		for (size_t j = 0; j < 4; j++)
			largest = fmax(largest, fabs(p->beta[j]));
		expect_near("largest beta", largest, 1, 1e-12);
	}
	assert_true(f.u->low[PARAM_ALPHA] == 0.96);
	assert_true(f.u->high[PARAM_ALPHA] == 0.96);
	assert_true(f.u->low[PARAM_F_MAT] < f.u->high[PARAM_F_MAT]);
	fitted_free(&f);
}

static bool
after_a_hundred(void)
{
	static int looks;
	return looks++ == 100;
}

static void
the_same_seed_gives_the_same_bits(void **state)
{
	(void)state;
	struct fitted f = fitted(TIERP, 0.005, 4, NULL);
	struct uncertainty *again = uncertainty_new(
	    f.misfit, &f.fit.params, &f.options.bounds, f.options.seed);
	assert_memory_equal(again, f.u, sizeof *again);
	free(again);
	again = uncertainty_new(
	    f.misfit, &f.fit.params, &f.options.bounds, f.options.seed + 1);
	assert_memory_not_equal(again, f.u, sizeof *again);
	free(again);
	f.misfit->stop = after_a_hundred;
	assert_null(uncertainty_new(
	    f.misfit, &f.fit.params, &f.options.bounds, f.options.seed));
	fitted_free(&f);
}

static void
perfect_data_leave_a_tenth_of_a_point(void **state)
{
	(void)state;
	struct fitted f = fitted(TIERP, 0, 1, NULL);
	struct psd product;
	struct band band = band_at_74(&f, &product);
	double widest = 0;
	for (size_t i = 0; i < band.n; i++)
		widest = fmax(widest, band.high[i] - band.low[i]);
	expect_near("s", f.u->deviation, 0.001, 1e-5);
	expect_near("widest band", widest, 0.0017, 0.0009);
	band_free(&band);
	psd_free(&product);
	fitted_free(&f);
}

/* A sheet that states its noise truly, at a tenth of the runs' weight: differences
 * are as large as stated, and what the draws leave open hardly changes. */
static void
stated_deviations_set_the_noise(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 5);
	double weight[3] = {0.1, 0.1, 0.1};
	struct calibrate_options o = calibrate_options_default();
	for (size_t r = 0; r < site->n_run; r++) {
		struct run *run = &site->run[r];
		run->product_sd = xdoubles(run->product.n);
		for (size_t i = 0; i < run->product.n; i++) {
			double P = run->product.passing[i];
			run->product_sd[i] =
			    fmax(0.01 * sqrt(P * (1 - P)), 1e-4);
		}
	}
	o.by_sd = true;
	o.run_weight = weight;
	struct params truth = made_params(&TABLE_3[TIERP]);
	struct misfit *m = calibrate_misfit(site, &o);
	struct uncertainty *u = uncertainty_new(m, &truth, &o.bounds, 1);
	/* The root of 0.1, of the choice among valleys and of what is left. */
	expect_near("s", u->deviation, sqrt(0.1 * 1.6 * 24 / 18), 0.15);
	misfit_free(m);
	free(u);
	site_free(site);
}

/* Össjö breaks nothing, so that its parameters may be nearly anything. */
static void
where_nothing_breaks_the_bounds_are_the_limit(void **state)
{
	(void)state;
	struct fitted f = fitted(5, 0.005, 2, NULL);
	double range = f.u->high[PARAM_E0_MIN] - f.u->low[PARAM_E0_MIN];
	double share = f.u->high[PARAM_F_MAT] - f.u->low[PARAM_F_MAT];
	if (range < 5 || share < 1)
		fail_msg("E0_min open by %g, f_mat by %g", range, share);
	fitted_free(&f);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(bands_hold_the_truth_as_often_as_they_say),
	    cmocka_unit_test(draws_keep_to_the_bounds_and_what_is_held),
	    cmocka_unit_test(the_same_seed_gives_the_same_bits),
	    cmocka_unit_test(perfect_data_leave_a_tenth_of_a_point),
	    cmocka_unit_test(stated_deviations_set_the_noise),
	    cmocka_unit_test(where_nothing_breaks_the_bounds_are_the_limit),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
