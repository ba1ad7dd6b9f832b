/* The discrepancy between a model and the truth, as a Gaussian process, and the
 * errors of a sample.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_DISCREPANCY_H
#define TIPSPEED_CORE_POSTERIOR_DISCREPANCY_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include "core/numeric/elementary.h"
#include "core/numeric/isa.h"
#include "core/numeric/rng.h"

/* D13 (Kennedy and O'Hagan 2001):
 *   measured = model + discrepancy + error of the sample
 * The discrepancy depends on the size s and on t, which measures the speed: it
 * is 0 in the middle of the measured speeds and 1 at e^0.135 times the energy
 * there (at 79 m/s if the middle is 74).  The discrepancy is
 *   h(P) (f_0(s) + c t f_1(s) + 0.3 c (t^2 - 1) f_2(s)),  h = 2 sqrt(P (1 - P))
 * where P is midway between the model's passing and the measured passing or the
 * answer's; the f are independent Gaussian processes with the covariance
 *   sigma_d^2 rho(ln s - ln s', l) + sigma_n^2 rho(ln s - ln s', 1/4)
 *   rho(z, l) = exp(-z^2 / 2 l^2)
 * where the second term is for features of single sieves.  The error of a
 * sample has a part shared along its curve, sigma_s^2 rho(.., l) within a run,
 * and an independent part, sigma_i^2, both times h h'. */
enum hyper {
	HYPER_DELTA,
	HYPER_LENGTH,
	HYPER_SLOPE,
	HYPER_NARROW,
	HYPER_SHARED,
	HYPER_OWN,
	HYPERS
};

/* A hyperparameter and its prior: its logarithm is normal, with mean ln median
 * and standard deviation spread.  Sizes are passings, 0..1. */
struct hyper_info {
	const char *name, *symbol;
	double median, spread;
	const char *meaning;
};
extern const struct hyper_info HYPER[HYPERS];

/* Returns t for a tip speed, m/s; middle: ln of the mean energy, J/kg. */
double discrepancy_speed_to_coordinate(double v, double middle);

/* Sets term to the factors of f_0, f_1 and f_2 at t. */
enum { DISCREPANCY_TERMS = 3 };
void discrepancy_speed_terms(
    double t, double slope, double term[static DISCREPANCY_TERMS]);

/* Returns h at a passing P, 0..1.  This function and the next two are called
 * for all draws at all sizes; being inline, they can be vectorised. */
static inline double
discrepancy_scale_at_passing(double P)
{
	double square = P * (1 - P);
	return 2 * sqrt(square > 0 ? square : 0);
}

/* Returns P limited to at least `least` and at most 1. */
static inline double
discrepancy_clamp_passing(double P, double least)
{
	P = P > least ? P : least;
	return P < 1 ? P : 1;
}

/* Returns a model's passing P corrected by delta, the discrepancy over h: the A
 * that solves
 *   A = P + h(m) delta,  m = (P + A) / 2
 * which also corrects model passings of 0 and 1.  The result is at least
 * `least`, the passing of the feed or of the next finer size, and at most 1. */
static inline double
discrepancy_corrected_passing(double P, double delta, double least)
{
	double h = discrepancy_scale_at_passing(P), square = delta * delta;
	double more = square * (1 - 2 * P) + delta * sqrt(square + h * h);
	return discrepancy_clamp_passing(P + more / (1 + square), least);
}

/* Returns -ln of the prior density of the hyperparameters' logarithms, up to a
 * constant.  noise: known sigma_i, or 0. */
double discrepancy_minus_log_prior(
    const double log_hyper[static HYPERS], double noise);

/* Returns rho(z, l), see above. */
static inline double
discrepancy_correlation(double apart, double length)
{
	double z = apart / length;
	return z * z > 80 ? 0 : el_exp(-z * z / 2);
}

/* DISCREPANCY_NARROW: the length of the narrow part.  DISCREPANCY_ROUNDING: the
 * rounding error of a passing.  discrepancy_covariance returns the covariance
 * of an f, and discrepancy_shared_covariance that of a sample's shared error,
 * between sizes whose logarithms differ by `apart`. */
#define DISCREPANCY_NARROW 0.25
#define DISCREPANCY_ROUNDING 0.0005

