/* Picks the instruction set and hands blocks of candidates to it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/kernel.h"

#include <assert.h>
#include <math.h>
#include <omp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/elementary.h"
#include "core/energy.h"
#include "core/plan.h"

struct kernel {
	struct plan plan;
	kernel_block *block;
	kernel_bins *bins;
	unsigned threads;
	double **scratch; /* [threads] */
	size_t room;
	unsigned char *bin;
	uint32_t *index;
};

struct kernel *
kernel_new(const struct misfit *m, enum isa isa, unsigned threads)
{
	static kernel_block *const BLOCKS[] = {
	    kernel_block_base, kernel_block_avx2, kernel_block_avx512};
	static kernel_bins *const BINS[] = {
	    kernel_bins_base, kernel_bins_avx2, kernel_bins_avx512};
	assert(threads >= 1);
	struct kernel *kernel = xcalloc(1, sizeof *kernel);
	enum isa usable = isa_usable(isa);
	kernel->block = BLOCKS[usable];
	kernel->bins = BINS[usable];
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
	free(kernel->bin);
	free(kernel->index);
	free(kernel);
}

/* Orders candidates by their break size, coarse classes of it: a block whose
 * lanes break the same sizes skips the rest at once.  The order changes no bit
 * of any misfit. */
static void
order(struct kernel *kernel, size_t n)
{
	size_t count[KERNEL_BINS + 1] = {0};
	for (size_t i = 0; i < n; i++)
		count[kernel->bin[i] + 1]++;
	for (size_t b = 0; b < KERNEL_BINS; b++)
		count[b + 1] += count[b];
	for (size_t i = 0; i < n; i++)
		kernel->index[count[kernel->bin[i]]++] = (uint32_t)i;
	/* The last block is filled up with its last candidate. */
	for (size_t i = n; i % KERNEL_LANES != 0; i++)
		kernel->index[i] = kernel->index[n - 1];
}

static void
make_room(struct kernel *kernel, size_t n)
{
	if (n <= kernel->room)
		return;
	kernel->room = n;
	kernel->bin = xrealloc(kernel->bin, n + KERNEL_LANES, 1);
	kernel->index =
	    xrealloc(kernel->index, n + KERNEL_LANES, sizeof *kernel->index);
}

void
kernel_evaluate(struct kernel *kernel, const double *const theta[PARAM_COUNT],
    size_t n, double *misfit)
{
	ptrdiff_t blocks = (ptrdiff_t)((n + KERNEL_LANES - 1) / KERNEL_LANES);
	int threads = (int)kernel->threads;
	make_room(kernel, n);
#pragma omp parallel num_threads(threads) if (threads > 1)
	{
#pragma omp for schedule(static)
		for (ptrdiff_t b = 0; b < blocks; b++)
			kernel->bins(&kernel->plan,
			    theta[PARAM_E0_MIN] + b * KERNEL_LANES,
			    theta[PARAM_ALPHA] + b * KERNEL_LANES,
			    kernel->bin + b * KERNEL_LANES);
#pragma omp single
		order(kernel, n);
#pragma omp for schedule(dynamic, 8)
		for (ptrdiff_t b = 0; b < blocks; b++)
			kernel->block(&kernel->plan, theta,
			    kernel->index + b * KERNEL_LANES,
			    kernel->scratch[omp_get_thread_num()], misfit);
	}
}
