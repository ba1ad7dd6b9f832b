/* The batch kernel: close to the accurate misfit, and the same bits whatever
 * the lanes, the threads and the instruction set.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "herd.h"
#include "made.h"

/* The misfit of a made-up site at all three speeds. */
static struct misfit *
misfit_of(const struct site *site, struct model_settings settings)
{
	const bool train[3] = {true, true, true};
	return misfit_new(site, train, NULL, false, settings);
}

static struct model_settings
settings_of(int which)
{
	struct model_settings settings = model_settings_default();
	if (which > 0) {
		settings.method = METHOD_CLASSES;
		settings.appearance = (enum appearance_form)(which - 1);
	}
	return settings;
}

/* What the kernel says of one product sieve, measured at the accurate value:
 * its error there. */
static double
error_set_at(
    const struct psd *feed, double v, const struct params *p, double size)
{
	const bool train = true;
	double misfit[KERNEL_LANES];
	struct site *site = site_new(1);
	struct run *run = &site->run[0];
	run->speed = v;
	run->feed = psd_copy(feed);
	run->product = psd_new(1);
	run->product.size[0] = size;
	made_product(run, p, run->product.passing);
	struct misfit *m =
	    misfit_new(site, &train, NULL, false, model_settings_default());
	struct herd herd = herd_new(1);
	herd_put(&herd, 0, p);
	herd_evaluate(m, ISA_BEST, 1, &herd, misfit);
	herd_free(&herd);
	misfit_free(m);
	site_free(site);
	return sqrt(misfit[0]);
}

static double
worst_error(const struct table_row *row, const struct params *p)
{
	double worst = 0;
	struct site *site = made_site(row, 0, 1);
	const struct psd *feed = &site->run[1].feed;
	for (double v = 65; v <= 85; v += 1)
		for (size_t i = 0; i < feed->n; i++)
			worst = fmax(
			    worst, error_set_at(feed, v, p, feed->size[i]));
	site_free(site);
	return worst;
}

/* Measured: 0.028 points at the rows themselves. */
static void
no_sieve_is_off_by_more_than_0_05_points_at_table_3(void **state)
{
	(void)state;
	for (size_t row = 0; row < ARRAY_LEN(TABLE_3); row++) {
		struct params p = made_params(&TABLE_3[row]);
		double points = 100 * worst_error(&TABLE_3[row], &p);
		if (!(points <= 0.05))
			fail_msg("row %zu: %g points", row, points);
	}
}

/* With p(u) above 0 from 2^-10 to 1; where it is clipped to a short piece the
 * kernel's 33 nodes see little of it. */
static void
and_by_no_more_near_table_3(void **state)
{
	(void)state;
	struct draw draw = draw_start(41);
	double worst = 0;
	for (size_t row = 0; row < 3 * ARRAY_LEN(TABLE_3); row++) {
		struct params p = made_params(&TABLE_3[row % 19]);
		p.beta[0] = draw_between(&draw, 0, 0.2);
		for (size_t j = 1; j < PARAM_COUNT; j++)
			p.at[j] = p.at[j] * draw_between(&draw, 0.9, 1.1);
		worst = fmax(worst, worst_error(&TABLE_3[row % 19], &p));
	}
	if (!(100 * worst <= 0.05))
		fail_msg("%g points", 100 * worst);
}

/* The row's parameters, each changed by up to a tenth. */
static struct params
near(const struct table_row *row, struct draw *draw)
{
	struct params p = made_params(row);
	for (size_t j = 0; j < PARAM_COUNT; j++)
		p.at[j] = p.at[j] * draw_between(draw, 0.9, 1.1);
	return p;
}

