/* league: compares all breakage models, and null models, on the same runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/fit.h"
#include "cmd/ask/outlook.h"
#include "cmd/fit/job.h"
#include "cmd/fit/scores.h"
#include "cmd/lang/table.h"
#include "core/posterior/discrepancy.h"
#include "core/check/league.h"
#include "core/check/validate.h"

/* Returns the index of the breakage model of a row.  There is a row for each
 * model and, if collision energies are set, a last one for the paper's model
 * with them (D15). */
static size_t
breakage_index_of_model_row(size_t row)
{
	return row < breakage_count_models() ? row : 0;
}

static const char *
model_name_of_league_row(size_t row)
{
	return row < breakage_count_models() ? BREAKAGES[row]->name
					     : "grunditz+energies";
}

/* A model at a site.  fit, parameters, aicc: on the site's training runs.
 * last: its fit on the runs of the present task, which gives models that extend
 * it a starting point.  runs: the held-out runs. */
struct tried_model {
	struct fit fit, last;
	size_t parameters;
	double aicc;
	struct trials runs;
};

/* A site with its models.  each: every speed was held out in turn. */
struct site_models {
	const struct site *site;
	size_t entry;
	bool each;
	size_t n_model;
	struct tried_model *model; /* [n_model] */
};

/* The state of one `league`. at, end: the present site, and the one to stop
 * before.  speed: the speed now held out in turn, 0 before the first.  model:
 * row of the present task. */
struct league {
	bool all;
	size_t n, at, end, model, n_model;
	double speed;
	struct site_models *sites;
};

static void
league_free(void *of)
{
	struct league *l = of;
	for (size_t i = 0; l != NULL && i < l->n; i++) {
		struct site_models *g = &l->sites[i];
		for (size_t m = 0; m < g->n_model; m++)
			trials_clear(&g->model[m].runs);
		free(g->model);
	}
	if (l != NULL)
		free(l->sites);
	free(l);
}

/* Returns the default bounds of a model.  A parameter that the session's model
 * has too gets the session's bounds. */
static struct bounds
param_bounds_of_model(const struct session *s, size_t model)
{
	struct bounds b = bounds_default(model);
	const struct breakage *set = BREAKAGES[s->set.model.breakage];
	for (size_t i = 0; i < set->n; i++) {
		size_t j = breakage_parameter_index(
		    BREAKAGES[model], set->parameter[i].name);
		if (j == BREAKAGES[model]->n)
			continue;
		b.lower[j] = s->set.bounds.lower[i];
		b.upper[j] = s->set.bounds.upper[i];
	}
	return b;
}

/* Sets up the task's model.  It starts from the fit of the best model that it
 * extends, if any. */
static bool
prepare_fit_of_model(struct session *s)
{
	const struct league *l = s->job.of;
	const struct tried_model *tried = l->sites[l->n - 1].model;
	struct calibrate_options *o = &s->job.options;
	const struct fit *from = NULL;
	bool energies = l->model >= breakage_count_models();
	for (size_t i = 0; i < l->model && !energies; i++)
		if (breakage_is_extension_of(l->model, i) &&
		    (from == NULL || tried[i].last.misfit < from->misfit))
			from = &tried[i].last;
	o->settings.breakage = (unsigned)breakage_index_of_model_row(l->model);
	o->settings.impacts =
	    energies ? s->set.model.impacts : (struct impacts){.n = 0};
	o->bounds =
	    param_bounds_of_model(s, breakage_index_of_model_row(l->model));
	o->start = from != NULL ? &from->params : NULL;
	return true;
}

/* Begins a site, with the training runs of its fit, if any.  Returns false if
 * it has no run to calibrate on. */
static bool
prepare_fits_of_site(struct session *s)
{
	struct league *l = s->job.of;
	const struct entry *entry = &s->entry[l->at];
	const struct site *site = entry->site;
	free(s->job.train);
	s->job.train = xcalloc(site->n_run, sizeof *s->job.train);
	s->job.entry = l->at;
	if (job_mark_training_runs(site, true, s->job.train) == 0)
		return false;
	if (entry->has_fit)
		memcpy(s->job.train, entry->train,
		    site->n_run * sizeof *entry->train);
	else
		job_mark_training_runs(site, false, s->job.train);
	l->sites = xgrow_by_one(l->sites, l->n, sizeof *l->sites);
	l->sites[l->n++] = (struct site_models){.site = site,
	    .entry = l->at,
	    .n_model = l->n_model,
	    .model = xcalloc(l->n_model, sizeof(struct tried_model))};
	return true;
}

