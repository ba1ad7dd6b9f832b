/* Eq 2: products against goldens, against plain quadrature and sums, and the
 * properties that any product has.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "golden.h"
#include "made.h"
#include "naive.h"

#include "core/model/breakage.h"
#include "core/model/product.h"

enum { SIEVES = 16 };

static struct model_settings
golden_settings(const struct golden_line *g)
{
	struct model_settings settings = model_settings_default();
	if (strcmp(g->method, "classes") == 0)
		settings.method = METHOD_CLASSES;
	if (strcmp(g->form, "progeny_mm") == 0)
		settings.appearance = APPEARANCE_PROGENY_MM;
	return settings;
}

static double
one_passing(const struct psd *feed, const struct params *p,
    struct model_settings settings, double v, double size)
{
	double passing;
	struct model *model = model_new(feed, &size, 1, settings);
	model_set_params(model, p);
	model_compute_product(model, v, &passing);
	model_free(model);
	return passing;
}

/* The goldens have six decimals of a per cent; 0.02 points are asked of
 * `continuous`, and half of the last digit holds. */
static void
products_match_the_goldens(void **state)
{
	(void)state;
	struct golden_feed feed[GOLDEN_FEEDS];
	struct golden_line g;
	size_t n = golden_feeds(feed), lines = 0;
	FILE *file = golden_open("golden-products.csv");
	for (; golden_next(file, &g); lines++) {
		size_t f = 0;
		while (f < n && strcmp(feed[f].name, g.feed) != 0)
			f++;
		assert_true(f < n);
		struct model_settings settings = golden_settings(&g);
		double pct = 100 * one_passing(&feed[f].psd, &g.p, settings,
				       g.speed, g.size_mm / 1000);
		if (!(fabs(pct - g.pct) <= 0.6e-6))
			fail_msg("%s, %s, %s, %g m/s, %g mm: %.9f is wanted, "
				 "found %.9f",
			    g.feed, g.method, g.form, g.speed, g.size_mm, g.pct,
			    pct);
	}
	fclose(file);
	assert_int_equal(n, 3);
	assert_int_equal(lines, 558);
	while (n-- > 0)
		psd_free(&feed[n].psd);
}

static struct model_settings
classes_of(enum appearance_form form)
{
	return (struct model_settings){
	    .method = METHOD_CLASSES, .appearance = form, .k = 1};
}

static struct model *
model_of(const struct psd *feed, const struct params *p,
    struct model_settings settings)
{
	struct model *model = model_new(feed, feed->size, feed->n, settings);
	model_set_params(model, p);
	return model;
}

/* The product on the feed's own sieves. */
static void
product_of(const struct psd *feed, const struct params *p,
    struct model_settings settings, double v, double *passing)
{
	struct model *model = model_of(feed, p, settings);
	model_compute_product(model, v, passing);
	model_free(model);
}

static void
classes_are_the_exact_sums(void **state)
{
	(void)state;
	struct draw draw = draw_start(31);
	double mass[SIEVES], got[SIEVES];
	for (int k = 0; k < 600; k++) {
		struct psd feed = made_any_feed(&draw);
		struct params p = made_any_params(&draw);
		enum appearance_form form = (enum appearance_form)(k % 3);
		double v = draw_between(&draw, 40, 100), finer = 0;
		naive_classes(&feed, &p, form, v, mass);
		product_of(&feed, &p, classes_of(form), v, got);
		for (size_t i = feed.n; i-- > 0;) {
			finer += mass[i];
			expect_near("passing", got[i], finer, 1e-10);
		}
		expect_near("all classes", finer, 1, 1e-12);
		psd_free(&feed);
	}
}

static void
continuous_is_the_exact_integral(void **state)
{
	(void)state;
	struct draw draw = draw_start(32);
	double want[SIEVES], got[SIEVES];
	for (int k = 0; k < 120; k++) {
		struct psd feed = made_any_feed(&draw);
		struct params p =
		    k < 19 ? made_params(&TABLE_3[k]) : made_any_params(&draw);
		double v = draw_between(&draw, 65, 85);
		naive_continuous(&feed, feed.size, feed.n, &p, v, 20000, want);
		product_of(&feed, &p, model_settings_default(), v, got);
		for (size_t i = 0; i < feed.n; i++)
			expect_near("passing", got[i], want[i], 2e-6);
		psd_free(&feed);
	}
}

/* Mass is kept, nothing grows, and a faster rotor makes nothing coarser, to the
 * error of the method's sums. */
