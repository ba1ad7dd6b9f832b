/* Windows against a sweep over the speeds in steps of 0.01 m/s, of random
 * conditions on random sites, with and without draws.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/window.h"

#include <stdlib.h>

#include "core/answer/predict.h"
#include "fitted.h"
#include "often.h"

enum { CONDITIONS = 3 };

/* A response with conditions, which are made from its own values. */
struct asked {
	struct site *site;
	struct response *response;
	struct condition at[CONDITIONS];
	struct wanted c;
};

static struct quantity
any_quantity(struct draw *draw)
{
	static const double SIZE[] = {8e-3, 5.6e-3, 2.3e-3, 1e-3, 0.5e-3};
	struct quantity q = {
	    .kind = (enum quantity_kind)draw_between(draw, 0, 6)};
	q.x = q.kind == QUANTITY_SIZE ? draw_between(draw, 0.2, 0.9)
				      : SIZE[(int)draw_between(draw, 0, 5)];
	q.modulus = &MODULUS[(int)draw_between(draw, 0, MODULI)];
	if (q.kind == QUANTITY_SHARE || draw_between(draw, 0, 1) < 0.4) {
		q.fraction.coarse = SIZE[(int)draw_between(draw, 0, 3)];
		if (draw_between(draw, 0, 1) < 0.5)
			q.fraction.fine = q.fraction.coarse / 8;
		if (draw_between(draw, 0, 1) < 0.5)
			q.fraction.partition.sharpness = 4;
		q.fraction.partition.cut_size = 1;
	}
	return q;
}

static struct asked
ask(struct draw *draw, struct site *site, const struct params *p,
    const struct posterior *posterior)
{
	struct asked a = {.site = site};
	struct quantity q[CONDITIONS];
	const struct psd *feed = &site->run[0].feed;
	struct psd sizes = predict_sizes(site, feed);
	for (size_t i = 0; i < CONDITIONS; i++)
		q[i] = any_quantity(draw);
	a.response = response_new(feed, sizes.size, sizes.n, q, CONDITIONS, p,
	    model_settings_default(), posterior);
	psd_free(&sizes);
	for (size_t i = 0; i < CONDITIONS; i++) {
		response_at(a.response, draw_between(draw, 66, 84));
		double one = response_value(a.response, i);
		response_at(a.response, draw_between(draw, 66, 84));
		double two = response_value(a.response, i);
		a.at[i] =
		    (struct condition){q[i], fmin(one, two), fmax(one, two)};
		if (draw_between(draw, 0, 1) < 0.3)
			a.at[i].least = NAN;
		if (draw_between(draw, 0, 1) < 0.3)
			a.at[i].most = NAN;
	}
	return a;
}

/* The conditions are of the struct's new place. */
static void
settle(struct asked *a)
{
	a->c = (struct wanted){
	    .response = a->response,
	    .n = CONDITIONS,
	    .at = a->at,
	    .from = 65,
	    .to = 85,
	};
}

/* Whether value i keeps its limits, plainly; by how much of the limit at
 * least. */
static bool
holds(const struct asked *a, size_t i, double slack)
{
	const struct condition *c = &a->at[i];
	double value = response_value(a->response, i);
	if (isnan(c->least) && isnan(c->most))
		return true;
	return !(value < c->least - slack * fabs(c->least)) &&
	       !(value > c->most + slack * fabs(c->most)) && !isnan(value);
}

static bool
all_hold(const struct asked *a, double v, double slack)
{
	response_answer_at(a->response, v);
	for (size_t i = 0; i < CONDITIONS; i++)
		if (!holds(a, i, slack))
			return false;
	return true;
}

static bool
is_inside(const struct window_found *w, double v)
{
	for (size_t k = 0; k < w->n_inside; k++)
		if (v >= w->inside[k].from && v <= w->inside[k].to)
			return true;
	return false;
}

