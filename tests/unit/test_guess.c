/* The guess: which materials are nearest, what comes of them, and what such
 * guesses are worth.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "made.h"
#include "rules.h"

#include "core/answer/guess.h"
#include "core/answer/predict.h"

enum { N = 19, UBBARP = 0, OSSJO = 5, GAVLE_4 = 9, GAVLE = 10, GAVLE_2 = 11 };
enum { KALLERED = 12, ENHORNA = 13, FORSBY = 16, KIRUNA = 17, GASGRUVAN = 18 };

static const char *const ROCKS[N] = {"Diabase", "Diorite", "Dolomite", "Gneiss",
    "Gneiss", "Gneiss", "Gneissic Granite", "Gneissic Granite", "Granite",
    "Granite", "Granite", "Granite", "Granite", "Granitic Gneiss", "Granitoid",
    "Granodiorite", "Limestone", "Porphyry", "Quartzite"};

struct table {
	struct guess_material m[N];
	bool leave_out[N];
	size_t pick[N];
};

static int
fill(void **state)
{
	struct table *t = xcalloc(1, sizeof *t);
	for (size_t i = 0; i < N; i++)
		t->m[i] = (struct guess_material){TABLE_3[i].site, ROCKS[i],
		    TABLE_3[i].top_mm / 1000, made_params(&TABLE_3[i]),
		    model_settings_default(), false};
	*state = t;
	return 0;
}

static int
drop(void **state)
{
	free(*state);
	return 0;
}

static size_t
nearest(struct table *t, const char *rock, double top_mm, size_t most)
{
	struct guess_material wanted = {
	    .site = "", .rock = rock, .top_size = top_mm / 1000};
	return guess_find_nearest_materials(
	    t->m, N, &wanted, t->leave_out, most, t->pick);
}

static void
expect_picks(struct table *t, size_t got, const size_t *want, size_t n)
{
	assert_int_equal(got, n);
	for (size_t i = 0; i < n; i++)
		assert_int_equal(t->pick[i], want[i]);
}

static void
the_rock_comes_before_the_size(void **state)
{
	struct table *t = *state;
	const size_t granite[] = {TIERP, GAVLE, GAVLE_2, KALLERED, GAVLE_4};
	expect_picks(t, nearest(t, "granite", 11.2, 5), granite, 5);
	/* ln(16/7) is .83, ln(11.2/7) .47, ln(7/4) .56. */
	const size_t at_7[] = {TIERP, GAVLE, GAVLE_2, GAVLE_4, KALLERED};
	expect_picks(t, nearest(t, "GRANITE", 7, 5), at_7, 5);
	const size_t porphyry[] = {KIRUNA, 14, 1};
	expect_picks(t, nearest(t, "porphyry", 10, 3), porphyry, 3);
	const size_t no_rock[] = {OSSJO, GAVLE_4};
	expect_picks(t, nearest(t, "", 4, 2), no_rock, 2);
	const size_t no_size[] = {16, UBBARP, 1};
	expect_picks(t, nearest(t, "limestone", 0, 3), no_size, 3);
}

static void
twins_count_once(void **state)
{
	struct table *t = *state;
	const size_t diabase[] = {UBBARP, 3, 4, ENHORNA, FORSBY};
	expect_picks(t, nearest(t, "Diabase", 19, 5), diabase, 5);
	const size_t quartzite[] = {GASGRUVAN, 3, 4, ENHORNA, FORSBY};
	expect_picks(t, nearest(t, "Quartzite", 19, 5), quartzite, 5);
	assert_int_equal(nearest(t, "Quartzite", 19, N), 18);
	t->leave_out[UBBARP] = t->leave_out[GASGRUVAN] = true;
	assert_int_equal(nearest(t, "Quartzite", 19, N), 17);
	/* Other settings make other products of the same parameters. */
	t->leave_out[UBBARP] = t->leave_out[GASGRUVAN] = false;
	t->m[GASGRUVAN].settings.method = METHOD_CLASSES;
	assert_int_equal(nearest(t, "Quartzite", 19, N), 19);
}

