/* What draws say of parameters: made-up draws of which everything is known.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "made.h"

#include "core/model/breakage.h"
#include "core/posterior/identify.h"

enum { BETA2 = 1, F_MAT = 4, E0_MIN, ALPHA, GAMMA };

/* alpha spread by `spread` about 0.9, e0_min so that the break size at 74 m/s
 * stays at 5 mm, f_mat anywhere in its bounds. */
static struct posterior
made_up(double spread)
{
	struct posterior p = {
	    .settings = model_settings_default(), .bounds = bounds_default(1)};
	p.settings.breakage = 1;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
		struct params *q = &p.draw[d].params;
		double t = ((double)d + 0.5) / POSTERIOR_DRAWS;
		*q = params_start_values(1);
		q->at[BETA2] = 1;
		q->at[ALPHA] = 0.9 + spread * (2 * t - 1);
		q->at[E0_MIN] =
		    specific_energy_at_speed(74) * pow(0.005, q->at[ALPHA]);
		q->at[F_MAT] = 0.001 + 2.999 * fmod(89 * t, 1);
	}
	return p;
}

static void
shares_of_the_prior_grade_parameters(void **state)
{
	(void)state;
	struct posterior p = made_up(0.04);
	struct identify_param alpha = identify_summarise_param(&p, ALPHA);
	struct identify_param f_mat = identify_summarise_param(&p, F_MAT);
	expect_near("mean", alpha.mean, 0.9, 1e-9);
	expect_near("sd", alpha.sd, 0.08 / sqrt(12), 1e-4);
	expect_near("prior", alpha.prior, 1 / sqrt(12), 1e-12);
	expect_near("ratio", alpha.ratio, 0.08, 2e-3);
	assert_int_equal(alpha.grade, IDENTIFY_DETERMINED);
	expect_near("f_mat", f_mat.ratio, 1, 0.02);
	assert_int_equal(f_mat.grade, IDENTIFY_NOT);
	assert_int_equal(
	    identify_summarise_param(&p, BETA2).grade, IDENTIFY_FIXED);
	assert_int_equal(
	    identify_summarise_param(&p, GAMMA).grade, IDENTIFY_FIXED);
	assert_true(identify_summarise_param(&p, GAMMA).prior == 0.4);
	p = made_up(0.1);
	assert_int_equal(
	    identify_summarise_param(&p, ALPHA).grade, IDENTIFY_POORLY);
}

/* beta2 is 1 in all draws because it is scaled so; the direction is known no
 * better than beta3 tells, and all four have its grade. */
static void
a_scaled_beta_is_not_determined(void **state)
{
	(void)state;
	struct posterior p = made_up(0.04);
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		p.draw[d].params.at[BETA2 + 1] = -1 + (double)d / 128;
	for (size_t j = 0; j < 4; j++) {
		struct identify_param beta = identify_summarise_param(&p, j);
		assert_int_equal(beta.grade, IDENTIFY_POORLY);
		assert_true(
		    beta.ratio == identify_summarise_param(&p, 0).ratio);
		assert_true(beta.ratio < 1);
	}
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		p.draw[d].params.at[BETA2 + 1] = -0.9 + (double)d / 12800;
	assert_int_equal(
	    identify_summarise_param(&p, BETA2).grade, IDENTIFY_DETERMINED);
}

/* alpha from 0.8 to 1: a tenth of the draws lies within 0.02 of its bound, of
 * those above 0.9 a fifth. */
static void
many_draws_at_a_bound_are_told(void **state)
{
	(void)state;
	struct posterior p = made_up(0.1);
	assert_int_equal(identify_summarise_param(&p, ALPHA).bound, 0);
	p.bounds.upper[ALPHA] = 0.84;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		p.draw[d].params.at[ALPHA] =
		    fmin(p.draw[d].params.at[ALPHA], 0.84);
	assert_int_equal(identify_summarise_param(&p, ALPHA).bound, 1);
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		p.draw[d].params.at[E0_MIN] *= (double)(d % 2);
	assert_int_equal(identify_summarise_param(&p, E0_MIN).bound, -1);
}

static void
a_ridge_is_a_correlation(void **state)
{
	(void)state;
	struct posterior p = made_up(0.1);
	struct identify_pair pair =
	    identify_correlate_params(&p, E0_MIN, ALPHA);
	/* e0_min is a bent function of alpha: of the ranks it is straight. */
	expect_near("rank", pair.rank, -1, 1e-9);
	assert_true(pair.linear < -0.95 && pair.linear > -1 + 1e-6);
	assert_true(identify_larger_of_rank_or_linear(pair) == pair.rank);
	assert_true(fabs(identify_larger_of_rank_or_linear(
			identify_correlate_params(&p, F_MAT, ALPHA))) < 0.2);
	assert_true(isnan(identify_correlate_params(&p, GAMMA, ALPHA).linear));
	struct identify_pair other = {-0.9, 0.5};
	assert_true(identify_larger_of_rank_or_linear(other) == -0.9);
}

static void
break_sizes_are_those_of_the_draws(void **state)
{
	(void)state;
	struct posterior p = made_up(0.1);
	struct identify_break at = identify_summarise_break_size(&p, 74, 0.004);
	expect_near("mean", at.mean, 0.005, 1e-12);
	assert_true(at.sd < 1e-9 && at.below == 0);
	at = identify_summarise_break_size(&p, 85, 0.00375);
	assert_true(at.mean < 0.005 && at.sd > 1e-6);
	assert_true(at.low < at.mean && at.mean < at.high);
	assert_true(at.below > 0 && at.below < 1);
	for (size_t d = 0; d < POSTERIOR_DRAWS; d += 4)
		p.draw[d].params.at[E0_MIN] = 0;
	expect_near("below", identify_summarise_break_size(&p, 74, 0.004).below,
	    0.25, 1e-12);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(shares_of_the_prior_grade_parameters),
	    cmocka_unit_test(a_scaled_beta_is_not_determined),
	    cmocka_unit_test(many_draws_at_a_bound_are_told),
	    cmocka_unit_test(a_ridge_is_a_correlation),
	    cmocka_unit_test(break_sizes_are_those_of_the_draws)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
