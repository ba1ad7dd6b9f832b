/* Starts, pauses and ends calibrations, and sums up their results.  The driver
 * runs them step by step.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/job.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/fit.h"
#include "cmd/ask/trust_light.h"
#include "cmd/fit/part.h"
#include "cmd/fit/fit_report.h"
#include "cmd/ask/outlook.h"
#include "cmd/lang/table.h"
#include "cmd/session/invocation.h"
#include "cmd/session/undo.h"
#include "core/psd/rotor_speed.h"
#include "core/search/misfit.h"

/* Notes what the job is about to do. */
static void
print_calibration_begun(struct session *s)
{
	const struct entry *entry = &s->entry[s->job.entry];
	const struct calibrate_options *o = &s->job.options;
	size_t model = o->settings.breakage;
	FREED char *train =
	    session_speeds_of_runs_text(entry->site, ", ", s->job.train, true);
	FREED char *holdout =
	    session_speeds_of_runs_text(entry->site, ", ", s->job.train, false);
	FREED char *rpm =
	    session_rpm_of_runs_in_brackets(entry->site, s->job.train, true);
	FREED char *held_rpm =
	    session_rpm_of_runs_in_brackets(entry->site, s->job.train, false);
	/* Held-out runs, too, correct the answers of a site's own fit. */
	bool included = s->job.fits && s->set.correction == CORRECTION_ALL;
	const char *kept = included ? tr("kept as a check, then included")
				    : tr("kept as a check");
	FREED char *words = xasprintf(
	    holdout[0] == '\0' ? tr("calibrating %s on %s m/s%s")
	    : rpm[0] == '\0'   ? tr("calibrating %s on %s m/s%s (%s: %s)")
			       : tr("calibrating %s on %s m/s%s; %s: %s m/s%s"),
	    entry->site->name, train, rpm, kept, holdout, held_rpm);
	if (model > 0)
		xappend_to_list(
		    &words, ", ", tr("model %s"), BREAKAGES[model]->name);
	session_print_note(s, "%s", words);
	if (s->job.detail)
		session_print_note(s,
		    "  population %zu, generations %zu, tolerance %g, stall "
		    "%zu, polish %s, seed %llu, threads %u",
		    o->population, o->generations, o->tolerance, o->stall,
		    o->polish ? "on" : "off", (unsigned long long)o->seed,
		    o->threads);
}

/* A job that pauses after a step runs its tasks one after the other. */
static bool
can_run_tasks_in_parallel(const struct job *job)
{
	return job->apart && job->pause_at == 0;
}

/* Starts to calibrate job.entry on job.train, if the job calibrates. */
static void
begin_calibration_task(struct session *s)
{
	struct job *job = &s->job;
	if (job->train == NULL)
		return;
	const struct site *site = s->entry[job->entry].site;
	calibration_free(job->calibration);
	job->options.train = job->train;
	job->options.run_weight = job->run_weight;
	struct calibrate_options options = job->options;
	options.threads = can_run_tasks_in_parallel(job) ? 1 : options.threads;
	job->calibration = calibration_new(site, &options);
	job->started = session_clock_seconds();
	print_calibration_begun(s);
}

/* Frees the job's members and clears it. */
static void
job_free(struct job *job)
{
	if (job->type != NULL)
		job->type->drop(job->of);
	free(job->run_weight);
	calibration_free(job->calibration);
	calibration_free(job->lowest);
	free(job->train);
	*job = (struct job){0};
}

bool
job_start(struct session *s, const struct job *job)
{
	session_abort_job(s);
	s->job = *job;
	s->job.invocation = s->invocation;
	s->job.fits = job->type->task_words == NULL;
	bool any = job->type->next(s);
	if (any)
		begin_calibration_task(s);
	else
		job_free(&s->job);
	return any;
}

size_t
job_mark_training_runs(const struct site *site, bool all, bool *train)
{
	size_t n = 0;
	if (!all)
		return misfit_mark_default_training(site, train);
	for (size_t r = 0; r < site->n_run; r++)
		n += train[r] = misfit_count_covered_sieves(&site->run[r]) > 0;
	return n;
}

size_t
job_count_trainable_speeds(const struct site *site)
{
	FREED bool *use = xcalloc(site->n_run + 1, sizeof *use);
	job_mark_training_runs(site, true, use);
	return site_count_speeds(site, use);
}