static void
expect_product(const struct psd *feed, struct model *model, double v,
    double error, const double *slower, double *passing)
{
	model_compute_product(model, v, passing);
	expect_near("top sieve", passing[0], 1, 1e-12);
	for (size_t i = 0; i < feed->n; i++) {
		assert_true(passing[i] >= 0 && passing[i] <= 1);
		assert_true(passing[i] >= feed->passing[i] - 1e-12);
		assert_true(i == 0 || passing[i] <= passing[i - 1] + 1e-12);
		if (!(passing[i] >= slower[i] - error))
			fail_msg("at %g m/s %.17g passes, before %.17g", v,
			    passing[i], slower[i]);
	}
}

static void
faster_is_never_coarser_and_keeps_the_mass(void **state)
{
	(void)state;
	struct draw draw = draw_start(33);
	for (int k = 0; k < 400; k++) {
		struct psd feed = made_any_feed(&draw);
		struct params p = made_any_params(&draw);
		struct model_settings settings = model_settings_default();
		if (k % 4 > 0)
			settings =
			    classes_of((enum appearance_form)(k % 4 - 1));
		struct model *model = model_of(&feed, &p, settings);
		/* Rounding; `continuous` states an error of 1e-7. */
		double error = k % 4 > 0 ? 1e-13 : 1e-7;
		double passing[2][SIEVES] = {{0}}, before = 0;
		for (size_t i = 0; i < 12; i++) {
			double v = 1 + 10.3 * (double)i;
			expect_product(&feed, model, v, error, passing[i % 2],
			    passing[(i + 1) % 2]);
			double selected = model_broken_feed_share(model, v);
			assert_true(selected >= before - 1e-12);
			assert_true(selected <= 1 + 1e-12);
			before = selected;
		}
		model_free(model);
		psd_free(&feed);
	}
}

/* 0.1 m/s moves no passing by more than the exact integral does and 0.02
 * points. */
static void
the_product_does_not_jump_with_the_speed(void **state)
{
	(void)state;
	double want[2][SIEVES], got[2][SIEVES];
	for (size_t row = 0; row < ARRAY_LEN(TABLE_3); row += 3) {
		struct site *site = made_site(&TABLE_3[row], 0, 1);
		const struct psd *feed = &site->run[1].feed;
		struct params p = made_params(&TABLE_3[row]);
		struct model *model =
		    model_of(feed, &p, model_settings_default());
		for (size_t k = 0; k <= 200; k++) {
			double v = 65 + 0.1 * (double)k;
			double *now = got[k % 2], *then = got[(k + 1) % 2];
			naive_continuous(feed, feed->size, feed->n, &p, v, 3000,
			    want[k % 2]);
			model_compute_product(model, v, now);
			for (size_t i = 0; i < feed->n && k > 0; i++) {
				double moved = fabs(now[i] - then[i]);
				double exact = fabs(want[0][i] - want[1][i]);
				assert_true(moved <= exact + 2e-4);
				assert_true(now[i] >= then[i] - 1e-13);
			}
		}
		model_free(model);
		site_free(site);
	}
}

/* J times the parameter's range against central differences. */
static void
expect_jacobian(const struct psd *feed, struct params p, double v)
{
	double passing[SIEVES], up[SIEVES], down[SIEVES];
	double J[SIEVES * PARAM_COUNT];
	struct model *model = model_of(feed, &p, model_settings_default());
	model_jacobian(model, v, passing, J);
	model_compute_product(model, v, up);
	assert_memory_equal(passing, up, feed->n * sizeof *up);
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		double at = p.at[j];
		double scale = j < 4 ? 1 : fmax(at, 0.05), h = 3e-6 * scale;
		struct params q = p;
		q.at[j] = at + h;
		model_set_params(model, &q);
		model_compute_product(model, v, up);
		q.at[j] = at - h;
		model_set_params(model, &q);
		model_compute_product(model, v, down);
		for (size_t i = 0; i < feed->n; i++) {
			double slope = (up[i] - down[i]) / (2 * h);
			expect_near(PARAMS[j].name,
			    J[i * PARAM_COUNT + j] * scale, slope * scale,
			    1e-6 + 1e-5 * fabs(slope * scale));
		}
	}
	model_free(model);
}

