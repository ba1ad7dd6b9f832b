/* Measures how much chance affects an answer: each site is calibrated once,
 * draws are made with several seeds, and the same questions are asked with
 * each.  Prints a row for each site; bench/README.md explains it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include <gsl/gsl_sort.h>

#include "base/xalloc.h"
#include "core/answer/predict.h"
#include "core/answer/forecast.h"
#include "core/posterior/posterior.h"
#include "measure.h"

enum { SPEEDS = 5, SEEDS = 5, LEVEL_PCT = 80 };

static const double SLOWEST = 65, FASTEST = 85;

/* Ranges over the seeds, in % of the band's mean width. */
struct ranges {
	size_t n;
	double *value;
};

static void
add(struct ranges *r, double value)
{
	r->value = xrealloc(r->value, r->n + 1, sizeof *r->value);
	r->value[r->n++] = value;
}

static void
add_all(struct ranges *to, const struct ranges *from)
{
	for (size_t i = 0; i < from->n; i++)
		add(to, from->value[i]);
}

/* Prints the median, the 90th and 99th percentiles, and the largest.  Returns
 * the second. */
static double
print_ranges(const struct ranges *r)
{
	static const double SHARE[] = {0.5, 0.9, 0.99, 1};
	gsl_sort(r->value, 1, r->n);
	for (size_t i = 0; i < ARRAY_LEN(SHARE) && r->n > 0; i++) {
		double last = (double)(r->n - 1);
		printf("%6.1f", r->value[(size_t)(SHARE[i] * last)]);
	}
	return r->n > 0 ? r->value[(r->n - 1) * 9 / 10] : NAN;
}

/* The answers with one seed: value, low and high of all quantities at all
 * speeds. */
struct answers {
	size_t n;
	double *of[3];
};

static struct answers
ask(const struct site *site, const struct fit *fit, const struct posterior *p)
{
	const struct psd *feed = site_feed_of_run(site, SITE_MEAN_FEED);
	const struct fraction whole = {0};
	struct psd sizes = predict_list_table_sieves(site, feed);
	size_t n;
	struct quantity *asked =
	    predict_table_quantities(site, feed, &whole, &n);
	struct forecast *r = forecast_new(feed, sizes.size, sizes.n, asked, n,
	    &fit->params, fit->settings, LEVEL_PCT / 100.0);
	struct ensemble *e = ensemble_new(p, feed, sizes.size, sizes.n);
	struct answers a = {.n = 0};
	for (size_t i = 0; i < 3; i++)
		a.of[i] = xcalloc_doubles(SPEEDS * n);
	for (size_t k = 0; k < SPEEDS; k++) {
		forecast_move_to_speed(r, e, ENSEMBLE_ANSWER,
		    SLOWEST + (FASTEST - SLOWEST) * (double)k / (SPEEDS - 1));
		for (size_t i = 0; i < n; i++, a.n++) {
			struct figure at = forecast_value_with_band(r, i);
			a.of[0][a.n] = at.value;
			a.of[1][a.n] = at.low;
			a.of[2][a.n] = at.high;
		}
	}
	ensemble_free(e);
	forecast_close(r);
	psd_free(&sizes);
	free(asked);
	return a;
}

static struct fit
calibrate(const struct site *site, const struct calibrate_options *o)
{
	struct fit fit;
	measure_calibrate(site, o, &fit);
	return fit;
}

static struct answers
draw_and_ask(const struct site *site, const struct fit *fit,
    const struct calibrate_options *o, const bool *use, size_t seed,
    double *seconds)
{
	struct measure_load from = measure_load();
	struct posterior *p = posterior_new(site, &fit->params,
	    &(struct posterior_options){.use = use,
		.settings = fit->settings,
		.bounds = o->bounds,
		.seed = seed,
		.speed_sd = POSTERIOR_USUAL_SPEED_SD,
		.threads = 1,
		.isa = ISA_BEST});
	*seconds += measure_load().own - from.own;
	struct answers a = ask(site, fit, p);
	posterior_free(p);
	return a;
}

/* Passings, 0..1, with narrower bands are taken as known, and do not count. */
static const double NARROW = 0.001;

static void
compare(const struct answers *a, size_t seeds, struct ranges ranges[static 2])
{
	for (size_t k = 0; k < a[0].n; k++) {
		double width = 0, apart[3];
		for (size_t s = 0; s < seeds; s++)
			width +=
			    (a[s].of[2][k] - a[s].of[1][k]) / (double)seeds;
		/* For sizes, in m, NARROW is a share of the size. */
		double size =
		    k % (a[0].n / SPEEDS) >= a[0].n / SPEEDS - PSD_SIZES
			? a[0].of[0][k]
			: 1;
		if (!(width > NARROW * size))
			continue;
		for (size_t i = 0; i < 3; i++) {
			double least = INFINITY, most = -INFINITY;
			for (size_t s = 0; s < seeds; s++) {
				least = fmin(least, a[s].of[i][k]);
				most = fmax(most, a[s].of[i][k]);
			}
			apart[i] = 100 * (most - least) / width;
		}
		add(&ranges[0], apart[0]);
		add(&ranges[1], apart[1]);
		add(&ranges[1], apart[2]);
	}
}

static void
try_site(const struct site *site, size_t seeds, struct ranges sum[static 2])
{
	bool *train = xcalloc(site->n_run, sizeof *train);
	bool *use = xcalloc(site->n_run, sizeof *use);
	struct answers *a = xcalloc(seeds, sizeof *a);
	struct ranges own[2] = {{0}};
	char stem[64];
	double seconds = 0;
	misfit_mark_default_training(site, train);
	for (size_t r = 0; r < site->n_run; r++)
		use[r] = true;
	struct calibrate_options o = calibrate_options_default();
	o.train = train;
	struct fit fit = calibrate(site, &o);
	for (size_t s = 0; s < seeds; s++)
		a[s] = draw_and_ask(site, &fit, &o, use, s + 1, &seconds);
	compare(a, seeds, own);
	printf("%-14s", measure_stem(site, stem));
	for (size_t i = 0; i < 2; i++) {
		print_ranges(&own[i]);
		printf("  ");
		add_all(&sum[i], &own[i]);
		free(own[i].value);
	}
	printf("%6.0f\n", 1000 * seconds / (double)seeds);
	fflush(stdout);
	for (size_t s = 0; s < seeds; s++)
		for (size_t i = 0; i < 3; i++)
			free(a[s].of[i]);
	free(a);
	free(use);
	free(train);
}

/* The most that nine of ten answers, and ends of bands, may range over, in
 * %. */
static const double MOST[] = {10, 18};

int
main(int argc, char **argv)
{
	if (argc < 2) {
		fprintf(stderr, "usage: chance DATA [SEEDS [SITE]...]\n");
		return 2;
	}
	struct measure_sites sites = measure_read_sites(argv[1]);
	size_t seeds = argc > 2 ? strtoul(argv[2], NULL, 10) : SEEDS;
	struct ranges sum[2] = {{0}};
	for (size_t i = 0; i < sites.n && argc < 4; i++)
		try_site(sites.site[i], seeds, sum);
	for (int i = 3; i < argc; i++)
		try_site(measure_site(&sites, argv[i]), seeds, sum);
	printf("%-14s", "all");
	bool ok = true;
	for (size_t i = 0; i < 2; i++) {
		ok = print_ranges(&sum[i]) <= MOST[i] && ok;
		free(sum[i].value);
		printf("  ");
	}
	printf("\n");
	measure_free_sites(&sites);
	return ok ? 0 : 1;
}
