/* The kernel's arithmetic, compiled once for each instruction set.
 *
 * A branch may depend on all lanes of a block only where both ways give a lane
 * the same bits, so that a candidate's misfit never depends on its neighbours.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdbool.h>

#include "core/lanes.h"
#include "core/plan.h"

/* A block's parameters and what follows from them. */
struct block {
	lanes beta[4], f, e0, alpha, over_alpha, log_e0, log_full, over_total;
};

/* 3-point Gauss-Legendre on an interval seen from its upper end. */
static const double GAUSS_FROM_TOP[KERNEL_GAUSS] = {
    0.1127016653792583, 0.5, 0.8872983346207417};
static const double GAUSS_WEIGHT[KERNEL_GAUSS] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

static inline void
load(struct block *b, const struct plan *plan,
    const double *const theta[PARAM_COUNT], const uint32_t *index)
{
	for (size_t m = 0; m < 4; m++)
		b->beta[m] = lanes_gather(theta[m], index);
	b->f = lanes_gather(theta[PARAM_F_MAT], index) * plan->k;
	b->e0 = lanes_gather(theta[PARAM_E0_MIN], index);
	b->alpha = lanes_gather(theta[PARAM_ALPHA], index);
	b->over_alpha = 1 / lanes_max(b->alpha, lanes_of(1e-9));
	/* S is 0 below the size of the first and exactly 1 above that of the
	 * second, where the exponent reaches 38. */
	b->log_e0 = lanes_log(b->e0);
	b->log_full = lanes_log(38 / b->f + b->e0);
}

/* p(u) clipped; one is 0 where u is below 2^-10. */
static inline lanes
density(const lanes beta[static 4], const double u[static 3], double one)
{
	return lanes_positive((beta[0] * one + beta[1] * u[0]) +
			      (beta[2] * u[1] + beta[3] * u[2]));
}

/* Integral of p from 2^-10 up to each node of u; node 0 is u = 1. */
static inline void
cumulate(struct block *b, const struct plan *plan, lanes *below)
{
	size_t last = KERNEL_U_NODES - 1;
	lanes before = density(b->beta, plan->u[last], 1);
	lanes sum = lanes_of(0);
	below[last] = sum;
	for (size_t n = last; n-- > 0;) {
		lanes p = density(b->beta, plan->u[n], 1);
		sum += plan->half_node * (before + p);
		below[n] = sum;
		before = p;
	}
	/* Where p is 0 everywhere nothing moves: product = feed. */
	b->over_total = (lanes)((sum > 0.0) & (lanes_mask)(1 / sum));
}

/* Mass S dF of a class and its first moment about the middle. */
struct share {
	lanes mass, moment;
};

/* From the Gauss points between max(from, lower) and upper; power, where it is
 * not NULL, has x^alpha at the points of the whole class. */
static inline struct share
class_share(const struct block *b, const struct plan *plan, size_t c, double E,
    double density_c, lanes from, const lanes *power)
{
	double upper = plan->upper[c], mid = plan->middle[c];
	lanes bottom = lanes_min(
	    lanes_max(from, lanes_of(plan->lower[c])), lanes_of(upper));
	lanes width = upper - bottom, sum = lanes_of(0), first = sum;
	for (size_t q = 0; q < KERNEL_GAUSS; q++) {
		lanes t = upper - width * GAUSS_FROM_TOP[q];
		lanes w = power != NULL ? power[q] : lanes_exp(b->alpha * t);
		lanes y = lanes_positive(b->f * (w * E - b->e0));
		lanes S = (1 - lanes_exp(-y)) * GAUSS_WEIGHT[q];
		sum += S;
		first += S * (t - mid);
	}
	lanes scale = density_c * width;
	return (struct share){scale * sum, scale * first};
}

/* The same where S is exactly 1. */
static inline struct share
full_share(const struct plan *plan, size_t c, double density_c)
{
	double upper = plan->upper[c], width = upper - plan->lower[c];
	double sum = 0, first = 0;
	for (size_t q = 0; q < KERNEL_GAUSS; q++) {
		double t = upper - width * GAUSS_FROM_TOP[q];
		sum += GAUSS_WEIGHT[q];
		first += GAUSS_WEIGHT[q] * (t - plan->middle[c]);
	}
	double scale = density_c * width;
	return (struct share){lanes_of(scale * sum), lanes_of(scale * first)};
}

