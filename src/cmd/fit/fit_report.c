/* The report on a fit and its fields; history: the generations of a search.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/fit_report.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/asked.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/fit.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/trust_light.h"
#include "cmd/lang/table.h"
#include "core/model/breakage.h"
#include "core/model/selection.h"
#include "core/check/trust.h"
#include "core/check/validate.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

/* Puts the speeds of the training runs or, unless `trained`, of the others. */
static void
put_run_speeds_field(
    struct fields *o, const char *key, const struct entry *entry, bool trained)
{
	struct fields *list = fields_add_list(o, key);
	const struct site *site = entry->site;
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].product.n > 0 && entry->train[r] == trained &&
		    !site_run_repeats_speed(site, r))
			fields_put_values(list, "%g", site->run[r].speed);
}

void
fit_put_fields(struct fields *o, const struct entry *entry, const char *verdict,
    double seconds)
{
	const struct fit *fit = &entry->fit;
	bool poor = fit->rmse > FIT_POOR;
	fields_put_values(o,
	    "seed %llu population %zu generations %zu evaluations %zu",
	    (unsigned long long)fit->seed, fit->population, fit->generations,
	    fit->evaluations);
	if (fit->edits > 0)
		fields_put_values(o, "bounds_edited_at %zu", fit->edited_at);
	fields_put_values(o, "stop %s converged %d misfit %g seconds %g",
	    calibrate_state_name(fit->stop), fit->converged, fit->misfit,
	    seconds);
	if (fit->lowest > 0)
		fields_put_values(o, "lowest_misfit %g", fit->lowest);
	fields_put_values(
	    o, "model %s", breakage_model_of_params(&fit->params)->name);
	fit_put_params_in_json(o, &fit->params);
	put_run_speeds_field(o, "train", entry, true);
	put_run_speeds_field(o, "holdout", entry, false);
	fields_put_values(o,
	    "cells %zu parameters %zu rmse_pct %g verdict %s .poor %g",
	    fit->cells, fit->parameters, fit->rmse * 100, verdict,
	    poor                        ? 1
	    : fit_has_too_few_data(fit) ? NAN
					: 0);
}

/* Says, if nothing breaks, that the parameters fit sampling errors, and whether
 * that is because the feed is finer than the break size. */
static void
note_why_nothing_breaks(struct answer *r, const struct entry *entry)
{
	const double few = 0.05; /* of the feed */
	const struct run *fastest = &entry->site->run[entry->site->n_run - 1];
	double x = params_break_size_by_impacts(
	    &entry->fit.params, &entry->fit.settings, fastest->speed);
	double coarser =
	    isfinite(x) && x > 0 ? 1 - psd_passing(&fastest->feed, x) : x <= 0;
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, fastest->speed, NAN);
	answer_add_sentence(r, ANSWER_REMARK,
	    "RMSE of the unchanged feed %.2f points, of the fit %.2f: the "
	    "parameters fit sampling errors",
	    100 * sqrt(entry->fit.feed_misfit / (double)entry->fit.n_residual),
	    100 * entry->fit.rmse);
	if (coarser < few)
		answer_add_sentence(r, ANSWER_REMARK,
		    "only particles coarser than the break size break; at %g "
		    "m/s%s that is %.3g mm or more, and %.1f %% of the feed is "
		    "coarser",
		    fastest->speed, rpm, units_m_to_mm(x), 100 * coarser);
}

/* Returns the width of a parameter's bounds: 2 for those in the gauge, which
 * are scaled to -1..1. */
static double
width_of_parameter_bounds(
    const struct fit *fit, const struct bounds *bounds, size_t j)
{
	return j < breakage_model_of_params(&fit->params)->gauge
		   ? 2
		   : bounds->upper[j] - bounds->lower[j];
}

/* True if all poorly determined parameters stay within their bounds after
 * the step (sign 1) or its reverse (-1). */
static bool
is_poorly_determined_step_in_bounds(
    const struct fit *fit, const struct bounds *bounds, double sign)
{
	const struct breakage *of = breakage_model_of_params(&fit->params);
	bool fits = true;
	for (size_t j = of->gauge; j < of->n; j++) {
		double x = fit->params.at[j] +
			   sign * fit->flat.part[j] *
			       width_of_parameter_bounds(fit, bounds, j);
		if (fit_is_param_poorly_determined(fit, j))
			fits = fits && x >= bounds->lower[j] &&
			       x <= bounds->upper[j];
	}
	return fits;
}

