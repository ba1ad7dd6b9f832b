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
	enum kernel_isa isa;
	kernel_block *block;
	unsigned threads;
	double **scratch;               /* [threads] */
	double over_E, bottom, per_bin; /* for the order of candidates */
	size_t room;
	unsigned char *bin;
	uint32_t *index;
};

enum { BINS = 64 };

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
	double mean = 0, low = 0, high = -20;
	for (size_t r = 0; r < m->n_run; r++) {
		const struct psd *feed = &m->run[r].feed;
		mean += energy_specific(m->run[r].speed) / (double)m->n_run;
		low = fmin(low, el_log(feed->size[feed->n - 1]));
		high = fmax(high, el_log(feed->size[0]));
	}
	kernel->over_E = 1 / mean;
	kernel->bottom = low;
	kernel->per_bin = BINS / (high - low);
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
order(struct kernel *kernel, const double *const theta[PARAM_COUNT], size_t n)
{
	size_t count[BINS + 1] = {0};
	for (size_t i = 0; i < n; i++) {
		double log_x = el_log(theta[PARAM_E0_MIN][i] * kernel->over_E) /
			       (theta[PARAM_ALPHA][i] + 1e-9);
		double bin = (log_x - kernel->bottom) * kernel->per_bin;
		bin = bin > 0 ? bin : 0;
		bin = bin < BINS - 1 ? bin : BINS - 1;
		kernel->bin[i] = (unsigned char)(int)bin;
	}
	for (size_t i = 0; i < n; i++)
		count[kernel->bin[i] + 1]++;
	for (size_t b = 0; b < BINS; b++)
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
	kernel->bin = xrealloc(kernel->bin, n, 1);
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
	order(kernel, theta, n);
#pragma omp parallel for num_threads(threads) \
    schedule(dynamic, 8) if (threads > 1)
	for (ptrdiff_t b = 0; b < blocks; b++)
		kernel->block(&kernel->plan, theta,
		    kernel->index + b * KERNEL_LANES,
		    kernel->scratch[omp_get_thread_num()], misfit);
}
