/* Eqs 4, 3 and 1: energy, selection and appearance, each for itself.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "made.h"

#include "core/model/appearance.h"
#include "core/model/breakage.h"
#include "core/model/classes.h"
#include "core/model/selection.h"

static const double SPEEDS[] = {65, 69, 74, 79, 85};

static void
energy_is_half_v_squared(void **state)
{
	(void)state;
	assert_true(specific_energy_at_speed(74) == 2738);
	assert_true(specific_energy_at_speed(0) == 0);
	/* D10: 85 m/s is 15.8 % above 79 m/s, 65 is 11.3 % below 69. */
	expect_near("85 over 79",
	    specific_energy_at_speed(85) / specific_energy_at_speed(79), 1.158,
	    5e-4);
	expect_near("65 over 69",
	    specific_energy_at_speed(65) / specific_energy_at_speed(69),
	    1 - 0.113, 5e-4);
}

static void
break_sizes_of_tierp(void **state)
{
	(void)state;
	static const double mm[] = {6.48, 5.72, 4.94, 4.31, 3.70};
	struct params p = made_params(&TABLE_3[TIERP]);
	for (size_t i = 0; i < 5; i++) {
		double x = selection_break_size_at_energy(
		    &p, specific_energy_at_speed(SPEEDS[i]));
		expect_near("break size, mm", x * 1000, mm[i], 0.005);
		double E = SPEEDS[i] * SPEEDS[i] / 2;
		expect_near("x^alpha E", pow(x, p.alpha) * E, p.e0_min, 1e-12);
	}
}

static void
break_sizes_at_the_edges(void **state)
{
	(void)state;
	struct params p = made_params(&TABLE_3[TIERP]);
	assert_true(isinf(
	    selection_break_size_at_energy(&p, specific_energy_at_speed(0))));
	p.e0_min = 0;
	assert_true(selection_break_size_at_energy(
			&p, specific_energy_at_speed(74)) == 0);
	assert_true(isinf(
	    selection_break_size_at_energy(&p, specific_energy_at_speed(0))));
	p = (struct params){.f_mat = 1, .e0_min = 2738, .alpha = 0};
	assert_true(isinf(
	    selection_break_size_at_energy(&p, specific_energy_at_speed(74))));
	assert_true(selection_break_size_at_energy(
			&p, specific_energy_at_speed(75)) == 0);
	p.alpha = 1e-6;
	assert_true(selection_break_size_at_energy(
			&p, specific_energy_at_speed(75)) == 0);
	assert_true(isinf(
	    selection_break_size_at_energy(&p, specific_energy_at_speed(73))));
	p.alpha = 1e-3;
	double x =
	    selection_break_size_at_energy(&p, specific_energy_at_speed(74.5));
	assert_true(x > 0 && x < 1);
}

static double
selected(const struct params *p, double k, double E, double x)
{
	return selection_share_at_size(
	    p->at + PARAM_F_MAT, k, E, el_log(x), NULL);
}

static void
selection_is_eq_3_with_its_minus_sign(void **state)
{
	(void)state;
	struct draw draw = draw_start(21);
	for (int i = 0; i < 5000; i++) {
		struct params p = made_any_params(&draw);
		double x = draw_log(&draw, 63e-6, 63e-3);
		double k = draw_between(&draw, 0, 4);
		double E = draw_between(&draw, 0, 5000);
		double over = pow(x, p.alpha) * E - p.e0_min;
		double want = over > 0 ? -expm1(-p.f_mat * k * over) : 0;
		double S = selected(&p, k, E, x);
		assert_true(S >= 0 && S <= 1);
		expect_near("S", S, want, 1e-12);
	}
}

static void
nothing_is_selected_below_the_break_size(void **state)
{
	(void)state;
	for (size_t row = 0; row < ARRAY_LEN(TABLE_3); row++)
		for (size_t i = 0; i < ARRAY_LEN(SPEEDS); i++) {
			struct params p = made_params(&TABLE_3[row]);
			double E = specific_energy_at_speed(SPEEDS[i]);
			double x = selection_break_size_at_energy(
			    &p, specific_energy_at_speed(SPEEDS[i]));
			assert_true(selected(&p, 1, E, x * (1 - 1e-9)) == 0);
			assert_true(selected(&p, 1, E, x * (1 + 1e-9)) > 0);
			assert_true(selected(&p, 1, E, x / 10) == 0);
		}
}

