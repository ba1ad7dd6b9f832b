/* Breeding.  Leaves the judging of candidates to its caller.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/ga.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/rng.h"

struct ga {
	struct ga_options options;
	size_t n_gene;
	double *lower, *upper;
	double **told, **asked; /* [n_gene][population] */
	double *misfit;         /* [population] of told */
	double *best;           /* [n_gene] */
	double *scale;          /* [n_gene] standard deviation of told */
	size_t *order;          /* scratch */
	double *sorted;         /* scratch */
	struct ga_status status;
};

/* Uses of random numbers, each a stream of its own in every generation. */
enum use { USE_START, USE_PARENT, USE_PAIR, USE_BLEND, USE_MUTATE, USE_STEP };

enum { STREAM = 64 }; /* room for genes or draws within a use */

struct ga_options
ga_options_default(void)
{
	return (struct ga_options){8000, 6, 16, 0.9, 0.03, 1};
}

static struct rng_key
stream(const struct ga *ga, enum use use, size_t i)
{
	return rng_key(ga->options.seed, ga->status.generation,
	    (uint64_t)use * STREAM + i);
}

static void
start(struct ga *ga)
{
	for (size_t g = 0; g < ga->n_gene; g++) {
		struct rng_key key = stream(ga, USE_START, g);
		double width = ga->upper[g] - ga->lower[g];
		for (size_t i = 0; i < ga->options.population; i++)
			ga->asked[g][i] = ga->lower[g] +
					  width * rng_uniform(key, (uint32_t)i);
	}
}

struct ga *
ga_new(const struct ga_options *options, size_t n_gene, const double *lower,
    const double *upper)
{
	assert(options->population >= 8 && n_gene < STREAM);
	assert(options->elite >= 1 && options->elite < options->population);
	struct ga *ga = xcalloc(1, sizeof *ga);
	size_t n = options->population;
	ga->options = *options;
	ga->n_gene = n_gene;
	ga->lower = xdoubles(n_gene);
	ga->upper = xdoubles(n_gene);
	ga->best = xdoubles(n_gene);
	ga->scale = xdoubles(n_gene);
	ga->told = xcalloc(n_gene, sizeof *ga->told);
	ga->asked = xcalloc(n_gene, sizeof *ga->asked);
	for (size_t g = 0; g < n_gene; g++) {
		ga->lower[g] = lower[g];
		ga->upper[g] = upper[g];
		ga->told[g] = xdoubles(n + 64);
		ga->asked[g] = xdoubles(n + 64);
	}
	ga->misfit = xdoubles(n);
	ga->sorted = xdoubles(n);
	ga->order = xcalloc(n, sizeof *ga->order);
	ga->status.best = INFINITY;
	ga->status.median = ga->status.worst = INFINITY;
	start(ga);
	return ga;
}

void
ga_free(struct ga *ga)
{
	if (ga == NULL)
		return;
	for (size_t g = 0; g < ga->n_gene; g++) {
		free(ga->told[g]);
		free(ga->asked[g]);
	}
	free(ga->told);
	free(ga->asked);
	free(ga->lower);
	free(ga->upper);
	free(ga->best);
	free(ga->scale);
	free(ga->misfit);
	free(ga->sorted);
	free(ga->order);
	free(ga);
}

const double *const *
ga_ask(const struct ga *ga)
{
	return (const double *const *)ga->asked;
}

const double *const *
ga_told(const struct ga *ga)
{
	return (const double *const *)ga->told;
}

/* The k-th smallest of a, which is put out of order.  Hoare's selection. */
static double
kth(double *a, size_t n, size_t k)
{
	size_t low = 0, high = n - 1;
	while (low < high) {
		double pivot = a[low + (high - low) / 2];
		size_t i = low, j = high;
		for (;;) {
			while (a[i] < pivot)
				i++;
			while (pivot < a[j])
				j--;
			if (i >= j)
				break;
			double swap = a[i];
			a[i++] = a[j];
			a[j--] = swap;
		}
		if (k <= j)
			high = j;
		else
			low = j + 1;
	}
	return a[k];
}

/* Moves the n best of told to the front of order, best first; equal misfits in
 * order of their index. */
static void
sort_leaders(const struct ga *ga, size_t n, size_t *order)
{
	size_t kept = 0;
	for (size_t i = 0; i < ga->options.population; i++) {
		double f = ga->misfit[i];
		if (kept == n && !(f < ga->misfit[order[n - 1]]))
			continue;
		size_t at = kept < n ? kept++ : n - 1;
		while (at > 0 && f < ga->misfit[order[at - 1]]) {
			order[at] = order[at - 1];
			at--;
		}
		order[at] = i;
	}
}

