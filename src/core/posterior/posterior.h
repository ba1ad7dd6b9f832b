/* What is known after the data: draws of the parameters and of what the model
 * leaves out, as probable as model, measurements and priors make them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_POSTERIOR_H
#define TIPSPEED_CORE_POSTERIOR_POSTERIOR_H

#include <stdbool.h>
#include <stdint.h>

#include "core/posterior/discrepancy.h"
#include "core/numeric/isa.h"
#include "core/model/params.h"
#include "core/psd/site.h"
#include "core/model/strengths.h"

/* Of more than POSTERIOR_RUNS runs so many inform the draws, evenly from the
 * slowest to the fastest: with 80, chains settled where what the model leaves
 * out is large and its parameters are wrong, and bands held 30 %. */
enum { POSTERIOR_DRAWS = 256, POSTERIOR_RUNS = 40 };

/* strengths: of the rock, where e0_min is its mean's (D16). */
struct posterior_draw {
	struct params params; /* scaled */
	struct strengths strengths;
	double hyper[HYPERS];
};

/* settings: the model of the draws, which lets the appearance follow the energy
 * where there is such a one (D12).  fit, bounds: the optimum it was told and
 * what it keeps within, in that model. */
struct posterior {
	struct model_settings settings;
	struct params fit;
	struct bounds bounds;
	size_t n_cell;
	double middle;   /* ln of the mean energy, J/kg, where t is 0 */
	double slowest;  /* of the runs that inform it, m/s */
	double from, to; /* speeds that are looked at, see site_reach */
	size_t n_knot;
	double *knot; /* ln of sizes, coarsest first */
	/* At the knots, [n_knot * POSTERIOR_DRAWS], a row of draws for each:
	 * the processes of the discrepancy (discrepancy.h), and the errors of
	 * one more sample, shared and independent together, over h. */
	double *term[DISCREPANCY_TERMS], *error;
	struct posterior_draw draw[POSTERIOR_DRAWS];
	/* What shows that the chains converged.  ratio: Gelman and Rubin's R,
	 * the largest of all coordinates, 1 at best; drift: how far the means
	 * of the draws' two halves, taken at different times, lie apart, in
	 * standard deviations, the largest; accepted: share of the moves. */
	double ratio, drift, accepted;
};

/* use [n_run]: the runs that inform it, of which one has a product; settings,
 * bounds: of the fit.  stop: or NULL. */
struct posterior_options {
	const bool *use;
	struct model_settings settings;
	struct bounds bounds;
	uint64_t seed;
	double noise; /* known sigma_i, passing 0..1; 0: the prior's */
	unsigned threads;
	enum isa isa;
	bool (*stop)(void);
};

/* p: the fit.  Feeds are smooth between their sieves (D18).  The same seed
 * gives the same bits with any number of threads and any instruction set.  NULL
 * where stop said so meanwhile; posterior_free. */
struct posterior *posterior_new(const struct site *site, const struct params *p,
    const struct posterior_options *options);

/* The same in steps of less than a millisecond, of many runs some ten, of which
 * the last says so and `stop` has no part in.  posterior_end frees it at any
 * time, and gives NULL before the last. */
struct posterior_run;
struct posterior_run *posterior_begin(const struct site *site,
    const struct params *p, const struct posterior_options *options);
bool posterior_step(struct posterior_run *run);
struct posterior *posterior_end(struct posterior_run *run);
void posterior_free(struct posterior *posterior);

#endif
