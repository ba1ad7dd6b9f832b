/* validate: compares the model and null models on held-out runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/fit/trials.h"
#include "cmd/ask/fit.h"
#include "cmd/session/invocation.h"
#include "cmd/fit/job.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/outlook.h"
#include "cmd/fit/part.h"
#include "cmd/fit/scores.h"
#include "cmd/lang/table.h"
#include "core/psd/rotor_speed.h"
#include "core/search/misfit.h"

/* The state of one `validate`. at, end: the present site, and the one to stop
 * before; speed: with holdout=each, the speed held out last. */
struct validating {
	bool all, sieves;
	struct part part;
	char *options; /* options on which all parts must agree */
	struct trials runs;
	size_t at, end;
	double speed;
};

static void
free_validation(void *of)
{
	struct validating *c = of;
	trials_clear(&c->runs);
	free(c->options);
	free(c);
}

static void
print_rmse_of_each_run(const struct session *s, const struct trials *found)
{
	for (size_t i = 0; i < found->n; i++) {
		const struct trial *item = &found->item[i];
		const double *rmse = item->v.rmse;
		bool drawn = !isnan(rmse[VALIDATE_CORRECTED]);
		FREED char *rpm =
		    rotor_speed_rpm_text(item->rotor, item->v.speed, NAN);
		session_print_note(s,
		    drawn ? N_("  %s at %s m/s%s: RMSE %.2f points, "
			       "corrected %.2f")
			  : N_("  %s at %s m/s%s: RMSE %.2f points (%.2f "
			       "interpolated)"),
		    item->key, item->name, rpm, 100 * rmse[VALIDATE_MODEL],
		    100 * rmse[drawn ? VALIDATE_CORRECTED
				     : VALIDATE_INTERPOLATION]);
	}
}

static void
show_validation_of_all_sites(struct session *s, const struct validating *c)
{
	const struct trials *runs = &c->runs;
	struct answer *r = scores_build_answer_of_all_sites(runs);
	if (c->part.of > 0) {
		FREED size_t *index = xcalloc(runs->n + 1, sizeof *index);
		for (size_t i = 0; i < runs->n; i++)
			index[i] = runs->item[i].entry;
		part_put_fields_for_collect(
		    r, s, &c->part, index, runs->n, c->options);
		fields_put_values(answer_json_fields(r),
		    "left_out %zu each %zu", runs->left_out,
		    (size_t)runs->each);
		scores_put_rows_for_merging(answer_json_fields(r), runs);
	}
	session_show_answer(s, r);
}

/* True if the site has enough speeds to hold one out. */
static bool
has_speeds_to_hold_out(const struct entry *entry)
{
	return job_count_trainable_speeds(entry->site) >= JOB_FOR_EACH;
}

static bool
has_held_out_run(const struct entry *entry)
{
	bool any = false;
	for (size_t r = 0; r < entry->site->n_run; r++) {
		const struct run *run = &entry->site->run[r];
		any = any || (!entry->train[r] &&
				 misfit_count_covered_sieves(run) > 0);
	}
	return any;
}

/* True if runs of the site can be compared. */
static bool
can_validate_site(
    const struct session *s, const struct validating *c, size_t index)
{
	const struct entry *entry = &s->entry[index];
	if (!part_has_site(&c->part, index))
		return false;
	return c->runs.each ? has_speeds_to_hold_out(entry)
			    : entry->has_fit && has_held_out_run(entry) &&
				  answers_require_params(s, entry, NULL);
}

/* Prepares the next site to compare or, with holdout=each, the next speed to
 * hold out. */
static bool
prepare_next_validation(struct session *s)
{
	struct validating *c = s->job.of;
	for (; c->at < c->end; c->at++, c->speed = 0) {
		const struct site *site = s->entry[c->at].site;
		if (!can_validate_site(s, c, c->at))
			continue;
		s->job.entry = c->at;
		if (!c->runs.each) {
			c->at++;
			return true;
		}
		free(s->job.train);
		s->job.train = xcalloc(site->n_run, sizeof *s->job.train);
		if (job_hold_out_next_speed(site, &c->speed, s->job.train))
			return true;
	}
	return false;
}

/* Compares the runs at the held-out speed with predictions by the task's
 * calibration, which used the other speeds.  Returns NULL if stopped. */