bool
job_hold_out_next_speed(const struct site *site, double *speed, bool *train)
{
	size_t next = 0;
	while (next < site->n_run &&
	       (site->run[next].speed <= *speed ||
		   misfit_count_covered_sieves(&site->run[next]) == 0))
		next++;
	if (next == site->n_run)
		return false;
	*speed = site->run[next].speed;
	job_mark_training_runs(site, true, train);
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].speed == *speed)
			train[r] = false;
	return true;
}

/* Copies the generations of the search to its site, for history and plots. */
static void
copy_search_history_to_site(struct entry *entry, const struct job *job)
{
	size_t n, size = sizeof(struct calibrate_generation);
	const struct calibrate_generation *g =
	    calibration_generation_history(job->calibration, &n);
	struct history *h =
	    history_new(&entry->fit, calibration_bounds(job->calibration),
		calibration_sum_squared_weights(job->calibration), entry->site,
		job->train);
	h->n = n;
	h->generation = xcalloc(n + 1, size);
	if (n > 0)
		memcpy(h->generation, g, n * size);
	history_release(entry->history);
	entry->history = h;
}

/* Returns the job's options as they would be typed, to record how the fit was
 * found.  Bounds are named only if they are not the defaults. */
static char *
calibrate_options_text(const struct session *s, const struct fit *fit)
{
	const struct job *job = &s->job;
	const struct calibrate_options *o = &job->options;
	const size_t model = o->settings.breakage;
	const struct bounds usual = bounds_default(model);
	const char *sign = " run_weights=";
	char *words = xasprintf("population=%zu generations=%zu tolerance=%g "
				"stall=%zu polish=%s%s%s",
	    o->population, o->generations, o->tolerance, o->stall,
	    o->polish ? "on" : "off", o->plain ? " preset=paper" : "",
	    o->by_sd ? " weights=sd" : "");
	for (size_t r = 0; r < s->entry[job->entry].site->n_run; r++) {
		if (job->run_weight == NULL || !job->train[r])
			continue;
		xappend(&words, "%s%g", sign, job->run_weight[r]);
		sign = ",";
	}
	if (fit->edits > 0)
		xappend_to_list(&words, "; ",
		    fit->edits > 1
			? tr("bounds edited after generation %zu and before")
			: tr("bounds edited after generation %zu"),
		    fit->edited_at);
	for (size_t j = 0; j < BREAKAGES[model]->n; j++)
		if (o->bounds.lower[j] != usual.lower[j] ||
		    o->bounds.upper[j] != usual.upper[j])
			xappend_to_list(&words, "; ", tr("bounds %s %g..%g"),
			    BREAKAGES[model]->parameter[j].name,
			    o->bounds.lower[j], o->bounds.upper[j]);
	return words;
}

/* Makes the job's result the fit of its site. */
static void
set_site_fit_from_job(struct session *s)
{
	struct entry *entry = &s->entry[s->job.entry];
	entry->fit = calibration_best_fit(s->job.calibration);
	if (s->job.lowest != NULL && entry->fit.plain)
		entry->fit.lowest = calibration_best_fit(s->job.lowest).misfit;
	FREED char *options = calibrate_options_text(s, &entry->fit);
	snprintf(entry->options, sizeof entry->options, "%s", options);
	entry->params = entry->fit.params;
	copy_search_history_to_site(entry, &s->job);
	session_remove_answers(s);
	entry->has_fit = entry->has_params = true;
	xfree_and_set(&entry->remembered, NULL);
	memcpy(entry->train, s->job.train,
	    entry->site->n_run * sizeof *entry->train);
	origin_release(entry->origin);
	entry->origin = origin_new_of_fit(entry);
	s->job.taken = true;
}

/* Runs a step of the polished search with which the result of a plain search is
 * compared.  Returns true if it is complete or not needed. */
static bool
step_polished_search(struct session *s)
{
	struct job *job = &s->job;
	struct calibrate_options options = job->options;
	if (!options.plain || options.polish || !job->type->alone)
		return true;
	if (job->lowest == NULL) {
		const struct calibrate_options usual =
		    calibrate_options_default();
		options.plain = false;
		options.polish = true;
		options.population = usual.population;
		options.generations = usual.generations;
		options.stall = usual.stall;
		options.tolerance = usual.tolerance;
		job->lowest =
		    calibration_new(s->entry[job->entry].site, &options);
	}
	return calibration_step(job->lowest) >= CALIBRATE_TOLERANCE;
}

