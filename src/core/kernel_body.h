/* The kernel's arithmetic, compiled once for each instruction set.
 *
 * Every loop over W runs over lanes and is plain C that gcc turns into vector
 * code; arrays are [..][W].  A branch may depend on all lanes of a block only
 * where both ways give a lane the same bits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdbool.h>

#include "core/elementary.h"
#include "core/plan.h"

enum { W = KERNEL_LANES };

typedef double lanes[W] __attribute__((aligned(64)));

/* A block's parameters and what follows from them. */
struct block {
	lanes beta[4], f, e0, alpha, over_alpha, log_e0, log_full;
	lanes over_total;
};

/* 3-point Gauss-Legendre on an interval seen from its upper end. */
static const double GAUSS_FROM_TOP[KERNEL_GAUSS] = {
    0.1127016653792583, 0.5, 0.8872983346207417};
static const double GAUSS_WEIGHT[KERNEL_GAUSS] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

static inline void
load(struct block *b, const struct plan *plan,
    const double *const theta[PARAM_COUNT], size_t at)
{
	for (size_t m = 0; m < 4; m++)
		for (size_t l = 0; l < W; l++)
			b->beta[m][l] = theta[m][at + l];
	for (size_t l = 0; l < W; l++) {
		b->f[l] = theta[PARAM_F_MAT][at + l] * plan->k;
		b->e0[l] = theta[PARAM_E0_MIN][at + l];
		b->alpha[l] = theta[PARAM_ALPHA][at + l];
		double a = b->alpha[l] > 1e-9 ? b->alpha[l] : 1e-9;
		b->over_alpha[l] = 1 / a;
		/* S is 0 below the first size and exactly 1 above the second,
		 * where the exponent reaches 38. */
		b->log_e0[l] = el_log(b->e0[l]);
		b->log_full[l] = el_log(38 / b->f[l] + b->e0[l]);
	}
}

/* p(u) clipped, for one u and all lanes; one is 0 where u is below 2^-10. */
static inline double
density(const struct block *b, size_t l, const double u[static 3], double one)
{
	double p = b->beta[0][l] * one + b->beta[1][l] * u[0] +
		   (b->beta[2][l] * u[1] + b->beta[3][l] * u[2]);
	return p > 0 ? p : 0;
}

/* Integral of p from 2^-10 up to each node of u; node 0 is u = 1. */
static inline void
cumulate(struct block *b, const struct plan *plan, lanes *below)
{
	struct block scaled;
	lanes before = {0};
	for (size_t m = 0; m < 4; m++)
		for (size_t l = 0; l < W; l++)
			scaled.beta[m][l] = b->beta[m][l] * plan->correction[m];
	for (size_t l = 0; l < W; l++) {
		before[l] = density(&scaled, l, plan->u[KERNEL_U_NODES - 1], 1);
		below[KERNEL_U_NODES - 1][l] = 0;
	}
	for (size_t n = KERNEL_U_NODES - 1; n-- > 0;) {
		for (size_t l = 0; l < W; l++) {
			double p = density(&scaled, l, plan->u[n], 1);
			below[n][l] =
			    below[n + 1][l] + plan->half_node * (before[l] + p);
			before[l] = p;
		}
	}
	/* Where p is 0 everywhere nothing moves: product = feed. */
	for (size_t l = 0; l < W; l++) {
		double total = below[0][l];
		b->over_total[l] = total > 0 ? 1 / total : 0;
	}
}

/* Where a class stands for all lanes of a block. */
enum stand { STAND_BELOW, STAND_CUT, STAND_WHOLE, STAND_FULL };

static inline enum stand
class_stand(const lanes from, const lanes full, double lower, double upper)
{
	unsigned above = 0, whole = 0, saturated = 0;
	for (size_t l = 0; l < W; l++) {
		above += from[l] < upper;
		whole += from[l] <= lower;
		saturated += full[l] <= lower;
	}
	if (above == 0)
		return STAND_BELOW;
	if (saturated == W)
		return STAND_FULL;
	return whole == W ? STAND_WHOLE : STAND_CUT;
}

/* Mass S dF of a class and its first moment about the middle, from the Gauss
 * points between max(from, lower) and upper; power, where it is not NULL, has
 * x^alpha at the points of the whole class. */
static inline void
class_mass(const struct block *b, double E, const lanes from, double lower,
    double upper, double mid, double dens, lanes *power, double *mass,
    double *moment)
{
	lanes width, sum = {0}, first = {0};
	for (size_t l = 0; l < W; l++) {
		double a = from[l] > lower ? from[l] : lower;
		a = a < upper ? a : upper;
		width[l] = upper - a;
	}
	for (size_t q = 0; q < KERNEL_GAUSS; q++) {
		for (size_t l = 0; l < W; l++) {
			double t = upper - width[l] * GAUSS_FROM_TOP[q];
			double w = power != NULL ? power[q][l]
						 : el_exp(b->alpha[l] * t);
			double y = b->f[l] * (w * E - b->e0[l]);
			y = y > 0 ? y : 0;
			double S = (1 - el_exp(-y)) * GAUSS_WEIGHT[q];
			sum[l] += S;
			first[l] += S * (t - mid);
		}
	}
	for (size_t l = 0; l < W; l++) {
		mass[l] = dens * width[l] * sum[l];
		moment[l] = dens * width[l] * first[l];
	}
}