/* list: the parameters with their steps.  both: the bounds also allow the
 * reverse of the step. */
static void
add_undetermined_params_note(
    struct answer *r, const char *list, bool several, bool both)
{
	answer_add_sentence(r, ANSWER_REMARK,
	    several && both
		? N_("poorly determined combination: changing %s together (or "
		     "all reversed) raises the misfit by only 10 %%; rely on "
		     "the curves, not on single parameters")
	    : several
		? N_("poorly determined combination: changing %s together "
		     "raises the misfit by only 10 %%; rely on the curves, "
		     "not on single parameters")
	    : both ? N_("poorly determined: changing %s or the reverse raises "
			"the misfit by only 10 %%; rely on the curves, not on "
			"single parameters")
		   : N_("poorly determined: changing %s raises the misfit by "
			"only 10 %%; rely on the curves, not on single "
			"parameters"),
	    list);
}

/* Names the parameters that can move far together while the misfit rises by
 * only a tenth, each with its step, in a direction that the bounds allow.  If
 * the steps leave the bounds in both directions, says that the data hardly
 * constrain them. */
static void
note_undetermined_parameters(
    struct answer *r, const struct fit *fit, const struct bounds *bounds)
{
	FREED char *list = xstrdup("");
	size_t n = 0;
	bool ahead = is_poorly_determined_step_in_bounds(fit, bounds, 1),
	     back = is_poorly_determined_step_in_bounds(fit, bounds, -1);
	bool silent = fit->flat.reach > 1 || (!ahead && !back);
	const struct breakage *of = breakage_model_of_params(&fit->params);
	for (size_t j = 0; j < of->n; j++) {
		if (!fit_is_param_poorly_determined(fit, j))
			continue;
		if (silent)
			xappend_to_list(
			    &list, ", ", "%s", of->parameter[j].name);
		else
			xappend_to_list(&list, ", ", tr("%s by %+.2g"),
			    of->parameter[j].name,
			    (ahead ? 1 : -1) * fit->flat.part[j] *
				width_of_parameter_bounds(fit, bounds, j));
		n++;
	}
	if (silent)
		answer_add_sentence(r, ANSWER_REMARK,
		    "poorly determined: the data hardly constrain %s; rely on "
		    "the curves, not on single parameters",
		    list);
	else if (n > 0)
		add_undetermined_params_note(r, list, n > 1, ahead && back);
}

/* Adds warnings and remarks about data that the fit does not explain. */
static void
add_warnings_of_fit(struct answer *r, const struct entry *entry)
{
	const struct fit *fit = &entry->fit;
	if (fit->rmse <= FIT_POOR && !fit_has_too_few_data(fit) &&
	    fit_has_no_breakage(entry))
		note_why_nothing_breaks(r, entry);
	struct validation far =
	    trust_find_outlier_cell(entry->site, entry->train, &entry->fit);
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, far.speed, NAN);
	if (far.worst_difference != 0)
		answer_add_sentence(r, ANSWER_WARNING,
		    "the product at %g m/s%s%s differs by %.1f points from the "
		    "fit at %g mm: run 'check'",
		    far.speed, entry->site->run[far.run].repeat, rpm,
		    100 * fabs(far.worst_difference),
		    units_m_to_mm(far.worst_sieve));
	double own, mean;
	if (trust_are_feeds_misleading(entry->site, fit, &own, &mean))
		answer_add_sentence(r, ANSWER_REMARK,
		    "the products do not follow the feeds sampled with them: "
		    "with the feed of each the model misses by %.2f points on "
		    "average, with the mean of all feeds by %.2f; were samples "
		    "of the feed too small, or mixed up?",
		    100 * own, 100 * mean);
}

static const char *
why_search_stopped(const struct fit *fit)
{
	switch (fit->stop) {
	case CALIBRATE_TOLERANCE:
		return tr("the population converged: median misfit within the "
			  "tolerance of the best");
	case CALIBRATE_STALLED:
		return tr(
		    "the search stalled: the best misfit no longer improved");
	case CALIBRATE_GENERATIONS:
		return tr("the generation limit was reached");
	default:
		return tr("interrupted; the best so far is kept");
	}
}

