/* Collision energies: bins, the model's quadrature of them, and the product
 * with them, against sums that take every impact by itself.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/spectrum.h"

#include <stdlib.h>

#include "core/model/selection.h"
#include "herd.h"
#include "made.h"

/* Impacts as a rock bed gives them: a few hard, many weak. */
static struct spectrum *
made_spectrum(uint64_t seed, size_t particles, size_t each)
{
	struct spectrum *s = spectrum_new();
	struct draw draw = draw_start(seed);
	s->speed = 74;
	s->counted = true;
	for (size_t i = 0; i < particles; i++) {
		spectrum_add_particles(s, 0.008, 1, 0.001);
		for (size_t j = 0; j < each; j++)
			spectrum_add_impact(s, 0.008, 0.001,
			    draw_log(&draw, 1, j == 0 ? 2738 : 1000), j == 0);
	}
	return s;
}

static struct model_settings
with(struct impacts impacts)
{
	struct model_settings settings = model_settings_default();
	settings.impacts = impacts;
	return settings;
}

static struct impacts
once(double ratio, double number)
{
	return (struct impacts){
	    .n = 1, .number = number, .share = {1}, .ratio = {ratio}};
}

static void
counts_what_was_put_in(void **state)
{
	(void)state;
	struct spectrum *s = spectrum_new();
	s->speed = 100;
	s->counted = true;
	spectrum_add_particles(s, 0.008, 2, 4);
	spectrum_add_impact(s, 0.008, 2, 5000, true);
	spectrum_add_impact(s, 0.008, 2, 5, false);
	spectrum_add_impact(s, 0.008, 2, 40, true);
	struct spectrum_size *all = spectrum_sum_over_sizes(s);
	expect_near(
	    "impacts", spectrum_impacts_per_particle(s, all, 0), 1.5, 1e-12);
	expect_near(
	    "above", spectrum_impacts_per_particle(s, all, 10), 1, 1e-12);
	expect_near("energy",
	    spectrum_impacts_above_energy(all, 10, false).energy, 10080, 1e-9);
	/* Of the hardest alone: half a particle each at v^2/2. */
	expect_near(
	    "k", spectrum_equivalent_k(s, all, 5000, 1000, 0), 0.5, 1e-12);
	expect_near("k, strong",
	    spectrum_equivalent_k(s, all, 5000, 1000, 1e-3),
	    -1.5 * log((2 + exp(-4.0)) / 3) / 4, 1e-9);
	assert_true(isnan(spectrum_equivalent_k(s, all, 5000, 6000, 0)));
	free(all);
	spectrum_free(s);
}

static void
a_single_impact_at_tip_speed_is_the_paper(void **state)
{
	(void)state;
	const double q[3] = {2.18, 16.74, 0.96};
	struct impacts paper = once(1, 1), twice = once(1, 2);
	for (double t = log(1e-3); t < log(0.02); t += 0.1) {
		double d[3] = {0}, e[3] = {0};
		double S = selection_share_at_size(q, 1, 2738, t, d);
		expect_near("S",
		    selection_share_by_impacts(&paper, q, 1, 2738, t, e), S,
		    1e-14);
		for (size_t i = 0; i < 3; i++)
			expect_near("dS", e[i], d[i], 1e-9 * fabs(d[i]));
		expect_near("S of two",
		    selection_share_by_impacts(&twice, q, 1, 2738, t, e),
		    selection_share_at_size(q, 2, 2738, t, d), 1e-13);
	}
}

/* S of all impacts, each by itself. */
static double
every_impact(
    const struct spectrum *s, const double q[3], double E, double log_x)
{
	double e0 = q[1] / exp(q[2] * log_x), f = q[0] * exp(q[2] * log_x);
	double k = spectrum_equivalent_k(s, s->size[0], E, e0, f);
	return isfinite(k) ? -expm1(-f * k * (E - e0)) : NAN;
}

static void
twelve_groups_stand_for_all_impacts(void **state)
{
	(void)state;
	const double q[3] = {0.44, 11.8, 1}, cut = 10;
	struct spectrum *s = made_spectrum(3, 2000, 5), *above = spectrum_new();
	struct impacts impacts = spectrum_group_impacts_by_energy(s, cut);
	double energy = 0, worst = 0, E = 74 * 74 / 2.0;
	struct spectrum_bin all =
	    spectrum_impacts_above_energy(s->size[0], cut, false);
	for (size_t j = 0; j < impacts.n; j++)
		energy += impacts.share[j] * impacts.ratio[j];
	assert_int_equal(impacts.n, IMPACTS_MOST);
	expect_near("mean energy", energy * E, all.energy / all.mass, 1e-6 * E);
	for (double t = log(2e-3); t < log(0.02); t += 0.05) {
		double want = every_impact(s, q, E, t);
		double S =
		    selection_share_by_impacts(&impacts, q, 1, E, t, NULL);
		if (isfinite(want))
			worst = fmax(worst, fabs(S - want));
	}
	/* Of the mass of a size that breaks. */
	expect_near("S by groups", worst, 0, 0.012);
	spectrum_free(above);
	spectrum_free(s);
}

/* The product summed in 40000 steps of ln x. */
static double
summed(const struct psd *feed, const struct params *p,
    const struct model_settings *settings, double v, double s)
{
	struct breaker b;
	double sum = psd_passing(feed, s), low = log(s);
	double high = log(feed->size[0]);
	enum { STEPS = 40000 };
	breaker_set_params(&b, p, settings);
	breaker_set_speed(&b, v);
	for (size_t i = 0; i < STEPS; i++) {
		double a = low + (high - low) * (double)i / STEPS;
		double z = low + (high - low) * (double)(i + 1) / STEPS;
		double t = (a + z) / 2;
		double dF =
		    psd_passing(feed, exp(z)) - psd_passing(feed, exp(a));
		sum += dF * selection_share_at_log_size(&b, t) *
		       b.model->finer(&b, low - t, NULL);
	}
	return sum;
}

