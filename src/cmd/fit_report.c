/* The table of a fit and its fields; history: the generations of the search.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit_report.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/band.h"
#include "cmd/outlook.h"
#include "cmd/fit.h"
#include "cmd/table.h"
#include "core/breakage.h"
#include "core/validate.h"
#include "io/units.h"

/* The speeds that were trained on, or the others. */
static void
put_speeds(
    struct fields *o, const char *key, const struct entry *entry, bool trained)
{
	struct fields *list = fields_list(o, key);
	const struct site *site = entry->site;
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].product.n > 0 && entry->train[r] == trained &&
		    !site_run_repeats(site, r))
			fields_put(list, "%g", site->run[r].speed);
}

void
fit_put(struct fields *o, const struct entry *entry, double seconds)
{
	const struct fit *fit = &entry->fit;
	bool poor = fit->rmse > FIT_POOR;
	fields_put(o,
	    "seed %llu population %zu generations %zu evaluations %zu",
	    (unsigned long long)fit->seed, fit->population, fit->generations,
	    fit->evaluations);
	if (fit->edits > 0)
		fields_put(o, "bounds_edited_at %zu", fit->edited_at);
	fields_put(o, "stop %s converged %d misfit %g seconds %g",
	    calibrate_state_name(fit->stop), fit->converged, fit->misfit,
	    seconds);
	fields_put(o, "model %s", breakage_of(&fit->params)->name);
	fit_put_params(o, &fit->params);
	put_speeds(o, "train", entry, true);
	put_speeds(o, "holdout", entry, false);
	fields_put(o,
	    "cells %zu parameters %zu rmse_pct %g verdict %s .poor %g",
	    fit->cells, fit->parameters, fit->rmse * 100, fit_verdict(fit),
	    poor               ? 1
	    : fit_too_few(fit) ? NAN
			       : 0);
}

/* Why nothing breaks, in terms of the break size and the feed. */
static void
explain_nothing(struct answer *r, const struct entry *entry)
{
	const struct run *fastest = &entry->site->run[entry->site->n_run - 1];
	double x = params_break_size(&entry->fit.params, fastest->speed);
	double coarser =
	    isfinite(x) && x > 0 ? 1 - psd_passing(&fastest->feed, x) : 0;
	answer_say(r, ANSWER_WARNING,
	    "nothing breaks: the products do not differ measurably from the "
	    "feed (RMSE of the unchanged feed %.2f points, of the fit %.2f), "
	    "so the parameters fit sampling error",
	    100 * sqrt(entry->fit.feed_misfit / (double)entry->fit.n_residual),
	    100 * entry->fit.rmse);
	answer_say(r, ANSWER_REMARK,
	    "only particles coarser than the break size break; at %g m/s that "
	    "is %.3g mm or more, and %.1f %% of the feed is coarser: measure "
	    "with a coarser feed or a higher speed",
	    fastest->speed, units_mm(x), 100 * coarser);
}

/* The range of a parameter: that of its bounds, of the gauge's scaled to 1. */
static double
range_of(const struct fit *fit, const struct bounds *bounds, size_t j)
{
	return j < breakage_of(&fit->params)->gauge
		   ? 2
		   : bounds->upper[j] - bounds->lower[j];
}

/* Whether all poorly determined parameters stay within their bounds with the
 * step as it is (sign 1) or reversed (-1). */
static bool
step_fits(const struct fit *fit, const struct bounds *bounds, double sign)
{
	const struct breakage *of = breakage_of(&fit->params);
	bool fits = true;
	for (size_t j = of->gauge; j < of->n; j++) {
		double x = fit->params.at[j] +
			   sign * fit->flat.part[j] * range_of(fit, bounds, j);
		if (fit_is_flat(fit, j))
			fits = fits && x >= bounds->lower[j] &&
			       x <= bounds->upper[j];
	}
	return fits;
}

/* Names the parameters that can go far together for a tenth more misfit, each
 * with its step, in a direction that the bounds allow.  Steps beyond the bounds
 * either way say no more than that the data are silent. */