/* Returns how many speeds of the sweep are inside. */
static size_t
check_sweep(const struct asked *a, const struct window_found *w)
{
	const double hair = 1e-6;
	size_t inside = 0;
	struct window_limit limit;
	for (size_t k = 0; k <= 2000; k++) {
		double v = fmin(65 + 0.01 * (double)k, 85);
		bool in = is_inside(w, v);
		/* A limit that is met within arithmetic may be either. */
		if (in && !all_hold(a, v, hair))
			fail_msg("%g m/s is not inside", v);
		if (!in && all_hold(a, v, -hair))
			fail_msg("%g m/s is inside", v);
		inside += in;
		response_answer_at(a->response, v);
		double margin = window_margin(&a->c, &limit);
		/* Corners of the curve make tops that differ by so little. */
		if (!(margin <= w->margin + 2e-5))
			fail_msg("%g m/s has %g more than %g at %g", v,
			    margin - w->margin, w->margin, w->best);
	}
	return inside;
}

/* The best speed has the margin, and it is one inside where there is one; just
 * beyond the ends a limit is missed, which is the one said. */
static void
check_ends(const struct asked *a, const struct window_found *w)
{
	struct window_limit limit;
	response_at(a->response, w->best);
	double margin = window_margin(&a->c, &limit);
	expect_near("margin", margin < 1 ? margin : 1, fmin(w->margin, 1), 0);
	assert_true((w->n_inside > 0) == (w->margin >= -1e-9));
	for (size_t k = 0; k < w->n_inside; k++) {
		const struct window_range *in = &w->inside[k];
		assert_true((in->low.i == SIZE_MAX) == (in->from <= 65));
		assert_true((in->high.i == SIZE_MAX) == (in->to >= 85));
		if (in->high.i == SIZE_MAX)
			continue;
		response_at(a->response, in->to);
		window_margin_of(&a->c, in->high.i, &limit);
		double over = response_over(a->response, in->high.i,
		    in->high.most ? a->at[in->high.i].most
				  : a->at[in->high.i].least,
		    SIZE_MAX);
		expect_near("what binds is at its limit", over, 0, 1e-6);
	}
}

/* Counts windows found, and those in more than one part. */
static void
check(struct asked *a, size_t count[static 2])
{
	settle(a);
	struct window_found w = window_find(&a->c);
	check_sweep(a, &w);
	check_ends(a, &w);
	count[0] += w.n_inside > 0;
	count[1] += w.n_inside > 1;
	window_free(&w);
	response_free(a->response);
}

static void
windows_are_those_of_a_sweep(void **state)
{
	(void)state;
	struct draw draw = draw_start(1);
	size_t count[2] = {0}, times = often(20, 60);
	for (size_t n = 0; n < times; n++) {
		size_t row = (size_t)draw_between(&draw, 0, 19);
		struct site *site = made_site(&TABLE_3[row], 0, 1);
		struct params p = n % 3 == 0 ? made_any_params(&draw)
					     : made_params(&TABLE_3[row]);
		struct asked a = ask(&draw, site, &p, NULL);
		check(&a, count);
		site_free(site);
	}
	/* The test is of little use unless both kinds are met. */
	assert_in_range(count[0], times / 6, times * 11 / 12);
	assert_in_range(count[1], 1, times);
}

/* Calibrated at 69 and 79 m/s. */
static struct posterior *
posterior_of(const struct site *site, struct params *p)
{
	static const bool use[3] = {true, false, true};
	struct calibrate_options o = quick_options(1);
	struct fit fit = fitted(site, &o);
	*p = fit.params;
	return drawn(site, &fit, &o, use);
}