/* The same where S is exactly 1: the same sums, once for all lanes. */
static inline void
full_mass(double lower, double upper, double mid, double dens, double *mass,
    double *moment)
{
	double width = upper - lower, sum = 0, first = 0;
	for (size_t q = 0; q < KERNEL_GAUSS; q++) {
		double t = upper - width * GAUSS_FROM_TOP[q];
		sum += GAUSS_WEIGHT[q];
		first += GAUSS_WEIGHT[q] * (t - mid);
	}
	for (size_t l = 0; l < W; l++) {
		mass[l] = dens * width * sum;
		moment[l] = dens * width * first;
	}
}

static inline void
powers(const struct block *b, double lower, double upper, lanes *power)
{
	double width = upper - lower;
	for (size_t q = 0; q < KERNEL_GAUSS; q++) {
		double t = upper - width * GAUSS_FROM_TOP[q];
		for (size_t l = 0; l < W; l++)
			power[q][l] = el_exp(b->alpha[l] * t);
	}
}

/* Workspace of a block; all arrays lie in the thread's scratch. */
struct room {
	lanes *from, *full;   /* [n_run] ln x* and ln x where S becomes 1 */
	lanes *mass, *moment; /* [n_run * n_class] */
	lanes *below;         /* [KERNEL_U_NODES] */
};

/* Masses of class c in every run.  Returns false when no lane breaks any of
 * it. */
static inline bool
one_class(
    const struct block *b, const struct plan *plan, size_t c, struct room *room)
{
	double lower = plan->lower[c], upper = plan->upper[c];
	double mid = plan->middle[c];
	lanes power[KERNEL_GAUSS];
	bool have_power = false, any = false;
	for (size_t r = 0; r < plan->n_run; r++) {
		const struct plan_run *run = &plan->run[r];
		double *mass = room->mass[r * plan->n_class + c];
		double *moment = room->moment[r * plan->n_class + c];
		enum stand stand =
		    class_stand(room->from[r], room->full[r], lower, upper);
		any = any || stand != STAND_BELOW;
		if (stand == STAND_WHOLE && !have_power) {
			powers(b, lower, upper, power);
			have_power = true;
		}
		if (stand == STAND_FULL)
			full_mass(
			    lower, upper, mid, run->mass[c], mass, moment);
		else if (stand == STAND_BELOW || run->mass[c] <= 0)
			for (size_t l = 0; l < W; l++)
				mass[l] = moment[l] = 0;
		else
			class_mass(b, run->E, room->from[r], lower, upper, mid,
			    run->mass[c], stand == STAND_WHOLE ? power : NULL,
			    mass, moment);
	}
	return any;
}

/* Masses of all classes and runs; returns how many classes, from the coarsest,
 * have any. */
static inline size_t
masses(const struct block *b, const struct plan *plan, struct room *room)
{
	for (size_t r = 0; r < plan->n_run; r++) {
		double log_E = plan->run[r].log_E;
		for (size_t l = 0; l < W; l++) {
			room->from[r][l] =
			    (b->log_e0[l] - log_E) * b->over_alpha[l];
			room->full[r][l] =
			    (b->log_full[l] - log_E) * b->over_alpha[l];
		}
	}
	size_t c = 0;
	while (c < plan->n_class && one_class(b, plan, c, room))
		c++;
	return c;
}

/* B and p at the middle of class c as seen from a sieve, going on from the
 * class before; both not yet divided by the total. */
static inline void
step_B(const struct block *b, const struct plan_sieve *sieve, size_t c,
    double *B, double *p)
{
	const double *u = sieve->u + 3 * c;
	double one = sieve->one[c], step = sieve->step[c];
	for (size_t l = 0; l < W; l++) {
		double next = density(b, l, u, one);
		B[l] += step * (p[l] + next);
		p[l] = next;
	}
}

/* B at the coarsest class: from the nodes of u. */
static inline void
start_B(const struct block *b, const struct plan_sieve *sieve, lanes *below,
    double *B, double *p)
{
	size_t n = sieve->start_node;
	for (size_t l = 0; l < W; l++) {
		double rise = below[n][l] - below[n + 1][l];
		B[l] = sieve->start_one *
		       (below[n + 1][l] + sieve->start_step * rise);
		p[l] = density(b, l, sieve->u, sieve->one[0]);
	}
}

