/* Searches against what is asked plainly at each tenth of a m/s, of random
 * conditions, with and without draws.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/speed_search.h"

#include <gsl/gsl_sort_double.h>

#include "cmd/ask/condition.h"
#include "desk.h"
#include "made.h"
#include "often.h"

enum { CONDITIONS = 3 };

/* A question with conditions, which are made from its own values. */
struct asked {
	struct question q;
	struct condition at[CONDITIONS];
	struct condition_list list;
	struct conditions_search w;
};

static struct quantity
any_quantity(struct draw *draw)
{
	static const double SIZE[] = {8e-3, 5.6e-3, 2.3e-3, 1e-3, 0.5e-3};
	struct quantity q = {
	    .kind = (enum quantity_kind)draw_between(draw, 0, QUANTITY_STEP)};
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

static double
value_at(const struct asked *a, size_t i, double v)
{
	forecast_set_speed(a->w.forecast, v);
	return forecast_value_with_band(a->w.forecast, i).value;
}

/* narrow: limits so close that they are often met between two tenths only. */
static void
ask(struct asked *a, const struct session *s, struct draw *draw, bool narrow)
{
	a->q =
	    question_of_whole_product(s, &s->entry[s->current], SITE_MEAN_FEED);
	for (size_t i = 0; i < CONDITIONS; i++)
		a->at[i] = (struct condition){any_quantity(draw), NAN, NAN};
	a->list = (struct condition_list){.n = CONDITIONS, .at = a->at};
	a->w = conditions_open_search(s, &a->q, &a->list, NULL);
	for (size_t i = 0; i < CONDITIONS; i++) {
		double v = draw_between(draw, 66, 84), one = value_at(a, i, v);
		double two = value_at(
		    a, i, narrow ? v + 0.05 : draw_between(draw, 66, 84));
		if (narrow && i > 0)
			continue;
		a->at[i].least = fmin(one, two);
		a->at[i].most = fmax(one, two);
		if (!narrow && draw_between(draw, 0, 1) < 0.3)
			a->at[i].least = NAN;
		if (!narrow && draw_between(draw, 0, 1) < 0.3)
			a->at[i].most = NAN;
	}
}

/* Whether a value keeps its limits, plainly; by how much of the limit at
 * least. */
static bool
keeps(const struct condition *c, double value, double slack)
{
	if (isnan(c->least) && isnan(c->most))
		return true;
	return !(value < c->least - slack * fabs(c->least)) &&
	       !(value > c->most + slack * fabs(c->most)) && !isnan(value);
}

static bool
all_keep(const struct asked *a, double v, double slack)
{
	for (size_t i = 0; i < CONDITIONS; i++)
		if (!keeps(&a->at[i], value_at(a, i, v), slack))
			return false;
	return true;
}

static bool
is_inside(const struct speed_search *s, double v)
{
	for (size_t k = 0; k < s->n_inside; k++)
		if (v >= s->inside[k].from && v <= s->inside[k].to)
			return true;
	return false;
}

/* All tenths, and both ends of each range, which binds where it says. */
static void
check_inside(const struct asked *a, const struct speed_search *s)
{
	const double hair = 1e-6;
	assert_true(s->n == 201 && s->speed[0] == 65 && s->speed[200] == 85);
	for (size_t k = 0; k < s->n; k++) {
		double v = s->speed[k];
		if (is_inside(s, v) ? !all_keep(a, v, hair)
				    : all_keep(a, v, -hair))
			fail_msg("%g m/s is%s inside", v,
			    is_inside(s, v) ? "" : " not");
	}
	for (size_t k = 0; k < s->n_inside; k++) {
		const struct speed_range *in = &s->inside[k];
		assert_true(all_keep(a, in->from, hair));
		assert_true(all_keep(a, in->to, hair));
		assert_true((in->low.i == SIZE_MAX) == (in->from <= 65));
		assert_true((in->high.i == SIZE_MAX) == (in->to >= 85));
		if (in->high.i == SIZE_MAX)
			continue;
		const struct condition *c = &a->at[in->high.i];
		double v = floor(10 * in->to + hair) / 10 + 0.1;
		double value = value_at(a, in->high.i, v);
		assert_true(in->high.most ? value > c->most - 1e-9
					  : !(value >= c->least + 1e-9));
	}
}

/* The width of the middle of the draws' distances from a limit, plainly. */
static double
width_of(const struct asked *a, size_t i, double limit)
{
	double over[POSTERIOR_DRAWS];
	size_t cut = (size_t)floor(0.1 * POSTERIOR_DRAWS + 0.5);
	forecast_excess_in_each_draw(a->w.forecast, i, limit, over);
	gsl_sort(over, 1, POSTERIOR_DRAWS);
	return fmax(over[POSTERIOR_DRAWS - 1 - cut] - over[cut], 1e-3);
}

/* Draw by draw, plainly; and the margin, where it is of passings. */
static void
check_certain(const struct asked *a, const struct speed_search *s)
{
	for (size_t k = 0; k < s->n; k += 7) {
		size_t held = 0;
		forecast_set_speed(a->w.forecast, s->speed[k]);
		for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
			bool all = true;
			for (size_t i = 0; i < CONDITIONS; i++)
				all = all && keeps(&a->at[i],
						 forecast_draws_of_quantity(
						     a->w.forecast, i)[d],
						 0);
			held += all;
		}
		expect_near("certainty", s->certain[k],
		    (double)held / POSTERIOR_DRAWS, 1.5 / POSTERIOR_DRAWS);
	}
	forecast_set_speed(a->w.forecast, s->best);
	struct margin m = condition_margin(&a->w, SIZE_MAX);
	size_t i = m.limit.i;
	if (i < CONDITIONS && a->at[i].quantity.kind == QUANTITY_PASSING &&
	    isfinite(m.passing) && m.passing > 0) {
		double limit = m.limit.most ? a->at[i].most : a->at[i].least;
		double value = forecast_value_with_band(a->w.forecast, i).value;
		expect_near("passing", m.passing, fabs(value - limit), 1e-12);
		expect_near(
		    "widths", m.widths * width_of(a, i, limit), m.passing, 0.1);
	}
}