/* Begins the next model; after the last, the next speed to hold out, if the
 * site has no held-out run; after the last of those, the next site. */
static bool
begin_next_league_fit(struct session *s)
{
	struct league *l = s->job.of;
	bool first = s->job.calibration == NULL;
	if (!first && ++l->model < l->n_model)
		return prepare_fit_of_model(s);
	l->model = 0;
	struct site_models *g = first ? NULL : &l->sites[l->n - 1];
	if (!first && l->speed == 0)
		g->each = g->model[0].runs.n == 0 &&
			  job_count_trainable_speeds(g->site) >= JOB_FOR_EACH;
	if (!first && g->each &&
	    job_hold_out_next_speed(g->site, &l->speed, s->job.train))
		return prepare_fit_of_model(s);
	l->speed = 0;
	for (l->at += !first; l->at < l->end; l->at++)
		if (prepare_fits_of_site(s))
			return prepare_fit_of_model(s);
	return false;
}

static void
record_model_result_in_league(struct session *s)
{
	struct league *l = s->job.of;
	const struct job *job = &s->job;
	struct site_models *g = &l->sites[l->n - 1];
	struct tried_model *t = &g->model[l->model];
	t->last = calibration_best_fit(job->calibration);
	if (l->speed == 0) {
		t->fit = t->last;
		t->parameters = league_count_fitted_params(
		    &t->fit, calibration_bounds(job->calibration));
		t->aicc =
		    league_aicc(t->fit.misfit, t->fit.cells, t->parameters);
	}
	trials_add_held_out_runs(&t->runs, s,
	    &(struct predicted_by){.entry = g->entry,
		.train = job->train,
		.params = t->last.params,
		.settings = t->last.settings,
		.rmse = t->last.rmse});
}

/* Returns the sampling error of a passing at a site: the residual error of the
 * model that explains the training runs best, but at least 0.1 points; 0.5
 * points if no model has more passings than parameters. */
static double
sampling_error_at_site(const struct site_models *g)
{
	const double least = 0.001, unknown = 0.005;
	double variance = INFINITY;
	for (size_t m = 0; m < g->n_model; m++) {
		const struct tried_model *t = &g->model[m];
		if (t->fit.cells > t->parameters)
			variance = fmin(variance,
			    t->fit.misfit /
				(double)(t->fit.cells - t->parameters));
	}
	return isfinite(variance) ? fmax(sqrt(variance), least) : unknown;
}

/* The verdict on the models [n_model] at one site or at several: their misfits,
 * parameters and AICc summed over the sites, the held-out runs of all sites,
 * and the errors of the null models.  simplest: of the models that remain, the
 * one that the others extend, or else the best.  winner: the null model with
 * the smallest error, if the best model errs by more than sampling explains;
 * otherwise VALIDATE_MODEL.  none: no model remains, because even the best
 * misses the held-out runs. */
struct verdict {
	size_t n, n_run, n_model, cells, best, simplest, *parameters;
	struct league_cell *cell;
	struct league_model *model;
	double *misfit, **predicted, *null[VALIDATE_WAYS];
	double rmse[VALIDATE_WAYS];
	bool can_tell, ranked, none;
	enum validate_way winner;
	/* straight: the share of the straight line in the answer between
	 * measured speeds, 0..1, NAN without draws.  in_use: the model that has
	 * the rest. */
	size_t in_use;
	double straight;
};

static void
verdict_free(struct verdict *v)
{
	for (size_t m = 0; m < v->n_model; m++)
		free(v->predicted[m]);
	for (size_t way = VALIDATE_NULL; way < VALIDATE_WAYS; way++)
		free(v->null[way]);
	free(v->predicted);
	free(v->parameters);
	free(v->cell);
	free(v->model);
	free(v->misfit);
}

/* Adds the passings of a site's held-out runs.  Their sampling error is larger
 * in the middle of a curve than at its ends, in proportion to h (D13). */
