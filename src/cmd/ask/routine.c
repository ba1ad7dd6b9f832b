/* Sorts the cuts by date, computes the residuals at the sieves that crushing
 * can change, and charts them (drift_compute_charts).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/routine.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/cut.h"
#include "cmd/ask/outlook.h"
#include "core/posterior/ensemble.h"
#include "core/search/misfit.h"
#include "core/model/product.h"
#include "io/cells/datetime.h"
#include "io/sitefile/units.h"

const char *const ROUTINE_STATE[5] = {[DRIFT_NONE] = "ok",
    [DRIFT_COARSER] = N_("coarser"),
    [DRIFT_FINER] = N_("finer"),
    [DRIFT_FLATTER] = N_("flatter"),
    [DRIFT_STEEPER] = N_("steeper")};

/* Sets the date of a cut, in words and in seconds.  order: which number of a
 * date such as 5/11/2026 is the day. */
static void
set_date_of_cut(struct routine_cut *c, const struct site_note *note,
    enum datetime_order order)
{
	struct datetime m;
	c->time = NAN;
	if (note != NULL && cut_parse_date(note, &m))
		c->time = datetime_seconds_since_1970(&m, order);
	c->when = isnan(c->time) ? xstrdup("") : datetime_to_text(c->time);
	if (!isnan(c->time) && !m.has_time)
		c->when[strcspn(c->when, " ")] = '\0';
}

/* True if a run is a routine cut.  One that was there at the calibration is a
 * routine cut only if a note says so and it was held out; *seen is then true,
 * because the training runs alone must predict it. */
static bool
is_routine_belt_cut(const struct entry *entry, size_t run, bool *seen)
{
	const struct site *site = entry->site;
	const struct history *h = origin_fit_behind_params(entry) != NULL
				      ? entry->origin->history
				      : NULL;
	bool noted = cut_find_note(site, run) != NULL, trained = false;
	*seen = false;
	if (misfit_count_covered_sieves(&site->run[run]) == 0)
		return false;
	for (size_t r = 0; h != NULL && r < h->site->n_run; r++)
		if (cut_is_duplicate(&h->site->run[r], &site->run[run])) {
			*seen = true;
			trained = trained || h->train[r];
		}
	return noted ? !trained : entry->has_fit && !*seen;
}

/* Returns the index of the cut's note in the site.  Notes are in the order in
 * which the cuts were added. */
static size_t
index_of_cut_note(const struct site *site, const struct routine_cut *c)
{
	const struct site_note *note = cut_find_note(site, c->run);
	return note != NULL ? (size_t)(note - site->note) : site->n_note;
}

/* Sorts by insertion: the cuts are few and nearly in order. */
static void
sort_cuts_by_date(struct routine *r, const struct site *site)
{
	r->dated = true;
	for (size_t i = 0; i < r->n; i++)
		r->dated = r->dated && !isnan(r->cut[i].time);
	for (size_t i = 1; i < r->n; i++)
		for (size_t j = i; j > 0; j--) {
			struct routine_cut *a = &r->cut[j - 1], *b = a + 1;
			size_t one = index_of_cut_note(site, a),
			       two = index_of_cut_note(site, b);
			bool later = r->dated && a->time != b->time
					 ? a->time > b->time
					 : one > two;
			if (!later)
				break;
			struct routine_cut swap = *a;
			*a = *b;
			*b = swap;
		}
}

static void
find_routine_belt_cuts(struct routine *r, const struct entry *entry)
{
	const struct site *site = entry->site;
	enum datetime_order order = cut_day_month_order(site);
	r->cut = xcalloc(site->n_run + 1, sizeof *r->cut);
	for (size_t i = 0; i < site->n_run; i++) {
		bool seen;
		if (!is_routine_belt_cut(entry, i, &seen))
			continue;
		struct routine_cut *c = &r->cut[r->n++];
		r->training_only = r->training_only || seen;
		c->run = i;
		c->speed = site->run[i].speed;
		set_date_of_cut(c, cut_find_note(site, i), order);
	}
	sort_cuts_by_date(r, site);
}

/* Sets the sieves that crushing can change and the passings measured there. */
static void
set_sieves_of_cut(struct routine_cut *c, const struct run *run)
{
	size_t n = misfit_count_covered_sieves(run), from = 0;
	while (from + 1 < n &&
	       !(psd_passing(&run->feed, run->product.size[from]) < 1))
		from++;
	c->n = n - from;
	c->size = xcalloc_doubles(c->n);
	c->measured = xcalloc_doubles(c->n);
	c->predicted = xcalloc_doubles(c->n);
	c->error = xcalloc_doubles(c->n * c->n);
	memcpy(c->size, run->product.size + from, c->n * sizeof(double));
	memcpy(c->measured, run->product.passing + from, c->n * sizeof(double));
}

