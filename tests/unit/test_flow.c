/* Flows: circuits worked out by hand, balances, what the classes of a crusher
 * add up to, and power.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/circuit.h"

#include <stdlib.h>

#include "core/posterior/ensemble.h"
#include "core/answer/power.h"
#include "core/answer/predict.h"
#include "fitted.h"

/* A crusher that breaks nothing at all, on so many classes. */
static struct transfer *
still(const double *size, size_t n)
{
	struct params p = made_params(&TABLE_3[TIERP]);
	p.f_mat = 0;
	struct crusher *c =
	    crusher_new(size, n, &p, model_settings_default(), NULL);
	struct transfer *t = crusher_transfer_at_speed(c, 74);
	crusher_free(c);
	return t;
}

/* feed -> split a 60, b 40; a -> stockpile; b -> screen at 4 mm over c, under d;
 * c and d -> stockpiles.  Feed 100 t/h: 50 % in 4..8 mm, 30 % in 2..4 mm, 20 %
 * below.  By hand: a 60; b 40, of which c = 20 and d = 20. */
static void
a_circuit_without_a_loop_is_what_a_pencil_says(void **state)
{
	(void)state;
	const double size[3] = {0.008, 0.004, 0.002}, feed[3] = {0.5, 0.3, 0.2};
	struct circuit *c = circuit_new();
	/* Not in the order of the flow. */
	static const char *const PILES[] = {"c", "a", "d"};
	for (size_t i = 0; i < 3; i++) {
		struct unit *pile =
		    circuit_add_unit(c, UNIT_STOCKPILE, PILES[i]);
		pile->n_in = 1;
		pile->in[0] = circuit_find_or_add_stream(c, PILES[i]);
	}
	struct unit *screen = circuit_add_unit(c, UNIT_SCREEN, "");
	screen->opening = 0.004;
	screen->n_in = 1;
	screen->in[0] = circuit_find_or_add_stream(c, "b");
	screen->n_out = 2;
	screen->out[0] = circuit_find_or_add_stream(c, "c");
	screen->out[1] = circuit_find_or_add_stream(c, "d");
	struct unit *split = circuit_add_unit(c, UNIT_SPLIT, "");
	split->n_in = 1;
	split->in[0] = circuit_find_or_add_stream(c, "new");
	split->n_out = 2;
	split->out[0] = circuit_find_or_add_stream(c, "a");
	split->out[1] = circuit_find_or_add_stream(c, "b");
	split->share[0] = 0.6;
	split->share[1] = 0.4;
	struct unit *new = circuit_add_unit(c, UNIT_FEED, "");
	new->n_out = 1;
	new->out[0] = circuit_find_or_add_stream(c, "new");
	c->tph = 100;
	assert_int_equal(circuit_find_unfed_unit(c), c->n_unit);
	assert_int_equal(circuit_find_trapped_stream(c), c->n_stream);
	struct flow f = circuit_compute_flow(c, feed, size, 3, NULL);
	static const struct {
		const char *name;
		double tph;
	} BY_HAND[] = {{"a", 60}, {"b", 40}, {"c", 20}, {"d", 20}};
	for (size_t i = 0; i < ARRAY_LEN(BY_HAND); i++)
		expect_near(BY_HAND[i].name,
		    f.tph[circuit_find_or_add_stream(c, BY_HAND[i].name)],
		    BY_HAND[i].tph, 1e-12);
	expect_near("balance", f.balance, 0, 1e-9);
	assert_true(f.circulating == 0 && !f.open);
	flow_free(&f);
	circuit_free(c);
}

/* new + back -> crusher -> split back r, product. */
static struct circuit *
loop(double r)
{
	struct circuit *c = circuit_new();
	size_t new = circuit_find_or_add_stream(c, "new"),
	       back = circuit_find_or_add_stream(c, "back"),
	       out = circuit_find_or_add_stream(c, "crushed"),
	       product = circuit_find_or_add_stream(c, "product");
	struct unit *u = circuit_add_unit(c, UNIT_FEED, "");
	u->n_out = 1;
	u->out[0] = new;
	u = circuit_add_unit(c, UNIT_CRUSHER, "");
	u->n_in = 2;
	u->in[0] = new;
	u->in[1] = back;
	u->n_out = 1;
	u->out[0] = out;
	u = circuit_add_unit(c, UNIT_SPLIT, "");
	u->n_in = 1;
	u->in[0] = out;
	u->n_out = 2;
	u->out[0] = back;
	u->out[1] = product;
	u->share[0] = r;
	u->share[1] = 1 - r;
	u = circuit_add_unit(c, UNIT_STOCKPILE, "");
	u->n_in = 1;
	u->in[0] = product;
	c->tph = 120;
	return c;
}

