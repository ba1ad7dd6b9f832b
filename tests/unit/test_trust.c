/* The light: green where the model is right, never where it is far off, and
 * each reason where it belongs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fitted.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/posterior/ensemble.h"
#include "core/check/trust.h"

struct known {
	struct site *site;
	bool train[8], use[8];
	struct fit fit;
	struct evidence e;
};

/* Calibrated at 69 and 79 m/s, with the evidence of all runs. */
static struct known
known(struct site *site)
{
	struct known k = {.site = site, .use = {true, true, true}};
	struct calibrate_options o = quick_options(1);
	misfit_mark_default_training(site, k.train);
	k.fit = fitted(site, &o);
	struct posterior *posterior = drawn(site, &k.fit, &o, k.use);
	k.e = trust_gather_evidence(
	    site, k.train, k.use, &k.fit, &o.bounds, posterior, 0);
	posterior_free(posterior);
	return k;
}

static struct trust
asked(const struct evidence *e, struct trust_question q)
{
	struct trust t = {0};
	trust_judge_answer(&t, e, &q);
	return t;
}

static enum light
light_at(const struct evidence *e, double v)
{
	struct trust t = asked(e, (struct trust_question){.speed = v});
	enum light light = t.light;
	trust_free(&t);
	return light;
}

static bool
names(const struct trust *t, const char *words)
{
	for (size_t i = 0; i < t->n; i++)
		if (strstr(t->reason[i].text, words) != NULL)
			return true;
	return false;
}

/* Plants that follow the model: green inside, amber beyond 5 m/s, red far out.
 * One of eight may look wrong by chance. */
static void
test_right(void **state)
{
	(void)state;
	size_t green = 0;
	for (uint64_t seed = 1; seed <= 8; seed++) {
		struct known k = known(made_site(&TABLE_3[TIERP], 0.005, seed));
		green += light_at(&k.e, 74) == LIGHT_GREEN;
		assert_int_not_equal(light_at(&k.e, 90), LIGHT_GREEN);
		assert_int_equal(light_at(&k.e, 110), LIGHT_RED);
		site_free(k.site);
	}
	assert_true(green >= 7);
}

/* Products that no parameters give: finer than the model's at the fast speed,
 * coarser at the slow one, by up to a few points, smoothly along the curve. */
static void
test_wrong(void **state)
{
	(void)state;
	for (uint64_t seed = 1; seed <= 3; seed++) {
		struct site *site = made_site(&TABLE_3[TIERP], 0.003, seed);
		for (size_t r = 0; r < site->n_run; r++) {
			struct psd *product = &site->run[r].product;
			for (size_t i = 0; i < product->n; i++) {
				double P = product->passing[i];
				double x = log(product->size[i]);
				P += 0.1 * P * (1 - P) * sin(3 * x) *
				     (r == 1 ? -1 : 1);
				product->passing[i] = fmin(fmax(P, 0), 1);
			}
		}
		struct known k = known(site);
		assert_int_not_equal(light_at(&k.e, 74), LIGHT_GREEN);
		site_free(site);
	}
}

static const struct evidence SOUND = {.cells = 24,
    .parameters = 7,
    .rmse = 0.003,
    .size = 1,
    .discrepancy = 0.002,
    .sampling = 0.005,
    .more = 0.1,
    .finer = 0.05,
    .finer_sd = 0.1,
    .halves = 0.1,
    .breaks = 0.9,
    .speeds = 3,
    .slowest = 69,
    .fastest = 79};

/* Runs that were exchanged, and a fit by which all sizes break. */
static void
test_sense(void **state)
{
	(void)state;
	struct evidence sizeless = SOUND, exchanged = SOUND;
	sizeless.all_break = true;
	exchanged.against.slow = 69;
	exchanged.against.fast = 74;
	exchanged.against.order = (struct passing_order){0.06, 0.004, 0.03};
	struct trust t = asked(&sizeless, (struct trust_question){.speed = 74});
	assert_int_equal(t.light, LIGHT_AMBER);
	assert_true(names(&t, "no break size"));
	trust_free(&t);
	t = asked(&exchanged, (struct trust_question){.speed = 74});
	assert_int_equal(t.light, LIGHT_RED);
	assert_true(names(&t, "run at 74 m/s is coarser than at 69, by "
			      "6.0 points at 4"));
	trust_free(&t);
}

