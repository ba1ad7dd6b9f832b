/* Covariances and priors of the discrepancy and of the errors of samples (D13,
 * Kennedy and O'Hagan 2001), and the Cholesky factor of the sum of the
 * covariances.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/discrepancy.h"

#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"

/* These priors were found by counting, with bench/coverage: how often the bands
 * hold, and how far answers err, both for plants that follow the model and for
 * others. */
const struct hyper_info HYPER[HYPERS] = {
    {"discrepancy", "sigma_d", 0.004, 1.2, N_("what the model leaves out")},
    {"length", "l", 1, 0.4,
	N_("in ln of size: errors at closer sizes are alike")},
    {"slope", "c", 0.4, 0.5, N_("how it changes with the speed")},
    {"narrow", "sigma_n", 0.0015, 1.2, N_("features of single sieves")},
    {"shared", "sigma_s", 0.004, 0.7,
	N_("sampling error shared along a curve")},
    {"independent", "sigma_i", 0.0035, 0.3, N_("error of a single passing")},
};

/* One unit of t, as a step in ln of the energy. */
static const double STEP = 0.135;

double
discrepancy_speed_to_coordinate(double v, double middle)
{
	return (2 * el_log(v) - el_log(2) - middle) / STEP;
}

void
discrepancy_speed_terms(
    double t, double slope, double term[static DISCREPANCY_TERMS])
{
	term[0] = 1;
	term[1] = slope * t;
	term[2] = slope * (t * t - 1) * 0.3;
}

/* Returns -ln of a t distribution with four degrees of freedom, up to a
 * constant.  Its long tail lets sigma_i rise above its median as far as the
 * data require. */
static double
minus_log_t4(double z)
{
	return 2.5 * el_log(1 + z * z / 4);
}

double
discrepancy_minus_log_prior(const double log_hyper[static HYPERS], double noise)
{
	const double known = 0.05; /* spread of a stated noise */
	double sum = 0;
	for (size_t i = 0; i < HYPERS; i++) {
		bool given = i == HYPER_OWN && noise > 0;
		double median = given ? noise : HYPER[i].median;
		double z = (log_hyper[i] - el_log(median)) /
			   (given ? known : HYPER[i].spread);
		sum += i == HYPER_OWN && !given && z > 0 ? minus_log_t4(z)
							 : z * z / 2;
	}
	return sum;
}

static const struct triangle *
triangle_functions_for_isa(enum isa isa)
{
	static const struct triangle *const TRIANGLES[] = {
	    &TRIANGLE_BASE, &TRIANGLE_AVX2, &TRIANGLE_AVX512};
	return TRIANGLES[isa_usable_or_best(isa)];
}

void
discrepancy_covariances_of_pairs(enum isa isa, size_t n,
    const double hyper[static HYPERS], double *f, double *error)
{
	triangle_functions_for_isa(isa)->pairs(n, hyper, f, error);
}

void
discrepancy_random_normals(
    enum isa isa, struct rng_key key, uint32_t next, size_t n, double *z)
{
	triangle_functions_for_isa(isa)->normals(key, next, n, z);
}

void
discrepancy_factor_pair_covariances(
    enum isa isa, const double *pair, size_t n, double *U)
{
	for (size_t i = 0; i < n; i++) {
		for (size_t j = 0; j <= i; j++)
			U[j * n + i] = pair[discrepancy_index_of_pair(i, j)];
		U[i * n + i] += 1e-8 * pair[0];
	}
	discrepancy_cholesky(isa, U, n);
}

void
discrepancy_cholesky(enum isa isa, double *U, size_t n)
{
	triangle_functions_for_isa(isa)->cholesky(U, n);
}

void
discrepancy_solve_lower(enum isa isa, const double *U, size_t n, double *d)
{
	triangle_functions_for_isa(isa)->forward(U, n, d);
}

void
discrepancy_solve_upper(const double *U, size_t n, double *z)
{
	for (size_t i = n; i-- > 0;) {
		for (size_t k = i + 1; k < n; k++)
			z[i] -= U[i * n + k] * z[k];
		z[i] /= U[i * n + i];
	}
}

/* Gives each cell the index of its size, the same for equal sizes.  Returns the
 * number of different sizes. */
static size_t
discrepancy_enumerate_sizes(const struct cell *cell, size_t n, int64_t *size)
{
	size_t sizes = 0;
	for (size_t i = 0; i < n; i++) {
		size_t j = 0;
		while (cell[j].log_size != cell[i].log_size)
			j++;
		size[i] = j < i ? size[j] : (int64_t)sizes++;
	}
	return sizes;
}

void
discrepancy_fill_covariance(enum isa isa, const struct cell *cell, size_t n,
    const double log_hyper[static HYPERS], double *U)
{
	double hyper[HYPERS], term[DISCREPANCY_TERMS];
	for (size_t i = 0; i < HYPERS; i++)
		hyper[i] = el_exp(log_hyper[i]);
	int64_t *number = xcalloc(2 * n, sizeof *number);
	size_t pairs = n * (n + 1) / 2; /* of sizes, at most */
	double *column =
	    xcalloc_doubles((4 + DISCREPANCY_TERMS) * n + 2 * pairs);
	struct cell_columns c = {.n = n,
	    .own = hyper[HYPER_OWN] * hyper[HYPER_OWN],
	    .size = number,
	    .run = number + n,
	    .h = column,
	    .log_size = column + n,
	    .f = column + 2 * n,
	    .error = column + 3 * n};
	for (size_t k = 0; k < DISCREPANCY_TERMS; k++)
		c.term[k] = column + (4 + k) * n;
	c.pair[0] = column + (4 + DISCREPANCY_TERMS) * n;
	c.pair[1] = c.pair[0] + pairs;
	c.sizes = discrepancy_enumerate_sizes(cell, n, c.size);
	for (size_t i = 0; i < n; i++) {
		c.run[i] = (int64_t)cell[i].run;
		c.h[i] = cell[i].h;
		c.log_size[c.size[i]] = cell[i].log_size;
		discrepancy_speed_terms(cell[i].t, hyper[HYPER_SLOPE], term);
		for (size_t k = 0; k < DISCREPANCY_TERMS; k++)
			c.term[k][i] = term[k];
	}
	triangle_functions_for_isa(isa)->covariance(&c, hyper, U);
	free(column);
	free(number);
}

void
discrepancy_factor_covariance(enum isa isa, const struct cell *cell, size_t n,
    const double log_hyper[static HYPERS], double *U)
{
	discrepancy_fill_covariance(isa, cell, n, log_hyper, U);
	discrepancy_cholesky(isa, U, n);
}

double
discrepancy_minus_log_density(
    enum isa isa, const double *U, size_t n, double *d)
{
	/* Logarithms are taken of products of this many numbers.  No product is
	 * below 0.0005^16; see DISCREPANCY_ROUNDING. */
	enum { AT_ONCE = 16 };
	double level = 0;
	discrepancy_solve_lower(isa, U, n, d);
	for (size_t i = 0; i < n; i++)
		level += d[i] * d[i] / 2;
	for (size_t from = 0; from < n; from += AT_ONCE) {
		double product = 1;
		for (size_t i = from; i < n && i < from + AT_ONCE; i++)
			product *= U[i * n + i];
		level += el_log(product);
	}
	return level;
}