static void *
validate_at_held_out_speed(const struct session *s, const struct job_task *task)
{
	const struct validating *c = s->job.of;
	const struct site *site = s->entry[task->entry].site;
	struct fit fit = calibration_best_fit(task->calibration);
	bool few = fit.cells <= fit.parameters;
	struct posterior_options o = {.use = task->train,
	    .settings = fit.settings,
	    .bounds = *calibration_bounds(task->calibration),
	    .seed = fit.seed,
	    .threads = c->all ? 1 : s->set.threads,
	    .isa = s->isa,
	    .noise = s->set.noise / 100,
	    .speed_sd = s->set.speed_sd / 100,
	    .stop = task->stop};
	struct posterior *posterior =
	    few ? NULL : posterior_new(site, &fit.params, &o);
	if (posterior == NULL && !few)
		return NULL;
	struct validating *found = xcalloc(1, sizeof *found);
	found->runs.one = c->runs.one;
	found->runs.level = c->runs.level;
	trials_add_held_out_runs(&found->runs, s,
	    &(struct predicted_by){task->entry, task->train, fit.params,
		fit.settings, posterior, fit.rmse});
	posterior_free(posterior);
	return found;
}

/* Compares the runs that the calibration of a site held out.  Returns NULL if
 * stopped. */
static void *
validate_held_out_runs_of_site(
    const struct session *s, const struct job_task *task)
{
	if (task->stop != NULL && task->stop())
		return NULL;
	struct posterior *posterior =
	    posterior_new_of_training_runs(s, &s->entry[task->entry]);
	struct validating *found = xcalloc(1, sizeof *found);
	trials_add_held_out_runs_of_site(
	    &found->runs, s, task->entry, posterior);
	posterior_free(posterior);
	return found;
}

static void
append_validation_results(struct session *s)
{
	struct validating *c = s->job.of, *found = s->job.found;
	if (c->all)
		print_rmse_of_each_run(s, &found->runs);
	trials_append_all(&c->runs, &found->runs);
	free_validation(found);
}

static char *
name_of_validation_task(const struct session *s)
{
	const struct validating *c = s->job.of;
	const struct entry *entry = &s->entry[s->job.entry];
	if (!c->runs.each)
		return xasprintf("validate: %s", entry->key);
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, c->speed, NAN);
	return xasprintf(
	    tr("validate: %s without %g m/s%s"), entry->key, c->speed, rpm);
}

static void
show_validation_results(struct session *s, void *of)
{
	struct validating *c = of;
	if (c->all)
		show_validation_of_all_sites(s, c);
	else
		session_show_answer(
		    s, scores_build_answer_of_site(
			   &c->runs, s->entry[c->end - 1].site, c->sieves));
	free_validation(c);
}

static const struct job_type EACH = {.next = prepare_next_validation,
    .take = append_validation_results,
    .end = show_validation_results,
    .drop = free_validation,
    .task_words = name_of_validation_task,
    .useless = N_("stopped before all speeds were predicted"),
    .follow = validate_at_held_out_speed};

static const struct job_type CALIBRATED = {.next = prepare_next_validation,
    .take = append_validation_results,
    .end = show_validation_results,
    .drop = free_validation,
    .task_words = name_of_validation_task,
    .useless = N_("stopped before all sites were compared"),
    .follow = validate_held_out_runs_of_site};

/* True if a part may be empty: those of its sites that can be calibrated have
 * been, and other parts have sites to compare. */
static bool
may_part_of_sites_be_empty(const struct session *s, const struct validating *c)
{
	bool others = false, forgotten = false;
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *entry = &s->entry[i];
		bool able = has_speeds_to_hold_out(entry);
		others = others || able || (entry->has_fit && !c->runs.each);
		forgotten = forgotten || (part_has_site(&c->part, i) &&
					     !entry->has_fit && able);
	}
	return c->part.of > 0 && others && !forgotten;
}

/* Adds the seed and the options of a fit, on which all parts must agree, unless
 * the list has them already. */
static void
append_options_of_fit(char **list, const struct entry *entry)
{
	FREED char *own = xasprintf(" [seed=%llu model=%s %s]",
	    (unsigned long long)entry->fit.seed,
	    breakage_model_of_params(&entry->fit.params)->name, entry->options);
	if (strstr(*list, own) == NULL)
		xappend(list, "%s", own);
}

/* Shows the answer of a part that may be empty; otherwise fails.  refused: the
 * error about the first calibrated site that cannot be compared, if any. */
