/* identify: which parameters the data determine, and which they do not.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/outlook.h"
#include "cmd/lang/table.h"
#include "core/posterior/identify.h"
#include "core/model/selection.h"
#include "core/psd/rotor_speed.h"
#include "core/search/misfit.h"
#include "io/sitefile/units.h"

/* RIDGE: a correlation above it is a ridge; at most RIDGES of them are named.
 * SHARP: a break size is fixed by the data if its standard deviation is at most
 * this share of it.  OPEN: the threshold counts as open if the break size is
 * below all sieves in more than this share of the draws. */
static const double RIDGE = 0.9, SHARP = 0.1, OPEN = 0.1;
enum { RIDGES = 3 };

static const char *const GRADES[] = {[IDENTIFY_FIXED] = N_("fixed"),
    [IDENTIFY_DETERMINED] = N_("determined"),
    [IDENTIFY_POORLY] = N_("poorly"),
    [IDENTIFY_NOT] = N_("cannot be told")};

/* What the draws show: param [of->n]: the parameters of their model; at
 * [n_speed]: the break sizes at the measured speeds.  rotor: the diameter of
 * the rotor of the runs, m, or 0; finest: the finest sieve compared, m. */
struct findings {
	const struct posterior *p;
	const struct breakage *of;
	struct identify_param param[PARAMS_MOST];
	size_t n_speed;
	double *speed, rotor, finest;
	struct identify_break *at;
	bool open; /* the threshold has an upper bound only */
};

static void
find_measured_speeds(struct findings *f, const struct site *site)
{
	f->finest = INFINITY;
	f->speed = xcalloc_doubles(site->n_run);
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		size_t n = misfit_count_covered_sieves(run);
		if (n == 0)
			continue;
		f->finest = fmin(f->finest, run->product.size[n - 1]);
		if (f->n_speed == 0 || f->speed[f->n_speed - 1] != run->speed)
			f->speed[f->n_speed++] = run->speed;
	}
}

static struct findings
compute_identifiability(const struct posterior *p, const struct site *site)
{
	struct findings f = {.p = p,
	    .of = BREAKAGES[p->settings.breakage],
	    .rotor = site_run_rotor_diameter(site)};
	size_t threshold = breakage_parameter_index(f.of, "e0_min");
	find_measured_speeds(&f, site);
	f.at = xcalloc(f.n_speed + 1, sizeof *f.at);
	for (size_t i = 0; i < f.n_speed; i++)
		f.at[i] =
		    identify_summarise_break_size(p, f.speed[i], f.finest);
	for (size_t j = 0; j < f.of->n; j++)
		f.param[j] = identify_summarise_param(p, j);
	f.open = (f.n_speed > 0 && f.at[0].below > OPEN) ||
		 (threshold < f.of->n && f.param[threshold].bound < 0);
	return f;
}

static bool
is_break_size_precise(const struct findings *f, size_t i)
{
	return f->at[i].sd <= SHARP * f->at[i].mean;
}

static void
add_identifiability_rows(
    struct answer *r, const struct findings *f, const struct site *site)
{
	answer_add_columns(
	    r, "what: , mean, sd, share_pct: %% of prior, unit, grade: ");
	for (size_t i = 0; i < f->n_speed; i++) {
		FREED char *key =
		    xasprintf(tr("break size, %g m/s"), f->speed[i]);
		FREED char *speed = answers_speed_text(site, f->speed[i], -1);
		FREED char *head = xasprintf(tr("break size, %s"), speed);
		answer_add_keyed_cell(r, key, head);
		answer_add_cells(r, "%.3f %.3f %.0f %s", 1000 * f->at[i].mean,
		    1000 * f->at[i].sd, NAN, "mm");
		answer_add_text_cell(r, f->open ? N_("bounded from above")
					: is_break_size_precise(f, i)
					    ? N_("determined")
					    : N_("poorly"));
	}
	for (size_t j = 0; j < f->of->n; j++) {
		const struct identify_param *a = &f->param[j];
		if (j == f->of->reference)
			continue;
		answer_add_cells(r, "%s %.3f %.3f %.0f %s",
		    f->of->parameter[j].name, a->mean, a->sd, 100 * a->ratio,
		    f->of->parameter[j].unit);
		answer_add_text_cell(r,
		    a->bound < 0   ? N_("%s, low bound")
		    : a->bound > 0 ? N_("%s, high bound")
				   : "%s",
		    tr(GRADES[a->grade]));
	}
}

