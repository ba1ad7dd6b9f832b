/* A genetic algorithm by ask and tell: tournaments, blend crossover, mutation
 * and elitism.  Its caller evaluates the candidates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/ga.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_statistics_double.h>

#include "base/xalloc.h"
#include "core/search/ga_operators.h"
#include "core/numeric/elementary.h"
#include "core/numeric/rng.h"

struct ga {
	struct ga_options options;
	struct breed breed;     /* with told, asked [n_gene][population] */
	double *misfit;         /* [population] of breed.told */
	double *best;           /* [n_gene] */
	uint32_t *rank, *spare; /* [population] indices, best first; scratch */
	uint32_t *key;
	size_t n_draw;    /* number of possible tournaments, a power of two */
	uint32_t *winner; /* [n_draw] ranks of their winners; breed.parent has
			   * the candidates */
	breed_block *block;
	bool ready; /* breed.asked is complete, without breeding */
	struct ga_status status;
};

enum { SPREAD_SAMPLE = 256, SCALE_SAMPLE = 1000 };

/* Uses of random numbers.  Each has its own streams in every generation. */
enum use { USE_START, USE_PARENT, USE_PAIR, USE_GENE };

enum { STREAM = 64 }; /* room for genes or draws within a use */

struct ga_options
ga_options_default(void)
{
	return (struct ga_options){.population = 8000,
	    .tournament = 6,
	    .elite = 16,
	    .crossover = 0.9,
	    .mutation = 0.03,
	    .seed = 1,
	    .isa = ISA_BEST};
}

struct ga_options
ga_options_textbook(void)
{
	struct ga_options o = ga_options_default();
	o.tournament = 2;
	o.mutation = 0.05;
	o.anywhere = true;
	return o;
}

static struct rng_key
random_stream_key(const struct ga *ga, enum use use, size_t i)
{
	return rng_make_key(ga->options.seed, ga->status.generation,
	    (uint64_t)use * STREAM + i);
}

static void
sample_first_generation(struct ga *ga)
{
	for (size_t g = 0; g < ga->breed.n_gene; g++) {
		struct rng_key key = random_stream_key(ga, USE_START, g);
		double width = ga->breed.upper[g] - ga->breed.lower[g];
		for (size_t i = 0; i < ga->options.population; i++) {
			double x = ga->breed.lower[g] +
				   width * rng_uniform(key, (uint32_t)i);
			/* Rounding may lead past the upper end. */
			ga->breed.asked[g][i] =
			    x < ga->breed.upper[g] ? x : ga->breed.upper[g];
		}
	}
	ga->ready = true;
}

/* Draws the rank of a tournament's winner instead of its k participants: the
 * least of k uniform numbers is 1 - (1 - u)^(1/k).  Tabulates it for at least
 * as many values of u as there are candidates. */
static void
tabulate_tournament_winners(struct ga *ga)
{
	size_t n = ga->options.population;
	double over = 1 / (double)ga->options.tournament;
	ga->n_draw = 4;
	ga->breed.draw_shift = 30;
	for (; ga->n_draw < n; ga->breed.draw_shift--)
		ga->n_draw *= 2;
	ga->winner = xcalloc(ga->n_draw, sizeof *ga->winner);
	ga->breed.parent = xcalloc(ga->n_draw, sizeof *ga->breed.parent);
	for (size_t i = 0; i < ga->n_draw; i++) {
		double u = ((double)i + 0.5) / (double)ga->n_draw;
		double rank = (double)n * (1 - el_pow(1 - u, over));
		size_t r = rank > 0 ? (size_t)rank : 0;
		ga->winner[i] = (uint32_t)(r < n ? r : n - 1);
	}
}

