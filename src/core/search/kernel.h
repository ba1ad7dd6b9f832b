/* The batch kernel: the misfit of many candidates at once.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_KERNEL_H
#define TIPSPEED_CORE_SEARCH_KERNEL_H

#include <stddef.h>

#include "core/numeric/isa.h"
#include "core/search/misfit.h"
#include "core/search/batch_plan.h"

/* A search evaluates millions of candidates, so that this computes the misfit
 * of misfit.h by a coarser scheme, with candidates as lanes:
 * - the feed is cut into classes of a quarter octave or less that end at every
 *   sieve; S is integrated on each from max(x*, lower edge) by two or three
 *   Gauss points, as mass and as first moment about the middle; where S is 1
 *   throughout, both are known beforehand;
 * - p = dB / d ln u and B are tabled at fixed nodes of u, once or for each
 *   speed as the model needs, and read at the middle of each class as seen from
 *   each sieve; a class adds mass times B there, less moment times p.
 * Within 0.05 points of model_product at Table 3 (tested); the answer of a
 * search is polished and reported on model_product.  `classes` is exact where
 * the model gives a density.
 *
 * Nothing is printed, nor allocated by an evaluation. A candidate's misfit
 * depends on that candidate alone, bit for bit: not on its neighbours, the
 * number of threads or the instruction set (no fused multiply-add, own exp). */
struct kernel;

/* m is read here and not kept.  threads: how many threads will evaluate at
 * once. */
struct kernel *kernel_new(
    const struct misfit *m, enum isa isa, unsigned threads);
void kernel_free(struct kernel *kernel);

/* The misfits out->misfit [to] in from..to-1, for those candidates of theta,
 * one array [to] a parameter of the misfit's model in the order of its table,
 * aligned to 64 bytes and readable up to the next multiple of KERNEL_LANES.
 * from is a multiple of KERNEL_LANES, and to - from at most KERNEL_PART.  Not a
 * number becomes INFINITY.  thread: below that of kernel_new; two at once have
 * different ones. */
enum { KERNEL_PART = 63 * KERNEL_LANES };
void kernel_evaluate_part(const struct kernel *kernel,
    const double *const *theta, size_t from, size_t to, unsigned thread,
    const struct kernel_out *out);

/* Sets another speed, m/s, for a misfit of one run. */
void kernel_set_speed(struct kernel *kernel, double v);

#endif
