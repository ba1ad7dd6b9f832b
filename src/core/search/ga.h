/* A genetic algorithm with real genes in a box; knows nothing of crushing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_GA_H
#define TIPSPEED_CORE_SEARCH_GA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/numeric/isa.h"

/* For each generation, ask for the candidates, evaluate them in any way, and
 * report their misfits.  Tournament selection, blend crossover, mutation,
 * elitism.  The random numbers are a function of (seed, generation, candidate,
 * gene), so the same seed gives the same generations however they are
 * evaluated. */
struct ga;

struct ga_options {
	size_t population; /* candidates per generation, at least 8 */
	size_t tournament; /* candidates that compete to be a parent */
	size_t elite;      /* best candidates kept unchanged, at least 1 */
	double crossover;  /* share of offspring with two parents */
	double mutation;   /* chance for each gene */
	bool anywhere;     /* mutate to anywhere in the box, not nearby */
	uint64_t seed;
	enum isa isa;
};

/* Returns the paper's population, and operators that work well on the paper's
 * Table 3. */
struct ga_options ga_options_default(void);

/* Returns the options of a textbook algorithm: tournaments of two, mutation
 * anywhere in the box. */
struct ga_options ga_options_textbook(void);

/* Genes lie in lower..upper [n_gene]; if both are equal, the gene is fixed.
 * The first generation is uniform in the box. */
struct ga *ga_new(const struct ga_options *options, size_t n_gene,
    const double *lower, const double *upper);
void ga_free(struct ga *ga);

/* Returns this generation's candidates: one array [population] per gene,
 * aligned to 64 bytes and readable up to the next multiple of 64.  Valid until
 * ga_set_misfits. */
const double *const *ga_next_candidates(struct ga *ga);

/* As ga_next_candidates, but makes only the candidates from..to-1, for threads
 * that each evaluate a part.  from: a multiple of GA_PART; to: at most the
 * population. */
enum { GA_PART = 8 };
const double *const *ga_next_candidates_subset(
    const struct ga *ga, size_t from, size_t to);

/* Takes the misfits of this generation's candidates, all of which must have
 * been asked for: lower is better, INFINITY for a candidate without a
 * misfit. */
void ga_set_misfits(struct ga *ga, const double *misfit);

/* Changes the box from the next generation on.  Candidates outside are moved to
 * its limits.  If the best candidate so far lies outside, it is moved too, and
 * its misfit is INFINITY until the next ga_set_misfits.  Redrawing half of the
 * candidates after the box had grown was tried, but none came near the best. */
void ga_set_bounds(struct ga *ga, const double *lower, const double *upper);

/* The state after the last ga_set_misfits.  worst and median include infinite
 * misfits. */
struct ga_status {
	size_t generation;    /* generations completed */
	double best;          /* lowest misfit so far */
	double median, worst; /* of the last generation */
};

struct ga_status ga_status(const struct ga *ga);

/* Returns the genes [n_gene] of the best candidate so far. */
const double *ga_best_genes(const struct ga *ga);

/* Return the indices of the last completed generation's candidates by
 * increasing misfit (only the better half is sorted exactly), and their
 * genes. */
const uint32_t *ga_get_candidate_ranking(const struct ga *ga);
const double *const *ga_genes_of_last_generation(const struct ga *ga);

/* Computes the 10 % and 90 % quantiles of a gene over at most 256 candidates of
 * the last completed generation that are not in the elite. */
void ga_quantiles_of_gene(
    const struct ga *ga, size_t gene, double *p10, double *p90);

#endif
