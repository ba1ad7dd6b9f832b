/* Blends by mass, and feeds and machines that were not measured.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/blend.h"

#include <stdlib.h>

#include "base/xalloc.h"
#include "core/model/product.h"
#include "made.h"

static void
a_blend_is_the_mean_on_all_sieves(void **state)
{
	(void)state;
	double size_a[] = {16e-3, 4e-3, 1e-3}, pass_a[] = {1, 0.5, 0.2};
	double size_b[] = {8e-3, 2e-3, 0.25e-3}, pass_b[] = {1, 0.4, 0};
	struct psd a = {3, size_a, pass_a}, b = {3, size_b, pass_b};
	double part[] = {3, 1};
	struct psd blend =
	    blend_new((const struct psd *const[]){&a, &b}, part, 2);
	/* b passes nothing below its finest sieve; a is not known there. */
	double sieve[] = {16e-3, 8e-3, 4e-3, 2e-3, 1e-3};
	double want[] = {1, (3 * 0.75 + 1) / 4, (3 * 0.5 + 0.7) / 4,
	    (3 * 0.35 + 0.4) / 4, (3 * 0.2 + 0.4 * 2 / 3) / 4};
	assert_int_equal(blend.n, 5);
	for (size_t i = 0; i < 5; i++) {
		expect_near("sieve", blend.size[i], sieve[i], 0);
		expect_near("passing", blend.passing[i], want[i], 1e-12);
	}
	psd_free(&blend);
}

/* Whatever the feeds, and in parts of any sum. */
static void
a_blend_is_a_feed(void **state)
{
	(void)state;
	struct draw draw = draw_start(72);
	for (int k = 0; k < 200; k++) {
		struct psd feed[3];
		const struct psd *all[3];
		double part[3];
		for (size_t i = 0; i < 3; i++) {
			feed[i] = made_any_feed(&draw);
			all[i] = &feed[i];
			part[i] = draw_log(&draw, 0.01, 100);
		}
		struct psd blend = blend_new(all, part, 3);
		assert_true(blend.n > 0 && blend.passing[0] == 1);
		for (size_t i = 1; i < blend.n; i++) {
			assert_true(blend.size[i] < blend.size[i - 1]);
			assert_true(
			    blend.passing[i] <= blend.passing[i - 1] + 1e-15);
			for (size_t j = 0; j < 3; j++)
				assert_true(
				    psd_covers_size(&feed[j], blend.size[i]));
		}
		psd_free(&blend);
		for (size_t i = 0; i < 3; i++)
			psd_free(&feed[i]);
	}
}

/* Eq 2 is linear in the feed: the product of a blend is the blend of the
 * products. */
static void
its_product_is_the_blend_of_products(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	struct params p = made_params(&TABLE_3[TIERP]);
	const struct psd *feed[2] = {&site->run[0].feed, &site->run[2].feed};
	double part[2] = {60, 40}, got[32], one[2][32];
	struct psd blend = blend_new(feed, part, 2);
	for (size_t k = 0; k < 3; k++) {
		const struct psd *from = k < 2 ? feed[k] : &blend;
		struct model *model = model_new(
		    from, blend.size, blend.n, model_settings_default());
		model_set_params(model, &p);
		model_compute_product(model, 74, k < 2 ? one[k] : got);
		model_free(model);
	}
	for (size_t i = 0; i < blend.n; i++)
		expect_near(
		    "passing", got[i], 0.6 * one[0][i] + 0.4 * one[1][i], 1e-6);
	psd_free(&blend);
	site_free(site);
}

/* A share led past the rotor is mixed in (D14), whether the model alone is
 * asked or has a bypass of its own; more impacts are more strength. */