struct ga *
ga_new(const struct ga_options *options, size_t n_gene, const double *lower,
    const double *upper)
{
	static breed_block *const BREEDERS[] = {
	    breed_block_base, breed_block_avx2, breed_block_avx512};
	assert(options->population >= 8 && n_gene < STREAM);
	assert(options->elite >= 1 && options->elite < options->population);
	struct ga *ga = xcalloc(1, sizeof *ga);
	struct breed *b = &ga->breed;
	size_t n = options->population;
	ga->options = *options;
	ga->block = BREEDERS[isa_usable_or_best(options->isa)];
	ga->best = xcalloc_doubles(n_gene);
	*b = (struct breed){.n_gene = n_gene,
	    .lower = xcalloc_doubles(n_gene),
	    .upper = xcalloc_doubles(n_gene),
	    .scale = xcalloc_doubles(n_gene),
	    .told = xcalloc(n_gene, sizeof(*b->told)),
	    .asked = xcalloc(n_gene, sizeof(*b->asked)),
	    .crossover = options->crossover,
	    .mutation = options->mutation,
	    .anywhere = options->anywhere};
	for (size_t g = 0; g < n_gene; g++) {
		b->lower[g] = lower[g];
		b->upper[g] = upper[g];
		b->told[g] = xcalloc_doubles(n + 64);
		b->asked[g] = xcalloc_doubles(n + 64);
	}
	ga->misfit = xcalloc_doubles(n);
	ga->rank = xcalloc(n, sizeof *ga->rank);
	ga->spare = xcalloc(n, sizeof *ga->spare);
	ga->key = xcalloc(n, sizeof *ga->key);
	tabulate_tournament_winners(ga);
	ga->status.best = INFINITY;
	ga->status.median = ga->status.worst = INFINITY;
	sample_first_generation(ga);
	return ga;
}

void
ga_free(struct ga *ga)
{
	if (ga == NULL)
		return;
	for (size_t g = 0; g < ga->breed.n_gene; g++) {
		free(ga->breed.told[g]);
		free(ga->breed.asked[g]);
	}
	free(ga->breed.told);
	free(ga->breed.asked);
	free(ga->breed.lower);
	free(ga->breed.upper);
	free(ga->best);
	free(ga->breed.scale);
	free(ga->misfit);
	free(ga->winner);
	free(ga->breed.parent);
	free(ga->rank);
	free(ga->spare);
	free(ga->key);
	free(ga);
}

const double *const *
ga_genes_of_last_generation(const struct ga *ga)
{
	return (const double *const *)ga->breed.told;
}

enum { DIGIT = 11, DIGITS = 1 << DIGIT };

/* One pass of a stable radix sort: sorts from into to by one digit of the keys.
 * from may be NULL: 0, 1, .. */
static void
radix_sort_pass(
    const struct ga *ga, int shift, const uint32_t *from, uint32_t *to)
{
	uint32_t count[DIGITS + 1] = {0};
	size_t n = ga->options.population;
	for (size_t i = 0; i < n; i++)
		count[((ga->key[i] >> shift) & (DIGITS - 1)) + 1]++;
	for (size_t d = 0; d < DIGITS; d++)
		count[d + 1] += count[d];
	for (size_t i = 0; i < n; i++) {
		uint32_t c = from != NULL ? from[i] : (uint32_t)i;
		to[count[(ga->key[c] >> shift) & (DIGITS - 1)]++] = c;
	}
}

/* Ranks the candidates.  The bits of doubles above 0 rise with their values, so
 * the key is their distance from the best one's.  It is cut to 22 bits that
 * resolve the better half; candidates with equal keys stay in the order of
 * their indices. */
static void
ga_rank_candidates(struct ga *ga, uint64_t best, uint64_t typical)
{
	const uint64_t most = (1u << 2 * DIGIT) - 1;
	int shift = 0;
	while ((typical - best) >> shift > most / 4)
		shift++;
	for (size_t i = 0; i < ga->options.population; i++) {
		uint64_t key =
		    (el_bits_of_double(ga->misfit[i]) - best) >> shift;
		ga->key[i] = (uint32_t)(key < most ? key : most);
	}
	radix_sort_pass(ga, 0, NULL, ga->spare);
	radix_sort_pass(ga, DIGIT, ga->spare, ga->rank);
}

static void
update_ga_status(struct ga *ga)
{
	struct ga_status *s = &ga->status;
	size_t n = ga->options.population, best = 0;
	double worst = -INFINITY, last_median = s->median;
	for (size_t i = 0; i < n; i++) {
		double f = ga->misfit[i];
		worst = f > worst ? f : worst;
		best = f < ga->misfit[best] ? i : best;
	}
	double least = ga->misfit[best];
	double typical = last_median > least ? last_median : worst;
	ga_rank_candidates(
	    ga, el_bits_of_double(least), el_bits_of_double(typical));
	s->worst = worst;
	s->median = ga->misfit[ga->rank[n / 2]];
	if (least < s->best || s->generation == 0) {
		s->best = least;
		for (size_t g = 0; g < ga->breed.n_gene; g++)
			ga->best[g] = ga->breed.told[g][best];
	}
	s->generation++;
}

