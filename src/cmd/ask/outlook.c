/* Draws the posterior when it is first needed and caches it with the
 * calibration; chooses the runs that correct an answer by the setting
 * correction.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/outlook.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/fit.h"
#include "core/posterior/ensemble.h"
#include "core/search/misfit.h"

/* Returns which runs of the calibration inform an answer [n_run].  The caller
 * frees it.  *place: the index of their posterior and evidence in the history.
 */
static bool *
mark_runs_used_in_correction(
    const struct history *h, enum correction correction, size_t *place)
{
	size_t n = h->site->n_run;
	bool *use = xcalloc(n, sizeof *use), same = true;
	for (size_t r = 0; r < n; r++) {
		bool measured =
		    misfit_count_covered_sieves(&h->site->run[r]) > 0;
		use[r] =
		    h->train[r] || (correction == CORRECTION_ALL && measured);
		same = same && use[r] == h->train[r];
	}
	*place = same ? CORRECTION_TRAIN : CORRECTION_ALL;
	return use;
}

enum correction
correction_in_use(const struct session *s, const struct entry *entry)
{
	return entry->scenario != NULL ? entry->scenario->correction
				       : s->set.correction;
}

/* Returns which runs inform the entry's answers, or the training runs if
 * answers are those of the model alone. */
static enum correction
correction_all_or_training(const struct session *s, const struct entry *entry)
{
	return correction_in_use(s, entry) == CORRECTION_ALL ? CORRECTION_ALL
							     : CORRECTION_TRAIN;
}

/* As mark_runs_used_in_correction, for the entry's answers. */
static bool *
mark_runs_that_inform_answers(
    const struct session *s, const struct entry *entry, size_t *place)
{
	return mark_runs_used_in_correction(entry->origin->history,
	    correction_all_or_training(s, entry), place);
}

/* Returns the options for drawing the posterior given the runs in `use`
 * [n_run]. */
static struct posterior_options
posterior_options_of_runs(
    const struct session *s, const struct entry *entry, const bool *use)
{
	const struct history *h = entry->origin->history;
	return (struct posterior_options){.use = use,
	    .settings = h->fit.settings,
	    .bounds = h->bounds,
	    .seed = s->set.draw_seed,
	    .threads = s->set.threads,
	    .isa = s->isa,
	    .noise = s->set.noise / 100,
	    .speed_sd = s->set.speed_sd / 100};
}

/* True if the parameters are from a completed calibration with enough data. */
static bool
can_sample_posterior(const struct entry *entry)
{
	const struct fit *fit = origin_fit_behind_params(entry);
	return fit != NULL && !fit_has_too_few_data(fit) &&
	       fit->stop != CALIBRATE_STOPPED;
}

/* Draws the posterior for `place` in the history, or continues with it, until
 * it is complete or the user is waiting or interrupts the command.  steps: the
 * most to take; 0 for no limit. */
static void
sample_posterior_steps(const struct session *s, const struct entry *entry,
    const bool *use, size_t place, size_t steps)
{
	struct history *h = entry->origin->history;
	if (h->drawing != NULL && h->drawn != place) {
		posterior_free(posterior_end(h->drawing));
		h->drawing = NULL;
	}
	if (h->drawing == NULL) {
		if (s->hooks.announce != NULL)
			s->hooks.announce(
			    "posterior: drawing parameters that fit the data");
		struct posterior_options o =
		    posterior_options_of_runs(s, entry, use);
		h->drawing =
		    posterior_begin_sampling(h->site, &h->fit.params, &o);
		h->drawn = place;
	}
	bool done = false;
	for (size_t i = 0; !done && (steps == 0 || i < steps); i++) {
		done = posterior_step(h->drawing);
		if (!done && session_is_interrupted(s))
			return;
	}
	if (!done)
		return;
	h->posterior[place] = posterior_end(h->drawing);
	h->drawing = NULL;
}

