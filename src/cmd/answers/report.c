/* report: the answers of other commands as a document.  The table of sections
 * defines its content.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/answers/predict.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/question.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/cut.h"
#include "cmd/document/document.h"
#include "cmd/fit/job.h"
#include "cmd/session/invocation.h"
#include "cmd/session/journal.h"
#include "cmd/ask/trust_light.h"
#include "cmd/run/line.h"
#include "cmd/lang/table.h"
#include "config.h"
#include "core/psd/rotor_speed.h"
#include "io/cells/datetime.h"
#include "io/sitefile/units.h"

/* What a section needs.  If only parameters are missing, the report says so;
 * sections that lack something else are left out silently. */
enum need {
	NEED_SITE,
	NEED_PARAMS,
	NEED_FIT,     /* a calibration of this session */
	NEED_NONE,    /* a site that has no parameters */
	NEED_SEVERAL, /* several sites with parameters */
	NEED_CUTS,    /* cuts added after the calibration */
	NEED_SPEC,    /* an envelope in use */
	NEED_CONDITIONS,
	NEED_TPH
};

/* The request: a speed, m/s, and the new feed, t/h, or 0.  Each text is a part
 * of a command line that begins with a space, or is "": the conditions in
 * quotes, the envelope as an operand and as an option, other options of the
 * question, those of the fraction, and the new feed.  list: all conditions,
 * including those of the envelope.  wanted, found: the search for speeds that
 * meet them, if the site has parameters. */
struct report_request {
	double speed, tph;
	char *conditions, *envelope, *spec, *asked, *cut, *rate;
	const struct question *q;
	struct condition_list list;
	struct conditions_search wanted;
	struct speed_search *found;
};

/* Headings, and a command below each; a NULL heading continues the section
 * before.  The words in capitals are replaced with parts of the request. */
static const struct section {
	const char *heading, *line;
	enum need need;
} SECTIONS[] = {
    {N_("Product at SPEED m/s"), "predict SPEEDASKEDCUT", NEED_PARAMS},
    {N_("Card"), "cardCONDITIONSRATESPECASKEDCUT", NEED_PARAMS},
    {N_("How sure the answer is"), "plot psd speed=SPEED band=onASKED",
	NEED_PARAMS},
    {NULL, "why SPEEDASKED", NEED_PARAMS},
    {NULL, "uncertainty speed=SPEEDASKED", NEED_FIT},
    {NULL, "advise speed=SPEEDASKED", NEED_FIT},
    {N_("Other speeds"), "sweepASKEDCUT", NEED_PARAMS},
    {NULL, "plot sweepASKED", NEED_PARAMS},
    {N_("Window"), "windowCONDITIONSSPECASKEDCUT", NEED_CONDITIONS},
    {N_("Grading envelope"), "specENVELOPE speed=SPEEDASKEDCUT", NEED_SPEC},
    {N_("Flow"), "flowRATE speed=SPEEDASKED", NEED_TPH},
    {N_("Validation"), "validate", NEED_PARAMS},
    {N_("Routine cuts"), "drift", NEED_CUTS},
    {NULL, "plot drift", NEED_CUTS},
    {N_("First estimate of the product at SPEED m/s"), "guess SPEED",
	NEED_NONE},
    {N_("Data"), "show site", NEED_SITE},
    {NULL, "show feed", NEED_SITE},
    {NULL, "show product", NEED_SITE},
    {N_("Check and mends"), "check", NEED_SITE},
    {N_("Fit"), "show params", NEED_PARAMS},
    {NULL, "show model", NEED_PARAMS},
    {NULL, "identify", NEED_FIT},
    {NULL, "plot residuals", NEED_PARAMS},
    {N_("All loaded sites"), "sites", NEED_SEVERAL},
    {NULL, "validate all", NEED_SEVERAL},
    {NULL, "plot parity", NEED_SEVERAL},
};

/* True if the section needs parameters and lacks nothing else. */
static bool
does_section_lack_only_params(const struct report_request *ask, enum need need)
{
	return need == NEED_PARAMS ||
	       (need == NEED_CONDITIONS && ask->list.n > 0) ||
	       (need == NEED_TPH && ask->tph > 0);
}

static bool
has_data_for_report_section(
    const struct session *s, const struct report_request *ask, enum need need)
{
	const struct entry *entry = &s->entry[s->current];
	size_t known = 0;
	for (size_t i = 0; i < s->n_entry; i++)
		known += s->entry[i].has_params;
	switch (need) {
	case NEED_PARAMS:
	case NEED_CONDITIONS:
	case NEED_TPH:
		return entry->has_params &&
		       does_section_lack_only_params(ask, need);
	case NEED_FIT:
		return entry->has_params &&
		       origin_fit_behind_params(entry) != NULL;
	case NEED_NONE:
		return !entry->has_params;
	case NEED_SEVERAL:
		return known > 1;
	case NEED_CUTS:
		return entry->has_params &&
		       cut_compare_runs_since_fit(s, entry).n > 0;
	case NEED_SPEC:
		return entry->has_params &&
		       (s->spec != NULL || ask->spec[0] != '\0');
	default:
		return true;
	}
}

