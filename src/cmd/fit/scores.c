/* Makes the answer on one site, run by run; that on many sites, with bias, RMS
 * and R2 of each size (validate_score) and how often each way is best; and the
 * rows that carry runs from parts to collect.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/scores.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/fit/job.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

const struct scores_way SCORES_WAYS[VALIDATE_WAYS] = {
    [VALIDATE_MODEL] = {"model", N_("model"), N_("the model")},
    [VALIDATE_CORRECTED] = {"corrected", N_("corrected"),
	N_("the model corrected by the runs")},
    [VALIDATE_INTERPOLATION] = {N_("interpolation"), N_("interpolated"),
	N_("a straight line through the training products")},
    [VALIDATE_NEAREST] = {"nearest", N_("nearest"),
	N_("the product at the nearest training speed"), 1},
    [VALIDATE_FEED] = {"feed", N_("feed"), N_("the unchanged feed"), 2}};

void
put_null_model_rmse(struct fields *o, const double rmse[static VALIDATE_WAYS])
{
	struct fields *null = fields_add_object(o, "null");
	for (size_t way = VALIDATE_NULL; way < VALIDATE_WAYS; way++) {
		FREED char *key =
		    xasprintf("%s_rmse_pct", SCORES_WAYS[way].key);
		fields_put_number(null, key, 100 * rmse[way]);
	}
}

/* Computes the root mean square over the runs of the RMSE of each way. */
static void
rmse_of_prediction_ways(
    const struct trials *c, double rmse[static VALIDATE_WAYS])
{
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		double sum = 0;
		for (size_t i = 0; i < c->n; i++)
			sum += pow(c->item[i].v.rmse[way], 2);
		rmse[way] = sqrt(sum / (double)c->n);
	}
}

static void
put_null_rmse_and_winner(
    struct fields *o, const double rmse[static VALIDATE_WAYS])
{
	put_null_model_rmse(o, rmse);
	fields_put_values(
	    o, "winner %s", SCORES_WAYS[validate_way_of_least_rmse(rmse)].key);
}

static void
put_run_p_size_fields(struct fields *o, const struct validation *v)
{
	for (size_t i = 0; i < PSD_SIZES; i++) {
		struct fields *size = fields_add_object(o, PSD_KEY[i]);
		fields_put_values(size,
		    "measured_mm %g predicted_mm %g corrected_mm %g",
		    1000 * v->measured[i], 1000 * v->size[VALIDATE_MODEL][i],
		    1000 * v->size[VALIDATE_CORRECTED][i]);
		for (size_t way = VALIDATE_NULL; way < VALIDATE_WAYS; way++) {
			FREED char *key =
			    xasprintf("%s_mm", SCORES_WAYS[way].key);
			fields_put_number(size, key, 1000 * v->size[way][i]);
		}
	}
}

static void
put_run_sieve_fields(struct fields *o, const struct trial *item)
{
	const struct psd *product = &item->run->product;
	size_t n = item->v.n_sieve;
	fields_put_numbers(o, "sieve_mm", product->size, n, units_m_to_mm);
	fields_put_numbers(
	    o, "measured_pct", product->passing, n, units_fraction_to_pct);
	for (enum validate_way way = 0; way < VALIDATE_WAYS; way++) {
		FREED char *key = xasprintf("%s_pct", SCORES_WAYS[way].key);
		fields_put_numbers(o, key, trials_predicted_passing(item, way),
		    n, units_fraction_to_pct);
	}
}

static void
put_held_out_run_fields(struct fields *o, const struct trial *item)
{
	const struct validation *v = &item->v;
	fields_put_number(o, "speed", v->speed);
	if (item->run->repeat[0] != '\0')
		fields_put_values(o, "run %s", item->name);
	fields_put_number(o, "rmse_pct", 100 * v->rmse[VALIDATE_MODEL]);
	fields_put_number(
	    o, "corrected_rmse_pct", 100 * v->rmse[VALIDATE_CORRECTED]);
	if (item->has_band)
		fields_put_number(o, "within", (double)item->within);
	put_run_p_size_fields(o, v);
	put_null_rmse_and_winner(o, v->rmse);
	fields_put_values(o, "loses_to_interpolation %d nearest_mps %g",
	    validation_is_interpolation_better(v), v->nearest);
	fields_put_numbers(o, "interpolation_mps", v->line, 2, NULL);
	put_run_sieve_fields(o, item);
}

