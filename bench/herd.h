/* Sets of candidates with which the kernel is timed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BENCH_HERD_H
#define TIPSPEED_BENCH_HERD_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/pool.h"
#include "base/xalloc.h"
#include "core/search/kernel.h"
#include "core/model/params.h"
#include "core/numeric/rng.h"
#include "measure.h"

enum { HERD = 8000 };

static const double HERD_NEAR = 0.02; /* relative to each parameter's value */

/* HERD candidates, with one array for each parameter. */
struct herd {
	double *gene[PARAM_COUNT];
};

/* Returns candidates uniform within lower..upper. */
static inline struct herd
herd_in(const double *lower, const double *upper)
{
	struct herd h;
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		struct rng_key key = rng_make_key(1, 0, j);
		double width = upper[j] - lower[j];
		h.gene[j] = xcalloc_doubles(HERD + KERNEL_LANES);
		for (uint32_t i = 0; i < HERD; i++)
			h.gene[j][i] = lower[j] + width * rng_uniform(key, i);
	}
	return h;
}

static inline struct herd
herd_wide(void)
{
	struct bounds b = bounds_default(0);
	return herd_in(b.lower, b.upper);
}

static inline struct herd
herd_near(const struct params *p)
{
	struct bounds b = bounds_default(0);
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		double x = p->at[j];
		b.lower[j] = x - HERD_NEAR * fabs(x);
		b.upper[j] = fmin(x + HERD_NEAR * fabs(x), b.upper[j]);
	}
	return herd_in(b.lower, b.upper);
}

/* The data that the threads of a pool share. */
struct herd_batch {
	const struct kernel *kernel;
	const double *const *gene;
	size_t n;
	double *misfit;
};

static inline void
herd_part(void *data, size_t part, unsigned thread)
{
	const struct herd_batch *b = data;
	size_t from = part * KERNEL_PART, to = from + KERNEL_PART;
	kernel_evaluate_candidates(b->kernel, b->gene, from,
	    to < b->n ? to : b->n, thread,
	    &(struct kernel_out){.misfit = b->misfit});
}

static inline void
herd_evaluate(const struct kernel *kernel, struct pool *pool,
    const double *const *gene, size_t n, double *misfit)
{
	struct herd_batch batch = {kernel, gene, n, misfit};
	pool_run(pool, (n + KERNEL_PART - 1) / KERNEL_PART, herd_part, &batch);
}

static inline void
herd_free(struct herd *h)
{
	for (size_t j = 0; j < PARAM_COUNT; j++)
		free(h->gene[j]);
}

#endif
