/* Control charts: how often they signal without and with drift, and that what
 * is not known of the truth does not make them signal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fitted.h"

#include <stdlib.h>

#include "core/check/control_chart.h"
#include "core/posterior/ensemble.h"

/* Montgomery, Introduction to Statistical Quality Control, table 9.4: the mean
 * run length of a CUSUM of both sides with k = 0.5.  There are two here, so
 * that without drift it is half of that. */
static void
run_lengths_are_those_of_the_textbook(void **state)
{
	(void)state;
	struct drift_rule r = {0.5, 5, 0.2, INFINITY, 2};
	expect_near("h 5", drift_mean_run_length(&r, 0, 1), 465.0 / 2, 18);
	expect_near("shift 1", drift_mean_run_length(&r, 1, 1), 10.4, 0.4);
	expect_near("shift 2", drift_mean_run_length(&r, 2, 1), 4.01, 0.1);
	r.h = 4;
	expect_near("h 4", drift_mean_run_length(&r, 0, 1), 168.0 / 2, 6);
	/* Lucas and Saccucci 1990: 500 with limits that stay; the exact ones
	 * are narrower at first. */
	struct drift_rule e = {0.5, INFINITY, 0.2, 2.962, 2};
	double own = drift_mean_run_length(&e, 0, 1);
	assert_true(own > 225 && own < 275);
	assert_true(drift_mean_run_length(&e, 0, 1) == own);
}

enum { SIEVES = 6, DRAWS = 256, LONG = 30 };
static const double SIZE[SIEVES] = {8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4};

/* Draws that differ by an offset of all sieves with a standard deviation of one
 * point, and samples that err by one at each sieve. */
struct made_up {
	double truth[SIEVES * DRAWS], error[SIEVES * SIEVES];
	double residual[LONG][SIEVES];
	struct drift_cut cut[LONG];
};

static void
make(struct made_up *m, uint64_t seed, double offset, size_t from, double shift)
{
	const double sd = 0.01;
	struct rng_key key = rng_make_key(seed, 0, 1),
		       own = rng_make_key(0, 0, 2);
	*m = (struct made_up){.error = {0}};
	for (size_t i = 0; i < SIEVES; i++) {
		m->error[i * SIEVES + i] = sd * sd;
		for (size_t d = 0; d < DRAWS; d++)
			m->truth[i * DRAWS + d] =
			    0.5 + sd * rng_normal(own, (uint32_t)d);
	}
	for (size_t j = 0; j < LONG; j++) {
		for (size_t i = 0; i < SIEVES; i++)
			m->residual[j][i] =
			    sd * (offset + rng_normal(key,
					       (uint32_t)(j * SIEVES + i))) +
			    (j >= from ? shift : 0);
		m->cut[j] = (struct drift_cut){
		    SIEVES, SIZE, m->residual[j], DRAWS, m->truth, m->error};
	}
}

/* The offset is learnt: scores are standard normal, but for what Student's t
 * leaves for errors of another size, and independent; they signal no more often
 * than they say.  Values over their standard deviation would
 * signal in one of three sequences. */
static void
an_unknown_truth_is_no_drift(void **state)
{
	(void)state;
	enum { MANY = 400 };
	static struct made_up m;
	struct drift_point point[LONG];
	struct rng_key key = rng_make_key(7, 0, 3);
	double square = 0, next = 0;
	size_t since, signals = 0, naive = 0;
	for (uint64_t q = 0; q < MANY; q++) {
		make(&m, q, rng_normal(key, (uint32_t)q), LONG, 0);
		signals += drift_compute_charts(
			       m.cut, LONG, &DRIFT_RULE, point, &since) < LONG;
		const struct drift_rule never = {0.5, 1e9, 0.2, 1e9, 2};
		drift_compute_charts(m.cut, LONG, &never, point, &since);
		double up = 0, down = 0, most = 0;
		for (size_t j = 0; j < LONG; j++) {
			const struct drift_chart *c = &point[j].chart[0];
			double sd = hypot(c->truth, c->error);
			square += c->score * c->score;
			if (j > 0)
				next += c->score * point[j - 1].chart[0].score;
			up = fmax(0, up + c->value / sd - 0.5);
			down = fmax(0, down - c->value / sd - 0.5);
			most = fmax(most, fmax(up, down));
		}
		naive += most > 5;
	}
	expect_near("variance", square / (MANY * LONG), 0.92, 0.05);
	expect_near("correlation", next / (MANY * (LONG - 1)), 0, 0.03);
	/* One in 150 to 200 samples: of 30, 14 % or so; fewer while the size
	 * of the errors is being learnt. */
	double length = drift_mean_run_length(&DRIFT_RULE, 0, 1);
	double expected = MANY * -expm1(-LONG / length);
	assert_true(length > 130 && length < 220);
	assert_true((double)signals < expected + 3 * sqrt(expected));
	assert_true((double)signals > expected / 4);
	assert_true(naive > 2 * signals);
}

