/* The posterior: the same bits anywhere, bounds kept, parts told apart, and
 * bands that hold the truth.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "made.h"

#include <stdlib.h>
#include <string.h>

#include "core/calibrate.h"
#include "core/ensemble.h"

struct known {
	struct site *site;
	struct params truth;
	bool use[8];
	struct calibrate_options options;
	struct fit fit;
};

/* A made-up site, calibrated at 69 and 79 m/s. */
static struct known
known(size_t row, double noise, uint64_t seed)
{
	struct known k = {.site = made_site(&TABLE_3[row], noise, seed),
	    .truth = made_params(&TABLE_3[row]),
	    .use = {true, false, true},
	    .options = calibrate_options_default()};
	k.options.population = 1000;
	k.options.seed = seed;
	struct calibration *c = calibration_new(k.site, &k.options);
	while (calibration_step(c) < CALIBRATE_TOLERANCE)
		;
	k.fit = calibration_fit(c);
	calibration_free(c);
	return k;
}

static struct posterior *
posterior_of(const struct known *k, unsigned threads, enum isa isa)
{
	struct posterior_options o = {.use = k->use,
	    .settings = k->fit.settings,
	    .bounds = k->options.bounds,
	    .seed = k->options.seed,
	    .threads = threads,
	    .isa = isa};
	return posterior_new(k->site, &k->fit.params, &o);
}

/* All threads and instruction sets draw the same. */
static void
test_bits(void **state)
{
	(void)state;
	struct known k = known(TIERP, 0.005, 3);
	struct posterior *one = posterior_of(&k, 1, ISA_BASE);
	struct posterior *two = posterior_of(&k, 3, ISA_BEST);
	for (size_t i = 0; i < POSTERIOR_DRAWS; i++) {
		const struct posterior_draw *a = &one->draw[i];
		const struct posterior_draw *b = &two->draw[i];
		assert_memory_equal(&a->params, &b->params, sizeof a->params);
		assert_memory_equal(a->hyper, b->hyper, sizeof a->hyper);
		assert_memory_equal(
		    a->term[0], b->term[0], one->n_knot * sizeof *a->term[0]);
	}
	assert_true(one->ratio == two->ratio && one->drift == two->drift);
	posterior_free(one);
	posterior_free(two);
	site_free(k.site);
}

/* The paper's model gains gamma; what is held fixed stays, bounds hold. */
static void
test_bounds(void **state)
{
	(void)state;
	struct known k = known(2, 0.005, 1);
	struct bounds *b = &k.options.bounds;
	b->lower[6] = b->upper[6] = k.fit.params.alpha;
	struct posterior *p = posterior_of(&k, 1, ISA_BEST);
	const struct breakage *of = BREAKAGES[p->settings.breakage];
	size_t gamma = breakage_parameter(of, "gamma");
	double least = 1e9, most = -1e9;
	assert_true(gamma < of->n);
	for (size_t i = 0; i < POSTERIOR_DRAWS; i++) {
		const struct params *q = &p->draw[i].params;
		assert_true(q->alpha == k.fit.params.alpha);
		assert_true(q->f_mat >= b->lower[4] && q->f_mat <= b->upper[4]);
		assert_true(
		    q->e0_min >= b->lower[5] && q->e0_min <= b->upper[5]);
		least = fmin(least, q->at[gamma]);
		most = fmax(most, q->at[gamma]);
	}
	assert_true(least < 0 && most > 0 && most - least < 2);
	posterior_free(p);
	site_free(k.site);
}

/* A draw's products never rise towards finer sizes, are never coarser than the
 * feed, and where nothing is left out and nothing errs the parts agree. */