/* Uses the standard deviations of the first candidates, which are a random
 * sample: a few per cent more or less do not matter to a mutation. */
static void
update_scale_of_mutation(struct ga *ga)
{
	size_t n = ga->options.population;
	n = n < SCALE_SAMPLE ? n : SCALE_SAMPLE;
	for (size_t g = 0; g < ga->breed.n_gene; g++) {
		const double *x = ga->breed.told[g];
		double sum = 0, squares = 0;
		for (size_t i = 0; i < n; i++) {
			sum += x[i] - x[0];
			squares += (x[i] - x[0]) * (x[i] - x[0]);
		}
		double mean = sum / (double)n;
		double variance = squares / (double)n - mean * mean;
		ga->breed.scale[g] = variance > 0 ? sqrt(variance) : 0;
	}
}

static void
prepare_breeding(struct ga *ga)
{
	struct breed_keys *keys = &ga->breed.keys;
	for (size_t i = 0; i < ga->n_draw; i++)
		ga->breed.parent[i] = ga->rank[ga->winner[i]];
	for (size_t i = 0; i < 2; i++)
		keys->parent[i] = random_stream_key(ga, USE_PARENT, i);
	keys->pair = random_stream_key(ga, USE_PAIR, 0);
	keys->line = random_stream_key(ga, USE_PAIR, 1);
	for (size_t g = 0; g < ga->breed.n_gene; g++)
		keys->gene[g] = random_stream_key(ga, USE_GENE, g);
	ga->ready = false;
}

const double *const *
ga_next_candidates_subset(const struct ga *ga, size_t from, size_t to)
{
	const double *const *asked = (const double *const *)ga->breed.asked;
	if (ga->ready)
		return asked;
	assert(from % GA_PART == 0 && to <= ga->options.population);
	for (size_t i = from; i < to; i += BREED_BLOCK)
		ga->block(&ga->breed, i);
	for (size_t i = from; i < to && i < ga->options.elite; i++)
		for (size_t g = 0; g < ga->breed.n_gene; g++)
			ga->breed.asked[g][i] = ga->breed.told[g][ga->rank[i]];
	return asked;
}

const double *const *
ga_next_candidates(struct ga *ga)
{
	const double *const *asked =
	    ga_next_candidates_subset(ga, 0, ga->options.population);
	ga->ready = true;
	return asked;
}

void
ga_set_misfits(struct ga *ga, const double *misfit)
{
	double **swap = ga->breed.told;
	ga->breed.told = ga->breed.asked;
	ga->breed.asked = swap;
	memcpy(ga->misfit, misfit, ga->options.population * sizeof *misfit);
	update_ga_status(ga);
	update_scale_of_mutation(ga);
	prepare_breeding(ga);
}

void
ga_set_bounds(struct ga *ga, const double *lower, const double *upper)
{
	ga_next_candidates(ga);
	for (size_t g = 0; g < ga->breed.n_gene; g++) {
		double low = lower[g], high = upper[g];
		double best = fmin(fmax(ga->best[g], low), high);
		for (size_t i = 0; i < ga->options.population; i++)
			ga->breed.asked[g][i] =
			    fmin(fmax(ga->breed.asked[g][i], low), high);
		if (best != ga->best[g])
			ga->status.best = INFINITY;
		ga->best[g] = best;
		ga->breed.lower[g] = low;
		ga->breed.upper[g] = high;
	}
}

struct ga_status
ga_status(const struct ga *ga)
{
	return ga->status;
}

const double *
ga_best_genes(const struct ga *ga)
{
	return ga->best;
}

const uint32_t *
ga_get_candidate_ranking(const struct ga *ga)
{
	return ga->rank;
}

void
ga_quantiles_of_gene(const struct ga *ga, size_t gene, double *p10, double *p90)
{
	/* Any successive candidates are a random sample, except the elite. */
	double sample[SPREAD_SAMPLE];
	size_t first = ga->options.elite;
	size_t n = ga->options.population - first;
	n = n < SPREAD_SAMPLE ? n : SPREAD_SAMPLE;
	memcpy(sample, ga->breed.told[gene] + first, n * sizeof *sample);
	*p10 = gsl_stats_select(sample, 1, n, n / 10);
	*p90 = gsl_stats_select(sample, 1, n, n - 1 - n / 10);
}