/* Takes the fit when its search is complete; then draws a part of the
 * posterior, which the light needs.  Returns true when all is drawn.  Drawing
 * takes longer than many generations, hence the parts. */
static bool
set_fit_and_step_posterior(struct session *s)
{
	if (!s->job.taken && !step_polished_search(s))
		return false;
	if (!s->job.taken)
		set_site_fit_from_job(s);
	return posterior_sample_a_part(s, &s->entry[s->job.entry]);
}

static void
show_fit_report(struct session *s)
{
	double seconds = session_clock_seconds() - s->job.started;
	bool fits = s->job.fits;
	if (s->job.detail)
		session_print_note(s, "  done in %.2f s", seconds);
	/* A stopped job counts as a search in progress, but the report is about
	 * the fit. */
	s->job.fits = false;
	struct answer *answer = fit_build_report(s, &s->entry[s->job.entry],
	    calibration_bounds(s->job.calibration), seconds, s->job.detail);
	s->job.fits = fits;
	session_show_answer(s, answer);
}

/* Returns remarks such as "alpha at bound; same data as ubbarp; poor". */
static char *
fit_remarks_text(const struct session *s, const struct entry *entry)
{
	char *text = xstrdup("");
	const struct breakage *of =
	    breakage_model_of_params(&entry->fit.params);
	for (size_t j = 0; j < of->n; j++)
		if (entry->fit.on_bound[j])
			xappend_to_list(&text, "; ", tr("%s at bound"),
			    of->parameter[j].name);
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *other = &s->entry[i];
		if (other != entry &&
		    other->site->digest == entry->site->digest)
			xappend_to_list(
			    &text, "; ", tr("same data as %s"), other->key);
	}
	const char *verdict = fit_verdict_without_posterior(s, entry);
	if (strcmp(verdict, "good") != 0)
		xappend_to_list(&text, "; ", "%s", verdict);
	return text;
}

/* A job with one calibration has its site and its runs from the start. */
static bool
prepare_fit_of_current_site(struct session *s)
{
	s->job.entry = s->current;
	return s->job.calibration == NULL;
}

static void
set_and_show_single_fit(struct session *s)
{
	if (!s->job.taken)
		set_site_fit_from_job(s);
	show_fit_report(s);
}

static void
end_job_without_answer(struct session *s, void *of)
{
	(void)s;
	(void)of;
}

static const struct job_type ONE_SITE = {.next = prepare_fit_of_current_site,
    .draw = set_fit_and_step_posterior,
    .take = set_and_show_single_fit,
    .end = end_job_without_answer,
    .drop = free,
    .alone = true};

/* The results of `calibrate all`. */
struct all_fits {
	bool train_all;
	struct part part;
	size_t n, *index; /* the sites of the part so far */
	char *options;    /* options that all parts must have */
};

static void *
all_fits_new(const struct session *s, bool train_all, struct part part,
    const struct calibrate_options *options)
{
	struct all_fits *fits = xcalloc(1, sizeof *fits);
	*fits = (struct all_fits){.train_all = train_all,
	    .part = part,
	    .options = part_common_options_text(
		s, options, train_all ? "all" : "ends")};
	return fits;
}

static void
all_fits_free(void *of)
{
	struct all_fits *fits = of;
	if (fits == NULL)
		return;
	free(fits->index);
	free(fits->options);
	free(fits);
}

/* Finds the next site that can be calibrated. */
static bool
prepare_next_site_fit(struct session *s)
{
	struct job *job = &s->job;
	const struct all_fits *fits = job->of;
	size_t i = job->calibration == NULL ? 0 : job->entry + 1;
	for (; i < s->n_entry; i++) {
		const struct site *site = s->entry[i].site;
		free(job->train);
		job->train = xcalloc(site->n_run, sizeof *job->train);
		job->entry = i;
		if (part_has_site(&fits->part, i) &&
		    job_mark_training_runs(site, true, job->train) > 0 &&
		    job_mark_training_runs(site, fits->train_all, job->train) >
			0)
			return true;
	}
	return false;
}