static void
put_validation_fields(struct fields *o, const struct trials *c)
{
	struct fields *list = fields_add_list(o, "holdout");
	double rmse[VALIDATE_WAYS];
	for (size_t i = 0; i < c->n; i++)
		put_held_out_run_fields(
		    fields_add_object(list, NULL), &c->item[i]);
	if (c->each)
		fields_put_values(o, "holdout_each %d", true);
	if (c->n == 0)
		return;
	rmse_of_prediction_ways(c, rmse);
	o = fields_add_object(o, "overall");
	fields_put_number(o, "rmse_pct", 100 * rmse[VALIDATE_MODEL]);
	fields_put_number(
	    o, "corrected_rmse_pct", 100 * rmse[VALIDATE_CORRECTED]);
	put_null_rmse_and_winner(o, rmse);
}

/* Begins a row with the name of the run.  exact: with its speed before it.
 * Otherwise in rpm if its sheet is in rpm, or with the rpm after it if the
 * rotor is known. */
static void
begin_row_of_run(struct answer *r, const struct trial *item, bool exact)
{
	if (exact)
		answer_add_cells(r, "%g", item->v.speed);
	double rpm = rotor_speed_to_rpm(item->v.speed, item->rotor);
	if (!exact && item->in_rpm) {
		answer_add_text_cell(r, "%.0f%s", rpm, item->run->repeat);
		return;
	}
	answer_add_text_cell(r, "%s", item->name);
	if (!exact && item->rotor > 0)
		answer_add_cells(r, "%.0f", rpm);
}

static void
add_validation_sieve_rows(
    struct answer *r, const struct trial *item, bool exact)
{
	const struct psd *product = &item->run->product;
	answer_set_missing_text(r, "-");
	for (size_t i = 0; i < item->v.n_sieve; i++) {
		begin_row_of_run(r, item, exact);
		if (exact)
			answer_add_cells(
			    r, "%g", units_m_to_mm(product->size[i]));
		else
			answer_add_text_cell(
			    r, "%g mm, %%", units_m_to_mm(product->size[i]));
		answer_add_cells(
		    r, "%.1f", units_fraction_to_pct(product->passing[i]));
		for (enum validate_way way = 0; way < VALIDATE_WAYS; way++)
			answer_add_cells(r, "%.1f",
			    units_fraction_to_pct(
				trials_predicted_passing(item, way)[i]));
	}
}

static void
add_rmse_cells(struct answer *r, const double *rmse)
{
	answer_add_text_cell(r, "error, points");
	answer_set_missing_text(r, "-");
	answer_add_cells(r, "%.2f", NAN);
	for (size_t way = 0; way < VALIDATE_WAYS; way++)
		answer_add_cells(r, "%.2f", 100 * rmse[way]);
}

static void
add_p_size_rows_of_run(struct answer *r, const struct trial *item, bool exact)
{
	const struct validation *v = &item->v;
	answer_set_missing_text(r, "outside");
	for (size_t i = 0; i < PSD_SIZES; i++) {
		begin_row_of_run(r, item, exact);
		answer_add_text_cell(
		    r, exact ? "P%.0f" : N_("P%.0f mm"), 100 * PSD_PASSING[i]);
		answer_add_cells(r, "%.3f", 1000 * v->measured[i]);
		for (size_t way = 0; way < VALIDATE_WAYS; way++)
			answer_add_cells(r, "%.3f", 1000 * v->size[way][i]);
	}
}

/* exact: adds a table for programs, of sieves or of sizes.  Otherwise adds one
 * for people, of sizes and RMSE and, if `sieves`, of sieves. */
