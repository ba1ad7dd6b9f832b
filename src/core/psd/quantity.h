/* Quantities of a product: single numbers read off its curve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_QUANTITY_H
#define TIPSPEED_CORE_PSD_QUANTITY_H

#include <stddef.h>

#include "core/psd/psd.h"
#include "core/psd/screening.h"

/* A fineness modulus: the sum of the shares retained on the sieves of a
 * standard, a measure of the coarseness of a sand.  size [n] mm, coarsest
 * first.  sand: only material that passes the coarsest sieve counts,
 *   (A2 + .. + A6 - 5 A1) / (1 - A1)
 * where A are the cumulative shares retained, as in GB/T 14684. */
enum { MODULUS_SIEVES = 10, MODULI = 5 };
struct modulus {
	const char *name, *standard;
	size_t n;
	double mm[MODULUS_SIEVES];
	int sand;
};
extern const struct modulus MODULUS[MODULI];

/* In the order in which they are offered.  A new kind has cases in quantity.c
 * and a row of KINDS in cmd/ask/quantity_words.c; the compiler and
 * tests/unit/test_conditions.c report what is missing. */
enum quantity_kind {
	QUANTITY_SIZE,       /* the size, m, that share x passes: P80, D80 */
	QUANTITY_PASSING,    /* passing at size x, m; 0..1 */
	QUANTITY_SHARE,      /* share of the product in the fraction; 0..1 */
	QUANTITY_MODULUS,    /* fineness modulus */
	QUANTITY_UNIFORMITY, /* D60 / D10 */
	QUANTITY_CURVATURE,  /* D30^2 / (D60 D10) */
	QUANTITY_STEP /* the largest share between two neighbours of `sieve` */
};

/* A quantity of the product, or of a screened fraction of it (screening.h). */
struct quantity {
	enum quantity_kind kind;
	double x;
	const struct modulus *modulus;
	size_t n_sieve;
	const double *sieve; /* [n_sieve] m, coarsest first; not owned */
	struct fraction fraction;
	/* How the user typed it.  A size: 'D', or 0 for P; a passing: 'f' if as
	 * fines. */
	char letter;
};

/* Returns 1 if the quantity can only rise as the product gets finer, as a
 * passing and the share of 0/4 do; -1 if it can only fall, as a size does; 0 if
 * it may do either. */
int quantity_sign_if_finer(const struct quantity *q);

bool quantity_is_same(const struct quantity *a, const struct quantity *b);

/* Returns the value read off the curve of the fraction, or NAN if the curve
 * does not reach that far.  share: the fraction's share of the product. */
double quantity_read_off_curve(
    const struct quantity *q, const struct psd *curve, double share);

/* Returns how far a value read off the fraction's curve is above a limit, as a
 * passing 0..1, so that all limits can be compared.  For a passing, share or
 * step it is the difference; for D and P, the shortfall in passing at the size
 * of the limit; for Cu and Cc, the shortfall at the size that the limit and the
 * other sizes imply; for a modulus, the difference divided by its number of
 * sieves.  Positive exactly where the value is above the limit; NAN where the
 * curve does not reach that far. */
double quantity_excess_as_passing(const struct quantity *q, double limit,
    double value, const struct psd *curve);

/* True if quantity_excess_as_passing reads the curve; if not, it may be NULL.
 */
bool quantity_excess_needs_whole_curve(const struct quantity *q);

/* Lists in [QUANTITY_POINTS] the sizes, m, at which the curve needs points for
 * the value to be exact; of a step's sieves, only the first STEP_SIEVES.
 * Returns their number. */
enum { STEP_SIEVES = 20, QUANTITY_POINTS = STEP_SIEVES + 2 };
size_t quantity_sizes_needed(
    const struct quantity *q, double size[static QUANTITY_POINTS]);

#endif