static void
add_held_out_passings(struct verdict *v, const struct site_models *g)
{
	const struct trials *runs = &g->model[0].runs;
	double sd = sampling_error_at_site(g), h = 0;
	size_t from = v->n, compared = 0;
	for (size_t r = 0; r < runs->n; r++, v->n_run++) {
		compared += runs->item[r].v.n_sieve - runs->item[r].v.n_idle;
		const struct psd *product = &runs->item[r].run->product;
		size_t n = runs->item[r].v.n_sieve;
		v->cell = xrealloc(v->cell, v->n + n, sizeof *v->cell);
		for (size_t i = 0; i < n; i++)
			v->cell[v->n++] = (struct league_cell){.run = v->n_run,
			    .log_size = log(product->size[i]),
			    .measured = product->passing[i]};
	}
	for (size_t i = from; i < v->n; i++)
		h += pow(discrepancy_scale_at_passing(v->cell[i].measured), 2) /
		     (double)compared;
	for (size_t i = from; i < v->n && h > 0; i++)
		v->cell[i].noise =
		    sd * discrepancy_scale_at_passing(v->cell[i].measured) /
		    sqrt(h);
}

/* Appends what a way predicts for the held-out passings of the runs to passing
 * [n]. */
static void
append_predicted_passings(double **passing, size_t n, const struct trials *runs,
    enum validate_way way)
{
	for (size_t r = 0; r < runs->n; r++) {
		size_t more = runs->item[r].v.n_sieve;
		*passing = xrealloc(*passing, n + more, sizeof **passing);
		memcpy(*passing + n,
		    trials_predicted_passing(&runs->item[r], way),
		    more * sizeof **passing);
		n += more;
	}
}

/* Adds a site.  Its AICc count only if all models have one, unless the verdict
 * is on this site alone. */
static void
add_site_to_model_verdict(
    struct verdict *v, const struct site_models *g, bool alone)
{
	bool counts = true;
	for (size_t m = 0; m < v->n_model; m++)
		counts = counts && (alone || isfinite(g->model[m].aicc));
	for (size_t m = 0; m < v->n_model; m++) {
		const struct tried_model *t = &g->model[m];
		v->misfit[m] += t->fit.misfit;
		v->parameters[m] += t->parameters;
		v->model[m].aicc += counts ? t->aicc : 0;
		append_predicted_passings(
		    &v->predicted[m], v->n, &t->runs, VALIDATE_MODEL);
	}
	for (enum validate_way way = VALIDATE_NULL; way < VALIDATE_WAYS; way++)
		append_predicted_passings(
		    &v->null[way], v->n, &g->model[0].runs, way);
	add_held_out_passings(v, g);
	v->cells += g->model[0].fit.cells;
}

static struct verdict
judge_models_on_sites(const struct site_models *g, size_t n)
{
	size_t models = g->n_model;
	struct verdict v = {.n_model = models,
	    .model = xcalloc(models, sizeof *v.model),
	    .misfit = xcalloc_doubles(models),
	    .parameters = xcalloc(models, sizeof *v.parameters),
	    .predicted = xcalloc(models, sizeof *v.predicted)};
	for (size_t i = 0; i < n; i++)
		add_site_to_model_verdict(&v, &g[i], n == 1);
	for (size_t m = 0; m < models; m++) {
		v.model[m].model = breakage_index_of_model_row(m);
		v.model[m].energies = m >= breakage_count_models();
		v.model[m].predicted = v.predicted[m];
		v.model[m].rmse =
		    league_rmse_over_runs(v.cell, v.n, v.predicted[m]);
	}
	v.can_tell = league_rule_out_models(v.model, models, v.cell, v.n);
	while (v.model[v.best].standing != LEAGUE_BEST)
		v.best++;
	v.simplest = v.best;
	for (size_t m = 0; m < models; m++)
		if (v.model[m].standing == LEAGUE_POSSIBLE &&
		    !v.model[m].energies && !v.model[v.simplest].energies &&
		    breakage_is_extension_of(v.simplest, m))
			v.simplest = m;
	v.ranked = isfinite(v.model[v.best].aicc) || v.n > 0;
	v.none = league_is_prediction_poor(v.cell, v.n, v.predicted[v.best]);
	v.can_tell = v.can_tell && !v.none;
	v.straight = NAN;
	const double *least = v.predicted[v.best];
	for (size_t way = VALIDATE_NULL; way < VALIDATE_WAYS; way++) {
		v.rmse[way] = league_rmse_over_runs(v.cell, v.n, v.null[way]);
		if (!league_is_error_clearly_larger(
			v.cell, v.n, least, v.null[way]))
			continue;
		least = v.null[way];
		v.winner = (enum validate_way)way;
	}
	return v;
}

