/* Measures tipspeed: the kernel, the paper's full run, ordinary calibrations,
 * and how their cost grows.  Prints plain tables; bench/README.md explains
 * them.  peers.cc compares with other optimisers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/pool.h"
#include "base/xalloc.h"
#include "core/search/calibrate.h"
#include "core/search/ga.h"
#include "core/numeric/isa.h"
#include "core/search/kernel.h"
#include "core/search/misfit.h"
#include "core/model/synth.h"
#include "herd.h"
#include "measure.h"

enum { REPEATS = 9, RUNS = 7, SEEDS = 5 };

static const double LEAST_SECONDS = 0.05; /* least length of a timed
					   * repetition */
static const double AT_OPTIMUM = 1e-6;    /* relative distance of the misfit
					   * from the best */

/* Returns the seconds to evaluate the herd `rounds` times. */
static double
herd_seconds(struct kernel *kernel, struct pool *pool, const struct herd *h,
    size_t rounds)
{
	static double misfit[HERD];
	double start = measure_now();
	for (size_t i = 0; i < rounds; i++)
		herd_evaluate(
		    kernel, pool, (const double *const *)h->gene, HERD, misfit);
	return measure_now() - start;
}

/* Returns the median seconds per candidate. */
static double
candidate_seconds(
    struct kernel *kernel, struct pool *pool, const struct herd *h)
{
	double took[REPEATS];
	size_t rounds = 1;
	while (herd_seconds(kernel, pool, h, rounds) < 1.2 * LEAST_SECONDS)
		rounds *= 2;
	for (size_t r = 0; r < REPEATS; r++)
		took[r] = herd_seconds(kernel, pool, h, rounds);
	return measure_median(took, REPEATS) / (double)(rounds * HERD);
}

static void
kernel_row(const struct misfit *m, enum isa isa, unsigned threads,
    const struct herd *near, const struct herd *wide)
{
	struct pool *pool = pool_new(threads);
	struct kernel *kernel = kernel_new(m, isa, threads);
	printf("%-12s%8u%14.2f%14.2f\n", isa_name(isa), threads,
	    1e-6 / candidate_seconds(kernel, pool, near),
	    1e-6 / candidate_seconds(kernel, pool, wide));
	kernel_free(kernel);
	pool_free(pool);
}

static void
bench_kernel(const struct measure_sites *sites)
{
	const struct site *site = measure_site(sites, "Tierp");
	struct calibrate_options o = calibrate_options_default();
	struct fit fit;
	measure_calibrate(site, &o, &fit);
	struct misfit *m = measure_misfit(site, false);
	struct herd near = herd_near(&fit.params), wide = herd_wide();
	printf("\n1. Kernel, %s, %zu training runs, %zu residuals: million "
	       "candidates/s\n(%d candidates, median of %d repetitions of "
	       ">= %.0f ms; near: within %.0f %% of the optimum)\n\n",
	    site->name, m->n_run, m->n_residual, HERD, REPEATS,
	    1e3 * LEAST_SECONDS, 100 * HERD_NEAR);
	printf("%-12s%8s%14s%14s\n", "set", "threads", "near", "whole bounds");
	for (enum isa isa = ISA_BASE; isa <= isa_usable_or_best(ISA_BEST);
	     isa++) {
		kernel_row(m, isa, 1, &near, &wide);
		if (measure_threads() >= 2)
			kernel_row(m, isa, 2, &near, &wide);
		if (measure_threads() > 2)
			kernel_row(m, isa, measure_threads(), &near, &wide);
	}
	herd_free(&near);
	herd_free(&wide);
	misfit_free(m);
}

/* Seconds spent in the kernel, and the best parameters found. */
struct parts {
	double kernel;
	struct params best;
};

/* Does the paper's full run without calibrate.c, so that the kernel can be
 * timed alone: candidates are made before its clock starts. */
static struct parts
drive(const struct site *site, const struct calibrate_options *full)
{
	struct ga_options o = ga_options_default();
	struct misfit *m = measure_misfit(site, false);
	struct pool *pool = pool_new(full->threads);
	struct kernel *kernel = kernel_new(m, full->isa, full->threads);
	o.population = full->population;
	o.seed = full->seed;
	o.isa = full->isa;
	struct ga *ga =
	    ga_new(&o, m->of->n, full->bounds.lower, full->bounds.upper);
	double *told = xcalloc_doubles(o.population);
	struct parts parts = {.kernel = 0};
	for (size_t g = 0; g < full->generations; g++) {
		const double *const *gene = ga_next_candidates(ga);
		double start = measure_now();
		herd_evaluate(kernel, pool, gene, o.population, told);
		parts.kernel += measure_now() - start;
		ga_set_misfits(ga, told);
	}
	for (size_t j = 0; j < BREAKAGES[0]->n; j++)
		parts.best.at[j] = ga_best_genes(ga)[j];
	params_scale_largest_beta_to_1(&parts.best);
	free(told);
	ga_free(ga);
	kernel_free(kernel);
	pool_free(pool);
	misfit_free(m);
	return parts;
}

