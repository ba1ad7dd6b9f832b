/* A misfit prepared for the kernel: classes, sieves, nodes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_BATCH_PLAN_H
#define TIPSPEED_CORE_SEARCH_BATCH_PLAN_H

#include "core/search/misfit.h"

enum { KERNEL_NODES = 33 };

/* Where u, from the middle of a class to a sieve, lies among the nodes: between
 * `node` and the next finer one.  p is linear between the nodes, that is, p =
 * fine p[node + 1] + coarse p[node] and B = B[node + 1] + below_fine p[node +
 * 1] + below_coarse p[node].  If u is below 2^-10, all weights are 0 and node +
 * 1 is the last node. */
struct node_interpolation {
	size_t node;
	double fine, coarse, below_fine, below_coarse;
};

/* A product sieve of a run. */
struct plan_target {
	double difference; /* feed minus measured passing */
	double measured;
	double weight; /* 0 if the run has no such sieve */
	size_t
	    cell; /* index of the difference in misfit_weighted_differences */
	size_t sieve; /* `classes`: the feed sieve at or above it, */
	double share; /* and the share of its passing to take */
	double feed;  /* `classes`: passing of the feed */
};

struct plan_run {
	double v, E, log_E; /* m/s, J/kg */
	double *mass; /* [n_class] dF / d ln x; for `classes` the mass itself */
	double *whole;              /* [n_class] mass of the class */
	size_t n_target;            /* number of the plan's sieves; `classes`:
				     * of the run's */
	struct plan_target *target; /* [n_target] */
	/* For `classes` only: the run's own classes, the arguments of p, and
	 * where their u lies among the nodes. */
	size_t n_size;
	double *log_size;                /* [n_size] */
	double *argument;                /* [parent][daughter] */
	struct node_interpolation *view; /* [parent][daughter] */
};

/* A sieve of some run's product, with the classes above it. */
struct plan_sieve {
	double log_size;                 /* m */
	size_t n_above;                  /* classes 0..n_above-1 are coarser */
	struct node_interpolation *view; /* [n_class] */
};

struct batch_plan {
	enum method method;
	double k;
	struct impacts impacts;
	/* ln of the highest and lowest energy of a spectrum; 0 without one. */
	double log_most, log_least;
	size_t bypass; /* index of the bypass parameter; 0: the model has
		        * none */
	size_t n_run, n_class, n_sieve;
	bool one_feed; /* all runs have the feed of the first */
	struct plan_run *run;
	struct plan_sieve *sieve;
	double *upper, *lower, *middle; /* [n_class] ln x */
	double u[KERNEL_NODES];         /* 1 to 2^-10 */
	double log_u[KERNEL_NODES];
	double half_step[KERNEL_NODES]; /* half the distance to the next node,
					 * in ln u */
	double over_E, bottom, per_bin; /* for sorting candidates */
	size_t scratch; /* doubles of workspace a thread needs */
};

/* Fills the plan; batch_plan_clear frees its arrays.  The misfit is not
 * kept. */
void batch_plan_fill(struct batch_plan *plan, const struct misfit *m);
void batch_plan_set_speed(struct batch_plan *plan, size_t run, double v);
void batch_plan_clear(struct batch_plan *plan);

#endif
