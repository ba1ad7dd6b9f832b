/* Parameters, their bounds, and settings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

static void
show_params(struct session *s, const struct entry *entry)
{
	struct report *r = report_new("params");
	char *label = session_label(entry->site);
	report_title(r, "%s: parameters %s%s", label,
	    entry->has_fit               ? "found by calibration"
	    : entry->recalled[0] != '\0' ? "from store: "
	    : entry->has_params          ? "set by hand"
					 : "not known yet",
	    entry->recalled);
	free(label);
	report_site(r, entry->site->name, entry->site->provenance);
	report_column(r, "parameter", "parameter");
	report_column(r, "value", "value");
	report_column(r, "unit", "unit");
	report_column(r, "meaning", "meaning");
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		report_text(r, PARAMS[j].name);
		report_number(r,
		    entry->has_params ? params_get(&entry->params, j) : NAN,
		    -1);
		report_text(r, PARAMS[j].unit);
		report_text(r, PARAMS[j].meaning);
	}
	session_report(s, r);
}

/* Parameters not named keep their value; where there is none yet, beta has a
 * default and the others must be named. */
static bool
set_params(struct session *s, const struct args *args, struct error *error)
{
	struct entry *entry = session_entry(s);
	const struct command *self = command_find("params");
	struct params p =
	    entry->has_params ? entry->params : params_default_beta();
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		const struct value *v = args_value(self, args, PARAMS[j].name);
		if (v->given)
			params_set(&p, j, v->number);
		else if (!entry->has_params && j >= PARAM_F_MAT)
			return error_set(error, ERROR_USAGE,
			    "params set wants %s too: %s has no parameters "
			    "yet",
			    PARAMS[j].name, entry->site->name);
	}
	session_forget(s);
	entry->params = p;
	entry->has_params = true;
	entry->has_fit = false;
	entry->recalled[0] = '\0';
	return true;
}

bool
cmd_params(struct session *s, const struct args *args, struct error *error)
{
	struct entry *entry = session_entry(s);
	const char *verb = args->n_operand > 0 ? args->operand[0] : "list";
	if (strcmp(verb, "set") == 0)
		return set_params(s, args, error);
	if (strcmp(verb, "list") != 0)
		return error_set(error, ERROR_USAGE,
		    "params wants set or list, not '%s'", verb);
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		if (!args->value[j].given)
			continue;
		error_set(error, ERROR_USAGE,
		    "params lists; to change %s it wants set", PARAMS[j].name);
		return error_hint(error, "params set %s=..", PARAMS[j].name);
	}
	show_params(s, entry);
	return true;
}

static void
show_bounds(struct session *s)
{
	struct report *r = report_new("bounds");
	report_title(r, "search bounds");
	report_column(r, "parameter", "parameter");
	report_column(r, "lower", "from");
	report_column(r, "upper", "to");
	report_column(r, "unit", "unit");
	for (size_t j = 0; j < PARAM_COUNT; j++) {
		report_text(r, PARAMS[j].name);
		report_number(r, s->bounds.lower[j], -1);
		report_number(r, s->bounds.upper[j], -1);
		report_text(r, PARAMS[j].unit);
	}
	session_report(s, r);
}

/* "a..b", or one number, which holds the parameter fixed. */
static bool
read_range(const char *word, double *lower, double *upper)
{
	char *text = xstrdup(word), *dots = strstr(text, "..");
	bool ok;
	if (dots != NULL) {
		*dots = '\0';
		ok = text_number(text, lower) && text_number(dots + 2, upper);
	} else {
		ok = text_number(text, lower);
		*upper = *lower;
	}
	free(text);
	return ok && *lower <= *upper;
}

bool
cmd_bounds(struct session *s, const struct args *args, struct error *error)
{
	if (args->n_operand == 0) {
		show_bounds(s);
		return true;
	}
	if (strcmp(args->operand[0], "default") == 0) {
		s->bounds = bounds_default();
		return true;
	}
	size_t j = params_find(args->operand[0]);
	if (j == PARAM_COUNT) {
		error_set(error, ERROR_USAGE, "there is no parameter '%s'",
		    args->operand[0]);
		return error_hint(error,
		    "beta1 beta2 beta3 beta4 f_mat e0_min alpha, or default");
	}
	if (args->n_operand < 2)
		return error_set(error, ERROR_USAGE,
		    "bounds %s wants a range a..b, or one value to hold it "
		    "fixed",
		    PARAMS[j].name);
	double lower, upper;
	if (!read_range(args->operand[1], &lower, &upper))
		return error_set(error, ERROR_USAGE,
		    "bounds wants a range from low to high (0..1) or one "
		    "number, not '%s'",
		    args->operand[1]);
	if (j >= PARAM_F_MAT && (lower < 0 || upper > 1e4))
		return error_set(error, ERROR_USAGE,
		    "%s lies between 0 and 10000, not %s", PARAMS[j].name,
		    args->operand[1]);
	if (fmax(fabs(lower), fabs(upper)) > 1e9)
		return error_set(error, ERROR_USAGE,
		    "%s lies between -1e9 and 1e9", PARAMS[j].name);
	s->bounds.lower[j] = lower;
	s->bounds.upper[j] = upper;
	return true;
}

static void
show_settings(struct session *s)
{
	static const char *const FORMS[] = {"ratio", "progeny_mm", "parent_mm"};
	struct report *r = report_new("set");
	char *k = xasprintf("%g", s->settings.k);
	char *threads = xasprintf("%u", s->threads);
	const char *rows[][2] = {
	    {"method", s->settings.method == METHOD_CLASSES ? "classes"
							    : "continuous"},
	    {"appearance", FORMS[s->settings.appearance]}, {"k", k},
	    {"threads", threads}, {"isa", isa_name(isa_usable(s->isa))},
	    {"format", REPORT_FORMATS[s->format]}};
	report_column(r, "setting", "setting");
	report_column(r, "value", "value");
	for (size_t i = 0; i < ARRAY_LEN(rows); i++) {
		report_text(r, rows[i][0]);
		report_text(r, rows[i][1]);
	}
	free(k);
	free(threads);
	session_report(s, r);
}

bool
cmd_set(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	const struct command *self = command_find("set");
	const struct value *method = args_value(self, args, "method");
	const struct value *form = args_value(self, args, "appearance");
	const struct value *k = args_value(self, args, "k");
	const struct value *threads = args_value(self, args, "threads");
	const struct value *isa = args_value(self, args, "isa");
	const struct value *format = args_value(self, args, "format");
	if (method->given || form->given || k->given)
		session_forget(s);
	if (method->given)
		s->settings.method = (enum method)method->choice;
	if (form->given)
		s->settings.appearance = (enum appearance_form)form->choice;
	if (k->given)
		s->settings.k = k->number;
	if (threads->given)
		s->threads = (unsigned)threads->whole;
	if (isa->given)
		s->isa = (enum isa)isa->choice;
	if (format->given)
		s->format = (enum report_format)format->choice;
	bool any = method->given || form->given || k->given || threads->given ||
		   format->given;
	if (!any)
		show_settings(s);
	return true;
}

bool
cmd_seed(struct session *s, const struct args *args, struct error *error)
{
	(void)error;
	const struct value *value =
	    args_value(command_find("seed"), args, "seed");
	if (value->given) {
		s->seed = value->whole;
		return true;
	}
	struct report *r = report_new("seed");
	char *text = xasprintf("%llu", (unsigned long long)s->seed);
	report_column(r, "seed", "seed");
	report_text(r, text);
	free(text);
	session_report(s, r);
	return true;
}
