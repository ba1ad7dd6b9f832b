/* validate: compares the model and null models on held-out runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
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

/* The state of one `validate`.  at, end, speed: for holdout=each, the present
 * site, the site to stop before, and the speed held out last. */
struct validating {
	bool all, sieves;
	struct part part;
	char *options; /* options that all parts must have */
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

/* Compares the held-out runs of an entry, or counts the entry as left out. */
static void
compare_held_out_runs(const struct session *s, size_t index,
    const struct posterior *posterior, struct trials *c)
{
	size_t before = c->n;
	trials_add_held_out_of_entry(c, s, index, posterior);
	c->left_out += c->n == before;
}

/* Notes the result of each run of a site. */
static void
note_rmse_of_each_run(const struct session *s, const struct trials *found)
{
	for (size_t i = 0; i < found->n; i++) {
		const struct trial *item = &found->item[i];
		const double *rmse = item->v.rmse;
		bool drawn = !isnan(rmse[VALIDATE_CORRECTED]);
		FREED char *rpm =
		    rotor_speed_rpm_text(item->rotor, item->v.speed, NAN);
		session_note(s,
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
show_validation_of_all(struct session *s, const struct validating *c)
{
	const struct trials *runs = &c->runs;
	struct answer *r = scores_all_sites_answer(runs);
	if (c->part.of > 0) {
		FREED size_t *index = xcalloc(runs->n + 1, sizeof *index);
		for (size_t i = 0; i < runs->n; i++)
			index[i] = runs->item[i].entry;
		part_put_collect_fields(
		    r, s, &c->part, index, runs->n, c->options);
		fields_put(answer_fields(r), "left_out %zu each %zu",
		    runs->left_out, (size_t)runs->each);
		scores_put_part_rows(answer_fields(r), runs);
	}
	session_show_answer(s, r);
}

/* Calibrated sites that `validate all` could not compare. */
struct failed {
	size_t n;
	char *keys;
	struct error first;
};

/* Fails after the answer, which is about the other sites. */
static void
set_error_after_answer(struct session *s, struct failed *failed, size_t n)
{
	if (failed->n > 0) {
		struct error e = failed->first;
		error_set(&e, failed->first.kind,
		    "%zu of %zu calibrated sites could not be compared (%s): "
		    "%s\n%s",
		    failed->n, n + failed->n, failed->keys, failed->first.text,
		    failed->first.hint);
		if (s->invocation != NULL)
			s->invocation->late = e;
	}
	free(failed->keys);
}

/* A site that is compared in parallel with others. */
struct compared_site {
	const struct session *s;
	size_t entry;
	bool done; /* false if the user stopped it */
	struct trials found;
};

static void
compare_site_in_thread(void *data, size_t piece, unsigned thread)
{
	struct compared_site *b = &((struct compared_site *)data)[piece];
	const struct session *s = b->s;
	(void)thread;
	if (s->hooks.stop != NULL && s->hooks.stop())
		return;
	struct posterior *p =
	    posterior_of_training_runs(s, &s->entry[b->entry]);
	compare_held_out_runs(s, b->entry, p, &b->found);
	b->done = true;
	posterior_free(p);
}

/* Compares sites [n] in parallel.  Returns false if the user stopped it. */
static bool
compare_sites_in_parallel(
    struct session *s, struct trials *c, const size_t *index, size_t n)
{
	enum { EACH_THREAD = 2 };
	size_t most = EACH_THREAD * s->set.threads;
	FREED struct compared_site *beside = xcalloc(most, sizeof *beside);
	struct pool *pool = pool_new(s->set.threads);
	bool all = true;
	for (size_t from = 0; all && from < n; from += most) {
		size_t m = n - from < most ? n - from : most;
		for (size_t i = 0; i < m; i++)
			beside[i] = (struct compared_site){
			    .s = s, .entry = index[from + i]};
		pool_run(pool, m, compare_site_in_thread, beside);
		for (size_t i = 0; i < m; i++) {
			all = all && beside[i].done;
			note_rmse_of_each_run(s, &beside[i].found);
			trials_append(c, &beside[i].found);
		}
	}
	pool_free(pool);
	return all;
}

/* Lists the calibrated sites of the part in index [n_entry]. */
static size_t
list_calibrated_sites(const struct session *s, struct validating *c,
    size_t *index, struct failed *failed)
{
	size_t n = 0;
	for (size_t i = 0; i < s->n_entry; i++) {
		struct error error = {0};
		if (!part_has_site(&c->part, i))
			continue;
		if (!s->entry[i].has_fit) {
			c->runs.left_out++;
		} else if (answers_require_params(s, &s->entry[i], &error)) {
			index[n++] = i;
		} else {
			if (failed->n++ == 0)
				failed->first = error;
			xappend_to_list(
			    &failed->keys, ", ", "%s", s->entry[i].key);
		}
	}
	return n;
}

/* True if the site has enough speeds to hold one out. */
static bool
has_speeds_to_hold_out(const struct entry *entry)
{
	return job_count_speeds(entry->site) >= JOB_FOR_EACH;
}

/* True if a part may be empty: all of its sites that could be calibrated
 * are, and other parts have sites to compare. */
static bool
may_part_be_empty(const struct session *s, const struct part *part)
{
	bool others = false, forgotten = false;
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *entry = &s->entry[i];
		others =
		    others || entry->has_fit || has_speeds_to_hold_out(entry);
		forgotten =
		    forgotten || (part_has_site(part, i) && !entry->has_fit &&
				     has_speeds_to_hold_out(entry));
	}
	return part->of > 0 && others && !forgotten;
}

/* Returns the seeds and options of the fits, each once: other parts must
 * have the same. */
static char *
seeds_and_options_of_fits(
    const struct session *s, const size_t *index, size_t n)
{
	char *words = xstrdup("fits");
	for (size_t i = 0; i < n; i++) {
		const struct entry *entry = &s->entry[index[i]];
		FREED char *own = xasprintf(" [seed=%llu model=%s %s]",
		    (unsigned long long)entry->fit.seed,
		    breakage_model_of_params(&entry->fit.params)->name,
		    entry->options);
		if (strstr(words, own) == NULL)
			xappend(&words, "%s", own);
	}
	return words;
}

static bool
validate_all_sites(struct session *s, struct validating *c, struct error *error)
{
	struct failed failed = {.keys = xstrdup("")};
	FREED size_t *index = xcalloc(s->n_entry + 1, sizeof *index);
	size_t n = list_calibrated_sites(s, c, index, &failed);
	FREED char *fits = seeds_and_options_of_fits(s, index, n);
	struct calibrate_options o = job_default_options(s);
	bool whole = compare_sites_in_parallel(s, &c->runs, index, n);
	c->options = part_dependencies_text(s, &o, fits);
	if (!whole)
		session_note(s, "stopped before all sites were compared");
	else if (c->runs.n > 0 || may_part_be_empty(s, &c->part))
		show_validation_of_all(s, c);
	else if (failed.n > 0)
		*error = failed.first;
	else if (c->part.of > 0)
		error_set(error, ERROR_USAGE,
		    "no site of part %zu/%zu has both a calibration and a "
		    "held-out run\n"
		    "run 'calibrate all part=%zu/%zu' before it",
		    c->part.number, c->part.of, c->part.number, c->part.of);
	else
		error_set(error, ERROR_USAGE,
		    "no loaded site has both a calibration and a held-out run\n"
		    "load sites with three speeds, then run 'calibrate', or "
		    "'calibrate all' for all of them");
	set_error_after_answer(s, &failed, n);
	return error->kind == ERROR_NONE;
}

static bool
validate_current_site(
    struct session *s, struct validating *c, struct error *error)
{
	if (!answers_require_params_of_current(s, error))
		return false;
	const struct entry *entry = session_current_entry(s);
	compare_held_out_runs(s, s->current,
	    posterior_of_calibration(s, entry, CORRECTION_TRAIN), &c->runs);
	struct answer *r = scores_site_answer(&c->runs, entry->site, c->sieves);
	if (entry->has_fit)
		fields_put(answer_fields(r), "verdict %s",
		    verdict_on_fit(s, entry, NULL));
	answers_show_fit_basis(s, r, entry, false);
	return session_show_answer(s, r);
}

/* Finds the next speed to hold out, at a site that has enough. */
static bool
find_next_held_out_speed(struct session *s)
{
	struct validating *c = s->job.of;
	for (; c->at < c->end; c->at++, c->speed = 0) {
		const struct site *site = s->entry[c->at].site;
		if (!part_has_site(&c->part, c->at))
			continue;
		if (job_count_speeds(site) < JOB_FOR_EACH) {
			c->runs.left_out++;
			continue;
		}
		free(s->job.train);
		s->job.train = xcalloc(site->n_run, sizeof *s->job.train);
		s->job.entry = c->at;
		if (job_hold_out_next_speed(site, &c->speed, s->job.train))
			return true;
	}
	return false;
}

/* Compares the runs at the speed held out with their predictions by a
 * calibration on the other speeds. */
static void *
compare_at_held_out_speed(const struct session *s, const struct job_task *task)
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
	trials_add_held_out_runs(&found->runs,
	    &(struct predicted_by){task->entry, s->entry[task->entry].key, site,
		task->train, fit.params, fit.settings, posterior, fit.rmse});
	posterior_free(posterior);
	return found;
}

static void
append_held_out_results(struct session *s)
{
	struct validating *c = s->job.of, *found = s->job.found;
	if (c->all)
		note_rmse_of_each_run(s, &found->runs);
	trials_append(&c->runs, &found->runs);
	free_validation(found);
}

static char *
name_of_held_out_task(const struct session *s)
{
	const struct validating *c = s->job.of;
	const struct entry *entry = &s->entry[s->job.entry];
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, c->speed, NAN);
	return xasprintf(
	    tr("validate: %s without %g m/s%s"), entry->key, c->speed, rpm);
}

static void
show_held_out_results(struct session *s, void *of)
{
	struct validating *c = of;
	if (c->all)
		show_validation_of_all(s, c);
	else
		session_show_answer(
		    s, scores_site_answer(
			   &c->runs, s->entry[c->end - 1].site, c->sieves));
	free_validation(c);
}

static const struct job_type EACH = {find_next_held_out_speed, NULL,
    append_held_out_results, show_held_out_results, free_validation, false,
    name_of_held_out_task, N_("stopped before all speeds were predicted"),
    compare_at_held_out_speed};

/* True if no site of the part has enough speeds but sites of other parts
 * have.  *left_out: those of the part. */
static bool
has_part_no_usable_site(
    const struct session *s, const struct part *part, size_t *left_out)
{
	size_t n = 0, all = 0;
	*left_out = 0;
	for (size_t i = 0; i < s->n_entry; i++) {
		bool able = has_speeds_to_hold_out(&s->entry[i]);
		all += able;
		n += able && part_has_site(part, i);
		*left_out += !able && part_has_site(part, i);
	}
	return part->of > 0 && n == 0 && all > 0;
}

/* Calibrates without each speed in turn.  The job owns c. */
static bool
calibrate_without_each_speed(
    struct session *s, struct validating *c, struct error *error)
{
	c->at = c->all ? 0 : s->current;
	c->end = c->all ? s->n_entry : s->current + 1;
	session_discard_paused_job(s);
	const struct job job = {.type = &EACH,
	    .of = c,
	    .apart = c->all,
	    .options = job_default_options(s)};
	c->options = part_dependencies_text(s, &job.options, "each");
	size_t left_out;
	if (has_part_no_usable_site(s, &c->part, &left_out)) {
		c->runs.left_out = left_out;
		show_held_out_results(s, c);
		return true;
	}
	return job_start(s, &job) ||
	       error_set(error, ERROR_DATA,
		   "holdout=each: expected products at three or more speeds, "
		   "so that two are left to calibrate on\n"
		   "measure another speed");
}

bool
cmd_validate(struct session *s, const struct args *args, struct error *error)
{
	enum { HOLDOUT_UNTRAINED, HOLDOUT_EACH };
	struct part part = {0};
	bool all = args->n_operand > 0, each = args->holdout == HOLDOUT_EACH;
	if (all && strcmp(args->operand[0], "all") != 0)
		return error_set(error, ERROR_USAGE,
		    "validate: expected options or all, got '%s'",
		    args->operand[0]);
	if (all && args->by_sieve)
		return error_set(error, ERROR_USAGE,
		    "validate all: expected no sieves=on; it sums up over the "
		    "sites");
	if (!part_from_args(args, all, &part, error) ||
	    (each && !fit_check_settings_agree(
			 &s->set.model, s->set.model.breakage, error)))
		return false;
	struct validating *c = xcalloc(1, sizeof *c);
	*c = (struct validating){.all = all,
	    .sieves = args->by_sieve,
	    .part = part,
	    .runs = {.one = !all,
		.each = each,
		.level = settings_band_probability(&s->set)}};
	if (each)
		return calibrate_without_each_speed(s, c, error);
	bool ok =
	    (all ? validate_all_sites : validate_current_site)(s, c, error);
	free_validation(c);
	return ok;
}