/* Returns the posterior, or NULL if it is not complete after these steps. */
static const struct posterior *
posterior_if_done_in_steps(const struct session *s, const struct entry *entry,
    enum correction correction, size_t steps)
{
	struct history *h = entry->origin->history;
	size_t place;
	FREED bool *use = mark_runs_used_in_correction(h, correction, &place);
	if (h->noise != s->set.noise || h->speed_sd != s->set.speed_sd ||
	    h->draw_seed != s->set.draw_seed)
		history_reset_posteriors(h, &s->set);
	if (h->posterior[place] == NULL)
		sample_posterior_steps(s, entry, use, place, steps);
	return h->posterior[place];
}

struct posterior *
posterior_new_of_training_runs(
    const struct session *s, const struct entry *entry)
{
	if (!can_sample_posterior(entry) ||
	    correction_in_use(s, entry) == CORRECTION_OFF)
		return NULL;
	const struct history *h = entry->origin->history;
	struct posterior_options o =
	    posterior_options_of_runs(s, entry, h->train);
	o.threads = 1;
	return posterior_new(h->site, &h->fit.params, &o);
}

const struct posterior *
posterior_of_calibration(const struct session *s, const struct entry *entry,
    enum correction correction)
{
	return can_sample_posterior(entry)
		   ? posterior_if_done_in_steps(s, entry, correction, 0)
		   : NULL;
}

bool
posterior_sample_a_part(const struct session *s, const struct entry *entry)
{
	enum { STEPS = 16 };
	return !can_sample_posterior(entry) ||
	       posterior_if_done_in_steps(s, entry,
		   correction_all_or_training(s, entry), STEPS) != NULL;
}

const struct posterior *
posterior_even_if_correction_off(
    const struct session *s, const struct entry *entry)
{
	return posterior_of_calibration(
	    s, entry, correction_all_or_training(s, entry));
}

const struct evidence *
trust_evidence_of_calibration(
    const struct session *s, const struct entry *entry)
{
	const struct fit *fit = origin_fit_behind_params(entry);
	if (fit == NULL)
		return NULL;
	struct history *h = entry->origin->history;
	size_t place;
	FREED bool *use = mark_runs_that_inform_answers(s, entry, &place);
	struct evidence **e = &h->evidence[place];
	const struct posterior *p = posterior_even_if_correction_off(s, entry);
	bool first = *e == NULL;
	if (first)
		*e = xcalloc(1, sizeof **e);
	/* If the draws were stopped last time, they may be complete now.  The
	 * evidence is then filled in again at the same address, because callers
	 * hold it. */
	if (first || (p != NULL && isnan((*e)->discrepancy)))
		**e = trust_gather_evidence(
		    h->site, h->train, use, fit, &h->bounds, p, s->set.noise);
	return *e;
}

struct evidence
trust_evidence_without_posterior(
    const struct session *s, const struct entry *entry)
{
	struct history *h = entry->origin->history;
	size_t place;
	FREED bool *use = mark_runs_that_inform_answers(s, entry, &place);
	return trust_gather_evidence(h->site, h->train, use,
	    origin_fit_behind_params(entry), &h->bounds, NULL, s->set.noise);
}

double
difference_from_nearest_feed(
    const struct session *s, const struct entry *entry, size_t feed_run)
{
	const struct history *h = entry->origin->history;
	double least = INFINITY;
	size_t place;
	FREED bool *use = mark_runs_that_inform_answers(s, entry, &place);
	for (size_t r = 0; r < h->site->n_run; r++)
		if (use[r])
			least = fmin(least,
			    trust_largest_feed_difference(&h->site->run[r].feed,
				site_feed_of_run(entry->site, feed_run)));
	return least;
}

static bool
has_fit_too_poor_for_band(const struct session *s, const struct entry *entry)
{
	const struct evidence *e = trust_evidence_of_calibration(s, entry);
	return e != NULL && trust_is_band_impossible(e->rmse, e->speeds);
}

/* True if the model's settings are those of the fit. */
static bool
are_settings_those_of_fit(const struct session *s, const struct entry *entry)
{
	const struct fit *fit = origin_fit_behind_params(entry);
	return fit != NULL &&
	       model_settings_are_same(&s->set.model, &fit->settings);
}

struct model_settings
model_settings_with_scenario(const struct session *s, const struct entry *entry)
{
	struct model_settings settings = s->set.model;
	const struct scenario *w = entry->scenario;
	if (w == NULL)
		return settings;
	settings.bypass = w->bypass;
	settings.k = w->k > 0 ? w->k : settings.k;
	return settings;
}