static void
the_product_is_that_of_a_fine_sum(void **state)
{
	(void)state;
	struct spectrum *spectrum = made_spectrum(5, 500, 4);
	struct model_settings settings =
	    with(spectrum_group_impacts_by_energy(spectrum, 10));
	for (size_t row = 0; row < 19; row += 3) {
		struct params p = made_params(&TABLE_3[row]);
		struct site *site = made_site(&TABLE_3[row], 0, 1);
		const struct psd *feed = &site->run[1].feed;
		double out[64];
		struct model *model =
		    model_new(feed, feed->size, feed->n, settings);
		model_set_params(model, &p);
		model_compute_product(model, 74, out);
		for (size_t i = 0; i < feed->n; i += 2)
			expect_near(TABLE_3[row].site, out[i],
			    summed(feed, &p, &settings, 74, feed->size[i]),
			    1e-4);
		model_free(model);
		site_free(site);
	}
	spectrum_free(spectrum);
}

static void
its_derivatives_are_those_of_differences(void **state)
{
	(void)state;
	struct spectrum *spectrum = made_spectrum(6, 500, 4);
	struct model_settings settings =
	    with(spectrum_group_impacts_by_energy(spectrum, 10));
	struct params p = made_params(&TABLE_3[TIERP]);
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	const struct psd *feed = &site->run[1].feed;
	struct model *model = model_new(feed, feed->size, feed->n, settings);
	double at[64], plus[64], minus[64], d[64 * PARAMS_MOST];
	model_set_params(model, &p);
	model_jacobian(model, 74, at, d);
	for (size_t j = 4; j < 7; j++) {
		double h = 1e-5 * p.at[j];
		struct params moved = p;
		moved.at[j] = p.at[j] + h;
		model_set_params(model, &moved);
		model_compute_product(model, 74, plus);
		moved.at[j] = p.at[j] - h;
		model_set_params(model, &moved);
		model_compute_product(model, 74, minus);
		for (size_t i = 0; i < feed->n; i++) {
			double want = (plus[i] - minus[i]) / (2 * h);
			expect_near("derivative", d[i * 7 + j], want,
			    2e-3 * fabs(want) + 1e-5);
		}
	}
	model_free(model);
	site_free(site);
	spectrum_free(spectrum);
}

/* The search's coarser scheme, whose misfit is that of the accurate one to the
 * same 0.1 points a sieve as without a spectrum. */
static void
the_search_sees_the_same_product(void **state)
{
	(void)state;
	struct spectrum *spectrum = made_spectrum(7, 500, 4);
	const bool train[3] = {true, true, true};
	for (int classes = 0; classes < 2; classes++) {
		struct model_settings settings =
		    with(spectrum_group_impacts_by_energy(spectrum, 10));
		settings.method = classes ? METHOD_CLASSES : METHOD_CONTINUOUS;
		struct params p = made_params(&TABLE_3[TIERP]);
		struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
		for (size_t r = 0; r < site->n_run; r++) {
			struct run *run = &site->run[r];
			struct model *model = model_new(&run->feed,
			    run->product.size, run->product.n, settings);
			model_set_params(model, &p);
			model_compute_product(
			    model, run->speed, run->product.passing);
			model_free(model);
		}
		struct misfit *m =
		    misfit_new(site, train, NULL, false, settings);
		double misfit[KERNEL_LANES];
		struct herd herd = herd_new(1);
		herd_put(&herd, 0, &p);
		herd_evaluate(m, ISA_BEST, 1, &herd, misfit);
		double cells = 3 * (double)site->run[0].product.n;
		expect_near("RMSE of the kernel", sqrt(misfit[0] / cells), 0,
		    classes ? 1e-8 : 1e-3);
		herd_free(&herd);
		misfit_free(m);
		site_free(site);
	}
	spectrum_free(spectrum);
}

static void
scaled_spectra_of_two_speeds_are_one(void **state)
{
	(void)state;
	struct spectrum *a = made_spectrum(8, 3000, 3), *b = spectrum_new();
	struct draw draw = draw_start(8);
	b->speed = 2 * 74;
	b->counted = true;
	for (size_t i = 0; i < 3000; i++)
		for (size_t j = 0; j < 3; j++)
			spectrum_add_impact(b, 0.008, 0.001,
			    4 * draw_log(&draw, 1, j == 0 ? 2738 : 1000),
			    j == 0);
	expect_near("same", spectrum_ks_distance(a, b, 10), 0, 1e-3);
	spectrum_add_impact(b, 0.008, 3, 4 * 2000, false);
	assert_true(spectrum_ks_distance(a, b, 10) > 0.2);
	spectrum_free(a);
	spectrum_free(b);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(counts_what_was_put_in),
	    cmocka_unit_test(a_single_impact_at_tip_speed_is_the_paper),
	    cmocka_unit_test(twelve_groups_stand_for_all_impacts),
	    cmocka_unit_test(the_product_is_that_of_a_fine_sum),
	    cmocka_unit_test(its_derivatives_are_those_of_differences),
	    cmocka_unit_test(the_search_sees_the_same_product),
	    cmocka_unit_test(scaled_spectra_of_two_speeds_are_one)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