/* Near the break size few digits are lost: S there is f_mat times the excess.
 * */
static void
selection_keeps_its_digits_where_it_is_small(void **state)
{
	(void)state;
	struct params p = {.f_mat = 1e-9, .e0_min = 10, .alpha = 1};
	double S = selected(&p, 1, 3000, 4e-3);
	expect_near("S", S, 2e-9, 1e-17);
}

static void
selection_rises_with_size_energy_and_f_mat(void **state)
{
	(void)state;
	struct draw draw = draw_start(22);
	for (int i = 0; i < 5000; i++) {
		struct params p = made_any_params(&draw), q = p;
		double x = draw_log(&draw, 63e-6, 63e-3);
		double E = draw_between(&draw, 100, 5000);
		double more = draw_between(&draw, 1.001, 2);
		double S = selected(&p, 1, E, x);
		assert_true(selected(&p, 1, E, x * more) >= S);
		assert_true(selected(&p, 1, E * more, x) >= S);
		assert_true(selected(&p, more, E, x) >= S);
		q.f_mat *= more;
		assert_true(selected(&q, 1, E, x) >= S);
		expect_near("k for f_mat", selected(&p, more, E, x),
		    selected(&q, 1, E, x), 1e-14);
		q = p;
		q.e0_min += more;
		assert_true(selected(&q, 1, E, x) <= S);
	}
	struct params p = made_params(&TABLE_3[TIERP]);
	assert_true(selected(&p, 1, 2738, 8e-3) > selected(&p, 1, 2738, 6e-3));
	assert_true(selected(&p, 1, 3000, 8e-3) > selected(&p, 1, 2738, 8e-3));
}

static void
density_is_the_cubic_clipped_at_0(void **state)
{
	(void)state;
	const double beta[4] = {-0.1, 1.5, -3, 1.5}; /* negative at both ends */
	assert_true(appearance_density(beta, 0.01) == 0);
	assert_true(appearance_density(beta, 0.8) == 0);
	expect_near(
	    "p(0.25)", appearance_density(beta, 0.25), 0.1109375, 1e-16);
	struct draw draw = draw_start(23);
	for (int i = 0; i < 5000; i++) {
		struct params p = made_any_params(&draw);
		double u = draw_between(&draw, 0, 1), *b = p.beta;
		double cubic =
		    b[0] + b[1] * u + b[2] * u * u + b[3] * u * u * u;
		expect_near("p(u)", appearance_density(b, u),
		    cubic > 0 ? cubic : 0, 1e-9);
		assert_true(appearance_density(b, u) >= 0);
	}
}

/* B by a midpoint rule in ln u, at the ends of `n` cells from 1 downwards. */
enum { CELLS = 20000 };

static void
naive_B(const double beta[static 4], double B[static CELLS + 1])
{
	double h = log(1024) / CELLS;
	B[CELLS] = 0;
	for (size_t i = CELLS; i-- > 0;) {
		double u = exp(-h * ((double)i + 0.5));
		double p =
		    beta[0] + u * (beta[1] + u * (beta[2] + u * beta[3]));
		B[i] = B[i + 1] + (p > 0 ? p * h : 0);
	}
	double total = B[0];
	for (size_t i = 0; i <= CELLS && total > 0; i++)
		B[i] /= total;
}

/* One to three zeros in (0, 1), with either sign, and lower degrees. */
static const double CUBICS[][4] = {{0, 1, -1, 0.5}, {-0.08, 0.66, -1.5, 1},
    {0.08, -0.66, 1.5, -1}, {-0.16, 1, -1, 0}, {0.16, -1, 1, 0},
    {-0.3, 1, 0, 0}, {0.3, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 1},
    {-0.1, 0, 0, 1}, {0.25, -1, 1, 0}, {0.1, 0, -1, 0}};

