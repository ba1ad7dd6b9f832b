/* What a calibration has found so far.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/calibration.h"

#include <math.h>

#include "base/xalloc.h"
#include "core/sensitivity.h"

/* The best so far: of a first phase, where the search has found none better. */
static struct params
best_of(const struct calibration *c, double searched)
{
	bool search = c->state == CALIBRATE_SEARCHING;
	return search && !(c->best_misfit < searched)
		   ? calibration_search_best(c)
		   : c->best;
}

struct calibrate_status
calibration_status(const struct calibration *c)
{
	struct ga_status s = ga_status(c->ga);
	struct calibrate_status status = {.state = c->state,
	    .generation = s.generation,
	    .step = s.generation + calibration_batches(c),
	    .evaluations = c->evaluations,
	    .stall = c->stall,
	    .infinite = s.infinite,
	    .best = fmin(s.best, c->best_misfit),
	    .median = s.median,
	    .worst = s.worst,
	    .starts_done = c->done,
	    .starts = c->n_start,
	    .params = best_of(c, s.best)};
	/* Other bounds, and nothing judged within them yet. */
	if (isinf(status.best) && s.generation > 0)
		status.best = misfit_at(c->misfit, &status.params);
	params_scale(&status.params);
	return status;
}

const struct bounds *
calibration_bounds(const struct calibration *c)
{
	return &c->options.bounds;
}

struct fit
calibration_fit(struct calibration *c)
{
	struct ga_status s = ga_status(c->ga);
	struct params p = best_of(c, s.best);
	struct fit fit = {.misfit = misfit_at(c->misfit, &p),
	    .rmse = misfit_rmse(c->misfit, &p),
	    .feed_misfit = misfit_of_feed(c->misfit),
	    .n_residual = c->misfit->n_residual,
	    .cells = misfit_cells(c->misfit),
	    .stop =
		c->state >= CALIBRATE_TOLERANCE ? c->stop : CALIBRATE_STOPPED,
	    .generations = s.generation,
	    .evaluations = c->evaluations,
	    .hops = c->hops,
	    .edits = c->edits,
	    .edited_at = c->edited_at,
	    .seed = c->options.seed,
	    .site_digest = c->site_digest,
	    .population = c->options.population,
	    .settings = c->options.settings};
	for (size_t j = 0; j < c->misfit->of->n; j++) {
		const struct bounds *b = &c->options.bounds;
		fit.on_bound[j] = sensitivity_on_bound(b, &p, j);
		fit.parameters += b->lower[j] < b->upper[j];
	}
	params_scale(&p);
	fit.flat = flat_direction(c->misfit, &p, &c->options.bounds);
	fit.params = p;
	return fit;
}
