/* The profile of the misfit, and the density of draws.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "fitted.h"

#include "core/model/breakage.h"
#include "core/posterior/profile.h"

enum { BETA2 = 1, BETA3, E0_MIN = 5, VALUES = 9 };

static struct fit
calibrated(const struct site *site, const struct bounds *bounds)
{
	struct calibrate_options o = calibrate_options_default();
	o.population = 4000;
	o.bounds = *bounds;
	return fitted(site, &o);
}

/* The fit is the lowest point, the profile rises from it, and at a value it is
 * what a calibration with the parameter held there finds. */
static void
a_profile_is_what_calibrations_find(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 2);
	struct bounds b = bounds_default(0);
	struct fit fit = calibrated(site, &b);
	struct calibrate_options o = calibrate_options_default();
	struct misfit *m = calibrate_make_misfit(site, &o);
	double x[VALUES], E[VALUES];
	for (size_t i = 0; i < VALUES; i++)
		x[i] = fit.params.e0_min + 1.5 * ((double)i - VALUES / 2);
	profile_misfit(m, &fit.params, &b, E0_MIN, x, VALUES, E);
	expect_near("at the fit", E[VALUES / 2] / fit.misfit, 1, 1e-9);
	for (size_t i = 0; i < VALUES; i++)
		assert_true(E[i] >= fit.misfit * (1 - 1e-9));
	assert_true(E[0] > E[2] && E[2] > E[4]);
	assert_true(E[8] > E[6] && E[6] > E[4]);
	b.lower[E0_MIN] = b.upper[E0_MIN] = x[6];
	expect_near("held", E[6] / calibrated(site, &b).misfit, 1, 1e-4);
	misfit_free(m);
	site_free(site);
}

/* Beta's scale is free: with the largest held the others still count. */
static void
a_profile_of_beta_holds_its_scale(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 2);
	struct bounds b = bounds_default(0);
	struct fit fit = calibrated(site, &b);
	struct calibrate_options o = calibrate_options_default();
	struct misfit *m = calibrate_make_misfit(site, &o);
	size_t j = fabs(fit.params.beta[BETA3]) == 1 ? BETA2 : BETA3;
	double x[3] = {-1, fit.params.beta[j], 1}, E[3];
	profile_misfit(m, &fit.params, &b, j, x, 3, E);
	expect_near("at the fit", E[1] / fit.misfit, 1, 1e-9);
	assert_true(fmax(E[0], E[2]) > 1.5 * E[1]);
	misfit_free(m);
	site_free(site);
}

static void
a_density_integrates_to_one_within_its_bounds(void **state)
{
	(void)state;
	enum { N = 400, STEPS = 2000 };
	double draw[N], sum = 0;
	for (size_t i = 0; i < N; i++)
		draw[i] = 1 - pow(((double)i + 0.5) / N, 2);
	for (size_t i = 0; i < STEPS; i++)
		sum += profile_kde_of_draws(
			   draw, N, 0, 1, ((double)i + 0.5) / STEPS) /
		       STEPS;
	expect_near("integral", sum, 1, 1e-3);
	/* Its density is 1 / (2 sqrt(1 - x)). */
	expect_near("at 0.5", profile_kde_of_draws(draw, N, 0, 1, 0.5),
	    sqrt(0.5), 0.05);
	draw[0] = draw[1] = 0.5;
	expect_near(
	    "alike", profile_kde_of_draws(draw, 2, 0, 1, 0.5), 0, 1e-12);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_profile_is_what_calibrations_find),
	    cmocka_unit_test(a_profile_of_beta_holds_its_scale),
	    cmocka_unit_test(a_density_integrates_to_one_within_its_bounds)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
