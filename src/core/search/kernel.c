/* Selects the code for the instruction set and gives it blocks of similar
 * candidates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/kernel.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

struct kernel {
	struct batch_plan plan;
	const struct model_kernel *of;
	unsigned threads;
	double **scratch; /* [threads] */
};

struct kernel *
kernel_new(const struct misfit *m, enum isa isa, unsigned threads)
{
	struct kernel *kernel = xcalloc(1, sizeof *kernel);
	const struct breakage *of = BREAKAGES[m->settings.breakage];
	kernel->of = of->kernel[isa_usable_or_best(isa)];
	batch_plan_fill(&kernel->plan, m);
	kernel->threads = threads;
	kernel->scratch = xcalloc(threads, sizeof *kernel->scratch);
	for (unsigned t = 0; t < threads; t++)
		kernel->scratch[t] = xcalloc_doubles(kernel->plan.scratch);
	return kernel;
}

void
kernel_free(struct kernel *kernel)
{
	if (kernel == NULL)
		return;
	batch_plan_clear(&kernel->plan);
	for (unsigned t = 0; t < kernel->threads; t++)
		free(kernel->scratch[t]);
	free(kernel->scratch);
	free(kernel);
}

/* Candidates in the order of evaluation.  Smooth ones come last, in blocks of
 * their own. */
struct queue {
	size_t n, n_stiff;
	uint32_t index[KERNEL_PART + 2 * KERNEL_LANES];
};

/* Fills the rest of the last block with its last candidate. */
static void
pad_last_candidate_block(struct queue *q)
{
	for (; q->n % KERNEL_LANES != 0; q->n++)
		q->index[q->n] = q->index[q->n - 1];
}

/* Sorts the candidates from..to-1 into bins of the break size: a block whose
 * lanes break the same sizes skips the other sizes at once.  The order does not
 * change any bit of a misfit. */
static void
sort_candidates_by_break_size(const struct kernel *kernel,
    const double *const *theta, size_t from, size_t to, struct queue *q)
{
	uint16_t bin[KERNEL_PART];
	uint32_t place[2 * KERNEL_BINS + 1] = {0};
	uint32_t order[KERNEL_PART] = {0};
	size_t n = to - from;
	for (size_t i = 0; i < n; i += KERNEL_LANES)
		kernel->of->sort(&kernel->plan, theta, from + i, bin + i);
	for (size_t i = 0; i < n; i++)
		place[bin[i] + 1]++;
	for (size_t b = 0; b < 2 * KERNEL_BINS; b++)
		place[b + 1] += place[b];
	size_t stiff = place[KERNEL_BINS];
	for (size_t i = 0; i < n; i++)
		order[place[bin[i]]++] = (uint32_t)(from + i);
	memcpy(q->index, order, stiff * sizeof *order);
	q->n = stiff;
	pad_last_candidate_block(q);
	memcpy(q->index + q->n, order + stiff, (n - stiff) * sizeof *order);
	q->n_stiff = q->n;
	q->n += n - stiff;
	pad_last_candidate_block(q);
}

void
kernel_evaluate_candidates(const struct kernel *kernel,
    const double *const *theta, size_t from, size_t to, unsigned thread,
    const struct kernel_out *out)
{
	struct queue q;
	assert(to - from <= KERNEL_PART && from % KERNEL_LANES == 0);
	sort_candidates_by_break_size(kernel, theta, from, to, &q);
	for (size_t i = 0; i < q.n; i += KERNEL_LANES)
		kernel->of->evaluate(&kernel->plan, theta, q.index + i,
		    i >= q.n_stiff, kernel->scratch[thread], out);
}

void
kernel_set_speed(struct kernel *kernel, double v)
{
	assert(kernel->plan.n_run == 1);
	batch_plan_set_speed(&kernel->plan, 0, v);
	kernel->plan.over_E = 1 / kernel->plan.run[0].E;
}