/* 30 % of what the crusher gives goes back: the geometric series
 * 120 (0.3 + 0.09 + ..) = 120 0.3 / 0.7 = 51.428571.. circulates, 171.428571..
 * go into the crusher, 120 come out. */
static void
a_loop_is_a_geometric_series(void **state)
{
	(void)state;
	const double size[2] = {0.008, 0.004}, feed[2] = {0.75, 0.25};
	struct transfer *t = still(size, 2);
	struct transfer *const of[4] = {NULL, t, NULL, NULL};
	struct circuit *c = loop(0.3);
	struct flow f = circuit_compute_flow(c, feed, size, 2, of);
	expect_near("circulates", f.circulating, 120 * 0.3 / 0.7, 1e-9);
	expect_near(
	    "crusher", flow_tph_into_unit(&f, &c->unit[1]), 120 / 0.7, 1e-9);
	expect_near("product", f.tph[3], 120, 1e-9);
	expect_near("balance", f.balance, 0, 1e-9);
	assert_true(f.back[1] && !f.back[0] && !f.back[2] && !f.open);
	flow_free(&f);
	circuit_free(c);
	transfer_free(t);
}

/* At 97 % 33.3 times the feed circulates and is found; at 99 % the passes do
 * not suffice, and nothing says otherwise. */
static void
a_loop_that_hardly_empties_is_left_open(void **state)
{
	(void)state;
	const double size[2] = {0.008, 0.004}, feed[2] = {0.75, 0.25};
	struct transfer *t = still(size, 2);
	struct transfer *const of[4] = {NULL, t, NULL, NULL};
	struct circuit *c = loop(0.97);
	struct flow f = circuit_compute_flow(c, feed, size, 2, of);
	assert_false(f.open);
	expect_near("97 %", f.circulating, 120 * 0.97 / 0.03, 1e-7);
	expect_near("its balance", f.balance, 0, 1e-9);
	flow_free(&f);
	circuit_free(c);
	c = loop(0.99);
	f = circuit_compute_flow(c, feed, size, 2, of);
	assert_true(f.open);
	flow_free(&f);
	circuit_free(c);
	transfer_free(t);
}

/* What comes back of a crusher by a screen, which breaks as it does: the coarse
 * class is broken by half into the fine one each time, so that of 100 t/h coarse
 * feed 50 + 25 + .. = 100 t/h circulate.  The half is made by a cascade of 50 %
 * around a crusher that breaks all. */
static void
oversize_that_breaks_by_half_circulates_once(void **state)
{
	(void)state;
	const double size[3] = {0.008, 0.004, 0.002};
	const double feed[3] = {1, 0, 0};
	struct circuit *c = loop(0.5);
	struct unit *screen = &c->unit[2];
	screen->kind = UNIT_SCREEN;
	screen->opening = 0.004;
	c->unit[1].cascade = 0.5;
	c->tph = 100;
	/* All that meets the rotor comes out below 4 mm. */
	struct params p = made_params(&TABLE_3[TIERP]);
	p.f_mat = 1e4;
	p.e0_min = 0;
	struct crusher *crusher =
	    crusher_new(size, 3, &p, model_settings_default(), NULL);
	struct transfer *t = crusher_transfer_at_speed(crusher, 85);
	struct transfer *const of[4] = {NULL, t, NULL, NULL};
	double product[3];
	transfer_compute_product(t, 0, feed, product);
	double stays = product[0];
	struct flow f = circuit_compute_flow(c, feed, size, 3, of);
	/* With `stays` of it left by the rotor, (1 + stays) / 2 goes back. */
	double r = (1 + stays) / 2;
	expect_near("circulates", f.circulating, 100 * r / (1 - r), 1e-7);
	expect_near("balance", f.balance, 0, 1e-9);
	flow_free(&f);
	circuit_free(c);
	transfer_free(t);
	crusher_free(crusher);
}

static void
what_is_not_fed_and_what_never_leaves_is_found(void **state)
{
	(void)state;
	struct circuit *c = loop(0.5);
	/* A ring of its own that nothing feeds, and nothing leaves. */
	struct unit *u = circuit_add_unit(c, UNIT_CRUSHER, "");
	u->n_in = u->n_out = 1;
	u->in[0] = u->out[0] = circuit_find_or_add_stream(c, "ring");
	assert_int_equal(circuit_find_unfed_unit(c), 4);
	assert_int_equal(circuit_find_trapped_stream(c),
	    circuit_find_or_add_stream(c, "ring"));
	assert_int_equal(circuit_destination_of_stream(
			     c, circuit_find_or_add_stream(c, "ring")),
	    4);
	circuit_free(c);
}