static void
add_validation_table(
    struct answer *r, const struct trials *c, bool sieves, bool exact)
{
	const char *unit = !exact ? "" : sieves ? "_pct" : "_mm";
	bool in_rpm = !exact && c->n > 0 && c->item[0].in_rpm;
	bool both = !exact && c->n > 0 && c->item[0].rotor > 0;
	answer_add_columns(r, in_rpm   ? N_("speed: rpm, of: ")
			      : both   ? N_("speed: m/s, rpm: rpm, of: ")
			      : !exact ? N_("speed: m/s, of: ")
			      : sieves ? N_("speed, run, sieve_mm")
				       : N_("speed, run, size"));
	answer_add_columns(r, "measured%s: measured", unit);
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		FREED char *key = xasprintf("%s%s", SCORES_WAYS[way].key, unit);
		answer_add_optional_column(
		    r, key, tr(SCORES_WAYS[way].head), SCORES_WAYS[way].spare);
	}
	for (size_t i = 0; i < c->n; i++) {
		const struct trial *item = &c->item[i];
		if (sieves)
			add_validation_sieve_rows(r, item, exact);
		if (!exact) {
			begin_row_of_run(r, item, exact);
			add_rmse_cells(r, item->v.rmse);
		}
		if (!exact || !sieves)
			add_p_size_rows_of_run(r, item, exact);
	}
}

/* Differences in RMSE, passing 0..1, beyond this exceed sampling errors. */
static const double CLEAR_GAP = 0.001;

/* Returns the RMSE of all sieves but the worst, passing 0..1. */
static double
rmse_without_worst_sieve(const struct validation *v)
{
	double n = (double)(v->n_sieve - v->n_idle);
	double square = v->misfit - v->worst_difference * v->worst_difference;
	return sqrt(fmax(square, 0) / (n - 1));
}

/* The way that predicts best.  worse: it is neither the model nor the corrected
 * answer.  clearly: the difference exceeds sampling errors. */
struct winner {
	enum validate_way best;
	bool worse, clearly;
};

static struct winner
find_best_prediction_way(const double rmse[static VALIDATE_WAYS])
{
	enum validate_way best = validate_way_of_least_rmse(rmse);
	double corrected = rmse[VALIDATE_CORRECTED];
	double own =
	    fmin(rmse[VALIDATE_MODEL], isnan(corrected) ? INFINITY : corrected);
	bool worse = best >= VALIDATE_NULL;
	return (struct winner){.best = best,
	    .worse = worse,
	    .clearly = worse && own > 1.1 * rmse[best] &&
		       own - rmse[best] > CLEAR_GAP};
}

/* Returns a speed to type, between the run and the slower training speed, where
 * nothing was measured: in whole m/s if possible or, for a sheet in rpm, in
 * whole rpm. */
static char *
speed_text_between_runs(const struct trial *item)
{
	const struct validation *v = &item->v;
	double middle = (v->line[0] + v->speed) / 2, whole = round(middle);
	if (item->in_rpm)
		return xasprintf(
		    "%.0f rpm", rotor_speed_to_rpm(middle, item->rotor));
	return xasprintf(
	    "%g", whole > v->line[0] && whole < v->speed ? whole : middle);
}

/* Warns if a null model predicts a run clearly better. */
static void
warn_if_null_model_is_better(
    struct answer *r, const struct trial *item, const char *run)
{
	const struct validation *v = &item->v;
	struct winner w = find_best_prediction_way(v->rmse);
	FREED char *who = xstrdup(tr(SCORES_WAYS[w.best].noun));
	if (!w.clearly)
		return;
	FREED char *near = rotor_speed_rpm_text(item->rotor, v->nearest, NAN);
	if (w.best == VALIDATE_NEAREST)
		xappend(&who, ", %g m/s%s", v->nearest, near);
	FREED char *words =
	    xasprintf(tr("at %s the model errs more than %s"), run, who);
	FREED char *between = speed_text_between_runs(item);
	if (w.best == VALIDATE_INTERPOLATION && !validation_is_extrapolated(v))
		xappend(&words, tr(": 'predict %s interpolated=on' shows both"),
		    between);
	answer_add_sentence(r, ANSWER_WARNING, "%s", words);
}

