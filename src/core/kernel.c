/* Picks the instruction set and hands blocks of candidates to it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/kernel.h"

#include <assert.h>
#include <omp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/plan.h"

struct kernel {
	struct plan plan;
	enum kernel_isa isa;
	kernel_block *block;
	unsigned threads;
	double **scratch; /* [threads] */
};

enum kernel_isa
kernel_isa_best(void)
{
#if defined __x86_64__
	if (__builtin_cpu_supports("avx512f") &&
	    __builtin_cpu_supports("avx512dq") &&
	    __builtin_cpu_supports("avx512vl") &&
	    __builtin_cpu_supports("avx512bw"))
		return KERNEL_AVX512;
	if (__builtin_cpu_supports("avx2"))
		return KERNEL_AVX2;
#endif
	return KERNEL_BASE;
}

const char *
kernel_isa_name(const struct kernel *kernel)
{
	static const char *const NAMES[] = {"baseline", "avx2", "avx512"};
	return NAMES[kernel->isa];
}

struct kernel *
kernel_new(const struct misfit *m, enum kernel_isa isa, unsigned threads)
{
	static kernel_block *const BLOCKS[] = {
	    kernel_block_base, kernel_block_avx2, kernel_block_avx512};
	assert(threads >= 1);
	struct kernel *kernel = xcalloc(1, sizeof *kernel);
	enum kernel_isa best = kernel_isa_best();
	kernel->isa = isa < best ? isa : best;
	kernel->block = BLOCKS[kernel->isa];
	plan_make(&kernel->plan, m);
	kernel->threads = threads;
	kernel->scratch = xcalloc(threads, sizeof *kernel->scratch);
	for (unsigned t = 0; t < threads; t++)
		kernel->scratch[t] = xdoubles(kernel->plan.scratch);
	return kernel;
}

void
kernel_free(struct kernel *kernel)
{
	if (kernel == NULL)
		return;
	plan_clear(&kernel->plan);
	for (unsigned t = 0; t < kernel->threads; t++)
		free(kernel->scratch[t]);
	free(kernel->scratch);
	free(kernel);
}

/* A block that would run past n writes its lanes beside the array. */
static void
evaluate_block(struct kernel *kernel, const double *const theta[PARAM_COUNT],
    size_t at, size_t n, double *scratch, double *misfit)
{
	double last[KERNEL_LANES] = {0};
	bool whole = at + KERNEL_LANES <= n;
	double *to = whole ? misfit + at : last;
	kernel->block(&kernel->plan, theta, at, scratch, to);
	if (!whole)
		memcpy(misfit + at, last, (n - at) * sizeof *last);
}

void
kernel_evaluate(struct kernel *kernel, const double *const theta[PARAM_COUNT],
    size_t n, double *misfit)
{
	ptrdiff_t blocks = (ptrdiff_t)((n + KERNEL_LANES - 1) / KERNEL_LANES);
	int threads = (int)kernel->threads;
#pragma omp parallel for num_threads(threads) \
    schedule(dynamic, 8) if (threads > 1)
	for (ptrdiff_t b = 0; b < blocks; b++)
		evaluate_block(kernel, theta, (size_t)b * KERNEL_LANES, n,
		    kernel->scratch[omp_get_thread_num()], misfit);
}
