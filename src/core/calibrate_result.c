/* What a calibration has found so far, and all of it for a checkpoint.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/calibration.h"

#include <math.h>

#include "base/xalloc.h"
#include "core/sensitivity.h"

/* Batches polished so far; the last of the starts may be a short one. */
static size_t
batches(const struct calibration *c)
{
	size_t starts = c->done < c->n_start ? c->done : c->n_start;
	return (starts + BATCH - 1) / BATCH + (c->done - starts) / BATCH;
}

struct calibrate_status
calibration_status(const struct calibration *c)
{
	struct ga_status s = ga_status(c->ga);
	struct calibrate_status status = {.state = c->state,
	    .generation = s.generation,
	    .step = s.generation + batches(c),
	    .evaluations = c->evaluations,
	    .stall = c->stall,
	    .infinite = s.infinite,
	    .best = fmin(s.best, c->best_misfit),
	    .median = s.median,
	    .worst = s.worst,
	    .starts_done = c->done,
	    .starts = c->n_start,
	    .params = c->state == CALIBRATE_SEARCHING
			  ? calibration_search_best(c)
			  : c->best};
	/* Other bounds, and nothing judged within them yet. */
	if (isinf(status.best) && s.generation > 0)
		status.best = misfit_at(c->misfit, &status.params);
	params_scale(&status.params);
	return status;
}

static bool
visit_params(const struct visit *v, const char *name, struct params *p)
{
	return v->real(v->data, name, p->at, breakage_of(p)->n);
}

static bool
visit_history(struct calibration *c, const struct visit *v, size_t n)
{
	bool ok = true;
	if (n > c->history_room) {
		c->history_room = n;
		c->history = xrealloc(c->history, n, sizeof *c->history);
	}
	c->n_history = n;
	for (size_t i = 0; ok && i < n; i++) {
		struct calibrate_generation *g = &c->history[i];
		double misfit[2] = {g->best, g->median};
		ok = v->real(v->data, "generation", misfit, 2) &&
		     visit_params(v, "best_then", &g->params) &&
		     v->real(v->data, "p10", g->p10, c->misfit->of->n) &&
		     v->real(v->data, "p90", g->p90, c->misfit->of->n);
		g->best = misfit[0];
		g->median = misfit[1];
	}
	return ok;
}

bool
calibration_visit(struct calibration *c, const struct visit *v)
{
	size_t state[2] = {c->state, c->stop};
	size_t whole[9] = {c->stall, c->evaluations, c->n_start, c->done,
	    c->hops, c->fruitless, c->n_history, c->edits, c->edited_at};
	double real[2] = {c->stall_from, c->best_misfit};
	bool ok = ga_visit(c->ga, v) && v->whole(v->data, "state", state, 2) &&
		  v->whole(v->data, "counts", whole, 9) &&
		  v->real(v->data, "levels", real, 2) &&
		  visit_params(v, "kept", &c->best) &&
		  state[0] <= CALIBRATE_STOPPED &&
		  state[1] <= CALIBRATE_STOPPED && whole[2] <= STARTS;
	if (!ok)
		return false;
	c->state = (enum calibrate_state)state[0];
	c->stop = (enum calibrate_state)state[1];
	c->stall = whole[0];
	c->evaluations = whole[1];
	c->n_start = whole[2];
	c->done = whole[3];
	c->hops = whole[4];
	c->fruitless = whole[5];
	c->edits = whole[7];
	c->edited_at = whole[8];
	c->stall_from = real[0];
	c->best_misfit = real[1];
	for (size_t i = 0; ok && i < c->n_start; i++)
		ok = visit_params(v, "start", &c->start[i]);
	/* One generation made one entry. */
	return ok && whole[6] == ga_status(c->ga).generation &&
	       visit_history(c, v, whole[6]);
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
	struct params p = c->state == CALIBRATE_SEARCHING
			      ? calibration_search_best(c)
			      : c->best;
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