static const char *const STANDINGS[] = {[LEAGUE_BEST] = N_("best"),
    [LEAGUE_POSSIBLE] = N_("possible"),
    [LEAGUE_OUT_AICC] = N_("out: AICc"),
    [LEAGUE_OUT_ERROR] = N_("out: hold-out")};

/* Returns the null model with the smallest error, if that is smaller than the
 * best model's; otherwise VALIDATE_MODEL. */
static enum validate_way
null_model_beating_best(const struct verdict *v)
{
	double least = v->model[v->best].rmse;
	enum validate_way ahead = VALIDATE_MODEL;
	for (enum validate_way way = VALIDATE_NULL; way < VALIDATE_WAYS;
	     way++) {
		if (!(v->rmse[way] < least))
			continue;
		least = v->rmse[way];
		ahead = way;
	}
	return ahead;
}

/* Returns the standing of a model in words.  Without AICc and hold-out error,
 * or if a null model errs less, no model is called best; if sampling errors do
 * not explain the latter, the best model is "beaten". */
static const char *
standing_of_model_text(const struct verdict *v, size_t m)
{
	enum league_standing standing = v->model[m].standing;
	if (standing == LEAGUE_BEST && v->winner != VALIDATE_MODEL)
		return tr("beaten");
	if (v->none && standing <= LEAGUE_POSSIBLE)
		return tr("misses");
	if (standing == LEAGUE_BEST &&
	    null_model_beating_best(v) != VALIDATE_MODEL)
		standing = LEAGUE_POSSIBLE;
	return tr(STANDINGS[v->ranked ? standing : LEAGUE_POSSIBLE]);
}

/* Returns the share of a model in the answer between measured speeds, %, or NAN
 * without draws. */
static double
model_weight_pct(const struct verdict *v, size_t m)
{
	return isnan(v->straight)
		   ? NAN
		   : 100 * (m == v->in_use ? 1 - v->straight : 0);
}

static void
put_league_fields(struct fields *o, const struct verdict *v)
{
	struct fields *list = fields_add_list(o, "models");
	for (size_t m = 0; m < v->n_model; m++)
		fields_put_values(fields_add_object(list, NULL),
		    "model %s holdout_rmse_pct %g aicc %g misfit %g "
		    "parameters %zu cells %zu standing %s weight_pct %g",
		    model_name_of_league_row(m), 100 * v->model[m].rmse,
		    v->model[m].aicc, v->misfit[m], v->parameters[m], v->cells,
		    standing_of_model_text(v, m), model_weight_pct(v, m));
	put_null_model_rmse(o, v->rmse);
	if (v->ranked)
		fields_put_values(
		    o, "best %s", model_name_of_league_row(v->best));
	fields_put_values(o, "can_tell %d", v->can_tell);
	if (v->can_tell)
		fields_put_values(
		    o, "simplest %s", model_name_of_league_row(v->simplest));
	if (v->winner != VALIDATE_MODEL)
		fields_put_values(
		    o, "beaten_by %s", SCORES_WAYS[v->winner].key);
	if (!isnan(v->straight))
		fields_put_values(
		    o, "interpolation_weight_pct %g", 100 * v->straight);
}

/* Adds a row for each model, then for each null model.  programs: add the
 * difference in AICc from the best model, for which the table for people has no
 * room. */
static void
add_model_rows(struct answer *r, const struct verdict *v, bool programs)
{
	bool weights = !isnan(v->straight);
	double least = v->model[v->best].aicc;
	answer_add_columns(r, "model, parameters: free, misfit, aicc: AICc");
	if (programs)
		answer_add_columns(r, "above_best");
	answer_add_columns(r, "holdout_rmse_pct: hold-out, standing");
	if (weights)
		answer_add_columns(r, "weight_pct: share");
	for (size_t m = 0; m < v->n_model; m++) {
		answer_add_cells(r, "%s %g %.5f %.1f",
		    model_name_of_league_row(m), (double)v->parameters[m],
		    v->misfit[m], v->model[m].aicc);
		if (programs)
			answer_add_cells(r, "%.1f", v->model[m].aicc - least);
		answer_add_cells(r, "%.2f %s", 100 * v->model[m].rmse,
		    standing_of_model_text(v, m));
		if (weights)
			answer_add_cells(r, "%.0f", model_weight_pct(v, m));
	}
	for (size_t way = VALIDATE_NULL; way < VALIDATE_WAYS; way++) {
		answer_add_cells(r, "%s %g %.5f %.1f", tr(SCORES_WAYS[way].key),
		    NAN, NAN, NAN);
		if (programs)
			answer_add_cells(r, "%.1f", NAN);
		answer_add_cells(
		    r, "%.2f %s", 100 * v->rmse[way], tr("no model"));
		if (weights)
			answer_add_cells(r, "%.0f",
			    way == VALIDATE_INTERPOLATION ? 100 * v->straight
							  : 0.0);
	}
}

