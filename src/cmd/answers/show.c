/* show: the content of a sheet, the model equation by equation, and the table
 * of everything that can be shown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/session/sites.h"
#include "cmd/ask/fit.h"
#include "cmd/fit/params.h"
#include "cmd/session/energies.h"
#include "cmd/lang/table.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/question.h"
#include "core/model/classes.h"
#include "core/model/breakage.h"
#include "core/model/selection.h"
#include "core/answer/predict.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

static bool
show_site(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	const struct site *site = session_current_site_entry(s)->site;
	struct answer *r = answer_new("show");
	FREED char *label = session_site_label(site);
	FREED char *speeds = session_speeds_of_runs_text(site, " ", NULL, true);
	answer_set_title(r, "%s", label);
	answer_set_site(r, site->name, site->provenance);
	answer_add_columns(r, "what, value");
	FREED char *data = site_translate_provenance(site->provenance);
	answer_add_name_value_row(r, "data", "%s", data);
	answer_add_name_value_row(r, "rock", "%s", site->rock);
	if (site->top_size > 0)
		answer_add_name_value_row(
		    r, "top size mm", "%g", units_m_to_mm(site->top_size));
	else
		answer_add_name_value_row(r, "top size mm", "not stated");
	answer_add_name_value_row(r, "machine", "%s", site->machine);
	answer_add_name_value_row(r, "file", "%s", site->path);
	answer_add_name_value_row(r, "speeds m/s", "%s", speeds);
	FREED char *rpm = session_rpm_of_runs_text(site, " ", NULL, true);
	if (rpm[0] != '\0')
		answer_add_name_value_row(r, "speeds rpm", "%s", rpm);
	answer_add_name_value_row(r, "feeds",
	    site->individual_feeds ? N_("one for each speed")
				   : N_("one for all speeds"));
	for (size_t i = 0; i < site->n_note; i++) {
		const struct site_note *note = &site->note[i];
		if (note->value[0] == '\0')
			answer_add_name_value_row(r, "remark", "%s", note->key);
		else
			answer_add_cells(r, "%s %s", note->key, note->value);
	}
	return session_show_answer(s, r);
}

/* Returns the coarsest sieve of the curves that is finer than `below`, m, or 0
 * if there is none. */
static double
next_finer_sieve(const struct psd *const *curve, size_t n, double below)
{
	double x = 0;
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j < curve[i]->n; j++)
			if (curve[i]->size[j] < below)
				x = fmax(x, curve[i]->size[j]);
	return x;
}

/* Adds a column for each product, "product@69", or for each feed, "feed@69",
 * which is just "feed" if all runs share one.  Sets curve [n_run] to their
 * curves and returns their number. */
static size_t
add_feed_or_product_columns(struct answer *r, const struct site *site,
    bool feed, const struct psd **curve)
{
	size_t n = 0;
	for (size_t i = 0; i < site->n_run; i++) {
		const struct run *run = &site->run[i];
		bool shared = feed && !site->individual_feeds;
		if (feed ? !site_run_has_feed_sample(site, i)
			 : run->product.n == 0)
			continue;
		const char *key = feed ? N_("feed") : N_("product");
		FREED char *at =
		    shared ? xstrdup("")
			   : xasprintf("@%g%s", run->speed, run->repeat);
		FREED char *name = xasprintf("%s%s", key, at);
		FREED char *head = xasprintf("%s%s", tr(key), at);
		answer_add_column(r, name, head);
		curve[n++] = feed ? &run->feed : &run->product;
	}
	return n;
}

/* Runs show feed and show product. */
static bool
show_feed_or_product(
    struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	const struct site *site = session_current_site_entry(s)->site;
	bool feed = strcmp(args->operand[0], "feed") == 0;
	FREED const struct psd **curve = xcalloc(site->n_run, sizeof(*curve));
	struct answer *r = answer_new_about_site(site, "show",
	    feed ? N_("feed, %% passing")
		 : N_("measured products, %% passing"));
	answer_add_columns(r, "sieve_mm: sieve mm");
	size_t n = add_feed_or_product_columns(r, site, feed, curve);
	if (n == 0)
		answer_note(r, "the site file has only a feed");
	answer_set_missing_text(r, "");
	for (double x = INFINITY; (x = next_finer_sieve(curve, n, x)) > 0;) {
		answer_add_cells(r, "%g", units_m_to_mm(x));
		for (size_t i = 0; i < n; i++)
			answer_add_cells(r, "%.2f",
			    units_fraction_to_pct(
				psd_passing_at_sieve(curve[i], x)));
	}
	return session_show_answer(s, r);
}