/* Replaces the words in capitals with parts of the request.  The caller frees
 * the text. */
static char *
fill_in_placeholders(const char *words, const struct report_request *ask)
{
	char speed[32], *text = xstrdup("");
	const struct {
		const char *word, *value;
	} with[] = {{"SPEED", text_shortest_exact_number(ask->speed, speed)},
	    {"SPEC", ask->spec}, {"CONDITIONS", ask->conditions},
	    {"ENVELOPE", ask->envelope}, {"ASKED", ask->asked},
	    {"CUT", ask->cut}, {"RATE", ask->rate}};
	while (*words != '\0') {
		size_t i = 0;
		while (i < ARRAY_LEN(with) &&
		       strncmp(words, with[i].word, strlen(with[i].word)) != 0)
			i++;
		if (i < ARRAY_LEN(with)) {
			xappend(&text, "%s", with[i].value);
			words += strlen(with[i].word);
		} else {
			xappend(&text, "%c", *words++);
		}
	}
	return text;
}

/* Runs a line and puts its answer into the document, or the reason why it
 * failed.  A check that finds a fault counts as an answer. */
static void
run_command_into_report(struct session *s, const char *line)
{
	struct error error = {0};
	size_t next;
	/* Set aside, so that a stopped calibration can be continued later. */
	const struct job stopped = s->job;
	s->job = (struct job){0};
	bool ok = session_run_line(s, line, 0, "report", 1, &next, &error);
	session_run_job_to_end(s);
	ok = ok && session_end_finished_commands(s, true, &error);
	s->job = stopped;
	if (ok || error.kind == ERROR_CHECK)
		return;
	document_add_paragraph(s->document, DOCUMENT_WORDS,
	    "No '%s' here: %s%s%s", line, error.text,
	    error.hint[0] != '\0' ? "; " : "", error.hint);
}

static void
write_report_sections(struct session *s, const struct report_request *ask)
{
	for (size_t i = 0; i < ARRAY_LEN(SECTIONS); i++) {
		const struct section *row = &SECTIONS[i];
		if (!has_data_for_report_section(s, ask, row->need))
			continue;
		FREED char *line = fill_in_placeholders(row->line, ask);
		if (row->heading != NULL) {
			FREED char *heading =
			    fill_in_placeholders(tr(row->heading), ask);
			document_add_paragraph(
			    s->document, DOCUMENT_HEADING, "%s", heading);
		}
		run_command_into_report(s, line);
	}
}

/* States the provenance of the data, as a warning if they were not measured. */
static void
write_data_provenance(struct document *d, const struct site *site)
{
	FREED char *first = site_provenance_first_clause(site, ""),
		   *from = site_translate_provenance(first);
	if (from[0] == '\0')
		document_add_paragraph(d, DOCUMENT_WARNING,
		    "The site file does not state where its data are from.");
	else if (site_is_data_made_up(first))
		document_add_paragraph(d, DOCUMENT_WARNING,
		    "The data were not measured at a plant: %s.", from);
	else
		document_add_paragraph(d, DOCUMENT_WORDS, "Data: %s.", from);
}

static void
write_trust_light(struct session *s, const struct report_request *ask)
{
	const struct entry *entry = ask->q->entry;
	struct trust t = trust_at_speed(s, entry, ask->speed, ask->q->feed);
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, ask->speed, NAN);
	FREED char *words =
	    xasprintf(tr("Trust: %s. %s the answer at %.*f m/s%s%s"),
		tr(LIGHT_NAME[t.light]),
		t.n == 0 ? tr("Nothing in the data or the fit casts doubt on")
		: t.light == LIGHT_RED ? tr("Do not rely on")
				       : tr("Take care with"),
		units_speed_decimals(ask->speed), ask->speed, rpm,
		t.n == 0 ? "." : ":");
	document_add_trust_light(s->document, t.light, words);
	for (size_t i = 0; i < t.n; i++)
		document_add_paragraph(s->document, DOCUMENT_WORDS, "%s: %s.",
		    tr(LIGHT_NAME[t.reason[i].light]), t.reason[i].text);
	trust_free(&t);
}