/* Returns the posterior behind the entry's answers, or NULL if these are those
 * of the model alone. */
static const struct posterior *
posterior_unless_correction_off(
    const struct session *s, const struct entry *entry)
{
	bool off = correction_in_use(s, entry) == CORRECTION_OFF ||
		   session_entry_being_fitted(s) != NULL;
	bool none = off || !are_settings_those_of_fit(s, entry) ||
		    has_fit_too_poor_for_band(s, entry);
	return none ? NULL : posterior_even_if_correction_off(s, entry);
}

const struct posterior *
posterior_for_unseen_cuts(
    const struct session *s, const struct entry *entry, bool training_only)
{
	if (!are_settings_those_of_fit(s, entry) ||
	    has_fit_too_poor_for_band(s, entry))
		return NULL;
	return training_only
		   ? posterior_of_calibration(s, entry, CORRECTION_TRAIN)
		   : posterior_even_if_correction_off(s, entry);
}

const struct posterior *
posterior_if_params_of_entry(const struct session *s, const struct entry *entry,
    const struct params *params)
{
	return memcmp(params, &entry->params, sizeof *params) == 0
		   ? posterior_unless_correction_off(s, entry)
		   : NULL;
}

struct crusher *
crusher_new_for_answers(const struct session *s, const struct entry *entry,
    const double *size, size_t n)
{
	return crusher_new(size, n, &entry->params,
	    model_settings_with_scenario(s, entry),
	    posterior_unless_correction_off(s, entry));
}

struct ensemble *
ensemble_for_answers(
    const struct session *s, const struct entry *entry, size_t feed_run)
{
	const struct posterior *p = posterior_unless_correction_off(s, entry);
	if (p == NULL)
		return NULL;
	struct history *h = entry->origin->history;
	size_t other = site_run_at_speed(entry->site, SITE_OTHER_FEED);
	/* If all runs share a feed, any run stands for it. */
	if (!entry->site->individual_feeds && other == entry->site->n_run)
		feed_run = 0;
	struct ensemble_of *kept = &h->kept[feed_run < entry->site->n_run];
	if (kept->ensemble != NULL && kept->posterior == p &&
	    kept->site == entry->site && kept->feed_run == feed_run)
		return kept->ensemble;
	ensemble_free(kept->ensemble);
	const struct psd *feed = site_feed_of_run(entry->site, feed_run);
	struct psd sizes = predict_list_table_sieves(entry->site, feed);
	*kept = (struct ensemble_of){p, entry->site, feed_run,
	    ensemble_new(p, feed, sizes.size, sizes.n)};
	ensemble_set_machine_settings(
	    kept->ensemble, model_settings_with_scenario(s, entry));
	psd_free(&sizes);
	return kept->ensemble;
}

const char *
band_why_missing(const struct session *s, const struct entry *entry)
{
	const struct fit *fit = origin_fit_behind_params(entry);
	return fit == NULL ? tr("no uncertainty band: the parameters do not "
				"come from a calibration in this session")
	       : fit->stop == CALIBRATE_STOPPED
		   ? tr("no uncertainty band: the calibration was stopped")
	       : fit_has_too_few_data(fit)
		   ? tr("no uncertainty band: too few data for the number of "
			"parameters")
	       : has_fit_too_poor_for_band(s, entry)
		   ? tr("no uncertainty band: the fit is poor, and two speeds "
			"do not show how its error changes with the speed; "
			"measure a third")
	       : !are_settings_those_of_fit(s, entry)
		   ? tr("no uncertainty band: the site was calibrated with "
			"other settings")
	       : correction_in_use(s, entry) == CORRECTION_OFF
		   ? tr("no uncertainty band for the model alone: 'set "
			"correction all' gives one")
		   : tr("no uncertainty band: its draws are not complete");
}