/* B(u); where total is 0 it is 0 for every u < 1. */
static double
passing(const struct appearance *a, double u)
{
	double parts[4], sum = 0;
	if (u >= 1)
		return 1;
	appearance_power_integrals_up_to(a, log(u), parts);
	for (size_t i = 0; i < 4; i++)
		sum += a->beta[i] * parts[i];
	return a->total > 0 ? sum / a->total : 0;
}

static void
expect_B(const double beta[static 4])
{
	static double B[CELLS + 1];
	naive_B(beta, B);
	struct appearance a = appearance_from_beta(beta);
	assert_true((a.total > 0) == (B[0] > 0));
	for (size_t i = 0; i <= CELLS && B[0] > 0; i += 97) {
		double u = exp(-log(1024) / CELLS * (double)i);
		expect_near("B(u)", passing(&a, u), B[i], 1e-5);
	}
}

static void
B_is_the_running_integral_of_the_density(void **state)
{
	(void)state;
	struct draw draw = draw_start(24);
	for (size_t k = 0; k < ARRAY_LEN(CUBICS); k++)
		expect_B(CUBICS[k]);
	for (int k = 0; k < 60; k++) {
		struct params p = made_any_params(&draw);
		expect_B(p.beta);
	}
}

static void
B_rises_from_0_to_1(void **state)
{
	(void)state;
	struct draw draw = draw_start(25);
	for (int k = 0; k < 400; k++) {
		struct params p = made_any_params(&draw);
		struct appearance a = appearance_from_beta(p.beta);
		double before = 0;
		assert_true(passing(&a, 0.999 / 1024) == 0);
		assert_true(passing(&a, 1) == 1);
		assert_true(passing(&a, 3) == 1);
		for (double u = 1.0 / 1024; u < 1; u *= 1.02) {
			double B = passing(&a, u);
			if (!(B >= before - 1e-14 && B <= 1 + 1e-14))
				fail_msg(
				    "B(%g) = %.17g after %.17g", u, B, before);
			before = B;
		}
		/* A short piece of p is a small difference of large ones. */
		if (a.total > 0)
			expect_near("B(1-)", passing(&a, 1 - 1e-15), 1,
			    1e-14 * (1 + 5000 / a.total));
	}
}

static void
only_the_direction_of_beta_matters(void **state)
{
	(void)state;
	struct draw draw = draw_start(26);
	for (int k = 0; k < 200; k++) {
		struct params p = made_any_params(&draw), q = p;
		params_scale_largest_beta_to_1(&q);
		double largest = 0;
		for (size_t b = 0; b < 4; b++)
			largest = fmax(largest, fabs(q.beta[b]));
		assert_true(largest == 1);
		struct appearance a = appearance_from_beta(p.beta);
		struct appearance b = appearance_from_beta(q.beta);
		for (double u = 1.0 / 1024; u < 1; u *= 1.3)
			expect_near(
			    "B(u)", passing(&a, u), passing(&b, u), 1e-11);
	}
}

static void
matrix_of(const double beta[4], enum appearance_form form, const double *x,
    size_t n, double *m)
{
	struct breaker b;
	struct params p = {.beta = {beta[0], beta[1], beta[2], beta[3]}};
	struct model_settings settings = model_settings_default();
	breaker_set_params(&b, &p, &settings);
	breaker_set_speed(&b, 74);
	classes_appearance_matrix(&b, form, x, n, m);
}

static void
no_daughters_leaves_the_parent_whole(void **state)
{
	(void)state;
	static const double none[][4] = {{0, 0, 0, 0}, {-1, 0, 0, 0},
	    {-1, 1, 0, 0}, {-1, -2, -3, -4}, {NAN, 0, 0, 0}};
	const double x[4] = {9e-3, 5e-3, 2e-3, 1e-3};
	for (size_t i = 0; i < ARRAY_LEN(none); i++) {
		struct appearance a = appearance_from_beta(none[i]);
		assert_true(a.total == 0 && a.n == 0);
		assert_true(passing(&a, 0.999) == 0);
		assert_true(passing(&a, 1) == 1);
		double m[16];
		matrix_of(none[i], APPEARANCE_RATIO, x, 4, m);
		for (size_t c = 0; c < 16; c++) {
			bool kept = c % 5 == 0;
			/* -1 + u is 0 at u = 1 and nowhere above it. */
			assert_true(m[c] == (kept ? 1 : 0));
		}
	}
}