/* The model is linear in the feed: its classes' products add up to that of the
 * whole. */
static void
classes_add_up_to_the_product_of_the_feed(void **state)
{
	(void)state;
	for (size_t row = 0; row < 19; row++) {
		struct site *site = made_site(&TABLE_3[row], 0, 1);
		const struct psd *feed = &site->run[0].feed;
		struct psd sizes = predict_list_table_sieves(site, feed);
		struct params p = made_params(&TABLE_3[row]);
		struct crusher *c = crusher_new(
		    sizes.size, sizes.n, &p, model_settings_default(), NULL);
		struct transfer *t = crusher_transfer_at_speed(c, 74);
		struct prediction whole = predict_with_model_alone(
		    site, &p, model_settings_default(), 74, 0);
		double *in = xcalloc_doubles(sizes.n),
		       *out = xcalloc_doubles(sizes.n);
		double below = 0;
		crusher_class_masses_of_feed(c, feed, in);
		transfer_compute_product(t, 0, in, out);
		for (size_t i = sizes.n; i-- > 0;) {
			below += out[i];
			expect_near("passing", below,
			    psd_passing(&whole.curve, sizes.size[i]), 2e-7);
		}
		free(in);
		free(out);
		prediction_free(&whole);
		transfer_free(t);
		crusher_free(c);
		psd_free(&sizes);
		site_free(site);
	}
}

/* Tierp, calibrated, with draws. */
static struct posterior *
posterior_of(const struct site *site, struct fit *fit)
{
	bool use[8] = {true, false, true};
	struct calibrate_options o = quick_options(1);
	*fit = fitted(site, &o);
	return drawn(site, fit, &o, use);
}

/* At the sieves each draw's product of the feed's classes is that of the feed,
 * P [sieves.n][draws]. */
static void
expect_products(struct transfer *t, const double *in, const struct psd *sizes,
    const struct psd *sieves, const double *P)
{
	enum { D = POSTERIOR_DRAWS };
	double *out = xcalloc_doubles(sizes->n);
	for (size_t d = 0; d < D; d++) {
		double below = 0;
		transfer_compute_product(t, d, in, out);
		for (size_t i = sizes->n, k = sieves->n; i-- > 0;) {
			below += out[i];
			if (k > 0 && sieves->size[k - 1] == sizes->size[i])
				expect_near(
				    "draw", below, P[--k * D + d], 1e-12);
		}
		expect_near("all of it", below, 1, 1e-14);
	}
	free(out);
}

/* In a circuit with 8/11.2 sent back all draws balance, and the answer is their
 * mean. */
static void
each_draw_is_its_own_and_balances(void **state)
{
	(void)state;
	enum { D = POSTERIOR_DRAWS };
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 4);
	const struct psd *feed = &site->run[0].feed;
	struct fit fit;
	struct posterior *posterior = posterior_of(site, &fit);
	struct psd sieves = predict_list_table_sieves(site, feed);
	struct psd sizes = psd_new_with_sizes_between(sieves.size, sieves.n);
	size_t n = sizes.n;
	struct ensemble *e =
	    ensemble_new(posterior, feed, sieves.size, sieves.n);
	struct crusher *crusher =
	    crusher_new(sizes.size, n, &fit.params, fit.settings, posterior);
	crusher_set_reference_feed(crusher, feed, sieves.size, sieves.n);
	struct transfer *t = crusher_transfer_at_speed(crusher, 72);
	const double *P = ensemble_products(e, ENSEMBLE_ANSWER);
	double *in = xcalloc_doubles(n);
	ensemble_set_speed(e, 72);
	crusher_class_masses_of_feed(crusher, feed, in);
	expect_products(t, in, &sizes, &sieves, P);
	struct circuit *c = loop(0.5);
	c->unit[2].kind = UNIT_SCREEN;
	c->unit[2].opening = 0.008;
	struct transfer *const of[4] = {NULL, t, NULL, NULL};
	struct flow f = circuit_compute_flow(c, in, sizes.size, n, of);
	double mean = 0;
	for (size_t d = 0; d < D; d++) {
		mean += f.tph_draw[d * f.n_stream + 1] / D;
		expect_near("out", f.tph_draw[d * f.n_stream + 3], 120, 1e-9);
	}
	assert_true(mean > 1 && !f.open);
	expect_near("mean", f.circulating, mean, 1e-9);
	expect_near("balance", f.balance, 0, 1e-9);
	flow_free(&f);
	circuit_free(c);
	free(in);
	transfer_free(t);
	crusher_free(crusher);
	ensemble_free(e);
	psd_free(&sieves);
	psd_free(&sizes);
	posterior_free(posterior);
	site_free(site);
}