static void
predict_cut_by_posterior(
    struct routine_cut *c, const struct psd *feed, const struct posterior *p)
{
	size_t n = c->n * POSTERIOR_DRAWS;
	struct ensemble *e = ensemble_new(p, feed, c->size, c->n);
	ensemble_set_speed(e, c->speed);
	ensemble_mean_answer(e, c->predicted);
	c->truth = xcalloc_doubles(n);
	memcpy(c->truth, ensemble_products(e, ENSEMBLE_ANSWER),
	    n * sizeof *c->truth);
	ensemble_free(e);
	drift_covariance_of_errors(p, c->size, c->predicted, c->n, c->error);
}

static void
predict_cut_by_model_alone(struct routine_cut *c, const struct psd *feed,
    const struct params *params, struct model_settings settings, double noise)
{
	struct model *model = model_new(feed, c->size, c->n, settings);
	model_set_params(model, params);
	model_compute_product(model, c->speed, c->predicted);
	model_free(model);
	drift_covariance_of_known_error(noise, c->predicted, c->n, c->error);
}

static double
measured_minus_predicted(const struct routine_cut *c, size_t i)
{
	return c->measured[i] - c->predicted[i];
}

static void
compute_control_chart_points(struct routine *r)
{
	FREED struct drift_cut *cut = xcalloc(r->n, sizeof *cut);
	FREED double **residuals = xcalloc(r->n, sizeof(*residuals));
	r->point = xcalloc(r->n, sizeof *r->point);
	for (size_t j = 0; j < r->n; j++) {
		struct routine_cut *c = &r->cut[j];
		double *off = residuals[j] = xcalloc_doubles(c->n);
		for (size_t i = 0; i < c->n; i++) {
			off[i] = measured_minus_predicted(c, i);
			if (fabs(off[i]) > fabs(off[c->worst]))
				c->worst = i;
		}
		cut[j] = (struct drift_cut){c->n, c->size, off,
		    c->truth != NULL ? POSTERIOR_DRAWS : 0, c->truth, c->error};
	}
	r->first =
	    drift_compute_charts(cut, r->n, &r->rule, r->point, &r->since);
	for (size_t j = 0; j < r->n; j++)
		free(residuals[j]);
}

/* Counts how many of the last cuts in a row are on the same side of the
 * prediction. */
static void
count_last_cuts_on_one_side(struct routine *r)
{
	bool above = r->point[r->n - 1].chart[DRIFT_LEVEL].value > 0;
	while (r->running < r->n) {
		const struct drift_point *p = &r->point[r->n - 1 - r->running];
		if ((p->chart[DRIFT_LEVEL].value > 0) != above)
			break;
		r->running++;
	}
}

/* Finds the sieve at which these last cuts differ most from the prediction. */
static void
find_sieve_of_largest_shift(struct routine *r)
{
	const struct routine_cut *last = &r->cut[r->n - 1];
	for (size_t i = 0; i < last->n; i++) {
		double sum = 0;
		size_t n = 0;
		for (size_t j = r->n - r->running; j < r->n; j++)
			for (size_t k = 0; k < r->cut[j].n; k++) {
				const struct routine_cut *c = &r->cut[j];
				if (fabs(c->size[k] / last->size[i] - 1) > 1e-6)
					continue;
				sum += measured_minus_predicted(c, k);
				n++;
			}
		double mean = sum / (double)n;
		if (fabs(mean) > fabs(r->by)) {
			r->by = mean;
			r->worst = last->size[i];
		}
	}
}

static struct routine *
set_error_why_no_charts(
    struct routine *r, const struct entry *entry, struct error *error)
{
	if (r->n == 0)
		error_set(error, ERROR_USAGE,
		    entry->has_fit
			? N_("expected cuts that came after the calibration, "
			     "got none\n"
			     "add one: add cut.csv@72 date=2026-05-03")
			: N_("expected routine cuts, got none\n"
			     "add one: add cut.csv@72 date=2026-05-03"));
	else
		error_set(error, ERROR_USAGE,
		    "expected a calibration or a known sampling error to find "
		    "limits from, got neither\n"
		    "run 'calibrate', or state the error of a passing: set "
		    "noise 0.5");
	control_charts_free(r);
	return NULL;
}

