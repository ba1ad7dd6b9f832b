/* Running mean and covariance of coordinates, their Cholesky factor, and normal
 * moves in its basis.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/guide.h"

#include <math.h>
#include <string.h>

/* One generation's sums, about an origin that keeps their digits. */
struct moments {
	double of[GUIDE_MOST], cross[GUIDE_MOST][GUIDE_MOST];
};

static void
add_chain(const struct guide *g, const double *x, size_t size, double weight,
    struct moments *sum)
{
	double off[GUIDE_MOST];
	for (size_t i = 0; i < size; i++) {
		off[i] = x[i] - g->origin[i];
		sum->of[i] += weight * off[i];
		for (size_t j = 0; j <= i; j++)
			sum->cross[i][j] += weight * off[i] * off[j];
	}
}

void
guide_add(struct guide *g, const double *const *x, size_t chains, size_t size,
    double most)
{
	struct moments sum = {{0}, {{0}}};
	if (g->n == 0)
		memcpy(g->origin, x[0], size * sizeof **x);
	for (size_t c = 0; c < chains; c++)
		add_chain(g, x[c], size, 1 / (double)chains, &sum);
	g->n = fmin(g->n + 1, most);
	for (size_t i = 0; i < size; i++) {
		g->mean[i] += (sum.of[i] - g->mean[i]) / g->n;
		for (size_t j = 0; j <= i; j++)
			g->cross[i][j] +=
			    (sum.cross[i][j] - g->cross[i][j]) / g->n;
	}
}

void
guide_factor(
    const struct guide *g, const size_t *at, size_t n, struct guide_part *part)
{
	const double more = 1.0005; /* variance: ridges are narrow */
	part->n = 0;
	for (size_t k = 0; k < n; k++) {
		size_t i = at[k];
		double mean = g->mean[i],
		       variance = g->cross[i][i] - mean * mean;
		if (!(variance > 1e-16 * (1 + mean * mean)))
			continue;
		part->at[part->n] = i;
		part->mean[part->n++] = g->origin[i] + mean;
	}
	for (size_t a = 0; a < part->n; a++)
		for (size_t b = 0; b <= a; b++) {
			size_t i = part->at[a], j = part->at[b];
			double c = g->cross[i][j] - g->mean[i] * g->mean[j];
			double own = a == b ? more * c : c, rest = own;
			for (size_t k = 0; k < b; k++)
				rest -= part->L[a][k] * part->L[b][k];
			part->L[a][b] = a == b ? sqrt(fmax(rest, 1e-6 * own))
					       : rest / part->L[b][b];
		}
}

double
guide_move(const struct guide_part *part, double share, const double *x,
    double *y, struct rng_key key, uint32_t next)
{
	double z[GUIDE_MOST], more = 0;
	for (size_t a = 0; a < part->n; a++) {
		z[a] = x[part->at[a]] - part->mean[a];
		for (size_t k = 0; k < a; k++)
			z[a] -= part->L[a][k] * z[k];
		z[a] /= part->L[a][a];
	}
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