/* Workspace of a block, in the thread's scratch. */
struct room {
	lanes *from, *full;  /* [n_run] ln x* and ln x where S becomes 1 */
	struct share *share; /* [n_run * n_class] */
	lanes *below;        /* [KERNEL_U_NODES] */
	lanes *B, *p;        /* [n_class] as seen from one sieve */
};

/* Shares of class c in every run.  Returns false when no lane breaks any of
 * it. */
static inline bool
one_class(const struct block *b, const struct plan *plan, size_t c,
    const struct room *room)
{
	double lower = plan->lower[c], upper = plan->upper[c];
	lanes power[KERNEL_GAUSS] = {{0}};
	bool have_power = false, any = false;
	for (size_t r = 0; r < plan->n_run; r++) {
		const struct plan_run *run = &plan->run[r];
		struct share *share = &room->share[r * plan->n_class + c];
		lanes from = room->from[r];
		bool some = lanes_any(from < upper);
		any = any || some;
		if (!some || run->mass[c] <= 0) {
			*share = (struct share){lanes_of(0), lanes_of(0)};
			continue;
		}
		if (lanes_all(room->full[r] <= lower)) {
			*share = full_share(plan, c, run->mass[c]);
			continue;
		}
		bool whole = lanes_all(from <= lower);
		for (size_t q = 0; whole && !have_power && q < KERNEL_GAUSS;
		     q++)
			power[q] = lanes_exp(
			    b->alpha *
			    (upper - (upper - lower) * GAUSS_FROM_TOP[q]));
		have_power = have_power || whole;
		*share = whole ? class_share(b, plan, c, run->E, run->mass[c],
				     from, power)
			       : class_share(b, plan, c, run->E, run->mass[c],
				     from, NULL);
	}
	return any;
}

/* Shares of all classes and runs; returns how many classes, from the coarsest,
 * have any. */
static inline size_t
shares(const struct block *b, const struct plan *plan, const struct room *room)
{
	for (size_t r = 0; r < plan->n_run; r++) {
		double log_E = plan->run[r].log_E;
		room->from[r] = (b->log_e0 - log_E) * b->over_alpha;
		room->full[r] = (b->log_full - log_E) * b->over_alpha;
	}
	size_t c = 0;
	while (c < plan->n_class && one_class(b, plan, c, room))
		c++;
	return c;
}

/* B and p at the middle of each class as seen from a sieve, not yet divided by
 * the total. */
static inline void
walk_B(const struct block *b, const struct plan_sieve *sieve, size_t n,
    const struct room *room)
{
	size_t node = sieve->start_node;
	lanes rise = room->below[node] - room->below[node + 1];
	lanes B = sieve->start_one *
		  (room->below[node + 1] + sieve->start_step * rise);
	lanes p = density(b->beta, sieve->u, sieve->one[0]);
	room->B[0] = B;
	room->p[0] = p;
	for (size_t c = 1; c < n; c++) {
		lanes next = density(b->beta, sieve->u + 3 * c, sieve->one[c]);
		B += sieve->step[c] * (p + next);
		p = next;
		room->B[c] = B;
		room->p[c] = p;
	}
}

/* Mass of a run broken to below the sieve that room->B belongs to. */
static inline lanes
broken_below(
    const struct plan *plan, size_t r, size_t n, const struct room *room)
{
	const struct share *share = room->share + r * plan->n_class;
	lanes sum = lanes_of(0);
	for (size_t c = 0; c < n; c++)
		sum +=
		    share[c].mass * room->B[c] - share[c].moment * room->p[c];
	return sum;
}

static inline lanes
continuous_block(const struct plan *plan, struct block *b, double *scratch)
{
	lanes *at = (lanes *)(void *)scratch, sum = lanes_of(0);
	size_t n_run = plan->n_run;
	struct room room = {.from = at,
	    .full = at + n_run,
	    .below = at + 2 * n_run,
	    .B = at + 2 * n_run + KERNEL_U_NODES,
	    .p = at + 2 * n_run + KERNEL_U_NODES + plan->n_class};
	room.share = (void *)(room.p + plan->n_class);
	cumulate(b, plan, room.below);
	size_t n_active = shares(b, plan, &room);
	for (size_t s = 0; s < plan->n_sieve; s++) {
		const struct plan_sieve *sieve = &plan->sieve[s];
		size_t n =
		    sieve->n_above < n_active ? sieve->n_above : n_active;
		if (n > 0)
			walk_B(b, sieve, n, &room);
		for (size_t r = 0; r < n_run; r++) {
			const struct plan_target *t = &plan->run[r].target[s];
			lanes part =
			    broken_below(plan, r, n, &room) * b->over_total;
			lanes d = t->weight * (t->difference + part);
			sum += d * d;
		}
	}
	return sum;
}