/* Appends "; met at 73.04 to 76.18 m/s", or the nearest miss. */
static void
append_speeds_meeting_conditions(char **words, const struct report_request *ask)
{
	const struct speed_search *w = ask->found;
	FREED char *speeds =
	    conditions_met_speeds_text_with_units(&ask->wanted, w);
	if (w->n_inside > 0)
		xappend_to_list(words, "; ", tr("met at %s"), speeds);
	if (w->n_inside > 0)
		return;
	FREED char *range = rotor_speed_rpm_text(
	    ask->q->entry->site->rotor, ask->wanted.from, ask->wanted.to);
	xappend_to_list(words, "; ",
	    ask->list.n > 1
		? tr("no speed from %g to %g m/s%s meets all of them")
		: tr("no speed from %g to %g m/s%s meets it"),
	    ask->wanted.from, ask->wanted.to, range);
	if (!isfinite(w->margin.passing))
		return;
	forecast_set_speed(ask->wanted.forecast, w->best);
	FREED char *misses = conditions_margin_text(&ask->wanted, w->margin);
	FREED char *rpm =
	    rotor_speed_rpm_text(ask->q->entry->site->rotor, w->best, NAN);
	xappend_to_list(words, "; ",
	    tr("the speed that comes closest misses by %s: %.1f m/s%s"), misses,
	    w->best, rpm);
}

/* Says whether the product at the report's speed meets the conditions. */
static void
write_whether_conditions_met(
    struct session *s, const struct report_request *ask)
{
	if (!has_data_for_report_section(s, ask, NEED_CONDITIONS))
		return;
	forecast_set_speed(ask->wanted.forecast, ask->speed);
	bool met = conditions_are_met(&ask->wanted, SIZE_MAX);
	double share = conditions_probability(&ask->wanted);
	FREED char *list = conditions_list_text(&ask->list);
	FREED char *often = conditions_times_in_100_text(share);
	FREED char *chance = isnan(share)
				 ? xstrdup(conditions_verdict(share, met))
				 : xasprintf(tr("met %s"), often);
	FREED char *rpm =
	    rotor_speed_rpm_text(ask->q->entry->site->rotor, ask->speed, NAN);
	FREED char *words = xasprintf(tr("Conditions: %s: at %.*f m/s%s %s"),
	    list, units_speed_decimals(ask->speed), ask->speed, rpm, chance);
	append_speeds_meeting_conditions(&words, ask);
	document_add_paragraph(s->document,
	    (isnan(share) ? met : share >= 0.5) ? DOCUMENT_WORDS
						: DOCUMENT_WARNING,
	    "%s.", words);
}

/* Writes the answer itself, with its bands. */
static void
write_headline_answer(struct session *s, const struct report_request *ask)
{
	const struct question *q = ask->q;
	if (!has_data_for_report_section(s, ask, NEED_PARAMS))
		return;
	struct prediction p =
	    forecast_whole_product(s, q->entry, ask->speed, q->feed);
	const struct quantity of = answers_default_passing_quantity(&p.product);
	FREED char *sure = predict_certainty_text(
	    s, q, &of, ask->speed, light_of_answer_or_fit(s, q->entry, &p));
	if (sure != NULL)
		document_add_paragraph(
		    s->document, DOCUMENT_WORDS, "%s.", sure);
	prediction_free(&p);
}

/* Lists the sections that need parameters.  Written instead of the light if
 * there are none. */
static void
write_missing_report_sections(
    struct session *s, const struct report_request *ask)
{
	FREED char *list = xstrdup("");
	for (size_t i = 0; i < ARRAY_LEN(SECTIONS); i++) {
		const struct section *row = &SECTIONS[i];
		if (row->heading == NULL ||
		    !does_section_lack_only_params(ask, row->need))
			continue;
		FREED char *heading =
		    fill_in_placeholders(tr(row->heading), ask);
		xappend_to_list(&list, "; ", "%s", heading);
	}
	document_add_paragraph(s->document, DOCUMENT_WARNING,
	    "The site is not calibrated. Missing here: %s. Next step: run "
	    "'calibrate', then 'report' again.",
	    list);
}

static void
write_reproducing_script(struct session *s, const struct report_request *ask)
{
	struct error error = {0};
	document_add_paragraph(
	    s->document, DOCUMENT_HEADING, "The script that makes this again");
	if (!journal_can_be_saved(s, &error)) {
		document_add_paragraph(s->document, DOCUMENT_WORDS,
		    "None: %s; %s.", error.text, error.hint);
		return;
	}
	FILE *out = s->document->out;
	fprintf(out, "# A session of tipspeed %s, written by 'report'.\n",
	    PACKAGE_VERSION);
	journal_write_script(s, NULL, out);
	FREED char *file = text_add_quotes(s->file);
	FREED char *line = fill_in_placeholders(
	    "reportCONDITIONS speed=SPEEDRATESPECASKEDCUT", ask);
	fprintf(out, "%s > %s\n", line, file);
}

