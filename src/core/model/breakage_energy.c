/* grunditz-energy: the paper's model with finer progeny at higher energy.
 *   B_v(u) = B(u)^((E / E_ref)^-gamma)
 * D12; gamma 0 is the paper's model.  Compiled as scalar code, and with LANES
 * for the kernel.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LANES

#include "core/model/breakage_energy.h"

#include "base/tr.h"
#include "base/xalloc.h"
#include "core/numeric/elementary.h"
#include "core/model/selection.h"

enum { GAMMA = 7, E_REF };

void
energy_compute_breaker_constants(struct breaker *b)
{
	grunditz_compute_breaker_constants(b);
	b->own[OWN_LOG_RATIO] = el_log(b->E / b->p.at[E_REF]);
	b->own[OWN_GAMMA] = el_exp(-b->p.at[GAMMA] * b->own[OWN_LOG_RATIO]);
}

double
energy_progeny_share_finer(const struct breaker *b, double log_u, double *d)
{
	double base[4] = {0}, e = b->own[OWN_GAMMA];
	double B =
	    grunditz_progeny_share_finer(b, log_u, d != NULL ? base : NULL);
	if (!(B > 0))
		return 0;
	double log_B = el_log(B), P = el_exp(e * log_B);
	if (d == NULL)
		return P;
	for (size_t i = 0; i < 4; i++)
		d[i] += e * P / B * base[i];
	d[GAMMA] -= P * log_B * e * b->own[OWN_LOG_RATIO];
	return P;
}

double
energy_progeny_density(
    const struct breaker *b, double u, double log_u, double log_x)
{
	(void)log_x;
	const struct appearance *a = &b->appearance;
	double p = appearance_density(a->beta, u), e = b->own[OWN_GAMMA];
	double B = log_u < 0 ? grunditz_progeny_share_finer(b, log_u, NULL) : 1;
	return B > 0 ? e * el_exp((e - 1) * el_log(B)) * p / a->total : 0;
}

char *
energy_appearance_text(const struct params *p)
{
	FREED char *cubic = grunditz_appearance_text(p);
	return xasprintf("%s; B at E is its B(u)^((E/%.4g)^-%.4g)", cubic,
	    p->at[E_REF], p->at[GAMMA]);
}

static const struct param_info PARAMETERS[] = {
    GRUNDITZ_BETA, SELECTION_PARAMETERS, ENERGY_PARAMETERS, BYPASS_PARAMETER};

KERNELS(energy);

BREAKAGE_ROWS(ENERGY, "grunditz-energy",
    N_("the paper's, with finer progeny at higher energy (gamma)"), 9,
    .source = "Grunditz et al. 2021, finer progeny at higher energy",
    .parameter = PARAMETERS, .gauge = 4, .gauge_name = "beta",
    .reference = E_REF, .strength = 4,
    .prepare = energy_compute_breaker_constants,
    .finer = energy_progeny_share_finer, .density = energy_progeny_density,
    .appearance_text = energy_appearance_text, .kernel = KERNEL_ROW(energy))

#else /* LANES */

static inline void
energy_load_params(
    struct block *b, const double *const *theta, const uint32_t *index)
{
	grunditz_load_params(b, theta, index);
	b->own[4] = lanes_gather(theta[7], index);
	b->own[5] = lanes_log(lanes_gather(theta[8], index));
}

/* Computes ln B and p / B of the cubic first, then B and p for each run.  The
 * last node, where B is 0 and p may be anything, gets the mean slope. */
static inline lanes
energy_tabulate_progeny(
    const struct block *b, const struct batch_plan *plan, struct node *node)
{
	size_t last = KERNEL_NODES - 1;
	lanes total = grunditz_tabulate_progeny(b, plan, node);
	for (size_t n = 0; n < last; n++) {
		lanes B = lanes_max(node[n].below, lanes_broadcast(1e-300));
		node[n].p /= B;
		node[n].below =
		    lanes_log(B / lanes_max(total, lanes_broadcast(1e-300)));
	}
	for (size_t r = plan->n_run; r-- > 0;) {
		struct node *to = node + r * KERNEL_NODES;
		lanes e = lanes_exp_quick(
		    lanes_min(b->own[4] * (b->own[5] - plan->run[r].log_E),
			lanes_broadcast(708)));
		for (size_t n = 0; n < last; n++) {
			to[n].below = lanes_exp_quick(e * node[n].below);
			to[n].p = e * node[n].p * to[n].below;
		}
		to[last].below = lanes_broadcast(0);
		to[last].p =
		    to[last - 1].below / (2 * plan->half_step[last - 1]);
	}
	return (lanes)((total > 0.0) & (lanes_mask)lanes_broadcast(1));
}

KERNEL(energy, .strength = 4, .load = energy_load_params,
    .nodes = energy_tabulate_progeny, .per_run = true)

#endif