/* Notes Eqs 4, 3 and 1 with the site's parameters filled in. */
static void
note_equations_with_numbers(
    struct answer *r, const struct session *s, const struct params *p)
{
	answer_note(r, "Eq 4: E = v^2 / 2, J/kg at v m/s");
	FREED char *S = selection_formula_text(p, &s->set.model);
	FREED char *B = breakage_model_of_params(p)->appearance_text(p);
	FREED char *energies = energies_trust_reason(s);
	double bypass = params_value_by_name(p, "bypass");
	answer_note(r, "Eq 3: %s", S);
	if (energies != NULL)
		answer_note(r, "%s", energies);
	answer_note(r, "Eq 1: %s", B);
	if (bypass > 0)
		answer_note(r,
		    "product = %.4g crushed + %.4g feed: a share of the feed "
		    "bypasses the rotor (D14)",
		    1 - bypass, bypass);
}

static bool
show_model_with_feed(struct session *s, const struct args *args,
    struct question *q, struct error *error)
{
	(void)args;
	(void)error;
	const struct entry *entry = q->entry;
	const struct site *site = entry->site;
	struct answer *r = answer_new_about_site(site, "show", "the model");
	const struct model_settings *set = &s->set.model;
	struct fields *o = answer_json_fields(r);
	fields_put_values(o, "what %s method %s appearance %s k %g", "model",
	    answers_method_name(set->method), APPEARANCE_NAMES[set->appearance],
	    set->k);
	energies_put_field(o, s);
	if (entry->has_params)
		fit_put_params_in_json(o, &entry->params);
	else
		fields_put_values(o, "params %g", NAN);
	answer_set_missing_text(r, entry->has_params ? N_("none") : "-");
	answer_add_columns(r,
	    "speed: m/s, energy_j_kg: E J/kg, break_mm: break "
	    "size mm, selected_pct: broken %% of feed");
	for (size_t i = 0; i < site->n_run; i++) {
		double v = site->run[i].speed, x = NAN, selected = NAN;
		v = v > 0 ? v : answers_default_speed(entry);
		if (site_run_repeats_speed(site, i))
			continue;
		if (entry->has_params) {
			struct prediction p =
			    forecast_whole_product(s, entry, v, q->feed);
			x = 1000 * p.break_size;
			selected = 100 * p.selected;
			prediction_free(&p);
		}
		answer_add_cells(r, "%g %.0f %.2f %.1f", v,
		    specific_energy_at_speed(v), x, selected);
	}
	answer_add_rows_as_json_objects(r, "runs");
	answer_note(r, "method %s, appearance %s, k %g",
	    answers_method_name(set->method), APPEARANCE_NAMES[set->appearance],
	    set->k);
	if (entry->has_params)
		note_equations_with_numbers(r, s, &entry->params);
	else
		answer_note(
		    r, "no parameters yet: run 'calibrate' or 'params set'");
	feed_add_note_to_answer(r, site, q->feed, NULL, 0);
	return session_show_answer(s, r);
}

static bool
show_model(struct session *s, const struct args *args, struct error *error)
{
	return question_read_and_answer(s, args, show_model_with_feed, error);
}

/* People see a row for each model, programs one for each parameter. */
/* The caller frees it. */
static char *
model_description_text(const struct breakage *model)
{
	int name = (int)strcspn(model->name, "+");
	return model->bypass
		   ? xasprintf(tr("%.*s with a share of the feed that "
				  "bypasses the rotor"),
			 name, model->name)
		   : xstrdup(tr(model->brief));
}

static bool
show_models(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	struct answer *r = answer_new("show");
	answer_set_title(r, "breakage models, for 'set model'");
	answer_add_columns(r, "model, parameters, what");
	for (size_t m = 0; m < breakage_count_models(); m++) {
		FREED char *what = model_description_text(BREAKAGES[m]);
		answer_add_cells(r, "%s %g %s", BREAKAGES[m]->name,
		    (double)BREAKAGES[m]->n, what);
	}
	answer_begin_table_for_programs(r);
	answer_add_columns(r, "model, parameter, unit, lower, upper, meaning");
	for (size_t m = 0; m < breakage_count_models(); m++)
		for (size_t j = 0; j < BREAKAGES[m]->n; j++) {
			const struct param_info *p =
			    &BREAKAGES[m]->parameter[j];
			answer_add_cells(r, "%s %s %s %g %g %s",
			    BREAKAGES[m]->name, p->name, p->unit, p->lower,
			    p->upper, tr(p->meaning));
		}
	answer_note(r, "'set model NAME; bounds' lists the parameters of one, "
		       "'man model' says what they mean");
	return session_show_answer(s, r);
}