/* Adds a row for each parameter, with its range if there are draws. */
static void
add_parameter_rows(struct answer *r, const struct session *s,
    const struct fit *fit, const struct posterior *u,
    const struct bounds *bounds)
{
	const struct breakage *of = breakage_model_of_params(&fit->params);
	answer_add_columns(r, "parameter, value");
	if (u != NULL)
		answer_add_columns(r, "low, high");
	answer_add_columns(r, "unit, lower, upper, remark");
	for (size_t j = 0; j < of->n; j++) {
		bool fixed = bounds->lower[j] >= bounds->upper[j];
		answer_add_cells(
		    r, "%s %.4f", of->parameter[j].name, fit->params.at[j]);
		if (u != NULL) {
			double range[2];
			param_band_from_posterior(u, s, &fit->params, j, range);
			answer_add_cells(r, "%.4f %.4f", range[0], range[1]);
		}
		answer_add_cells(r, "%s %g %g %s", of->parameter[j].unit,
		    bounds->lower[j], bounds->upper[j],
		    fixed              ? tr("held fixed")
		    : fit->on_bound[j] ? tr("at bound")
		    : j < of->gauge    ? tr("scaled to max 1")
				       : "");
	}
}

/* For a search without polish, notes how far above the lowest misfit it
 * ended. */
static void
note_misfit_above_lowest(struct answer *r, const struct fit *fit)
{
	if (!(fit->lowest > 0))
		return;
	double above = 100 * (fit->misfit / fit->lowest - 1);
	if (above >= 0.1)
		answer_add_sentence(r, ANSWER_REMARK,
		    "the search alone ends %.*f %% above the lowest misfit, "
		    "%.4g: 'calibrate' finds it",
		    above < 10 ? 1 : 0, above, fit->lowest);
	else
		answer_add_sentence(r, ANSWER_REMARK,
		    "the search alone ends at the lowest misfit: 'calibrate' "
		    "finds no lower one");
}

static void
note_bounds_edited(struct answer *r, const struct fit *fit)
{
	if (fit->edits > 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    fit->edits > 1
			? N_("the bounds were edited after generation %zu and "
			     "before: a script written by 'save' repeats "
			     "that, calibrate alone does not")
			: N_("the bounds were edited after generation %zu: a "
			     "script written by 'save' repeats that, "
			     "calibrate alone does not"),
		    fit->edited_at);
}

/* Adds notes on the misfit, on how the search went, and on parameters that are
 * poorly determined. */
static void
add_calibration_search_notes(
    struct answer *r, const struct entry *entry, const struct bounds *bounds)
{
	const struct fit *fit = &entry->fit;
	answer_note(r,
	    tr_n("misfit %.6g (sum of squared residuals), RMSE %.2f points "
		 "over %zu passings; %zu of these can change by crushing, and "
		 "%zu parameter was fitted to them",
		"misfit %.6g (sum of squared residuals), RMSE %.2f points over "
		"%zu passings; %zu of these can change by crushing, and %zu "
		"parameters were fitted to them",
		fit->parameters),
	    fit->misfit, 100 * fit->rmse, fit->n_residual, fit->cells,
	    fit->parameters);
	answer_note(r, "stopped after %zu generations, %zu evaluations: %s",
	    fit->generations, fit->evaluations, why_search_stopped(fit));
	note_misfit_above_lowest(r, fit);
	note_bounds_edited(r, fit);
	add_warnings_of_fit(r, entry);
	note_undetermined_parameters(r, fit, bounds);
}

/* Notes how to test a fit for which no speed was held out. */
static void
note_how_to_test_fit(struct answer *r, const struct entry *entry)
{
	size_t speeds = site_count_speeds(entry->site, entry->train);
	answer_note(r,
	    speeds > 2    ? N_("no speed was held out: 'validate holdout=each' "
				  "tests the model")
	    : speeds == 2 ? N_("no speed was held out: measure a third speed "
			       "to test the model")
			  : N_("no speed was held out: measure two more speeds "
			       "to test the model"));
}

/* Notes the quality of the fit, and its error at the held-out speeds or how to
 * test it. */
static void
add_fit_summary(
    struct answer *r, const struct entry *entry, const char *verdict)
{
	const struct fit *fit = &entry->fit;
	bool of_fit = strchr(verdict, ' ') == NULL;
	FREED char *held =
	    session_speeds_of_runs_text(entry->site, ", ", entry->train, false);
	FREED char *rpm =
	    session_rpm_of_runs_in_brackets(entry->site, entry->train, false);
	double holdout = fit_largest_holdout_rmse(entry);
	FREED char *words = xasprintf(
	    of_fit ? tr("%s fit: misses its products by %.2f points on average")
		   : tr("%s: misses its products by %.2f points on average"),
	    verdict, 100 * fit->rmse);
	if (isfinite(holdout))
		xappend_to_list(&words, "; ",
		    strchr(held, ',') != NULL
			? tr("at %s m/s%s, kept as a check, by up to %.2f")
			: tr("at %s m/s%s, kept as a check, by %.2f"),
		    held, rpm, 100 * holdout);
	answer_note(r, "%s", words);
	if (isnan(holdout))
		note_how_to_test_fit(r, entry);
}

