/* Calibration: the search for the parameters that explain a site's runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_CALIBRATE_H
#define TIPSPEED_CORE_SEARCH_CALIBRATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "core/numeric/isa.h"
#include "core/search/sensitivity.h"
#include "core/psd/site.h"

/* tolerance: the search ends when the median misfit is no more than this share
 * above the best; 0: never.  stall: it ends when the best misfit has not fallen
 * by 0.1 % within this many generations; 0: never.  Neither applies in the
 * first 25 generations, nor in the 25 after a change of bounds.  train,
 * run_weight [n_run], or NULL for the default (slowest and fastest; all weights
 * 1).  by_sd: weight the sieves by the sheet's standard deviations. */
struct calibrate_options {
	uint64_t seed;
	size_t population, generations, stall;
	double tolerance;
	bool polish;
	unsigned threads;
	enum isa isa;
	struct bounds bounds;
	struct model_settings settings;
	const bool *train;
	const double *run_weight;
	bool by_sd;
	/* A starting point: the fit, on the same runs, of a model that this one
	 * extends; or NULL. */
	const struct params *start;
	bool plain;         /* a textbook genetic algorithm, as in the paper */
	bool (*stop)(void); /* or NULL; see calibration_step */
};

/* Returns the population, generations and bounds of the paper. */
struct calibrate_options calibrate_options_default(void);

/* Returns the misfit that a calibration with these options minimises.  The site
 * must outlive the misfit.  Free with misfit_free. */
struct misfit *calibrate_make_misfit(
    const struct site *site, const struct calibrate_options *options);

/* The stage of a search, or the reason why it ended. */
enum calibrate_state {
	CALIBRATE_SEARCHING,
	CALIBRATE_POLISHING,
	CALIBRATE_TOLERANCE,   /* the population converged */
	CALIBRATE_STALLED,     /* the best no longer improved */
	CALIBRATE_GENERATIONS, /* all generations were used */
	CALIBRATE_STOPPED      /* by the caller */
};

/* Returns a name for people and JSON: "tolerance", "stall", "generations",
 * "stopped". */
const char *calibrate_state_name(enum calibrate_state state);

/* One calibration.  It never prints, waits, reads a clock or catches a signal.
 * To stop it, stop calling calibration_step; the best so far is kept. */
struct calibration;

/* The site must outlive the calibration.  At least one training run must have a
 * product with a sieve that its feed covers (asserted). */
struct calibration *calibration_new(
    const struct site *site, const struct calibrate_options *options);
void calibration_free(struct calibration *c);

/* Runs one generation, or polishes a few starting points, and returns the new
 * state.  A call after the end changes nothing.  If options.stop returns true
 * during a step, that step changes nothing either and must be repeated. */
enum calibrate_state calibration_step(struct calibration *c);

/* Continues within other bounds from the current population (ga_set_bounds).
 * Starting points kept for the polish are moved inside the bounds.  A running
 * polish and the stopping rules start again; generations and history continue.
 * Allowed only before the end (asserted).  Because the result depends on when
 * the bounds changed, the fit's `edits` counts the changes. */
void calibration_set_bounds(struct calibration *c, const struct bounds *bounds);

/* Returns the sum of the squared weights of the passings compared.  A misfit
 * divided by this sum is a mean squared difference. */
double calibration_sum_squared_weights(const struct calibration *c);

/* Returns the bounds of the search, with the reference energy (D12) set. */
const struct bounds *calibration_bounds(const struct calibration *c);

struct calibrate_status {
	enum calibrate_state state;
	size_t generation, evaluations;
	size_t step;                /* generations plus batches of the polish */
	double best, median, worst; /* misfits in the search's scheme */
	size_t starts_done, starts; /* of the polish */
	size_t trials, trials_most; /* perturbations without a gain; the polish
				     * ends at trials_most */
	struct params params;       /* the best so far */
};

/* Returns the state of a search; zeros for NULL. */
struct calibrate_status calibration_status(const struct calibration *c);

/* The record of a generation.  p10, p90: the middle 80 % of the values of each
 * parameter among the first few hundred candidates, a random sample.  kept
 * [n_kept]: the parameters of the first of these, for candidates.h. */
enum { CALIBRATE_KEPT = 64 };
struct calibrate_generation {
	double best, median;
	struct params params; /* the best so far, beta not scaled */
	double p10[PARAMS_MOST], p90[PARAMS_MOST];
	size_t n_kept;
	float kept[PARAMS_MOST][CALIBRATE_KEPT];
};

/* Returns the *n generations so far.  The array is valid until the next
 * step. */
const struct calibrate_generation *calibration_generation_history(
    const struct calibration *c, size_t *n);

/* The result of a calibration, and how it was obtained. */
struct fit {
	struct params
	    params;    /* scaled, see params_scale_largest_beta_to_1 (D4) */
	double misfit; /* of model_compute_product on the training runs */
	double rmse;   /* of passing on the training runs, 0..1 */
	double feed_misfit; /* of the null model product = feed */
	size_t n_residual;  /* passings compared */
	size_t cells;       /* of these, the passings that crushing can
			       * change */
	size_t parameters;  /* number searched, not held fixed */
	bool on_bound[PARAMS_MOST];
	struct flat_direction flat; /* the least determined combination */
	enum calibrate_state stop;
	bool converged; /* the polish that found the fit converged */
	bool plain;     /* found by a plain search without polish */
	double lowest;  /* for a plain search: the misfit that a polished search
			 * with the same options found; 0: not known */
	size_t generations, evaluations, perturbations;
	size_t edits, edited_at; /* changes of the bounds; generation of the
				  * last */
	uint64_t seed;
	size_t population;
	struct model_settings settings;
};

/* Returns the result so far, at any time after the first step. */
struct fit calibration_best_fit(struct calibration *c);

#endif
