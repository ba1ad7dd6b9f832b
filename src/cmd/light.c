/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/light.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/cut.h"
#include "cmd/fit.h"
#include "cmd/outlook.h"
#include "core/misfit.h"

/* Below this width of a band, passing, no parameter moves the answer by what is
 * worth a word; and that. */
static const double NARROW = 0.01, MOVES = 0.005;

static double
mean_width(const struct prediction *p)
{
	double sum = 0;
	for (size_t i = 0; p->low != NULL && i < p->product.n; i++)
		sum += (p->high[i] - p->low[i]) / (double)p->product.n;
	return sum;
}

/* The parameter on a bound that holds the answer back most. */
static void
find_bound(const struct session *s, const struct entry *entry,
    const struct prediction *p, struct trust_question *q)
{
	const struct fit *fit = origin_fit(entry);
	struct ensemble *e = outlook_ensemble(s, entry, p->feed_run);
	if (e == NULL)
		return;
	ensemble_at(e, p->speed);
	for (size_t j = 0; j < breakage_of(&fit->params)->n; j++) {
		const char *name = breakage_of(&fit->params)->parameter[j].name;
		double moves = fit->on_bound[j]
				   ? trust_moves(outlook_draws(s, entry), e,
					 p->curve.n, name)
				   : 0;
		if (moves > fmax(q->bound_moves, MOVES)) {
			q->bound = name;
			q->bound_moves = moves;
		}
	}
}

/* The largest RMSE of the entry's parameters at a measured run, passing 0..1;
 * NAN where none was measured. */
static double
largest_error(const struct session *s, const struct entry *entry)
{
	double most = NAN;
	for (size_t r = 0; r < entry->site->n_run; r++) {
		if (misfit_covered(&entry->site->run[r]) == 0)
			continue;
		struct validation v = validate_run(entry->site, r, entry->train,
		    &entry->params, s->set.model, NULL);
		most = fmax(most, v.rmse[VALIDATE_MODEL]);
	}
	return most;
}

/* Parameters that no calibration on this site's data found in this session. */
static void
judge_origin(
    struct trust *t, const struct session *s, const struct entry *entry)
{
	const struct origin *o = entry->origin;
	bool same = o->found && o->digest == entry->site->digest;
	double error = largest_error(s, entry);
	if (same && origin_fit(entry) != NULL)
		return;
	if (same)
		trust_add(t, LIGHT_AMBER, TRUST_ORIGIN,
		    xasprintf("parameters %s, calibrated on the same data in "
			      "another session: calibrate here to see how far "
			      "the data determine them",
			origin_words(entry)));
	else if (isnan(error))
		trust_add(t, LIGHT_RED, TRUST_ORIGIN,
		    xasprintf("parameters %s, and no product of this site was "
			      "measured that could check them",
			origin_words(entry)));
	else
		trust_add(t, error > FIT_POOR ? LIGHT_RED : LIGHT_AMBER,
		    TRUST_ORIGIN,
		    xasprintf("parameters %s, not calibrated on this site: "
			      "they miss a measured product by %.1f points "
			      "(RMSE)",
			origin_words(entry), 100 * error));
}

/* How the calibration was made. */
static void
judge_calibration(
    struct trust *t, const struct session *s, const struct fit *fit)
{
	if (fit->stop == CALIBRATE_STOPPED)
		trust_add(t, LIGHT_AMBER, TRUST_FIT,
		    xstrdup("the calibration was stopped: 'continue' may find "
			    "better parameters"));
	else if (!fit->converged)
		trust_add(t, LIGHT_AMBER, TRUST_FIT,
		    xstrdup("the calibration has not converged: the misfit can "
			    "still fall, so that another seed may give other "
			    "parameters"));
	if (!model_settings_same(&s->set.model, &fit->settings))
		trust_add(t, LIGHT_AMBER, TRUST_FIT,
		    xstrdup("the site was calibrated with other settings: "
			    "calibrate again"));
}