/* Draw by draw at each step, plainly. */
static void
check_certain(const struct asked *a, const struct window_found *w)
{
	for (size_t k = 0; k < w->n; k += 10) {
		size_t held = 0;
		response_at(a->response, w->speed[k]);
		for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
			bool all = true;
			for (size_t i = 0; i < CONDITIONS; i++) {
				const struct condition *c = &a->at[i];
				double x = response_draws(a->response, i)[d];
				if (isnan(c->least) && isnan(c->most))
					continue;
				all = all && !(x < c->least) &&
				      !(x > c->most) && !isnan(x);
			}
			held += all;
		}
		expect_near("certainty", w->certain[k],
		    (double)held / POSTERIOR_DRAWS, 1.5 / POSTERIOR_DRAWS);
	}
	double range[2], level = 0.8;
	window_certain(w, level, range);
	for (size_t k = 0; k < w->n; k++)
		if (w->speed[k] >= range[0] && w->speed[k] <= range[1])
			assert_true(w->certain[k] >= level);
		else if (isnan(range[0]))
			assert_true(w->certain[k] < level);
}

static void
certainty_is_counted_of_the_draws(void **state)
{
	(void)state;
	struct draw draw = draw_start(3);
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 3);
	struct params p;
	struct posterior *posterior = posterior_of(site, &p);
	size_t count[2] = {0};
	for (size_t n = 0; n < often(2, 6); n++) {
		struct asked a = ask(&draw, site, &p, posterior);
		settle(&a);
		struct window_found w = window_find(&a.c);
		check_certain(&a, &w);
		window_free(&w);
		if (n < often(1, 2))
			check(&a, count);
		else
			response_free(a.response);
	}
	posterior_free(posterior);
	site_free(site);
}

/* A speed is found again from its value, and a range of the draws is about
 * it. */
static void
a_speed_is_found_again_from_its_value(void **state)
{
	(void)state;
	struct draw draw = draw_start(11);
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 3);
	struct params p;
	struct posterior *posterior = posterior_of(site, &p);
	for (size_t n = 0; n < 6; n++) {
		struct asked a = ask(&draw, site, &p, posterior);
		double v = draw_between(&draw, 70, 80), range[2], *root;
		settle(&a);
		response_at(a.response, v);
		double value = response_value(a.response, 0);
		size_t roots = window_roots(&a.c, 0, value, &root);
		double nearest = INFINITY;
		for (size_t i = 0; i < roots; i++)
			nearest = fmin(nearest, fabs(root[i] - v));
		if (isfinite(value))
			expect_near("speed", nearest, 0, 1e-6);
		window_spread(&a.c, 0, value, v, 0.8, range);
		if (isfinite(value))
			assert_true(range[0] <= range[1]);
		free(root);
		response_free(a.response);
	}
	posterior_free(posterior);
	site_free(site);
}

/* The largest value inside is that of a sweep. */
static void
the_largest_value_is_that_of_a_sweep(void **state)
{
	(void)state;
	struct draw draw = draw_start(23);
	size_t found = 0;
	for (size_t n = 0; n < 20; n++) {
		struct site *site = made_site(&TABLE_3[n % 19], 0, 1);
		struct params p = made_params(&TABLE_3[n % 19]);
		struct asked a = ask(&draw, site, &p, NULL);
		settle(&a);
		a.c.n = 2;
		struct window_found w = window_find(&a.c);
		double v = window_extreme(&a.c, &w, 2, n % 2 == 0);
		double sign = n % 2 == 0 ? 1 : -1, most = -INFINITY;
		for (double at = 65; at <= 85; at += 0.01) {
			response_at(a.response, at);
			double value = sign * response_value(a.response, 2);
			if (is_inside(&w, at) && !isnan(value))
				most = fmax(most, value);
		}
		assert_true(isnan(v) == (w.n_inside == 0) || isinf(most));
		if (isfinite(most)) {
			found++;
			response_at(a.response, v);
			double value = sign * response_value(a.response, 2);
			assert_true(value >= most - 1e-9);
			assert_true(is_inside(&w, v));
		}
		window_free(&w);
		response_free(a.response);
		site_free(site);
	}
	assert_true(found > 5);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(windows_are_those_of_a_sweep),
	    cmocka_unit_test(certainty_is_counted_of_the_draws),
	    cmocka_unit_test(a_speed_is_found_again_from_its_value),
	    cmocka_unit_test(the_largest_value_is_that_of_a_sweep),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
