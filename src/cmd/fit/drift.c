/* drift: control charts of routine cuts, compared with their predictions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/cut.h"
#include "cmd/ask/routine.h"
#include "cmd/ask/trust_light.h"
#include "cmd/lang/table.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

static const uint64_t SEED = 1; /* seed of the simulated run lengths */

/* charts: also add the numbers of the charts.  Programs get measured minus
 * predicted; people get predicted minus measured, as in all other
 * comparisons. */
static void
add_belt_cut_rows_to_answer(
    struct answer *a, const struct routine *r, bool charts, bool programs)
{
	double sign = programs ? 1 : -1;
	answer_add_columns(a, "cut, date, speed: m/s, mean_points: mean, "
			      "worst_points: most, worst_mm: mm");
	if (charts)
		answer_add_columns(a,
		    "ewma: EWMA, ewma_limit: max, cusum_up: "
		    "fine, cusum_down: coarse, tilt_cusum: tilt");
	answer_add_columns(a, "state");
	for (size_t j = 0; j < r->n; j++) {
		const struct routine_cut *c = &r->cut[j];
		const struct drift_point *p = &r->point[j];
		const struct drift_chart *level = &p->chart[DRIFT_LEVEL];
		const struct drift_chart *tilt = &p->chart[DRIFT_TILT];
		double worst = c->measured[c->worst] - c->predicted[c->worst];
		FREED char *day = xstrndup(c->when, strcspn(c->when, " T"));
		answer_add_cells(a, "%g", (double)(j + 1));
		answer_add_keyed_cell(a, c->when, day[0] != '\0' ? day : "-");
		answer_add_cells(a, "%g %.1f %.1f %g", c->speed,
		    sign * 100 * level->value, sign * 100 * worst,
		    units_m_to_mm(c->size[c->worst]));
		if (charts)
			answer_add_cells(a, "%.1f %.1f %.1f %.1f %.1f",
			    sign * level->ewma, level->ewma_limit, level->up,
			    level->down,
			    sign * (tilt->down > tilt->up ? -tilt->down
							  : tilt->up));
		answer_add_cells(a, "%s", tr(ROUTINE_STATE[p->state]));
	}
}

/* Returns "5 (2026-05-18)". */
static char *
cut_number_and_date_text(const struct routine *r, size_t cut)
{
	const char *when = r->cut[cut].when;
	return when[0] != '\0' ? xasprintf("%zu (%s)", cut + 1, when)
			       : xasprintf("%zu", cut + 1);
}

/* Returns the different speeds of the cuts from `from` on, "72,76", and sets *n
 * to their number. */
static char *
speeds_of_cuts_text(const struct routine *r, size_t *n)
{
	char *list = xstrdup("");
	*n = 0;
	for (size_t j = r->since; j < r->n; j++) {
		bool known = false;
		for (size_t i = r->since; i < j; i++)
			known = known || r->cut[i].speed == r->cut[j].speed;
		if (known)
			continue;
		xappend_to_list(&list, ",", "%g", r->cut[j].speed);
		++*n;
	}
	return list;
}

/* A drift that takes more cuts than this to find counts as not found. */
enum { MOST_CUTS = 50 };

/* Says when the drift began, if the last cut signals one. */
static void
note_when_drift_began(struct answer *a, const struct routine *r)
{
	if (r->point[r->n - 1].state == DRIFT_NONE)
		return;
	FREED char *since = cut_number_and_date_text(r, r->since),
		   *first = cut_number_and_date_text(r, r->first);
	answer_note(a,
	    "it began at about cut %s; by cut %s it was more than chance",
	    since, first);
}

