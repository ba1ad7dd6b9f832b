/* What the kernel's variants share: the plan of one misfit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PLAN_H
#define TIPSPEED_CORE_PLAN_H

#include <stddef.h>
#include <stdint.h>

#include "core/kernel.h"
#include "core/params.h"

enum { KERNEL_GAUSS = 3, KERNEL_U_NODES = 41 };

/* A product sieve of a run. */
struct plan_target {
	double difference; /* feed less measured passing */
	double measured;
	double weight; /* 0 where the run has no such sieve */
	size_t sieve;  /* `classes`: the feed sieve at or above it, */
	double share;  /* and how much of that one's passing to take */
};

struct plan_run {
	double E, log_E; /* J/kg */
	double *mass; /* [n_class] dF / d ln x; for `classes` the mass itself */
	size_t n_target;            /* the plan's sieves; `classes`: its own */
	struct plan_target *target; /* [n_target] */
	/* `classes` only: its own classes and the arguments of p. */
	size_t n_size;
	double *log_size; /* [n_size] */
	double *argument; /* [parent][daughter][3]: powers 1..3 */
};

/* A sieve at which some run has a product, with the classes above it. */
struct plan_sieve {
	size_t n_above;    /* classes 0..n_above-1 are coarser */
	double *u;         /* [n_class][3]: u, u^2, u^3; all 0 below 2^-10 */
	double *one;       /* [n_class] 1, or 0 below 2^-10 */
	double *step;      /* [n_class] half the distance to the class before */
	size_t start_node; /* B at the coarsest class: above this node of u, */
	double start_step; /* this much of the way to the next in ln u, */
	double start_one;  /* or nothing when 0 (below 2^-10) */
};

struct plan {
	enum method method;
	double k;
	size_t n_run, n_class, n_sieve;
	struct plan_run *run;
	struct plan_sieve *sieve;
	double *upper, *lower, *middle; /* [n_class] ln x */
	double u[KERNEL_U_NODES][3];
	double half_node; /* half the distance of the nodes of u, in ln u */
	double over_E, bottom, per_bin; /* for the order of candidates */
	size_t scratch; /* doubles of workspace a thread needs */
};

/* Fills the plan, which plan_clear empties.  The misfit is read, not kept. */
void plan_make(struct plan *plan, const struct misfit *m);
void plan_clear(struct plan *plan);

/* Evaluates KERNEL_LANES candidates, those of the indices, and puts each misfit
 * in its place. */
typedef void kernel_block(const struct plan *plan,
    const double *const theta[PARAM_COUNT], const uint32_t *index,
    double *scratch, double *misfit);

kernel_block kernel_block_base;
kernel_block kernel_block_avx2;
kernel_block kernel_block_avx512;

/* Which break sizes KERNEL_LANES candidates belong together by, at the mean
 * energy: a bin of ln x* for each. */
enum { KERNEL_BINS = 64 };
typedef void kernel_bins(const struct plan *plan, const double *e0,
    const double *alpha, unsigned char *bin);

kernel_bins kernel_bins_base;
kernel_bins kernel_bins_avx2;
kernel_bins kernel_bins_avx512;

#endif