/* The posterior's size of the errors is wrong by a factor: the cuts show it, and
 * signals are as rare as stated, but for the first cuts. */
static void
the_size_of_errors_is_learnt(void **state)
{
	(void)state;
	enum { MANY = 400 };
	static struct made_up m;
	struct drift_point point[LONG];
	struct rng_key key = rng_make_key(7, 0, 3);
	double expected =
	    MANY * -expm1(-LONG / drift_mean_run_length(&DRIFT_RULE, 0, 1));
	for (double larger = 0.6; larger < 2.5; larger += 0.6) {
		size_t since, signals = 0;
		for (uint64_t q = 0; q < MANY; q++) {
			make(&m, q, rng_normal(key, (uint32_t)q), LONG, 0);
			for (size_t j = 0; j < LONG; j++)
				for (size_t i = 0; i < SIEVES; i++)
					m.residual[j][i] *= larger;
			signals += drift_compute_charts(m.cut, LONG,
				       &DRIFT_RULE, point, &since) < LONG;
		}
		print_message("errors %g times as large: %zu signals of %d, "
			      "stated %.0f\n",
		    larger, signals, MANY, expected);
		assert_true((double)signals > expected / 10);
		assert_true((double)signals < 2 * expected);
	}
}

/* What is said of a step is what happens on sequences like those seen: half of
 * the steps are signalled by then, no earlier. */
static void
steps_are_signalled_as_said(void **state)
{
	(void)state;
	enum { MANY = 300, QUIET = 12 };
	static struct made_up m;
	struct drift_point point[LONG];
	struct rng_key key = rng_make_key(9, 0, 3);
	size_t since, by = 0, before = 0, all = 0;
	for (uint64_t q = 0; q < MANY; q++) {
		make(&m, q, rng_normal(key, (uint32_t)q), QUIET, 0.008);
		size_t first = drift_compute_charts(
		    m.cut, LONG, &DRIFT_RULE, point, &since);
		double said = drift_detection_delay(
		    &DRIFT_RULE, point, QUIET, QUIET, 0.008, q);
		if (first < QUIET)
			continue;
		all++;
		by += (double)(first - QUIET + 1) <= said;
		before += (double)(first - QUIET + 1) < said - 1;
	}
	print_message("signalled by then %zu of %zu, by the cut before the "
		      "last %zu\n",
	    by, all, before);
	assert_true(2 * by > all && 2 * before < all);
}

static void
a_step_is_found_and_dated(void **state)
{
	(void)state;
	static struct made_up m;
	struct drift_point point[LONG];
	size_t since, first;
	make(&m, 3, 0.5, 12, -0.015);
	first = drift_compute_charts(m.cut, LONG, &DRIFT_RULE, point, &since);
	assert_in_range(first, 12, 16);
	assert_in_range(since, 11, 13);
	for (size_t i = first; i < LONG; i++)
		assert_int_equal(point[i].state, DRIFT_COARSER);
	make(&m, 3, 0.5, 12, 0.015);
	first = drift_compute_charts(m.cut, LONG, &DRIFT_RULE, point, &since);
	assert_int_equal(point[first].state, DRIFT_FINER);
	/* Coarse sieves pass more, fine ones less. */
	make(&m, 4, 0, LONG, 0);
	for (size_t j = 8; j < LONG; j++)
		for (size_t i = 0; i < SIEVES; i++)
			m.residual[j][i] += i < SIEVES / 2 ? 0.02 : -0.02;
	first = drift_compute_charts(m.cut, LONG, &DRIFT_RULE, point, &since);
	assert_int_equal(point[first].state, DRIFT_STEEPER);
	assert_in_range(first, 8, 12);
	/* One sieve has no tilt. */
	for (size_t j = 0; j < LONG; j++)
		m.cut[j].n = 1;
	drift_compute_charts(m.cut, LONG, &DRIFT_RULE, point, &since);
	for (size_t j = 0; j < LONG; j++)
		assert_true(point[j].chart[DRIFT_TILT].score == 0);
}

/* A calibrated site: its posterior, its answers at the speeds. */
struct plant {
	struct site *site;
	struct posterior *posterior;
	struct ensemble *ensemble;
	const struct psd *feed;
	size_t n; /* of sieves that crushing can change */
	const double *size;
	double *truth[3], *mean[3], *error[3];
};