bool
band_set_error_missing(
    const struct session *s, const struct entry *entry, struct error *error)
{
	const struct fit *fit = origin_fit_behind_params(entry);
	return error_set(error, ERROR_USAGE, "%s\n%s",
	    band_why_missing(s, entry),
	    fit == NULL                      ? tr("run 'calibrate' first")
	    : fit->stop == CALIBRATE_STOPPED ? tr("run 'calibrate' again")
	    : fit_has_too_few_data(fit) || has_fit_too_poor_for_band(s, entry)
		? tr("add sieves or a run to the sheet, then 'calibrate' again")
	    : !are_settings_those_of_fit(s, entry)
		? tr("'set' shows the settings")
	    : correction_in_use(s, entry) != CORRECTION_OFF
		? tr("run 'calibrate' again")
	    : s->set.correction != CORRECTION_OFF
		? tr("leave out correction=off")
		: tr("write: set correction all"));
}

const char *
correction_name(const struct session *s, const struct entry *entry)
{
	static const char *const NAME[] = {[CORRECTION_ALL] = "all",
	    [CORRECTION_TRAIN] = "train",
	    [CORRECTION_OFF] = "off"};
	return NAME[correction_in_use(s, entry)];
}

_Static_assert(POSTERIOR_RUNS == 40, "the text of correction_in_words");

const char *
correction_in_words(const struct session *s, const struct entry *entry)
{
	if (posterior_unless_correction_off(s, entry) == NULL)
		return tr("the model alone");
	const struct site *site = entry->origin->history->site;
	size_t place, n = 0;
	FREED bool *use = mark_runs_that_inform_answers(s, entry, &place);
	for (size_t r = 0; r < site->n_run; r++)
		n += use[r];
	if (n > POSTERIOR_RUNS)
		return tr("model corrected by 40 of the runs, from the "
			  "slowest to the fastest");
	bool former = entry->has_fit &&
		      entry->history->site->digest != entry->site->digest;
	return correction_in_use(s, entry) == CORRECTION_TRAIN
		   ? tr("model corrected by the training runs")
	       : former ? tr("model corrected by the runs measured before the "
			     "calibration, not by those added since")
			: tr("model corrected by all measured runs");
}

const char *
correction_legend_text(const struct session *s, const struct entry *entry,
    const struct prediction *p)
{
	static const char *const WORDS[] = {[CORRECTION_ALL] = N_(", all runs"),
	    [CORRECTION_TRAIN] = N_(", training runs"),
	    [CORRECTION_OFF] = N_(", model")};
	enum correction asked = correction_in_use(s, entry);
	return p->low != NULL || asked == CORRECTION_OFF ? tr(WORDS[asked])
							 : "";
}

void
correction_note_unless_all(
    struct answer *r, const struct session *s, const struct entry *entry)
{
	if (correction_in_use(s, entry) != CORRECTION_ALL)
		answer_add_sentence(
		    r, ANSWER_REMARK, "%s", correction_in_words(s, entry));
}

void
band_note_meaning(struct answer *r, const struct session *s,
    const struct entry *entry, bool product)
{
	if (!product) {
		answer_add_sentence(r, ANSWER_REMARK,
		    "low, high: the middle %.0f %% of the draws; the value is "
		    "the fit to the training runs, and may lie outside",
		    100 * settings_band_probability(&s->set));
		if (entry->params.breakage == 0 && s->set.model.impacts.n == 0)
			answer_add_sentence(r, ANSWER_REMARK,
			    "at 72 to 87 of 100 synthetic plants that follow "
			    "Eqs 1 to 3, such ranges held the truth; those of "
			    "the break size at 52 to 77");
		if (!entry->has_fit)
			answer_add_sentence(r, ANSWER_REMARK,
			    "the difference between the two sites is not "
			    "included");
		return;
	}
	answer_add_sentence(
	    r, ANSWER_REMARK, "%s", correction_in_words(s, entry));
	answer_add_sentence(r, ANSWER_REMARK,
	    entry->has_fit
		? N_("low, high: the true value lies between them with %.0f "
		     "%% probability")
		: N_("low, high: the true value lies between them with %.0f "
		     "%% probability; the difference between the two sites is "
		     "not included"),
	    100 * settings_band_probability(&s->set));
	if (s->set.speed_sd > 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    "low and high allow for tip speeds that are off by %g %% "
		    "('set speed_sd')",
		    s->set.speed_sd);
}
