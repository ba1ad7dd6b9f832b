/* Picks the instruction set and hands blocks of candidates to it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/kernel.h"

#include <math.h>
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
	struct pool *pool; /* borrowed */
	double **scratch;  /* [threads] */
	size_t room;
	unsigned char *bin;
	uint32_t *index;
};

struct kernel *
kernel_new(const struct misfit *m, enum isa isa, struct pool *pool)
{
	static kernel_block *const BLOCKS[] = {
	    kernel_block_base, kernel_block_avx2, kernel_block_avx512};
	static kernel_bins *const BINS[] = {
	    kernel_bins_base, kernel_bins_avx2, kernel_bins_avx512};
	struct kernel *kernel = xcalloc(1, sizeof *kernel);
	enum isa usable = isa_usable(isa);
	kernel->block = BLOCKS[usable];
	kernel->bins = BINS[usable];
	plan_make(&kernel->plan, m);
	kernel->pool = pool;
	unsigned threads = pool_threads(pool);
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
	for (unsigned t = 0; t < pool_threads(kernel->pool); t++)
		free(kernel->scratch[t]);
	free(kernel->scratch);
	free(kernel->bin);
	free(kernel->index);
	free(kernel);
}

/* Orders the candidates from..to-1 by their break size, coarse classes of it: a
 * block whose lanes break the same sizes skips the rest at once.  The order
 * changes no bit of any misfit. */
static void
order(struct kernel *kernel, const double *const theta[PARAM_COUNT],
    size_t from, size_t to)
{
	size_t count[KERNEL_BINS + 1] = {0};
	for (size_t i = from; i < to; i += KERNEL_LANES)
		kernel->bins(&kernel->plan, theta[PARAM_E0_MIN] + i,
		    theta[PARAM_ALPHA] + i, kernel->bin + i);
	for (size_t i = from; i < to; i++)
		count[kernel->bin[i] + 1]++;
	for (size_t b = 0; b < KERNEL_BINS; b++)
		count[b + 1] += count[b];
	uint32_t *index = kernel->index + from;
	for (size_t i = from; i < to; i++)
		index[count[kernel->bin[i]]++] = (uint32_t)i;
	/* The last block is filled up with its last candidate. */
	for (size_t i = to - from; i % KERNEL_LANES != 0; i++)
		index[i] = index[to - from - 1];
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

/* One evaluation, for the threads that share it. */
struct batch {
	struct kernel *kernel;
	const double *const *theta;
	size_t n;
	double *misfit;
};

/* Each thread orders and evaluates chunks of its own, so that threads meet only
 * once, at the end. */
enum { CHUNK = 63 * KERNEL_LANES };

static void
evaluate_chunk(void *data, size_t chunk, unsigned thread)
{
	const struct batch *b = data;
	size_t from = chunk * CHUNK;
	size_t to = from + CHUNK < b->n ? from + CHUNK : b->n;
	order(b->kernel, b->theta, from, to);
	for (size_t i = from; i < to; i += KERNEL_LANES)
		b->kernel->block(&b->kernel->plan, b->theta,
		    b->kernel->index + i, b->kernel->scratch[thread],
		    b->misfit);
}

void
kernel_evaluate(struct kernel *kernel, const double *const theta[PARAM_COUNT],
    size_t n, double *misfit)
{
	struct batch batch = {kernel, theta, n, misfit};
	make_room(kernel, n);
	pool_run(kernel->pool, (n + CHUNK - 1) / CHUNK, evaluate_chunk, &batch);
}