/* Finds the pairs of parameters whose correlation exceeds RIDGE, strongest
 * first, at most RIDGES of them.  Returns their number. */
static size_t
find_correlated_pairs(const struct findings *f, size_t pair[RIDGES][2])
{
	size_t n = 0;
	double last = INFINITY;
	while (n < RIDGES) {
		double most = RIDGE;
		bool found = false;
		for (size_t i = 0; i < f->of->n; i++)
			for (size_t j = i + 1; j < f->of->n; j++) {
				double r =
				    fabs(identify_larger_of_rank_or_linear(
					identify_correlate_params(f->p, i, j)));
				if (!(r > most && r < last))
					continue;
				most = r;
				pair[n][0] = i;
				pair[n][1] = j;
				found = true;
			}
		if (!found)
			return n;
		last = most;
		n++;
	}
	return n;
}

static void
note_correlated_param_pairs(struct answer *r, const struct findings *f)
{
	size_t pair[RIDGES][2], n = find_correlated_pairs(f, pair);
	struct fields *list = fields_add_list(answer_json_fields(r), "ridges");
	for (size_t k = 0; k < n; k++) {
		struct identify_pair c =
		    identify_correlate_params(f->p, pair[k][0], pair[k][1]);
		const char *a = f->of->parameter[pair[k][0]].name;
		const char *b = f->of->parameter[pair[k][1]].name;
		double most = identify_larger_of_rank_or_linear(c);
		fields_put_values(fields_add_object(list, NULL),
		    "a %s b %s linear %g rank %g", a, b, c.linear, c.rank);
		answer_note(r,
		    most > 0
			? N_("%s and %s compensate for each other: a higher "
			     "%s goes with a higher %s (correlation %+.2f)")
			: N_("%s and %s compensate for each other: a higher "
			     "%s goes with a lower %s (correlation %+.2f)"),
		    a, b, a, b, most);
	}
}

/* Appends the break sizes, "5.72 +- 0.06, 4.31 +- 0.05 mm", at the speeds where
 * they are sharp or, unless `sharp`, where they are not. */
static void
append_break_sizes(char **text, const struct findings *f, bool sharp)
{
	FREED char *speeds = xstrdup(""), *sizes = xstrdup(""),
		   *fits = xstrdup(""), *turns = xstrdup(""),
		   *rpm = xstrdup("");
	for (size_t i = 0; i < f->n_speed; i++) {
		if (is_break_size_precise(f, i) != sharp)
			continue;
		xappend_to_list(&speeds, ", ", "%g", f->speed[i]);
		xappend_to_list(&turns, ", ", "%.0f",
		    rotor_speed_to_rpm(f->speed[i], f->rotor));
		xappend_to_list(&sizes, ", ", "%.2f +- %.2f",
		    1000 * f->at[i].mean, 1000 * f->at[i].sd);
		xappend_to_list(&fits, ", ", "%.2f",
		    1000 * params_break_size_by_impacts(
			       &f->p->fit, &f->p->settings, f->speed[i]));
	}
	xend_list_with(&speeds, tr(" and "));
	xend_list_with(&turns, tr(" and "));
	if (f->rotor > 0)
		xfree_and_set(&rpm, xasprintf(tr(" (%s rpm)"), turns));
	if (speeds[0] != '\0')
		xappend_to_list(text, "; ",
		    sharp ? tr("the data fix the break size at %s m/s%s: %s mm "
			       "in the draws, %s by the fit")
			  : tr("the data leave the break size at %s m/s%s "
			       "open: %s mm in the draws, %s by the fit"),
		    speeds, rpm, sizes, fits);
}