/* With weights: of the runs, and of the sieves of one. */
static void
misfit_near_the_truth_is_close_to_the_accurate_one(void **state)
{
	(void)state;
	enum { N = 40 };
	const bool train[3] = {true, true, true};
	const double weight[3] = {4, 0.25, 1};
	struct draw draw = draw_start(42);
	for (size_t row = 0; row < ARRAY_LEN(TABLE_3); row++) {
		struct site *site = made_site(&TABLE_3[row], 0.005, row);
		size_t n = site->run[2].product.n;
		double misfit[N], weights = 4.25 * (double)n;
		site->run[2].product_sd = xcalloc_doubles(n);
		for (size_t i = 0; i < n; i++) {
			double sd = 0.5 + 0.1 * (double)i;
			site->run[2].product_sd[i] = sd;
			weights += 1 / (sd * sd);
		}
		struct misfit *m = misfit_new(
		    site, train, weight, true, model_settings_default());
		struct herd herd = herd_new(N);
		for (size_t i = 0; i < N; i++) {
			struct params p = near(&TABLE_3[row], &draw);
			herd_put(&herd, i, &p);
		}
		herd_evaluate(m, ISA_BEST, 1, &herd, misfit);
		/* 0.05 points on every sieve at most. */
		for (size_t i = 0; i < N; i++) {
			struct params p = herd_get(&herd, i);
			expect_near("root of the misfit", sqrt(misfit[i]),
			    sqrt(misfit_of_params(m, &p)),
			    7e-4 * sqrt(weights));
		}
		herd_free(&herd);
		misfit_free(m);
		site_free(site);
	}
}

static void
classes_agree_to_1e_12(void **state)
{
	(void)state;
	enum { N = 200 };
	double misfit[N];
	for (int form = 1; form <= 3; form++) {
		struct site *site = made_site(&TABLE_3[TIERP], 0.005, 3);
		struct misfit *m = misfit_of(site, settings_of(form));
		struct herd herd = herd_any(N, 43);
		herd_evaluate(m, ISA_BEST, 1, &herd, misfit);
		for (size_t i = 0; i < N; i++) {
			struct params p = herd_get(&herd, i);
			double want = misfit_of_params(m, &p);
			expect_near("misfit", misfit[i], want, 1e-12 * want);
		}
		herd_free(&herd);
		misfit_free(m);
		site_free(site);
	}
}

/* Sieves that the feed lacks, weights of runs, and k impacts. */
static void
classes_agree_on_other_sieves_and_weights(void **state)
{
	(void)state;
	enum { N = 64 };
	double misfit[N];
	const bool train[3] = {true, false, true};
	const double weight[3] = {0.25, 7, 2};
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 4);
	struct psd *product = &site->run[0].product;
	for (size_t i = 0; i < product->n; i++)
		product->size[i] *= 1.13;
	struct model_settings settings = settings_of(1);
	settings.k = 2.5;
	struct misfit *m = misfit_new(site, train, weight, false, settings);
	struct herd herd = herd_any(N, 44);
	herd_evaluate(m, ISA_BEST, 1, &herd, misfit);
	for (size_t i = 0; i < N; i++) {
		struct params p = herd_get(&herd, i);
		double want = misfit_of_params(m, &p);
		expect_near("misfit", misfit[i], want, 1e-12 * want);
	}
	herd_free(&herd);
	misfit_free(m);
	site_free(site);
}

static void
expect_same(const char *what, const double *a, const double *b, size_t n)
{
	for (size_t i = 0; i < n; i++)
		if (memcmp(&a[i], &b[i], sizeof *a) != 0)
			fail_msg("%s: candidate %zu has %.17g, not %.17g", what,
			    i, b[i], a[i]);
}

enum { HERD = 1000 };

/* Runs check on a continuous and a classes misfit, with a herd and its misfits
 * on the plainest kernel. */
static void
with_each_method(
    void (*check)(const struct misfit *, const struct herd *, const double *))
{
	for (int which = 0; which < 2; which++) {
		double plain[HERD];
		struct site *site = made_site(&TABLE_3[TIERP], 0.005, 5);
		struct misfit *m = misfit_of(site, settings_of(which));
		struct herd herd = herd_any(HERD, 45);
		herd_evaluate(m, ISA_BASE, 1, &herd, plain);
		check(m, &herd, plain);
		herd_free(&herd);
		misfit_free(m);
		site_free(site);
	}
}