static void
set_site_fit_and_add_to_list(struct session *s)
{
	struct all_fits *fits = s->job.of;
	const struct entry *entry = &s->entry[s->job.entry];
	if (!s->job.taken)
		set_site_fit_from_job(s);
	/* The table of sites does not have these fields; assert reads them. */
	struct answer *answer = answer_new("calibrate");
	fit_put_fields(answer_json_fields(answer), entry,
	    fit_verdict_without_posterior(s, entry),
	    session_clock_seconds() - s->job.started);
	session_store_newest_answer(s, answer);
	session_print_note(s, "  %s: misfit %.4g, RMSE %.2f points", entry->key,
	    entry->fit.misfit, 100 * entry->fit.rmse);
	fits->index = xrealloc(fits->index, fits->n + 1, sizeof *fits->index);
	fits->index[fits->n++] = s->job.entry;
}

static struct part_row
row_of_calibrated_site(
    const struct entry *entry, const char *source, const char *remark)
{
	const struct params *p = &entry->fit.params;
	return (struct part_row){.site = entry->key,
	    .source = source,
	    .remark = remark,
	    .number = {params_value_by_name(p, "f_mat"),
		params_value_by_name(p, "e0_min"),
		params_value_by_name(p, "alpha"), entry->fit.misfit,
		100 * entry->fit.rmse, 100 * fit_largest_holdout_rmse(entry)}};
}

static void
show_table_of_all_fits(struct session *s, void *of)
{
	struct all_fits *fits = of;
	size_t n = fits->n;
	FREED struct part_row *row = xcalloc(n + 1, sizeof *row);
	FREED char **text = xcalloc(2 * n + 1, sizeof *text);
	for (size_t i = 0; i < n; i++) {
		const struct entry *entry = &s->entry[fits->index[i]];
		text[i] = site_provenance_first_clause(
		    entry->site, "provenance not stated");
		text[n + i] = fit_remarks_text(s, entry);
		row[i] = row_of_calibrated_site(entry, text[i], text[n + i]);
	}
	struct answer *r = part_build_calibrate_all_answer(row, n);
	for (size_t i = 0; i < 2 * n; i++)
		free(text[i]);
	if (fits->part.of > 0) {
		part_put_fields_for_collect(
		    r, s, &fits->part, fits->index, fits->n, fits->options);
		answer_add_rows_as_json_objects(r, "rows");
	}
	session_show_answer(s, r);
	all_fits_free(fits);
}

static const struct job_type ALL_SITES = {.next = prepare_next_site_fit,
    .draw = set_fit_and_step_posterior,
    .take = set_site_fit_and_add_to_list,
    .end = show_table_of_all_fits,
    .drop = all_fits_free};

static void
end_job(struct session *s)
{
	const struct job_type *type = s->job.type;
	void *of = s->job.of;
	s->job.type = NULL;
	job_free(&s->job);
	type->end(s, of);
}

/* Keeps the task's result, then begins the next task or ends the job. */
static void
begin_next_task_or_end_job(struct session *s)
{
	s->job.type->take(s);
	if (s->job.type->next(s))
		begin_calibration_task(s);
	else
		end_job(s);
}

/* Runs a step of a task's search.  Returns true if the search is over. */
static bool
step_calibration_search(struct calibration *c)
{
	return c == NULL || calibration_step(c) >= CALIBRATE_TOLERANCE;
}

void
session_step_job(struct session *s)
{
	struct calibration *c = s->job.calibration;
	struct calibrate_status before = calibration_status(c);
	if (before.state < CALIBRATE_TOLERANCE)
		s->job.taken = false;
	bool over = step_calibration_search(c);
	s->job.step += calibration_status(c).step - before.step;
	if (over && s->job.type->draw != NULL && !s->job.type->draw(s))
		return;
	if (over && s->job.type->follow != NULL)
		s->job.found = s->job.type->follow(
		    s, &(struct job_task){s->job.entry, s->job.train, c, NULL});
	if (over)
		begin_next_task_or_end_job(s);
	if (session_is_calibrating(s) && s->job.pause_at > 0 &&
	    s->job.step == s->job.pause_at)
		session_stop_job_for_user(s);
}