static void
append_params_by_identifiability(
    char **text, const struct findings *f, enum identify_grade grade)
{
	FREED char *names = xstrdup("");
	size_t n = 0;
	for (size_t j = 0; j < f->of->n; j++) {
		if (f->param[j].grade != grade)
			continue;
		xappend_to_list(&names, ", ", "%s", f->of->parameter[j].name);
		n++;
	}
	xend_list_with(&names, tr(" and "));
	if (n > 0)
		xappend_to_list(text, "; ",
		    grade == IDENTIFY_NOT
			? tr_n("%s cannot be told", "%s cannot be told", n)
		    : grade == IDENTIFY_POORLY
			? tr_n("%s is determined poorly",
			      "%s are determined poorly", n)
			: tr_n("%s is determined", "%s are determined", n),
		    names);
}

/* Sums up all findings in one sentence.  The caller frees it. */
static char *
identifiability_summary_text(const struct findings *f)
{
	char *text = xstrdup("");
	if (f->open && f->n_speed > 0) {
		FREED char *rpm =
		    rotor_speed_rpm_text(f->rotor, f->speed[0], NAN);
		xappend_to_list(&text, "; ",
		    tr("the data bound the break size from above only: at most "
		       "%.2f mm at %g m/s%s"),
		    1000 * f->at[0].high, f->speed[0], rpm);
	} else {
		append_break_sizes(&text, f, true);
		append_break_sizes(&text, f, false);
	}
	append_params_by_identifiability(&text, f, IDENTIFY_DETERMINED);
	append_params_by_identifiability(&text, f, IDENTIFY_POORLY);
	append_params_by_identifiability(&text, f, IDENTIFY_NOT);
	return text;
}

static void
put_identifiability_fields(
    struct fields *o, const struct findings *f, const char *text)
{
	struct fields *list = fields_add_list(o, "break_size");
	for (size_t i = 0; i < f->n_speed; i++)
		fields_put_values(fields_add_object(list, NULL),
		    "speed %g mean_mm %g sd_mm %g low_mm %g high_mm %g "
		    "below_sieves_share %g",
		    f->speed[i], 1000 * f->at[i].mean, 1000 * f->at[i].sd,
		    1000 * f->at[i].low, 1000 * f->at[i].high, f->at[i].below);
	list = fields_add_list(o, "parameters");
	for (size_t j = 0; j < f->of->n; j++) {
		const struct identify_param *a = &f->param[j];
		fields_put_values(fields_add_object(list, NULL),
		    "name %s mean %g sd %g prior_sd %g share_pct %g grade %s "
		    "bound %s",
		    f->of->parameter[j].name, a->mean, a->sd, a->prior,
		    100 * a->ratio, tr(GRADES[a->grade]),
		    a->bound < 0   ? "lower"
		    : a->bound > 0 ? "upper"
				   : "none");
	}
	fields_put_values(o, "model %s threshold_open %d sentence %s",
	    f->of->name, f->open, text);
}

bool
cmd_identify(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	if (!answers_require_params_current_site(s, error))
		return false;
	const struct entry *entry = session_current_site_entry(s);
	const struct posterior *p = posterior_even_if_correction_off(s, entry);
	if (p == NULL)
		return band_set_error_missing(s, entry, error);
	struct findings f = compute_identifiability(p, entry->site);
	struct answer *r = answer_new_about_site(
	    entry->site, "identify", "what the data determine");
	FREED char *text = identifiability_summary_text(&f);
	add_identifiability_rows(r, &f, entry->site);
	put_identifiability_fields(answer_json_fields(r), &f, text);
	note_correlated_param_pairs(r, &f);
	FREED char *rpm = rotor_speed_rpm_text(f.rotor, f.speed[0], NAN);
	if (f.open)
		answer_add_sentence(r, ANSWER_WARNING,
		    "the threshold is bounded from above only: at %g m/s%s the "
		    "break size is at most %.2f mm in 90 %% of the draws, "
		    "below the finest sieve (%g mm) in %.0f %%",
		    f.speed[0], rpm, 1000 * f.at[0].high,
		    units_m_to_mm(f.finest), 100 * f.at[0].below);
	if (entry->params.breakage == 0 && s->set.model.impacts.n == 0)
		answer_note(r,
		    "at 52 to 77 of 100 synthetic plants that follow Eqs 1 to "
		    "3, the middle 80 %% of the draws of the break size held "
		    "the true one");
	answer_note(r, "%s", text);
	free(f.speed);
	free(f.at);
	return session_show_answer(s, r);
}