static void
check_isa_and_threads(
    const struct misfit *m, const struct herd *herd, const double *plain)
{
	static const unsigned threads[] = {1, 2, 8};
	double misfit[HERD];
	for (int isa = ISA_BASE; isa <= ISA_BEST; isa++)
		for (size_t t = 0; t < ARRAY_LEN(threads); t++) {
			herd_evaluate(
			    m, (enum isa)isa, threads[t], herd, misfit);
			expect_same("set and threads", plain, misfit, HERD);
		}
}

static void
instruction_sets_and_threads_give_the_same_bits(void **state)
{
	(void)state;
	with_each_method(check_isa_and_threads);
}

/* Each candidate again: alone, and among copies of itself. */
static void
check_company(
    const struct misfit *m, const struct herd *herd, const double *plain)
{
	struct herd alone = herd_new(1), copies = herd_new(KERNEL_LANES);
	double misfit[KERNEL_LANES];
	struct kernel *kernel = kernel_new(m, ISA_BEST, 1);
	for (size_t i = 0; i < HERD; i += 7) {
		struct params p = herd_get(herd, i);
		herd_put(&alone, 0, &p);
		herd_judge(kernel, NULL, &alone, 1, misfit);
		expect_same("alone", plain + i, misfit, 1);
		for (size_t l = 0; l < KERNEL_LANES; l++)
			herd_put(&copies, l, &p);
		herd_judge(kernel, NULL, &copies, KERNEL_LANES, misfit);
		for (size_t l = 0; l < KERNEL_LANES; l++)
			expect_same("copies", plain + i, misfit + l, 1);
	}
	kernel_free(kernel);
	herd_free(&alone);
	herd_free(&copies);
}

static void
a_candidate_is_judged_alone(void **state)
{
	(void)state;
	with_each_method(check_company);
}

/* 389 has no divisor in common with 1000, so every candidate moves, and most to
 * another lane. */
static void
check_order(
    const struct misfit *m, const struct herd *herd, const double *plain)
{
	struct herd other = herd_new(HERD);
	double misfit[HERD];
	for (size_t i = 0; i < HERD; i++) {
		struct params p = herd_get(herd, i);
		herd_put(&other, (i * 389 + 1) % HERD, &p);
	}
	herd_evaluate(m, ISA_BEST, 2, &other, misfit);
	for (size_t i = 0; i < HERD; i++)
		expect_same(
		    "moved", plain + i, misfit + (i * 389 + 1) % HERD, 1);
	herd_free(&other);
}

static void
the_order_of_candidates_does_not_matter(void **state)
{
	(void)state;
	with_each_method(check_order);
}

static void
check_count(
    const struct misfit *m, const struct herd *herd, const double *plain)
{
	struct pool *pool = pool_new(2);
	struct kernel *kernel = kernel_new(m, ISA_BEST, 2);
	double misfit[100];
	for (size_t n = 0; n < 70; n++) {
		for (size_t i = 0; i < ARRAY_LEN(misfit); i++)
			misfit[i] = -3;
		herd_judge(kernel, pool, herd, n, misfit);
		expect_same("a part", plain, misfit, n);
		for (size_t i = n; i < ARRAY_LEN(misfit); i++)
			assert_true(misfit[i] == -3);
	}
	kernel_free(kernel);
	pool_free(pool);
}

static void
nothing_is_written_beyond_the_last_candidate(void **state)
{
	(void)state;
	with_each_method(check_count);
}