/* True if the parameters are identical, that is, if the populations were the
 * same. */
static bool
same_params(const struct params *a, const struct params *b)
{
	bool same = true;
	for (size_t j = 0; j < BREAKAGES[0]->n; j++)
		same = same && !(a->at[j] < b->at[j]) && !(a->at[j] > b->at[j]);
	return same;
}

static void
full_run_row(const struct site *site, unsigned threads)
{
	struct calibrate_options o = measure_full_run(threads);
	double wall[RUNS], kernel[RUNS], ratio[RUNS];
	struct fit fit;
	bool same = true;
	for (size_t i = 0; i < RUNS; i++) {
		wall[i] = measure_calibrate(site, &o, &fit);
		struct parts parts = drive(site, &o);
		kernel[i] = parts.kernel;
		ratio[i] = wall[i] / kernel[i];
		same = same && same_params(&parts.best, &fit.params);
	}
	double w = measure_median(wall, RUNS), k = measure_median(kernel, RUNS);
	printf("%8u%10.3f%10.3f%10.3f%9.0f %%%12.2f%12.4g%s\n", threads, w, k,
	    w - k, 100 * (measure_median(ratio, RUNS) - 1),
	    (double)fit.evaluations / w / 1e6, fit.misfit,
	    same ? "" : "  NOT THE SAME POPULATIONS");
}

/* Prints how far above the lowest misfit runs with these options end, over the
 * seeds. */
static void
operators_row(const struct site *site, const char *name,
    struct calibrate_options o, double lowest)
{
	double seconds[SEEDS], gap[SEEDS];
	struct fit fit;
	for (size_t i = 0; i < SEEDS; i++) {
		o.seed = i + 1;
		seconds[i] = measure_calibrate(site, &o, &fit);
		gap[i] = 100 * (fit.misfit / lowest - 1);
	}
	double middle = measure_median(gap, SEEDS);
	printf("%-34s%9.3f%12.2f%10.2f%10.2f\n", name,
	    measure_median(seconds, SEEDS), gap[0], middle, gap[SEEDS - 1]);
}

static void
bench_operators(const struct site *site)
{
	struct calibrate_options o = calibrate_options_default();
	struct fit fit;
	o.threads = measure_threads();
	measure_calibrate(site, &o, &fit);
	printf("\nThe same size with either operators, %d seeds: %% above the "
	       "lowest misfit\n\n%-34s%9s%12s%10s%10s\n",
	    SEEDS, "operators", "seconds", "best", "median", "worst");
	struct calibrate_options full = measure_full_run(o.threads);
	operators_row(site, "tipspeed's own", full, fit.misfit);
	full.plain = true;
	operators_row(site, "a textbook's (preset=paper)", full, fit.misfit);
	operators_row(site, "(ordinary calibration)", o, fit.misfit);
}

static void
bench_full_run(const struct measure_sites *sites)
{
	const struct site *site = measure_site(sites, "Tierp");
	printf("\n2. The paper's full run, %s: 8000 candidates, 800 "
	       "generations, no polish\n(median of %d; kernel timed apart "
	       "over the same populations right after, the\nrest is breeding, "
	       "ranking and bookkeeping; on top: median over the pairs)\n\n",
	    site->name, RUNS);
	printf("%8s%10s%10s%10s%11s%12s%12s\n", "threads", "seconds",
	    "kernel s", "rest s", "on top", "million/s", "misfit");
	full_run_row(site, measure_threads());
	if (measure_threads() > 1)
		full_run_row(site, 1);
	bench_operators(site);
}

/* One ordinary calibration, with time and misfit after each step. */
struct trial {
	struct fit fit;
	size_t n, room;
	double *clock, *misfit; /* [n], after each step */
};

static void
trial_note(struct trial *t, double clock, double misfit)
{
	if (t->n == t->room) {
		t->room = 2 * t->room + 256;
		t->clock = xrealloc(t->clock, t->room, sizeof *t->clock);
		t->misfit = xrealloc(t->misfit, t->room, sizeof *t->misfit);
	}
	t->clock[t->n] = clock;
	t->misfit[t->n++] = misfit;
}

