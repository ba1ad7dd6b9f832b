/* Measures tipspeed: the kernel, the paper's full run, ordinary calibrations,
 * and how their cost grows.  Prints plain tables; bench/README.md says how to
 * read them.  Leaves the comparison with other optimisers to peers.cc.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <dirent.h>
#include <math.h>
#include <omp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "core/calibrate.h"
#include "core/ga.h"
#include "core/isa.h"
#include "core/kernel.h"
#include "core/misfit.h"
#include "core/rng.h"
#include "core/synth.h"
#include "io/site_read.h"

enum { HERD = 8000, GENERATIONS = 800 }; /* the paper's */
enum { REPEATS = 9, RUNS = 5, SEEDS = 5, MOST_SITES = 64 };

static const double LEAST_SECONDS = 0.05; /* a timed repetition's */
static const double NEAR = 0.02;          /* of each parameter's value */
static const double AT_OPTIMUM = 1e-6;    /* misfit above the best, relative */

static double
now(void)
{
	struct timespec t;
	clock_gettime(CLOCK_MONOTONIC, &t);
	return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int
rising(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

/* Puts value [n] in rising order and returns the middle one. */
static double
median(double *value, size_t n)
{
	qsort(value, n, sizeof *value, rising);
	return n % 2 != 0 ? value[n / 2]
			  : (value[n / 2 - 1] + value[n / 2]) / 2;
}

static void
print_padded(const char *text, int width)
{
	printf("%s%*s", text, width - text_width(text), "");
}

static int
is_site_file(const struct dirent *entry)
{
	const char *dot = strrchr(entry->d_name, '.');
	return dot != NULL && strcmp(dot, ".csv") == 0;
}

/* Reads data/sites in the order of the names; ends the program on a fault. */
static size_t
read_sites(const char *data, struct site *site[static MOST_SITES])
{
	struct dirent **entry = NULL;
	char *folder = xasprintf("%s/sites", data);
	int found = scandir(folder, &entry, is_site_file, alphasort);
	size_t n = 0;
	for (int i = 0; i < found; i++) {
		char *path = xasprintf("%s/%s", folder, entry[i]->d_name);
		struct error_list errors = {0};
		if (n < MOST_SITES)
			site[n] = site_read(path, &errors);
		if (errors.n > 0) {
			error_print(&errors.item[0], stderr);
			exit(3);
		}
		n += n < MOST_SITES;
		free(path);
		free(entry[i]);
	}
	if (n == 0) {
		fprintf(stderr,
		    "bench: %s: site files were wanted, "
		    "found none\n",
		    folder);
		exit(5);
	}
	free(entry);
	free(folder);
	return n;
}

static struct site *
site_named(struct site *const *site, size_t n, const char *name)
{
	for (size_t i = 0; i < n; i++)
		if (text_same(site[i]->name, name))
			return site[i];
	fprintf(stderr, "bench: the site %s was wanted, found none\n", name);
	exit(3);
}

static unsigned
all_threads(void)
{
	return (unsigned)omp_get_num_procs();
}

/* First line of a file of /proc that begins with key, from `skip` on. */
static void
print_proc(const char *label, const char *path, const char *key)
{
	char line[512];
	FILE *in = fopen(path, "r");
	while (in != NULL && fgets(line, sizeof line, in) != NULL) {
		if (strncmp(line, key, strlen(key)) != 0)
			continue;
		const char *colon = strchr(line, ':');
		printf("%s%s", label, colon != NULL ? colon + 2 : line);
		break;
	}
	if (in != NULL)
		fclose(in);
}

static void
print_machine(void)
{
	char date[32];
	time_t t = time(NULL);
	strftime(date, sizeof date, "%Y-%m-%d", gmtime(&t));
	printf("date             %s\n", date);
	print_proc("processor        ", "/proc/cpuinfo", "model name");
	printf("cores            %u\n", all_threads());
	printf("instruction set  %s\n", isa_name(isa_usable(ISA_BEST)));
	printf("compiler         %s\n", __VERSION__);
	print_proc("load at start    ", "/proc/loadavg", "");
}

/* HERD candidates, one array a parameter. */
struct herd {
	double *gene[PARAM_COUNT];
};

static struct herd
herd_new(void)
{
	struct herd h;
	for (size_t j = 0; j < PARAM_COUNT; j++)
		h.gene[j] = xdoubles(HERD + KERNEL_LANES);
	return h;
}

static void
herd_free(struct herd *h)
{
	for (size_t j = 0; j < PARAM_COUNT; j++)
		free(h->gene[j]);
}

/* Uniform within lower..upper. */
static struct herd
herd_in(const double *lower, const double *upper)
{
	struct herd h = herd_new();
	for (size_t j = 0; j < PARAM_COUNT; j++)
		for (uint32_t i = 0; i < HERD; i++)
			h.gene[j][i] =
			    lower[j] + (upper[j] - lower[j]) *
					   rng_uniform(rng_key(1, 0, j), i);
	return h;
}

static struct herd
herd_wide(void)
{
	struct bounds b = bounds_default();
	return herd_in(b.lower, b.upper);
}

static struct herd
herd_near(const struct params *p)
{
	struct bounds b = bounds_default();
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		double x = params_get(p, j);
		b.lower[j] = x - NEAR * fabs(x);
		b.upper[j] = fmin(x + NEAR * fabs(x), b.upper[j]);
	}
	return herd_in(b.lower, b.upper);
}

/* Median seconds a candidate. */
static double
candidate_seconds(struct kernel *kernel, const struct herd *h)
{
	double *misfit = xdoubles(HERD + KERNEL_LANES), took[REPEATS];
	const double *const *theta = (const double *const *)h->gene;
	size_t rounds = 1;
	for (;;) {
		double start = now();
		for (size_t i = 0; i < rounds; i++)
			kernel_evaluate(kernel, theta, HERD, misfit);
		if (now() - start >= 1.2 * LEAST_SECONDS)
			break;
		rounds *= 2;
	}
	for (size_t r = 0; r < REPEATS; r++) {
		double start = now();
		for (size_t i = 0; i < rounds; i++)
			kernel_evaluate(kernel, theta, HERD, misfit);
		took[r] = (now() - start) / (double)(rounds * HERD);
	}
	free(misfit);
	return median(took, REPEATS);
}

static struct misfit *
misfit_of(const struct site *site, bool all_runs)
{
	bool *train = xcalloc(site->n_run, sizeof *train);
	misfit_default_train(site, train);
	for (size_t r = 0; r < site->n_run && all_runs; r++)
		train[r] = true;
	struct misfit *m =
	    misfit_new(site, train, NULL, false, model_settings_default());
	free(train);
	return m;
}

/* Runs to the end; returns the seconds it took. */
static double
calibrate(const struct site *site, const struct calibrate_options *options,
    struct fit *fit)
{
	double start = now();
	struct calibration *c = calibration_new(site, options);
	while (calibration_step(c) <= CALIBRATE_POLISHING)
		;
	double took = now() - start;
	*fit = calibration_fit(c);
	calibration_free(c);
	return took;
}

static void
kernel_row(const struct misfit *m, enum isa isa, unsigned threads,
    const struct herd *near, const struct herd *wide)
{
	struct kernel *kernel = kernel_new(m, isa, threads);
	printf("%-12s%8u%14.2f%14.2f\n", isa_name(isa), threads,
	    1e-6 / candidate_seconds(kernel, near),
	    1e-6 / candidate_seconds(kernel, wide));
	kernel_free(kernel);
}

static void
bench_kernel(const struct site *site)
{
	struct calibrate_options o = calibrate_options_default();
	struct fit fit;
	calibrate(site, &o, &fit);
	struct misfit *m = misfit_of(site, false);
	struct herd near = herd_near(&fit.params), wide = herd_wide();
	printf("\n1. Kernel, %s, %zu training runs, %zu residuals: million "
	       "candidates/s\n(%d candidates, median of %d repetitions of "
	       ">= %.0f ms; near: within %.0f %% of the optimum)\n\n",
	    site->name, m->n_run, m->n_residual, HERD, REPEATS,
	    1e3 * LEAST_SECONDS, 100 * NEAR);
	printf("%-12s%8s%14s%14s\n", "set", "threads", "near", "whole bounds");
	for (enum isa isa = ISA_BASE; isa <= isa_usable(ISA_BEST); isa++) {
		kernel_row(m, isa, 1, &near, &wide);
		if (all_threads() >= 2)
			kernel_row(m, isa, 2, &near, &wide);
		if (all_threads() > 2)
			kernel_row(m, isa, all_threads(), &near, &wide);
	}
	herd_free(&near);
	herd_free(&wide);
	misfit_free(m);
}

/* Seconds within the kernel and within ga_tell, and the best misfit found. */
struct parts {
	double kernel, tell, best;
};

/* The paper's full run without calibrate.c. */
static struct parts
drive(const struct site *site, unsigned threads)
{
	struct bounds b = bounds_default();
	struct ga_options o = ga_options_default();
	struct misfit *m = misfit_of(site, false);
	struct kernel *kernel = kernel_new(m, ISA_BEST, threads);
	o.population = HERD;
	o.threads = threads;
	struct ga *ga = ga_new(&o, PARAM_COUNT, b.lower, b.upper);
	double *told = xdoubles(HERD);
	struct parts parts = {0, 0, 0};
	for (size_t g = 0; g < GENERATIONS; g++) {
		double start = now();
		kernel_evaluate(kernel, ga_ask(ga), HERD, told);
		double middle = now();
		ga_tell(ga, told);
		parts.kernel += middle - start;
		parts.tell += now() - middle;
	}
	parts.best = ga_status(ga).best;
	free(told);
	ga_free(ga);
	kernel_free(kernel);
	misfit_free(m);
	return parts;
}

static void
full_run_row(const struct site *site, unsigned threads)
{
	struct calibrate_options o = calibrate_options_default();
	double wall[RUNS], kernel[RUNS], tell[RUNS];
	struct fit fit;
	bool same = true;
	o.population = HERD;
	o.generations = GENERATIONS;
	o.tolerance = 0;
	o.stall = 0;
	o.polish = false;
	o.threads = threads;
	for (size_t i = 0; i < RUNS; i++) {
		wall[i] = calibrate(site, &o, &fit);
		struct parts parts = drive(site, threads);
		kernel[i] = parts.kernel;
		tell[i] = parts.tell;
		/* misfit_at is not the kernel's scheme, but near it. */
		same =
		    same && fabs(parts.best - fit.misfit) < 0.05 * fit.misfit;
	}
	double w = median(wall, RUNS), k = median(kernel, RUNS);
	double t = median(tell, RUNS);
	printf("%8u%10.3f%10.3f%10.3f%12.2f%12.4g%12.4g\n", threads, w, k, t,
	    HERD * (double)GENERATIONS / w / 1e6, fit.misfit, fit.rmse * 100);
	printf(
	    "        operators and bookkeeping: %.0f %% on top of the kernel "
	    "(ga_tell %.0f %%)%s\n",
	    100 * (w / k - 1), 100 * t / k,
	    same ? "" : "; NOT THE SAME POPULATIONS");
}

static void
bench_full_run(const struct site *site)
{
	printf("\n2. The paper's full run, %s: %d candidates, %d generations, "
	       "no polish\n(median of %d; kernel and ga_tell timed apart over "
	       "the same populations)\n\n",
	    site->name, HERD, GENERATIONS, RUNS);
	printf("%8s%10s%10s%10s%12s%12s%12s\n", "threads", "seconds",
	    "kernel s", "ga_tell s", "million/s", "misfit", "rmse points");
	full_run_row(site, all_threads());
	if (all_threads() > 1)
		full_run_row(site, 1);
}

/* One ordinary calibration, step by step. */
struct trial {
	struct fit fit;
	size_t n, room;
	double *clock, *misfit; /* [n] after each step */
};

static struct trial
trial_run(const struct site *site, uint64_t seed)
{
	struct calibrate_options o = calibrate_options_default();
	struct misfit *m = misfit_of(site, false);
	struct trial t = {.n = 0, .room = 0};
	enum calibrate_state state = CALIBRATE_SEARCHING;
	o.seed = seed;
	o.threads = all_threads();
	double start = now();
	struct calibration *c = calibration_new(site, &o);
	double clock = now() - start;
	while (state <= CALIBRATE_POLISHING) {
		start = now();
		state = calibration_step(c);
		clock += now() - start;
		if (t.n == t.room) {
			t.room = 2 * t.room + 256;
			t.clock = xrealloc(t.clock, t.room, sizeof *t.clock);
			t.misfit = xrealloc(t.misfit, t.room, sizeof *t.misfit);
		}
		struct params p = calibration_status(c).params;
		t.clock[t.n] = clock;
		t.misfit[t.n++] = misfit_at(m, &p);
	}
	t.fit = calibration_fit(c);
	calibration_free(c);
	misfit_free(m);
	return t;
}

/* When the misfit first came near the best known; NAN for never. */
static double
trial_reached(const struct trial *t, double best)
{
	for (size_t i = 0; i < t->n; i++)
		if (t->misfit[i] <= best * (1 + AT_OPTIMUM))
			return t->clock[i];
	return NAN;
}

/* What the table says of one site. */
struct summary {
	double seconds, worst_seconds, reached, spread;
	size_t missed;
};

static struct summary
bench_site(const struct site *site)
{
	struct trial trial[SEEDS];
	double seconds[SEEDS], reached[SEEDS], best = INFINITY, worst = 0;
	size_t least = SIZE_MAX, most = 0, n = 0;
	struct summary sum = {0};
	for (size_t i = 0; i < SEEDS; i++) {
		struct trial *t = &trial[i];
		*t = trial_run(site, i + 1);
		seconds[i] = t->clock[t->n - 1];
		best = fmin(best, t->fit.misfit);
		worst = fmax(worst, t->fit.misfit);
		size_t g = t->fit.generations;
		least = g < least ? g : least;
		most = g > most ? g : most;
	}
	for (size_t i = 0; i < SEEDS; i++) {
		double at = trial_reached(&trial[i], best);
		if (isnan(at))
			sum.missed++;
		else
			reached[n++] = at;
		free(trial[i].clock);
		free(trial[i].misfit);
	}
	sum.seconds = median(seconds, SEEDS);
	sum.worst_seconds = seconds[SEEDS - 1];
	sum.reached = median(reached, n);
	sum.spread = worst / best - 1;
	print_padded(site->name, 14);
	printf("%6.1f%9.3f%9.3f%9.3f%5zu-%-4zu%14.6e%10.1e%5zu\n",
	    site->top_size * 1e3, sum.seconds, sum.worst_seconds, sum.reached,
	    least, most, best, sum.spread, sum.missed);
	return sum;
}

static void
bench_sites(struct site *const *site, size_t n)
{
	double seconds[MOST_SITES], reached[MOST_SITES], worst = 0, spread = 0;
	size_t missed = 0;
	printf("\n3. Ordinary calibration, %u threads, %d seeds a site; "
	       "seconds\n(optimum: until within %.0e of the best of the seeds; "
	       "missed: seeds that never were)\n\n",
	    all_threads(), SEEDS, AT_OPTIMUM);
	print_padded("site", 14);
	printf("%6s%9s%9s%9s%10s%14s%10s%5s\n", "mm", "median", "worst",
	    "optimum", "generat.", "misfit", "spread", "miss");
	for (size_t i = 0; i < n; i++) {
		struct summary s = bench_site(site[i]);
		seconds[i] = s.seconds;
		reached[i] = s.reached;
		worst = fmax(worst, s.worst_seconds);
		spread = fmax(spread, s.spread);
		missed += s.missed;
	}
	double middle = median(seconds, n);
	printf("\nwhole calibration: median site %.3f s, slowest site's median "
	       "%.3f s, worst %.3f s\nlargest spread %.1e, %zu of %zu runs "
	       "missed\n",
	    middle, seconds[n - 1], worst, spread, missed, n * SEEDS);
	middle = median(reached, n);
	printf(
	    "\n4. Time to optimum: median site %.3f s, slowest site %.3f s\n",
	    middle, reached[n - 1]);
}

/* The curve on n sieves evenly spaced on log size over the same sizes. */
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

static const struct params TIERP_PRINTED = {{0, 1, -1, 0.5}, 2.18, 16.74, 0.96};

/* Microseconds a candidate near Tierp's parameters and over the bounds, for
 * made-up runs; sieves 0 leaves the sieves of EN 933. */
struct cost {
	double near, wide;
};

static struct cost
cost_of(size_t runs, size_t product_sieves, size_t feed_sieves)
{
	double speed[8];
	for (size_t i = 0; i < runs; i++)
		speed[i] = 65 + 20 * (double)i / (double)(runs - 1);
	struct synth synth = {.top_size = 0.0112,
	    .params = TIERP_PRINTED,
	    .individual_feeds = true,
	    .n = 1,
	    .noise = 0.005,
	    .seed = 9,
	    .n_speed = runs,
	    .speed = speed};
	struct site *site = synth_site(&synth);
	for (size_t r = 0; r < runs; r++) {
		if (product_sieves > 0)
			resample(&site->run[r].product, product_sieves);
		if (feed_sieves > 0)
			resample(&site->run[r].feed, feed_sieves);
	}
	struct misfit *m = misfit_of(site, true);
	struct kernel *kernel = kernel_new(m, ISA_BEST, 1);
	struct herd near = herd_near(&TIERP_PRINTED), wide = herd_wide();
	struct cost cost = {1e6 * candidate_seconds(kernel, &near),
	    1e6 * candidate_seconds(kernel, &wide)};
	herd_free(&near);
	herd_free(&wide);
	kernel_free(kernel);
	misfit_free(m);
	site_free(site);
	return cost;
}

static void
cost_row(const char *what, double factor, struct cost cost, struct cost first)
{
	print_padded(what, 30);
	printf("%10.3f%10.2f%10.3f%10.2f\n", cost.near,
	    cost.near / first.near / factor, cost.wide,
	    cost.wide / first.wide / factor);
}

static void
bench_scaling(void)
{
	char what[64];
	struct cost first = {0, 0};
	printf(
	    "\n5. Scaling: microseconds a candidate, one thread, and the "
	    "ratio to cost in\nproportion to the first row of the group\n\n");
	print_padded("", 30);
	printf("%10s%10s%10s%10s\n", "near", "ratio", "bounds", "ratio");
	for (int feed_too = 0; feed_too < 2; feed_too++)
		for (size_t n = 8; n <= 64; n *= 2) {
			struct cost cost = cost_of(2, n, feed_too ? n : 0);
			snprintf(what, sizeof what,
			    "2 runs, %zu sieves, feed %s", n,
			    feed_too ? "too" : "12");
			first = n == 8 ? cost : first;
			cost_row(what, (double)n / 8, cost, first);
		}
	for (size_t runs = 2; runs <= 8; runs *= 2) {
		struct cost cost = cost_of(runs, 0, 0);
		snprintf(
		    what, sizeof what, "%zu runs, 12 sieves, feed 12", runs);
		first = runs == 2 ? cost : first;
		cost_row(what, (double)runs / 2, cost, first);
	}
}

int
main(int argc, char **argv)
{
	struct site *site[MOST_SITES] = {NULL};
	if (argc != 2) {
		fprintf(stderr, "usage: bench DATA_DIR\n");
		return 2;
	}
	size_t n = read_sites(argv[1], site);
	const struct site *tierp = site_named(site, n, "Tierp");
	print_machine();
	bench_kernel(tierp);
	bench_full_run(tierp);
	bench_sites(site, n);
	bench_scaling();
	for (size_t i = 0; i < n; i++)
		site_free(site[i]);
	return ferror(stdout) != 0;
}
