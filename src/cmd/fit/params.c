/* params, bounds: show and set parameters and their bounds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/params.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/fit.h"
#include "cmd/session/sites.h"
#include "cmd/ask/outlook.h"
#include "cmd/lang/table.h"

const char *const APPEARANCE_NAMES[3] = {"ratio", "progeny_mm", "parent_mm"};

bool
show_params(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	const struct entry *entry = session_current_site_entry(s);
	const struct posterior *u = posterior_even_if_correction_off(s, entry);
	const struct breakage *of =
	    entry->has_params ? breakage_model_of_params(&entry->params)
			      : BREAKAGES[s->set.model.breakage];
	struct answer *r =
	    of == BREAKAGES[0]
		? answer_new_about_site(entry->site, "params", "parameters %s",
		      origin_of_params_text(entry))
		: answer_new_about_site(entry->site, "params",
		      "parameters %s; model %s", origin_of_params_text(entry),
		      of->name);
	answer_add_columns(r, "parameter, value");
	if (u != NULL)
		answer_add_columns(r, "low, high");
	answer_add_columns(r, "unit, meaning");
	for (size_t j = 0; j < of->n; j++) {
		const struct param_info *info = &of->parameter[j];
		answer_add_cells(r, u != NULL ? "%s %.4f" : "%s %g", info->name,
		    entry->has_params ? entry->params.at[j] : NAN);
		if (u != NULL) {
			double range[2];
			param_band_from_posterior(
			    u, s, &entry->params, j, range);
			answer_add_cells(r, "%.4f %.4f", range[0], range[1]);
		}
		answer_add_cells(r, "%s %s", info->unit, tr(info->meaning));
	}
	if (u != NULL)
		band_note_meaning(r, s, entry, false);
	origin_add_note_to_answer(r, entry);
	return session_show_answer(s, r);
}

void
set_site_params(struct session *s, struct entry *entry, const struct params *p,
    struct origin *origin)
{
	session_remove_answers(s);
	entry->params = *p;
	entry->has_params = true;
	entry->has_fit = false;
	origin_release(entry->origin);
	entry->origin = origin;
}

/* Sets an error if the call names a parameter that the model does not have. */
static bool
check_params_are_of_model(
    const struct args *args, const struct breakage *of, struct error *error)
{
	const struct command_option *o;
	for (size_t i = 0; (o = command_option_at(args->command, i)) != NULL;
	     i++) {
		const char *name = o->name;
		if (args->value[i].given &&
		    breakage_parameter_index(of, name) == of->n)
			return error_set(error, ERROR_USAGE,
			    "the model %s has no parameter %s\n"
			    "run 'bounds' for its parameters, or 'set model' "
			    "to choose another model",
			    of->name, name);
	}
	return true;
}

/* Sets the parameters that the call names.  The others keep their values or, if
 * the site has none yet, get starting values; parameters without a starting
 * value must be named. */
static bool
set_named_params(
    struct session *s, const struct args *args, struct error *error)
{
	const struct entry *entry = session_current_site_entry(s);
	size_t model = s->set.model.breakage;
	const struct breakage *of = BREAKAGES[model];
	bool has = entry->has_params && entry->params.breakage == model;
	struct params p = has ? entry->params : params_start_values(model);
	if (!check_params_are_of_model(args, of, error))
		return false;
	FREED char *missing = xstrdup("");
	for (size_t j = 0; j < of->n; j++) {
		const struct value *v = &args->value[command_option_index(
		    args->command, of->parameter[j].name)];
		if (v->given)
			p.at[j] = v->number;
		if (isnan(p.at[j]))
			xappend_to_list(
			    &missing, " ", "%s=..", of->parameter[j].name);
	}
	if (missing[0] != '\0')
		return error_set(error, ERROR_USAGE,
		    "params set: expected %s as well: %s has no parameters for "
		    "the model %s yet",
		    missing, entry->site->name, of->name);
	set_site_params(
	    s, session_current_site_entry(s), &p, origin_new_by_hand());
	return true;
}