static void
another_machine(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	struct params p = made_params(&TABLE_3[TIERP]), strong = p;
	const struct psd *feed = &site->run[0].feed;
	struct model_settings as = model_settings_default(), led = as,
			      twice = as;
	led.bypass = 0.25;
	twice.k = 2;
	strong.f_mat *= 2;
	const struct model_settings settings[4] = {as, led, twice, as};
	double *product[4];
	for (size_t k = 0; k < 4; k++) {
		struct model *m =
		    model_new(feed, feed->size, feed->n, settings[k]);
		product[k] = xcalloc_doubles(feed->n);
		model_set_params(m, k < 3 ? &p : &strong);
		model_compute_product(m, 77, product[k]);
		model_free(m);
	}
	for (size_t k = 0; k < feed->n; k++) {
		expect_near("led past", product[1][k],
		    0.75 * product[0][k] + 0.25 * feed->passing[k], 1e-12);
		expect_near("impacts", product[2][k], product[3][k], 1e-12);
	}
	assert_false(model_settings_are_same(&as, &led));
	for (size_t k = 0; k < 4; k++)
		free(product[k]);
	site_free(site);
}

/* D19: feeds that are the same count once, and one that ends early cuts nothing
 * off: below its end the mean falls as the other does. */
static void
the_mean_of_feeds(void **state)
{
	(void)state;
	double size_a[] = {16e-3, 4e-3, 1e-3}, pass_a[] = {1, 0.5, 0.2};
	double size_b[] = {16e-3, 4e-3, 1e-3, 0.5e-3, 0.25e-3};
	double pass_b[] = {1, 0.7, 0.4, 0.1, 0};
	struct psd a = {3, size_a, pass_a}, b = {5, size_b, pass_b};
	const struct psd *const feed[] = {&a, &b, &b};
	struct psd mean = blend_mean_of_feeds(feed, 3);
	double want[] = {1, 0.6, 0.3, 0.3 * 0.1 / 0.4, 0}, sieve;
	assert_int_equal(mean.n, 5);
	for (size_t i = 0; i < 5; i++) {
		expect_near("sieve", mean.size[i], size_b[i], 0);
		expect_near("passing", mean.passing[i], want[i], 1e-12);
	}
	expect_near("spread", blend_largest_feed_difference(feed, 3, &sieve),
	    0.2, 1e-12);
	psd_free(&mean);
	mean = blend_mean_of_feeds(&feed[1], 2);
	assert_true(psd_is_same(&mean, &b));
	expect_near(
	    "none", blend_largest_feed_difference(&feed[1], 2, &sieve), 0, 0);
	psd_free(&mean);
}

/* Whatever they are, the mean is a feed, between the least and the largest
 * where all of them tell. */
static void
the_mean_is_a_feed(void **state)
{
	(void)state;
	struct draw draw = draw_start(73);
	for (int k = 0; k < 200; k++) {
		struct psd feed[3];
		const struct psd *all[3];
		for (size_t i = 0; i < 3; i++) {
			feed[i] = made_any_feed(&draw);
			all[i] = &feed[i];
		}
		struct psd mean = blend_mean_of_feeds(all, 3);
		for (size_t i = 0; i < mean.n; i++) {
			double x = mean.size[i], least = 1, most = 0;
			bool known = true;
			for (size_t j = 0; j < 3; j++) {
				double P = psd_passing(all[j], x);
				known = known && psd_covers_size(all[j], x);
				least = fmin(least, P);
				most = fmax(most, P);
			}
			assert_true(i == 0 || mean.passing[i] <=
						  mean.passing[i - 1] + 1e-12);
			assert_true(mean.passing[i] >= 0);
			assert_true(
			    !known || (mean.passing[i] >= least - 1e-12 &&
					  mean.passing[i] <= most + 1e-12));
		}
		psd_free(&mean);
		for (size_t i = 0; i < 3; i++)
			psd_free(&feed[i]);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_blend_is_the_mean_on_all_sieves),
	    cmocka_unit_test(a_blend_is_a_feed),
	    cmocka_unit_test(its_product_is_the_blend_of_products),
	    cmocka_unit_test(another_machine),
	    cmocka_unit_test(the_mean_of_feeds),
	    cmocka_unit_test(the_mean_is_a_feed),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