/* Returns "grunditz, vogel": the models whose standing is within from..to. */
static char *
model_names_in_standing_range(
    const struct verdict *v, enum league_standing from, enum league_standing to)
{
	char *list = xstrdup("");
	for (size_t m = 0; m < v->n_model; m++)
		if (v->model[m].standing >= from && v->model[m].standing <= to)
			xappend_to_list(
			    &list, ", ", "%s", model_name_of_league_row(m));
	return list;
}

static void
note_best_model(struct answer *r, const struct verdict *v)
{
	FREED char *open =
	    model_names_in_standing_range(v, LEAGUE_POSSIBLE, LEAGUE_POSSIBLE);
	FREED char *out =
	    model_names_in_standing_range(v, LEAGUE_OUT_AICC, LEAGUE_OUT_ERROR);
	const char *best = model_name_of_league_row(v->best);
	if (v->none)
		answer_add_sentence(r, ANSWER_WARNING,
		    "none of these describes this rock: the best, %s, misses "
		    "the runs left out by %.1f points",
		    best, 100 * v->model[v->best].rmse);
	else if (v->can_tell)
		answer_note(r,
		    open[0] ? N_("the data can tell the models apart: %s and "
				 "its extensions remain")
			    : N_("the data can tell the models apart: %s "
				 "remains"),
		    model_name_of_league_row(v->simplest));
	else if (!v->ranked)
		answer_note(r, "the data cannot rank the models: no AICc and "
			       "no hold-out error");
	else if (open[0] != '\0')
		answer_note(r,
		    tr_n("the data cannot tell the models apart: besides %s, "
			 "%s is also possible",
			"the data cannot tell the models apart: besides %s, %s "
			"are also possible",
			strchr(open, ',') != NULL ? 2 : 1),
		    best, open);
	if (out[0] != '\0' && !v->none &&
	    (v->can_tell || (v->ranked && open[0] != '\0')))
		answer_note(r, "ruled out: %s", out);
	if (v->winner != VALIDATE_MODEL)
		answer_add_sentence(r, ANSWER_WARNING,
		    "no model is best: %s predicts the held-out runs better "
		    "than the first of them, %s: RMSE %.2f against %.2f points",
		    tr(SCORES_WAYS[v->winner].noun), best,
		    100 * v->rmse[v->winner], 100 * v->model[v->best].rmse);
}

static void
note_how_to_read_league(
    struct answer *r, const struct verdict *v, bool each, bool alone)
{
	if (v->n > 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    "ranked by the hold-out error, and by AICc among those "
		    "within 0.1 points");
	answer_add_sentence(r, ANSWER_REMARK,
	    "ruled out: AICc more than 10 above the best and no smaller "
	    "hold-out error; or a hold-out error larger by 0.1 points and "
	    "twice what sampling explains");
	if (v->n == 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    "no run was held out, and there are fewer than three "
		    "speeds: no hold-out error");
	else if (each && alone)
		answer_add_sentence(r, ANSWER_REMARK,
		    "hold-out: each speed in turn, calibrated on the others; "
		    "AICc: all runs");
	for (size_t m = 0; m < v->n_model; m++)
		if (isnan(v->model[m].aicc)) {
			answer_add_sentence(r, ANSWER_REMARK,
			    "no AICc: it needs two more passings than "
			    "parameters, counting the variance; %s has %zu and "
			    "%zu",
			    model_name_of_league_row(m), v->cells,
			    v->parameters[m] + 1);
			break;
		}
}

static bool
has_products_at_one_speed(const struct site *site)
{
	double speed = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		if (site->run[r].product.n == 0)
			continue;
		if (speed > 0 && site->run[r].speed != speed)
			return false;
		speed = site->run[r].speed;
	}
	return true;
}