/* Cuts that were added since. */
static void
judge_later(struct trust *t, const struct session *s, const struct entry *entry)
{
	struct later later = cut_later(s, entry);
	if (later.missed)
		trust_add(t, later.rms > FIT_POOR ? LIGHT_RED : LIGHT_AMBER,
		    TRUST_HOLDOUT,
		    xasprintf("the cut at %g m/s, added after the calibration, "
			      "is missed by %.1f points (RMS): calibrate again "
			      "with train=all",
			later.speed, 100 * later.rms));
}

/* Speeds of parameters that no calibration of this session found. */
static struct evidence
reach_of(const struct entry *entry)
{
	struct evidence e = {.speeds = 2, .cells = 100};
	if (!origin_reach(entry, &e.slowest, &e.fastest)) {
		e.slowest = 0;
		e.fastest = INFINITY;
	}
	return e;
}

struct trust
light_of(const struct session *s, const struct entry *entry,
    const struct prediction *p)
{
	struct trust t = {0};
	struct trust_question q = {.speed = p != NULL ? p->speed : 0};
	const struct evidence *e = outlook_evidence(s, entry);
	struct evidence reach = reach_of(entry);
	if (p != NULL && session_busy(s) && &s->entry[s->job.entry] == entry) {
		trust_add(&t, LIGHT_AMBER, TRUST_FIT,
		    xstrdup("a calibration is running: parameters change"));
		return t;
	}
	judge_later(&t, s, entry);
	if (p != NULL)
		q.width = mean_width(p);
	if (p != NULL && e != NULL)
		q.feed = outlook_feed_difference(s, entry, p->feed_run);
	if (q.width > NARROW && e != NULL)
		find_bound(s, entry, p, &q);
	if (!entry->has_fit)
		judge_origin(&t, s, entry);
	if (e != NULL)
		judge_calibration(&t, s, origin_fit(entry));
	trust_judge(&t, e != NULL ? e : &reach, &q);
	return t;
}

void
light_worse(struct trust *worst, struct trust t)
{
	struct trust less = t.light > worst->light ? *worst : t;
	if (t.light > worst->light)
		*worst = t;
	trust_free(&less);
}

struct trust
light_worst(const struct session *s, const struct entry *entry,
    const struct prediction *p, size_t n)
{
	struct trust worst = light_of(s, entry, &p[0]);
	for (size_t i = 1; i < n; i++)
		light_worse(&worst, light_of(s, entry, &p[i]));
	return worst;
}

char *
light_words(const struct trust *t)
{
	const char *name = LIGHT_NAME[t->light];
	return t->n == 0 ? xstrdup(name)
			 : xasprintf("%s: %s", name, t->reason[0].text);
}

void
light_note(struct answer *r, const struct trust *t)
{
	static const enum answer_grade GRADE[] = {
	    ANSWER_PLAIN, ANSWER_REMARK, ANSWER_WARNING};
	char *words = light_words(t);
	answer_say(r, GRADE[t->light], "trust: %s%s", words,
	    t->n > 0 ? " ('why' explains)" : "");
	free(words);
}

void
light_put(struct fields *o, const struct trust *t)
{
	fields_put(o, "trust %s", LIGHT_NAME[t->light]);
	struct fields *list = fields_list(o, "reasons");
	for (size_t i = 0; i < t->n; i++)
		fields_put(list, "%s", t->reason[i].text);
}

void
light_show(struct answer *r, struct trust t)
{
	light_note(r, &t);
	light_put(answer_fields(r), &t);
	trust_free(&t);
}

const char *
light_verdict(const struct session *s, const struct entry *entry,
    const struct prediction *p)
{
	const struct fit *fit = &entry->fit;
	if (fit->rmse > FIT_POOR)
		return "poor";
	if (fit_too_few(fit))
		return "too few data";
	if (fit_breaks_nothing(fit))
		return "nothing breaks";
	struct trust t = light_of(s, entry, p);
	bool good = t.light == LIGHT_GREEN;
	trust_free(&t);
	return good ? "good" : "doubtful";
}
