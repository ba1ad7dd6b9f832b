/* Reads passings, sizes, shares, fineness moduli and coefficients off a curve,
 * and computes their distances from limits as passings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/quantity.h"

#include <math.h>
#include <string.h>

const struct modulus MODULUS[MODULI] = {
    {"EN", "EN 12620", 6, {4, 2, 1, 0.5, 0.25, 0.125}, 0},
    {"ASTM", "ASTM C136", 9, {37.5, 19, 9.5, 4.75, 2.36, 1.18, 0.6, 0.3, 0.15},
	0},
    {"IS", "IS 2386-1", 10, {80, 40, 20, 10, 4.75, 2.36, 1.18, 0.6, 0.3, 0.15},
	0},
    {"DIN", "DIN 1045-2, k-value", 9, {63, 31.5, 16, 8, 4, 2, 1, 0.5, 0.25}, 0},
    {"GB", "GB/T 14684", 6, {4.75, 2.36, 1.18, 0.6, 0.3, 0.15}, 1},
};

static double
fineness_modulus_of_curve(const struct modulus *m, const struct psd *curve)
{
	double sum = 0, coarse = 0;
	if (!psd_covers_size(curve, m->mm[m->n - 1] / 1000))
		return NAN;
	for (size_t i = 0; i < m->n; i++) {
		double retained = 1 - psd_passing(curve, m->mm[i] / 1000);
		sum += retained;
		if (i == 0)
			coarse = retained;
	}
	if (!m->sand)
		return sum;
	return (sum - (double)m->n * coarse) / (1 - coarse);
}

static double
largest_step_of_curve(const struct quantity *q, const struct psd *curve)
{
	double most = 0;
	if (q->n_sieve == 0 ||
	    !psd_covers_size(curve, q->sieve[q->n_sieve - 1]))
		return NAN;
	for (size_t i = 1; i < q->n_sieve; i++)
		most = fmax(most, psd_passing(curve, q->sieve[i - 1]) -
				      psd_passing(curve, q->sieve[i]));
	return most;
}

int
quantity_sign_if_finer(const struct quantity *q)
{
	const struct fraction *f = &q->fraction;
	bool whole = !fraction_is_screened(f);
	switch (q->kind) {
	case QUANTITY_SHARE:
		return f->coarse > 0 && !(f->fine > 0);
	case QUANTITY_PASSING:
		return whole ? 1 : 0;
	case QUANTITY_SIZE:
		return whole ? -1 : 0;
	case QUANTITY_MODULUS:
	case QUANTITY_UNIFORMITY:
	case QUANTITY_CURVATURE:
	case QUANTITY_STEP:
		break;
	}
	return 0;
}

bool
quantity_is_same(const struct quantity *a, const struct quantity *b)
{
	return a->kind == b->kind && a->x == b->x && a->modulus == b->modulus &&
	       a->sieve == b->sieve &&
	       memcmp(&a->fraction, &b->fraction, sizeof a->fraction) == 0;
}

double
quantity_read_off_curve(
    const struct quantity *q, const struct psd *curve, double share)
{
	switch (q->kind) {
	case QUANTITY_SHARE:
		return share;
	case QUANTITY_PASSING:
		return psd_covers_size(curve, q->x) ? psd_passing(curve, q->x)
						    : NAN;
	case QUANTITY_SIZE:
		return psd_size_at_passing(curve, q->x);
	case QUANTITY_MODULUS:
		return fineness_modulus_of_curve(q->modulus, curve);
	case QUANTITY_UNIFORMITY:
		return psd_size_at_passing(curve, 0.6) /
		       psd_size_at_passing(curve, 0.1);
	case QUANTITY_CURVATURE:
		return psd_size_at_passing(curve, 0.3) *
		       psd_size_at_passing(curve, 0.3) /
		       (psd_size_at_passing(curve, 0.6) *
			   psd_size_at_passing(curve, 0.1));
	case QUANTITY_STEP:
		return largest_step_of_curve(q, curve);
	}
	return NAN;
}

/* Returns how much less than `share` passes the size; negative if more does, or
 * NAN if the passing there is not known. */
static double
passing_shortfall_at_size(const struct psd *curve, double share, double size)
{
	bool known = size > 0 && psd_covers_size(curve, size);
	return known ? share - psd_passing(curve, size) : NAN;
}

double
quantity_excess_as_passing(const struct quantity *q, double limit, double value,
    const struct psd *curve)
{
	switch (q->kind) {
	case QUANTITY_PASSING:
	case QUANTITY_SHARE:
	case QUANTITY_STEP:
		return value - limit;
	case QUANTITY_MODULUS:
		return (value - limit) / (double)q->modulus->n;
	case QUANTITY_SIZE:
		return passing_shortfall_at_size(curve, q->x, limit);
	case QUANTITY_UNIFORMITY:
		return passing_shortfall_at_size(
		    curve, 0.6, limit * psd_size_at_passing(curve, 0.1));
	case QUANTITY_CURVATURE:
		return passing_shortfall_at_size(curve, 0.3,
		    sqrt(limit * psd_size_at_passing(curve, 0.6) *
			 psd_size_at_passing(curve, 0.1)));
	}
	return NAN;
}

bool
quantity_excess_needs_whole_curve(const struct quantity *q)
{
	switch (q->kind) {
	case QUANTITY_PASSING:
	case QUANTITY_SHARE:
	case QUANTITY_STEP:
	case QUANTITY_MODULUS:
		return false;
	case QUANTITY_SIZE:
	case QUANTITY_UNIFORMITY:
	case QUANTITY_CURVATURE:
		break;
	}
	return true;
}

size_t
quantity_sizes_needed(
    const struct quantity *q, double size[static QUANTITY_POINTS])
{
	size_t n = 0;
	switch (q->kind) {
	case QUANTITY_PASSING:
		size[n++] = q->x;
		break;
	case QUANTITY_MODULUS:
		for (; n < q->modulus->n; n++)
			size[n] = q->modulus->mm[n] / 1000;
		break;
	case QUANTITY_STEP:
		for (; n < q->n_sieve && n < STEP_SIEVES; n++)
			size[n] = q->sieve[n];
		break;
	case QUANTITY_SIZE:
	case QUANTITY_SHARE:
	case QUANTITY_UNIFORMITY:
	case QUANTITY_CURVATURE:
		break;
	}
	if (q->fraction.fine > 0)
		size[n++] = q->fraction.fine;
	if (q->fraction.coarse > 0)
		size[n++] = q->fraction.coarse;
	return n;
}
