/* The posterior: draws of the parameters and of the discrepancy, given the
 * model, the measurements and the priors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_POSTERIOR_H
#define TIPSPEED_CORE_POSTERIOR_POSTERIOR_H

#include <stdbool.h>
#include <stdint.h>

#include "core/posterior/draws.h"
#include "core/numeric/isa.h"
#include "core/psd/site.h"

/* The usual error of tip speeds, if none is stated, from rounding, belt slip
 * and worn tips: a standard deviation, as a share. */
#define POSTERIOR_USUAL_SPEED_SD 0.005

/* use [n_run]: the runs that inform the posterior; at least one must have a
 * product.  settings, bounds: those of the fit.  stop may be NULL. */
struct posterior_options {
	const bool *use;
	struct model_settings settings;
	struct bounds bounds;
	uint64_t seed;
	double noise;    /* known sigma_i, passing 0..1; 0: not known */
	double speed_sd; /* of stated tip speeds, as a share; 0: exact */
	unsigned threads;
	enum isa isa;
	bool (*stop)(void);
};

/* p: the fit.  Feeds are taken to be smooth between their sieves (D18).  The
 * same seed gives the same bits with any number of threads and any instruction
 * set.  Returns NULL if stop returned true.  Free with posterior_free. */
struct posterior *posterior_new(const struct site *site, const struct params *p,
    const struct posterior_options *options);

/* As posterior_new, but without `stop` and in steps of less than a millisecond
 * (some ten with many runs).  posterior_step returns true after the last step.
 * posterior_end may be called at any time: it frees the run and returns the
 * posterior, or NULL before the last step. */
struct posterior_run;
struct posterior_run *posterior_begin_sampling(const struct site *site,
    const struct params *p, const struct posterior_options *options);
bool posterior_step(struct posterior_run *run);
struct posterior *posterior_end(struct posterior_run *run);
void posterior_free(struct posterior *posterior);

#endif
