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
 * Between sieves passing is straight on log size; above the coarsest sieve it
 * is passing[0].  Below the finest sieve nothing is known, unless passing is 0
 * there. */
struct psd {
	size_t n;
	double *size;
	double *passing;
};

/* psd_new: returns n sieves, all zero.  psd_free frees the arrays, not the
 * struct. */
struct psd psd_new(size_t n);
struct psd psd_copy(const struct psd *psd);
void psd_free(struct psd *psd);

/* Returns the passing at size x (m), straight on log size; the end values
 * outside the sieves.  Asserts n >= 1 and x > 0. */
double psd_passing(const struct psd *psd, double x);

/* Returns the curve with further points at about every half octave between
 * sieves that lie wider apart, on Steffen's monotone cubic in log size: curves
 * of plants have no corners (D18). */
struct psd psd_curve(const struct psd *psd);

/* Sizes [n], m, coarsest first, and further ones between neighbours more than a
 * tenth apart (below a tenth of the coarsest, a seventh), close enough for
 * break sizes and corners of a product; passings 0.  psd_free. */
struct psd psd_refined(const double *size, size_t n);

/* True if both are the same to the last bit and not empty. */
bool psd_same(const struct psd *a, const struct psd *b);

/* Returns the passing measured at x; NAN where x is not a sieve. */
double psd_at_sieve(const struct psd *psd, double x);

/* Returns the size (m) that the given fraction passes, straight on log size:
 * P80 is psd_size(psd, 0.8).  NAN where the size lies outside the sieves. */
double psd_size(const struct psd *psd, double passing);

/* The sizes that summarise a product, P20, P50 and P80: as passings, by name
 * and as keys and options, "p80". */
enum { PSD_SIZES = 3 };
extern const double PSD_PASSING[PSD_SIZES];
extern const char *const PSD_NAME[PSD_SIZES], *const PSD_KEY[PSD_SIZES];

/* Returns the sieve above the widest gap: the next sieve is finer by a factor
 * of more than 2.5, and more than 5 points of passing lie between them.  n
 * where there is no such gap. */
size_t psd_gap(const struct psd *psd);

/* True if the passing at x is known: x is within the sieves or above them, or
 * below a finest sieve that passes nothing. */
bool psd_covers(const struct psd *psd, double x);

/* Sorts sizes, or their logarithms, coarsest first, and drops every size that
 * lies no more than `apart` below another.  Returns how many are left. */
size_t psd_sort(double *x, size_t n, double apart);

/* Returns the root mean square difference of passing, 0..1, between two curves
 * at n sizes; worst: index of the largest difference, out, may be NULL. */
double psd_rms(const double *a, const double *b, size_t n, size_t *worst);

/* Returns the passing at sieve i less the passing of the straight line, on log
 * size, between its two neighbours: -1..1; NAN at the two ends, which have one
 * neighbour. */
double psd_bend(const struct psd *psd, size_t i);

/* The most unusual point of n curves: its curve bends there unlike the other
 * curves at the same three sieves.  A true curve may bend by 10 points and more
 * (at its top size, at the break size), but curves of one crusher do so
 * together, and a typing error occurs in one curve alone.  off: its bend less
 * the mean bend of the others, passing -1..1; 0 where no point can be checked.
 * others: their number; where it is 0, off is the bend itself.  Of two curves
 * that differ, the curve with the larger bend is returned. */
struct psd_outlier {
	size_t curve, sieve, others;
	double off;
};

struct psd_outlier psd_outlier(const struct psd *const *curve, size_t n);

#endif
