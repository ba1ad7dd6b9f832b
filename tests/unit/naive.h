/* Eq 2 once more, in the plainest way and with nothing of src/core: to compare
 * the program's products with.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_NAIVE_H
#define TIPSPEED_TESTS_NAIVE_H

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "core/model/params.h"
#include "core/psd/psd.h"

static inline double
naive_selection(const struct params *p, double v, double x)
{
	double over = pow(x, p->alpha) * v * v / 2 - p->e0_min;
	return over > 0 ? -expm1(-p->f_mat * over) : 0;
}

static inline double
naive_density(const struct params *p, double u)
{
	const double *b = p->beta;
	double cubic = b[0] + b[1] * u + b[2] * u * u + b[3] * u * u * u;
	return cubic > 0 ? cubic : 0;
}

static inline double
naive_passing(const struct psd *psd, double x)
{
	if (x >= psd->size[0])
		return psd->passing[0];
	for (size_t i = 1; i < psd->n; i++)
		if (x >= psd->size[i]) {
			double t = log(x / psd->size[i]) /
				   log(psd->size[i - 1] / psd->size[i]);
			return psd->passing[i] * (1 - t) +
			       psd->passing[i - 1] * t;
		}
	return psd->passing[psd->n - 1];
}

/* B at the ends of cells of equal width in ln u, from u = 1 down to 2^-10, by
 * the midpoint rule. */
enum { NAIVE_CELLS = 8000 };

static inline void
naive_daughters(const struct params *p, double B[static NAIVE_CELLS + 1])
{
	double h = log(1024) / NAIVE_CELLS;
	B[NAIVE_CELLS] = 0;
	for (size_t i = NAIVE_CELLS; i-- > 0;)
		B[i] = B[i + 1] +
		       h * naive_density(p, exp(-h * ((double)i + 0.5)));
	for (size_t i = 1; i <= NAIVE_CELLS && B[0] > 0; i++)
		B[i] /= B[0];
	if (B[0] > 0)
		B[0] = 1;
}

/* B at ln u <= 0, straight between the ends of the cells. */
static inline double
naive_B(const double B[static NAIVE_CELLS + 1], double log_u)
{
	double at = -log_u / (log(1024) / NAIVE_CELLS);
	if (at >= NAIVE_CELLS)
		return 0;
	size_t i = (size_t)at;
	return B[i] + (at - (double)i) * (B[i + 1] - B[i]);
}

/* P(s) = F(s) + integral over x > s of S(x) B(s/x) dF(x) by the midpoint rule,
 * `cells` of them spread over the feed's intervals; a product sieve within an
 * interval cuts off a part of a cell.  sieve [n] m; passing [n] out. */
static inline void
naive_continuous(const struct psd *feed, const double *sieve, size_t n,
    const struct params *p, double v, size_t cells, double *passing)
{
	static double B[NAIVE_CELLS + 1];
	naive_daughters(p, B);
	for (size_t s = 0; s < n; s++)
		passing[s] = naive_passing(feed, sieve[s]);
	double all = log(feed->size[0] / feed->size[feed->n - 1]);
	for (size_t i = 0; i + 1 < feed->n && B[0] > 0; i++) {
		double top = log(feed->size[i]);
		double width = top - log(feed->size[i + 1]);
		double part = ceil(width / all * (double)cells);
		double h = width / part;
		double dF = (feed->passing[i] - feed->passing[i + 1]) / width;
		for (double c = 0; c < part; c += 1) {
			double upper = top - c * h, middle = upper - h / 2;
			double S = naive_selection(p, v, exp(middle));
			for (size_t s = 0; s < n && S > 0; s++) {
				double t = log(sieve[s]);
				double w = upper - t < h ? upper - t : h;
				if (w > 0)
					passing[s] +=
					    S * dF * w *
					    naive_B(B, t - upper + w / 2);
			}
		}
	}
}

/* Eq 2 on the classes of the feed's sieves, to the letter: mass [feed->n] of
 * each class of the product, the pan last. */
static inline void
naive_classes(const struct psd *feed, const struct params *p,
    enum appearance_form form, double v, double *mass)
{
	size_t n = feed->n;
	double *x = malloc(n * sizeof *x);
	for (size_t i = 0; i < n; i++) {
		x[i] = i + 1 < n ? sqrt(feed->size[i] * feed->size[i + 1])
				 : feed->size[i] / 2;
		mass[i] = 0;
	}
	for (size_t i = 0; i < n; i++) {
		double f =
		    feed->passing[i] - (i + 1 < n ? feed->passing[i + 1] : 0);
		double S = naive_selection(p, v, x[i]), sum = 0;
		double u[3] = {0, 0, 1000 * x[i]};
		for (int pass = 0; pass < 2; pass++)
			for (size_t j = i; j < n; j++) {
				u[0] = x[j] / x[i];
				u[1] = 1000 * x[j];
				double share = naive_density(p, u[form]);
				if (pass == 0)
					sum += share;
				else if (sum > 0)
					mass[j] += S * f * share / sum;
			}
		mass[i] += sum > 0 ? (1 - S) * f : f;
	}
	free(x);
}

#endif
