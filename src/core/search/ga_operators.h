/* Crossover and mutation, compiled once for each instruction set; used by ga.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_GA_OPERATORS_H
#define TIPSPEED_CORE_SEARCH_GA_OPERATORS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/numeric/rng.h"

enum { BREED_GENES = 16, BREED_BLOCK = 8 };

/* The random number streams of one generation. */
struct breed_keys {
	struct rng_key parent[2], pair, line;
	struct rng_key gene[BREED_GENES];
};

/* told: the last generation, whose misfits are known; asked: the one being
 * made; an array for each gene.  parent: the winners of tournaments, indexed by
 * a random number shifted right by draw_shift.  lower, upper [n_gene]: the box;
 * scale [n_gene]: the unit of a mutation, the standard deviation of told. */
struct breed {
	size_t n_gene;
	double **told, **asked;
	uint32_t *parent;
	int draw_shift;
	double *lower, *upper, *scale;
	double crossover, mutation;
	bool anywhere;
	struct breed_keys keys;
};

/* Makes the offspring first..first+BREED_BLOCK-1. */
typedef void breed_block(const struct breed *b, size_t first);

breed_block breed_block_base;
breed_block breed_block_avx2;
breed_block breed_block_avx512;

#endif