/* Adds a row for each class of the feed. */
static void
add_selection_function_rows(
    struct answer *r, const struct psd *feed, const double *S)
{
	answer_add_columns(r,
	    "from_mm: from mm, to_mm: to mm, feed_pct: feed %%, "
	    "s_pct: S %%, selected_pct: broken %% of feed");
	for (size_t i = 0; i < feed->n; i++) {
		bool pan = i + 1 == feed->n;
		double mass =
		    feed->passing[i] - (pan ? 0 : feed->passing[i + 1]);
		answer_add_cells(r, "%g %g %.1f %.1f %.1f",
		    pan ? 0 : units_m_to_mm(feed->size[i + 1]),
		    units_m_to_mm(feed->size[i]), units_fraction_to_pct(mass),
		    100 * S[i], units_fraction_to_pct(S[i] * mass));
	}
}

static bool
show_selection_function_at_speed(struct session *s, const struct args *args,
    struct question *q, struct error *error)
{
	const struct entry *entry = q->entry;
	const struct psd *feed = question_feed(q);
	question_use_last_speed(s, q);
	struct prediction p =
	    forecast_whole_product(s, entry, q->speed, q->feed);
	FREED double *S = xcalloc_doubles(feed->n);
	(void)args;
	(void)error;
	predict_broken_share_of_classes(
	    feed, &entry->params, s->set.model, q->speed, S);
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, q->speed, NAN);
	struct answer *r = answer_new_about_site(entry->site, "show",
	    "selection function at %.4g m/s%s (Eq 3)", q->speed, rpm);
	add_selection_function_rows(r, feed, S);
	answer_add_rows_as_json_objects(r, "rows");
	fields_put_values(answer_json_fields(r),
	    "what %s speed %g selected_pct %g break_mm %g", "selection",
	    q->speed, 100 * p.selected, 1000 * p.break_size);
	answer_note(r,
	    "S: share of the size class that breaks; broken: share of the "
	    "whole feed, %.1f %% in total",
	    100 * p.selected);
	if (isfinite(p.break_size) && p.break_size > 0)
		answer_note(r, "particles of %.3g mm or more can break",
		    1000 * p.break_size);
	feed_add_note_to_answer(r, entry->site, q->feed, NULL, 0);
	prediction_free(&p);
	return session_show_answer(s, r);
}

static bool
show_selection_function(
    struct session *s, const struct args *args, struct error *error)
{
	return answers_require_params_current_site(s, error) &&
	       question_read_and_answer(
		   s, args, show_selection_function_at_speed, error);
}

/* Returns the heading of a class: the sieve that retains it. */
static const char *
sieve_heading_of_class(const struct psd *feed, size_t i, char buf[static 32])
{
	if (i + 1 == feed->n)
		return "pan";
	snprintf(buf, 32, tr("on %g"), units_m_to_mm(feed->size[i + 1]));
	return buf;
}

/* Puts parents across and progeny down.  a: laid out as in
 * appearance_matrix. */
static void
add_appearance_matrix_rows(
    struct answer *r, const struct psd *feed, const double *a)
{
	char name[32];
	answer_add_columns(r, "daughter: daughter");
	for (size_t i = 0; i < feed->n; i++)
		answer_add_columns(
		    r, "%s", sieve_heading_of_class(feed, i, name));
	for (size_t j = 0; j < feed->n; j++) {
		answer_add_cells(
		    r, "%s", sieve_heading_of_class(feed, j, name));
		answer_set_missing_text(r, "");
		for (size_t i = 0; i < feed->n; i++)
			answer_add_cells(
			    r, "%.1f", i <= j ? 100 * a[j * feed->n + i] : NAN);
	}
}

/* Adds a row for each pair of parent and progeny, for spreadsheets. */
static void
add_parent_progeny_share_rows(
    struct answer *r, const struct psd *feed, const double *x, const double *a)
{
	answer_add_columns(r, "parent_mm: parent mm, daughter_mm: progeny mm, "
			      "share_pct: share %%");
	for (size_t i = 0; i < feed->n; i++)
		for (size_t j = 0; j < feed->n; j++)
			answer_add_cells(r, "%g %g %.1f", units_m_to_mm(x[i]),
			    units_m_to_mm(x[j]), 100 * a[j * feed->n + i]);
}

/* Notes B(u) at u = 1/2, 1/4 and so on. */
static void
note_cumulative_breakage_values(
    struct answer *r, const struct breaker *b, const struct site *site)
{
	FREED char *text = xstrdup("");
	for (int i = 1; i < 10; i++)
		xappend_to_list(&text, ", ", "1/%d: %.1f %%", 1 << i,
		    100 * answers_breakage_at_ratio(b, ldexp(1, -i), site));
	answer_note(r,
	    "B(u), the share of a broken particle finer than u times its size, "
	    "as used by the method continuous: %s; nothing is finer than "
	    "1/1024",
	    text);
}