/* Says when to calibrate again, and with what. */
static void
note_when_to_recalibrate(struct answer *a, const struct entry *entry,
    const struct routine *r, const struct later *later)
{
	size_t n;
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, later->speed, NAN);
	if (r->point[r->n - 1].state == DRIFT_NONE && later->missed) {
		answer_note(a,
		    "next: check how the cut at %g m/s%s and its feed were "
		    "taken; if they are right, 'calibrate train=all'",
		    later->speed, rpm);
		return;
	}
	if (r->point[r->n - 1].state == DRIFT_NONE) {
		bool take = later->n > 0 && !later->off && !later->twice;
		answer_note(a,
		    take ? N_("next: 'calibrate' includes the cuts since the "
			      "last calibration in the answers; 'remember' "
			      "keeps them")
		    : later->off ? N_("next: take one more cut before anything "
				      "is changed")
		    : entry->has_fit
			? N_("next: nothing needs to be done; 'remember' keeps "
			     "these cuts, and 'add' takes the next one")
			: N_("next: nothing needs to be done; 'add' takes the "
			     "next cut"));
		return;
	}
	FREED char *since = cut_number_and_date_text(r, r->since);
	FREED char *speeds = speeds_of_cuts_text(r, &n);
	answer_note(a,
	    n > 1
		? N_("next: find the cause; if the change is permanent, sample "
		     "feed and product anew: 'template speeds=%s > new.csv' "
		     "has the columns for them and for the cuts from %s on")
		: N_("next: find the cause; if the change is permanent, sample "
		     "feed and product anew, also at another speed: 'template "
		     "speeds=%s > new.csv' has the columns for them and for "
		     "the cuts from %s on"),
	    speeds, since);
}

/* Returns the smallest shift of the mean passing, in steps of half a point,
 * that the next cut alone would show in half of all cases; NAN if it is MOST or
 * more. */
static double
smallest_shift_one_cut_shows(const struct routine *r)
{
	const double STEP = 0.005, MOST = 0.1;
	size_t known = r->since < r->n ? r->since : r->n;
	for (double shift = STEP; shift < MOST; shift += STEP)
		if (drift_detection_delay(
			&r->rule, r->point, r->n, known, shift, SEED) <= 1)
			return shift;
	return NAN;
}

/* Says what a few cuts can show.  With fewer than MEASURES cuts, the smallest
 * change depends mostly on whether the calibration included them. */
static void
note_what_few_cuts_show(struct answer *a, const struct routine *r)
{
	enum { MEASURES = 3 };
	bool measures = r->n >= MEASURES;
	double sudden =
	    measures ? smallest_shift_one_cut_shows(r) : (double)NAN;
	FREED char *words =
	    xasprintf(tr_n("%zu cut so far: a slow drift needs %d or more to "
			   "show",
			  "%zu cuts so far: a slow drift needs %d or more to "
			  "show",
			  r->n),
		r->n, ROUTINE_FEW);
	if (!measures)
		xappend_to_list(&words, "; ",
		    tr("with fewer than %d only a large sudden change shows; "
		       "with %d, 'drift' says how large"),
		    MEASURES, MEASURES);
	if (isfinite(sudden))
		xappend_to_list(&words, "; ",
		    tr("the next cut would mostly show a sudden change, by "
		       "%.1f points or more (mean of the sieves)"),
		    100 * sudden);
	answer_note(a, "%s", words);
}

static void
note_belt_cuts_until_drift_found(struct answer *a, double shift, double found)
{
	if (found <= MOST_CUTS)
		answer_note(a,
		    "a drift of %.1f points (mean of the sieves) is found "
		    "within %g cuts in half of all cases",
		    100 * shift, found);
	else
		answer_note(a,
		    "a drift of %.1f points (mean of the sieves) is usually "
		    "not found: cuts differ from one another by more",
		    100 * shift);
}

/* States the limits, and how often chance alone crosses them. */
static void
note_control_limits(struct answer *a, const struct routine *r, bool detail)
{
	const double shift = 0.005;
	double quiet = drift_mean_run_length(&r->rule, 0, SEED);
	double found = drift_detection_delay(&r->rule, r->point, r->n,
	    r->since < r->n ? r->since : r->n, shift, SEED);
	double about = quiet > 100 ? 10 * round(quiet / 10) : quiet;
	answer_add_sentence(a, ANSWER_REMARK,
	    "in points, answer - measured, + where the cut is coarser: mean of "
	    "all sieves; most, at the sieve in mm");
	if (detail)
		answer_note(a,
		    "a signal: EWMA beyond its limit or a CUSUM above %g, of "
		    "the mean "
		    "residual or of its tilt (coarse sieves less fine ones), "
		    "in standard deviations; by chance, without drift, once in "
		    "about %.0f cuts",
		    r->rule.h, about);
	else if (r->n >= ROUTINE_FEW)
		answer_note(a,
		    "one cut in about %.0f is called a drift by mistake",
		    about);
	if (detail || r->n >= ROUTINE_FEW)
		note_belt_cuts_until_drift_found(a, shift, found);
	if (r->n < ROUTINE_FEW)
		note_what_few_cuts_show(a, r);
	fields_put_values(answer_json_fields(a),
	    "false_signal_every %g found_after %g", quiet,
	    isfinite(found) ? found : (double)NAN);
}