/* Euler: 33.33 kg/s brought to 72 m/s take 5184 J/kg, 172.8 kW; half of that
 * would be the kinetic energy alone. */
static void
throwing_takes_what_euler_says(void **state)
{
	(void)state;
	expect_near("thrown", power_to_accelerate_rock(72, 120), 172.8, 1e-12);
	struct power none = power_fit_readings(NULL, 0);
	assert_true(none.least);
	for (size_t d = 0; d < POWER_DRAWS; d++)
		expect_near("none",
		    power_kw_of_posterior_draw(&none, d, 72, 120), 172.8,
		    1e-12);
}

/* The mean and the least and most of the draws. */
static double
power_mean(const struct power *p, double v, double tph, double range[2])
{
	double sum = 0;
	range[0] = INFINITY;
	range[1] = -INFINITY;
	for (size_t d = 0; d < POWER_DRAWS; d++) {
		double kw = power_kw_of_posterior_draw(p, d, v, tph);
		sum += kw / POWER_DRAWS;
		range[0] = fmin(range[0], kw);
		range[1] = fmax(range[1], kw);
	}
	return sum;
}

/* Readings of an empty and a loaded crusher whose idle grows with v^2.6, and
 * the same without the empty ones. */
static void
idle_grows_as_the_empty_crusher_shows(void **state)
{
	(void)state;
	struct reading r[4] = {
	    {72, 0, 115}, {79, 0, 125}, {66, 0, 0}, {84, 0, 0}};
	double empty[2], loaded[2], one[2], idle = 60 * pow(60 / 72.0, 2.6);
	for (size_t i = 0; i < 4; i++)
		r[i].kw = 60 * pow(r[i].speed / 72, 2.6) +
			  1.2 * power_to_accelerate_rock(r[i].speed, r[i].tph);
	struct power all = power_fit_readings(r, 4),
		     two = power_fit_readings(r, 2),
		     first = power_fit_readings(r, 1);
	expect_near("empty", power_mean(&all, 60, 0, empty), idle, 1.5);
	double want = idle + 1.2 * power_to_accelerate_rock(60, 120);
	expect_near("all", power_mean(&all, 60, 120, loaded), want, 4);
	assert_true(loaded[0] < want && want < loaded[1]);
	power_mean(&two, 60, 0, empty);
	assert_true(empty[0] < 5 && empty[1] > idle);
	power_mean(&first, 60, 60, one);
	assert_true(one[1] - one[0] > 10);
	for (size_t d = 0; d < POWER_DRAWS; d++)
		assert_true(power_kw_of_posterior_draw(&first, d, 60, 100) >=
			    power_to_accelerate_rock(60, 100));
}

/* Readings that contradict Euler, each other or themselves give numbers. */
static void
impossible_readings_give_numbers(void **state)
{
	(void)state;
	struct reading r[5] = {{72, 20, 120}, {79, 300, 121}, {60, 1, 120},
	    {60, 900, 1}, {61, 3, 0}};
	for (size_t n = 1; n <= 5; n++) {
		struct power p = power_fit_readings(r, n),
			     last = power_fit_readings(r + n - 1, 1);
		assert_true(p.below == (n == 1));
		assert_true(last.least == (n == 5));
		double range[2];
		assert_true(isfinite(power_mean(&p, 74, 120, range)));
		assert_true(range[0] >= 0 && isfinite(p.rms));
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_circuit_without_a_loop_is_what_a_pencil_says),
	    cmocka_unit_test(a_loop_is_a_geometric_series),
	    cmocka_unit_test(a_loop_that_hardly_empties_is_left_open),
	    cmocka_unit_test(oversize_that_breaks_by_half_circulates_once),
	    cmocka_unit_test(what_is_not_fed_and_what_never_leaves_is_found),
	    cmocka_unit_test(classes_add_up_to_the_product_of_the_feed),
	    cmocka_unit_test(each_draw_is_its_own_and_balances),
	    cmocka_unit_test(throwing_takes_what_euler_says),
	    cmocka_unit_test(idle_grows_as_the_empty_crusher_shows),
	    cmocka_unit_test(impossible_readings_give_numbers),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