/* Returns the row of the model that answers use. */
static size_t
row_of_model_in_use(const struct session *s, const struct site_models *g)
{
	const struct entry *entry = &s->entry[g->entry];
	size_t breakage =
	    entry->has_params ? entry->params.breakage : s->set.model.breakage;
	bool energies = breakage == 0 && s->set.model.impacts.n > 0 &&
			g->n_model > breakage_count_models();
	return energies ? breakage_count_models() : breakage;
}

/* Notes the model in use, and how to change it, to the best if it is ruled
 * out. */
static void
note_model_in_use(struct answer *r, const struct session *s,
    const struct site_models *g, const struct verdict *v)
{
	size_t used = row_of_model_in_use(s, g);
	const char *name = model_name_of_league_row(used);
	bool out = v->ranked && !v->none && used < v->n_model &&
		   v->model[used].standing >= LEAGUE_OUT_AICC;
	fields_put_values(answer_json_fields(r), "in_use %s", name);
	if (out && v->winner == VALIDATE_MODEL && !v->model[v->best].energies)
		answer_add_sentence(r, ANSWER_REMARK,
		    "answers use %s, which is ruled out; 'set model %s', then "
		    "'calibrate', for the best",
		    name, model_name_of_league_row(v->best));
	else
		answer_add_sentence(r, ANSWER_REMARK,
		    "answers use %s; 'set model NAME', then 'calibrate', for "
		    "another",
		    name);
}

/* Sets the shares of the model in use and of the straight line in the site's
 * answers, if there are draws. */
static void
set_shares_of_model_and_line(
    struct verdict *v, const struct session *s, const struct site_models *g)
{
	const struct entry *entry = &s->entry[g->entry];
	const struct posterior *p =
	    correction_in_use(s, entry) == CORRECTION_OFF
		? NULL
		: posterior_for_unseen_cuts(s, entry, false);
	if (p == NULL)
		return;
	v->in_use = row_of_model_in_use(s, g);
	v->straight = p->straight;
}

static void
note_share_of_model_and_line(struct answer *r, const struct verdict *v)
{
	if (isnan(v->straight))
		return;
	answer_add_sentence(r, ANSWER_REMARK,
	    "share: between two measured speeds the answer is %.0f %% %s, "
	    "corrected, and %.0f %% the straight line; elsewhere it is all %s",
	    model_weight_pct(v, v->in_use), model_name_of_league_row(v->in_use),
	    100 * v->straight, model_name_of_league_row(v->in_use));
}

static struct answer *
build_league_answer_of_site(
    const struct session *s, const struct site_models *g)
{
	struct verdict v = judge_models_on_sites(g, 1);
	set_shares_of_model_and_line(&v, s, g);
	struct answer *r = answer_new_about_site(
	    g->site, "league", "breakage models compared");
	add_model_rows(r, &v, false);
	answer_begin_table_for_programs(r);
	add_model_rows(r, &v, true);
	note_best_model(r, &v);
	if (has_products_at_one_speed(g->site))
		answer_add_sentence(r, ANSWER_WARNING,
		    "all products are from one speed: this compares how the "
		    "models fit one curve, not how they describe the effect of "
		    "the speed");
	note_model_in_use(r, s, g, &v);
	note_share_of_model_and_line(r, &v);
	note_how_to_read_league(r, &v, g->each, true);
	put_league_fields(answer_json_fields(r), &v);
	if (g->each)
		fields_put_values(
		    answer_json_fields(r), "holdout_each %d", true);
	verdict_free(&v);
	return r;
}

/* Adds the cells of a site, or of all sites, after its name. */
static void
add_model_verdict_cells(struct answer *r, const struct verdict *v)
{
	FREED char *open = v->none ? xstrdup("")
				   : model_names_in_standing_range(
					 v, LEAGUE_POSSIBLE, LEAGUE_POSSIBLE);
	enum validate_way ahead = null_model_beating_best(v);
	answer_add_cells(r, "%s %.2f %.2f %s",
	    ahead != VALIDATE_MODEL ? tr(SCORES_WAYS[ahead].key)
	    : v->none               ? tr("none")
				    : model_name_of_league_row(v->best),
	    100 * v->model[v->best].rmse, 100 * v->rmse[VALIDATE_INTERPOLATION],
	    v->can_tell ? tr("yes") : tr("no"));
	answer_add_text_cell(r, "%s", open);
}

/* Adds a row to the table for people and to that for programs, in which each
 * site has the source of its own data.  The first row brings the columns. */
