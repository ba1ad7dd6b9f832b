/* Runs generations at the chosen pace or, at pace auto, by the gain of the last
 * one, and shows the result of the search.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/watch.h"

#include "base/tr.h"
#include "cmd/session/invocation.h"
#include "cmd/fit/job.h"
#include "cmd/ask/trust_light.h"
#include "tui/control.h"
#include "cli/signals.h"
#include "tui/captured.h"

/* Messages about a stopped calibration, by its outcome.  all: by itself;
 * behind: after the output of the line that stopped it. */
static const struct {
	const char *all, *behind;
} STOPS[] = {
    [STOPPED_EMPTY] = {N_("stopped before its first generation: f starts "
			  "again"),
	N_("the calibration was stopped before its first generation")},
    [STOPPED_TAKEN] = {N_("stopped, the best is kept: Space continues, f "
			  "starts again, both within the current bounds; u "
			  "undoes it"),
	N_("the calibration was stopped, its best is kept")},
    [STOPPED_WORSE] = {N_("stopped: the site's parameters fit better and "
			  "stay; Space continues, :accept takes the stopped "
			  "ones"),
	N_("the calibration was stopped: the site's parameters fit better "
	   "and stay; :accept takes the stopped ones")}};

const char *
tui_stop_fit(struct tui *t)
{
	struct session *s = t->session;
	if (!session_is_calibrating(s))
		return "";
	struct error error = {0};
	bool alone = s->job.type->alone;
	const char *useless = s->job.type->useless;
	enum stopped stopped = session_stop_job_for_user(s);
	session_end_finished_commands(s, true, &error);
	t->ran = tui_calibration_seconds(t);
	t->held = false;
	control_discard_outdated_state(t);
	const char *said =
	    useless != NULL ? tr(useless)
	    : alone
		? tr(STOPS[stopped].all)
		: tr("stopped: the sites calibrated so far keep their fits; u "
		     "undoes it");
	tui_set_message(t, false, "%s", said);
	return useless == NULL && alone ? tr(STOPS[stopped].behind) : said;
}

/* Reports the end of a calibration, or of the last of several. */
static void
report_fit_end(struct tui *t, bool alone)
{
	struct error error = {0};
	if (!session_end_finished_commands(t->session, true, &error))
		captured_show_error(t, &error, "", "");
	t->held = false;
	control_discard_outdated_state(t);
	const struct entry *entry = tui_current_site_entry(t);
	if (error.kind != ERROR_NONE)
		return;
	if (!alone)
		tui_set_message(t, false,
		    "all sites are calibrated: Enter opens one, :validate all "
		    "compares them with their held-out runs");
	else if (entry != NULL && entry->has_fit)
		tui_set_message(t, false,
		    t->ui.page == PAGE_FIT
			? N_("calibrated: %s, RMSE %.2f points, %zu "
			     "generations; 1 shows the prediction")
			: N_("calibrated: %s, RMSE %.2f points, %zu "
			     "generations"),
		    verdict_on_fit(
			entry, light_of_answer_or_fit(t->session, entry, NULL)),
		    100 * entry->fit.rmse, entry->fit.generations);
}

static void
end_job_and_show_result(struct tui *t, const struct job_type *type)
{
	struct error error = {0};
	if (type->task_words == NULL) {
		report_fit_end(t, type->alone);
		return;
	}
	t->held = false;
	control_discard_outdated_state(t);
	captured_show_output(t);
	if (!session_end_finished_commands(t->session, true, &error))
		captured_show_error(t, &error, "", "");
	else if (t->viewer.text != NULL) {
		t->viewer.report = true;
		tui_set_message(t, false, "%s: done, V shows it again",
		    t->job != NULL ? t->job : t->command);
	}
}

/* Returns true while the posterior is sampled, after the search. */
static bool
is_sampling_posterior(const struct session *s)
{
	return session_is_calibrating(s) &&
	       calibration_status(s->job.calibration).state >=
		   CALIBRATE_TOLERANCE;
}

void
watch_set_fit_paused(struct tui *t, bool hold)
{
	if (hold == t->held)
		return;
	t->ran = tui_calibration_seconds(t);
	t->held = hold;
	t->due = t->started = t->clock;
}

void
watch_run_fit_step(struct tui *t)
{
	if (!session_is_calibrating(t->session))
		return;
	const struct job_type *type = t->session->job.type;
	do
		session_step_job(t->session);
	while (session_is_calibrating(t->session) &&
	       is_sampling_posterior(t->session));
	if (!session_is_calibrating(t->session))
		end_job_and_show_result(t, type);
}

/* Returns how many generations to run per second: at pace auto, fewer after a
 * generation that gained much. */
static double
generations_to_run_per_second(const struct tui *t)
{
	enum { QUICK = 40, USUAL = 12, SLOW = 4 };
	const double much = 0.2, little = 0.02;
	struct search_shown past = tui_calibration_history(t);
	const struct calibrate_generation *g = past.generation;
	if (t->ui.pace != PACE_AUTO)
		return PACES[t->ui.pace];
	if (past.n < 2 || past.polished)
		return USUAL;
	double gain = 1 - g[past.n - 1].best / g[past.n - 2].best;
	return gain >= much ? SLOW : gain >= little ? USUAL : QUICK;
}

void
watch_run_due_fit_steps(struct tui *t)
{
	static const double FRAME = 0.02; /* s, at full pace */
	struct session *s = t->session;
	if (!session_is_calibrating(s) || t->held)
		return;
	double began = session_clock_seconds();
	/* If several sites are calibrated in turn, nobody watches the
	 * generations, so they need no pace. */
	const struct job_type *type = s->job.type;
	int pace =
	    type->alone && !is_sampling_posterior(s) ? t->ui.pace : PACE_FULL;
	size_t entry = s->job.entry;
	if (pace < PACE_FULL && t->clock < t->due)
		return;
	do {
		/* The output of a single task is not part of the result. */
		if (type->task_words != NULL)
			captured_discard_output(t);
		session_step_job(s);
	} while (session_is_calibrating(s) &&
		 signals_get_ending_or_interrupt() == 0 &&
		 entry == s->job.entry &&
		 (pace == PACE_FULL || is_sampling_posterior(s)) &&
		 (t->aside || (!signals_is_stop_wanted() &&
				  session_clock_seconds() - began < FRAME)));
	if (pace < PACE_FULL)
		t->due = t->clock + 1 / generations_to_run_per_second(t);
	if (!session_is_calibrating(s))
		end_job_and_show_result(t, type);
	else if (type->task_words == NULL && entry != s->job.entry)
		control_discard_outdated_state(t);
}
