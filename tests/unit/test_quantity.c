/* Quantities of a product and of its screened fractions, by hand and at any
 * speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fitted.h"

#include <stdlib.h>

#include "core/answer/predict.h"
#include "core/answer/forecast.h"

/* A curve whose every number is round. */
static struct psd
sand(void)
{
	static const double MM[] = {8, 4, 2, 1, 0.5, 0.25, 0.125, 0.0625},
			    PASSING[] = {1, 0.8, 0.6, 0.4, 0.2, 0.1, 0.05, 0};
	struct psd psd = psd_new(8);
	for (size_t i = 0; i < 8; i++) {
		psd.size[i] = MM[i] / 1000;
		psd.passing[i] = PASSING[i];
	}
	return psd;
}

static double
read_one(enum quantity_kind kind, double x, const struct modulus *m)
{
	struct psd psd = sand();
	struct quantity q = {.kind = kind, .x = x, .modulus = m};
	double value = quantity_read_off_curve(&q, &psd, 0.3);
	psd_free(&psd);
	return value;
}

static void
quantities_by_hand(void **state)
{
	(void)state;
	expect_near(
	    "passing", read_one(QUANTITY_PASSING, 1e-3, NULL), 0.4, 1e-12);
	expect_near("P60", read_one(QUANTITY_SIZE, 0.6, NULL), 2e-3, 1e-12);
	expect_near("share", read_one(QUANTITY_SHARE, 0, NULL), 0.3, 1e-12);
	expect_near("Cu", read_one(QUANTITY_UNIFORMITY, 0, NULL), 8, 1e-9);
	/* D30 lies in the middle of 0.5 and 1 mm, on log size. */
	expect_near("Cc", read_one(QUANTITY_CURVATURE, 0, NULL),
	    0.5 * 1 / (2 * 0.25), 1e-9);
	/* Retained on 4, 2, 1, 0.5, 0.25, 0.125: .2 .4 .6 .8 .9 .95 */
	expect_near(
	    "FM EN", read_one(QUANTITY_MODULUS, 0, &MODULUS[0]), 3.85, 1e-12);
	/* Nothing passes the finest sieve, so that finer ones are known. */
	expect_near("finer", read_one(QUANTITY_PASSING, 1e-6, NULL), 0, 1e-12);
}

/* What passes a screen of 4 mm, and so the share of 0/4, only rises as a
 * product gets finer; that of 2/4 may do either. */
static void
quantities_say_how_they_change_with_fineness(void **state)
{
	(void)state;
	struct quantity q = {.kind = QUANTITY_PASSING, .x = 4e-3};
	assert_int_equal(quantity_sign_if_finer(&q), 1);
	q = (struct quantity){.kind = QUANTITY_SIZE, .x = 0.8};
	assert_int_equal(quantity_sign_if_finer(&q), -1);
	q.fraction = (struct fraction){0, 4e-3, PARTITION_IDEAL};
	assert_int_equal(quantity_sign_if_finer(&q), 0);
	q.kind = QUANTITY_SHARE;
	assert_int_equal(quantity_sign_if_finer(&q), 1);
	q.fraction.fine = 2e-3;
	assert_int_equal(quantity_sign_if_finer(&q), 0);
	q.fraction.coarse = 0;
	assert_int_equal(quantity_sign_if_finer(&q), 0);
}

/* Between 8 and 4, 4 and 1, 1 and 0.5 mm: 0.2, 0.4, 0.2. */
static void
the_largest_step_is_between_neighbours_of_the_list(void **state)
{
	(void)state;
	static const double SIEVE[] = {8e-3, 4e-3, 1e-3, 0.5e-3};
	struct psd psd = sand();
	struct quantity q = {
	    .kind = QUANTITY_STEP, .n_sieve = 4, .sieve = SIEVE};
	double point[QUANTITY_POINTS];
	expect_near("step", quantity_read_off_curve(&q, &psd, 1), 0.4, 1e-12);
	expect_near("over", quantity_excess_as_passing(&q, 0.45, 0.4, &psd),
	    -0.05, 1e-12);
	assert_int_equal(quantity_sizes_needed(&q, point), 4);
	psd_free(&psd);
}

/* A1 = 0.3 on 4.75, then .5 .7 .8 .9 .95 cumulative:
 * (.5 + .7 + .8 + .9 + .95 - 5 * .3) / (1 - .3) = 2.35 / 0.7 */
static void
the_chinese_modulus_leaves_out_gravel(void **state)
{
	(void)state;
	const struct modulus *gb = &MODULUS[4];
	static const double PASSING[] = {0.7, 0.5, 0.3, 0.2, 0.1, 0.05};
	struct psd psd = psd_new(6);
	for (size_t i = 0; i < 6; i++) {
		psd.size[i] = gb->mm[i] / 1000;
		psd.passing[i] = PASSING[i];
	}
	struct quantity q = {.kind = QUANTITY_MODULUS, .modulus = gb};
	expect_near(
	    "FM GB", quantity_read_off_curve(&q, &psd, 1), 2.35 / 0.7, 1e-12);
	psd_free(&psd);
}

