/* Lack of fit from the lag-one products of the residuals along each run's
 * curve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/lack_of_fit.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/numeric/elementary.h"
#include "core/posterior/ensemble.h"

/* What the mean answer leaves at a run, r [n] out, and its h, midway between
 * answer and measurement (discrepancy.h). */
static void
find_residuals(const struct posterior *p, const struct misfit_run *run,
    double *r, double *h)
{
	struct ensemble *e = ensemble_new(p, &run->feed, run->sieve, run->n);
	ensemble_draws_at(e, run->speed);
	ensemble_mean(e, r);
	for (size_t i = 0; i < run->n; i++) {
		h[i] = discrepancy_h((run->measured[i] + r[i]) / 2);
		r[i] = run->measured[i] - r[i];
	}
	ensemble_free(e);
}

/* Standard deviation of the errors that a sample shares along its curve. */
static double
shared_error(const struct posterior *p, const struct misfit *m)
{
	double sum = 0;
	if (m->n_run == p->n_speed)
		return HYPER[HYPER_SHARED].median;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		sum += p->draw[d].hyper[HYPER_SHARED] / POSTERIOR_DRAWS;
	return sum;
}

/* The share of residuals r [n] that is the product's own. */
static double
product_error_share(const double *r, const double *h, size_t n, double shared)
{
	double along = 0, squares = 0, explained = 2 * shared;
	for (size_t i = 0; i < n; i++) {
		squares += r[i] * r[i];
		if (i + 1 < n)
			along += r[i] * r[i + 1] -
				 explained * explained * h[i] * h[i + 1];
	}
	return squares > 0 ? fmin(fmax(along / squares, 0), 1) : 0;
}

/* Adds a run's residuals, over h, times `share` to those at the knots: straight
 * in ln size between its sieves, held beyond them. */
static void
add_residuals_at_knots(const struct posterior *p, const struct misfit_run *run,
    const double *r, const double *h, double share, double *lack)
{
	const double least = 0.05; /* of h: next to nothing or all passes */
	for (size_t k = 0, i = 0; k < p->n_knot; k++) {
		while (i + 1 < run->n && p->knot[k] < el_log(run->sieve[i]))
			i++;
		size_t above = i > 0 ? i - 1 : 0;
		double a = el_log(run->sieve[above]), b = el_log(run->sieve[i]),
		       t = 1;
		if (above < i)
			t = fmin((a - p->knot[k]) / (a - b), 1);
		lack[k] += share * ((1 - t) * r[above] / fmax(h[above], least) +
				       t * r[i] / fmax(h[i], least));
	}
}

void
lack_of_fit_find(struct posterior *p, const struct misfit *m)
{
	if (p->n_speed < 2)
		return;
	double shared = shared_error(p, m), repeats[POSTERIOR_RUNS] = {0};
	double *lack = xdoubles(p->n_speed * p->n_knot);
	for (size_t j = 0; j < m->n_run; j++) {
		const struct misfit_run *run = &m->run[j];
		double *r = xdoubles(2 * run->n), *h = r + run->n;
		size_t k = 0;
		while (p->speed[k] < run->speed)
			k++;
		find_residuals(p, run, r, h);
		double share = product_error_share(r, h, run->n, shared);
		add_residuals_at_knots(
		    p, run, r, h, share, lack + k * p->n_knot);
		repeats[k]++;
		free(r);
	}
	for (size_t k = 0; k < p->n_speed; k++)
		for (size_t i = 0; i < p->n_knot; i++)
			lack[k * p->n_knot + i] /= repeats[k];
	p->lack = lack;
}
