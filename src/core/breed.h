/* Breeding a generation, compiled once for each instruction set; used by ga.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_BREED_H
#define TIPSPEED_CORE_BREED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/rng.h"

enum { BREED_GENES = 16, BREED_BLOCK = 8 };

/* Streams of random numbers of one generation. */
struct breed_keys {
	struct rng_key parent[2], pair, line;
	struct rng_key blend[BREED_GENES], mutate[BREED_GENES];
};

/* told, asked: one array a gene.  rank [n]: candidates of told, best first.
 * over_tournament: 1 / size.  scale [n_gene]: unit of a mutation. */
struct breed {
	size_t n_gene, n;
	const double *const *told;
	double *const *asked;
	const uint32_t *rank;
	const double *lower, *upper, *scale;
	double over_tournament, crossover, mutation;
	bool anywhere;
	struct breed_keys keys;
};

/* Children first..first+BREED_BLOCK-1. */
typedef void breed_block(const struct breed *b, size_t first);

breed_block breed_block_base;
breed_block breed_block_avx2;
breed_block breed_block_avx512;

#endif
