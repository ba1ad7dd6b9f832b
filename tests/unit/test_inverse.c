/* The inverse of a prediction: the product at the speed found is the one that
 * was wanted, and envelopes are met or missed as a scan over the speeds says.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/inverse.h"

#include <stdlib.h>

#include "core/predict.h"
#include "made.h"

enum { SIEVES = 5 };
static const double SIEVE[SIEVES] = {8e-3, 4.75e-3, 2e-3, 0.5e-3, 0.125e-3};

/* Inverse of a row of Table 3 on its first feed; the site is the caller's. */
static struct inverse
inverse_of(const struct site *site, size_t row)
{
	struct params p = made_params(&TABLE_3[row]);
	return inverse_new(&site->run[0].feed, SIEVE, SIEVES, &p,
	    model_settings_default(), NULL);
}

struct target {
	struct inverse *inverse;
	size_t sieve;
	double passing;
};

static double
over(void *data, double v)
{
	struct target *t = data;
	return inverse_at(t->inverse, v)->passing[t->sieve] - t->passing;
}

static void
a_speed_is_found_again_from_its_product(void **state)
{
	(void)state;
	for (size_t row = 0; row < 19; row++) {
		struct site *site = made_site(&TABLE_3[row], 0, 1);
		struct inverse inverse = inverse_of(site, row);
		for (double v = 66; v < 85; v += 3.7) {
			struct target t = {
			    &inverse, 2, inverse_at(&inverse, v)->passing[2]};
			double below = over(&t, v - 0.5);
			double found = inverse_speed(over, &t, 65, 85);
			/* Where nothing breaks the speed cannot be told. */
			if (below < -1e-6)
				expect_near("speed", found, v, 1e-6);
			else
				assert_true(found <= v);
		}
		inverse_free(&inverse);
		site_free(site);
	}
}

static void
what_no_speed_gives_is_not_found(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	struct inverse inverse = inverse_of(site, TIERP);
	struct target t = {&inverse, 1, 0.999};
	assert_true(isinf(inverse_speed(over, &t, 65, 85)));
	t.passing = 0.01;
	assert_true(inverse_speed(over, &t, 65, 85) == 65);
	inverse_free(&inverse);
	site_free(site);
}

/* By how much the worst limit is missed, plainly. */
static double
missed(const struct psd *product, const struct envelope *e)
{
	double most = 0;
	for (size_t i = 0; i < product->n; i++) {
		if (product->passing[i] < e->least[i])
			most = fmax(most, e->least[i] - product->passing[i]);
		if (product->passing[i] > e->most[i])
			most = fmax(most, product->passing[i] - e->most[i]);
	}
	return most;
}

static void
check_window(struct inverse *inverse, const struct envelope *e)
{
	struct window w = inverse_window(inverse, e, 65, 85);
	bool any = false;
	double least = INFINITY;
	for (double v = 65; v <= 85; v += 0.01) {
		double by = missed(inverse_at(inverse, v), e);
		any = any || by == 0;
		least = fmin(least, by);
		if (w.inside && v > w.slowest && v < w.fastest)
			assert_true(by < 1e-8);
		else if (w.inside &&
			 (v < w.slowest - 1e-6 || v > w.fastest + 1e-6))
			assert_true(by > 0);
	}
	/* Between two steps of the scan there may be a narrow window. */
	assert_true(w.inside || !any);
	if (w.inside)
		return;
	size_t worst;
	assert_true(fabs(w.by) <= least + 1e-9 && fabs(w.by) > 0);
	expect_near(
	    "by", inverse_outside(inverse, e, w.nearest, &worst), w.by, 0);
	assert_int_equal(worst, w.worst);
	assert_true(w.nearest >= 65 && w.nearest <= 85);
}

static void
windows_are_those_of_a_scan(void **state)
{
	(void)state;
	struct draw draw = draw_start(5);
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	struct inverse inverse = inverse_of(site, TIERP);
	for (size_t n = 0; n < 40; n++) {
		double least[SIEVES], most[SIEVES];
		const struct psd *at =
		    inverse_at(&inverse, draw_between(&draw, 60, 90));
		for (size_t i = 0; i < SIEVES; i++) {
			double p = at->passing[i];
			least[i] = p - draw_between(&draw, -0.01, 0.05);
			most[i] = p + draw_between(&draw, -0.01, 0.05);
			if (draw_between(&draw, 0, 1) < 0.2)
				least[i] = NAN;
			if (draw_between(&draw, 0, 1) < 0.2)
				most[i] = NAN;
			if (least[i] > most[i])
				least[i] = most[i];
		}
		check_window(&inverse, &(struct envelope){least, most});
	}
	inverse_free(&inverse);
	site_free(site);
}

static void
no_limits_are_always_met(void **state)
{
	(void)state;
	double none[SIEVES] = {NAN, NAN, NAN, NAN, NAN};
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	struct inverse inverse = inverse_of(site, TIERP);
	struct window w =
	    inverse_window(&inverse, &(struct envelope){none, none}, 65, 85);
	assert_true(w.inside && w.slowest == 65 && w.fastest == 85);
	inverse_free(&inverse);
	site_free(site);
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
			double *S = xdoubles(feed->n), sum = 0;
			predict_selection(feed, &p, settings, 77, S);
			for (size_t i = 0; i < feed->n; i++) {
				double finer =
				    i + 1 < feed->n ? feed->passing[i + 1] : 0;
				sum += S[i] * (feed->passing[i] - finer);
				assert_true(S[i] >= 0 && S[i] <= 1);
			}
			struct prediction all =
			    predict(site, &p, settings, 77, 1);
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
	    cmocka_unit_test(a_speed_is_found_again_from_its_product),
	    cmocka_unit_test(what_no_speed_gives_is_not_found),
	    cmocka_unit_test(windows_are_those_of_a_scan),
	    cmocka_unit_test(no_limits_are_always_met),
	    cmocka_unit_test(selection_sums_to_what_breaks),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
