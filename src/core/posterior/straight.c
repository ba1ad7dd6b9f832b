/* What the correction has of all that the speed changes, see straight.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/straight.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/posterior/ensemble.h"

/* How far the straight line is taken to be off between measured speeds, as a
 * share of what the speed changes (doc/decisions/straight-answers.md). */
static const double LINE = 0.15;

/* The largest share: some draws stay, so that a band of 80 % has both ways. */
static const double MOST = 0.75;

/* The means of model and answer at a speed, [n] each. */
static void
find_means(struct ensemble *e, double v, double *model, double *answer)
{
	size_t n = ensemble_sizes(e);
	ensemble_draws_at(e, v);
	const double *M = ensemble_products(e, ENSEMBLE_MODEL);
	ensemble_mean(e, answer);
	for (size_t i = 0; i < n; i++, M += POSTERIOR_DRAWS) {
		model[i] = 0;
		for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
			model[i] += M[d] / POSTERIOR_DRAWS;
	}
}

double
straight_share(const struct posterior *p, const struct psd *feed,
    const double *sieve, size_t n)
{
	double missed = 0, all = 0;
	if (n == 0 || p->n_speed < 2)
		return 0;
	struct ensemble *e = ensemble_new(p, feed, sieve, n);
	double *model = xdoubles(4 * n), *answer = model + 2 * n;
	for (size_t k = 0; k < p->n_speed; k++) {
		size_t now = k % 2 * n, last = n - now;
		find_means(e, p->speed[k], model + now, answer + now);
		for (size_t i = 0; i < n && k > 0; i++) {
			double by = answer[now + i] - answer[last + i];
			double told = model[now + i] - model[last + i];
			missed += (by - told) * (by - told);
			all += by * by;
		}
	}
	free(model);
	ensemble_free(e);
	double line = LINE * LINE * all;
	return all > 0 ? MOST * missed / (missed + line) : 0;
}
