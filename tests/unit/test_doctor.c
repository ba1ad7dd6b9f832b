/* What is wrong with a sheet is found, and mends do what they say.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fitted.h"

#include <stdlib.h>

#include "base/xalloc.h"
#include "core/check/loo.h"
#include "core/check/outliers.h"
#include "core/numeric/rng.h"
#include "core/model/synth.h"

enum { SITES = 6 };

static struct site *
site_of(uint64_t seed)
{
	static const double SPEED[] = {69, 74, 79};
	struct rng_key key = rng_make_key(seed, 0, 5);
	struct synth synth = {.top_size = 0.008 + 0.008 * rng_uniform(key, 0),
	    .params = {.beta = {0.2, 1, -1, 0.5},
		.f_mat = 0.8 + rng_uniform(key, 1),
		.e0_min = 12 + 6 * rng_uniform(key, 2),
		.alpha = 0.95},
	    .n = 0.8 + 0.4 * rng_uniform(key, 3),
	    .noise = 0.005,
	    .seed = seed,
	    .n_speed = 3,
	    .speed = SPEED};
	return synth_make_site(&synth);
}

static struct posterior *
posterior_of(const struct site *site)
{
	bool use[3] = {true, true, true};
	struct calibrate_options o = quick_options(1);
	struct fit fit = fitted(site, &o);
	return drawn(site, &fit, &o, use);
}

/* The first sieve at which a passing of the product can be so much more and
 * leave the order, in the middle of the curve. */
static size_t
sieve_for(const struct psd *psd, double off)
{
	size_t i = 1;
	while (psd->passing[i] > 0.8 ||
	       psd->passing[i] + off > psd->passing[i - 1])
		i++;
	assert_true(i + 1 < psd->n && psd->passing[i] > 0.1);
	return i;
}

/* A wrong passing of 5 points is named, at its run and sieve and with what it
 * should be; a sheet without one is left in peace. */
static void
a_wrong_cell_is_named(void **state)
{
	(void)state;
	size_t found = 0, alarms = 0;
	for (uint64_t seed = 1; seed <= SITES; seed++) {
		struct site *site = site_of(seed);
		struct posterior *p = posterior_of(site);
		struct outlier_findings d = outliers_find(site, p, 0);
		alarms += d.n > 0;
		outliers_free(&d);
		posterior_free(p);
		size_t r = seed % 3;
		struct psd *psd = &site->run[r].product;
		size_t i = sieve_for(psd, 0.05);
		double right = psd->passing[i];
		psd->passing[i] += 0.05;
		p = posterior_of(site);
		d = outliers_find(site, p, 0);
		found += d.n == 1 && !d.finding[0].mend.feed &&
			 d.finding[0].mend.run == r &&
			 d.finding[0].mend.size == psd->size[i] &&
			 fabs(d.finding[0].expected - right) < 0.02;
		outliers_free(&d);
		posterior_free(p);
		site_free(site);
	}
	assert_true(found >= SITES - 1);
	assert_true(alarms == 0);
}

/* Curves of Rosin and Rammler whose size leaps between two speeds, as no law of
 * breakage has it, on a feed with the corner of the screen that it was cut by:
 * no cell is told of. */
static void
a_law_that_is_wrong_accuses_no_cell(void **state)
{
	static const double SHARE[] = {0.4, 0.39, 0.32}; /* of the top size */
	(void)state;
	for (uint64_t seed = 1; seed <= SITES; seed++) {
		struct site *site = site_of(seed);
		struct rng_key key = rng_make_key(seed, 0, 6);
		for (size_t r = 0; r < 3; r++) {
			struct psd *psd = &site->run[r].product;
			double size = SHARE[r] * site->top_size;
			for (size_t i = 1; i < psd->n; i++) {
				double u = psd->size[i] / size;
				double P = psd_passing(
				    &site->run[r].feed, psd->size[i]);
				P = fmax(P, -expm1(-u));
				P += 0.004 * sqrt(P * (1 - P)) *
				     rng_normal(key, (uint32_t)(20 * r + i));
				psd->passing[i] = fmin(
				    round(1e4 * P) / 1e4, psd->passing[i - 1]);
			}
		}
		struct posterior *p = posterior_of(site);
		struct outlier_findings d = outliers_find(site, p, 0);
		assert_int_equal(d.n, 0);
		outliers_free(&d);
		posterior_free(p);
		site_free(site);
	}
}

/* Bounds within which passings could move by 10^10 leave no less to say: all
 * numbers are finite, and none changes by more than bounds that are wide. */
