/* show: the model taken apart, equation by equation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/fit.h"
#include "cmd/model.h"
#include "cmd/table.h"
#include "core/classes.h"
#include "core/energy.h"
#include "core/predict.h"
#include "io/units.h"

/* The equations with the numbers of this site in them. */
static void
note_equations(struct report *r, const struct params *p, double k)
{
	report_note(r, "Eq 4: E = v^2 / 2, J/kg at v m/s");
	char *S = breakage_of(p)->selection_text(p, k);
	char *B = breakage_of(p)->appearance_text(p);
	report_note(r, "Eq 3: %s", S);
	report_note(r, "Eq 1: %s", B);
	free(S);
	free(B);
}

bool
show_model(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	const struct entry *entry = session_entry(s);
	const struct site *site = entry->site;
	struct report *r = answers_report(site, "show", "the model");
	const struct model_settings *set = &s->set.model;
	json_t *o = report_json(r);
	report_put(o, "what %s method %s appearance %s k %g", "model",
	    answers_method(set->method), MODEL_FORMS[set->appearance], set->k);
	if (entry->has_params)
		fit_put_params(o, &entry->params);
	else
		json_object_set_new(o, "params", json_null());
	report_columns(r,
	    "speed: m/s, energy_j_kg: E J/kg, break_mm: breaks from mm, "
	    "selected_pct: feed broken %%");
	for (size_t i = 0; i < site->n_run; i++) {
		double v = site->run[i].speed, x = NAN, selected = NAN;
		if (entry->has_params) {
			struct prediction p = answers_predict(s, entry, v, i);
			x = 1000 * p.break_size;
			selected = 100 * p.selected;
			prediction_free(&p);
		}
		report_cells(
		    r, "%g %.0f %.2f %.1f", v, energy_specific(v), x, selected);
	}
	report_put_rows(r, "runs");
	report_note(r, "method %s, appearance %s, k %g",
	    answers_method(set->method), MODEL_FORMS[set->appearance], set->k);
	if (entry->has_params)
		note_equations(r, &entry->params, set->k);
	else
		report_note(r, "no parameters yet: calibrate, or params set");
	return session_report(s, r);
}

/* A row for each parameter of each model; a bypass is told once. */
bool
show_models(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	struct report *r = report_new("show");
	report_title(r, "breakage models, for 'set model'");
	report_columns(r, "model, parameter, unit, lower, upper, meaning");
	for (size_t m = 0; m < breakage_count(); m++) {
		const struct breakage *of = BREAKAGES[m];
		size_t first = of->bypass ? of->n - 1 : 0;
		for (size_t j = first; j < of->n; j++)
			report_cells(r, "%s %s %s %g %g %s", of->name,
			    of->parameter[j].name, of->parameter[j].unit,
			    of->parameter[j].lower, of->parameter[j].upper,
			    of->parameter[j].meaning);
		report_note(r, "%s: %s", of->name, of->brief);
	}
	return session_report(s, r);
}

/* A row for each class of the feed. */
static void
selection_rows(struct report *r, const struct psd *feed, const double *S)
{
	report_columns(r,
	    "from_mm: from mm, to_mm: to mm, feed_pct: feed %%, s_pct: S %%, "
	    "selected_pct: selected %%");
	for (size_t i = 0; i < feed->n; i++) {
		bool pan = i + 1 == feed->n;
		double mass =
		    feed->passing[i] - (pan ? 0 : feed->passing[i + 1]);
		report_cells(r, "%g %g %.1f %.1f %.1f",
		    pan ? 0 : units_mm(feed->size[i + 1]),
		    units_mm(feed->size[i]), units_pct(mass), 100 * S[i],
		    100 * S[i] * mass);
	}
}

bool
show_selection(struct session *s, const struct args *args, struct error *error)
{
	if (!answers_ready(s, error))
		return false;
	const struct entry *entry = session_entry(s);
	double v = answers_speed(args, entry);
	size_t run = site_run_nearest(entry->site, v);
	const struct psd *feed = &entry->site->run[run].feed;
	struct prediction p = answers_predict(s, entry, v, run);
	double *S = xdoubles(feed->n);
	predict_selection(feed, &entry->params, s->set.model, v, S);
	struct report *r = answers_report(
	    entry->site, "show", "selection at %g m/s (Eq 3)", v);
	selection_rows(r, feed, S);
	report_put_rows(r, "rows");
	report_put(report_json(r),
	    "what %s speed %g selected_pct %g break_mm %g", "selection", v,
	    100 * p.selected, 1000 * p.break_size);
	report_note(r,
	    "S: share of the class that breaks; selected: share of all the "
	    "feed, %.1f %% in sum",
	    100 * p.selected);
	if (isfinite(p.break_size) && p.break_size > 0)
		report_note(r, "fragments of %.3g mm or more can break",
		    1000 * p.break_size);
	if (entry->site->individual_feeds)
		report_note(r, "feed: the sample taken at %g m/s",
		    entry->site->run[run].speed);
	free(S);
	prediction_free(&p);
	return session_report(s, r);
}