/* A task that runs in parallel with others.  found: see job_type.follow. */
struct running_task {
	const struct session *s;
	struct job_task task;
	bool over;
	void *found;
};

/* Runs a task until it is complete or should stop. */
static void
run_calibration_task_to_end(void *data, size_t piece, unsigned thread)
{
	struct running_task *a = &((struct running_task *)data)[piece];
	const struct job_type *type = a->s->job.type;
	bool (*stop)(void) = a->task.stop;
	(void)thread;
	do
		a->over = step_calibration_search(a->task.calibration);
	while (!a->over && (stop == NULL || !stop()));
	if (a->over && type->follow != NULL) {
		a->found = type->follow(a->s, &a->task);
		a->over = a->found != NULL;
	}
}

/* Lists the present task and the next ones, at most `most` in all. */
static size_t
begin_and_list_calibration_tasks(
    struct session *s, struct running_task *ahead, size_t most)
{
	struct job *job = &s->job;
	size_t n = 0;
	do {
		ahead[n++] = (struct running_task){.s = s,
		    .task = {job->entry, job->train, job->calibration,
			job->options.stop}};
		job->train = NULL;
		if (n == most || !job->type->next(s))
			break;
		job->calibration = NULL;
		begin_calibration_task(s);
	} while (true);
	free(job->train);
	return n;
}

/* Takes the results in the order of the tasks.  If a task was stopped, it
 * becomes the present task, and the results of those after it are dropped. */
static void
collect_parallel_results(
    struct session *s, const struct running_task *ahead, size_t n)
{
	struct job *job = &s->job;
	bool over = true;
	for (size_t i = 0; i < n; i++) {
		if (!over) {
			if (ahead[i].found != NULL)
				job->type->drop(ahead[i].found);
			calibration_free(ahead[i].task.calibration);
			free(ahead[i].task.train);
			continue;
		}
		job->entry = ahead[i].task.entry;
		job->train = ahead[i].task.train;
		job->calibration = ahead[i].task.calibration;
		job->found = ahead[i].found;
		struct calibrate_status st =
		    calibration_status(job->calibration);
		over = ahead[i].over;
		job->taken = false;
		job->step += over ? st.step : 0;
		if (!over || i + 1 == n)
			continue;
		job->type->take(s);
		calibration_free(job->calibration);
		free(job->train);
	}
	if (over)
		begin_next_task_or_end_job(s);
}

void
session_run_parallel_tasks(struct session *s)
{
	enum { EACH_THREAD = 2 };
	if (!can_run_tasks_in_parallel(&s->job)) {
		session_step_job(s);
		return;
	}
	unsigned threads = s->job.options.threads;
	size_t most = EACH_THREAD * threads;
	FREED struct running_task *ahead = xcalloc(most, sizeof *ahead);
	size_t n = begin_and_list_calibration_tasks(s, ahead, most);
	struct pool *pool = pool_new(threads);
	pool_run(pool, n, run_calibration_task_to_end, ahead);
	pool_free(pool);
	collect_parallel_results(s, ahead, n);
}

/* Returns the misfit of the site's present parameters for the job's runs,
 * weights and settings, or INFINITY if it has none or the settings do not allow
 * their breakage model. */
static double
misfit_of_present_params(const struct session *s)
{
	const struct entry *entry = &s->entry[s->job.entry];
	struct calibrate_options options = s->job.options;
	size_t breakage = entry->params.breakage;
	struct error error;
	options.train = s->job.train;
	options.run_weight = s->job.run_weight;
	options.settings.breakage = (unsigned)breakage;
	if (!entry->has_params || !fit_check_settings_allow_model(
				      &options.settings, breakage, &error))
		return INFINITY;
	struct misfit *m = calibrate_make_misfit(entry->site, &options);
	double misfit = misfit_of_params(m, &entry->params);
	misfit_free(m);
	return misfit;
}