/* Returns the loaded site that the second operand names, or NULL with an error
 * if there is no such site or it has no parameters. */
static const struct entry *
find_named_site_with_params(
    struct session *s, const struct args *args, struct error *error)
{
	size_t at;
	if (args->n_operand < 2) {
		error_set(error, ERROR_USAGE,
		    "params %s: expected a loaded site\n"
		    "run 'sites' to list them",
		    args->operand[0]);
		return NULL;
	}
	if (!session_find_site(s, args->operand[1], &at, error))
		return NULL;
	if (s->entry[at].has_params)
		return &s->entry[at];
	error_set(error, ERROR_USAGE,
	    "%s has no parameters yet\n"
	    "run 'calibrate' or 'params set' there first",
	    s->entry[at].site->name);
	return NULL;
}

static bool
copy_params_of_site(
    struct session *s, const struct args *args, struct error *error)
{
	const struct entry *from = find_named_site_with_params(s, args, error);
	if (from == NULL)
		return false;
	if (from == session_current_site_entry(s))
		return error_set(error, ERROR_USAGE,
		    "%s is the site in use: its parameters are already in use",
		    from->key);
	set_site_params(s, session_current_site_entry(s), &from->params,
	    origin_new_of_copied_params(from));
	session_print_note(s, "%s now has the parameters of %s (%s)",
	    session_current_site_entry(s)->key, from->key,
	    origin_of_params_text(from));
	return true;
}

/* Compares the parameters of the site in use with those of another site, with
 * the gauge of both scaled to 1. */
static bool
compare_params_of_sites(
    struct session *s, const struct args *args, struct error *error)
{
	const struct entry *mine = session_current_site_entry(s);
	const struct entry *other = find_named_site_with_params(s, args, error);
	if (other == NULL || !answers_require_params_current_site(s, error))
		return false;
	struct params a = mine->params, b = other->params;
	const struct breakage *of = breakage_model_of_params(&a);
	if (a.breakage != b.breakage)
		return error_set(error, ERROR_USAGE,
		    "%s has parameters of the model %s, %s of %s\n"
		    "run 'compare' to see the difference between the products",
		    mine->key, of->name, other->key,
		    breakage_model_of_params(&b)->name);
	params_scale_largest_beta_to_1(&a);
	params_scale_largest_beta_to_1(&b);
	struct answer *r = answer_new_about_site(mine->site, "params",
	    "parameters compared with those of %s", other->key);
	answer_add_columns(r,
	    "parameter, value: %s, other: %s, difference, unit", mine->key,
	    other->key);
	for (size_t j = 0; j < of->n; j++) {
		double x = a.at[j], y = b.at[j];
		answer_add_cells(r, "%s %.4f %.4f %.4f %s",
		    of->parameter[j].name, x, y, y - x, of->parameter[j].unit);
	}
	answer_add_rows_as_json_objects(r, "rows");
	fields_put_values(
	    answer_json_fields(r), "other_site %s", other->site->name);
	answer_note(r, "%s: %s; %s: %s%s%s%s", mine->key,
	    origin_of_params_text(mine), other->key,
	    origin_of_params_text(other), of->gauge > 0 ? "; " : "",
	    of->gauge > 0 ? of->gauge_name : "",
	    of->gauge > 0 ? tr(" scaled to max 1") : "");
	answer_note(r, "e0_min, alpha and f_mat compensate for each other: run "
		       "'compare' to see the difference between the products");
	return session_show_answer(s, r);
}

/* values: the verb takes values of parameters; operands: the most it takes,
 * counting itself. */
static const struct {
	const char *verb;
	bool values;
	size_t operands;
	command_run *run;
} VERBS[] = {{"list", false, 1, show_params},
    {"set", true, 1, set_named_params},
    {"diff", false, 2, compare_params_of_sites},
    {"use", false, 2, copy_params_of_site}};

