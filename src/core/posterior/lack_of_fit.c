/* Computes the lack of fit from the products of neighbouring residuals along
 * each run's curve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/lack_of_fit.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/numeric/elementary.h"
#include "core/posterior/ensemble.h"

/* Computes r [n], the residuals of the mean answer at a run, and h [n] midway
 * between answer and measurement (discrepancy.h). */
static void
compute_run_residuals(const struct posterior *p, const struct misfit_run *run,
    double *r, double *h)
{
	struct ensemble *e = ensemble_new(p, &run->feed, run->sieve, run->n);
	ensemble_set_speed_unconstrained(e, run->speed);
	ensemble_mean_answer(e, r);
	for (size_t i = 0; i < run->n; i++) {
		h[i] =
		    discrepancy_scale_at_passing((run->measured[i] + r[i]) / 2);
		r[i] = run->measured[i] - r[i];
	}
	ensemble_free(e);
}

/* Returns the standard deviation of the errors that a sample shares along its
 * curve. */
static double
estimate_sd_shared_along_curve(
    const struct posterior *p, const struct misfit *m)
{
	double sum = 0;
	if (m->n_run == p->n_speed)
		return HYPER[HYPER_SHARED].median;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		sum += p->draw[d].hyper[HYPER_SHARED] / POSTERIOR_DRAWS;
	return sum;
}

/* Returns the share of residuals r [n] that belongs to the product and not to
 * the sample. */
static double
residual_share_due_to_product(
    const double *r, const double *h, size_t n, double shared)
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

/* Returns the share of residuals r [m->n_residual] that is smooth along the
 * curves.  Independent errors of neighbours are uncorrelated; the errors that
 * the smooth answer leaves have a correlation of a half with their
 * neighbours. */
static double
smooth_share_of_residuals(const struct misfit *m, const double *r)
{
	double along = 0, squares = 0;
	for (size_t j = 0; j < m->n_run; r += m->run[j++].n)
		for (size_t i = 0; i < m->run[j].n; i++) {
			squares += r[i] * r[i];
			along += i > 0 ? r[i] * r[i - 1] : 0;
		}
	return squares > 0 ? fmin(fmax(2 * along / squares, 0), 1) : 0;
}

/* Adds a run's residuals, divided by h and times `share`, to those at the
 * knots: linear in ln size between its sieves, constant beyond them. */
static void
add_residuals_at_knots(const struct posterior *p, const struct misfit_run *run,
    const double *r, const double *h, double share, double *lack)
{
	/* h is near 0 where almost nothing or almost all passes. */
	const double least = 0.05;
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

static size_t
index_of_speed(const struct posterior *p, double v)
{
	size_t k = 0;
	while (p->speed[k] < v)
		k++;
	return k;
}

/* Adds the residuals r [m->n_residual] of all runs, divided by h
 * [m->n_residual], times the share [m->n_run] of their run.  Averages
 * repeats. */
static void
add_weighted_residuals_of_runs(struct posterior *p, const struct misfit *m,
    const double *r, const double *h, const double *share)
{
	double repeats[POSTERIOR_RUNS] = {0};
	for (size_t j = 0; j < m->n_run; j++)
		repeats[index_of_speed(p, m->run[j].speed)]++;
	for (size_t j = 0; j < m->n_run; r += m->run[j].n, h += m->run[j++].n) {
		size_t k = index_of_speed(p, m->run[j].speed);
		add_residuals_at_knots(p, &m->run[j], r, h,
		    share[j] / repeats[k], p->lack + k * p->n_knot);
	}
}

/* Returns [2 * m->n_residual]: the residuals of the mean answer at all runs,
 * followed by their h.  The caller frees them. */
static double *
residuals_of_runs(const struct posterior *p, const struct misfit *m)
{
	double *r = xcalloc_doubles(2 * m->n_residual), *at = r;
	for (size_t j = 0; j < m->n_run; at += m->run[j++].n)
		compute_run_residuals(p, &m->run[j], at, at + m->n_residual);
	return r;
}

void
lack_of_fit_compute(struct posterior *p, const struct misfit *m)
{
	if (p->n_speed < 2)
		return;
	double *r = residuals_of_runs(p, m), *h = r + m->n_residual;
	double *share = xcalloc_doubles(m->n_run),
	       shared = estimate_sd_shared_along_curve(p, m);
	for (size_t j = 0, at = 0; j < m->n_run; at += m->run[j++].n)
		share[j] = residual_share_due_to_product(
		    r + at, h + at, m->run[j].n, shared);
	p->lack = xcalloc_doubles(p->n_speed * p->n_knot);
	add_weighted_residuals_of_runs(p, m, r, h, share);
	free(share);
	free(r);
}

void
lack_of_fit_add_smooth_part(struct posterior *p, const struct misfit *m)
{
	const double usual = 0.1, most = 0.75; /* of the share q of D25 */
	double law = fmin(1, (most - p->straight) / (most - usual));
	if (p->n_speed < 2 || law == 1)
		return;
	double *r = residuals_of_runs(p, m), *share = xcalloc_doubles(m->n_run);
	double smooth = (1 - law * law) * smooth_share_of_residuals(m, r);
	for (size_t j = 0; j < m->n_run; j++)
		share[j] = smooth;
	add_weighted_residuals_of_runs(p, m, r, r + m->n_residual, share);
	free(share);
	free(r);
}
