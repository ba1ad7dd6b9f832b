/* D13.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/discrepancy.h"

#include <math.h>
#include <stdbool.h>

#include "core/elementary.h"

/* Found by counting, with bench/coverage: what bands hold and how far answers
 * err where plants follow the model and where they do not. */
const struct hyper_info HYPER[HYPERS] = {
    {"discrepancy", "sigma_d", 0.004, 1.2, "what the model leaves out"},
    {"length", "l", 1, 0.4, "ln of sizes over which it is alike"},
    {"slope", "c", 0.5, 0.5, "how it changes with the speed"},
    {"narrow", "sigma_n", 0.0015, 1.2, "features of single sieves"},
    {"shared", "sigma_s", 0.003, 0.7, "sampling error shared along a curve"},
    {"independent", "sigma_i", 0.0035, 0.3, "error of a single passing"},
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
discrepancy_h(double P)
{
	return 2 * sqrt(fmax(P * (1 - P), 0));
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

static double
rho(double apart, double length)
{
	double z = apart / length;
	return z * z > 80 ? 0 : el_exp(-z * z / 2);
}

double
discrepancy_covariance(double apart, const double hyper[static HYPERS])
{
	double wide = hyper[HYPER_DELTA], narrow = hyper[HYPER_NARROW];
	return wide * wide * rho(apart, hyper[HYPER_LENGTH]) +
	       narrow * narrow * rho(apart, NARROW);
}

double
discrepancy_shared(double apart, const double hyper[static HYPERS])
{
	double shared = hyper[HYPER_SHARED];
	return shared * shared * rho(apart, hyper[HYPER_LENGTH]);
}

void
discrepancy_cholesky(double *L, size_t n)
{
	for (size_t j = 0; j < n; j++)
		for (size_t i = j; i < n; i++) {
			double sum = L[i * n + j];
			for (size_t k = 0; k < j; k++)
				sum -= L[i * n + k] * L[j * n + k];
			L[i * n + j] = i == j ? sqrt(sum) : sum / L[j * n + j];
		}
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

/* Sum over the terms at two times. */
static double
terms_product(double t, double u, double slope)
{
	double a[DISCREPANCY_TERMS], b[DISCREPANCY_TERMS], sum = 0;
	discrepancy_terms(t, slope, a);
	discrepancy_terms(u, slope, b);
	for (size_t i = 0; i < DISCREPANCY_TERMS; i++)
		sum += a[i] * b[i];
	return sum;
}

void
discrepancy_fill(const struct cell *cell, size_t n,
    const double log_hyper[static HYPERS], double *L)
{
	double hyper[HYPERS];
	for (size_t i = 0; i < HYPERS; i++)
		hyper[i] = el_exp(log_hyper[i]);
	double own = hyper[HYPER_OWN] * hyper[HYPER_OWN];
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j <= i; j++) {
			const struct cell *a = &cell[i], *b = &cell[j];
			double apart = a->log_size - b->log_size;
			double K =
			    discrepancy_covariance(apart, hyper) *
			    terms_product(a->t, b->t, hyper[HYPER_SLOPE]);
			if (a->run == b->run)
				K += discrepancy_shared(apart, hyper);
			L[i * n + j] = a->h * b->h * (K + (i == j ? own : 0)) +
				       (i == j ? ROUNDING * ROUNDING : 0);
		}
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
