/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/ensemble.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_statistics_double.h>

#include "base/xalloc.h"
#include "core/elementary.h"
#include "core/kernel.h"
#include "core/product.h"

/* The draws' parameters and in the last block the fit's, whose exact product
 * tells what the search's scheme errs by. */
enum { DRAWS = POSTERIOR_DRAWS, ALL = DRAWS + KERNEL_LANES };

struct ensemble {
	const struct posterior *of;
	size_t n;
	struct kernel *kernel;
	struct model *exact;
	double *theta[PARAMS_MOST]; /* [ALL] */
	double *product, *misfit;   /* [n * ALL], [ALL], of the scheme */
	double *fit, *feed;         /* [n] */
	size_t *knot;               /* [n]: between it and the next, */
	double *share;              /* and how much it counts */
	double *part[ENSEMBLE_PARTS];
};

/* Passings less 0 are differences from sieves at which nothing passes. */
static struct kernel *
kernel_of(const struct posterior *p, const struct psd *feed, const double *size,
    size_t n)
{
	double *sieve = xdoubles(n), *none = xdoubles(n), *one = xdoubles(n);
	memcpy(sieve, size, n * sizeof *size);
	for (size_t i = 0; i < n; i++)
		one[i] = 1;
	struct misfit_run run = {.speed = 1,
	    .run_weight = 1,
	    .feed = *feed,
	    .n = n,
	    .sieve = sieve,
	    .measured = none,
	    .weight = one};
	struct misfit m = {.of = BREAKAGES[p->settings.breakage],
	    .settings = p->settings,
	    .n_run = 1,
	    .n_residual = n,
	    .run = &run};
	struct kernel *kernel = kernel_new(&m, ISA_BEST, 1);
	free(sieve);
	free(none);
	free(one);
	return kernel;
}

static void
find_knots(struct ensemble *e, const double *size)
{
	const struct posterior *p = e->of;
	e->knot = xcalloc(e->n, sizeof *e->knot);
	e->share = xdoubles(e->n);
	for (size_t i = 0; i < e->n; i++) {
		double at = el_log(size[i]);
		size_t k = 0;
		while (k + 2 < p->n_knot && p->knot[k + 1] > at)
			k++;
		double share =
		    (at - p->knot[k + 1]) / (p->knot[k] - p->knot[k + 1]);
		e->knot[i] = k;
		e->share[i] = fmin(fmax(share, 0), 1);
	}
}

struct ensemble *
ensemble_new(const struct posterior *p, const struct psd *feed,
    const double *size, size_t n)
{
	struct ensemble *e = xcalloc(1, sizeof *e);
	*e = (struct ensemble){.of = p,
	    .n = n,
	    .kernel = kernel_of(p, feed, size, n),
	    .exact = model_new(feed, size, n, p->settings),
	    .product = xdoubles(n * ALL),
	    .misfit = xdoubles(ALL),
	    .fit = xdoubles(n),
	    .feed = xdoubles(n)};
	model_set(e->exact, &p->fit);
	for (size_t j = 0; j < breakage_of(&p->fit)->n; j++) {
		e->theta[j] = xdoubles(ALL);
		for (size_t i = 0; i < ALL; i++)
			e->theta[j][i] =
			    i < DRAWS ? p->draw[i].params.at[j] : p->fit.at[j];
	}
	for (size_t i = 0; i < n; i++)
		e->feed[i] = psd_passing(feed, size[i]);
	for (size_t i = 0; i < ENSEMBLE_PARTS; i++)
		e->part[i] = xdoubles(n * DRAWS);
	find_knots(e, size);
	return e;
}

void
ensemble_free(struct ensemble *e)
{
	if (e == NULL)
		return;
	for (size_t j = 0; j < PARAMS_MOST; j++)
		free(e->theta[j]);
	for (size_t i = 0; i < ENSEMBLE_PARTS; i++)
		free(e->part[i]);
	kernel_free(e->kernel);
	model_free(e->exact);
	free(e->product);
	free(e->misfit);
	free(e->fit);
	free(e->feed);
	free(e->knot);
	free(e->share);
	free(e);
}

static double
at_knots(const struct ensemble *e, size_t i, const double *f)
{
	size_t k = e->knot[i];
	return e->share[i] * f[k] + (1 - e->share[i]) * f[k + 1];
}

/* Column d of all parts, from the finest size on. */
static void
fill_draw(struct ensemble *e, size_t d, double t)
{
	const struct posterior_draw *draw = &e->of->draw[d];
	double term[DISCREPANCY_TERMS], finer = 0, sample = 0;
	discrepancy_terms(t, draw->hyper[HYPER_SLOPE], term);
	for (size_t i = e->n; i-- > 0;) {
		const double *row = e->product + i * ALL;
		double P = row[d] + e->fit[i] - row[DRAWS];
		P = fmin(fmax(P, e->feed[i]), 1);
		double h = discrepancy_h(P), delta = 0;
		for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
			delta += term[j] * at_knots(e, i, draw->term[j]);
		finer = fmax(fmax(P + h * delta, e->feed[i]), finer);
		finer = fmin(finer, 1);
		double error =
		    at_knots(e, i, draw->shared) + at_knots(e, i, draw->own);
		sample = fmin(fmax(finer + h * error, sample), 1);
		e->part[ENSEMBLE_MODEL][i * DRAWS + d] = P;
		e->part[ENSEMBLE_ANSWER][i * DRAWS + d] = finer;
		e->part[ENSEMBLE_SAMPLE][i * DRAWS + d] = sample;
	}
}

void
ensemble_at(struct ensemble *e, double v)
{
	struct kernel_out out = {e->misfit, e->product, ALL};
	double t = discrepancy_time(v, e->of->middle);
	kernel_set_speed(e->kernel, v);
	kernel_evaluate_part(
	    e->kernel, (const double *const *)e->theta, 0, ALL, 0, &out);
	model_product(e->exact, v, e->fit);
	for (size_t d = 0; d < DRAWS; d++)
		fill_draw(e, d, t);
}

const double *
ensemble_products(const struct ensemble *e, enum ensemble_part part)
{
	return e->part[part];
}

double
ensemble_break_size(const struct ensemble *e, size_t draw, double v)
{
	return params_break_size(&e->of->draw[draw].params, v);
}

void
ensemble_mean(const struct ensemble *e, double *passing)
{
	for (size_t i = 0; i < e->n; i++)
		passing[i] = gsl_stats_mean(
		    e->part[ENSEMBLE_ANSWER] + i * DRAWS, 1, DRAWS);
}

void
ensemble_middle(double *value, double level, double *low, double *high)
{
	size_t cut = (size_t)floor((1 - level) / 2 * DRAWS + 0.5);
	for (size_t i = 0; i < DRAWS; i++)
		if (isnan(value[i]))
			value[i] = -INFINITY;
	*low = gsl_stats_select(value, 1, DRAWS, cut);
	*high = gsl_stats_select(value, 1, DRAWS, DRAWS - 1 - cut);
	if (*low < -1e300)
		*low = NAN;
	if (*high < -1e300)
		*high = NAN;
}

void
ensemble_band(const struct ensemble *e, enum ensemble_part part, size_t row,
    double level, double *low, double *high)
{
	double value[DRAWS];
	memcpy(value, e->part[part] + row * DRAWS, sizeof value);
	ensemble_middle(value, level, low, high);
}
