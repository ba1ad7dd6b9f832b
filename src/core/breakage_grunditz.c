/* The paper's model: Eq 3 and the cubic of Eq 1; scalar, or with LANES.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LANES

#include <assert.h>
#include <math.h>

#include "base/xalloc.h"
#include "core/appearance.h"
#include "core/breakage.h"
#include "core/grunditz.h"
#include "core/moments.h"
#include "core/selection.h"

void
grunditz_prepare(struct breaker *b)
{
	struct params scaled = b->p;
	params_scale(&scaled);
	static_assert(sizeof(struct appearance) <= sizeof b->own, "room");
	*(struct appearance *)(void *)b->own = appearance_of(scaled.beta);
}

const struct appearance *
grunditz_appearance(const struct breaker *b)
{
	return (const struct appearance *)(const void *)b->own;
}

double
grunditz_selection(const struct breaker *b, double log_x, double *d)
{
	return selection(b->p.at + GRUNDITZ_F_MAT, b->k, b->E, log_x,
	    d != NULL ? d + GRUNDITZ_F_MAT : NULL);
}

double
grunditz_size_at(const struct breaker *b, double exponent)
{
	return selection_size_at(
	    b->p.at + GRUNDITZ_F_MAT, b->k, b->E, exponent);
}

double
grunditz_break_size(const struct params *p, double E)
{
	return selection_break_size(p->at + GRUNDITZ_F_MAT, E);
}

double
grunditz_finer(const struct breaker *b, double log_u, double *d)
{
	const struct appearance *a = grunditz_appearance(b);
	double parts[4], sum = 0;
	if (a->n == 0)
		return 0;
	appearance_parts(a, log_u, parts);
	for (size_t i = 0; i < 4; i++)
		sum += a->beta[i] * parts[i];
	double B = sum / a->total;
	if (d == NULL)
		return B;
	double scale = 1 / (a->total * params_gauge(&b->p));
	for (size_t i = 0; i < 4; i++)
		d[i] += (parts[i] - B * a->full[a->n - 1][i]) * scale;
	return B;
}

bool
grunditz_breaks(const struct breaker *b)
{
	return grunditz_appearance(b)->total > 0;
}

char *
grunditz_selection_text(const struct params *p, double k)
{
	return selection_text(p->at + GRUNDITZ_F_MAT, k);
}

char *
grunditz_appearance_text(const struct params *p)
{
	return xasprintf("p(u) = max(0, %.4g %+.4g u %+.4g u^2 %+.4g u^3), u = "
			 "progeny / parent",
	    p->beta[0], p->beta[1], p->beta[2], p->beta[3]);
}

static double
density(const struct breaker *b, double u, double log_u, double log_x)
{
	(void)log_u;
	(void)log_x;
	return appearance_density(b->p.beta, u);
}

static const struct param_info PARAMETERS[] = {
    GRUNDITZ_BETA, SELECTION_PARAMETERS, BYPASS_PARAMETER};

KERNELS(grunditz);

#define ROW(NAME, BYPASS, ...)                                                \
	{                                                                     \
		.name = NAME, .brief = __VA_ARGS__, .n = 7 + (BYPASS),        \
		.parameter = PARAMETERS, .gauge = 4, .gauge_name = "beta",    \
		.reference = 7 + (BYPASS), .bypass = BYPASS, .forms = true,   \
		.prepare = grunditz_prepare, .selection = grunditz_selection, \
		.size_at = grunditz_size_at,                                  \
		.break_size = grunditz_break_size, .finer = grunditz_finer,   \
		.density = density, .breaks = grunditz_breaks,                \
		.product = moments_product,                                   \
		.selection_text = grunditz_selection_text,                    \
		.appearance_text = grunditz_appearance_text,                  \
		.kernel = KERNEL_ROW(grunditz)                                \
	}

extern const struct breakage BREAKAGE_GRUNDITZ, BREAKAGE_GRUNDITZ_BYPASS;
const struct breakage BREAKAGE_GRUNDITZ =
    ROW("grunditz", 0, "Eqs 1 to 3 of the paper");
const struct breakage BREAKAGE_GRUNDITZ_BYPASS = ROW("grunditz+bypass", 1,
    "grunditz with a share of the feed that bypasses the rotor");

#else /* LANES */

static inline void
grunditz_load(
    struct block *b, const double *const *theta, const uint32_t *index)
{
	for (size_t m = 0; m < 4; m++)
		b->own[m] = lanes_gather(theta[m], index);
}

/* p(u), clipped. */
static inline lanes
grunditz_density(const struct block *b, const struct plan_run *run, double u,
    double log_u, double log_y)
{
	(void)run;
	(void)log_u;
	(void)log_y;
	const lanes *beta = b->own;
	return positive(beta[0] + u * (beta[1] + u * (beta[2] + u * beta[3])));
}

/* p at the nodes of u and its integral up to each. */
static inline lanes
grunditz_nodes(
    const struct block *b, const struct plan *plan, struct node *node)
{
	const struct plan_run *run = &plan->run[0];
	size_t last = KERNEL_NODES - 1;
	lanes sum = lanes_of(0);
	node[last].p = grunditz_density(b, run, plan->u[last], 0, 0);
	node[last].below = sum;
	for (size_t n = last; n-- > 0;) {
		node[n].p = grunditz_density(b, run, plan->u[n], 0, 0);
		sum += plan->half_step[n] * (node[n + 1].p + node[n].p);
		node[n].below = sum;
	}
	return sum;
}

KERNEL(grunditz, .strength = 4, .load = grunditz_load, .nodes = grunditz_nodes,
    .density = grunditz_density)

#endif