static void
put_appearance_function_fields(struct fields *o, enum appearance_form form,
    size_t n, const double *x, const double *a)
{
	fields_put_values(
	    o, "what %s appearance %s", "appearance", APPEARANCE_NAMES[form]);
	fields_put_numbers(o, "class_mm", x, n, units_m_to_mm);
	struct fields *rows = fields_add_list(o, "share_pct");
	for (size_t j = 0; j < n; j++)
		fields_put_numbers(
		    rows, NULL, a + j * n, n, units_fraction_to_pct);
}

static bool
show_appearance_function(
    struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	const struct entry *entry = session_current_site_entry(s);
	const struct psd *feed = &entry->site->run[0].feed;
	struct params p = entry->has_params
			      ? entry->params
			      : params_start_values(s->set.model.breakage);
	struct breaker b;
	breaker_set_params(&b, &p, &s->set.model);
	breaker_set_speed(&b, site_middle_speed(entry->site));
	FREED double *x = xcalloc_doubles(feed->n),
		     *a = xcalloc_doubles(feed->n * feed->n);
	classes_compute_sizes(feed, x);
	classes_appearance_matrix(&b, s->set.model.appearance, x, feed->n, a);
	struct answer *r = answer_new_about_site(entry->site, "show",
	    "appearance function (Eq 1), %% of each broken size class");
	add_appearance_matrix_rows(r, feed, a);
	answer_begin_table_for_programs(r);
	add_parent_progeny_share_rows(r, feed, x, a);
	answer_add_sentence(r, ANSWER_REMARK,
	    "parent classes across, progeny down; a class is named after the "
	    "sieve that retains it; columns sum to 100");
	if (!entry->has_params)
		answer_add_sentence(
		    r, ANSWER_REMARK, "beta is the default: no parameters yet");
	if (s->set.model.appearance == APPEARANCE_RATIO)
		note_cumulative_breakage_values(r, &b, entry->site);
	put_appearance_function_fields(
	    answer_json_fields(r), s->set.model.appearance, feed->n, x, a);
	return session_show_answer(s, r);
}

/* What can be shown.  show alone shows the first. */
static const struct {
	const char *name;
	bool at_site;
	bool asked; /* takes the options speed and feed */
	command_run *show;
} WHAT[] = {
    {"site", true, false, show_site},
    {"feed", true, false, show_feed_or_product},
    {"product", true, false, show_feed_or_product},
    {"params", true, false, show_params},
    {"fit", true, false, show_fit},
    {"bounds", false, false, show_param_bounds},
    {"model", true, false, show_model},
    {"models", false, false, show_models},
    {"selection", true, true, show_selection_function},
    {"appearance", true, false, show_appearance_function},
    {"equations", false, false, show_equations},
    {"claims", false, false, show_claims},
    {"search", true, false, cmd_history},
    {"store", false, false, show_store_summary},
    {"log", false, false, show_plant_log},
};

static bool
error_no_such_thing_to_show(struct session *s, const char *what,
    const struct args *args, struct error *error)
{
	size_t at;
	error_set(error, ERROR_USAGE, "there is no '%s' to show", what);
	if (session_find_site(s, what, &at, NULL))
		return error_set_hint(error,
		    "'%s' is a loaded site: write 'use %s; show'", what, what);
	return error_set_hint(
	    error, "write: show %s", args->command->operands.usage);
}

bool
cmd_show(struct session *s, const struct args *args, struct error *error)
{
	const char *what = args->n_operand > 0 ? args->operand[0] : "site";
	size_t i = 0;
	while (i < ARRAY_LEN(WHAT) && strcmp(what, WHAT[i].name) != 0)
		i++;
	if (i == ARRAY_LEN(WHAT))
		return error_no_such_thing_to_show(s, what, args, error);
	if (args->speed > 0 && !WHAT[i].asked)
		return error_set(error, ERROR_USAGE,
		    "show %s: expected no speed; it is the same at all speeds",
		    what);
	if (args->feed != NULL && !WHAT[i].asked)
		return error_set(error, ERROR_USAGE,
		    "show %s: expected no feed=; it is the same for every feed",
		    what);
	if (args->every > 0 && WHAT[i].show != cmd_history)
		return error_set(error, ERROR_USAGE,
		    "show %s: expected no every=\n"
		    "generations are those of 'show search every=50'",
		    what);
	if (WHAT[i].at_site && !session_require_site(s, "show", error))
		return false;
	return WHAT[i].show(s, args, error);
}