static void
add_flat(struct answer *r, const struct fit *fit, const struct bounds *bounds)
{
	char *list = xstrdup("");
	size_t n = 0;
	bool ahead = step_fits(fit, bounds, 1),
	     back = step_fits(fit, bounds, -1);
	bool silent = fit->flat.reach > 1 || (!ahead && !back);
	const struct breakage *of = breakage_of(&fit->params);
	for (size_t j = 0; j < of->n; j++) {
		if (!fit_is_flat(fit, j))
			continue;
		xlist(&list, ", ", "%s", of->parameter[j].name);
		if (!silent)
			xappend(&list, " by %+.2g",
			    (ahead ? 1 : -1) * fit->flat.part[j] *
				range_of(fit, bounds, j));
		n++;
	}
	if (silent)
		answer_say(r, ANSWER_REMARK,
		    "poorly determined: the data hardly constrain %s; rely on "
		    "the curves, not on single parameters",
		    list);
	else if (n > 0)
		answer_say(r, ANSWER_REMARK,
		    "poorly determined%s: changing %s%s%s raises the misfit by "
		    "only 10 %%; rely on the curves, not on single parameters",
		    n > 1 ? " combination" : "", list, n > 1 ? " together" : "",
		    !ahead || !back ? ""
		    : n > 1         ? " (or all reversed)"
				    : " or the reverse");
	free(list);
}

static void
add_verdict(struct answer *r, const struct session *s,
    const struct entry *entry, const struct bounds *bounds, bool ranges)
{
	const struct fit *fit = &entry->fit;
	if (fit->rmse > FIT_POOR)
		answer_say(r, ANSWER_WARNING,
		    "poor fit: RMSE %.1f points on the training products, "
		    "where repeat samples agree within 0.5 to 1: do not rely "
		    "on predictions; check the data with 'check'",
		    100 * fit->rmse);
	else if (!fit_too_few(fit) && fit_breaks_nothing(fit))
		explain_nothing(r, entry);
	if (fit_too_few(fit))
		fit_note_too_few(r, fit);
	if (!fit->converged && fit->stop != CALIBRATE_STOPPED)
		answer_say(r, ANSWER_WARNING,
		    "not converged: the misfit can still fall, so that "
		    "another seed may give other parameters; compare the "
		    "curves of several seeds");
	struct validation far = fit_outlier(entry);
	if (far.worst_difference != 0)
		answer_say(r, ANSWER_WARNING,
		    "the product at %g m/s%s differs by %.1f points from the "
		    "fit at %g mm: run 'check'",
		    far.speed, entry->site->run[far.run].repeat,
		    100 * fabs(far.worst_difference),
		    units_mm(far.worst_sieve));
	for (size_t j = 0; j < breakage_of(&fit->params)->n; j++)
		if (fit->on_bound[j])
			answer_say(r, ANSWER_REMARK,
			    "%s is at its bound: the bound, not the data, "
			    "sets it",
			    breakage_of(&fit->params)->parameter[j].name);
	add_flat(r, fit, bounds);
	if (ranges)
		band_note(r, s, entry, false);
}

static const char *
stop_sentence(const struct fit *fit)
{
	switch (fit->stop) {
	case CALIBRATE_TOLERANCE:
		return "the population converged: median misfit within the "
		       "tolerance of the best";
	case CALIBRATE_STALLED:
		return "the search stalled: the best misfit no longer improved";
	case CALIBRATE_GENERATIONS:
		return "the generation limit was reached";
	default:
		return "interrupted; the best so far is kept";
	}
}

static void
add_range(struct answer *r, const struct session *s, const struct posterior *u,
    const struct params *p, size_t j)
{
	double range[2];
	band_parameter(u, s, p, j, range);
	answer_cells(r, "%.4f %.4f", range[0], range[1]);
}