/* A measured speed where one will do, of these the surest, to what chance
 * leaves of a share; all tenths that hold so at `sure`. */
static void
check_best(const struct asked *a, const struct speed_search *s)
{
	bool any = false, drawn = !isnan(s->certain[0]);
	double most = -1;
	for (size_t k = 0; k < s->n; k++) {
		double v = s->speed[k];
		bool measured = v >= a->w.measured[0] && v <= a->w.measured[1];
		if (is_inside(s, v) && measured)
			any = true;
		if (is_inside(s, v) && measured && drawn)
			most = fmax(most, s->certain[k]);
		if (drawn && v >= s->sure[0] && v <= s->sure[1])
			assert_true(s->certain[k] >= 0.8);
		if (drawn && isnan(s->sure[0]))
			assert_true(s->certain[k] < 0.8);
	}
	if (s->n_inside > 0)
		assert_true(is_inside(s, s->best));
	if (any) {
		assert_true(s->best >= a->w.measured[0]);
		assert_true(s->best <= a->w.measured[1]);
		assert_true(!drawn || s->best_certain >= most - 0.02 - 1e-9);
	}
}

/* From the slowest safe speed on, up to the best, all hold at measured speeds
 * with 95 %; a tenth below it they do not. */
static void
check_safe(const struct asked *a, const struct speed_search *s)
{
	for (size_t k = 0; k < s->n; k++) {
		double v = s->speed[k];
		bool safe = is_inside(s, v) && s->certain[k] >= 0.95 &&
			    v >= a->w.measured[0] && v <= a->w.measured[1];
		if (v == s->best)
			assert_int_equal(safe, !isnan(s->safe));
		if (v >= s->safe && v <= s->best)
			assert_true(safe);
		if (k + 1 < s->n && s->speed[k + 1] == s->safe)
			assert_false(safe);
	}
}

/* Counts windows found, those in more than one part, and narrow ones. */
static void
check(struct asked *a, size_t count[static 3])
{
	struct speed_search *s = speed_search_new(&a->w);
	size_t steps = 1;
	while (!speed_search_step(s, &a->w))
		steps++;
	assert_int_equal(steps, s->n);
	check_inside(a, s);
	if (!isnan(s->certain[0]))
		check_certain(a, s);
	check_best(a, s);
	check_safe(a, s);
	count[0] += s->n_inside > 0;
	count[1] += s->n_inside > 1;
	for (size_t k = 0; k < s->n_inside; k++)
		count[2] += s->inside[k].to - s->inside[k].from < 0.0999 &&
			    s->inside[k].to > s->inside[k].from;
	speed_search_free(s);
	forecast_close(a->w.forecast);
}

