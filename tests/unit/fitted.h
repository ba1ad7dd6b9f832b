/* Sites calibrated, and their draws, as several tests want them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_FITTED_H
#define TIPSPEED_TESTS_FITTED_H

#include "made.h"

#include "core/search/calibrate.h"
#include "core/posterior/posterior.h"

/* A search that is polished, so that a small one finds the same. */
static inline struct calibrate_options
quick_options(uint64_t seed)
{
	struct calibrate_options o = calibrate_options_default();
	o.population = 500;
	o.seed = seed;
	return o;
}

/* Goes on to the end, and frees. */
static inline struct fit
fitted_by(struct calibration *c)
{
	while (calibration_step(c) < CALIBRATE_TOLERANCE)
		;
	struct fit fit = calibration_best_fit(c);
	calibration_free(c);
	return fit;
}

static inline struct fit
fitted(const struct site *site, const struct calibrate_options *options)
{
	return fitted_by(calibration_new(site, options));
}

/* The draws of a fit that was made with these options.  use: as the posterior's. */
static inline struct posterior *
drawn(const struct site *site, const struct fit *fit,
    const struct calibrate_options *options, const bool *use)
{
	return posterior_new(site, &fit->params,
	    &(struct posterior_options){.use = use,
		.settings = fit->settings,
		.bounds = options->bounds,
		.seed = options->seed,
		.threads = 1,
		.isa = ISA_BEST});
}

#endif
