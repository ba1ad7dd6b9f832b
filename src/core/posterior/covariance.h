/* The covariance of the differences between measured passings and the model
 * (D13), factored, for few passings and for many.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_COVARIANCE_H
#define TIPSPEED_CORE_POSTERIOR_COVARIANCE_H

#include <stddef.h>

#include "core/posterior/discrepancy.h"

/* Up to COVARIANCE_FEW cells are factored as one matrix.  More are factored by
 * blocks, because the runs share only the processes f of the discrepancy, which
 * have few values at the sizes of the cells, however many runs there are.  Let
 * B be the factors of these values in the cells, K their covariance, and E the
 * covariance of the samples' errors, with a block for each run.  Then
 *   C = B K B' + E,   K = L L',   A = 1 + L' B' E^-1 B L
 *   C^-1 = E^-1 - E^-1 B L A^-1 L' B' E^-1,   |C| = |E| |A|
 * (Rasmussen and Williams 2006, A.9).  This is exact, and takes time and space
 * proportional to the number of runs.  With more than COVARIANCE_SIZES sizes,
 * the discrepancy and the shared errors, but not the model, are evaluated at
 * the nearest of COVARIANCE_SIZES evenly spaced sizes. */
enum { COVARIANCE_FEW = 96, COVARIANCE_SIZES = COVARIANCE_FEW / 3 };

struct covariance;

/* cell [n] is not kept; the cells of a run must be adjacent.  If there are many
 * sizes, they are moved as described above.  Free with covariance_free. */
struct covariance *covariance_new(enum isa isa, struct cell *cell, size_t n);
void covariance_free(struct covariance *covariance);

/* Returns the number of doubles in a factor. */
size_t covariance_factor_size(const struct covariance *covariance);

/* Computes factor [covariance_factor_size]. */
void covariance_compute_factor(const struct covariance *covariance,
    const double log_hyper[static HYPERS], double *factor);

/* Returns -ln of the probability of the differences d [n], up to a constant; d
 * is overwritten. */
double covariance_minus_log_density(
    const struct covariance *covariance, const double *factor, double *d);

/* Computes C^-1 d in place. */
void covariance_solve(
    const struct covariance *covariance, const double *factor, double *d);

#endif