static void
test_parts(void **state)
{
	(void)state;
	enum { N = POSTERIOR_DRAWS };
	struct known k = known(TIERP, 0.005, 2);
	struct posterior *p = posterior_of(&k, 1, ISA_BEST);
	const struct psd *feed = &k.site->run[1].feed;
	struct ensemble *e = ensemble_new(p, feed, feed->size, feed->n);
	double *model = xdoubles(feed->n);
	ensemble_at(e, 74);
	for (enum ensemble_part part = 0; part < ENSEMBLE_PARTS; part++) {
		const double *P = ensemble_products(e, part);
		for (size_t i = 0; i < feed->n * N; i++) {
			assert_true(P[i] >= 0 && P[i] <= 1);
			assert_true(i < N || P[i] <= P[i - N]);
			assert_true(part == ENSEMBLE_SAMPLE ||
				    P[i] >= feed->passing[i / N] - 1e-12);
		}
	}
	struct posterior *plain = p;
	for (size_t i = 0; i < N; i++)
		for (size_t j = 0; j < plain->n_knot; j++) {
			for (size_t t = 0; t < DISCREPANCY_TERMS; t++)
				plain->draw[i].term[t][j] = 0;
			plain->draw[i].shared[j] = plain->draw[i].own[j] = 0;
		}
	ensemble_at(e, 77);
	const double *a = ensemble_products(e, ENSEMBLE_MODEL);
	const double *b = ensemble_products(e, ENSEMBLE_SAMPLE);
	for (size_t i = 0; i < feed->n * N; i++)
		assert_float_equal(a[i], b[i], 1e-12);
	/* The first draw's product, by the exact way: the scheme errs by less
	 * than 0.05 points. */
	struct model *exact = model_new(feed, feed->size, feed->n, p->settings);
	model_set(exact, &p->draw[0].params);
	model_product(exact, 77, model);
	for (size_t i = 0; i < feed->n; i++)
		assert_float_equal(a[i * N], model[i], 5e-4);
	model_free(exact);
	free(model);
	ensemble_free(e);
	posterior_free(p);
	site_free(k.site);
}

/* Of 400 sieves 48 a run inform it, the two ends among them. */
static void
test_many_sieves(void **state)
{
	(void)state;
	enum { MANY = 400 };
	struct known k = known(TIERP, 0, 1);
	for (size_t r = 0; r < k.site->n_run; r++) {
		struct psd *old = &k.site->run[r].product;
		struct psd many = psd_new(MANY);
		double step = log(old->size[0] / old->size[old->n - 1]);
		for (size_t i = 0; i < MANY; i++) {
			many.size[i] =
			    old->size[0] * exp(-step * (double)i / (MANY - 1));
			many.passing[i] = psd_passing(old, many.size[i]);
		}
		many.size[MANY - 1] = old->size[old->n - 1];
		psd_free(old);
		*old = many;
	}
	struct posterior *p = posterior_of(&k, 1, ISA_BEST);
	assert_int_equal(p->n_cell, 96);
	assert_true(fabs(p->knot[p->n_knot - 1] - log(63e-6)) < 1e-6);
	posterior_free(p);
	site_free(k.site);
}

/* Counts the sieves at 74 m/s whose true passing the middle 80 % holds; sieves
 * that pass all or next to nothing are left out. */
static void
count(const struct known *k, struct ensemble *e, size_t *in, size_t *all)
{
	enum { N = POSTERIOR_DRAWS };
	const struct run *run = &k->site->run[1];
	double row[N], low, high, *truth = xdoubles(run->feed.n);
	struct model *model = model_new(
	    &run->feed, run->feed.size, run->feed.n, model_settings_default());
	model_set(model, &k->truth);
	model_product(model, 74, truth);
	ensemble_at(e, 74);
	for (size_t i = 0; i < run->feed.n; i++) {
		memcpy(row, ensemble_products(e, ENSEMBLE_ANSWER) + i * N,
		    sizeof row);
		ensemble_middle(row, 0.8, &low, &high);
		if (truth[i] < 0.002 || run->feed.passing[i] >= 1)
			continue;
		*in += truth[i] >= low && truth[i] <= high;
		*all += 1;
	}
	model_free(model);
	free(truth);
}

/* Of 20 calibrations; bench/coverage counts thousands. */
static void
test_bands_hold(void **state)
{
	(void)state;
	size_t in = 0, all = 0;
	for (uint64_t seed = 1; seed <= 20; seed++) {
		struct known k = known(TIERP, 0.005, seed);
		struct posterior *p = posterior_of(&k, 1, ISA_BEST);
		const struct psd *feed = &k.site->run[1].feed;
		struct ensemble *e = ensemble_new(p, feed, feed->size, feed->n);
		assert_true(p->drift < 0.8);
		count(&k, e, &in, &all);
		ensemble_free(e);
		posterior_free(p);
		site_free(k.site);
	}
	print_message("held at %zu of %zu sieves\n", in, all);
	assert_in_range(in, all * 72 / 100, all * 96 / 100);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_bits),
	    cmocka_unit_test(test_bounds),
	    cmocka_unit_test(test_parts),
	    cmocka_unit_test(test_many_sieves),
	    cmocka_unit_test(test_bands_hold),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