static struct plant
plant(void)
{
	static const bool use[3] = {true, false, true};
	struct plant p = {.site = made_site(&TABLE_3[TIERP], 0.005, 3)};
	struct calibrate_options o = quick_options(3);
	struct fit fit = fitted(p.site, &o);
	p.posterior = drawn(p.site, &fit, &o, use);
	p.feed = &p.site->run[1].feed;
	p.n = p.feed->n - 1;
	p.size = p.feed->size + 1;
	p.ensemble = ensemble_new(p.posterior, p.feed, p.size, p.n);
	for (size_t v = 0; v < 3; v++) {
		ensemble_set_speed(p.ensemble, 69 + 4 * (double)v);
		p.truth[v] = xcalloc_doubles(p.n * POSTERIOR_DRAWS);
		p.mean[v] = xcalloc_doubles(p.n);
		p.error[v] = xcalloc_doubles(p.n * p.n);
		memcpy(p.truth[v],
		    ensemble_products(p.ensemble, ENSEMBLE_ANSWER),
		    p.n * POSTERIOR_DRAWS * sizeof(double));
		ensemble_mean_answer(p.ensemble, p.mean[v]);
		drift_covariance_of_errors(
		    p.posterior, p.size, p.mean[v], p.n, p.error[v]);
	}
	return p;
}

/* Samples at 69, 73 and 77 m/s in turn where draw d is the truth; the error of
 * each is that of some draw's sample: of another draw than the posterior holds
 * beside it. */
static size_t
first_signal(const struct plant *p, size_t n, uint64_t q)
{
	struct rng_key key = rng_make_key(11, q, 5);
	struct drift_cut *cut = xcalloc(n, sizeof *cut);
	struct drift_point *point = xcalloc(n, sizeof *point);
	double *residual = xcalloc_doubles(n * p->n);
	size_t d = rng_random_bits(key, 0) % POSTERIOR_DRAWS, since;
	for (size_t j = 0; j < n; j++) {
		size_t v = j % 3;
		struct rng_key own = rng_make_key(13 + q, j, 6);
		const double *hyper = p->posterior->draw[d].hyper;
		double *U = xcalloc_doubles(p->n * p->n),
		       *z = xcalloc_doubles(p->n);
		for (size_t a = 0; a < p->n; a++) {
			z[a] = rng_normal(own, (uint32_t)a);
			for (size_t b = 0; b <= a; b++)
				U[b * p->n + a] =
				    discrepancy_shared_covariance(
					log(p->size[a] / p->size[b]), hyper) +
				    (a == b ? hyper[HYPER_OWN] *
						  hyper[HYPER_OWN]
					    : 0);
		}
		discrepancy_cholesky(ISA_BEST, U, p->n);
		for (size_t a = 0; a < p->n; a++) {
			double e = 0;
			for (size_t b = 0; b <= a; b++)
				e += U[b * p->n + a] * z[b];
			residual[j * p->n + a] =
			    p->truth[v][a * POSTERIOR_DRAWS + d] +
			    discrepancy_scale_at_passing(p->mean[v][a]) * e -
			    p->mean[v][a];
		}
		cut[j] = (struct drift_cut){p->n, p->size, residual + j * p->n,
		    POSTERIOR_DRAWS, p->truth[v], p->error[v]};
		free(U);
		free(z);
	}
	size_t first = drift_compute_charts(cut, n, &DRIFT_RULE, point, &since);
	free(cut);
	free(point);
	free(residual);
	return first;
}

/* What the posterior says of sites like its own happens as often as stated. */
static void
false_signals_are_as_rare_as_stated(void **state)
{
	(void)state;
	enum { MANY = 300, CUTS = 40 };
	struct plant p = plant();
	size_t signals = 0;
	for (uint64_t q = 0; q < MANY; q++)
		signals += first_signal(&p, CUTS, q) < CUTS;
	double length = drift_mean_run_length(&DRIFT_RULE, 0, 1);
	double expected = MANY * -expm1(-CUTS / length);
	print_message("false signals in %d sequences of %d: %zu, stated %.0f\n",
	    MANY, CUTS, signals, expected);
	assert_true((double)signals > 0.3 * expected);
	assert_true((double)signals < 1.5 * expected);
	for (size_t v = 0; v < 3; v++) {
		free(p.truth[v]);
		free(p.mean[v]);
		free(p.error[v]);
	}
	ensemble_free(p.ensemble);
	posterior_free(p.posterior);
	site_free(p.site);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(run_lengths_are_those_of_the_textbook),
	    cmocka_unit_test(an_unknown_truth_is_no_drift),
	    cmocka_unit_test(the_size_of_errors_is_learnt),
	    cmocka_unit_test(steps_are_signalled_as_said),
	    cmocka_unit_test(a_step_is_found_and_dated),
	    cmocka_unit_test(false_signals_are_as_rare_as_stated)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