static void
print_calibration_stopped(const struct session *s, double best, bool taken)
{
	struct calibrate_status st = calibration_status(s->job.calibration);
	if (taken && s->job.type->alone)
		session_print_note(s,
		    "stopped at generation %zu of %zu, best misfit %.4g kept: "
		    "continue, accept, undo or calibrate again",
		    st.generation, s->job.options.generations, best);
	else if (s->job.type->alone)
		session_print_note(s,
		    "stopped at generation %zu of %zu, best misfit %.4g; the "
		    "site's parameters fit better (misfit %.4g) and stay: "
		    "'accept' takes the stopped ones, 'continue' resumes",
		    st.generation, s->job.options.generations, best,
		    s->job.before);
	else if (!taken)
		session_print_note(s,
		    "%s: stopped at generation %zu of %zu, best misfit %.4g; "
		    "the site's parameters fit better (misfit %.4g) and stay",
		    s->entry[s->job.entry].key, st.generation,
		    s->job.options.generations, best, s->job.before);
}

/* Takes the best fit so far if it is worth it; before the first generation
 * there is none.  If the job was stopped before, the site may have the result
 * of that stop, which is half done, too, and may lie outside bounds edited
 * since.  So the best is compared with the parameters before that. */
static enum stopped
apply_best_fit_on_stop(struct session *s)
{
	struct job *job = &s->job;
	const struct params *params = &s->entry[job->entry].params;
	if (calibration_status(job->calibration).generation == 0)
		return STOPPED_EMPTY;
	double best = calibration_best_fit(job->calibration).misfit;
	if (!job->gave || memcmp(&job->given, params, sizeof *params) != 0)
		job->before = misfit_of_present_params(s);
	/* Half a search does not replace a better fit.  One that is complete
	 * and lacks only its draws always does. */
	bool taken =
	    calibration_status(job->calibration).state >= CALIBRATE_TOLERANCE ||
	    !isfinite(job->before) || best < job->before;
	if (taken) {
		job->type->take(s);
		job->given = *params;
		job->gave = true;
	}
	print_calibration_stopped(s, best, taken);
	return taken ? STOPPED_TAKEN : STOPPED_WORSE;
}

enum stopped
session_stop_job_for_user(struct session *s)
{
	if (!session_is_calibrating(s))
		return STOPPED_EMPTY;
	const char *useless = s->job.type->useless;
	if (useless != NULL) {
		session_abort_job(s);
		session_print_note(s, "%s", tr(useless));
		return STOPPED_EMPTY;
	}
	enum stopped stopped = apply_best_fit_on_stop(s);
	invocation_set_job_stopped(s, s->job.step);
	if (!s->job.type->alone || stopped == STOPPED_EMPTY) {
		end_job(s);
		return stopped;
	}
	s->job.paused = true;
	s->job.held_back = stopped == STOPPED_WORSE;
	s->job.undo_steps = undo_count_steps(s);
	s->job.stopped = session_clock_seconds();
	return stopped;
}

void
session_run_job_to_end(struct session *s)
{
	while (session_is_calibrating(s))
		if (session_is_interrupted(s))
			session_stop_job_for_user(s);
		else
			session_run_parallel_tasks(s);
}

void
session_abort_job(struct session *s)
{
	if (session_is_calibrating(s))
		invocation_set_job_stopped(s, 0);
	job_free(&s->job);
}

void
session_discard_paused_job(struct session *s)
{
	if (s->job.type == NULL)
		return;
	session_abort_job(s);
	session_print_note(
	    s, "discarded the stopped calibration; it cannot be continued");
}

/* Marks the runs with a product at the given speeds, including all repeats.
 * Each speed must have one. */
static bool
mark_training_runs_at_speeds(const struct site *site, const struct args *args,
    bool *train, struct error *error)
{
	const double *speed = args->train.at;
	if (args->train.n == 0)
		return job_mark_training_runs(site,
			   args_is_given(args, &args->train), train) > 0 ||
		       error_set(error, ERROR_DATA,
			   "%s has no product to calibrate on\n"
			   "run 'guess' for an estimate from its feed, or "
			   "'recall' to use a material's parameters",
			   site->name);
	for (size_t i = 0; i < args->train.n; i++) {
		size_t r = site_run_at_speed(site, speed[i]);
		FREED char *rpm =
		    rotor_speed_rpm_text(site->rotor, speed[i], NAN);
		if (r == site->n_run || site->run[r].product.n == 0)
			return error_set(error, ERROR_USAGE,
			    "%s has no product at %g m/s%s\n"
			    "run 'show' for its speeds",
			    site->name, speed[i], rpm);
		for (train[r] = true;
		     r + 1 < site->n_run && site_run_repeats_speed(site, r + 1);
		     r++)
			train[r + 1] = true;
	}
	return true;
}

