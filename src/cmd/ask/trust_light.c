/* Collects what is known about an entry, its calibration and the prediction,
 * for trust_judge_answer in core.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/trust_light.h"

#include <math.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/cut.h"
#include "cmd/session/energies.h"
#include "cmd/ask/fit.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/routine.h"
#include "core/psd/rotor_speed.h"
#include "core/search/misfit.h"
#include "io/sitefile/units.h"

/* A parameter on a bound is mentioned if the band is wider than NARROW on
 * average and it moves the answer by more than MOVES; both passings. */
static const double NARROW = 0.01, MOVES = 0.005;

static double
mean_band_width(const struct prediction *p)
{
	double sum = 0;
	size_t n = p->product.n, from = 0;
	/* Of the sieves that all of the feed passes only the finest counts. */
	while (from + 1 < n &&
	       psd_passing(&p->feed, p->product.size[from + 1]) >= 1)
		from++;
	for (size_t i = from; p->low != NULL && i < n; i++)
		sum += (p->high[i] - p->low[i]) / (double)(n - from);
	return sum;
}

/* Finds the parameter, of those on a bound, that moves the answer most. */
static void
find_param_on_bound_that_matters(const struct session *s,
    const struct entry *entry, const struct prediction *p,
    struct trust_question *q)
{
	const struct fit *fit = origin_fit_behind_params(entry);
	struct ensemble *e = ensemble_for_answers(s, entry, p->feed_run);
	if (e == NULL)
		return;
	ensemble_set_speed(e, p->speed);
	const struct breakage *of = breakage_model_of_params(&fit->params);
	for (size_t j = 0; j < of->n; j++) {
		const char *name = of->parameter[j].name;
		double moves =
		    fit->on_bound[j]
			? trust_answer_change_per_param_sd(
			      posterior_even_if_correction_off(s, entry), e,
			      name)
			: 0;
		if (moves > fmax(q->bound_moves, MOVES)) {
			q->bound = name;
			q->bound_moves = moves;
		}
	}
}

/* Adds reasons about parameters that no calibration of this site in this
 * session found. */
static void
add_trust_reasons_of_params_origin(
    struct trust *t, const struct session *s, const struct entry *entry)
{
	const struct origin *o = entry->origin;
	bool same = o->found && o->digest == entry->site->digest;
	if (same && origin_fit_behind_params(entry) != NULL)
		return;
	double error = fit_largest_rmse_of_runs(
	    entry, &entry->params, s->set.model, false);
	if (same)
		trust_add_reason(t, LIGHT_AMBER, TRUST_ORIGIN,
		    xasprintf(
			tr("parameters %s, calibrated on the same data in "
			   "another session: calibrate here to see how far "
			   "the data determine them"),
			origin_of_params_text(entry)));
	else if (isnan(error))
		trust_add_reason(t, LIGHT_RED, TRUST_ORIGIN,
		    xasprintf(tr("parameters %s, and no measured product of "
				 "this site to check them against"),
			origin_of_params_text(entry)));
	else
		trust_add_reason(t, error > FIT_POOR ? LIGHT_RED : LIGHT_AMBER,
		    TRUST_ORIGIN,
		    xasprintf(tr("parameters %s, not calibrated on this site: "
				 "they miss a measured product by %.1f points "
				 "(RMSE)"),
			origin_of_params_text(entry), 100 * error));
}

/* A misfit above the lowest one by more than this share leaves other parameters
 * to be found: within it lie those of a flat direction. */
static const double FAR_ABOVE_LOWEST = 0.1;

/* Adds reasons about how the calibration was made. */
static void
add_trust_reasons_of_calibration(
    struct trust *t, const struct session *s, const struct fit *fit)
{
	if (fit->stop == CALIBRATE_STOPPED)
		trust_add_reason(t, LIGHT_AMBER, TRUST_FIT,
		    xstrdup(
			tr("the calibration was stopped: 'continue' may find "
			   "better parameters")));
	else if (fit->lowest > 0 &&
		 fit->misfit > (1 + FAR_ABOVE_LOWEST) * fit->lowest)
		trust_add_reason(t, LIGHT_AMBER, TRUST_FIT,
		    xasprintf(tr("the search ended %.0f %% above the lowest "
				 "misfit: 'calibrate' finds better parameters"),
			100 * (fit->misfit / fit->lowest - 1)));
	else if (!fit->converged && !(fit->lowest > 0))
		trust_add_reason(t, LIGHT_AMBER, TRUST_FIT,
		    xstrdup(
			tr("the calibration has not converged: the misfit can "
			   "still fall, so that another seed may give other "
			   "parameters")));
	if (!model_settings_are_same(&s->set.model, &fit->settings))
		trust_add_reason(t, LIGHT_AMBER, TRUST_FIT,
		    xstrdup(tr("the site was calibrated with other settings: "
			       "calibrate again")));
}

/* Adds reasons about the cuts added after the calibration: that they drift, and
 * which one is missed most.  If they drift, the text does not advise a
 * calibration with them: the crusher should be looked at first. */