/* Notes which way predicts best over all runs. */
static void
note_best_way_to_predict(struct answer *r, const struct trials *c)
{
	double rmse[VALIDATE_WAYS];
	rmse_of_prediction_ways(c, rmse);
	struct winner w = find_best_prediction_way(rmse);
	FREED char *who = xstrdup(tr(SCORES_WAYS[w.best].noun));
	bool one = c->n == 1, some = isnan(rmse[VALIDATE_INTERPOLATION]);
	const struct trial *first = &c->item[0];
	FREED char *rpm =
	    rotor_speed_rpm_text(first->rotor, first->v.speed, NAN);
	FREED char *near =
	    rotor_speed_rpm_text(first->rotor, first->v.nearest, NAN);
	if (one && w.best == VALIDATE_NEAREST)
		xappend(&who, ", %g m/s%s", first->v.nearest, near);
	FREED char *where = one ? xasprintf(tr("at %s m/s%s"), first->name, rpm)
				: xstrdup(tr("in all"));
	if (!w.worse)
		answer_note(r,
		    some ? N_("%s: %s predicts best of those with an answer "
			      "on all sieves")
			 : N_("%s: %s predicts best"),
		    where, who);
	else if (!w.clearly)
		answer_add_sentence(r, ANSWER_REMARK,
		    "%s: the model predicts no better than %s; the difference "
		    "is too small to be seen above the sampling error",
		    where, who);
	else if (!one)
		answer_add_sentence(r, ANSWER_REMARK,
		    "in all: the model errs more than %s", who);
}

/* Notes why there is no interpolation, or that it is an extrapolation. */
static void
note_why_not_interpolated(struct answer *r, const struct trial *item)
{
	const struct validation *v = &item->v;
	FREED char *line =
	    rotor_speed_rpm_text(item->rotor, v->line[0], v->line[1]);
	if (isnan(v->rmse[VALIDATE_INTERPOLATION]))
		answer_add_sentence(r, ANSWER_REMARK,
		    isnan(v->line[1])
			? N_("  no interpolation: there is one training speed")
			: N_("  no interpolation: a training product lacks "
			     "some of these sieves"));
	else if (validation_is_extrapolated(v))
		answer_add_sentence(r, ANSWER_REMARK,
		    "  interpolation extrapolates here: the line through %g "
		    "and %g m/s%s",
		    v->line[0], v->line[1], line);
}

/* Returns a sentence on the sieve at which the corrected answer or, without
 * draws, the model errs most.  sampled: the prediction is from the run's own
 * feed. */
static char *
worst_sieve_words(const struct trial *item, const char *run, bool sampled)
{
	const struct validation *v = &item->v;
	const struct psd *product = &item->run->product;
	bool corrected = isfinite(v->rmse[VALIDATE_CORRECTED]);
	const double *passing = trials_predicted_passing(
	    item, corrected ? VALIDATE_CORRECTED : VALIDATE_MODEL);
	size_t worst = 0;
	psd_rms_difference(passing, product->passing, v->n_sieve, &worst);
	double off = passing[worst] - product->passing[worst];
	const char *who = corrected ? tr("the answer of the other runs")
				    : tr("the model alone");
	return xasprintf(off > 0 ? tr("at %s%s: at worst %s lets %.2f points "
				      "too many pass %g mm")
				 : tr("at %s%s: at worst %s lets %.2f points "
				      "too few pass %g mm"),
	    run, sampled ? tr(", with the feed sampled there") : "", who,
	    100 * fabs(off), units_m_to_mm(product->size[worst]));
}