/* A class is called by the sieve it lies on. */
static const char *
class_name(const struct psd *feed, size_t i, char buf[static 32])
{
	if (i + 1 == feed->n)
		return "pan";
	snprintf(buf, 32, "on %g", units_mm(feed->size[i + 1]));
	return buf;
}

/* Parents across and daughters down; a: as appearance_matrix has it. */
static void
matrix_across(struct report *r, const struct psd *feed, const double *a)
{
	char name[32];
	report_columns(r, "daughter");
	for (size_t i = 0; i < feed->n; i++)
		report_columns(r, "%s", class_name(feed, i, name));
	for (size_t j = 0; j < feed->n; j++) {
		report_cells(r, "%s", class_name(feed, j, name));
		report_missing(r, "");
		for (size_t i = 0; i < feed->n; i++)
			report_cells(
			    r, "%.1f", i <= j ? 100 * a[j * feed->n + i] : NAN);
	}
}

/* A row for each parent and daughter: for spreadsheets. */
static void
matrix_long(
    struct report *r, const struct psd *feed, const double *x, const double *a)
{
	report_columns(r, "parent_mm: parent mm, daughter_mm: daughter mm, "
			  "share_pct: share %%");
	for (size_t i = 0; i < feed->n; i++)
		for (size_t j = 0; j < feed->n; j++)
			report_cells(r, "%g %g %.1f", units_mm(x[i]),
			    units_mm(x[j]), 100 * a[j * feed->n + i]);
}

/* B(u) at u = 1/2, 1/4 and so on to 1/1024. */
static void
note_passing(struct report *r, const struct breaker *b, const struct site *site)
{
	char *text = xstrdup("");
	for (int i = 1; i < 10; i++) {
		char *more =
		    xasprintf("%s%s1/%d: %.1f %%", text, i > 1 ? ", " : "",
			1 << i, 100 * answers_finer(b, ldexp(1, -i), site));
		free(text);
		text = more;
	}
	report_note(r,
	    "B(u), the share of a broken fragment finer than u times its "
	    "size, which the method continuous takes: %s; below 1/1024 "
	    "there is nothing",
	    text);
	free(text);
}

static void
put_matrix(json_t *o, enum appearance_form form, size_t n, const double *x,
    const double *a)
{
	json_t *rows = json_array();
	report_put(o, "what %s appearance %s", "appearance", MODEL_FORMS[form]);
	json_object_set_new(o, "class_mm", answers_list(x, n, units_mm));
	for (size_t j = 0; j < n; j++)
		json_array_append_new(
		    rows, answers_list(a + j * n, n, units_pct));
	json_object_set_new(o, "share_pct", rows);
}

bool
show_appearance(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	const struct entry *entry = session_entry(s);
	const struct psd *feed = &entry->site->run[0].feed;
	struct params p = entry->has_params
			      ? entry->params
			      : params_start(s->set.model.breakage);
	struct breaker b;
	breaker_set(&b, &p, s->set.model.k);
	breaker_at(&b, answers_middle(entry->site));
	double *x = xdoubles(feed->n), *a = xdoubles(feed->n * feed->n);
	classes_sizes(feed, x);
	classes_matrix(&b, s->set.model.appearance, x, feed->n, a);
	struct report *r = answers_report(
	    entry->site, "show", "appearance (Eq 1), %% of each broken class");
	if (s->set.format == REPORT_CSV)
		matrix_long(r, feed, x, a);
	else
		matrix_across(r, feed, a);
	report_note(r,
	    "parent classes across, daughters down; a class is called by the "
	    "sieve it lies on; columns sum to 100");
	if (!entry->has_params)
		report_note(r, "beta is the default: there are no parameters "
			       "yet");
	if (s->set.model.appearance == APPEARANCE_RATIO)
		note_passing(r, &b, entry->site);
	put_matrix(report_json(r), s->set.model.appearance, feed->n, x, a);
	free(x);
	free(a);
	return session_report(s, r);
}