static void
add_trust_reasons_of_later_cuts(
    struct trust *t, const struct session *s, const struct entry *entry)
{
	struct later later = cut_compare_runs_since_fit(s, entry);
	char *alarm = drift_alarm_in_words(s, entry);
	bool drifts = alarm != NULL;
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, later.speed, NAN);
	if (drifts)
		trust_add_reason(t, LIGHT_AMBER, TRUST_HOLDOUT, alarm);
	if (later.missed)
		trust_add_reason(t,
		    later.rms > FIT_POOR ? LIGHT_RED : LIGHT_AMBER,
		    TRUST_HOLDOUT,
		    xasprintf(
			drifts
			    ? tr("the cut at %g m/s%s, added after the "
				 "calibration, is missed by %.1f points (RMS)")
			    : tr("the cut at %g m/s%s, added after the "
				 "calibration, is missed by %.1f points "
				 "(RMS): calibrate again with train=all"),
			later.speed, rpm, 100 * later.rms));
}

/* Adds reasons about a feed or a machine with which nothing was measured.
 * evidence: about the fit, or NULL. */
static void
add_trust_reasons_of_feed_or_machine(struct trust *t, const struct session *s,
    const struct entry *entry, const struct evidence *evidence)
{
	const struct scenario *w = entry->scenario;
	const char *rock = w->own->site->rock, *other = w->rock;
	double measured = entry_rotor_of_calibration(w->own);
	if (other[0] != '\0' && rock[0] != '\0' &&
	    !text_is_same_folded(other, rock))
		trust_add_reason(t, LIGHT_RED, TRUST_FEED,
		    xasprintf(
			tr("the feed is %s and the site's rock is %s: no "
			   "measurement shows how the feed's rock breaks"),
			other, rock));
	if (w->feed != NULL && evidence == NULL)
		trust_add_reason(t, LIGHT_AMBER, TRUST_FEED,
		    xstrdup(tr("the feeds behind the parameters are not known: "
			       "this feed may break differently")));
	if (w->rotor > 0 && measured > 0 && fabs(w->rotor - measured) > 5e-4)
		trust_add_reason(t, LIGHT_AMBER, TRUST_MACHINE,
		    xasprintf(
			tr("the runs were measured with a rotor of %g mm: "
			   "no measurement shows the effect of another "
			   "rotor diameter (%g mm)"),
			units_m_to_mm(measured), units_m_to_mm(w->rotor)));
	if (w->bypass > 0)
		trust_add_reason(t, LIGHT_AMBER, TRUST_MACHINE,
		    xasprintf(tr("no measurement shows the effect of another "
				 "cascade share (%g %% of the feed, taken as "
				 "uncrushed: the coarsest case)"),
			100 * w->bypass));
	if (w->k > 0 && w->k != s->set.model.k)
		trust_add_reason(t, LIGHT_AMBER, TRUST_MACHINE,
		    xasprintf(tr("no measurement shows the effect of another "
				 "number of impacts (%g instead of %g)"),
			w->k, s->set.model.k));
}

/* Returns evidence that only has the speeds, for parameters that no calibration
 * in this session found. */
static struct evidence
trust_evidence_from_speeds_only(const struct entry *entry)
{
	struct evidence e = {.speeds = 2, .cells = 100};
	if (!origin_training_speed_range(entry, &e.slowest, &e.fastest)) {
		e.slowest = 0;
		e.fastest = INFINITY;
	}
	return e;
}

static struct trust
judge_trust_in_answer(const struct session *s, const struct entry *entry,
    const struct prediction *p, const struct evidence *e, bool later)
{
	struct trust t = {0};
	bool off = correction_in_use(s, entry) == CORRECTION_OFF;
	struct trust_question q = {.speed = p != NULL ? p->speed : 0,
	    .rotor = entry->site->run_rotor > 0 ? 0 : entry->site->rotor,
	    .corrected = !off};
	struct evidence reach = trust_evidence_from_speeds_only(entry);
	/* The site's own measurements are judged without the question's
	 * changes. */
	const struct entry *own = entry_without_scenario(entry);
	if (later)
		add_trust_reasons_of_later_cuts(&t, s, own);
	if (entry->scenario != NULL)
		add_trust_reasons_of_feed_or_machine(&t, s, entry, e);
	if (p != NULL)
		q.width = mean_band_width(p);
	if (p != NULL && e != NULL)
		t.speed_sd = s->set.speed_sd / 100;
	if (p != NULL && e != NULL && entry->scenario != NULL &&
	    entry->scenario->feed != NULL)
		q.feed = difference_from_nearest_feed(s, entry, p->feed_run);
	if (q.width > NARROW && e != NULL)
		find_param_on_bound_that_matters(s, entry, p, &q);
	if (!entry->has_fit)
		add_trust_reasons_of_params_origin(&t, s, own);
	if (e != NULL && !e->like_feed)
		add_trust_reasons_of_calibration(
		    &t, s, origin_fit_behind_params(entry));
	char *energies = energies_trust_reason(s);
	if (energies != NULL)
		trust_add_reason(&t, LIGHT_AMBER, TRUST_MACHINE, energies);
	trust_judge_answer(&t, e != NULL ? e : &reach, &q);
	return t;
}