/* Says what the cuts are compared with, and in which order. */
static void
note_basis_of_control_charts(
    struct answer *a, const struct session *s, const struct routine *r)
{
	if (r->drawn && s->set.correction == CORRECTION_OFF)
		answer_add_sentence(a, ANSWER_REMARK,
		    "compared with the answer that the runs correct, which "
		    "'set correction off' leaves out elsewhere");
	if (!r->drawn)
		answer_add_sentence(a, ANSWER_WARNING,
		    "limits are from 'set noise' alone: parameter uncertainty "
		    "is not included: expect more false alarms");
	if (!r->dated && r->n > 1)
		answer_add_sentence(a, ANSWER_REMARK,
		    "not every cut has a date: they are in the order in which "
		    "they were added; 'add FILE date=2026-05-03' gives one");
	if (r->training_only)
		answer_add_sentence(a, ANSWER_REMARK,
		    r->n == 1
			? N_("this cut was known to the calibration: it is "
			     "compared with the answer of the other runs, not "
			     "as 'add' compared it")
			: N_("some of these cuts were known to the "
			     "calibration: all are compared with the answer of "
			     "the other runs, not as 'add' compared them"));
}

static void
drift_put_fields(struct answer *a, const struct routine *r)
{
	struct fields *o = answer_json_fields(a);
	enum drift_state state = r->point[r->n - 1].state;
	answer_add_rows_as_json_objects(a, "cuts");
	fields_put_values(o, "state %s signal %d k %g h %g lambda %g width %g",
	    ROUTINE_STATE[state], state != DRIFT_NONE, r->rule.k, r->rule.h,
	    r->rule.lambda, r->rule.width);
	fields_put_values(o, "first_signal %g since %g running %zu",
	    r->first < r->n ? (double)(r->first + 1) : (double)NAN,
	    r->since < r->n ? (double)(r->since + 1) : (double)NAN, r->running);
	fields_put_values(o, "worst_mm %g worst_points %g limits %s",
	    units_m_to_mm(r->worst), 100 * r->by,
	    r->drawn ? "posterior" : "noise");
}

/* Says whether the cuts drift.  A single cut that the prediction misses is not
 * a drift, but gets a warning. */
static void
note_whether_drifting(struct answer *a, const struct routine *r,
    const struct later *later, double rotor)
{
	bool drifts = r->point[r->n - 1].state != DRIFT_NONE;
	FREED char *words = drift_in_words(r);
	FREED char *rpm = rotor_speed_rpm_text(rotor, later->speed, NAN);
	if (!drifts && later->missed)
		answer_add_sentence(a, ANSWER_WARNING,
		    "no drift, but the cut at %g m/s%s is not as expected",
		    later->speed, rpm);
	else
		answer_add_sentence(
		    a, drifts ? ANSWER_WARNING : ANSWER_PLAIN, "%s", words);
}

bool
cmd_drift(struct session *s, const struct args *args, struct error *error)
{
	const struct entry *entry = session_current_site_entry(s);
	struct drift_rule rule = DRIFT_RULE;
	rule.k = args->k;
	rule.h = args->h;
	if (!answers_require_params_current_site(s, error))
		return false;
	struct routine *r = control_charts_compute(s, entry, &rule, error);
	if (r == NULL)
		return false;
	struct answer *a = answer_new_about_site(entry->site, "drift",
	    tr_n("%zu routine cut against its prediction",
		"%zu routine cuts against their predictions", r->n),
	    r->n);
	add_belt_cut_rows_to_answer(a, r, args->detail, false);
	answer_begin_table_for_programs(a);
	add_belt_cut_rows_to_answer(a, r, true, true);
	drift_put_fields(a, r);
	struct later later = cut_compare_runs_since_fit(s, entry);
	note_whether_drifting(a, r, &later, entry->site->rotor);
	note_when_drift_began(a, r);
	note_control_limits(a, r, args->detail);
	note_basis_of_control_charts(a, s, r);
	answers_note_fit_basis_and_trust(
	    s, a, entry, false, trust_in_answer_or_fit(s, entry, NULL));
	note_when_to_recalibrate(a, entry, r, &later);
	control_charts_free(r);
	return session_show_answer(s, a);
}