static void
write_report(struct session *s, const struct report_request *ask)
{
	const struct site *site = ask->q->entry->site;
	FREED char *label = session_site_label(site);
	FREED char *today = datetime_today_text();
	FREED char *title = xasprintf(tr("Report: %s, %s"), label, today);
	document_set_title(s->document, title);
	write_headline_answer(s, ask);
	write_whether_conditions_met(s, ask);
	if (has_data_for_report_section(s, ask, NEED_PARAMS))
		write_trust_light(s, ask);
	else
		write_missing_report_sections(s, ask);
	write_data_provenance(s->document, site);
	write_report_sections(s, ask);
	write_reproducing_script(s, ask);
}

/* Appends a space, the name, and the words in quotes. */
static void
append_quoted_option(char **text, const char *name, const char *words)
{
	FREED char *quoted = text_add_quotes(words);
	xappend(text, " %s%s", name, quoted);
}

/* Returns the options that the call gives, as a part of a command line: "
 * cut=\"0/4\"".  The caller frees it. */
static char *
given_options_text(const struct args *args, const void *const *option, size_t n)
{
	char *words = xstrdup("");
	for (size_t i = 0; i < n; i++) {
		FREED char *key =
		    xasprintf("%s=", args_option_name(args, option[i]));
		if (args_is_given(args, option[i]))
			append_quoted_option(
			    &words, key, args_value_text(args, option[i]));
	}
	return words;
}

static void
format_report_section_options(
    const struct args *args, struct report_request *ask)
{
	const void *const cut[] = {
	    &args->cut, &args->sharpness, &args->cut_size};
	const void *const asked[] = {&args->feed, &args->rotor_mm,
	    &args->cascade, &args->k, &args->correction};
	char number[32];
	ask->conditions = xstrdup("");
	for (size_t i = 0; i < args->n_operand; i++)
		append_quoted_option(&ask->conditions, "", args->operand[i]);
	ask->envelope = xstrdup("");
	ask->spec = xstrdup("");
	if (args->spec != NULL) {
		append_quoted_option(&ask->envelope, "", args->spec);
		append_quoted_option(&ask->spec, "spec=", args->spec);
	}
	ask->cut = given_options_text(args, cut, ARRAY_LEN(cut));
	ask->asked = given_options_text(args, asked, ARRAY_LEN(asked));
	ask->tph = args->tph;
	ask->rate = args->tph > 0
			? xasprintf(" tph=%s",
			      text_shortest_exact_number(args->tph, number))
			: xstrdup("");
}

/* Reads the request.  Errors in conditions are thus reported before anything is
 * written. */
static bool
parse_report_request(struct session *s, const struct args *args,
    struct report_request *ask, struct error *error)
{
	format_report_section_options(args, ask);
	if (!conditions_add_from_args(s, args, ask->q, &ask->list, error))
		return false;
	ask->speed = ask->q->speed;
	if (!has_data_for_report_section(s, ask, NEED_CONDITIONS))
		return true;
	ask->wanted = conditions_open_search(s, ask->q, &ask->list, NULL);
	ask->found = speed_search_run(&ask->wanted);
	if (!ask->q->speed_given && ask->found->n_inside > 0)
		ask->speed = ask->found->best;
	return true;
}

static void
report_request_free(struct report_request *ask)
{
	speed_search_free(ask->found);
	forecast_close(ask->wanted.forecast);
	conditions_free(&ask->list);
	free(ask->conditions);
	free(ask->envelope);
	free(ask->spec);
	free(ask->asked);
	free(ask->cut);
	free(ask->rate);
}

bool
cmd_report(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	struct report_request ask = {.q = q};
	const char *file = args->n_operand == 1 ? args->operand[0] : "";
	bool named =
	    strchr(file, ' ') == NULL &&
	    (text_ends_with(file, ".html") || text_ends_with(file, ".pdf"));
	if (s->document == NULL)
		return error_set(error, ERROR_USAGE,
		    "report: expected a file for it, .html or .pdf\n"
		    "write: report > %s",
		    named ? file : "report.html");
	question_use_last_speed_and_feed(s, args, q);
	bool ok = parse_report_request(s, args, &ask, error);
	if (ok) {
		/* The answers from before the report stay available to
		 * assert, and what was asked to later commands. */
		const struct last_asked asked = s->last_asked;
		struct answer **kept = s->answer;
		size_t n_kept = s->n_answer;
		s->answer = NULL;
		s->n_answer = 0;
		write_report(s, &ask);
		s->last_asked = asked;
		session_remove_answers(s);
		free(s->answer);
		s->answer = kept;
		s->n_answer = n_kept;
	}
	report_request_free(&ask);
	return ok;
}
