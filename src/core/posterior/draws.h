/* Draws from the posterior, see posterior.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_DRAWS_H
#define TIPSPEED_CORE_POSTERIOR_DRAWS_H

#include <stddef.h>

#include "core/posterior/discrepancy.h"
#include "core/model/params.h"
#include "core/model/strengths.h"

/* Of more than POSTERIOR_RUNS runs, only that many, spread evenly from the
 * slowest to the fastest, inform the draws: with 80 runs, chains settled where
 * the discrepancy is large and the parameters are wrong, and 80 % bands held
 * only 30 %. */
enum { POSTERIOR_DRAWS = 256, POSTERIOR_RUNS = 40 };

/* strengths: of the rock; e0_min in params is then their mean (D16). */
struct posterior_draw {
	struct params params; /* scaled */
	struct strengths strengths;
	double hyper[HYPERS];
};

/* settings: with the model of the draws, whose appearance depends on the energy
 * if there is such a model (D12).  fit, bounds: the optimum at which the chains
 * began and their bounds, in this model. */
struct posterior {
	struct model_settings settings;
	struct params fit;
	struct bounds bounds;
	size_t n_cell;
	double middle; /* ln of the mean energy, J/kg, where t is 0 */
	double from,
	    to; /* range of speeds of interest, see site_default_speed_range */
	/* The speeds of the runs that inform the draws, m/s, slowest first, and
	 * the share of draws that are linear between neighbouring speeds
	 * (thin.h). */
	size_t n_speed;
	double speed[POSTERIOR_RUNS], straight;
	double speed_sd; /* of stated tip speeds, as a share; 0: exact */
	size_t n_knot;
	double *knot; /* ln of sizes, coarsest first */
	/* At the knots, [n_knot * POSTERIOR_DRAWS], a row of draws for each:
	 * the processes of the discrepancy (discrepancy.h) and the total errors
	 * of one more sample, shared and independent, over h. */
	double *term[DISCREPANCY_TERMS], *error;
	double *lack; /* [n_speed * n_knot], see lack_of_fit.h, or NULL */
	struct posterior_draw draw[POSTERIOR_DRAWS];
	/* Convergence diagnostics.  ratio: the largest Gelman-Rubin R of all
	 * coordinates, ideally 1; drift: the largest difference between the
	 * means of two halves of the draws, taken at different times, in
	 * standard deviations; accepted: share of moves accepted. */
	double ratio, drift, accepted;
};

#endif
