/* Running mean and covariance of coordinates, their Cholesky factor, and normal
 * moves in its basis.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/guide.h"

#include <math.h>
#include <string.h>

#include "core/numeric/elementary.h"

void
guide_init(struct guide *g, size_t size, const double *origin)
{
	*g = (struct guide){.size = size};
	memcpy(g->origin, origin, size * sizeof *origin);
}

static void
add_chain_to_moments(
    const struct guide *g, const double *x, double weight, struct moments *sum)
{
	double off[GUIDE_MOST];
	for (size_t i = 0; i < g->size; i++) {
		off[i] = x[i] - g->origin[i];
		sum->mean[i] += weight * off[i];
		for (size_t j = 0; j <= i; j++)
			sum->cross[i][j] += weight * off[i] * off[j];
	}
}

/* Moves the moments part of the way to other moments. */
static void
move_moments_part_way(struct guide *g, double part, const struct moments *to)
{
	for (size_t i = 0; i < g->size; i++) {
		g->of.mean[i] += part * (to->mean[i] - g->of.mean[i]);
		for (size_t j = 0; j <= i; j++)
			g->of.cross[i][j] +=
			    part * (to->cross[i][j] - g->of.cross[i][j]);
	}
}

void
guide_add_generation(struct guide *g, const double *const *x, size_t chains,
    double weight, double keep)
{
	struct moments sum = {{0}, {{0}}};
	g->n *= keep;
	if (chains == 0)
		return;
	for (size_t c = 0; c < chains; c++)
		add_chain_to_moments(g, x[c], 1 / (double)chains, &sum);
	g->n += weight;
	move_moments_part_way(g, weight / g->n, &sum);
}

void
guide_merge_moments(
    struct guide *g, const struct guide *other, double generations)
{
	g->n += generations;
	move_moments_part_way(g, generations / g->n, &other->of);
}

void
guide_factor_subset(const struct guide *g, const size_t *at, size_t n,
    struct guide_subset *part)
{
	const double more = 1.0005; /* factor of the variance, because ridges
				     * are narrow */
	part->n = 0;
	for (size_t k = 0; k < n; k++) {
		size_t i = at[k];
		double mean = g->of.mean[i],
		       variance = g->of.cross[i][i] - mean * mean;
		if (!(variance > 1e-16 * (1 + mean * mean)))
			continue;
		part->at[part->n] = i;
		part->mean[part->n++] = g->origin[i] + mean;
	}
	for (size_t a = 0; a < part->n; a++)
		for (size_t b = 0; b <= a; b++) {
			size_t i = part->at[a], j = part->at[b];
			double c =
			    g->of.cross[i][j] - g->of.mean[i] * g->of.mean[j];
			double own = a == b ? more * c : c, rest = own;
			for (size_t k = 0; k < b; k++)
				rest -= part->L[a][k] * part->L[b][k];
			part->L[a][b] = a == b ? sqrt(fmax(rest, 1e-6 * own))
					       : rest / part->L[b][b];
		}
}

/* Computes the standardised x: L z = x - mean. */
static void
guide_standardise(const struct guide_subset *part, const double *x, double *z)
{
	for (size_t a = 0; a < part->n; a++) {
		z[a] = x[part->at[a]] - part->mean[a];
		for (size_t k = 0; k < a; k++)
			z[a] -= part->L[a][k] * z[k];
		z[a] /= part->L[a][a];
	}
}

double
guide_log_density(const struct guide_subset *part, const double *x)
{
	double z[GUIDE_MOST], sum = 0;
	guide_standardise(part, x, z);
	for (size_t a = 0; a < part->n; a++)
		sum -= z[a] * z[a] / 2 + el_log(part->L[a][a]);
	return sum;
}

double
guide_propose_mcmc_step(const struct guide_subset *part, double share,
    const double *x, double *y, struct rng_key key, uint32_t next)
{
	double z[GUIDE_MOST], more = 0;
	guide_standardise(part, x, z);
	for (size_t a = 0; a < part->n; a++, next += 2) {
		if (rng_uniform(key, next) >= share)
			continue;
		double anew = rng_normal(key, next + 1);
		more += (z[a] * z[a] - anew * anew) / 2;
		z[a] = anew;
	}
	for (size_t a = 0; a < part->n; a++) {
		y[part->at[a]] = part->mean[a];
		for (size_t k = 0; k <= a; k++)
			y[part->at[a]] += part->L[a][k] * z[k];
	}
	return more;
}