struct answer *
fit_answer(const struct session *s, const struct entry *entry,
    const struct bounds *bounds, double seconds)
{
	const struct fit *fit = &entry->fit;
	const struct posterior *u = outlook_draws(s, entry);
	const struct breakage *of = breakage_of(&fit->params);
	struct answer *r = answers_new(entry->site, "calibrate",
	    "calibrated parameters%s%s", of != BREAKAGES[0] ? " of " : "",
	    of != BREAKAGES[0] ? of->name : "");
	answer_columns(r, "parameter, value");
	if (u != NULL)
		answer_columns(r, "low, high");
	answer_columns(r, "unit, lower, upper, remark");
	for (size_t j = 0; j < of->n; j++) {
		bool fixed = bounds->lower[j] >= bounds->upper[j];
		answer_cells(
		    r, "%s %.4f", of->parameter[j].name, fit->params.at[j]);
		if (u != NULL)
			add_range(r, s, u, &fit->params, j);
		answer_cells(r, "%s %g %g %s", of->parameter[j].unit,
		    bounds->lower[j], bounds->upper[j],
		    fixed              ? "held fixed"
		    : fit->on_bound[j] ? "at bound"
		    : j < of->gauge    ? "scaled to max 1"
				       : "");
	}
	answer_note(r,
	    "misfit %.6g (sum of squared residuals), RMSE %.2f points over %zu "
	    "passings; %zu of these can change by crushing, and %zu "
	    "parameter%s fitted to them",
	    fit->misfit, 100 * fit->rmse, fit->n_residual, fit->cells,
	    fit->parameters, fit->parameters == 1 ? " was" : "s were");
	answer_note(r, "stopped after %zu generations, %zu evaluations: %s",
	    fit->generations, fit->evaluations, stop_sentence(fit));
	if (fit->edits > 0)
		answer_say(r, ANSWER_REMARK,
		    "the bounds were edited after generation %zu%s: a script "
		    "written by 'save' repeats that, calibrate alone does not",
		    fit->edited_at, fit->edits > 1 ? " and before" : "");
	add_verdict(r, s, entry, bounds, u != NULL);
	fit_put(answer_fields(r), entry, seconds);
	band_put_interval(answer_fields(r), s, u, &fit->params);
	return r;
}

/* Rows that fit a screen with their heading. */
enum { ROWS = 18 };

/* The middle 80 % of the candidates in per cent of the bounds; 0 where a
 * parameter is held fixed. */
static double
spread(const struct history *h, const struct calibrate_generation *g, size_t j)
{
	double range = h->bounds.upper[j] - h->bounds.lower[j];
	return range > 0 ? 100 * (g->p90[j] - g->p10[j]) / range : 0;
}

static void
add_generation_heads(struct answer *r, const struct breakage *of, bool exact)
{
	answer_columns(r, "generation: gen, best, median");
	for (size_t j = 0; j < of->n; j++) {
		const char *name = of->parameter[j].name;
		if (exact)
			answer_columns(
			    r, "%s, %s_p10, %s_p90", name, name, name);
		else
			answer_columns(r, "%s_p90: %s", name, name);
	}
}

static void
add_generation(struct answer *r, const struct history *h, size_t i, bool exact)
{
	const struct calibrate_generation *g = &h->generation[i];
	answer_cells(r, "%g %.6f %.6f", (double)(i + 1), g->best, g->median);
	for (size_t j = 0; j < breakage_of(&g->params)->n; j++) {
		if (exact) {
			answer_cells(r, "%g %g %g", g->params.at[j], g->p10[j],
			    g->p90[j]);
		} else {
			answer_cells(r, "%.1f", spread(h, g, j));
		}
	}
}

static void
add_generations(
    struct answer *r, const struct history *h, size_t step, bool exact)
{
	add_generation_heads(r, breakage_of(&h->generation[0].params), exact);
	for (size_t i = 0; i < h->n; i++)
		if (i % step == 0 || i + 1 == h->n)
			add_generation(r, h, i, exact);
}

bool
cmd_history(struct session *s, const struct args *args, struct error *error)
{
	const struct entry *entry = session_entry(s);
	const struct history *h = entry->history;
	if (h == NULL || h->n == 0)
		return error_set(error, ERROR_USAGE,
		    "%s has not been calibrated in this session\n"
		    "run 'calibrate' first",
		    entry->site->name);
	const struct value *every = args_value(args, "every");
	size_t step =
	    every->given ? (size_t)every->whole : (h->n + ROWS - 1) / ROWS;
	struct answer *r =
	    answers_new(entry->site, "history", "%zu generations", h->n);
	add_generations(r, h, step, false);
	answer_for_programs(r);
	add_generations(r, h, step, true);
	answer_say(r, ANSWER_REMARK,
	    "best and median misfit of the search, then the spread of each "
	    "parameter in %% of its bounds");
	answers_note_worth(s, r, entry);
	if (entry->fit.edits > 0)
		answer_say(r, ANSWER_REMARK,
		    "the bounds were edited after generation %zu%s: earlier "
		    "spreads are in %% of the edited bounds",
		    entry->fit.edited_at,
		    entry->fit.edits > 1 ? " and before" : "");
	return session_answer(s, r);
}