static void
expect_column(const double *m, size_t n, size_t i)
{
	double sum = 0;
	for (size_t j = 0; j < n; j++) {
		double share = m[j * n + i];
		assert_true(j >= i ? share >= 0 && share <= 1 : share == 0);
		sum += share;
	}
	expect_near("sum of a column", sum, 1, 1e-14);
}

static void
matrix_is_lower_triangular_with_unit_columns(void **state)
{
	(void)state;
	enum { N = 13 };
	double x[N], m[N * N];
	struct draw draw = draw_start(27);
	for (size_t i = 0; i < N; i++)
		x[i] = 20e-3 * pow(0.6, (double)i);
	for (int k = 0; k < 300; k++) {
		struct params p = made_any_params(&draw);
		enum appearance_form form = (enum appearance_form)(k % 3);
		matrix_of(p.beta, form, x, N, m);
		for (size_t i = 0; i < N; i++)
			expect_column(m, N, i);
	}
}

/* What p is a function of in each form, D3. */
static void
matrix_shares_follow_the_form(void **state)
{
	(void)state;
	const double x[3] = {10e-3, 5e-3, 1e-3}, beta[4] = {0, 1, 0, 0};
	static const double want[3][3] = {{1 / 1.6, 0.5 / 1.6, 0.1 / 1.6},
	    {10.0 / 16, 5.0 / 16, 1.0 / 16}, {1 / 3.0, 1 / 3.0, 1 / 3.0}};
	for (int form = 0; form < 3; form++) {
		double m[9];
		matrix_of(beta, (enum appearance_form)form, x, 3, m);
		for (size_t j = 0; j < 3; j++)
			expect_near("a_j0", m[3 * j], want[form][j], 1e-15);
		expect_near("a_22", m[8], 1, 0);
	}
	const double square[4] = {0, 0, 1, 0};
	double m[9];
	matrix_of(square, APPEARANCE_RATIO, x, 3, m);
	expect_near("a_21", m[2 * 3 + 1], 0.04 / 1.04, 1e-15);
}

static void
the_table_of_parameters_is_whole(void **state)
{
	(void)state;
	struct params p = {0};
	struct bounds b = bounds_default(0);
	for (size_t i = 0; i < PARAM_COUNT; i++) {
		p.at[i] = 10.0 + (double)i;
		assert_int_equal(
		    breakage_parameter_index(BREAKAGES[0], PARAMS[i].name), i);
		assert_true(b.lower[i] == PARAMS[i].lower);
		assert_true(b.upper[i] == PARAMS[i].upper);
	}
	for (size_t i = 0; i < PARAM_COUNT; i++)
		assert_true(p.at[i] == 10.0 + (double)i);
	assert_true(p.f_mat == 14 && p.e0_min == 15 && p.alpha == 16);
	assert_int_equal(
	    breakage_parameter_index(BREAKAGES[0], "beta5"), PARAM_COUNT);
	struct params none = {0};
	params_scale_largest_beta_to_1(&none);
	assert_true(none.beta[0] == 0 && none.beta[3] == 0);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(energy_is_half_v_squared),
	    cmocka_unit_test(break_sizes_of_tierp),
	    cmocka_unit_test(break_sizes_at_the_edges),
	    cmocka_unit_test(selection_is_eq_3_with_its_minus_sign),
	    cmocka_unit_test(nothing_is_selected_below_the_break_size),
	    cmocka_unit_test(selection_keeps_its_digits_where_it_is_small),
	    cmocka_unit_test(selection_rises_with_size_energy_and_f_mat),
	    cmocka_unit_test(density_is_the_cubic_clipped_at_0),
	    cmocka_unit_test(B_is_the_running_integral_of_the_density),
	    cmocka_unit_test(B_rises_from_0_to_1),
	    cmocka_unit_test(only_the_direction_of_beta_matters),
	    cmocka_unit_test(no_daughters_leaves_the_parent_whole),
	    cmocka_unit_test(matrix_is_lower_triangular_with_unit_columns),
	    cmocka_unit_test(matrix_shares_follow_the_form),
	    cmocka_unit_test(the_table_of_parameters_is_whole),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
