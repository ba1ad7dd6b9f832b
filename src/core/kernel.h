/* The batch kernel: the misfit of many candidates at once.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_KERNEL_H
#define TIPSPEED_CORE_KERNEL_H

#include <stddef.h>

#include "base/pool.h"
#include "core/isa.h"
#include "core/misfit.h"

/* A search evaluates millions of candidates, so this computes the misfit of
 * misfit.h on a coarser scheme, lanes being candidates:
 * - the feed is cut into classes of a quarter octave or less that end at every
 *   sieve; S is integrated on each from max(x*, lower edge) by three Gauss
 *   points, as mass and as first moment about the middle;
 * - B(s/x) is summed by the trapezoidal rule on the classes' middles from p,
 *   whose clipping is a max() at fixed points; a class adds mass times B at its
 *   middle, less moment times p.
 * Within 0.05 points of model_product at Table 3 (tested); the answer of a
 * search is polished and reported on model_product.  `classes` is exact.
 *
 * Nothing is printed, nor allocated after the first batch of a size. A
 * candidate's misfit depends on that candidate alone, bit for bit: not on its
 * neighbours, the number of threads or the instruction set (no fused
 * multiply-add, own exp). */
struct kernel;

/* The misfit is read here and not kept.  pool: threads to share the work, must
 * outlive the kernel; NULL: the caller's alone. */
struct kernel *kernel_new(
    const struct misfit *m, enum isa isa, struct pool *pool);
void kernel_free(struct kernel *kernel);

/* misfit [n] out, for candidates theta[PARAM_COUNT][n], one array a parameter
 * in the order of PARAMS, aligned to 64 bytes and readable up to the next
 * multiple of KERNEL_LANES. Not a number becomes INFINITY. Threads share the
 * blocks. */
enum { KERNEL_LANES = 8 };
void kernel_evaluate(struct kernel *kernel,
    const double *const theta[PARAM_COUNT], size_t n, double *misfit);

#endif
