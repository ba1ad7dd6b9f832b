/* vogel: the selection of Eq 3 with the appearance of Vogel and Peukert,
 *   B(y, x, v) = (y/x)^q (1 + tanh((y - y')/y')) / 2,  q = q_slope v + q_0
 * where y' is the size below which the share of fines falls off.  Source:
 * Vogel, L., Peukert, W. (2005), From single particle impact behaviour to
 * modelling of impact mills, Chem. Eng. Sci. 60, 5164-5176.  Compiled as scalar
 * code, and with LANES for the kernel.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LANES

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "core/numeric/elementary.h"
#include "core/model/selection.h"

enum { Q_SLOPE, Q_0, Y_FINE, F_MAT };

/* Keeps the power falling towards the fines. */
static const double LEAST_Q = 0.01;

/* Returns (1 + tanh((y - y')/y')) / 2 and sets *ratio to y / y'. */
static double
vogel_fines_cutoff(const struct breaker *b, double log_y, double *ratio)
{
	double y = 1000 * el_exp(log_y);
	*ratio = fmin(y / fmax(b->p.at[Y_FINE], 1e-9), 1e9);
	return 1 / (1 + el_exp(-2 * (*ratio - 1)));
}

static void
vogel_compute_breaker_constants(struct breaker *b)
{
	b->own[0] = fmax(b->p.at[Q_SLOPE] * b->v + b->p.at[Q_0], LEAST_Q);
}

static double
vogel_progeny_share_finer(const struct breaker *b, double log_u, double *d)
{
	double q = b->own[0], B = el_exp(q * log_u);
	if (d != NULL && q > LEAST_Q) {
		d[Q_SLOPE] += B * log_u * b->v;
		d[Q_0] += B * log_u;
	}
	return B;
}

static double
fines_factor_with_slope(const struct breaker *b, double log_y, double *d)
{
	double ratio, w = vogel_fines_cutoff(b, log_y, &ratio);
	if (d != NULL)
		d[Y_FINE] -=
		    2 * w * (1 - w) * ratio / fmax(b->p.at[Y_FINE], 1e-9);
	return w;
}

static double
progeny_density(const struct breaker *b, double u, double log_u, double log_x)
{
	(void)u;
	double q = b->own[0], ratio,
	       w = vogel_fines_cutoff(b, log_x + log_u, &ratio);
	return el_exp(q * log_u) * w * (q + 2 * (1 - w) * ratio);
}

static char *
appearance_text(const struct params *p)
{
	const double *q = p->at;
	FREED char *fines =
	    q[Y_FINE] > 0 ? xasprintf(" (1 + tanh(y/%.4g - 1)) / 2", q[Y_FINE])
			  : xstrdup("");
	return xasprintf("B = (y/x)^q%s, q = %.4g v %c %.4g, y = progeny "
			 "in mm, x = parent, v in m/s",
	    fines, q[Q_SLOPE], q[Q_0] < 0 ? '-' : '+', fabs(q[Q_0]));
}

static const struct param_info PARAMETERS[] = {
    {"q_slope", "s/m", -0.05, 0.05, -10, 10, 0,
	N_("appearance: change of its exponent with the speed"), 0},
    {"q_0", "-", 0, 5, -1000, 1000, NAN,
	N_("appearance function: its exponent at speed 0"), 0},
    {"y_fine", "mm", 0, 0.5, 0, 1000, 0,
	N_("appearance: size at which the fines fall off"), 0},
    SELECTION_PARAMETERS, BYPASS_PARAMETER};

KERNELS(vogel);

BREAKAGE_ROWS(VOGEL, "vogel",
    N_("Eq 3 with the appearance of Vogel and Peukert"), 6,
    .source = "Grunditz et al. 2021 with Vogel and Peukert",
    .parameter = PARAMETERS, .reference = PARAMS_MOST, .strength = F_MAT,
    .prepare = vogel_compute_breaker_constants,
    .finer = vogel_progeny_share_finer, .at_size = fines_factor_with_slope,
    .density = progeny_density, .appearance_text = appearance_text,
    .kernel = KERNEL_ROW(vogel))

#else /* LANES */

static inline void
vogel_load_params(
    struct block *b, const double *const *theta, const uint32_t *index)
{
	for (size_t m = 0; m < 3; m++)
		b->own[m] = lanes_gather(theta[m], index);
	b->own[2] = 1000 / lanes_max(b->own[2], lanes_broadcast(1e-9));
}

static inline lanes
vogel_q_at_speed(const struct block *b, const struct plan_run *run)
{
	return lanes_max(b->own[0] * run->v + b->own[1], lanes_broadcast(0.01));
}

static inline lanes
vogel_tabulate_progeny(
    const struct block *b, const struct batch_plan *plan, struct node *node)
{
	for (size_t r = 0; r < plan->n_run; r++, node += KERNEL_NODES) {
		lanes q = vogel_q_at_speed(b, &plan->run[r]);
		for (size_t n = 0; n < KERNEL_NODES; n++) {
			node[n].below = lanes_exp_quick(q * plan->log_u[n]);
			node[n].p = q * node[n].below;
		}
	}
	return lanes_broadcast(1);
}

/* Returns vogel_fines_cutoff at progeny size ln y and sets *ratio to y / y'. */
static inline lanes
vogel_fines_factor(const struct block *b, double log_y, lanes *ratio)
{
	*ratio = lanes_min(b->own[2] * el_exp(log_y), lanes_broadcast(1e9));
	return 1 / (1 + lanes_exp_quick(-2 * (*ratio - 1)));
}

static inline lanes
vogel_fines_factor_at_sieve(const struct block *b, double log_s)
{
	lanes ratio;
	return vogel_fines_factor(b, log_s, &ratio);
}

static inline lanes
vogel_progeny_density(const struct block *b, const struct plan_run *run,
    double u, double log_u, double log_y)
{
	(void)u;
	lanes ratio, w = vogel_fines_factor(b, log_y, &ratio),
		     q = vogel_q_at_speed(b, run);
	return lanes_exp_quick(q * log_u) * w * (q + 2 * (1 - w) * ratio);
}

KERNEL(vogel, .strength = 3, .load = vogel_load_params,
    .nodes = vogel_tabulate_progeny, .density = vogel_progeny_density,
    .at_sieve = vogel_fines_factor_at_sieve, .per_run = true)

#endif
