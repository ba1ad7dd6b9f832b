/* grunditz-t10: grunditz-energy with progeny that also get finer as in the t10
 * model.
 *   B_v(u) = 1 - (1 - B(u)^((E / E_ref)^-gamma))^((E / E_ref)^kappa)
 * D17.  With t10 = 1 - exp(-b E) and t_n = 1 - (1 - t10)^w(n), every -ln(1 -
 * t_n) is proportional to E, which is the case of kappa 1 and gamma 0.  Source:
 * Narayanan, S.S., Whiten, W.J. (1988), Determination of comminution
 * characteristics from single-particle breakage tests and its application to
 * ball-mill scale-up, Trans. Instn Min. Metall. C 97, 115-124.  Compiled as
 * scalar code, and with LANES for the kernel.
 * SPDX-License-Identifier: GPL-3.0-or-later */

/* At u = 1 the density may be infinite.  For the parent's own class, `classes`
 * uses the density where this share is coarser.  T10_LOG_LEAST is its ln. */
#define T10_LEAST 0.01
#define T10_LOG_LEAST (-4.605170185988091)

#ifndef LANES

#include "core/model/breakage_energy.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "core/numeric/elementary.h"
#include "core/model/selection.h"

enum { KAPPA = 9 };

static void
t10_compute_breaker_constants(struct breaker *b)
{
	energy_compute_breaker_constants(b);
	b->own[OWN_KAPPA] = el_exp(b->p.at[KAPPA] * b->own[OWN_LOG_RATIO]);
}

static double
t10_progeny_share_finer(const struct breaker *b, double log_u, double *d)
{
	double base[PARAMS_MOST] = {0}, r = b->own[OWN_KAPPA];
	double B =
	    energy_progeny_share_finer(b, log_u, d != NULL ? base : NULL);
	double rest = el_log(fmax(1 - B, 1e-300)), coarser = el_exp(r * rest);
	if (d == NULL)
		return 1 - coarser;
	for (size_t i = 0; i < KAPPA && B < 1; i++)
		d[i] += r * coarser / (1 - B) * base[i];
	d[KAPPA] -= r * rest * coarser * b->own[OWN_LOG_RATIO];
	return 1 - coarser;
}

static double
progeny_density(const struct breaker *b, double u, double log_u, double log_x)
{
	double r = b->own[OWN_KAPPA];
	double B = log_u < 0 ? energy_progeny_share_finer(b, log_u, NULL) : 1;
	return r * el_exp((r - 1) * el_log(fmax(1 - B, T10_LEAST))) *
	       energy_progeny_density(b, u, log_u, log_x);
}

static char *
appearance_text(const struct params *p)
{
	FREED char *energy = energy_appearance_text(p);
	return xasprintf("%s, and of 1 - B the power (E/%.4g)^%.4g", energy,
	    params_value_by_name(p, "e_ref"), p->at[KAPPA]);
}

static const struct param_info PARAMETERS[] = {GRUNDITZ_BETA,
    SELECTION_PARAMETERS, ENERGY_PARAMETERS,
    {"kappa", "-", 0, 2, -10, 10, 0,
	N_("appearance: finer with energy if above 0, as in t10"), 0.3},
    BYPASS_PARAMETER};

KERNELS(t10);

BREAKAGE_ROWS(T10, "grunditz-t10",
    N_("grunditz-energy, with finer progeny as t10 has it too (kappa)"), 10,
    .source = "Grunditz et al. 2021, finer progeny by t10",
    .parameter = PARAMETERS, .gauge = 4, .gauge_name = "beta", .reference = 8,
    .strength = 4, .prepare = t10_compute_breaker_constants,
    .finer = t10_progeny_share_finer, .density = progeny_density,
    .appearance_text = appearance_text, .kernel = KERNEL_ROW(t10))

#else /* LANES */

static inline void
t10_load_params(
    struct block *b, const double *const *theta, const uint32_t *index)
{
	energy_load_params(b, theta, index);
	b->own[6] = lanes_gather(theta[9], index);
}

/* Raises the coarser share at the nodes of grunditz-energy to a power.  For
 * integrals, p at u = 1 is the value that leads from the node below to B =
 * 1. */
static inline lanes
t10_tabulate_progeny(
    const struct block *b, const struct batch_plan *plan, struct node *node)
{
	lanes total = energy_tabulate_progeny(b, plan, node);
	for (size_t r = 0; r < plan->n_run; r++) {
		struct node *at = node + r * KERNEL_NODES;
		lanes e = lanes_exp_quick(
		    lanes_min(b->own[6] * (plan->run[r].log_E - b->own[5]),
			lanes_broadcast(708)));
		lanes top =
		    e * at[0].p *
		    lanes_exp_quick((e - 1) * lanes_broadcast(T10_LOG_LEAST));
		for (size_t n = 0; n + 1 < KERNEL_NODES; n++) {
			lanes rest =
			    lanes_max(1 - at[n].below, lanes_broadcast(1e-300));
			lanes coarser = lanes_exp_quick(lanes_max(
			    e * lanes_log(rest), lanes_broadcast(-708)));
			at[n].below = 1 - coarser;
			at[n].p *= e * coarser / rest;
		}
		at[0].p =
		    (at[0].below - at[1].below) / plan->half_step[0] - at[1].p;
		if (plan->method == METHOD_CLASSES)
			at[0].p = top;
	}
	return total;
}

KERNEL(t10, .strength = 4, .load = t10_load_params,
    .nodes = t10_tabulate_progeny, .per_run = true)

#endif
