/* The ledger of mass: it closes, and it adds up to the product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/mass_balance.h"

#include "core/answer/predict.h"
#include "made.h"

static double
sum_of(const double *value, size_t n)
{
	double sum = 0;
	for (size_t i = 0; i < n; i++)
		sum += value[i];
	return sum;
}

/* Class by class and in all, to arithmetic; nothing is below 0. */
static void
expect_closed(const struct mass_balance *l)
{
	for (size_t i = 0; i < l->n; i++) {
		double stays = l->unbroken[i] + l->within[i];
		expect_near("feed", stays + l->left[i], l->feed[i], 1e-12);
		expect_near(
		    "product", stays + l->arrived[i], l->product[i], 1e-12);
		assert_true(l->unbroken[i] >= 0 && l->within[i] >= -1e-9);
		assert_true(l->left[i] >= -1e-9 && l->arrived[i] >= -1e-9);
	}
	expect_near("all feed", sum_of(l->feed, l->n), 1, 1e-12);
	expect_near("all product", sum_of(l->product, l->n), 1, 1e-9);
	expect_near("left is what arrived", sum_of(l->left, l->n),
	    sum_of(l->arrived, l->n), 1e-9);
	expect_near("broken", l->broken, 1 - sum_of(l->unbroken, l->n), 1e-12);
}

/* The classes' own ways add up to that of the whole feed. */
static void
expect_product(const struct psd *feed, const struct params *p,
    struct model_settings settings, double v, double error)
{
	struct mass_balance l = mass_balance_new(feed, p, settings, v);
	double passing[32], finer = 0;
	struct model *model = model_new(feed, feed->size, feed->n, settings);
	model_set_params(model, p);
	model_compute_product(model, v, passing);
	expect_near(
	    "broken", l.broken, model_broken_feed_share(model, v), error);
	model_free(model);
	expect_closed(&l);
	for (size_t i = feed->n; i-- > 0;) {
		finer += l.product[i];
		expect_near("passing", finer, passing[i], error);
	}
	mass_balance_free(&l);
}

static void
it_closes_and_adds_up_to_the_product(void **state)
{
	(void)state;
	struct draw draw = draw_start(71);
	for (int k = 0; k < 60; k++) {
		struct psd feed = made_any_feed(&draw);
		struct params p =
		    k < 19 ? made_params(&TABLE_3[k]) : made_any_params(&draw);
		double v = draw_between(&draw, 50, 95);
		struct model_settings settings = model_settings_default();
		settings.bypass = k % 3 == 0 ? 0.1 : 0;
		expect_product(&feed, &p, settings, v, 2e-6);
		settings.method = METHOD_CLASSES;
		expect_product(&feed, &p, settings, v, 1e-9);
		psd_free(&feed);
	}
}

/* All of one class breaks (S is 1 to 1e-12) into halves and finer by B = u: of
 * 8 to 16 mm what arrives in a class can be worked out by hand. */
static void
a_case_by_hand(void **state)
{
	(void)state;
	double size[] = {16e-3, 8e-3, 4e-3, 2e-3}, passing[] = {1, 0, 0, 0};
	struct psd feed = {4, size, passing};
	struct params p = params_start_values(0);
	p.beta[0] = 0;
	p.beta[1] = 1;
	p.beta[2] = p.beta[3] = 0;
	p.f_mat = 1000;
	p.e0_min = 0;
	p.alpha = 0;
	struct mass_balance l =
	    mass_balance_new(&feed, &p, model_settings_default(), 70);
	/* dB / d ln u = u: finer than y of what is spread evenly over ln x from
	 * 8 to 16 mm are y (1/8 - 1/16) / ln 2. */
	double below_8 = 8 * (1 / 8.0 - 1 / 16.0) / log(2);
	expect_near("broken", l.broken, 1, 1e-9);
	expect_near("within", l.within[0], 1 - below_8, 1e-3);
	expect_near("left", l.left[0], below_8, 1e-3);
	expect_near("4 to 8 mm", l.arrived[1], below_8 / 2, 1e-3);
	expect_near("2 to 4 mm", l.arrived[2], below_8 / 4, 1e-3);
	expect_near("pan", l.arrived[3], below_8 / 4, 1e-3);
	expect_closed(&l);
	mass_balance_free(&l);
}

static void
a_faster_rotor_leaves_less_unbroken(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	struct params p = made_params(&TABLE_3[TIERP]);
	const struct psd *feed = &site->run[0].feed;
	struct mass_balance slow =
	    mass_balance_new(feed, &p, model_settings_default(), 69);
	struct mass_balance fast =
	    mass_balance_new(feed, &p, model_settings_default(), 79);
	double change = 0;
	for (size_t i = 0; i < slow.n; i++) {
		assert_true(fast.unbroken[i] <= slow.unbroken[i] + 1e-12);
		change += fast.product[i] - slow.product[i];
	}
	expect_near("changes", change, 0, 1e-9);
	assert_true(fast.broken > slow.broken);
	assert_int_equal(
	    mass_balance_largest_class(fast.feed, slow.feed, slow.n), 0);
	size_t most = mass_balance_largest_class(fast.left, slow.left, slow.n);
	for (size_t i = 0; i < slow.n; i++)
		assert_true(fast.left[i] - slow.left[i] <=
			    fast.left[most] - slow.left[most]);
	mass_balance_free(&slow);
	mass_balance_free(&fast);
	site_free(site);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(it_closes_and_adds_up_to_the_product),
	    cmocka_unit_test(a_case_by_hand),
	    cmocka_unit_test(a_faster_rotor_leaves_less_unbroken),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
