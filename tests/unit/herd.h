/* Candidates as the kernel takes them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_HERD_H
#define TIPSPEED_TESTS_HERD_H

#include <stdlib.h>

#include "made.h"

#include "base/pool.h"
#include "core/search/kernel.h"

/* Candidates of a model, gene[its n][n], readable as the kernel wants it. */
struct herd {
	size_t n, breakage;
	double *gene[PARAMS_MOST];
};

static inline struct herd
herd_new(size_t n)
{
	struct herd herd = {.n = n};
	for (size_t j = 0; j < PARAMS_MOST; j++)
		herd.gene[j] = xcalloc_doubles(n + 64);
	return herd;
}

static inline void
herd_free(struct herd *herd)
{
	for (size_t j = 0; j < PARAMS_MOST; j++)
		free(herd->gene[j]);
}

static inline void
herd_put(struct herd *herd, size_t i, const struct params *p)
{
	herd->breakage = p->breakage;
	for (size_t j = 0; j < breakage_model_of_params(p)->n; j++)
		herd->gene[j][i] = p->at[j];
}

static inline struct params
herd_get(const struct herd *herd, size_t i)
{
	struct params p = {.breakage = herd->breakage};
	for (size_t j = 0; j < breakage_model_of_params(&p)->n; j++)
		p.at[j] = herd->gene[j][i];
	return p;
}

/* Parts of the box: all of it, and a half near a row of Table 3, so that the
 * break size of many a candidate lies within the feed. */
static inline struct herd
herd_any(size_t n, uint64_t seed)
{
	struct herd herd = herd_new(n);
	struct draw draw = draw_start(seed);
	for (size_t i = 0; i < n; i++) {
		struct params p = made_any_params(&draw);
		if (i % 2 == 1) {
			const struct table_row *row = &TABLE_3[i % 19];
			p.f_mat = row->f_mat;
			p.e0_min = row->e0_min;
			p.alpha = row->alpha;
		}
		if (i % 50 == 7)
			p.e0_min = 0;
		if (i % 50 == 8)
			p.alpha = 0;
		if (i % 50 == 9)
			p.alpha = p.e0_min = 0;
		herd_put(&herd, i, &p);
	}
	return herd;
}

/* One evaluation, for the threads that share it. */
struct batch {
	const struct kernel *kernel;
	const double *const *theta;
	size_t n;
	double *misfit;
};

static inline void
evaluate_part(void *data, size_t part, unsigned thread)
{
	const struct batch *b = data;
	size_t from = part * KERNEL_PART, to = from + KERNEL_PART;
	kernel_evaluate_candidates(b->kernel, b->theta, from, to < b->n ? to : b->n,
	    thread, &(struct kernel_out){.misfit = b->misfit});
}

/* All of n candidates; the pool's threads, at most those of kernel_new, share
 * the parts.  pool: NULL for the caller's thread alone. */
static inline void
herd_judge(const struct kernel *kernel, struct pool *pool,
    const struct herd *herd, size_t n, double *misfit)
{
	struct batch batch = {
	    kernel, (const double *const *)herd->gene, n, misfit};
	pool_run(
	    pool, (n + KERNEL_PART - 1) / KERNEL_PART, evaluate_part, &batch);
}

static inline void
herd_evaluate(const struct misfit *m, enum isa isa, unsigned threads,
    const struct herd *herd, double *misfit)
{
	struct pool *pool = pool_new(threads);
	struct kernel *kernel = kernel_new(m, isa, threads);
	herd_judge(kernel, pool, herd, herd->n, misfit);
	kernel_free(kernel);
	pool_free(pool);
}

#endif