/* True if each training run has a sieve to compare. */
static bool
check_training_runs_have_sieves(
    const struct site *site, const bool *train, struct error *error)
{
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		if (!train[r] || misfit_count_covered_sieves(run) > 0)
			continue;
		return error_set(error, ERROR_DATA,
		    "%s: no product sieve at %g m/s is in the range of the "
		    "feed's sieves\n"
		    "sieve the feed to finer sizes, or choose other training "
		    "runs: calibrate train=...",
		    site->name, run->speed);
	}
	return true;
}

/* True if each training run has standard deviations.  A run without them
 * would count for almost nothing beside the others. */
static bool
check_runs_have_standard_deviations(
    const struct site *site, const bool *train, struct error *error)
{
	for (size_t r = 0; r < site->n_run; r++) {
		if (!train[r] || site->run[r].product_sd != NULL)
			continue;
		return error_set(error, ERROR_DATA,
		    "expected standard deviations for every training run with "
		    "weights=sd; %s has none at %g m/s\n"
		    "add a column sd@%g, or calibrate without weights",
		    site->name, site->run[r].speed, site->run[r].speed);
	}
	return true;
}

/* Assigns the given weights to the training runs, in their order. */
static bool
assign_weights_to_runs(const struct site *site, const bool *train,
    const struct number_list *given, double **run_weight, struct error *error)
{
	size_t n = 0;
	if (given->n == 0)
		return true;
	double *weight = xcalloc_doubles(site->n_run);
	for (size_t r = 0; r < site->n_run; r++)
		if (train[r] && n++ < given->n)
			weight[r] = given->at[n - 1];
	if (n == given->n) {
		*run_weight = weight;
		return true;
	}
	free(weight);
	return error_set(error, ERROR_USAGE,
	    "run_weights: expected %zu numbers, one for each training run, got "
	    "%zu",
	    n, given->n);
}

struct calibrate_options
job_options_from_settings(const struct session *s)
{
	struct calibrate_options o = calibrate_options_default();
	o.seed = s->set.seed;
	o.threads = s->set.threads;
	o.isa = s->isa;
	o.stop = s->hooks.stop;
	o.bounds = s->set.bounds;
	o.settings = s->set.model;
	return o;
}

/* The population of `calibrate all`. So few candidates are enough to find
 * starting points for the polish: see doc/decisions/search-and-polish.md. */
enum { POPULATION_OF_MANY = 2500 };

enum { PRESET_PAPER = 1, WEIGHTS_SD = 1 };

static struct calibrate_options
parse_calibrate_options(
    const struct session *s, const struct args *args, bool all)
{
	struct calibrate_options o = job_options_from_settings(s);
	o.plain = args->preset == PRESET_PAPER;
	o.seed = args_is_given(args, &args->seed) ? args->seed : o.seed;
	o.threads = args->threads > 0 ? (unsigned)args->threads : o.threads;
	if (args->population > 0)
		o.population = (size_t)args->population;
	else if (all && !o.plain)
		o.population = POPULATION_OF_MANY;
	o.generations = (size_t)args->generations;
	o.stall = o.plain && !args_is_given(args, &args->stall)
		      ? 0
		      : (size_t)args->stall;
	o.tolerance = args->tolerance;
	o.polish =
	    args->polish && (args_is_given(args, &args->polish) || !o.plain);
	o.by_sd = args->weights == WEIGHTS_SD;
	if (o.plain)
		o.bounds = bounds_default(o.settings.breakage);
	return o;
}

static bool
check_options_of_calibrate_all(const struct args *args, struct error *error)
{
	if (args->train.n == 0 && args->run_weights.n == 0 &&
	    args->weights != WEIGHTS_SD)
		return true;
	return error_set(error, ERROR_USAGE,
	    "calibrate all: expected no weights= or run_weights= and no speeds "
	    "but train=all; each site uses its own");
}