/* Each reason alone, its light and its words. */
static void
test_reasons(void **state)
{
	(void)state;
	struct evidence poor = SOUND, few = SOUND, slow = SOUND,
			unsettled = SOUND, lost = SOUND, bent = SOUND,
			one = SOUND;
	poor.rmse = 0.03;
	few.cells = 7;
	slow.unbounded = 0.4;
	unsettled.halves = 0.3;
	bent.finer = 0.5;
	one.fastest = one.slowest;
	lost.holdout = (struct validation){.n_sieve = 9,
	    .holdout = true,
	    .speed = 74,
	    .rmse = {0.012, 0.01, 0.004, 0.03, 0.2}};
	const struct {
		const struct evidence *e;
		struct trust_question q;
		enum light light;
		const char *words;
	} want[] = {
	    {&poor, {.speed = 74}, LIGHT_RED, "by 3.0 points"},
	    {&few, {.speed = 74}, LIGHT_RED, "7 passings cannot determine 7"},
	    {&slow, {.speed = 68}, LIGHT_AMBER, "bounded from above (40 %"},
	    {&slow, {.speed = 74}, LIGHT_GREEN, NULL},
	    {&unsettled, {.speed = 74}, LIGHT_AMBER, "30 % of its width"},
	    {&bent, {.speed = 74}, LIGHT_AMBER, "finer with energy"},
	    {&lost, {.speed = 74}, LIGHT_AMBER, "training products by 0.40"},
	    {&SOUND, {.speed = 74, .width = 0.08}, LIGHT_AMBER, "8 points"},
	    {&SOUND, {.speed = 74, .width = 0.2}, LIGHT_RED, "20 points"},
	    {&SOUND, {.speed = 74, .feed = 0.12}, LIGHT_AMBER, "12 points"},
	    {&SOUND, {.speed = 74, .bound = "f_mat", .bound_moves = 0.01},
		LIGHT_AMBER, "f_mat is at its bound"},
	    {&SOUND, {.speed = 86}, LIGHT_AMBER, "7.0 m/s beyond"},
	    {&SOUND, {.speed = 68.9}, LIGHT_AMBER, "0.1 m/s beyond"},
	    {&SOUND, {.speed = 59}, LIGHT_AMBER, "10.0 m/s beyond"},
	    {&SOUND, {.speed = 58.9}, LIGHT_RED, "which span 10.0"},
	    {&one, {.speed = 75.9}, LIGHT_AMBER, "6.9 m/s from the one speed"},
	    {&one, {.speed = 76}, LIGHT_RED, "7.0 m/s from the one speed"},
	    {&SOUND, {.speed = 69}, LIGHT_GREEN, NULL},
	    {&SOUND, {.speed = 74}, LIGHT_GREEN, NULL},
	};
	for (size_t i = 0; i < ARRAY_LEN(want); i++) {
		struct trust t = asked(want[i].e, want[i].q);
		assert_int_equal(t.light, want[i].light);
		assert_int_equal(t.n > 0, want[i].words != NULL);
		assert_true(t.n == 0 || names(&t, want[i].words));
		trust_free(&t);
	}
}

/* Products exchanged between two runs are named, where each run has its own
 * feed, too: the fit moves them to one. */
static void
test_exchanged(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.002, 1);
	struct psd product = site->run[0].product;
	assert_true(site->individual_feeds);
	struct known k = known(site);
	assert_true(k.e.against.order.most == 0);
	site->run[0].product = site->run[1].product;
	site->run[1].product = product;
	k = known(site);
	assert_true(k.e.against.order.most > 0.02);
	assert_float_equal(k.e.against.slow, 69, 1e-9);
	assert_float_equal(k.e.against.fast, 74, 1e-9);
	site_free(site);
}

/* Products equal to the feed within a point, or coarser, are no finer; one that
 * is finer at one sieve by more makes them finer.  What a fit to them does
 * wrong beside is then no reason of its own. */
static void
nothing_breaks_where_no_product_is_finer(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	assert_false(trust_are_products_like_feed(site));
	for (size_t r = 0; r < site->n_run; r++) {
		psd_free(&site->run[r].product);
		site->run[r].product = psd_copy(&site->run[r].feed);
	}
	assert_true(trust_are_products_like_feed(site));
	struct psd *one = &site->run[1].product;
	one->passing[3] += 0.009;
	one->passing[4] -= 0.05;
	assert_true(trust_are_products_like_feed(site));
	one->passing[3] += 0.002;
	assert_false(trust_are_products_like_feed(site));
	site_free(site);
	struct evidence e = SOUND;
	e.alike = 2.5;
	e.like_feed = true;
	struct trust t = asked(&e, (struct trust_question){.speed = 74});
	assert_int_equal(t.light, LIGHT_AMBER);
	assert_int_equal(t.n, 1);
	assert_true(names(&t, "not measurably finer"));
	trust_free(&t);
}