bool
cmd_params(struct session *s, const struct args *args, struct error *error)
{
	const char *verb = args->n_operand > 0 ? args->operand[0] : "list";
	size_t i = 0;
	while (i < ARRAY_LEN(VERBS) && strcmp(verb, VERBS[i].verb) != 0)
		i++;
	if (i == ARRAY_LEN(VERBS))
		return error_set(error, ERROR_USAGE,
		    "params: expected list, set, diff or use, got '%s'", verb);
	if (args->n_operand > VERBS[i].operands)
		return error_set(error, ERROR_USAGE,
		    "params %s: unexpected word '%s'", verb, args->operand[1]);
	const struct command_option *o;
	size_t j = 0;
	while ((o = command_option_at(args->command, j)) != NULL &&
	       !args->value[j].given)
		j++;
	if (o != NULL && !VERBS[i].values)
		return error_set(error, ERROR_USAGE,
		    "params %s: expected no values, got %s=\n"
		    "write params set %s=VALUE",
		    verb, o->name, o->name);
	if (o == NULL && VERBS[i].values)
		return error_set(error, ERROR_USAGE,
		    "params set: expected a parameter and its value\n"
		    "write: params set f_mat=2.18 e0_min=16.74 alpha=0.96");
	return VERBS[i].run(s, args, error);
}

bool
show_param_bounds(
    struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	struct answer *r = answer_new("bounds");
	answer_set_title(r, "search bounds");
	answer_add_columns(
	    r, "parameter, lower: lower bound, upper: upper bound, unit");
	const struct breakage *of = BREAKAGES[s->set.model.breakage];
	answer_set_missing_text(r, "by calibrate");
	for (size_t j = 0; j < of->n; j++) {
		const struct bounds *b = &s->set.bounds;
		bool open = j == of->reference && !(b->upper[j] > 0);
		answer_add_cells(r, "%s %g %g %s", of->parameter[j].name,
		    open ? NAN : b->lower[j], open ? NAN : b->upper[j],
		    of->parameter[j].unit);
	}
	return session_show_answer(s, r);
}

/* Reads "a..b", or one number, which holds the parameter fixed. */
static bool
parse_param_bounds(const char *word, double *lower, double *upper)
{
	const char *dots = strstr(word, "..");
	FREED char *first = dots != NULL ? xstrndup(word, (size_t)(dots - word))
					 : xstrdup(word);
	return text_parse_typed_number(first, lower) &&
	       text_parse_typed_number(dots != NULL ? dots + 2 : word, upper) &&
	       *lower <= *upper;
}

bool
cmd_bounds(struct session *s, const struct args *args, struct error *error)
{
	if (args->n_operand == 0)
		return show_param_bounds(s, args, error);
	if (strcmp(args->operand[0], "default") == 0) {
		s->set.bounds = bounds_default(s->set.model.breakage);
		return true;
	}
	const struct breakage *of = BREAKAGES[s->set.model.breakage];
	size_t j = breakage_parameter_index(of, args->operand[0]);
	if (j == of->n) {
		FREED char *names = xstrdup(of->parameter[0].name);
		for (size_t i = 1; i < of->n; i++)
			xappend(&names, " %s", of->parameter[i].name);
		return error_set(error, ERROR_USAGE,
		    "there is no parameter '%s'\n%s, or default",
		    args->operand[0], names);
	}
	const struct param_info *info = &of->parameter[j];
	if (args->n_operand < 2)
		return error_set(error, ERROR_USAGE,
		    "bounds %s: expected a range a..b, or one value to hold it "
		    "fixed",
		    info->name);
	double lower, upper;
	if (!parse_param_bounds(args->operand[1], &lower, &upper))
		return error_set(error, ERROR_USAGE,
		    "bounds: expected a range from low to high (0..1) or one "
		    "number, got '%s'",
		    args->operand[1]);
	if (lower < info->least || upper > info->most)
		return error_set(error, ERROR_USAGE,
		    "expected bounds of %s from %g to %g, got %s", info->name,
		    info->least, info->most, args->operand[1]);
	s->set.bounds.lower[j] = lower;
	s->set.bounds.upper[j] = upper;
	return true;
}