static void
take_status(struct ga *ga)
{
	struct ga_status *s = &ga->status;
	size_t n = ga->options.population, best = 0;
	s->worst = -INFINITY;
	for (size_t i = 0; i < n; i++) {
		double f = ga->misfit[i];
		s->infinite += isinf(f) != 0;
		s->worst = f > s->worst ? f : s->worst;
		best = f < ga->misfit[best] ? i : best;
	}
	memcpy(ga->sorted, ga->misfit, n * sizeof *ga->sorted);
	s->median = kth(ga->sorted, n, n / 2);
	if (ga->misfit[best] < s->best || s->generation == 0) {
		s->best = ga->misfit[best];
		for (size_t g = 0; g < ga->n_gene; g++)
			ga->best[g] = ga->told[g][best];
	}
	s->generation++;
	s->evaluations += n;
}

static void
take_scale(struct ga *ga)
{
	double n = (double)ga->options.population;
	for (size_t g = 0; g < ga->n_gene; g++) {
		double sum = 0, squares = 0, shift = ga->told[g][0];
		for (size_t i = 0; i < ga->options.population; i++) {
			double d = ga->told[g][i] - shift;
			sum += d;
			squares += d * d;
		}
		double variance = squares / n - sum / n * (sum / n);
		ga->scale[g] = variance > 0 ? sqrt(variance) : 0;
	}
}

/* The best of a few candidates drawn at random. */
static size_t
tournament(const struct ga *ga, struct rng_key key, size_t i)
{
	size_t n = ga->options.population, winner = 0;
	for (size_t t = 0; t < ga->options.tournament; t++) {
		uint64_t bits =
		    rng_bits(key, (uint32_t)(i * ga->options.tournament + t));
		size_t drawn = (size_t)(bits * n >> 32);
		if (t == 0 || ga->misfit[drawn] < ga->misfit[winner])
			winner = drawn;
	}
	return winner;
}

/* A step with long tails, of about unit size: most are small, a few reach far.
 * */
static double
long_tailed(double u)
{
	double v = 2 * u - 1, away = 1 - fabs(v);
	return 0.5 * v / (away * away + 0.02);
}

/* One gene of a child.  Where a value would leave the box it goes half-way from
 * the parent to the bound. */
static double
child_gene(const struct ga *ga, size_t g, double a, double b, double blend,
    double mutate, double step)
{
	double x = a + blend * (b - a);
	if (mutate < ga->options.mutation)
		x += ga->scale[g] * long_tailed(step);
	if (x < ga->lower[g])
		x = a + (ga->lower[g] - a) * (mutate < 0.5 ? 1 : step);
	if (x > ga->upper[g])
		x = a + (ga->upper[g] - a) * (mutate < 0.5 ? 1 : step);
	return x;
}

static void
breed(struct ga *ga)
{
	size_t n = ga->options.population;
	struct rng_key first = stream(ga, USE_PARENT, 0);
	struct rng_key second = stream(ga, USE_PARENT, 1);
	struct rng_key pair = stream(ga, USE_PAIR, 0);
	struct rng_key line = stream(ga, USE_PAIR, 1);
	struct rng_key blend[STREAM], mutate[STREAM], step[STREAM];
	for (size_t g = 0; g < ga->n_gene; g++) {
		blend[g] = stream(ga, USE_BLEND, g);
		mutate[g] = stream(ga, USE_MUTATE, g);
		step[g] = stream(ga, USE_STEP, g);
	}
	sort_leaders(ga, ga->options.elite, ga->order);
	for (size_t i = 0; i < n; i++) {
		uint32_t c = (uint32_t)i;
		bool elite = i < ga->options.elite;
		size_t a = elite ? ga->order[i] : tournament(ga, first, i);
		size_t b = tournament(ga, second, i);
		bool crossed = rng_uniform(pair, c) < ga->options.crossover;
		double along = rng_uniform(line, c);
		for (size_t g = 0; g < ga->n_gene; g++) {
			double x = ga->told[g][a];
			double u =
			    along < 0.5 ? 2 * along : rng_uniform(blend[g], c);
			double share = crossed ? 1.8 * u - 0.4 : 0;
			if (!elite)
				x = child_gene(ga, g, x, ga->told[g][b], share,
				    rng_uniform(mutate[g], c),
				    rng_uniform(step[g], c));
			ga->asked[g][i] = x;
		}
	}
}

void
ga_tell(struct ga *ga, const double *misfit)
{
	double **swap = ga->told;
	ga->told = ga->asked;
	ga->asked = swap;
	memcpy(ga->misfit, misfit, ga->options.population * sizeof *misfit);
	take_status(ga);
	take_scale(ga);
	breed(ga);
}

struct ga_status
ga_status(const struct ga *ga)
{
	return ga->status;
}

const double *
ga_best(const struct ga *ga)
{
	return ga->best;
}

void
ga_leaders(const struct ga *ga, size_t n, size_t *index)
{
	sort_leaders(ga, n, index);
}

void
ga_spread(const struct ga *ga, size_t gene, double *p10, double *p90)
{
	size_t n = ga->options.population;
	memcpy(ga->sorted, ga->told[gene], n * sizeof *ga->sorted);
	*p10 = kth(ga->sorted, n, n / 10);
	*p90 = kth(ga->sorted, n, n - 1 - n / 10);
}