/* Two weak signs make what one does not. */
static void
test_signs(void **state)
{
	(void)state;
	struct evidence e = SOUND;
	e.size = 1.8;
	assert_int_equal(light_at(&e, 74), LIGHT_GREEN);
	e.alike = 1.5;
	assert_int_equal(light_at(&e, 74), LIGHT_AMBER);
	e.size = 1;
	assert_int_equal(light_at(&e, 74), LIGHT_GREEN);
	e.alike = 2.5;
	assert_int_equal(light_at(&e, 74), LIGHT_AMBER);
}

/* Between three measured speeds what corrects the model makes remarks of the
 * signs; beyond them, between two, and of the model alone they are reasons. */
static void
measurements_answer_between_their_speeds(void **state)
{
	(void)state;
	struct evidence wrong = SOUND, two = SOUND;
	wrong.size = two.size = 3;
	wrong.finer = two.finer = 0.5;
	two.speeds = 2;
	const struct {
		const struct evidence *e;
		double speed;
		bool corrected;
		enum light light;
	} want[] = {{&wrong, 69, true, LIGHT_GREEN},
	    {&wrong, 74, true, LIGHT_GREEN}, {&wrong, 0, true, LIGHT_GREEN},
	    {&wrong, 79.1, true, LIGHT_AMBER}, {&wrong, 74, false, LIGHT_AMBER},
	    {&wrong, 0, false, LIGHT_AMBER}, {&two, 74, true, LIGHT_AMBER}};
	for (size_t i = 0; i < ARRAY_LEN(want); i++) {
		struct trust t = asked(
		    want[i].e, (struct trust_question){.speed = want[i].speed,
				   .corrected = want[i].corrected});
		bool green = want[i].light == LIGHT_GREEN;
		assert_int_equal(t.light, want[i].light);
		assert_int_equal(t.remarks, green ? 2 : 0);
		assert_int_equal(t.n > 0, !green);
		assert_int_equal(names(&t, "sampling errors"), !green);
		trust_free(&t);
	}
}

/* The worst reason comes first, and gives the light. */
static void
test_order(void **state)
{
	(void)state;
	struct evidence e = SOUND;
	e.finer = 0.5;
	e.rmse = 0.05;
	struct trust t = asked(&e, (struct trust_question){.speed = 110});
	assert_int_equal(t.light, LIGHT_RED);
	assert_true(t.n >= 3);
	for (size_t i = 1; i < t.n; i++)
		assert_true(t.reason[i].light <= t.reason[i - 1].light);
	trust_free(&t);
	assert_int_equal(t.n, 0);
}

static void
test_feeds(void **state)
{
	(void)state;
	struct site *a = made_site(&TABLE_3[TIERP], 0.005, 1);
	struct psd *feed = &a->run[0].feed, other = psd_copy(feed);
	assert_true(trust_largest_feed_difference(feed, &other) == 0);
	other.passing[3] -= 0.07;
	assert_true(
	    fabs(trust_largest_feed_difference(feed, &other) - 0.07) < 1e-12);
	psd_free(&other);
	site_free(a);
}

/* A slower run that was sieved less finely is not finer at a sieve that it
 * lacks: a straight line there says 32 * 1 mm / 2 mm, which is too much. */
static void
a_sieve_that_a_run_lacks_proves_nothing(void **state)
{
	(void)state;
	double sieves[] = {8e-3, 2e-3, 1e-3, 0.5e-3, 0.25e-3};
	double few[] = {8e-3, 2e-3, 0.25e-3};
	double fine[] = {1, 0.34, 0.17, 0.09, 0.045}, same[] = {1, 0.32, 0.04};
	double wrong[] = {1, 0.45, 0.04};
	const struct psd fast = {.n = 5, .size = sieves, .passing = fine};
	struct psd slow = {.n = 3, .size = few, .passing = same};
	struct passing_order o = trust_compare_slow_fast_products(&slow, &fast);
	assert_true(o.most < 1e-9);
	assert_false(trust_is_product_order_wrong(&o));
	slow.passing = wrong;
	o = trust_compare_slow_fast_products(&slow, &fast);
	assert_true(trust_is_product_order_wrong(&o));
	assert_true(fabs(o.most - 0.11) < 1e-9 && o.at == 2e-3);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_sieve_that_a_run_lacks_proves_nothing),
	    cmocka_unit_test(test_right),
	    cmocka_unit_test(test_wrong),
	    cmocka_unit_test(test_reasons),
	    cmocka_unit_test(test_sense),
	    cmocka_unit_test(test_exchanged),
	    cmocka_unit_test(nothing_breaks_where_no_product_is_finer),
	    cmocka_unit_test(test_signs),
	    cmocka_unit_test(measurements_answer_between_their_speeds),
	    cmocka_unit_test(test_order),
	    cmocka_unit_test(test_feeds),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
