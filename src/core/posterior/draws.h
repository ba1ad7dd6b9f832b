/* Draws from the posterior; see posterior.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_DRAWS_H
#define TIPSPEED_CORE_POSTERIOR_DRAWS_H

#include <stddef.h>

#include "core/posterior/discrepancy.h"
#include "core/model/params.h"
#include "core/model/strengths.h"

/* If there are more than POSTERIOR_RUNS runs, only this many, spread evenly
 * from the slowest to the fastest, inform the draws: with 80 runs, chains
 * settled where the discrepancy is large and the parameters are wrong, and 80 %
 * bands held only 30 %. */
enum { POSTERIOR_DRAWS = 256, POSTERIOR_RUNS = 40 };

/* strengths: of the rock; e0_min in params is then their mean (D16). */
struct posterior_draw {
	struct params params; /* scaled */
	struct strengths strengths;
	double hyper[HYPERS];
};

/* settings: those of the fit, with the model of the draws, whose appearance
 * depends on the energy if there is such a model (D12).  fit, bounds: the
 * optimum at which the chains began and their bounds, in this model. */
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
	/* [n_knot * POSTERIOR_DRAWS], a row of draws for each knot: the
	 * processes of the discrepancy (discrepancy.h), and the total error,
	 * shared and independent, of one more sample, over h. */
	double *term[DISCREPANCY_TERMS], *error;
	double *lack; /* [n_speed * n_knot] (lack_of_fit.h), or NULL */
	struct posterior_draw draw[POSTERIOR_DRAWS];
	/* Convergence diagnostics.  ratio: the largest Gelman-Rubin R of all
	 * coordinates, ideally 1; drift: the largest difference, in standard
	 * deviations, between the means of the two halves of the draws, which
	 * were taken at different times; accepted: share of moves accepted. */
	double ratio, drift, accepted;
};

#endif