/* Adds the squares of the runs' differences at sieve s to sum. */
static inline void
one_sieve(const struct block *b, const struct plan *plan, size_t s,
    size_t n_active, const struct room *room, lanes *broken, double *sum)
{
	const struct plan_sieve *sieve = &plan->sieve[s];
	size_t n = sieve->n_above < n_active ? sieve->n_above : n_active;
	lanes B, p;
	for (size_t r = 0; r < plan->n_run; r++)
		for (size_t l = 0; l < W; l++)
			broken[r][l] = 0;
	for (size_t c = 0; c < n; c++) {
		if (c == 0)
			start_B(b, sieve, room->below, B, p);
		else
			step_B(b, sieve, c, B, p);
		for (size_t r = 0; r < plan->n_run; r++) {
			size_t i = r * plan->n_class + c;
			const double *mass = room->mass[i];
			const double *moment = room->moment[i];
			for (size_t l = 0; l < W; l++)
				broken[r][l] +=
				    mass[l] * B[l] - moment[l] * p[l];
		}
	}
	for (size_t r = 0; r < plan->n_run; r++) {
		const struct plan_target *t = &plan->run[r].target[s];
		for (size_t l = 0; l < W; l++) {
			double part = broken[r][l] * b->over_total[l];
			double d =
			    t->weight * (t->feed_passing + part - t->measured);
			sum[l] += d * d;
		}
	}
}

static inline void
continuous_block(
    const struct plan *plan, struct block *b, double *scratch, double *sum)
{
	lanes *at = (lanes *)(void *)scratch;
	size_t all = plan->n_run * plan->n_class;
	struct room room = {at, at + plan->n_run, at + 2 * plan->n_run,
	    at + 2 * plan->n_run + all, at + 2 * plan->n_run + 2 * all};
	lanes *broken = room.below + KERNEL_U_NODES;
	cumulate(b, plan, room.below);
	size_t n_active = masses(b, plan, &room);
	for (size_t s = 0; s < plan->n_sieve; s++)
		one_sieve(b, plan, s, n_active, &room, broken, sum);
}

/* Selection of each class of a run, method `classes`. */
static inline void
classes_selection(const struct block *b, const struct plan_run *run, lanes *S)
{
	for (size_t i = 0; i < run->n_size; i++) {
		double t = run->log_size[i];
		for (size_t l = 0; l < W; l++) {
			double w = el_exp(b->alpha[l] * t);
			double y = b->f[l] * (w * run->E - b->e0[l]);
			y = y > 0 ? y : 0;
			S[i][l] = 1 - el_exp(-y);
		}
	}
}

/* Breaks parent class i into the product q. */
static inline void
classes_break(const struct block *b, const struct plan_run *run, size_t i,
    const double *S, lanes *p, lanes *q)
{
	lanes share = {0};
	for (size_t j = i; j < run->n_size; j++) {
		const double *u = run->argument + 3 * (i * run->n_size + j);
		for (size_t l = 0; l < W; l++) {
			p[j][l] = density(b, l, u, 1);
			share[l] += p[j][l];
		}
	}
	double f = run->mass[i];
	for (size_t l = 0; l < W; l++) {
		double over = share[l] > 0 ? 1 / share[l] : 0;
		double kept = share[l] > 0 ? 1 - S[l] : 1;
		q[i][l] += kept * f;
		share[l] = S[l] * f * over;
	}
	for (size_t j = i; j < run->n_size; j++)
		for (size_t l = 0; l < W; l++)
			q[j][l] += p[j][l] * share[l];
}

static inline void
classes_run(const struct block *b, const struct plan_run *run, double *scratch,
    double *sum)
{
	size_t n = run->n_size;
	lanes *S = (lanes *)(void *)scratch, *p = S + n, *q = p + n;
	for (size_t i = 0; i < n; i++)
		for (size_t l = 0; l < W; l++)
			q[i][l] = 0;
	classes_selection(b, run, S);
	for (size_t i = 0; i < n; i++)
		classes_break(b, run, i, S[i], p, q);
	for (size_t j = n - 1; j-- > 0;)
		for (size_t l = 0; l < W; l++)
			q[j][l] += q[j + 1][l];
	for (size_t s = 0; s < run->n_target; s++) {
		const struct plan_target *t = &run->target[s];
		const double *coarse = q[t->sieve], *fine = q[t->sieve + 1];
		for (size_t l = 0; l < W; l++) {
			double P = fine[l] + t->share * (coarse[l] - fine[l]);
			double d = t->weight * (P - t->measured);
			sum[l] += d * d;
		}
	}
}

void
KERNEL_NAME(const struct plan *plan, const double *const theta[PARAM_COUNT],
    size_t offset, double *scratch, double *misfit)
{
	struct block b;
	lanes sum = {0};
	load(&b, plan, theta, offset);
	if (plan->method == METHOD_CLASSES)
		for (size_t r = 0; r < plan->n_run; r++)
			classes_run(&b, &plan->run[r], scratch, sum);
	else
		continuous_block(plan, &b, scratch, sum);
	for (size_t l = 0; l < W; l++)
		misfit[l] = sum[l] <= 1e300 ? sum[l] : HUGE_VAL;
}