static void
wide_bounds_leave_numbers(void **state)
{
	(void)state;
	struct site *site = site_of(2);
	struct posterior *p = posterior_of(site);
	struct leave_out_shift wide[2];
	for (size_t k = 0; k < 2; k++) {
		for (size_t j = 0; j < 4; j++) {
			p->bounds.lower[j] = k == 0 ? -1e3 : -1e10;
			p->bounds.upper[j] = -p->bounds.lower[j];
		}
		struct leave_out *l = leave_out_new(site, p, 0);
		for (size_t c = 0; c < leave_out_count_cells(l); c++) {
			struct leave_out_shift s =
			    leave_out_shift_of_cell(l, c);
			assert_true(isfinite(s.z) && isfinite(s.gain));
			assert_true(s.sd > 0 && isfinite(s.sd));
			if (c == 5)
				wide[k] = s;
		}
		leave_out_free(l);
	}
	expect_near("sd", wide[1].sd, wide[0].sd, 0.1 * wide[0].sd);
	posterior_free(p);
	site_free(site);
}

/* 34.6 for 36.4: the two digits about the point change places. */
static double
transposed(double passing)
{
	int tenths = (int)round(passing * 1000);
	int other = tenths / 100 * 100 + tenths % 10 * 10 + tenths / 10 % 10;
	return other / 1000.0;
}

/* Digits that were transposed are read the right way round, in the first cell
 * of some sites where that changes 4 points or more and leaves the order. */
static void
transposed_digits_are_read(void **state)
{
	(void)state;
	size_t tried = 0;
	for (uint64_t seed = 1; seed < 40 && tried < 3; seed++) {
		struct site *site = site_of(seed);
		struct psd *psd = &site->run[1].product;
		size_t i = 2;
		double right = 0, wrong = 0;
		for (; i + 1 < psd->n; i++) {
			right = round(psd->passing[i] * 1000) / 1000;
			wrong = transposed(right);
			if (fabs(wrong - right) > 0.04 &&
			    wrong < psd->passing[i - 1] &&
			    wrong > psd->passing[i + 1])
				break;
		}
		if (i + 1 < psd->n) {
			psd->passing[i] = wrong;
			struct posterior *p = posterior_of(site);
			struct outlier_findings d = outliers_find(site, p, 0);
			assert_int_equal(d.n, 1);
			assert_int_equal(d.finding[0].mend.kind, MEND_READ);
			assert_true(
			    fabs(d.finding[0].mend.value - right) < 1e-9);
			assert_true(
			    d.finding[0].rmse[1] < d.finding[0].rmse[0]);
			outliers_free(&d);
			posterior_free(p);
			tried++;
		}
		site_free(site);
	}
	assert_int_equal(tried, 3);
}

static void
assert_curves_equal(const struct psd *p, const struct psd *right)
{
	for (size_t i = 0; i < right->n; i++) {
		assert_true(p->passing[i] == right->passing[i]);
		assert_true(fabs(p->size[i] / right->size[i] - 1) < 1e-9);
	}
}

/* Two products at each other's speed; a column one row too low; a product in
 * the feed's column; a copy; micrometres.  Each mend brings the site back. */
static void
columns_are_put_right(void **state)
{
	(void)state;
	for (size_t kind = 0; kind < 5; kind++) {
		static const enum mend_kind KIND[] = {MEND_SWAP_RUNS, MEND_UP,
		    MEND_SWAP_FEED, MEND_DROP, MEND_SCALE};
		struct site *site = site_of(2);
		struct run *a = &site->run[0], *b = &site->run[2];
		struct psd was = a->product;
		if (kind == 0) {
			a->product = b->product;
			b->product = was;
		} else if (kind == 1) {
			for (size_t i = 0; i + 1 < was.n; i++)
				was.size[i] = was.size[i + 1];
			a->product.n--;
		} else if (kind == 2) {
			site->individual_feeds = true;
			a->product = a->feed;
			a->feed = was;
		} else if (kind == 3) {
			memcpy(b->product.passing, site->run[1].product.passing,
			    b->product.n * sizeof(double));
		} else {
			for (size_t i = 0; i < was.n; i++)
				was.size[i] *= 1000;
		}
		struct outlier_findings d = outliers_find(site, NULL, 0);
		assert_int_equal(d.n, 1);
		assert_int_equal(d.finding[0].mend.kind, KIND[kind]);
		struct site *mended =
		    site_with_mend(site, &d.finding[0].mend, NULL);
		assert_non_null(mended);
		struct site *right = site_of(2);
		for (size_t r = 0; r < mended->n_run && kind != 1; r++)
			assert_curves_equal(
			    &mended->run[r].product, &right->run[r].product);
		struct outlier_findings none = outliers_find(mended, NULL, 0);
		assert_int_equal(none.n, 0);
		assert_non_null(strstr(mended->provenance, "; mended: "));
		outliers_free(&none);
		outliers_free(&d);
		site_free(right);
		site_free(mended);
		site_free(site);
	}
}

/* The digest follows the numbers, what cannot be is refused, and the first
 * clause of the provenance says that something was mended, once. */
