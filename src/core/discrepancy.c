/* D13.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/discrepancy.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "core/elementary.h"

/* Found by counting, with bench/coverage: what bands hold and how far answers
 * err where plants follow the model and where they do not. */
const struct hyper_info HYPER[HYPERS] = {
    {"discrepancy", "sigma_d", 0.004, 1.2, N_("what the model leaves out")},
    {"length", "l", 1, 0.4, N_("ln of sizes over which it is alike")},
    {"slope", "c", 0.5, 0.5, N_("how it changes with the speed")},
    {"narrow", "sigma_n", 0.0015, 1.2, N_("features of single sieves")},
    {"shared", "sigma_s", 0.003, 0.7,
	N_("sampling error shared along a curve")},
    {"independent", "sigma_i", 0.0035, 0.3, N_("error of a single passing")},
};

/* ln of the energy that t counts in, the length of the narrow part, and what no
 * passing is trusted to more than: its rounding. */
static const double STEP = 0.135, NARROW = 0.25, ROUNDING = 0.0005;

double
discrepancy_time(double v, double middle)
{
	return (2 * el_log(v) - el_log(2) - middle) / STEP;
}

void
discrepancy_terms(double t, double slope, double term[static DISCREPANCY_TERMS])
{
	term[0] = 1;
	term[1] = slope * t;
	term[2] = slope * (t * t - 1) * 0.4;
}

double
discrepancy_prior(const double log_hyper[static HYPERS], double noise)
{
	const double known = 0.05; /* spread of what is said to be known */
	double sum = 0;
	for (size_t i = 0; i < HYPERS; i++) {
		bool given = i == HYPER_OWN && noise > 0;
		double median = given ? noise : HYPER[i].median;
		double z = (log_hyper[i] - el_log(median)) /
			   (given ? known : HYPER[i].spread);
		sum += z * z / 2;
	}
	return sum;
}

double
discrepancy_rho(double apart, double length)
{
	double z = apart / length;
	return z * z > 80 ? 0 : el_exp(-z * z / 2);
}

double
discrepancy_covariance(double apart, const double hyper[static HYPERS])
{
	double wide = hyper[HYPER_DELTA], narrow = hyper[HYPER_NARROW];
	return wide * wide * discrepancy_rho(apart, hyper[HYPER_LENGTH]) +
	       narrow * narrow * discrepancy_rho(apart, NARROW);
}

double
discrepancy_shared(double apart, const double hyper[static HYPERS])
{
	double shared = hyper[HYPER_SHARED];
	return shared * shared * discrepancy_rho(apart, hyper[HYPER_LENGTH]);
}

void
discrepancy_cholesky(double *L, size_t n)
{
	double *column = xdoubles(n);
	for (size_t k = 0; k < n; k++) {
		L[k * n + k] = sqrt(L[k * n + k]);
		for (size_t i = k + 1; i < n; i++)
			column[i] = L[i * n + k] /= L[k * n + k];
		/* What is left of each row: a loop that has vectors. */
		for (size_t i = k + 1; i < n; i++)
			for (size_t j = k + 1; j <= i; j++)
				L[i * n + j] -= column[i] * column[j];
	}
	free(column);
}

void
discrepancy_forward(const double *L, size_t n, double *d)
{
	for (size_t i = 0; i < n; i++) {
		for (size_t k = 0; k < i; k++)
			d[i] -= L[i * n + k] * d[k];
		d[i] /= L[i * n + i];
	}
}

void
discrepancy_backward(const double *L, size_t n, double *z)
{
	for (size_t i = n; i-- > 0;) {
		for (size_t k = i + 1; k < n; k++)
			z[i] -= L[k * n + i] * z[k];
		z[i] /= L[i * n + i];
	}
}

/* Of each cell the number of its size, cells with the same have the same; there
 * are as many as returned. */
static size_t
number_sizes(const struct cell *cell, size_t n, size_t *size)
{
	size_t sizes = 0;
	for (size_t i = 0; i < n; i++) {
		size_t j = 0;
		while (cell[j].log_size != cell[i].log_size)
			j++;
		size[i] = j < i ? size[j] : sizes++;
	}
	return sizes;
}

/* Runs have the same sieves, mostly: the exponentials are of pairs of sizes,
 * and not of pairs of cells. */
void
discrepancy_fill(const struct cell *cell, size_t n,
    const double log_hyper[static HYPERS], double *L)
{
	double hyper[HYPERS];
	for (size_t i = 0; i < HYPERS; i++)
		hyper[i] = el_exp(log_hyper[i]);
	double own = hyper[HYPER_OWN] * hyper[HYPER_OWN];
	size_t *size = xcalloc(n, sizeof *size);
	size_t sizes = number_sizes(cell, n, size);
	double *covariance = xdoubles(2 * sizes * sizes),
	       *shared = covariance + sizes * sizes,
	       (*term)[DISCREPANCY_TERMS] = xcalloc(n, sizeof *term);
	for (size_t i = 0, known = 0; i < n; i++) {
		const struct cell *a = &cell[i];
		bool first = size[i] == known;
		known += first;
		discrepancy_terms(a->t, hyper[HYPER_SLOPE], term[i]);
		for (size_t j = 0; j <= i; j++) {
			const struct cell *b = &cell[j];
			size_t at = size[i] * sizes + size[j],
			       other = size[j] * sizes + size[i];
			double apart = a->log_size - b->log_size, terms = 0;
			if (first) {
				covariance[at] = covariance[other] =
				    discrepancy_covariance(apart, hyper);
				shared[at] = shared[other] =
				    discrepancy_shared(apart, hyper);
			}
			for (size_t k = 0; k < DISCREPANCY_TERMS; k++)
				terms += term[i][k] * term[j][k];
			double K = covariance[at] * terms;
			if (a->run == b->run)
				K += shared[at];
			L[i * n + j] = a->h * b->h * (K + (i == j ? own : 0)) +
				       (i == j ? ROUNDING * ROUNDING : 0);
		}
	}
	free(term);
	free(covariance);
	free(size);
}

void
discrepancy_factor(const struct cell *cell, size_t n,
    const double log_hyper[static HYPERS], double *L)
{
	discrepancy_fill(cell, n, log_hyper, L);
	discrepancy_cholesky(L, n);
}

double
discrepancy_level(const double *L, size_t n, double *d)
{
	double level = 0;
	discrepancy_forward(L, n, d);
	for (size_t i = 0; i < n; i++)
		level += d[i] * d[i] / 2 + el_log(L[i * n + i]);
	return level;
}
