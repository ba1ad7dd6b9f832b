/* Starts, pauses, ends and sums up calibrations.  The driver pumps them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/fit.h"
#include "cmd/table.h"
#include "cmd/turn.h"

/* Begins with the site of job.entry. */
static void
begin(struct session *s)
{
	struct job *job = &s->job;
	const struct site *site = s->entry[job->entry].site;
	if (job->train == NULL || job->all) {
		free(job->train);
		job->train = xcalloc(site->n_run, sizeof *job->train);
		misfit_default_train(site, job->train);
	}
	job->options.train = job->train;
	job->options.run_weight = job->run_weight;
	job->calibration = calibration_new(site, &job->options);
	job->started = session_clock();
	fit_announce(s);
}

void
job_free(struct job *job)
{
	free(job->run_weight);
	calibration_free(job->calibration);
	free(job->train);
	answer_free(job->summary);
	*job = (struct job){0};
}

/* The next site of `all` that can be calibrated; n_entry when there is none. */
static size_t
next_site(const struct session *s, size_t from)
{
	for (size_t i = from; i < s->n_entry; i++) {
		const struct site *site = s->entry[i].site;
		for (size_t r = 0; r < site->n_run; r++)
			if (misfit_covered(&site->run[r]) > 0)
				return i;
	}
	return s->n_entry;
}

static struct answer *
new_summary(void)
{
	struct answer *r = answer_new("calibrate");
	answer_title(r, "all sites, calibrated");
	answer_columns(r, "site, f_mat, e0_min, alpha, misfit, rmse_pct: RMSE, "
			  "holdout_pct: hold-out RMSE, remark");
	return r;
}

void
job_start(struct session *s, const struct job *job)
{
	session_stop(s);
	s->job = *job;
	s->job.turn = s->turn;
	s->job.entry = job->all ? next_site(s, 0) : s->current;
	s->job.summary = job->all ? new_summary() : NULL;
	if (s->job.entry < s->n_entry)
		begin(s);
	else
		job_free(&s->job);
}

/* "alpha on bound; twin of ubbarp; poor". */
static char *
remarks(const struct session *s, const struct entry *entry)
{
	char *text = xstrdup("");
	const struct breakage *of = breakage_of(&entry->fit.params);
	for (size_t j = 0; j < of->n; j++)
		if (entry->fit.on_bound[j])
			xlist(
			    &text, "; ", "%s at bound", of->parameter[j].name);
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *other = &s->entry[i];
		if (other != entry &&
		    other->site->digest == entry->site->digest)
			xlist(&text, "; ", "same data as %s", other->key);
	}
	const char *verdict = fit_verdict(&entry->fit);
	if (strcmp(verdict, "good") != 0)
		xlist(&text, "; ", "%s", verdict);
	return text;
}

static void
summarise(struct session *s, const struct entry *entry)
{
	struct answer *r = s->job.summary;
	char *words = remarks(s, entry);
	const struct params *p = &entry->fit.params;
	answer_cells(r, "%s %.3f %.2f %.3f %g %.2f %.2f %s", entry->key,
	    params_value(p, "f_mat"), params_value(p, "e0_min"),
	    params_value(p, "alpha"), entry->fit.misfit, 100 * entry->fit.rmse,
	    100 * fit_holdout_rmse(entry), words);
	free(words);
}

/* Takes the result of the calibration that ended or was stopped. */
static void
take_result(struct session *s)
{
	fit_take(s);
	if (s->job.all)
		summarise(s, &s->entry[s->job.entry]);
	else
		fit_show(s);
}

bool
session_busy(const struct session *s)
{
	return s->job.calibration != NULL && !s->job.paused;
}

static void
end_all(struct session *s)
{
	struct answer *summary = s->job.summary;
	s->job.summary = NULL;
	job_free(&s->job);
	if (summary != NULL)
		session_answer(s, summary);
}

/* The calibration is done: on to the next site of `all`, or to the end. */
static void
next_or_end(struct session *s)
{
	take_result(s);
	size_t next = s->job.all ? next_site(s, s->job.entry + 1) : s->n_entry;
	if (next == s->n_entry) {
		end_all(s);
		return;
	}
	calibration_free(s->job.calibration);
	s->job.entry = next;
	begin(s);
}

void
session_step(struct session *s)
{
	struct calibration *c = s->job.calibration;
	size_t before = calibration_status(c).step;
	bool over = calibration_step(c) >= CALIBRATE_TOLERANCE;
	s->job.step += calibration_status(c).step - before;
	if (over)
		next_or_end(s);
	if (session_busy(s) && s->job.step == s->job.pause_at)
		session_pause(s);
}

void
session_pause(struct session *s)
{
	if (!session_busy(s))
		return;
	struct calibrate_status st = calibration_status(s->job.calibration);
	/* Before its first generation there is nothing to keep. */
	if (st.generation > 0)
		take_result(s);
	turn_stopped(s, s->job.step);
	if (s->job.all || st.generation == 0) {
		end_all(s);
		return;
	}
	s->job.paused = true;
	session_note(s,
	    "stopped at generation %zu of %zu, best misfit %.4g kept; "
	    "continue, accept or calibrate again",
	    st.generation, s->job.options.generations, st.best);
}

void
session_stop(struct session *s)
{
	if (session_busy(s))
		turn_stopped(s, 0);
	job_free(&s->job);
}

void
session_let_go(struct session *s)
{
	if (s->job.calibration == NULL)
		return;
	session_stop(s);
	session_note(
	    s, "discarded the stopped calibration; it cannot be continued");
}

static bool
need_paused(const struct session *s, const char *name, struct error *error)
{
	if (s->job.calibration != NULL && s->job.paused)
		return true;
	return error_set(error, ERROR_USAGE,
	    "%s: no calibration was stopped\n"
	    "use ^C or pause= to stop a calibration and keep it",
	    name);
}

/* On within the session's bounds, where these are others than it began with. */
static void
take_bounds(struct session *s)
{
	struct job *job = &s->job;
	if (s->set.model.breakage != job->options.settings.breakage ||
	    memcmp(&s->set.bounds, &job->options.bounds,
		sizeof s->set.bounds) == 0)
		return;
	job->options.bounds = s->set.bounds;
	calibration_set_bounds(job->calibration, &s->set.bounds);
	session_note(s,
	    "  continuing after generation %zu within the edited bounds",
	    calibration_status(job->calibration).generation);
}

bool
cmd_continue(struct session *s, const struct args *args, struct error *error)
{
	if (!need_paused(s, "continue", error))
		return false;
	const struct value *pause = args_value(args, "pause");
	if (pause->given && pause->whole <= s->job.step)
		return error_set(error, ERROR_USAGE,
		    "pause: expected a generation after %zu, which is done",
		    s->job.step);
	take_bounds(s);
	s->job.pause_at = (size_t)pause->whole;
	s->job.paused = false;
	s->job.turn = s->turn;
	return true;
}

bool
cmd_accept(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	if (!need_paused(s, "accept", error))
		return false;
	job_free(&s->job);
	return true;
}