static void
derivatives_match_differences(void **state)
{
	(void)state;
	struct draw draw = draw_start(34);
	for (int k = 0; k < 200; k++) {
		struct psd feed = made_any_feed(&draw);
		struct params p = made_params(&TABLE_3[k % 19]);
		for (size_t b = 0; b < 4; b++)
			p.beta[b] += draw_between(&draw, -1, 1);
		p.f_mat *= draw_between(&draw, 0.5, 1.5);
		expect_jacobian(&feed, p, draw_between(&draw, 65, 85));
		psd_free(&feed);
	}
}

static void
classes_have_derivatives_too(void **state)
{
	(void)state;
	struct draw draw = draw_start(35);
	double up[SIEVES], down[SIEVES], J[SIEVES * PARAM_COUNT];
	for (int k = 0; k < 40; k++) {
		struct psd feed = made_any_feed(&draw);
		struct params p = made_params(&TABLE_3[k % 19]), q = p;
		struct model *model =
		    model_of(&feed, &p, classes_of(APPEARANCE_RATIO));
		model_jacobian(model, 80, up, J);
		model_compute_product(model, 80, down);
		assert_memory_equal(up, down, feed.n * sizeof *up);
		q.f_mat = p.f_mat * 1.0001;
		product_of(&feed, &q, classes_of(APPEARANCE_RATIO), 80, up);
		q.f_mat = p.f_mat * 0.9999;
		product_of(&feed, &q, classes_of(APPEARANCE_RATIO), 80, down);
		for (size_t i = 0; i < feed.n; i++)
			expect_near("f_mat", J[i * PARAM_COUNT + PARAM_F_MAT],
			    (up[i] - down[i]) / (2e-4 * p.f_mat), 1e-6);
		model_free(model);
		psd_free(&feed);
	}
}

/* What passes a sieve does not depend on the other sieves asked for. */
static void
sieves_do_not_change_each_other(void **state)
{
	(void)state;
	struct draw draw = draw_start(36);
	for (int k = 0; k < 200; k++) {
		struct psd feed = made_any_feed(&draw);
		struct params p = made_any_params(&draw);
		struct model_settings settings = model_settings_default();
		if (k % 2 == 1)
			settings = classes_of(APPEARANCE_RATIO);
		double sieve[5], together[5];
		for (size_t i = 0; i < 5; i++)
			sieve[i] = draw_log(
			    &draw, feed.size[feed.n - 1], 2 * feed.size[0]);
		struct model *model = model_new(&feed, sieve, 5, settings);
		model_set_params(model, &p);
		model_compute_product(model, 77, together);
		for (size_t i = 0; i < 5; i++)
			expect_near("passing",
			    one_passing(&feed, &p, settings, 77, sieve[i]),
			    together[i], 1e-9);
		model_free(model);
		psd_free(&feed);
	}
}

static void
where_nothing_breaks_the_product_is_the_feed(void **state)
{
	(void)state;
	struct draw draw = draw_start(37);
	for (int k = 0; k < 200; k++) {
		struct psd feed = made_any_feed(&draw);
		struct params p = made_params(&TABLE_3[TIERP]);
		struct model_settings settings = model_settings_default();
		if (k % 2 == 1)
			settings = classes_of((enum appearance_form)(k % 3));
		if (k % 5 == 0)
			p.beta[1] = -1;
		if (k % 5 == 0)
			p.beta[3] = -1;
		if (k % 5 == 1)
			p.e0_min = 1e300;
		if (k % 5 == 2)
			p.f_mat = 0;
		if (k % 5 == 3)
			settings.k = 0;
		double passing[SIEVES];
		struct model *model = model_of(&feed, &p, settings);
		model_compute_product(model, k % 5 == 4 ? 0 : 74, passing);
		assert_true(model_is_feed_broken(model, 74) == (k % 5 != 0));
		for (size_t i = 0; i < feed.n; i++)
			expect_near(
			    "passing", passing[i], feed.passing[i], 1e-15);
		model_free(model);
		psd_free(&feed);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(products_match_the_goldens),
	    cmocka_unit_test(classes_are_the_exact_sums),
	    cmocka_unit_test(continuous_is_the_exact_integral),
	    cmocka_unit_test(faster_is_never_coarser_and_keeps_the_mass),
	    cmocka_unit_test(the_product_does_not_jump_with_the_speed),
	    cmocka_unit_test(derivatives_match_differences),
	    cmocka_unit_test(classes_have_derivatives_too),
	    cmocka_unit_test(sieves_do_not_change_each_other),
	    cmocka_unit_test(where_nothing_breaks_the_product_is_the_feed),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
