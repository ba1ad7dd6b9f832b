/* The method `classes`; used through product.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_CLASSES_H
#define TIPSPEED_CORE_MODEL_CLASSES_H

#include <stdbool.h>

#include "core/model/breakage.h"
#include "core/psd/psd.h"

struct classes_solver;

/* See model_new.  b is borrowed; the functions below use the parameters and
 * speed that it has when they are called. */
struct classes_solver *classes_solver_new(const struct breaker *b,
    const struct psd *feed, const double *sieve, size_t n,
    enum appearance_form form);
void classes_solver_free(struct classes_solver *c);

/* See model_compute_product, model_is_feed_broken and model_broken_feed_share,
 * without the bypass. */
void classes_solver_compute_product(struct classes_solver *c, double *passing);
bool classes_solver_is_feed_broken(struct classes_solver *c);
double classes_solver_broken_feed_share(struct classes_solver *c);

/* Computes the sizes x, m, of the n feed classes, coarsest first, the pan last
 * (D5). */
void classes_compute_sizes(const struct psd *feed, double *x);

/* Computes the appearance matrix of Table 1 for size classes. a_ij: the share
 * of class i that breaks into class j, at or below i; the shares of a parent i
 * add up to 1. b must be set to a speed.  x [n]: class sizes, m, coarsest
 * first.  a [n * n] receives a_ij at a[j * n + i], and 0 above the diagonal.  A
 * parent without progeny keeps its mass: a_ii = 1.
 * Cannot fail.   Source: paper Eq 1 and Table 1, departures D3 and D4. */
void classes_appearance_matrix(const struct breaker *b,
    enum appearance_form form, const double *x, size_t n, double *a);

#endif
