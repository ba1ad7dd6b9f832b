/* Particle size distributions: passing against sieve size.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_PSD_H
#define TIPSPEED_CORE_PSD_PSD_H

#include <stdbool.h>
#include <stddef.h>

/* A sieve analysis.
 *   size    [n] sieve openings, m, coarsest first, strictly falling, > 0
 *   passing [n] mass fraction finer than the sieve, 0..1, never rising as the
 *               sieves get finer
 * Between sieves, passing is linear in log size; above the coarsest sieve it is
 * passing[0].  Below the finest sieve nothing is known, unless passing is 0
 * there. */
struct psd {
	size_t n;
	double *size;
	double *passing;
};

/* psd_new returns n sieves, all zero.  psd_free frees the arrays, not the
 * struct. */
struct psd psd_new(size_t n);
struct psd psd_copy(const struct psd *psd);
void psd_free(struct psd *psd);

/* Returns the passing at size x (m), interpolated linearly in log size; outside
 * the sieves, the value at the nearer end.  Asserts n >= 1 and x > 0. */
double psd_passing(const struct psd *psd, double x);

/* Returns the curve with points added about every half octave between sieves
 * further apart than that, on Steffen's monotone cubic in log size: real curves
 * have no corners (D18). */
struct psd psd_add_points_on_cubic(const struct psd *psd);

/* Returns a curve at the sizes [n], m, coarsest first, with sizes added so that
 * neighbours are at most a tenth apart (a seventh among those finer than a
 * tenth of the coarsest): close enough to follow the corners of a product.  All
 * passings are 0.  Free with psd_free. */
struct psd psd_new_with_sizes_between(const double *size, size_t n);

/* True if both are identical to the last bit and not empty. */
bool psd_is_same(const struct psd *a, const struct psd *b);

/* Returns the passing measured at x, or NAN if x is not a sieve. */
double psd_passing_at_sieve(const struct psd *psd, double x);

/* Returns the size (m) that the given fraction passes, interpolated linearly in
 * log size: P80 is psd_size_at_passing(psd, 0.8).  Returns NAN if the size lies
 * outside the sieves. */
double psd_size_at_passing(const struct psd *psd, double passing);

/* The sizes that summarise a product, P20, P50 and P80: their passings, names,
 * and keys such as "p80", which are also options. */
enum { PSD_SIZES = 3 };
extern const double PSD_PASSING[PSD_SIZES];
extern const char *const PSD_NAME[PSD_SIZES], *const PSD_KEY[PSD_SIZES];

/* Returns the sieve above the widest gap: the next sieve is finer by a factor
 * of more than 2.5, and more than 5 points of passing lie between them.
 * Returns n if there is no such gap. */
size_t psd_sieve_above_widest_gap(const struct psd *psd);

/* True if the passing at x is known: x is within the sieves or above them, or
 * below a finest sieve that passes nothing. */
bool psd_covers_size(const struct psd *psd, double x);

/* Sorts sizes, or their logarithms, coarsest first, and drops every size no
 * more than `apart` below another.  Returns the number left. */
size_t psd_sort_distinct_sizes(double *x, size_t n, double apart);

/* Returns the root mean square difference of passing, 0..1, between two curves
 * at n sizes.  Sets *worst, if worst is not NULL, to the index of the largest
 * difference. */
double psd_rms_difference(
    const double *a, const double *b, size_t n, size_t *worst);

/* Returns the passing at sieve i minus that interpolated linearly in log size
 * between its two neighbours: -1..1, or NAN at the two ends. */
double psd_deviation_from_chord(const struct psd *psd, size_t i);

/* The most unusual point of n curves: where one curve bends least like the
 * others at the same three sieves.  A correct curve may bend by 10 points or
 * more (at its top size or the break size), but then all curves of the crusher
 * do; a typing error is in one curve alone.  off: the curve's bend minus the
 * mean bend of the others, passing -1..1; 0 if no point can be checked.
 * others: the number of other curves; if 0, off is the bend itself.  If just
 * two curves differ, the one with the larger bend is returned. */
struct psd_outlier {
	size_t curve, sieve, others;
	double off;
};

struct psd_outlier psd_find_outlier(const struct psd *const *curve, size_t n);

#endif