/* Returns the report for calibrate detail=on or show fit (`command`), with the
 * parameters and the course of the search. */
static struct answer *
build_detailed_fit_report(const struct session *s, const struct entry *entry,
    const struct bounds *bounds, double seconds, const char *command)
{
	const struct posterior *u = posterior_even_if_correction_off(s, entry);
	struct answer *r = answer_new_about_site(
	    entry->site, command, "calibrated parameters");
	struct fields *o = answer_json_fields(r);
	add_parameter_rows(r, s, &entry->fit, u, bounds);
	add_calibration_search_notes(r, entry, bounds);
	if (strcmp(command, "show") == 0)
		fields_put_values(o, "what %s", "fit");
	struct trust trust = trust_in_answer_or_fit(s, entry, NULL);
	fit_put_fields(o, entry, verdict_on_fit(entry, trust.light), seconds);
	answers_note_fit_basis_and_trust(s, r, entry, u != NULL, trust);
	fit_put_param_bands(o, s, u, &entry->fit.params);
	return r;
}

struct former
fitted_answer_to_last_question(
    const struct session *s, const struct entry *entry)
{
	const struct last_asked *asked = &s->last_asked;
	bool mean = s->set.feed[0] == '\0' || strcmp(s->set.feed, "mean") == 0;
	if (!entry->has_fit || !mean || session_is_calibrating(s))
		return (struct former){0};
	double speed =
	    asked->speed > 0 ? asked->speed : answers_default_speed(entry);
	struct former former = {.speed = speed, .of = asked->of};
	const struct question q =
	    question_of_whole_product(s, entry, SITE_MEAN_FEED);
	if (!asked->named) {
		struct prediction p = forecast_product(s, &q, speed);
		former.of = answers_default_passing_quantity(&p.product);
		prediction_free(&p);
	}
	former.value = forecast_quantity_at_speed(s, &q, &former.of, speed);
	return former;
}

/* Notes the new answer to what was last asked about, and the answer before this
 * calibration. */
static void
note_change_of_answer(
    struct answer *r, const struct session *s, const struct entry *entry)
{
	const struct former *was = &s->job.former;
	if (!(was->speed > 0))
		return;
	const struct question q =
	    question_of_whole_product(s, entry, SITE_MEAN_FEED);
	double value = forecast_quantity_at_speed(s, &q, &was->of, was->speed);
	FREED char *words = quantities_sentence_with_value(&was->of, value);
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, was->speed, NAN);
	bool all = correction_in_use(s, entry) == CORRECTION_ALL;
	bool checks = all && isfinite(fit_largest_holdout_rmse(entry));
	if (isfinite(value) && isfinite(was->value))
		answer_note(r,
		    checks ? N_("at %.*f m/s%s %s, corrected by all measured "
				"runs, including those kept as a check; before "
				"this calibration %.*f")
		    : all  ? N_("at %.*f m/s%s %s, with all measured runs; "
				 "before this calibration %.*f")
			   : N_("at %.*f m/s%s %s; before this calibration "
				 "%.*f"),
		    units_speed_decimals(was->speed), was->speed, rpm, words,
		    quantities_decimals(&was->of),
		    quantities_value_in_shown_unit(&was->of, was->value));
}