static void
windows_are_those_of_each_tenth(void **state)
{
	struct desk *desk = *state;
	struct draw draw = draw_start(1);
	size_t count[3] = {0}, times = often(24, 90);
	desk_expect(desk, "load data/sites/tierp.csv");
	/* Until windows of each kind were met, without which the test is of
	 * little use. */
	size_t n = 0, most = 5 * times;
	for (; n < times || ((count[1] == 0 || count[2] == 0) && n < most);
	     n++) {
		char line[200];
		struct params p = made_any_params(&draw);
		snprintf(line, sizeof line,
		    "params set f_mat=%.3f e0_min=%.3f alpha=%.3f", p.f_mat,
		    p.e0_min, p.alpha);
		desk_expect(desk, line);
		struct asked a;
		ask(&a, desk->session, &draw, n % 3 == 2);
		check(&a, count);
	}
	assert_in_range(count[0], n / 6, n - 1);
	assert_in_range(count[1], 1, n);
	assert_in_range(count[2], 1, n);
}

static void
certainty_is_counted_of_the_draws(void **state)
{
	struct desk *desk = *state;
	struct draw draw = draw_start(3);
	size_t count[3] = {0};
	desk_expect(desk, TIERP_CALIBRATED);
	for (size_t n = 0; n < often(8, 30); n++) {
		struct asked a;
		ask(&a, desk->session, &draw, n % 4 == 3);
		check(&a, count);
	}
	assert_true(count[0] > 2);
}

/* A speed is found again from its value, within its ranges, of which that of a
 * belt cut is the wider; the largest value inside is that of its tenths. */
static void
a_speed_is_found_again_from_its_value(void **state)
{
	struct desk *desk = *state;
	struct draw draw = draw_start(11);
	desk_expect(desk, TIERP_CALIBRATED);
	for (size_t n = 0; n < 8; n++) {
		struct asked a;
		ask(&a, desk->session, &draw, false);
		forecast_close(a.w.forecast);
		double v = draw_between(&draw, 70, 80), nearest = INFINITY;
		struct condition target = {
		    {.kind = QUANTITY_SIZE, .x = 0.3 + 0.06 * (double)n}, NAN,
		    NAN};
		a.w = conditions_open_search(
		    desk->session, &a.q, &a.list, &target);
		forecast_set_speed(a.w.forecast, v);
		target.least = target.most =
		    forecast_value_with_band(a.w.forecast, CONDITIONS).value;
		struct speed_search *s = speed_search_run(&a.w);
		for (size_t i = 0; i < s->n_root; i++) {
			double at = s->root[i].speed;
			nearest = fmin(nearest, fabs(at - v));
			assert_true(
			    s->root[i].holds == all_keep(&a, at, 0) ||
			    all_keep(&a, at, 1e-6) != all_keep(&a, at, -1e-6));
		}
		expect_near("speed", nearest, 0, 1e-6);
		assert_true(s->range[0] < v && v < s->range[1]);
		assert_true(s->cut[0] <= s->range[0] + 0.2);
		assert_true(s->cut[1] >= s->range[1] - 0.2);
		double largest =
		    speed_search_speed_of_max_or_min(s, n % 2 == 0, false);
		double sign = n % 2 == 0 ? 1 : -1, most = -INFINITY;
		for (size_t k = 0; k < s->n; k++)
			if (is_inside(s, s->speed[k]))
				most =
				    fmax(most, sign * value_at(&a, CONDITIONS,
							  s->speed[k]));
		if (isnan(largest) == !!isfinite(most))
			fail_msg("largest at %g, of %g", largest, most);
		if (isfinite(most))
			expect_near("largest",
			    sign * value_at(&a, CONDITIONS, largest), most,
			    1e-12);
		speed_search_free(s);
		forecast_close(a.w.forecast);
	}
}

int
main(void)
{
	chdir_to_source();
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_setup_teardown(
		windows_are_those_of_each_tenth, desk_open, desk_close),
	    cmocka_unit_test_setup_teardown(
		certainty_is_counted_of_the_draws, desk_open, desk_close),
	    cmocka_unit_test_setup_teardown(
		a_speed_is_found_again_from_its_value, desk_open, desk_close),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