static void
an_ideal_screen_cuts_the_curve(void **state)
{
	(void)state;
	struct psd psd = sand(), part = sand();
	struct fraction f = {0.5e-3, 4e-3, PARTITION_IDEAL};
	double kept[8];
	fraction_share_of_each_class(&f, psd.size, psd.n, kept);
	expect_near("share", screening_compute_kept_part(&psd, kept, &part),
	    0.8 - 0.2, 1e-12);
	expect_near("4", part.passing[1], 1, 1e-12);
	expect_near("2", part.passing[2], (0.6 - 0.2) / 0.6, 1e-12);
	expect_near("0.5", part.passing[4], 0, 1e-12);
	psd_free(&psd);
	psd_free(&part);
}

/* Half of the cut size goes either way, more of what is coarser; and nothing
 * is lost between oversize and undersize. */
static void
a_real_screen_keeps_the_mass(void **state)
{
	(void)state;
	struct psd psd = sand(), part = sand();
	struct partition p = {5, 0.9};
	expect_near(
	    "d50", partition_share_to_oversize(&p, 4e-3, 3.6e-3), 0.5, 1e-12);
	expect_near("0", partition_share_to_oversize(&p, 4e-3, 1e-9), 0, 1e-6);
	double before = 0, sum = 0;
	for (double d = 1e-4; d < 0.1; d *= 1.1) {
		double now = partition_share_to_oversize(&p, 4e-3, d);
		assert_true(now >= before && now <= 1);
		before = now;
	}
	static const double AT[4] = {0, 0.5e-3, 4e-3, 0};
	for (size_t i = 0; i < 3; i++) {
		/* 0/0.5 and what stays on 4 pass the other screen too. */
		struct fraction f = {AT[i], i < 2 ? AT[i + 1] : 0, p};
		double kept[8], other[8];
		fraction_share_of_each_class(&f, psd.size, psd.n, kept);
		partition_oversize_of_classes(&p, 4e-3, psd.size, psd.n, other);
		for (size_t k = 0; k < 8 && i == 0; k++)
			kept[k] *= 1 - other[k];
		sum += screening_compute_kept_part(&psd, kept, &part);
	}
	expect_near("sum", sum, 1, 1e-12);
	psd_free(&psd);
	psd_free(&part);
}

/* A site with what is known of it after calibrating. */
struct known {
	struct site *site;
	struct fit fit;
	struct posterior *posterior;
};

static struct known
known(void)
{
	struct known k = {.site = made_site(&TABLE_3[TIERP], 0.005, 4)};
	bool use[8] = {true, false, true};
	struct calibrate_options o = quick_options(1);
	k.fit = fitted(k.site, &o);
	k.posterior = drawn(k.site, &k.fit, &o, use);
	return k;
}

enum { ASKED = 4 };
static const struct quantity ASK[ASKED] = {
    {.kind = QUANTITY_PASSING, .x = 2e-3}, {.kind = QUANTITY_SIZE, .x = 0.8},
    {.kind = QUANTITY_SHARE, .fraction = {.coarse = 4e-3}},
    {.kind = QUANTITY_PASSING, .x = 2e-3, .fraction = {.coarse = 4e-3}}};

/* The P80 of the mean of the draws, and the middle of those of each. */
static double
size_of_draws(
    struct ensemble *e, const struct psd *sizes, double range[static 2])
{
	double size[POSTERIOR_DRAWS];
	struct psd curve = psd_copy(sizes);
	const double *P = ensemble_products(e, ENSEMBLE_ANSWER);
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
		for (size_t i = 0; i < curve.n; i++)
			curve.passing[i] = P[i * POSTERIOR_DRAWS + d];
		size[d] = psd_size_at_passing(&curve, 0.8);
	}
	ensemble_mean_answer(e, curve.passing);
	double mean = psd_size_at_passing(&curve, 0.8);
	ensemble_interval_around_answer(size, 0.8, mean, range);
	psd_free(&curve);
	return mean;
}

/* What is read off by itself is what the draws and the table of a prediction
 * have; the fraction's passing is the quotient of two passings, in every
 * draw. */
