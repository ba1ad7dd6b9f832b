/* Appearance (Eq 1): the sizes into which a particle breaks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_APPEARANCE_H
#define TIPSPEED_CORE_MODEL_APPEARANCE_H

#include <stddef.h>

#include "core/model/params.h"

/* Progeny finer than 2^-10 of the parent do not occur. */
#define APPEARANCE_FINEST (1.0 / 1024)

enum { APPEARANCE_PIECES = 4 };

/* The progeny distribution in the form `ratio`, u = progeny / parent:
 *   p(u) = max(0, beta1 + beta2 u + beta3 u^2 + beta4 u^3), u in [2^-10, 1]
 *   B(u) = integral of p d ln u up to u, over the integral up to 1
 * D3: read literally, Eq 1 gives all progeny the same share; u is the ratio.
 * D4: p is clipped at 0 and normalised, to conserve mass.
 *
 * p is positive on n pieces lower[i]..upper[i], finest first.  total is the
 * integral over all pieces; if it is 0, p is 0 everywhere and a particle that
 * breaks keeps its size. */
struct appearance {
	double beta[4];
	size_t n;
	double lower[APPEARANCE_PIECES], upper[APPEARANCE_PIECES];
	double total;
	double log_lower[APPEARANCE_PIECES], log_upper[APPEARANCE_PIECES];
	/* For appearance_power_integrals_up_to: the integrals at the upper end
	 * of each piece, and those at the lower end minus the antiderivative
	 * there. */
	double full[APPEARANCE_PIECES][4], base[APPEARANCE_PIECES][4];
	double whole[4]; /* at u = 1 */
};

/* Cannot fail. */
struct appearance appearance_from_beta(const double beta[static 4]);

/* Returns p(u), not normalised, clipped at 0.  Source: paper Eq 1. */
double appearance_density(const double beta[static 4], double u);

/* Returns the argument of p for parent and progeny of the given sizes, m: their
 * ratio, or one of the sizes in mm (D3). */
double appearance_argument(
    enum appearance_form form, double parent, double daughter);

/* Returns the integral of u^power d ln u, up to a constant. */
static inline double
appearance_power_integral(size_t power, double log_u, double u)
{
	double up = 1;
	for (size_t i = 0; i < power; i++)
		up *= u;
	return power == 0 ? log_u : up / (double)power;
}

/* Computes the integral of u^(m - 1) over the pieces of p up to u: parts [4]
 * for m = 0 to 3, with ln u for m = 0.  B(u) is their sum weighted by beta,
 * divided by the same sum at u = 1. */
void appearance_power_integrals_up_to(
    const struct appearance *a, double log_u, double parts[static 4]);

#endif