static void
note_error_at_held_out_run(
    struct answer *r, const struct trials *c, size_t i, bool own_feeds)
{
	const struct trial *item = &c->item[i];
	bool sampled = own_feeds && !item->run->lacks_feed;
	const struct validation *v = &item->v;
	FREED char *rpm = rotor_speed_rpm_text(item->rotor, v->speed, NAN);
	FREED char *run =
	    xasprintf("%g m/s%s%s", v->speed, item->run->repeat, rpm);
	FREED char *words = worst_sieve_words(item, run, sampled);
	if (item->has_band)
		xappend_to_list(&words, "; ",
		    tr("%zu of %zu sieves lie in the %.0f %% band for a "
		       "sample"),
		    item->within, v->n_sieve - v->n_idle, 100 * c->level);
	answer_note(r, "%s", words);
	warn_if_null_model_is_better(r, item, run);
	if (c->n == 1)
		note_best_way_to_predict(r, c);
	if (item->open)
		answer_add_sentence(r, ANSWER_REMARK,
		    "  no band: the fit is poor, and two speeds do not show "
		    "how its error changes with the speed");
	note_why_not_interpolated(r, item);
	/* An error that far exceeds those of the other sieves suggests a typing
	 * error: an error of the model shows on several sieves. */
	const double times = 4, least = 0.03;
	double worst = fabs(v->worst_difference),
	       others = rmse_without_worst_sieve(v);
	if (v->n_sieve - v->n_idle > 3 && worst > least &&
	    worst > times * others)
		answer_add_sentence(r, ANSWER_REMARK,
		    "  %g mm stands out (the other sieves: %.2f points on "
		    "average): check that cell",
		    units_m_to_mm(v->worst_sieve), 100 * others);
	if (v->n_left_out > 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    "  finer sieves are not compared: the feed was not sieved "
		    "so fine");
}

struct answer *
scores_build_answer_of_site(
    const struct trials *c, const struct site *site, bool sieves)
{
	double rmse[VALIDATE_WAYS];
	struct answer *r = answer_new_about_site(site, "validate", "%s",
	    c->each ? tr("each speed held out, calibrated on the others")
		    : tr("speeds kept as a check, measured and predicted"));
	add_validation_table(r, c, sieves, false);
	if (c->n > 1) {
		rmse_of_prediction_ways(c, rmse);
		answer_add_text_cell(r, "all");
		answer_set_missing_text(r, "");
		if (site->rotor > 0 && !c->item[0].in_rpm)
			answer_add_cells(r, "%.0f", NAN);
		add_rmse_cells(r, rmse);
	}
	answer_begin_table_for_programs(r);
	add_validation_table(r, c, sieves, true);
	for (size_t i = 0; i < c->n; i++)
		note_error_at_held_out_run(r, c, i, site->individual_feeds);
	if (c->n > 1)
		note_best_way_to_predict(r, c);
	if (c->n == 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    job_count_trainable_speeds(site) < JOB_FOR_EACH
			? N_("no run was held out; sample another speed to "
			     "test the model")
			: N_("no run was held out: 'validate holdout=each' "
			     "holds out each speed in turn"));
	put_validation_fields(answer_json_fields(r), c);
	return r;
}

/* Puts the bias, the RMS and the R2 of a size. */
static void
put_size_score_fields(struct fields *o, size_t i, struct validate_score score)
{
	fields_put_values(fields_add_object(o, PSD_KEY[i]),
	    "n %zu bias_pct %g rms_pct %g r2 %g", score.n, 100 * score.bias,
	    100 * score.rms, score.r2);
}

static void
add_prediction_score_rows(struct answer *r, const struct trials *c)
{
	struct fields *o = answer_json_fields(r), *null = NULL;
	answer_add_columns(r,
	    "size, by: predicted by, n: runs, bias_pct: bias %%, "
	    "rms_pct: rms %%, r2: R2");
	for (size_t i = 0; i < PSD_SIZES; i++)
		for (enum validate_way way = 0; way < VALIDATE_WAYS; way++) {
			struct validate_score score =
			    trials_score_at_size(c, way, i);
			answer_add_text_cell(r, "P%.0f", 100 * PSD_PASSING[i]);
			answer_add_keyed_cell(
			    r, SCORES_WAYS[way].key, tr(SCORES_WAYS[way].key));
			answer_add_cells(r, "%g %.2f %.2f %.4f",
			    (double)score.n, 100 * score.bias, 100 * score.rms,
			    score.r2);
			if (way == VALIDATE_MODEL)
				put_size_score_fields(o, i, score);
		}
	struct fields *corrected = fields_add_object(o, "corrected");
	for (size_t i = 0; i < PSD_SIZES; i++)
		put_size_score_fields(corrected, i,
		    trials_score_at_size(c, VALIDATE_CORRECTED, i));
	null = fields_add_object(o, "null");
	for (enum validate_way way = VALIDATE_NULL; way < VALIDATE_WAYS;
	     way++) {
		struct fields *own =
		    fields_add_object(null, SCORES_WAYS[way].key);
		for (size_t i = 0; i < PSD_SIZES; i++)
			put_size_score_fields(
			    own, i, trials_score_at_size(c, way, i));
	}
}