static void
add_league_row_of_site(struct answer *r, bool first, const char *key,
    const char *source, const struct verdict *v)
{
	for (int programs = 0; programs < 2; programs++) {
		if (programs)
			answer_begin_table_for_programs(r);
		else
			answer_resume_table_for_people(r);
		if (first) {
			answer_add_column(r, "site", "site");
			if (programs)
				answer_add_column(
				    r, "provenance", "provenance");
			answer_add_columns(r,
			    "best, holdout_rmse_pct: hold-out RMSE, "
			    "interpolation_pct: interpolation, "
			    "can_tell: can tell, possible: also possible");
		}
		answer_add_cells(r, "%s", key);
		if (programs)
			answer_add_cells(r, "%s", source);
		add_model_verdict_cells(r, v);
	}
}

/* Adds a row for each site and one for all of them. */
static struct answer *
build_league_answer_of_all_sites(
    const struct session *s, const struct league *l)
{
	struct answer *r = answer_new("league");
	struct fields *sites = fields_add_list(answer_json_fields(r), "sites");
	struct sources all = {0};
	answer_set_title(r,
	    tr_n("breakage models compared, %zu site",
		"breakage models compared, %zu sites", l->n),
	    l->n);
	for (size_t i = 0; i < l->n; i++) {
		const struct site_models *g = &l->sites[i];
		const char *key = s->entry[g->entry].key;
		FREED char *source = site_provenance_first_clause(
		    g->site, "provenance not stated");
		struct verdict v = judge_models_on_sites(g, 1);
		struct fields *own = fields_add_object(sites, NULL);
		fields_put_values(own, "site %s key %s", g->site->name, key);
		put_league_fields(own, &v);
		fields_put_values(own, "provenance %s", source);
		sources_add(&all, key, source);
		add_league_row_of_site(r, i == 0, key, source, &v);
		verdict_free(&v);
	}
	FREED char *about = sources_text_and_clear(&all);
	struct verdict v = judge_models_on_sites(l->sites, l->n);
	add_league_row_of_site(r, l->n == 0, "all", about, &v);
	put_league_fields(answer_json_fields(r), &v);
	note_best_model(r, &v);
	note_how_to_read_league(r, &v, false, false);
	verdict_free(&v);
	answer_set_site_names(r, "all", about);
	return r;
}

static void
show_league_and_free(struct session *s, void *of)
{
	struct league *l = of;
	session_show_answer(
	    s, l->all ? build_league_answer_of_all_sites(s, l)
		      : build_league_answer_of_site(s, &l->sites[0]));
	league_free(l);
}

static char *
league_calibration_text(const struct session *s)
{
	const struct league *l = s->job.of;
	const char *key = s->entry[s->job.entry].key;
	const char *model = model_name_of_league_row(l->model);
	return l->speed > 0 ? xasprintf(tr("league: %s, model %s without %g "
					   "m/s"),
				  key, model, l->speed)
			    : xasprintf(tr("league: %s, model %s"), key, model);
}

static const struct job_type LEAGUE = {.next = begin_next_league_fit,
    .take = record_model_result_in_league,
    .end = show_league_and_free,
    .drop = league_free,
    .task_words = league_calibration_text,
    .useless = N_("stopped before all models were calibrated")};

bool
cmd_league(struct session *s, const struct args *args, struct error *error)
{
	bool all = args->n_operand > 0;
	if (all && strcmp(args->operand[0], "all") != 0)
		return error_set(error, ERROR_USAGE,
		    "league: expected all or nothing, got '%s'",
		    args->operand[0]);
	for (size_t m = 0; m < breakage_count_models(); m++)
		if (!fit_check_settings_allow_model(&s->set.model, m, error))
			return false;
	struct league *l = xcalloc(1, sizeof *l);
	*l = (struct league){.all = all,
	    .n_model = breakage_count_models() + (s->set.model.impacts.n > 0),
	    .at = all ? 0 : s->current,
	    .end = all ? s->n_entry : s->current + 1};
	session_discard_paused_job(s);
	const struct job job = {
	    .type = &LEAGUE, .of = l, .options = job_options_from_settings(s)};
	return job_start(s, &job) ||
	       error_set(error, ERROR_DATA,
		   all ? N_("no loaded site has a product to calibrate on")
		       : N_("%s has no product to calibrate on\n"
			    "measure a product at two speeds or more"),
		   session_current_site_entry(s)->site->name);
}