struct trust
trust_in_answer_or_fit(const struct session *s, const struct entry *entry,
    const struct prediction *p)
{
	struct trust t = {0};
	if (p != NULL &&
	    session_entry_being_fitted(s) == entry_without_scenario(entry)) {
		trust_add_reason(&t, LIGHT_AMBER, TRUST_FIT,
		    xstrdup(tr("a calibration is running: parameters change")));
		return t;
	}
	return judge_trust_in_answer(
	    s, entry, p, trust_evidence_of_calibration(s, entry), true);
}

enum light
light_of_answer_or_fit(const struct session *s, const struct entry *entry,
    const struct prediction *p)
{
	struct trust t = trust_in_answer_or_fit(s, entry, p);
	enum light light = t.light;
	trust_free(&t);
	return light;
}

void
trust_replace_if_worse(struct trust *worst, struct trust t)
{
	struct trust less = t.light > worst->light ? *worst : t;
	double speed_sd = fmax(worst->speed_sd, t.speed_sd);
	if (t.light > worst->light)
		*worst = t;
	worst->speed_sd = speed_sd;
	trust_free(&less);
}

struct trust
trust_worst_of_predictions(const struct session *s, const struct entry *entry,
    const struct prediction *p, size_t n)
{
	struct trust worst = trust_in_answer_or_fit(s, entry, &p[0]);
	for (size_t i = 1; i < n; i++)
		trust_replace_if_worse(
		    &worst, trust_in_answer_or_fit(s, entry, &p[i]));
	return worst;
}

/* Returns "amber: " and the first reason, or "green" and on what condition.
 * The caller frees it. */
static char *
trust_light_and_reason_text(const struct trust *t)
{
	const char *name = tr(LIGHT_NAME[t->light]);
	if (t->n > 0)
		return xasprintf("%s: %s", name, t->reason[0].text);
	return t->speed_sd > 0
		   ? xasprintf(tr("%s, if tip speeds are accurate to %g %%"),
			 name, 100 * t->speed_sd)
		   : xstrdup(name);
}

struct trust
trust_at_speed(const struct session *s, const struct entry *entry, double speed,
    size_t feed)
{
	struct prediction p = forecast_whole_product(s, entry, speed, feed);
	struct trust t = trust_in_answer_or_fit(s, entry, &p);
	prediction_free(&p);
	return t;
}

char *
trust_in_words_at_speed(const struct session *s, const struct entry *entry,
    double speed, size_t feed)
{
	struct trust t = trust_at_speed(s, entry, speed, feed);
	FREED char *words = trust_light_and_reason_text(&t);
	FREED char *rpm = rotor_speed_rpm_text(entry->site->rotor, speed, NAN);
	char *said = xasprintf(tr("trust at %g m/s%s: %s"), speed, rpm, words);
	trust_free(&t);
	return said;
}

void
trust_put_fields(struct fields *o, const struct trust *t)
{
	fields_put_values(o, "trust %s", LIGHT_NAME[t->light]);
	struct fields *list = fields_add_list(o, "reasons");
	for (size_t i = 0; i < t->n; i++)
		fields_put_values(list, "%s", t->reason[i].text);
}

void
trust_add_to_answer_at_speed(
    struct answer *r, const struct site *site, double speed, struct trust t)
{
	static const enum answer_grade GRADE[] = {
	    ANSWER_PLAIN, ANSWER_REMARK, ANSWER_WARNING};
	FREED char *words = trust_light_and_reason_text(&t);
	const char *why = t.n > 0 ? tr(" ('why' explains)") : "";
	FREED char *rpm =
	    rotor_speed_rpm_text(speed > 0 ? site->rotor : 0, speed, NAN);
	if (speed > 0)
		answer_add_sentence(r, GRADE[t.light],
		    "trust at %g m/s%s: %s%s", speed, rpm, words, why);
	else
		answer_add_sentence(
		    r, GRADE[t.light], "trust: %s%s", words, why);
	trust_put_fields(answer_json_fields(r), &t);
	trust_free(&t);
}

void
trust_add_to_answer(struct answer *r, struct trust t)
{
	trust_add_to_answer_at_speed(r, NULL, 0, t);
}

const char *
verdict_on_fit(const struct entry *entry, enum light light)
{
	const struct fit *fit = &entry->fit;
	return fit->rmse > FIT_POOR         ? tr("poor")
	       : fit_has_too_few_data(fit)  ? tr("too few data")
	       : fit_has_no_breakage(entry) ? tr("nothing breaks")
	       : light == LIGHT_GREEN       ? tr("good")
					    : tr("doubtful");
}

const char *
fit_verdict_without_posterior(
    const struct session *s, const struct entry *entry)
{
	struct evidence e = trust_evidence_without_posterior(s, entry);
	/* No cut has been added since this calibration. */
	struct trust t = judge_trust_in_answer(s, entry, NULL, &e, false);
	const char *verdict = verdict_on_fit(entry, t.light);
	trust_free(&t);
	return verdict;
}
