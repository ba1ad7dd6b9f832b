/* A genetic algorithm with real genes in a box; knows nothing of crushing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_GA_H
#define TIPSPEED_CORE_SEARCH_GA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/numeric/isa.h"

/* Ask for candidates, evaluate them in any way, tell their misfits: that is one
 * generation.  Tournament selection, blend crossover, mutation, elitism.  The
 * random numbers are a function of (seed, generation, candidate, gene), so the
 * same seed gives the same generations whoever evaluates them. */
struct ga;

struct ga_options {
	size_t population; /* candidates a generation, at least 8 */
	size_t tournament; /* candidates a parent is the best of */
	size_t elite;      /* best candidates kept unchanged, at least 1 */
	double crossover;  /* share of children with two parents */
	double mutation;   /* chance for each gene */
	bool anywhere;     /* mutate to any place in the box, not nearby */
	uint64_t seed;
	enum isa isa;
};

/* The paper's population, and operators found good on its Table 3. */
struct ga_options ga_options_default(void);

/* A textbook algorithm: tournaments of two, mutation anywhere in the box. */
struct ga_options ga_options_plain(void);

/* Genes lie in lower..upper [n_gene]; where both are equal the gene is fixed.
 * The first generation is uniform in the box. */
struct ga *ga_new(const struct ga_options *options, size_t n_gene,
    const double *lower, const double *upper);
void ga_free(struct ga *ga);

/* This generation's candidates: one array a gene, [population], aligned to 64
 * bytes and readable up to the next multiple of 64.  Borrowed until ga_tell. */
const double *const *ga_ask(struct ga *ga);

/* As ga_ask, but guarantees only the candidates from..to-1, for several threads
 * that each evaluate their own parts.  from: a multiple of GA_PART; to: at most
 * the population. */
enum { GA_PART = 8 };
const double *const *ga_ask_part(const struct ga *ga, size_t from, size_t to);

/* Receives the misfits of this generation's candidates, all of which were asked
 * for: lower is better, INFINITY for a candidate without a misfit. */
void ga_tell(struct ga *ga, const double *misfit);

/* Changes the box from the next generation on; its candidates are moved to the
 * limits.  Where the best candidate ever told lies outside, it is moved too,
 * and its misfit is INFINITY until the next ga_tell.  Drawing half of the
 * candidates again where the box has grown was tried: none came near the
 * best. */
void ga_set_box(struct ga *ga, const double *lower, const double *upper);

/* State after the last ga_tell, by value.  worst and median count infinite
 * misfits as such. */
struct ga_status {
	size_t generation; /* generations told */
	size_t evaluations;
	size_t infinite;      /* misfits told that were INFINITY, in all */
	double best;          /* lowest misfit ever told */
	double median, worst; /* of the last generation */
};

struct ga_status ga_status(const struct ga *ga);

/* Genes [n_gene] of the best candidate ever told. */
const double *ga_best(const struct ga *ga);

/* Index, within the last generation told, of candidates in order of increasing
 * misfit; the first `n` places are sorted.  Genes through ga_told. */
void ga_leaders(const struct ga *ga, size_t n, size_t *index);
const double *const *ga_told(const struct ga *ga);

/* Lowest and highest value of a gene among the middle 80 % of the last
 * generation told (its 10 % and 90 % quantiles): of at most 256 candidates that
 * are not of the elite. */
void ga_spread(const struct ga *ga, size_t gene, double *p10, double *p90);

#endif