/* Selection of each class of a run, method `classes`. */
static inline void
classes_selection(const struct block *b, const struct plan_run *run, lanes *S)
{
	for (size_t i = 0; i < run->n_size; i++) {
		lanes w = lanes_exp(b->alpha * run->log_size[i]);
		lanes y = lanes_positive(b->f * (w * run->E - b->e0));
		S[i] = 1 - lanes_exp(-y);
	}
}

/* Breaks parent class i into the product q. */
static inline void
classes_break(const struct block *b, const struct plan_run *run, size_t i,
    lanes S, lanes *p, lanes *q)
{
	lanes sum = lanes_of(0);
	for (size_t j = i; j < run->n_size; j++) {
		p[j] = density(
		    b->beta, run->argument + 3 * (i * run->n_size + j), 1);
		sum += p[j];
	}
	double f = run->mass[i];
	lanes_mask breaks = sum > 0.0;
	q[i] += f * lanes_select(breaks, 1 - S, lanes_of(1));
	lanes share = (lanes)(breaks & (lanes_mask)(S * f / sum));
	for (size_t j = i; j < run->n_size; j++)
		q[j] += p[j] * share;
}

static inline lanes
classes_run(const struct block *b, const struct plan_run *run, double *scratch)
{
	size_t n = run->n_size;
	lanes *S = (lanes *)(void *)scratch, *p = S + n, *q = p + n;
	lanes sum = lanes_of(0);
	for (size_t i = 0; i < n; i++)
		q[i] = lanes_of(0);
	classes_selection(b, run, S);
	for (size_t i = 0; i < n; i++)
		classes_break(b, run, i, S[i], p, q);
	for (size_t j = n - 1; j-- > 0;)
		q[j] += q[j + 1];
	for (size_t s = 0; s < run->n_target; s++) {
		const struct plan_target *t = &run->target[s];
		lanes coarse = q[t->sieve], fine = q[t->sieve + 1];
		lanes P = fine + t->share * (coarse - fine);
		lanes d = t->weight * (P - t->measured);
		sum += d * d;
	}
	return sum;
}

static inline void
evaluate(const struct plan *plan, const double *const theta[PARAM_COUNT],
    const uint32_t *index, double *scratch, double *misfit)
{
	struct block b;
	lanes sum = lanes_of(0);
	load(&b, plan, theta, index);
	if (plan->method == METHOD_CLASSES)
		for (size_t r = 0; r < plan->n_run; r++)
			sum += classes_run(&b, &plan->run[r], scratch);
	else
		sum = continuous_block(plan, &b, scratch);
	for (size_t l = 0; l < LANES; l++)
		misfit[index[l]] = sum[l] <= 1e300 ? sum[l] : HUGE_VAL;
}

void
KERNEL_NAME(const struct plan *plan, const double *const theta[PARAM_COUNT],
    const uint32_t *index, double *scratch, double *misfit)
{
	for (size_t i = 0; i < KERNEL_LANES; i += LANES)
		evaluate(plan, theta, index + i, scratch, misfit);
}

void
BINS_NAME(const struct plan *plan, const double *e0, const double *alpha,
    unsigned char *bin)
{
	for (size_t i = 0; i < KERNEL_LANES; i += LANES) {
		lanes log_x = lanes_log(lanes_load(e0 + i) * plan->over_E) /
			      (lanes_load(alpha + i) + 1e-9);
		lanes at = lanes_max(
		    (log_x - plan->bottom) * plan->per_bin, lanes_of(0));
		at = lanes_min(at, lanes_of(KERNEL_BINS - 1));
		for (size_t l = 0; l < LANES; l++)
			bin[i + l] = (unsigned char)(int32_t)at[l];
	}
}