static void
a_forecast_is_what_is_predicted(void **state)
{
	(void)state;
	const struct fraction whole = {0};
	struct known k = known();
	const struct psd *feed = &k.site->run[0].feed;
	struct psd sizes = predict_list_table_sieves(k.site, feed);
	struct ensemble *e =
	    ensemble_new(k.posterior, feed, sizes.size, sizes.n);
	size_t n;
	struct quantity *all =
	    predict_table_quantities(k.site, feed, &whole, &n);
	struct forecast *table = forecast_new(feed, sizes.size, sizes.n, all, n,
	    &k.fit.params, k.fit.settings, 0.8);
	forecast_move_to_speed(table, e, ENSEMBLE_ANSWER, 72);
	struct prediction p = predict_at_table_sieves(k.site, 0, &whole, table);
	struct forecast *r = forecast_new(feed, sizes.size, sizes.n, ASK, ASKED,
	    &k.fit.params, k.fit.settings, 0.8);
	forecast_move_to_speed(r, e, ENSEMBLE_ANSWER, 72);
	double ends[2];
	struct figure p80 = forecast_value_with_band(r, 1);
	expect_near("P80", p80.value, p.p80, 1e-12);
	expect_near("low", p80.low, p.range[2][0], 1e-12);
	expect_near("high", p80.high, p.range[2][1], 1e-12);
	expect_near("of draws", p.p80, size_of_draws(e, &sizes, ends), 1e-12);
	expect_near("their low", p.range[2][0], ends[0], 1e-12);
	expect_near("their high", p.range[2][1], ends[1], 1e-12);
	expect_near("2 mm", forecast_value_with_band(r, 0).value,
	    psd_passing_at_sieve(&p.product, 2e-3), 1e-9);
	expect_near("2 mm of 0/4", forecast_value_with_band(r, 3).value,
	    forecast_value_with_band(r, 0).value /
		forecast_value_with_band(r, 2).value,
	    1e-12);
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		expect_near("draw", forecast_draws_of_quantity(r, 3)[d],
		    forecast_draws_of_quantity(r, 0)[d] /
			forecast_draws_of_quantity(r, 2)[d],
		    1e-12);
	forecast_close(r);
	forecast_close(table);
	free(all);
	ensemble_free(e);
	prediction_free(&p);
	psd_free(&sizes);
	posterior_free(k.posterior);
	site_free(k.site);
}

/* Where a size lies below the finest sieve in many draws, its low end is not
 * known, though the answer is; of Cu, which is D60 / D10, the high end. */
static void
an_end_beyond_the_sieves_is_not_known(void **state)
{
	(void)state;
	enum { SIEVES = 4 };
	static const double SIZE[SIEVES] = {22.4e-3, 8e-3, 2e-3, 0.55e-3};
	static const struct quantity OF[] = {
	    {.kind = QUANTITY_SIZE, .x = 0.1}, {.kind = QUANTITY_UNIFORMITY}};
	struct known k = known();
	const struct psd *feed = &k.site->run[0].feed;
	struct ensemble *e = ensemble_new(k.posterior, feed, SIZE, SIEVES);
	struct forecast *f = forecast_new(
	    feed, SIZE, SIEVES, OF, 2, &k.fit.params, k.fit.settings, 0.8);
	double v = 60;
	do
		forecast_move_to_speed(f, e, ENSEMBLE_ANSWER, v += 0.1);
	while (!isnan(forecast_value_with_band(f, 0).low));
	struct figure d10 = forecast_value_with_band(f, 0);
	struct figure cu = forecast_value_with_band(f, 1);
	assert_false(isnan(d10.value) || isnan(d10.high));
	assert_true(d10.high >= d10.value);
	assert_true(isnan(cu.high));
	assert_true(cu.low <= cu.value);
	struct figure more = forecast_difference(f, f, 0);
	assert_true(isnan(more.low) && isnan(more.high));
	forecast_close(f);
	ensemble_free(e);
	posterior_free(k.posterior);
	site_free(k.site);
}

/* The classes' shares add up to what predict says is broken. */
static void
selection_sums_to_what_breaks(void **state)
{
	(void)state;
	for (size_t row = 0; row < 19; row++)
		for (int method = 0; method < 2; method++) {
			struct site *site = made_site(&TABLE_3[row], 0, 1);
			const struct psd *feed = &site->run[1].feed;
			struct params p = made_params(&TABLE_3[row]);
			struct model_settings settings =
			    model_settings_default();
			settings.method = (enum method)method;
			double *S = xcalloc_doubles(feed->n), sum = 0;
			predict_broken_share_of_classes(
			    feed, &p, settings, 77, S);
			for (size_t i = 0; i < feed->n; i++) {
				double finer =
				    i + 1 < feed->n ? feed->passing[i + 1] : 0;
				sum += S[i] * (feed->passing[i] - finer);
				assert_true(S[i] >= 0 && S[i] <= 1);
			}
			struct prediction all =
			    predict_with_model_alone(site, &p, settings, 77, 1);
			expect_near("selected", sum, all.selected, 1e-7);
			prediction_free(&all);
			free(S);
			site_free(site);
		}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(quantities_by_hand),
	    cmocka_unit_test(quantities_say_how_they_change_with_fineness),
	    cmocka_unit_test(
		the_largest_step_is_between_neighbours_of_the_list),
	    cmocka_unit_test(the_chinese_modulus_leaves_out_gravel),
	    cmocka_unit_test(an_ideal_screen_cuts_the_curve),
	    cmocka_unit_test(a_real_screen_keeps_the_mass),
	    cmocka_unit_test(a_forecast_is_what_is_predicted),
	    cmocka_unit_test(an_end_beyond_the_sieves_is_not_known),
	    cmocka_unit_test(selection_sums_to_what_breaks),
	};
	return cmocka_run_group_tests_name("quantity", tests, NULL, NULL);
}