static void
mends_say_what_they_did(void **state)
{
	(void)state;
	struct site *site = site_of(3);
	struct error error = {.kind = ERROR_NONE};
	double size = site->run[1].product.size[4];
	struct mend m = {.kind = MEND_READ, .run = 1, .size = size, .value = 2};
	assert_null(site_with_mend(site, &m, &error));
	assert_int_equal(error.kind, ERROR_USAGE);
	m.kind = MEND_OUT;
	struct site *one = site_with_mend(site, &m, NULL);
	assert_int_equal(one->run[1].product.n + 1, site->run[1].product.n);
	assert_true(one->digest != site->digest);
	assert_true(one->digest == site_digest(one));
	assert_string_equal(site_data_kind(one->provenance), "not stated");
	assert_null(site_with_mend(one, &m, NULL));
	m.run = 2;
	struct site *two = site_with_mend(one, &m, NULL);
	char *source = site_provenance_first_clause(two, "");
	assert_string_equal(source, "not stated, mended");
	free(source);
	m.feed = true;
	struct site *three = site_with_mend(two, &m, NULL);
	for (size_t r = 0; r < 3; r++)
		assert_int_equal(three->run[r].feed.n + 1, site->run[r].feed.n);
	site_free(three);
	site_free(two);
	site_free(one);
	site_free(site);
}

/* The coarsest cell of a product that can be 20 points lower and keep the
 * order is one wrong cell, though the faster product is then the coarser one
 * on the whole. */
static void
a_large_slip_is_no_exchange(void **state)
{
	(void)state;
	size_t tried = 0;
	for (uint64_t seed = 1; seed <= SITES; seed++) {
		struct site *site = site_of(seed);
		struct psd *psd = &site->run[1].product;
		size_t i = 1;
		/* Speeds so near that one cell outweighs them. */
		for (size_t k = 0; k < psd->n; k++) {
			double p = psd->passing[k], by = 0.04 * p * (1 - p);
			site->run[0].product.passing[k] = p - by;
			site->run[2].product.passing[k] = p + by;
		}
		while (i + 1 < psd->n &&
		       psd->passing[i] - 0.2 < psd->passing[i + 1])
			i++;
		if (i + 1 < psd->n) {
			tried++;
			psd->passing[i] -= 0.2;
			struct outlier_findings d =
			    outliers_find(site, NULL, 0);
			assert_int_equal(d.n, 1);
			assert_true(d.finding[0].mend.kind != MEND_SWAP_RUNS);
			assert_int_equal(d.finding[0].mend.run, 1);
			assert_true(d.finding[0].mend.size == psd->size[i]);
			outliers_free(&d);
		}
		site_free(site);
	}
	assert_true(tried > 2);
}

/* A feed alone, or one product, has no mend and does no harm. */
static void
little_is_looked_at_too(void **state)
{
	(void)state;
	struct site *site = site_of(4);
	for (size_t n = 3; n-- > 1;) {
		struct mend m = {.kind = MEND_DROP, .run = n};
		struct site *less = site_with_mend(site, &m, NULL);
		site_free(site);
		site = less;
	}
	struct outlier_findings d = outliers_find(site, NULL, 0);
	assert_int_equal(d.n, 0);
	outliers_free(&d);
	site->run[0].product.n = 0;
	d = outliers_find(site, NULL, 0);
	assert_int_equal(d.n, 0);
	outliers_free(&d);
	site_free(site);
}

/* Of so many passings that each beside all others would take minutes it says
 * that it does not look, and still finds a column that was copied. */
static void
too_many_are_not_looked_at(void **state)
{
	(void)state;
	enum { RUNS = 120 };
	double speed[RUNS];
	for (size_t r = 0; r < RUNS; r++)
		speed[r] = 66 + 0.15 * (double)r;
	struct site *site = synth_make_site(&(struct synth){.top_size = 0.0112,
	    .params = {.beta = {0.2, 1, -1, 0.5},
		.f_mat = 2,
		.e0_min = 16,
		.alpha = 0.95},
	    .n = 1,
	    .seed = 1,
	    .n_speed = RUNS,
	    .speed = speed});
	struct run *run = site->run;
	psd_free(&run[1].product);
	run[1].product = psd_copy(&run[0].product);
	struct outlier_findings d = outliers_find(site, NULL, 0);
	assert_in_range(d.unseen, OUTLIERS_CELLS_MOST + 1, RUNS * 20);
	assert_int_equal(d.n, 1);
	assert_int_equal(d.finding[0].mend.kind, MEND_DROP);
	outliers_free(&d);
	site_free(site);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_wrong_cell_is_named),
	    cmocka_unit_test(a_law_that_is_wrong_accuses_no_cell),
	    cmocka_unit_test(wide_bounds_leave_numbers),
	    cmocka_unit_test(transposed_digits_are_read),
	    cmocka_unit_test(columns_are_put_right),
	    cmocka_unit_test(a_large_slip_is_no_exchange),
	    cmocka_unit_test(mends_say_what_they_did),
	    cmocka_unit_test(little_is_looked_at_too),
	    cmocka_unit_test(too_many_are_not_looked_at),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