static void
note_runs_won_by_prediction_way(struct answer *r, const struct trials *c)
{
	size_t wins[VALIDATE_WAYS] = {0};
	struct fields *o = fields_add_object(answer_json_fields(r), "wins");
	FREED char *list = xstrdup("");
	for (size_t k = 0; k < c->n; k++)
		wins[validate_way_of_least_rmse(c->item[k].v.rmse)]++;
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		fields_put_number(o, SCORES_WAYS[way].key, (double)wins[way]);
		xappend_to_list(&list, ", ", "%s %zu",
		    tr(SCORES_WAYS[way].noun), wins[way]);
	}
	answer_note(
	    r, "best at how many of the %zu runs (RMSE): %s", c->n, list);
}

struct answer *
scores_build_answer_of_all_sites(const struct trials *c)
{
	struct answer *r = answer_new("validate");
	size_t sites;
	FREED char *about = trials_data_sources_text(c, &sites);
	answer_set_title(r,
	    c->each
		? tr_n("sizes at each speed held out in turn, %zu site",
		      "sizes at each speed held out in turn, %zu sites", sites)
		: tr_n("sizes at held-out speeds, %zu site",
		      "sizes at held-out speeds, %zu sites", sites),
	    sites);
	answer_set_site_names(r, "all", about);
	fields_put_values(
	    answer_json_fields(r), "sites %zu runs %zu", sites, c->n);
	add_prediction_score_rows(r, c);
	note_runs_won_by_prediction_way(r, c);
	if (c->each)
		fields_put_values(
		    answer_json_fields(r), "holdout_each %d", true);
	if (c->left_out > 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    c->each ? tr_n("%zu loaded site with fewer than three "
				   "speeds: not compared",
				  "%zu loaded sites with fewer than three "
				  "speeds: not compared",
				  c->left_out)
			    : tr_n("%zu loaded site without a calibration or a "
				   "held-out run: not compared",
				  "%zu loaded sites without a calibration or a "
				  "held-out run: not compared",
				  c->left_out),
		    c->left_out);
	return r;
}

/* Fills number[] with the addresses of the members of a score, in a fixed
 * order. */
static void
collect_score_number_pointers(
    struct validation *v, double *number[static PART_NUMBERS])
{
	_Static_assert(
	    (int)PART_NUMBERS == PSD_SIZES + VALIDATE_WAYS * (1 + PSD_SIZES),
	    "as many as there are");
	for (size_t i = 0; i < PSD_SIZES; i++)
		*number++ = &v->measured[i];
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		*number++ = &v->rmse[way];
		for (size_t i = 0; i < PSD_SIZES; i++)
			*number++ = &v->size[way][i];
	}
}

void
scores_put_rows_for_merging(struct fields *o, const struct trials *c)
{
	struct fields *list = fields_add_list(o, "rows");
	for (size_t k = 0; k < c->n; k++) {
		struct validation v = c->item[k].v;
		double *at[PART_NUMBERS], number[PART_NUMBERS];
		struct fields *row = fields_add_object(list, NULL);
		collect_score_number_pointers(&v, at);
		for (size_t i = 0; i < PART_NUMBERS; i++)
			number[i] = *at[i];
		fields_put_values(row, "site %s source %s", c->item[k].key,
		    c->item[k].source);
		fields_put_numbers(row, "numbers", number, PART_NUMBERS, NULL);
	}
}

void
scores_add_run_of_part(struct trials *c, const struct part_row *row)
{
	struct trial trial = {.entry = row->index,
	    .key = xstrdup(row->site),
	    .source = xstrdup(row->source)};
	double *at[PART_NUMBERS];
	collect_score_number_pointers(&trial.v, at);
	for (size_t i = 0; i < PART_NUMBERS; i++)
		*at[i] = row->number[i];
	trials_add_trial(c, trial);
}