/* Of a rock and top size that occur once: the product of that material. */
static void
one_material_gives_its_own_product(void **state)
{
	struct table *t = *state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 9);
	assert_int_equal(nearest(t, "Porphyry", 10, 1), 1);
	struct guess guess =
	    guess_psd_from_materials(site, 1, t->m, t->pick, 1, 74);
	struct prediction p = predict_with_model_alone(
	    site, &t->m[KIRUNA].params, t->m[KIRUNA].settings, 74, 1);
	assert_int_equal(guess.median.n, p.product.n);
	for (size_t i = 0; i < p.product.n; i++) {
		assert_true(guess.median.size[i] == p.product.size[i]);
		assert_true(guess.median.passing[i] == p.product.passing[i]);
		assert_true(guess.low.passing[i] == p.product.passing[i]);
		assert_true(guess.high.passing[i] == p.product.passing[i]);
	}
	assert_true(
	    guess.size[1].middle == p.p50 && guess.size[1].low == p.p50);
	assert_true(guess.size[PSD_SIZES].high == p.break_size);
	prediction_free(&p);
	guess_free(&guess);
	site_free(site);
}

static int
rising(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

static void
the_median_lies_within_the_spread(void **state)
{
	struct table *t = *state;
	struct site *site = made_site(&TABLE_3[TIERP], 0, 9);
	for (size_t n = 2; n <= 5; n++) {
		nearest(t, "Granite", 11.2, n);
		struct guess g =
		    guess_psd_from_materials(site, 0, t->m, t->pick, n, 70);
		struct prediction p[5];
		for (size_t i = 0; i < n; i++)
			p[i] = predict_with_model_alone(site,
			    &t->m[t->pick[i]].params, model_settings_default(),
			    70, 0);
		for (size_t s = 0; s < g.median.n; s++) {
			double v[5];
			for (size_t i = 0; i < n; i++)
				v[i] = p[i].product.passing[s];
			qsort(v, n, sizeof *v, rising);
			double middle = 0.5 * (v[(n - 1) / 2] + v[n / 2]);
			assert_true(g.low.passing[s] == v[0]);
			assert_true(g.high.passing[s] == v[n - 1]);
			expect_near(
			    "median", g.median.passing[s], middle, 1e-15);
		}
		assert_true(keeps_rules(&g.median));
		assert_true(g.size[1].low <= g.size[1].middle);
		assert_true(g.size[1].middle <= g.size[1].high);
		for (size_t i = 0; i < n; i++)
			prediction_free(&p[i]);
		guess_free(&g);
	}
	site_free(site);
}

/* A P20 below the finest sieve of one material has no number for its low. */
static void
sizes_below_the_sieves_are_told(void **state)
{
	struct table *t = *state;
	struct site *site = site_new(1);
	site->run[0].feed = psd_new(3);
	const double size[3] = {22.4e-3, 11.2e-3, 1e-3};
	const double passing[3] = {1, 0.9, 0.19};
	memcpy(site->run[0].feed.size, size, sizeof size);
	memcpy(site->run[0].feed.passing, passing, sizeof passing);
	nearest(t, "Granite", 11.2, 3);
	struct guess g =
	    guess_psd_from_materials(site, 0, t->m, t->pick, 3, 79);
	assert_true(isnan(g.size[0].low) && isnan(g.size[0].high));
	assert_true(isfinite(g.size[2].low) && isfinite(g.size[2].high));
	guess_free(&g);
	site_free(site);
}

/* A rock with coarse or with fine progeny, as strong as the others: the band
 * holds it where their beta is open, and not where all have the default. */
static void
an_open_beta_is_in_the_band(void **state)
{
	struct table *t = *state;
	const double fine[4] = {0.1, 1, -1, 0.5}, coarse[4] = {0, 0.7, 0.7, 0};
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	size_t n = nearest(t, "Granite", 11.2, N);
	for (size_t q = 0; q < 2; q++) {
		struct params params = made_params(&TABLE_3[TIERP]);
		memcpy(params.beta, q == 0 ? fine : coarse, sizeof fine);
		struct prediction p = predict_with_model_alone(
		    site, &params, model_settings_default(), 74, 0);
		size_t held[2] = {0};
		for (size_t open = 0; open < 2; open++) {
			for (size_t i = 0; i < N; i++)
				t->m[i].law_open = open == 1;
			struct guess g = guess_psd_from_materials(
			    site, 0, t->m, t->pick, n, 74);
			for (size_t i = 0; i < p.product.n; i++)
				held[open] += p.product.passing[i] >=
						  g.low.passing[i] - 1e-9 &&
					      p.product.passing[i] <=
						  g.high.passing[i] + 1e-9;
			guess_free(&g);
		}
		assert_true(held[1] == p.product.n && held[0] < held[1]);
		prediction_free(&p);
	}
	site_free(site);
}

/* Two sites of one rock are guessed from each other: the error is known. */
static void
leaving_one_out_errs_by_the_difference(void **state)
{
	struct table *t = *state;
	struct guess_material two[3] = {t->m[TIERP], t->m[GAVLE], t->m[TIERP]};
	two[2].site = "Twin";
	const double speed = 74;
	struct guess_error e = guess_leave_one_out_error(two, 3, 5, speed);
	struct synth synth = {.top_size = 11.2e-3,
	    .params = two[0].params,
	    .n = 1,
	    .n_speed = 1,
	    .speed = &speed};
	struct site *site = synth_make_site(&synth);
	struct prediction a = predict_with_model_alone(
	    site, &two[0].params, two[0].settings, speed, 0);
	struct prediction b = predict_with_model_alone(
	    site, &two[1].params, two[1].settings, speed, 0);
	double want = psd_rms_difference(
	    a.product.passing, b.product.passing, a.product.n, NULL);
	assert_true(want > 0.01);
	assert_int_equal(e.n, 2);
	expect_near("median", e.median, want, 1e-12);
	expect_near("worst", e.worst, want, 1e-12);
	prediction_free(&a);
	prediction_free(&b);
	site_free(site);
}

/* No site is guessed from itself: not Gavle from another Gavle either. */
static void
a_site_is_not_guessed_from_itself(void **state)
{
	struct table *t = *state;
	struct guess_material gavle[3] = {
	    t->m[GAVLE], t->m[GAVLE_2], t->m[GAVLE_4]};
	struct guess_error e = guess_leave_one_out_error(gavle, 3, 5, 74);
	assert_int_equal(e.n, 0);
	e = guess_leave_one_out_error(t->m, N, 5, 74);
	assert_int_equal(e.n, 18);
	assert_true(e.median < e.worst && e.worst < e.feed);
}

/* Of the passings of sites left out, at each of these speeds and in all; of 5
 * nearest materials the least and the most hold two thirds at best. */
static void
the_band_holds_four_of_five_left_out(void **state)
{
	struct table *t = *state;
	double all = 0, five = 0;
	for (double v = 65; v <= 85; v += 4) {
		double held = guess_leave_one_out_error(t->m, N, N, v).held;
		if (!(held >= 0.75 && held <= 0.9))
			fail_msg("%g m/s: the band held %.3f", v, held);
		all += held / 6;
		five += guess_leave_one_out_error(t->m, N, 5, v).held / 6;
	}
	print_message("# the band held %.1f %%, of 5 nearest %.1f %%\n",
	    100 * all, 100 * five);
	expect_near("held", all, 0.82, 0.05);
	assert_true(five < 0.7);
}

/* In Table 3 the rock tells nothing; where it tells all, the nearest are used.
 */
static void
the_nearest_are_used_where_that_helps(void **state)
{
	struct table *t = *state;
	struct guess_choice c = guess_choose_neighbour_count(t->m, N, 74);
	assert_false(c.helps);
	assert_int_equal(c.all.nearest, N);
	assert_true(c.few.nearest < N);
	for (size_t i = 0; i < N; i++) {
		bool soft = i % 2 == 0;
		t->m[i].rock = soft ? "soft" : "hard";
		t->m[i].top_size = 11.2e-3;
		t->m[i].params.f_mat = soft ? 2 : 0.2 + 0.001 * (double)i;
		t->m[i].params.e0_min = (soft ? 14 : 24) + 0.01 * (double)i;
		t->m[i].params.alpha = 0.95;
	}
	c = guess_choose_neighbour_count(t->m, N, 74);
	assert_true(c.helps && c.few.nearest < 10);
	assert_true(c.few.median < 0.2 * c.all.median);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_setup_teardown(
		the_rock_comes_before_the_size, fill, drop),
	    cmocka_unit_test_setup_teardown(twins_count_once, fill, drop),
	    cmocka_unit_test_setup_teardown(
		one_material_gives_its_own_product, fill, drop),
	    cmocka_unit_test_setup_teardown(
		the_median_lies_within_the_spread, fill, drop),
	    cmocka_unit_test_setup_teardown(
		sizes_below_the_sieves_are_told, fill, drop),
	    cmocka_unit_test_setup_teardown(
		leaving_one_out_errs_by_the_difference, fill, drop),
	    cmocka_unit_test_setup_teardown(
		an_open_beta_is_in_the_band, fill, drop),
	    cmocka_unit_test_setup_teardown(
		a_site_is_not_guessed_from_itself, fill, drop),
	    cmocka_unit_test_setup_teardown(
		the_band_holds_four_of_five_left_out, fill, drop),
	    cmocka_unit_test_setup_teardown(
		the_nearest_are_used_where_that_helps, fill, drop),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