/* The clock is stopped while the accurate misfit is computed. */
static struct trial
trial_run(const struct site *site, uint64_t seed)
{
	struct calibrate_options o = calibrate_options_default();
	struct misfit *m = measure_misfit(site, false);
	struct trial t = {.n = 0};
	enum calibrate_state state = CALIBRATE_SEARCHING;
	o.seed = seed;
	o.threads = measure_threads();
	double start = measure_now();
	struct calibration *c = calibration_new(site, &o);
	double clock = measure_now() - start;
	while (state <= CALIBRATE_POLISHING) {
		start = measure_now();
		state = calibration_step(c);
		clock += measure_now() - start;
		struct params p = calibration_status(c).params;
		trial_note(&t, clock, misfit_of_params(m, &p));
	}
	t.fit = calibration_best_fit(c);
	calibration_free(c);
	misfit_free(m);
	return t;
}

/* Returns the time at which the misfit first came near the best known, or
 * NAN. */
static double
trial_reached(const struct trial *t, double best)
{
	for (size_t i = 0; i < t->n; i++)
		if (t->misfit[i] <= best * (1 + AT_OPTIMUM))
			return t->clock[i];
	return NAN;
}

/* A summary of the trials of one site. */
struct summary {
	double seconds, worst_seconds, reached, best, spread;
	size_t missed, least, most; /* seeds; generations */
};

static struct summary
summarise(const struct trial *trial)
{
	struct summary sum = {.best = INFINITY, .least = SIZE_MAX};
	double seconds[SEEDS], reached[SEEDS], worst = 0;
	size_t n = 0;
	for (size_t i = 0; i < SEEDS; i++) {
		const struct fit *fit = &trial[i].fit;
		seconds[i] = trial[i].clock[trial[i].n - 1];
		sum.best = fmin(sum.best, fit->misfit);
		worst = fmax(worst, fit->misfit);
		if (fit->generations < sum.least)
			sum.least = fit->generations;
		if (fit->generations > sum.most)
			sum.most = fit->generations;
	}
	for (size_t i = 0; i < SEEDS; i++) {
		double at = trial_reached(&trial[i], sum.best);
		if (!isnan(at))
			reached[n++] = at;
	}
	sum.missed = SEEDS - n;
	sum.seconds = measure_median(seconds, SEEDS);
	sum.worst_seconds = seconds[SEEDS - 1];
	sum.reached = measure_median(reached, n);
	sum.spread = worst / sum.best - 1;
	return sum;
}

static struct summary
bench_site(const struct site *site)
{
	struct trial trial[SEEDS];
	char stem[64];
	for (size_t i = 0; i < SEEDS; i++)
		trial[i] = trial_run(site, i + 1);
	struct summary s = summarise(trial);
	for (size_t i = 0; i < SEEDS; i++) {
		free(trial[i].clock);
		free(trial[i].misfit);
	}
	printf("%-14s%9.3f%9.3f%10.3f%7zu-%-4zu%14.6e%10.1e%7zu\n",
	    measure_stem(site, stem), s.seconds, s.worst_seconds, s.reached,
	    s.least, s.most, s.best, s.spread, s.missed);
	return s;
}

static void
bench_sites(const struct measure_sites *sites)
{
	size_t n = sites->n, missed = 0;
	double *seconds = xcalloc_doubles(n), *reached = xcalloc_doubles(n);
	double worst = 0, spread = 0;
	printf(
	    "\n3. Ordinary calibration, %u threads, %d seeds a site; "
	    "seconds\n(optimum: until within %.0e of the best of the seeds, "
	    "median; missed: seeds that\nnever were; spread: worst over best "
	    "misfit, less 1)\n\n",
	    measure_threads(), SEEDS, AT_OPTIMUM);
	printf("%-14s%9s%9s%10s%12s%14s%10s%7s\n", "site", "median", "worst",
	    "optimum", "generations", "misfit", "spread", "missed");
	for (size_t i = 0; i < n; i++) {
		struct summary s = bench_site(sites->site[i]);
		seconds[i] = s.seconds;
		reached[i] = s.reached;
		worst = fmax(worst, s.worst_seconds);
		spread = fmax(spread, s.spread);
		missed += s.missed;
	}
	double middle = measure_median(seconds, n);
	printf(
	    "\nwhole calibration: median site %.3f s, slowest site %.3f s, "
	    "worst run %.3f s\nlargest spread %.1e, %zu of %zu runs missed\n",
	    middle, seconds[n - 1], worst, spread, missed, n * SEEDS);
	middle = measure_median(reached, n);
	printf(
	    "\n4. Time to optimum: median site %.3f s, slowest site %.3f s\n",
	    middle, reached[n - 1]);
	free(seconds);
	free(reached);
}

