/* The batch kernel: the misfit of many candidates at once.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_KERNEL_H
#define TIPSPEED_CORE_SEARCH_KERNEL_H

#include <stddef.h>

#include "core/numeric/isa.h"
#include "core/search/misfit.h"
#include "core/search/batch_plan.h"

/* A search evaluates millions of candidates, so the kernel computes the misfit
 * of misfit.h by a coarser scheme, with candidates as lanes: - the feed is cut
 * into classes of a quarter octave or less that end at every sieve; in each, S
 * dF is integrated from max(x*, lower edge) with two or three Gauss points,
 * which give the broken mass and its first moment about the middle; where S is
 * 1 throughout, both are known in advance; - p = dB / d ln u and B are
 * tabulated at fixed nodes of u, once or for each speed, depending on the
 * model, and interpolated for each class's middle and each sieve; a class adds
 * mass times B, minus moment times p. For Table 3 the passings are within 0.05
 * points (tested) of model_compute_product, the accurate product with which
 * results are polished and reported.  `classes` is exact if the model has a
 * density.
 *
 * An evaluation allocates nothing.  A candidate's misfit depends, bit for bit,
 * on that candidate alone: not on its neighbours, the number of threads or the
 * instruction set (no fused multiply-add, own exp). */
struct kernel;

/* m is not kept.  threads: the number that will evaluate at the same time. */
struct kernel *kernel_new(
    const struct misfit *m, enum isa isa, unsigned threads);
void kernel_free(struct kernel *kernel);

/* Computes out->misfit [to] for the candidates from..to-1.  theta has an array
 * [to] for each parameter of the misfit's model, in the order of its table,
 * aligned to 64 bytes and readable up to the next multiple of KERNEL_LANES.
 * from is a multiple of KERNEL_LANES, and to - from at most KERNEL_PART.  A
 * misfit that is NaN becomes INFINITY.  thread: less than kernel_new's threads,
 * and unique among concurrent calls. */
enum { KERNEL_PART = 63 * KERNEL_LANES };
void kernel_evaluate_candidates(const struct kernel *kernel,
    const double *const *theta, size_t from, size_t to, unsigned thread,
    const struct kernel_out *out);

/* Sets another speed, m/s.  The misfit must have one run. */
void kernel_set_speed(struct kernel *kernel, double v);

#endif