static void
a_forced_set_is_lowered_to_the_processor(void **state)
{
	(void)state;
	static const char *const names[] = {"baseline", "avx2", "avx512"};
	struct site *site = made_site(&TABLE_3[TIERP], 0, 1);
	struct misfit *m = misfit_of(site, model_settings_default());
	enum isa best = isa_usable_or_best(ISA_BEST);
	assert_true(best < ISA_BEST);
	for (int isa = ISA_BASE; isa <= ISA_BEST; isa++) {
		struct kernel *kernel = kernel_new(m, (enum isa)isa, 1);
		int want = isa < (int)best ? isa : (int)best;
		assert_string_equal(
		    isa_name(isa_usable_or_best((enum isa)isa)), names[want]);
		kernel_free(kernel);
	}
	misfit_free(m);
	site_free(site);
}

/* Rock of two strengths breaks as its two parts do: differences of both, by the
 * share, to rounding; a candidate of one strength has the same bits beside them
 * as alone. */
static void
check_strengths(const struct misfit *m)
{
	enum { N = 48, STRIDE = 64 };
	const struct breakage *of = m->of;
	size_t e0 = of->strength + 1, n = m->n_residual;
	struct herd herd = herd_any(N, 5);
	struct kernel *kernel = kernel_new(m, ISA_BEST, 1);
	const double *const *theta = (const double *const *)herd.gene;
	double misfit[STRIDE], softer[STRIDE], share[STRIDE];
	double *hard = xcalloc_doubles(n * STRIDE),
	       *soft = xcalloc_doubles(n * STRIDE);
	double *both = xcalloc_doubles(n * STRIDE);
	struct kernel_out out = {misfit, hard, STRIDE, NULL, NULL};
	kernel_evaluate_candidates(kernel, theta, 0, N, 0, &out);
	for (size_t i = 0; i < N; i++) {
		softer[i] = herd.gene[e0][i] * (0.4 + 0.01 * (double)i);
		share[i] = i % 3 == 0 ? 0 : (double)i / N;
	}
	out = (struct kernel_out){misfit, both, STRIDE, softer, share};
	kernel_evaluate_candidates(kernel, theta, 0, N, 0, &out);
	memcpy(herd.gene[e0], softer, N * sizeof *softer);
	out = (struct kernel_out){misfit, soft, STRIDE, NULL, NULL};
	kernel_evaluate_candidates(kernel, theta, 0, N, 0, &out);
	double most = 0;
	for (size_t i = 0; i < N; i++)
		for (size_t c = 0; c < n; c++) {
			size_t k = c * STRIDE + i;
			double want = hard[k] + share[i] * (soft[k] - hard[k]);
			most = fmax(most, fabs(soft[k] - hard[k]));
			/* The softer may have been summed with fewer Gauss
			 * points. */
			if (share[i] == 0)
				assert_true(both[k] == want);
			else
				expect_near("mixture", both[k], want, 2e-4);
		}
	assert_true(most > 0.1);
	free(hard);
	free(soft);
	free(both);
	herd_free(&herd);
	kernel_free(kernel);
}

static void
two_strengths_break_as_their_parts_do(void **state)
{
	(void)state;
	struct site *site = made_site(&TABLE_3[TIERP], 1, 1);
	for (int which = 0; which < 2; which++) {
		struct misfit *m = misfit_of(site, settings_of(which));
		check_strengths(m);
		misfit_free(m);
	}
	site_free(site);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(
		no_sieve_is_off_by_more_than_0_05_points_at_table_3),
	    cmocka_unit_test(and_by_no_more_near_table_3),
	    cmocka_unit_test(
		misfit_near_the_truth_is_close_to_the_accurate_one),
	    cmocka_unit_test(classes_agree_to_1e_12),
	    cmocka_unit_test(classes_agree_on_other_sieves_and_weights),
	    cmocka_unit_test(instruction_sets_and_threads_give_the_same_bits),
	    cmocka_unit_test(a_candidate_is_judged_alone),
	    cmocka_unit_test(the_order_of_candidates_does_not_matter),
	    cmocka_unit_test(nothing_is_written_beyond_the_last_candidate),
	    cmocka_unit_test(a_forced_set_is_lowered_to_the_processor),
	    cmocka_unit_test(two_strengths_break_as_their_parts_do),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
