/* spec: chooses and lists grading envelopes, and compares the product with one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/question.h"
#include "cmd/ask/envelope.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/lang/table.h"
#include "core/psd/rotor_speed.h"
#include "io/formats/standards.h"
#include "io/sitefile/units.h"

/* Joins the operands from `from` on into one text, because names contain
 * spaces.  Returns NULL if there are none; otherwise the caller frees it. */
static char *
join_operands(const struct args *args, size_t from)
{
	char *words = args->n_operand > from ? xstrdup("") : NULL;
	for (size_t i = from; i < args->n_operand; i++)
		xappend_to_list(&words, " ", "%s", args->operand[i]);
	return words;
}

static char *
envelope_fraction_text(const struct spec *spec)
{
	struct fraction f = {.fine = spec->cut[0], .coarse = spec->cut[1]};
	return fraction_is_screened(&f) ? quantities_fraction_text(&f)
					: xstrdup(tr("whole product"));
}

static bool
set_session_envelope(
    struct session *s, const struct args *args, struct error *error)
{
	FREED char *words = join_operands(args, 1);
	if (words == NULL)
		return error_set(error, ERROR_USAGE,
		    "spec use: expected an envelope\n"
		    "write spec use and a name of 'spec list', or a file");
	const struct spec *spec = envelope_named_or_chosen(s, words, error);
	if (spec == NULL)
		return false;
	s->spec = spec;
	FREED char *cut = envelope_fraction_text(spec);
	session_print_note(s, "envelope: %s (%s): %s", spec->name, cut,
	    spec->source[0] != '\0' ? spec->source : tr("source not stated"));
	return true;
}

static bool
clear_session_envelope(
    struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	(void)error;
	s->spec = NULL;
	return true;
}

/* Returns "2.4 to 4" or "up to 45 %; maximum passing one and retained on
 * next". */
static char *
standard_limit_text(const struct standard_limit *l)
{
	const char *unit = l->unit[0] == '-' ? "" : l->unit;
	char *words = isnan(l->least) ? xasprintf(tr("up to %g"), l->most)
		      : l->least == l->most
			  ? xasprintf("%g", l->most)
			  : xasprintf(tr("%g to %g"), l->least, l->most);
	xappend(&words, "%s%s%s%s", unit[0] != '\0' ? " " : "", unit,
	    l->note[0] != '\0' ? "; " : "", l->note);
	return words;
}

static void
add_standard_limit_rows(struct answer *r, const struct standards *all)
{
	answer_add_columns(r, "limit, is");
	for (size_t i = 0; i < all->n_limit; i++) {
		const struct standard_limit *l = &all->limit[i];
		FREED char *words = standard_limit_text(l);
		FREED char *name = xasprintf("%s: %s", l->standard, l->item);
		answer_add_cells(r, "%s %s", name, words);
	}
	answer_begin_table_for_programs(r);
	answer_add_columns(r, "standard, limit, min, max, unit, note");
	for (size_t i = 0; i < all->n_limit; i++) {
		const struct standard_limit *l = &all->limit[i];
		answer_add_cells(r, "%s %s %g %g %s %s", l->standard, l->item,
		    l->least, l->most, l->unit, l->note);
	}
}

static bool
show_standard_limits(struct session *s, const struct standards *all)
{
	struct answer *r = answer_new("spec");
	answer_set_title(r, "limits of standards that are not on a passing");
	add_standard_limit_rows(r, all);
	answer_add_sentence(r, ANSWER_REMARK,
	    "second-hand copies: check them against your own. Those on a "
	    "fineness modulus and between two sieves are checked by 'spec'; "
	    "tolerances need a declared grading");
	return session_show_answer(s, r);
}

/* Lists the limits of one envelope, sieve by sieve. */
static bool
show_envelope_limits(struct session *s, const struct spec *spec)
{
	struct answer *r = answer_new("spec");
	FREED char *cut = envelope_fraction_text(spec);
	answer_set_title(
	    r, "%s: limits of passing, %%; for %s", spec->name, cut);
	answer_add_columns(
	    r, "sieve_mm: sieve mm, min_pct: min %%, max_pct: max %%");
	for (size_t i = 0; i < spec->n; i++)
		answer_add_cells(r, "%g %g %g", units_m_to_mm(spec->size[i]),
		    units_fraction_to_pct(spec->least[i]),
		    units_fraction_to_pct(spec->most[i]));
	answer_add_sentence(r, ANSWER_REMARK, "limits: %s", spec->source);
	return session_show_answer(s, r);
}