struct routine *
control_charts_compute(const struct session *s, const struct entry *entry,
    const struct drift_rule *rule, struct error *error)
{
	struct routine *r = xcalloc(1, sizeof *r);
	r->rule = *rule;
	find_routine_belt_cuts(r, entry);
	if (r->n == 0)
		return set_error_why_no_charts(r, entry, error);
	const struct posterior *p =
	    posterior_for_unseen_cuts(s, entry, r->training_only);
	r->drawn = p != NULL;
	if (!r->drawn && !(s->set.noise > 0))
		return set_error_why_no_charts(r, entry, error);
	for (size_t j = 0; j < r->n; j++) {
		struct routine_cut *c = &r->cut[j];
		const struct run *run = &entry->site->run[c->run];
		set_sieves_of_cut(c, run);
		if (r->drawn)
			predict_cut_by_posterior(c, &run->feed, p);
		else
			predict_cut_by_model_alone(c, &run->feed,
			    &entry->params, s->set.model, s->set.noise / 100);
	}
	compute_control_chart_points(r);
	count_last_cuts_on_one_side(r);
	find_sieve_of_largest_shift(r);
	return r;
}

void
control_charts_free(struct routine *r)
{
	for (size_t j = 0; r != NULL && j < r->n; j++) {
		struct routine_cut *c = &r->cut[j];
		free(c->when);
		free(c->size);
		free(c->measured);
		free(c->predicted);
		free(c->truth);
		free(c->error);
	}
	if (r == NULL)
		return;
	free(r->cut);
	free(r->point);
	free(r);
}

/* Returns "four times running".  The caller frees it. */
static char *
times_in_a_row_text(size_t n)
{
	static const char *const WORDS[] = {"", N_("once"), N_("twice running"),
	    N_("three times running"), N_("four times running"),
	    N_("five times running"), N_("six times running"),
	    N_("seven times running"), N_("eight times running"),
	    N_("nine times running"), N_("ten times running")};
	return n < ARRAY_LEN(WORDS) ? xstrdup(tr(WORDS[n]))
				    : xasprintf(tr("%zu times running"), n);
}

char *
drift_in_words(const struct routine *r)
{
	static const char *const LOOK[] = {
	    [DRIFT_COARSER] = N_("look at rotor tips, feed or screen cloth"),
	    [DRIFT_FINER] =
		N_("look at the rotor's speed, its feed rate and feed"),
	    [DRIFT_FLATTER] = N_("look at screen cloth, feed and how cuts are "
				 "taken"),
	    [DRIFT_STEEPER] = N_("look at feed, loss of fines and how cuts are "
				 "taken")};
	enum drift_state state = r->point[r->n - 1].state;
	if (state == DRIFT_NONE && r->n < ROUTINE_FEW && r->first == r->n)
		return xstrdup(
		    tr("no sign of drift: measured and predicted products "
		       "differ by no more than samples do"));
	if (state == DRIFT_NONE)
		return r->first < r->n
			   ? xasprintf(
				 tr("back within the limits after a signal "
				    "at cut %zu"),
				 r->first + 1)
			   : xstrdup(tr("no drift: cuts and predictions differ "
					"by no more than samples do"));
	FREED char *most =
	    xasprintf(tr("most at %g mm (%+.1f points on average)"),
		units_m_to_mm(r->worst), -100 * r->by);
	bool tilt = state == DRIFT_FLATTER || state == DRIFT_STEEPER;
	FREED char *count = times_in_a_row_text(r->running);
	return tilt ? xasprintf(tr("a %s curve than predicted, %s: %s"),
			  tr(ROUTINE_STATE[state]), most, tr(LOOK[state]))
		    : xasprintf(tr("%s than predicted %s, %s: %s"),
			  tr(ROUTINE_STATE[state]), count, most,
			  tr(LOOK[state]));
}

char *
drift_alarm_in_words(const struct session *s, const struct entry *entry)
{
	if (!entry->has_fit || entry->history == NULL)
		return NULL;
	struct alarm *a = &entry->history->alarm;
	const struct posterior *p = posterior_for_unseen_cuts(s, entry, false);
	if (p == NULL)
		return NULL;
	if (a->site != entry->site || a->posterior != p) {
		struct routine *r =
		    control_charts_compute(s, entry, &DRIFT_RULE, NULL);
		a->site = entry->site;
		a->posterior = p;
		a->state = r != NULL ? r->point[r->n - 1].state : DRIFT_NONE;
		control_charts_free(r);
	}
	if (a->state == DRIFT_NONE)
		return NULL;
	bool tilt = a->state == DRIFT_FLATTER || a->state == DRIFT_STEEPER;
	return xasprintf(
	    tilt ? tr("the last cuts have a curve that is %s than predicted: "
		      "see 'drift'")
		 : tr("the last cuts are %s than predicted: see 'drift'"),
	    tr(ROUTINE_STATE[a->state]));
}