static inline double
discrepancy_covariance(double apart, const double hyper[static HYPERS])
{
	double wide = hyper[HYPER_DELTA], narrow = hyper[HYPER_NARROW];
	return wide * wide *
		   discrepancy_correlation(apart, hyper[HYPER_LENGTH]) +
	       narrow * narrow *
		   discrepancy_correlation(apart, DISCREPANCY_NARROW);
}

static inline double
discrepancy_shared_covariance(double apart, const double hyper[static HYPERS])
{
	double shared = hyper[HYPER_SHARED];
	return shared * shared *
	       discrepancy_correlation(apart, hyper[HYPER_LENGTH]);
}

/* discrepancy_covariances_of_pairs computes both covariances for n pairs of
 * sizes.  f [n] holds the differences of their logarithms; they are replaced
 * with the covariances of an f, and error [n] is set to the others.
 * discrepancy_index_of_pair returns the index of a pair of sizes; pairs are
 * ordered by the larger of the two sizes' indices. */
void discrepancy_covariances_of_pairs(enum isa isa, size_t n,
    const double hyper[static HYPERS], double *f, double *error);

static inline size_t
discrepancy_index_of_pair(size_t i, size_t j)
{
	size_t more = i > j ? i : j, less = i > j ? j : i;
	return more * (more + 1) / 2 + less;
}

/* Computes the Cholesky factor U [n * n] of the covariance of n sizes from the
 * covariances of pairs.  Raises the diagonal slightly, because sizes may be
 * close together. */
void discrepancy_factor_pair_covariances(
    enum isa isa, const double *pair, size_t n, double *U);

/* Sets z [n] to standard normal numbers of a stream, starting at number
 * `next`. */
void discrepancy_random_normals(
    enum isa isa, struct rng_key key, uint32_t next, size_t n, double *z);

/* A measured passing: ln of its size in m, its t and its h. */
struct cell {
	size_t run;
	double log_size, t, h;
};

/* discrepancy_cholesky replaces the upper half, U [n * n] by rows, of a
 * symmetric matrix with its Cholesky factor L' and overwrites the lower half.
 * The others solve L z = d and L' x = z in place.  The last bits of GSL's
 * routines depend on its version, and one bit changes a whole chain, so these
 * are plain loops. */
void discrepancy_cholesky(enum isa isa, double *U, size_t n);
void discrepancy_solve_lower(
    enum isa isa, const double *U, size_t n, double *d);
void discrepancy_solve_upper(const double *U, size_t n, double *z);

/* Compute U [n * n]: the upper half of the covariance of the differences
 * between n measured passings and the model, or its Cholesky factor. */
void discrepancy_fill_covariance(enum isa isa, const struct cell *cell,
    size_t n, const double log_hyper[static HYPERS], double *U);
void discrepancy_factor_covariance(enum isa isa, const struct cell *cell,
    size_t n, const double log_hyper[static HYPERS], double *U);

/* Returns -ln of the probability of the differences d [n], up to a constant; d
 * is replaced with L^-1 d. */
double discrepancy_minus_log_density(
    enum isa isa, const double *U, size_t n, double *d);

/* ---- For discrepancy.c: compiled for each instruction set ---- */

/* n cells in columns.  size, run: the index of each cell's size and run; own:
 * the variance of the independent error; term: see discrepancy_speed_terms;
 * log_size: ln of the sizes.  f, error and pair are workspace: a double for
 * each size, and for each pair of sizes. */
struct cell_columns {
	size_t n, sizes;
	int64_t *size, *run;
	double own;
	double *h, *term[DISCREPANCY_TERMS];
	double *log_size, *f, *error, *pair[2];
};

/* The functions for one instruction set.  U [n * n]: the upper half of a
 * symmetric matrix, by rows. */
struct triangle {
	void (*pairs)(size_t n, const double hyper[static HYPERS], double *f,
	    double *error);
	void (*covariance)(const struct cell_columns *c,
	    const double hyper[static HYPERS], double *U);
	void (*cholesky)(double *U, size_t n);
	void (*forward)(const double *U, size_t n, double *d);
	void (*normals)(struct rng_key key, uint32_t next, size_t n, double *z);
};
extern const struct triangle TRIANGLE_BASE, TRIANGLE_AVX2, TRIANGLE_AVX512;

#endif