/* Chooses the training runs and their weights. */
static bool
choose_training_runs(const struct site *site, const struct args *args,
    struct job *job, struct error *error)
{
	job->train = xcalloc(site->n_run, sizeof *job->train);
	return mark_training_runs_at_speeds(site, args, job->train, error) &&
	       check_training_runs_have_sieves(site, job->train, error) &&
	       (args->weights != WEIGHTS_SD ||
		   check_runs_have_standard_deviations(
		       site, job->train, error)) &&
	       assign_weights_to_runs(site, job->train, &args->run_weights,
		   &job->run_weight, error);
}

bool
cmd_calibrate(struct session *s, const struct args *args, struct error *error)
{
	const struct site *site = session_current_site_entry(s)->site;
	bool all = args->n_operand > 0;
	struct part part = {0};
	struct job job = {.type = all ? &ALL_SITES : &ONE_SITE,
	    .options = parse_calibrate_options(s, args, all),
	    .detail = args->detail,
	    .watch = args->watch,
	    .pause_at = (size_t)args->pause};
	if (!fit_check_settings_allow_model(
		&s->set.model, s->set.model.breakage, error) ||
	    !part_from_args(args, all, &part, error) ||
	    !(all ? check_options_of_calibrate_all(args, error)
		  : choose_training_runs(site, args, &job, error))) {
		job_free(&job);
		return false;
	}
	bool train_all = all && args_is_given(args, &args->train);
	/* Sites that are calibrated in parallel cannot be watched. */
	job.apart = all && !job.watch;
	if (all)
		job.of = all_fits_new(s, train_all, part, &job.options);
	else
		job.former = fitted_answer_to_last_question(
		    s, session_current_site_entry(s));
	if (job_start(s, &job))
		return true;
	if (part.of == 0)
		return error_set(error, ERROR_DATA,
		    "no loaded site has a product to calibrate on\n"
		    "load site files with products at two speeds, or 'add' "
		    "belt cuts");
	/* With more parts than sites, a part may be empty. */
	show_table_of_all_fits(
	    s, all_fits_new(s, train_all, part, &job.options));
	return true;
}

static bool
require_paused_calibration(
    const struct session *s, const char *name, struct error *error)
{
	if (s->job.paused)
		return true;
	return error_set(error, ERROR_USAGE,
	    "%s: no calibration was stopped\n"
	    "use ^C or pause= to stop a calibration and keep it",
	    name);
}

/* If the session's bounds were edited, continues within them. */
static void
continue_in_edited_bounds(struct session *s)
{
	struct job *job = &s->job;
	size_t model = job->options.settings.breakage;
	if (s->set.model.breakage != model) {
		session_print_note(s,
		    "  continuing with the model %s; 'calibrate' begins with "
		    "%s",
		    BREAKAGES[model]->name,
		    BREAKAGES[s->set.model.breakage]->name);
		return;
	}
	if (job->options.plain || memcmp(&s->set.bounds, &job->options.bounds,
				      sizeof s->set.bounds) == 0)
		return;
	/* Only draws are missing. */
	if (calibration_status(job->calibration).state >= CALIBRATE_TOLERANCE) {
		session_print_note(s,
		    "  the search has ended; 'calibrate' begins within the "
		    "edited bounds");
		return;
	}
	job->options.bounds = s->set.bounds;
	calibration_set_bounds(job->calibration, &s->set.bounds);
	session_print_note(s,
	    "  continuing after generation %zu within the edited bounds",
	    calibration_status(job->calibration).generation);
}

bool
cmd_continue(struct session *s, const struct args *args, struct error *error)
{
	if (!require_paused_calibration(s, "continue", error))
		return false;
	if (args->pause > 0 && args->pause <= s->job.step)
		return error_set(error, ERROR_USAGE,
		    "pause: expected a generation after %zu, which is done, "
		    "got %zu\n"
		    "write a later one, or leave out pause=",
		    s->job.step, (size_t)args->pause);
	continue_in_edited_bounds(s);
	/* A fit is one step of undo, however often it was stopped. */
	if (s->job.newest)
		s->invocation->joins = true;
	s->job.pause_at = (size_t)args->pause;
	s->job.started += session_clock_seconds() - s->job.stopped;
	s->job.paused = s->job.held_back = false;
	s->job.invocation = s->invocation;
	return true;
}

bool
cmd_accept(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	if (!require_paused_calibration(s, "accept", error))
		return false;
	if (s->job.held_back)
		s->job.type->take(s);
	job_free(&s->job);
	return true;
}