static bool
show_empty_validation_or_fail(struct session *s, struct validating *c,
    const struct error *refused, struct error *error)
{
	const struct part *part = &c->part;
	if (may_part_of_sites_be_empty(s, c))
		show_validation_of_all_sites(s, c);
	else if (c->runs.each)
		error_set(error, ERROR_DATA,
		    "holdout=each: expected products at three or more speeds, "
		    "so that two are left to calibrate on\n"
		    "measure another speed");
	else if (refused->kind != ERROR_NONE)
		*error = *refused;
	else if (part->of > 0)
		error_set(error, ERROR_USAGE,
		    "no site of part %zu/%zu has both a calibration and a "
		    "held-out run\n"
		    "run 'calibrate all part=%zu/%zu' before it",
		    part->number, part->of, part->number, part->of);
	else
		error_set(error, ERROR_USAGE,
		    "no loaded site has both a calibration and a held-out run\n"
		    "load sites with three speeds, then run 'calibrate', or "
		    "'calibrate all' for all of them");
	free_validation(c);
	return error->kind == ERROR_NONE;
}

/* Starts to compare site after site.  The job owns c.  If the settings do not
 * allow the parameters of some calibrated sites, the answer is about the
 * others, and an error about those follows it. */
static bool
begin_validation_of_sites(
    struct session *s, struct validating *c, struct error *error)
{
	struct error refused = {0};
	size_t n = 0, n_fit = 0, n_refused = 0;
	FREED char *keys = xstrdup(""), *fits = xstrdup("fits");
	const struct job job = {.type = c->runs.each ? &EACH : &CALIBRATED,
	    .of = c,
	    .apart = c->all,
	    .options = job_options_from_settings(s)};
	for (size_t i = c->at; i < c->end; i++) {
		struct error e = {0};
		const struct entry *entry = &s->entry[i];
		bool fit = entry->has_fit && !c->runs.each,
		     compared = can_validate_site(s, c, i);
		if (!part_has_site(&c->part, i))
			continue;
		n_fit += fit;
		if (fit && !answers_require_params(s, entry, &e)) {
			refused = n_refused++ == 0 ? e : refused;
			xappend_to_list(&keys, ", ", "%s", entry->key);
			continue;
		}
		if (fit)
			append_options_of_fit(&fits, entry);
		n += compared;
		c->runs.left_out += !compared;
	}
	c->options = part_common_options_text(
	    s, &job.options, c->runs.each ? "each" : fits);
	if (n_refused > 0 && s->invocation != NULL)
		error_set(&s->invocation->late, refused.kind,
		    "%zu of %zu calibrated sites could not be compared (%s): "
		    "%s\n%s",
		    n_refused, n_fit, keys, refused.text, refused.hint);
	if (n == 0)
		return show_empty_validation_or_fail(s, c, &refused, error);
	session_discard_paused_job(s);
	return job_start(s, &job);
}

static bool
validate_current_site(
    struct session *s, struct validating *c, struct error *error)
{
	if (!answers_require_params_current_site(s, error))
		return false;
	const struct entry *entry = session_current_site_entry(s);
	trials_add_held_out_runs_of_site(&c->runs, s, s->current,
	    posterior_of_calibration(s, entry, CORRECTION_TRAIN));
	struct answer *r =
	    scores_build_answer_of_site(&c->runs, entry->site, c->sieves);
	struct trust trust = trust_in_answer_or_fit(s, entry, NULL);
	if (entry->has_fit)
		fields_put_values(answer_json_fields(r), "verdict %s",
		    verdict_on_fit(entry, trust.light));
	answers_note_fit_basis_and_trust(s, r, entry, false, trust);
	return session_show_answer(s, r);
}

bool
cmd_validate(struct session *s, const struct args *args, struct error *error)
{
	enum { HOLDOUT_UNTRAINED, HOLDOUT_EACH };
	struct part part = {0};
	bool all = args->n_operand > 0, each = args->holdout == HOLDOUT_EACH;
	if (!part_from_args(args, all, &part, error))
		return false;
	if (all && args->by_sieve)
		return error_set(error, ERROR_USAGE,
		    "validate all: expected no sieves=on; it sums up over the "
		    "sites");
	if (each && !fit_check_settings_allow_model(
			&s->set.model, s->set.model.breakage, error))
		return false;
	struct validating *c = xcalloc(1, sizeof *c);
	*c = (struct validating){.all = all,
	    .at = all ? 0 : s->current,
	    .end = all ? s->n_entry : s->current + 1,
	    .sieves = args->by_sieve,
	    .part = part,
	    .runs = {.one = !all,
		.each = each,
		.level = settings_band_probability(&s->set)}};
	if (all || each)
		return begin_validation_of_sites(s, c, error);
	bool ok = validate_current_site(s, c, error);
	free_validation(c);
	return ok;
}
