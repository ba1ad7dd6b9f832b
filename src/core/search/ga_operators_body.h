/* Offspring from parents, LANES at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/ga_operators.h"
#include "core/search/lanes.h"

static inline lanes
random_uniform_lanes(struct rng_key key, size_t first)
{
	lanes v = {0};
	for (size_t l = 0; l < LANES; l++)
		v[l] = rng_uniform(key, (uint32_t)(first + l));
	return v;
}

/* Computes a gene's two random numbers. */
static inline void
random_uniform_pair(struct rng_key key, size_t first, lanes *a, lanes *b)
{
	for (size_t l = 0; l < LANES; l++) {
		uint32_t bits = rng_random_bits(key, (uint32_t)(first + l));
		(*a)[l] = rng_bits_to_unit(bits);
		(*b)[l] = rng_bits_to_unit(rng_rehash_bits(bits));
	}
}

static inline void
choose_parents(
    const struct breed *b, struct rng_key key, size_t first, uint32_t *index)
{
	uint32_t draw[LANES];
	for (size_t l = 0; l < LANES; l++)
		draw[l] = rng_random_bits(key, (uint32_t)(first + l)) >>
			  b->draw_shift;
	for (size_t l = 0; l < LANES; l++)
		index[l] = b->parent[draw[l]];
}

/* Returns a mutation.  One random number decides both whether to mutate and by
 * how much.  Steps are of the order of 1; most are small, a few are large. */
static inline lanes
mutation_step(const struct breed *b, lanes u)
{
	lanes v = u * (2 / b->mutation) - 1;
	lanes away = 1 - lanes_max(v, -v);
	lanes step = 0.5 * v / (away * away + 0.02);
	return (lanes)((u < b->mutation) & (lanes_mask)step);
}

/* Returns the child or, with the mutation's probability, any place in the
 * box. */
static inline lanes
mutate_anywhere(const struct breed *b, size_t g, lanes child, lanes u)
{
	lanes place =
	    b->lower[g] + u * ((b->upper[g] - b->lower[g]) / b->mutation);
	return lanes_select(u < b->mutation, place, child);
}

/* Moves a value outside the box to a place between the parent and the bound. */
static inline lanes
move_into_bounds(
    const struct breed *b, size_t g, lanes x, lanes parent, lanes u)
{
	lanes lower = lanes_broadcast(b->lower[g]),
	      upper = lanes_broadcast(b->upper[g]);
	lanes_mask under = x<lower, over = x> upper;
	if (!lanes_any(under | over))
		return x;
	/* Half of the offspring land on the bound itself, where optima often
	 * lie.
	 * */
	lanes part = lanes_min(2 * u, lanes_broadcast(1));
	x = lanes_select(under, parent + (lower - parent) * part, x);
	x = lanes_select(over, parent + (upper - parent) * part, x);
	x = lanes_max(x, lower);
	return lanes_min(x, upper);
}

static inline void
breed_candidate_lanes(const struct breed *b, size_t first)
{
	uint32_t mother[LANES], father[LANES];
	choose_parents(b, b->keys.parent[0], first, mother);
	choose_parents(b, b->keys.parent[1], first, father);
	lanes_mask crossed =
	    random_uniform_lanes(b->keys.pair, first) < b->crossover;
	lanes along = random_uniform_lanes(b->keys.line, first);
	lanes_mask straight = along < 0.5;
	for (size_t g = 0; g < b->n_gene; g++) {
		lanes x = lanes_gather(b->told[g], mother);
		lanes y = lanes_gather(b->told[g], father);
		lanes m = {0}, own = m;
		random_uniform_pair(b->keys.gene[g], first, &m, &own);
		lanes u = lanes_select(straight, 2 * along, own);
		lanes share = (lanes)(crossed & (lanes_mask)(1.8 * u - 0.4));
		lanes child = x + share * (y - x);
		if (lanes_any(m < b->mutation))
			child = b->anywhere
				    ? mutate_anywhere(b, g, child, m)
				    : child + b->scale[g] * mutation_step(b, m);
		child = move_into_bounds(b, g, child, x, own);
		for (size_t l = 0; l < LANES; l++)
			b->asked[g][first + l] = child[l];
	}
}

void
BREED_NAME(const struct breed *b, size_t first)
{
	for (size_t i = 0; i < BREED_BLOCK; i += LANES)
		breed_candidate_lanes(b, first + i);
}