/* Replaces the curve with one on n sieves, evenly spaced in log size over the
 * same range. */
static void
resample(struct psd *psd, size_t n)
{
	struct psd to = psd_new(n);
	double top = psd->size[0], bottom = psd->size[psd->n - 1];
	for (size_t i = 0; i < n; i++) {
		double share = (double)i / (double)(n - 1);
		to.size[i] =
		    i + 1 < n ? top * pow(bottom / top, share) : bottom;
		to.passing[i] = psd_passing(psd, to.size[i]);
	}
	psd_free(psd);
	*psd = to;
}

/* As printed in Table 3, with the default beta. */
static const struct params TIERP = {.at = {0, 1, -1, 0.5, 2.18, 16.74, 0.96}};

/* Returns synthetic runs with Tierp's parameters.  n_product, n_feed: numbers
 * of sieves, or 0 for those of EN 933. */
static struct site *
made_site(size_t runs, size_t n_product, size_t n_feed)
{
	double speed[8];
	for (size_t i = 0; i < runs; i++)
		speed[i] = 65 + 20 * (double)i / (double)(runs - 1);
	struct synth synth = {.top_size = 0.0112,
	    .params = TIERP,
	    .individual_feeds = true,
	    .n = 1,
	    .noise = 0.005,
	    .seed = 9,
	    .n_speed = runs,
	    .speed = speed};
	struct site *site = synth_make_site(&synth);
	for (size_t r = 0; r < runs; r++) {
		if (n_product > 0)
			resample(&site->run[r].product, n_product);
		if (n_feed > 0)
			resample(&site->run[r].feed, n_feed);
	}
	return site;
}

/* Microseconds per candidate. */
struct cost {
	double near, wide;
};

static struct cost
cost_of(size_t runs, size_t n_product, size_t n_feed)
{
	struct site *site = made_site(runs, n_product, n_feed);
	struct misfit *m = measure_misfit(site, true);
	struct kernel *kernel = kernel_new(m, ISA_BEST, 1);
	struct herd near = herd_near(&TIERP), wide = herd_wide();
	struct cost cost = {1e6 * candidate_seconds(kernel, NULL, &near),
	    1e6 * candidate_seconds(kernel, NULL, &wide)};
	herd_free(&near);
	herd_free(&wide);
	kernel_free(kernel);
	misfit_free(m);
	site_free(site);
	return cost;
}

static void
cost_row(size_t runs, size_t product, const char *feed, double factor,
    struct cost cost, struct cost first)
{
	printf("%6zu%10zu%8s%10.3f%10.2f%10.3f%10.2f\n", runs, product, feed,
	    cost.near, cost.near / first.near / factor, cost.wide,
	    cost.wide / first.wide / factor);
}

static void
bench_scaling(const struct measure_sites *sites)
{
	(void)sites;
	struct cost first = {0, 0};
	printf("\n5. Scaling: microseconds a candidate, one thread, near the "
	       "optimum and over the\nwhole bounds, and the ratio to cost in "
	       "proportion to the first row of its group\n\n");
	printf("%6s%10s%8s%10s%10s%10s%10s\n", "runs", "product", "feed",
	    "near", "ratio", "bounds", "ratio");
	for (size_t n = 8; n <= 64; n *= 2) {
		struct cost cost = cost_of(2, n, n);
		first = n == 8 ? cost : first;
		cost_row(2, n, "same", (double)n / 8, cost, first);
	}
	for (size_t n = 8; n <= 64; n *= 2) {
		struct cost cost = cost_of(2, n, 0);
		first = n == 8 ? cost : first;
		cost_row(2, n, "12", (double)n / 8, cost, first);
	}
	for (size_t runs = 2; runs <= 8; runs *= 2) {
		struct cost cost = cost_of(runs, 0, 0);
		first = runs == 2 ? cost : first;
		cost_row(runs, 12, "12", (double)runs / 2, cost, first);
	}
}

int
main(int argc, char **argv)
{
	static void (*const tables[])(const struct measure_sites *) = {
	    bench_kernel, bench_full_run, bench_sites, bench_scaling};
	if (argc != 2) {
		fprintf(stderr, "usage: bench DATA_DIR\n");
		return 2;
	}
	struct measure_sites sites = measure_read_sites(argv[1]);
	measure_print_machine();
	for (size_t i = 0; i < ARRAY_LEN(tables); i++) {
		struct measure_load load = measure_load();
		tables[i](&sites);
		measure_print_others(&load);
		fflush(stdout);
	}
	measure_free_sites(&sites);
	return ferror(stdout) != 0;
}