static bool
show_envelope_list(
    struct session *s, const struct standards *all, const bool *match)
{
	struct answer *r = answer_new("spec");
	answer_set_title(r, "grading envelopes, for 'spec use'");
	answer_add_columns(r,
	    "cut: fraction mm, sieves, from_mm: from mm, to_mm: to mm, name");
	for (size_t i = 0; i < all->n; i++) {
		const struct spec *spec = all->spec[i];
		FREED char *cut = envelope_fraction_text(spec);
		if (match == NULL || match[i])
			answer_add_cells(r, "%s %g %g %g %s", cut,
			    (double)spec->n,
			    units_m_to_mm(spec->size[spec->n - 1]),
			    units_m_to_mm(spec->size[0]), spec->name);
	}
	if (s->spec != NULL)
		answer_note(r, "in use: %s", s->spec->name);
	answer_add_sentence(r, ANSWER_REMARK,
	    "second-hand copies: check them against your own; 'spec list NAME' "
	    "has the limits of one, 'spec list limits' those that are not on a "
	    "passing");
	return session_show_answer(s, r);
}

static bool
show_envelopes_or_limits(
    struct session *s, const struct args *args, struct error *error)
{
	FREED char *words = join_operands(args, 1);
	struct standards *all = standards_read_built_in();
	bool *match = xcalloc(all->n, sizeof *match), ok;
	size_t n = words != NULL
		       ? standards_mark_envelopes_named(all, words, match)
		       : 0;
	size_t at = 0;
	while (at < all->n && !match[at])
		at++;
	if (words == NULL)
		ok = show_envelope_list(s, all, NULL);
	else if (strcmp(words, "limits") == 0)
		ok = show_standard_limits(s, all);
	else if (n == 0)
		ok = standards_find_envelope(all, words, error) != NULL;
	else
		ok = n == 1 ? show_envelope_limits(s, all->spec[at])
			    : show_envelope_list(s, all, match);
	free(match);
	standards_free(all);
	return ok;
}

/* Notes which limits are missed, and with what probability all are met. */
static void
note_envelope_verdict(struct answer *r, const struct grading *g, double v)
{
	forecast_set_speed(g->conditions.forecast, v);
	double certain = conditions_probability(&g->conditions);
	FREED char *missed = envelope_missed_limits_text(g);
	fields_put_number(
	    answer_json_fields(r), "certainty_pct", 100 * certain);
	answer_note(r, "%s",
	    missed[0] != '\0'         ? missed
	    : g->n_sieve < g->spec->n ? tr("meets the limits that were checked")
				      : tr("meets the envelope"));
	FREED char *often = conditions_times_in_100_text(certain);
	if (isfinite(certain))
		answer_note(
		    r, "the true product meets the checked limits %s", often);
}

/* Compares the product at a speed with the envelope that the call names, or
 * else with the one in use. */
static bool
compare_product_with_envelope(struct session *s, const struct args *args,
    struct question *q, struct error *error)
{
	const struct entry *entry = q->entry;
	question_use_last_speed(s, q);
	double v = q->speed;
	struct grading g;
	FREED char *words = join_operands(args, 0);
	const struct spec *spec = envelope_named_or_chosen(s, words, error);
	if (spec == NULL || !answers_require_params_current_site(s, error) ||
	    !envelope_open_grading(s, args->cut, spec, q, &g, error))
		return false;
	FREED char *name = envelope_title_text(&g);
	FREED char *rpm = rotor_speed_rpm_text(entry->site->rotor, v, NAN);
	struct answer *r = answer_new_about_site(
	    entry->site, "spec", "%s at %.4g m/s%s", name, v, rpm);
	envelope_add_sieve_rows(r, &g, v);
	note_envelope_verdict(r, &g, v);
	envelope_add_notes(r, &g);
	answers_note_basis_and_trust_at_speed(s, r, q, v, false);
	fields_put_values(answer_json_fields(r), "speed %g extrapolated %d", v,
	    answers_is_speed_extrapolated(entry, v));
	envelope_put_inside(r, &g, conditions_are_met(&g.conditions, SIZE_MAX));
	envelope_put_fields(r, &g);
	session_show_answer(s, r);
	envelope_close(&g);
	return true;
}

bool
cmd_spec(struct session *s, const struct args *args, struct error *error)
{
	static const struct {
		const char *verb;
		command_run *run;
	} VERBS[] = {{"use", set_session_envelope},
	    {"list", show_envelopes_or_limits},
	    {"off", clear_session_envelope}};
	for (size_t i = 0; args->n_operand > 0 && i < ARRAY_LEN(VERBS); i++)
		if (strcmp(args->operand[0], VERBS[i].verb) == 0)
			return VERBS[i].run(s, args, error);
	return session_require_site(s, "spec", error) &&
	       question_read_and_answer(
		   s, args, compare_product_with_envelope, error);
}
