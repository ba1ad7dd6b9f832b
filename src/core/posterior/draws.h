/* Draws from the posterior, see posterior.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_DRAWS_H
#define TIPSPEED_CORE_POSTERIOR_DRAWS_H

#include <stddef.h>

#include "core/posterior/discrepancy.h"
#include "core/model/params.h"
#include "core/model/strengths.h"

/* Where there are more runs, POSTERIOR_RUNS of them inform the draws, spread
 * evenly from the slowest to the fastest: with 80, chains settled where the
 * discrepancy is large and the parameters are wrong, and bands held 30 %. */
enum { POSTERIOR_DRAWS = 256, POSTERIOR_RUNS = 40 };

/* strengths: of the rock; e0_min is then that of its mean (D16). */
struct posterior_draw {
	struct params params; /* scaled */
	struct strengths strengths;
	double hyper[HYPERS];
};

/* settings: the model of the draws, which lets the appearance follow the energy
 * where there is such a model (D12).  fit, bounds: the optimum where the chains
 * began, and their bounds, in this model. */
struct posterior {
	struct model_settings settings;
	struct params fit;
	struct bounds bounds;
	size_t n_cell;
	double middle;   /* ln of the mean energy, J/kg, where t is 0 */
	double from, to; /* speeds that are looked at, see site_reach */
	/* The speeds of the runs that inform it, m/s, slowest first, and the
	 * share of the draws that are straight between neighbouring speeds
	 * (thin.h). */
	size_t n_speed;
	double speed[POSTERIOR_RUNS], straight;
	size_t n_knot;
	double *knot; /* ln of sizes, coarsest first */
	/* At the knots, [n_knot * POSTERIOR_DRAWS], a row of draws for each:
	 * the processes of the discrepancy (discrepancy.h), and the errors of
	 * one more sample, shared and independent together, over h. */
	double *term[DISCREPANCY_TERMS], *error;
	double *lack; /* [n_speed * n_knot], see lack_of_fit.h, or NULL */
	struct posterior_draw draw[POSTERIOR_DRAWS];
	/* Diagnostics of convergence.  ratio: Gelman and Rubin's R, the largest
	 * of all coordinates, 1 at best; drift: how far the means of the draws'
	 * two halves, taken at different times, lie apart, in standard
	 * deviations, the largest; accepted: share of the moves. */
	double ratio, drift, accepted;
};

#endif