struct answer *
fit_build_report(const struct session *s, const struct entry *entry,
    const struct bounds *bounds, double seconds, bool detail)
{
	if (detail)
		return build_detailed_fit_report(
		    s, entry, bounds, seconds, "calibrate");
	const struct fit *fit = &entry->fit;
	const struct posterior *u = posterior_even_if_correction_off(s, entry);
	FREED char *speeds =
	    session_speeds_of_runs_text(entry->site, ", ", entry->train, true);
	FREED char *rpm =
	    session_rpm_of_runs_in_brackets(entry->site, entry->train, true);
	FREED char *next =
	    speed_text_in_typed_unit(entry->site, answers_default_speed(entry));
	struct answer *r = answer_new_about_site(
	    entry->site, "calibrate", "calibrated on %s m/s%s", speeds, rpm);
	answer_begin_table_for_programs(r);
	add_parameter_rows(r, s, fit, u, bounds);
	struct trust trust = trust_in_answer_or_fit(s, entry, NULL);
	const char *verdict = verdict_on_fit(entry, trust.light);
	add_fit_summary(r, entry, verdict);
	note_change_of_answer(r, s, entry);
	note_misfit_above_lowest(r, fit);
	note_bounds_edited(r, fit);
	add_warnings_of_fit(r, entry);
	fit_put_fields(answer_json_fields(r), entry, verdict, seconds);
	answers_note_fit_basis_and_trust(s, r, entry, false, trust);
	if (trust.light == LIGHT_RED)
		answer_note(r, "next: 'check' looks for faults in the sheet");
	else if (fit_has_no_breakage(entry))
		answer_note(r, "next: 'show feed' and 'show product' have "
			       "the curves");
	else
		answer_note(r,
		    "next: 'predict %s', or any speed; 'show fit' "
		    "has the parameters",
		    next);
	fit_put_param_bands(answer_json_fields(r), s, u, &fit->params);
	return r;
}

bool
show_fit(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	const struct entry *entry = session_current_site_entry(s);
	if (!entry->has_fit || entry->history == NULL)
		return error_set(error, ERROR_USAGE,
		    "%s has not been calibrated in this session\n"
		    "run 'calibrate' first",
		    entry->site->name);
	return session_show_answer(
	    s, build_detailed_fit_report(
		   s, entry, &entry->history->bounds, NAN, "show"));
}

/* The number of rows that fit on a screen below the heading of a table. */
enum { ROWS = 18 };

static void
add_search_generation_row(
    struct answer *r, const struct history *h, size_t i, bool exact)
{
	const struct calibrate_generation *g = &h->generation[i];
	answer_add_cells(
	    r, "%g %.6f %.6f", (double)(i + 1), g->best, g->median);
	for (size_t j = 0; j < breakage_model_of_params(&g->params)->n; j++) {
		double range = h->bounds.upper[j] - h->bounds.lower[j];
		double spread = g->p90[j] - g->p10[j];
		if (exact)
			answer_add_cells(r, "%g %g %g", g->params.at[j],
			    g->p10[j], g->p90[j]);
		else
			answer_add_cells(
			    r, "%.1f", range > 0 ? 100 * spread / range : 0.0);
	}
}

static void
add_search_generation_rows(
    struct answer *r, const struct history *h, size_t step, bool exact)
{
	const struct breakage *of =
	    breakage_model_of_params(&h->generation[0].params);
	answer_add_columns(r, "generation: gen, best, median");
	for (size_t j = 0; j < of->n; j++) {
		const char *name = of->parameter[j].name;
		answer_add_columns(r,
		    exact ? "%s, %s_p10, %s_p90" : "%s_p90: %s", name, name,
		    name);
	}
	for (size_t i = 0; i < h->n; i++)
		if (i % step == 0 || i + 1 == h->n)
			add_search_generation_row(r, h, i, exact);
}

bool
cmd_history(struct session *s, const struct args *args, struct error *error)
{
	const struct entry *entry = session_current_site_entry(s);
	const struct history *h = entry->history;
	if (h == NULL || h->n == 0)
		return error_set(error, ERROR_USAGE,
		    "%s has not been calibrated in this session\n"
		    "run 'calibrate' first",
		    entry->site->name);
	size_t step =
	    args->every > 0 ? (size_t)args->every : (h->n + ROWS - 1) / ROWS;
	struct answer *r = answer_new_about_site(
	    entry->site, "history", "%zu generations", h->n);
	add_search_generation_rows(r, h, step, false);
	answer_begin_table_for_programs(r);
	add_search_generation_rows(r, h, step, true);
	answer_add_rows_as_json_objects(r, "rows");
	answer_add_sentence(r, ANSWER_REMARK,
	    "best and median misfit of the search, then the spread of each "
	    "parameter in %% of its bounds");
	answers_note_fit_basis_and_trust(
	    s, r, entry, false, trust_in_answer_or_fit(s, entry, NULL));
	if (entry->fit.edits > 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    entry->fit.edits > 1
			? N_("the bounds were edited after generation %zu and "
			     "before: earlier spreads are in %% of the edited "
			     "bounds")
			: N_("the bounds were edited after generation %zu: "
			     "earlier spreads are in %% of the edited bounds"),
		    entry->fit.edited_at);
	return session_show_answer(s, r);
}
