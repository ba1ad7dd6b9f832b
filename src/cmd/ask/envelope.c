/* Turns an envelope into conditions on a fraction, and compares each with the
 * forecast at a speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/envelope.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/files.h"
#include "cmd/ask/question.h"
#include "cmd/ask/quantity_words.h"
#include "io/formats/standards.h"
#include "io/sitefile/units.h"

static const struct spec *
add_envelope_to_session(struct session *s, struct spec *spec)
{
	s->specs = xrealloc(s->specs, s->n_spec + 1, sizeof(*s->specs));
	return s->specs[s->n_spec++] = spec;
}

/* Returns the shipped envelope of that name if the session has read it. */
static const struct spec *
find_shipped_envelope_in_session(const struct session *s, const char *name)
{
	for (size_t i = 0; i < s->n_spec; i++)
		if (s->specs[i]->standard[0] != '\0' &&
		    strcmp(s->specs[i]->name, name) == 0)
			return s->specs[i];
	return NULL;
}

static const struct spec *
find_shipped_envelope(struct session *s, const char *words, struct error *error)
{
	struct standards *all = standards_read_built_in();
	const struct spec *found = standards_find_envelope(all, words, error);
	const struct spec *same =
	    found != NULL ? find_shipped_envelope_in_session(s, found->name)
			  : NULL;
	for (size_t i = 0; found != NULL && same == NULL && i < all->n; i++) {
		if (all->spec[i] != found)
			continue;
		same = add_envelope_to_session(s, all->spec[i]);
		all->spec[i] = NULL;
	}
	standards_free(all);
	return same;
}

static const struct spec *
read_envelope_file(struct session *s, const char *path, struct error *error)
{
	struct error_list errors = {.stop = s->hooks.stop};
	if (s->safe) {
		error_set(error, ERROR_USAGE,
		    "%s is a file, and --safe allows no files\nname an "
		    "envelope of 'spec list', or start the program without "
		    "--safe",
		    path);
		return NULL;
	}
	files_record_read(s, path);
	struct spec *spec = spec_read_file(path, &errors);
	if (spec == NULL) {
		session_report_file_faults(s, path, &errors, error);
		return NULL;
	}
	if (spec->note[0] != '\0')
		session_print_note(s, "%s: %s", path, spec->note);
	return add_envelope_to_session(s, spec);
}

const struct spec *
envelope_named_or_chosen(
    struct session *s, const char *words, struct error *error)
{
	if (words != NULL)
		return standards_is_file_path(words)
			   ? read_envelope_file(s, words, error)
			   : find_shipped_envelope(s, words, error);
	if (s->spec == NULL)
		error_set(error, ERROR_USAGE,
		    "no grading envelope is chosen\nrun 'spec use NAME'; 'spec "
		    "list' has the names, and a file name will also do");
	return s->spec;
}

/* The first words of limits on the modulus for one of several categories, of
 * which the buyer chooses one. */
static const char CATEGORY[] = "FM category ";

static bool
begins_with_text(const char *text, const char *start)
{
	return strncmp(text, start, strlen(start)) == 0;
}

/* Returns the fineness modulus that the envelope's standard defines, if the
 * envelope is for a sand; otherwise NULL. */
static const struct modulus *
fineness_modulus_of_sand_standard(const struct spec *spec)
{
	const double sand = 0.006;
	for (size_t i = 0; i < MODULI; i++)
		if (spec->cut[0] <= 0 && spec->cut[1] > 0 &&
		    spec->cut[1] < sand &&
		    begins_with_text(spec->standard, MODULUS[i].name))
			return &MODULUS[i];
	return NULL;
}

/* Returns the first limit of a standard on an item that begins with this text;
 * with `after`, the next one; NULL after the last. */
static const struct standard_limit *
next_limit_of_standard(const struct standards *all, const char *standard,
    const char *item, const struct standard_limit *after)
{
	for (size_t i = after != NULL ? (size_t)(after - all->limit) + 1 : 0;
	     i < all->n_limit; i++)
		if (strcmp(all->limit[i].standard, standard) == 0 &&
		    begins_with_text(all->limit[i].item, item))
			return &all->limit[i];
	return NULL;
}

/* Returns the standard's limits on the modulus that do not belong to a
 * category, or NULL. */
static const struct standard_limit *
fineness_modulus_limit(const struct standards *all, const char *standard)
{
	const struct standard_limit *l = NULL;
	while ((l = next_limit_of_standard(all, standard, "FM ", l)) != NULL)
		if (!begins_with_text(l->item, CATEGORY) && !isnan(l->least))
			return l;
	return NULL;
}

/* Returns the standard's limit on the share retained between two neighbouring
 * sieves, or NULL. */
static const struct standard_limit *
share_between_sieves_limit(const struct standards *all, const char *standard)
{
	return next_limit_of_standard(
	    all, standard, "between two consecutive", NULL);
}

bool
envelope_limits_to_conditions(const struct spec *spec,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, size_t *n_sieve)
{
	struct standards *all = standards_read_built_in();
	const struct standard_limit *fm =
	    fineness_modulus_limit(all, spec->standard);
	const struct standard_limit *step =
	    share_between_sieves_limit(all, spec->standard);
	const struct modulus *m = fineness_modulus_of_sand_standard(spec);
	bool limited = fm != NULL && m != NULL;
	bool known = limited && psd_covers_size(feed, m->mm[m->n - 1] / 1000);
	struct quantity q = {.fraction = *fraction};
	size_t n = 0;
	for (; n < spec->n && psd_covers_size(feed, spec->size[n]); n++) {
		q.kind = QUANTITY_PASSING;
		q.x = spec->size[n];
		conditions_add(
		    list, (struct condition){q, spec->least[n], spec->most[n]});
	}
	q.x = 0;
	if (known) {
		q.kind = QUANTITY_MODULUS;
		q.modulus = m;
		conditions_add(
		    list, (struct condition){q, fm->least, fm->most});
		q.modulus = NULL;
	}
	if (step != NULL && n > 1) {
		q.kind = QUANTITY_STEP;
		q.n_sieve = n;
		q.sieve = spec->size;
		conditions_add(
		    list, (struct condition){q, NAN, step->most / 100});
	}
	standards_free(all);
	*n_sieve = n;
	return known || !limited;
}

static double
predicted_grading_value(const struct grading *g, size_t i)
{
	return forecast_value_with_band(g->conditions.forecast, i).value;
}

bool
envelope_set_error_no_sieve(const struct spec *spec, struct error *error)
{
	return error_set(error, ERROR_DATA,
	    "%s: none of its sieves is in the range of the feed's sieves\nuse "
	    "another envelope ('spec list' lists them), or a feed sieved finer",
	    spec->name);
}

struct fraction
envelope_fraction(
    const struct spec *spec, const char *cut, const struct fraction *asked)
{
	struct fraction f = *asked;
	if (cut == NULL) {
		f.fine = spec->cut[0];
		f.coarse = spec->cut[1];
	}
	return f;
}

bool
envelope_open_grading(const struct session *s, const char *cut,
    const struct spec *spec, const struct question *q, struct grading *g,
    struct error *error)
{
	*g = (struct grading){.spec = spec,
	    .fraction = envelope_fraction(spec, cut, &q->fraction),
	    .modulus = fineness_modulus_of_sand_standard(spec)};
	envelope_limits_to_conditions(
	    spec, &g->fraction, question_feed(q), &g->limits, &g->n_sieve);
	if (g->n_sieve == 0) {
		conditions_free(&g->limits);
		return envelope_set_error_no_sieve(spec, error);
	}
	const struct quantity more[] = {
	    {.kind = QUANTITY_SHARE, .fraction = g->fraction},
	    {.kind = QUANTITY_MODULUS,
		.modulus = g->modulus,
		.fraction = g->fraction}};
	g->conditions = conditions_search_from_question(
	    s, q, g->limits.n, g->limits.at, g->modulus != NULL ? 2 : 1, more);
	return true;
}

bool
envelope_open_chosen_forecast(const struct session *s,
    const struct entry *entry, size_t feed, struct grading *g,
    struct error *error)
{
	struct question q = question_of_whole_product(s, entry, feed);
	return envelope_open_grading(s, NULL, s->spec, &q, g, error);
}

void
envelope_close(struct grading *g)
{
	forecast_close(g->conditions.forecast);
	conditions_free(&g->limits);
}

char *
envelope_title_text(const struct grading *g)
{
	FREED char *fraction = quantities_fraction_text(&g->fraction);
	return fraction_is_screened(&g->fraction)
		   ? xasprintf(tr("%s, fraction %s"), g->spec->name, fraction)
		   : xstrdup(g->spec->name);
}

static const char *
verdict_by_limits_text(double value, double least, double most)
{
	const double exact = 1e-9;
	if (value < least - exact)
		return tr("below");
	return value > most + exact ? tr("above") : "ok";
}

/* Returns the margin of the sieve that is furthest outside. */
static struct margin
margin_of_worst_sieve(const struct grading *g)
{
	struct margin worst = {.passing = INFINITY};
	for (size_t i = 0; i < g->n_sieve; i++) {
		struct margin m = condition_margin(&g->conditions, i);
		worst = m.passing < worst.passing ? m : worst;
	}
	return worst;
}

/* Returns "fineness modulus (ASTM C136) 3.15 is above 3.1" for a limit that is
 * not on a sieve.  The decimals suffice to tell the two numbers apart. */
static char *
missed_limit_text(const struct grading *g, size_t i)
{
	const struct condition *c = &g->limits.at[i];
	struct quantity q = c->quantity;
	const double near = 0.005;
	struct wanted_limit limit = condition_margin(&g->conditions, i).limit;
	double most =
	    quantities_value_in_shown_unit(&q, limit.most ? c->most : c->least);
	double is =
	    quantities_value_in_shown_unit(&q, predicted_grading_value(g, i));
	const char *unit = quantities_unit_suffix(&q);
	q.fraction = (struct fraction){0};
	FREED char *name = quantities_name(&q);
	return xasprintf(tr("%s %.*f%s is %s %g%s"), name,
	    fabs(is - most) < near ? 4 : 2, is, unit,
	    limit.most ? tr("above") : tr("below"), most, unit);
}

char *
envelope_missed_limits_text(const struct grading *g)
{
	struct margin worst = margin_of_worst_sieve(g);
	size_t out = 0;
	for (size_t i = 0; i < g->n_sieve; i++)
		out += !conditions_are_met(&g->conditions, i);
	char *words = xstrdup("");
	if (out > 0)
		xappend(&words,
		    tr("outside on %zu of %zu sieves; worst at %g mm: %.1f "
		       "points %s"),
		    out, g->n_sieve,
		    units_m_to_mm(g->spec->size[worst.limit.i]),
		    -100 * worst.passing,
		    worst.limit.most ? tr("above max") : tr("below min"));
	for (size_t i = g->n_sieve; i < g->limits.n; i++)
		if (!conditions_are_met(&g->conditions, i)) {
			FREED char *one = missed_limit_text(g, i);
			bool first = words[0] == '\0';
			xappend_to_list(&words, "; ",
			    first ? tr("inside on all sieves, but %s") : "%s",
			    one);
		}
	return words;
}

void
envelope_put_inside(struct answer *r, const struct grading *g, bool met)
{
	struct fields *o = answer_json_fields(r);
	if (met && g->n_sieve < g->spec->n)
		fields_put_values(o, "inside %g", NAN);
	else
		fields_put_values(o, "inside %d", met);
}

void
envelope_put_worst_sieve(struct fields *o, const struct grading *g)
{
	struct margin worst = margin_of_worst_sieve(g);
	bool out = !conditions_are_met(&g->conditions, worst.limit.i);
	fields_put_values(o, "worst_mm %g outside_pct %g",
	    out ? units_m_to_mm(g->spec->size[worst.limit.i]) : NAN,
	    !out               ? 0
	    : worst.limit.most ? -100 * worst.passing
			       : 100 * worst.passing);
}

void
envelope_add_sieve_rows(struct answer *r, struct grading *g, double v)
{
	const struct spec *spec = g->spec;
	struct forecast *all = g->conditions.forecast;
	forecast_set_speed(all, v);
	bool band = forecast_draws_of_quantity(all, 0) != NULL;
	answer_add_columns(
	    r, "sieve_mm: sieve mm, min_pct: min %%, max_pct: max %%");
	answer_add_column(r, "passing_pct",
	    fraction_is_screened(&g->fraction) ? N_("fraction %")
					       : N_("product %"));
	if (band)
		answer_add_columns(r, "low_pct: low %%, high_pct: high %%");
	answer_add_columns(r, "verdict");
	for (size_t i = 0; i < spec->n; i++) {
		bool known = i < g->n_sieve,
		     met = known && conditions_are_met(&g->conditions, i);
		struct figure f = {NAN, NAN, NAN};
		if (known)
			f = forecast_value_with_band(all, i);
		answer_add_cells(r, "%g %g %g %.1f",
		    units_m_to_mm(spec->size[i]),
		    units_fraction_to_pct(spec->least[i]),
		    units_fraction_to_pct(spec->most[i]),
		    units_fraction_to_pct(f.value));
		if (band)
			answer_add_cells(r, "%.1f %.1f",
			    units_fraction_to_pct(f.low),
			    units_fraction_to_pct(f.high));
		answer_add_cells(r, "%s",
		    !known ? tr("not known")
		    : met  ? "ok"
		    : condition_margin(&g->conditions, i).limit.most
			? tr("above")
			: tr("below"));
	}
}

/* Returns the verdict on a modulus by the standard's limits, or else the
 * categories that it is in; NULL if the standard has neither.  The caller frees
 * it. */
static char *
fineness_modulus_verdict(
    const struct standards *all, const struct spec *spec, double fm)
{
	const struct standard_limit *own =
	    fineness_modulus_limit(all, spec->standard);
	FREED char *in = xstrdup("");
	const struct standard_limit *l = NULL;
	bool categories =
	    next_limit_of_standard(all, spec->standard, CATEGORY, l) != NULL;
	while ((l = next_limit_of_standard(all, spec->standard, CATEGORY, l)) !=
	       NULL)
		if (fm >= l->least && fm <= l->most)
			xappend_to_list(&in, tr(" and "), "%s",
			    l->item + sizeof CATEGORY - 1);
	char *words = NULL;
	if (own != NULL)
		words = xasprintf(tr("%s; limits %g to %g"),
		    verdict_by_limits_text(fm, own->least, own->most),
		    own->least, own->most);
	else if (categories)
		words = in[0] == '\0' ? xstrdup(tr("in no category"))
				      : xasprintf(tr("category %s"), in);
	return words;
}

static void
note_fineness_modulus(
    struct answer *r, const struct grading *g, const struct standards *all)
{
	size_t i = g->limits.n + 1;
	if (g->modulus == NULL)
		return;
	struct figure fm = forecast_value_with_band(g->conditions.forecast, i);
	FREED char *is = fineness_modulus_verdict(all, g->spec, fm.value);
	if (is == NULL)
		return;
	if (isnan(fm.value)) {
		answer_note(r,
		    "fineness modulus not known: the feed was not sieved down "
		    "to %g mm",
		    g->modulus->mm[g->modulus->n - 1]);
		return;
	}
	FREED char *band = quantities_band_text(fm.low, fm.high, 2);
	answer_note(r, "fineness modulus (%s) %.2f%s: %s", g->modulus->standard,
	    fm.value, band, is);
	fields_put_values(answer_json_fields(r),
	    "fm %g fm_standard %s fm_verdict %s", fm.value,
	    g->modulus->standard, is);
}

/* Notes the largest share between two neighbouring sieves of the envelope, and
 * whether it is within the standard's limit. */
static void
note_largest_share_between_sieves(
    struct answer *r, const struct grading *g, const struct standards *all)
{
	const struct standard_limit *l =
	    share_between_sieves_limit(all, g->spec->standard);
	const struct forecast *f = g->conditions.forecast;
	double most = 0, step[POSTERIOR_DRAWS], range[2] = {NAN, NAN};
	size_t at = 0; /* the coarser of the two */
	if (l == NULL || g->n_sieve < 2)
		return;
	for (size_t i = 0; i + 1 < g->n_sieve; i++) {
		double share = predicted_grading_value(g, i) -
			       predicted_grading_value(g, i + 1);
		if (share <= most)
			continue;
		most = share;
		at = i;
	}
	const double *coarse = forecast_draws_of_quantity(f, at),
		     *fine = forecast_draws_of_quantity(f, at + 1);
	for (size_t d = 0; d < POSTERIOR_DRAWS && coarse != NULL; d++)
		step[d] = 100 * (coarse[d] - fine[d]);
	if (coarse != NULL)
		ensemble_interval_around_answer(
		    step, g->conditions.level, NAN, range);
	FREED char *band = quantities_band_text(range[0], range[1], 1);
	const double coarse_mm = units_m_to_mm(g->spec->size[at]);
	bool open = g->n_sieve < g->spec->n && 100 * most <= l->most;
	const char *is =
	    open ? tr("not known")
		 : verdict_by_limits_text(100 * most, -INFINITY, l->most);
	answer_note(r,
	    "most between two sieves: %.1f %%%s, %g to %g mm: %s; limit %g",
	    100 * most, band, coarse_mm, units_m_to_mm(g->spec->size[at + 1]),
	    is, l->most);
	fields_put_values(answer_json_fields(r),
	    "step_pct %g step_mm %g step_verdict %s", 100 * most, coarse_mm,
	    is);
}

/* Tolerances apply to a declared grading, which is not known. */
static void
note_tolerances_unchecked(
    struct answer *r, const struct spec *spec, const struct standards *all)
{
	size_t n = 0;
	for (size_t i = 0; i < all->n_limit; i++)
		n += strcmp(all->limit[i].standard, spec->standard) == 0 &&
		     strstr(all->limit[i].item, "tolerance") != NULL;
	if (n > 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    "not checked: %zu tolerances of %s, which need a declared "
		    "grading ('spec list limits')",
		    n, spec->standard);
}

void
envelope_add_notes(struct answer *r, const struct grading *g)
{
	const struct spec *spec = g->spec;
	struct standards *all = standards_read_built_in();
	note_fineness_modulus(r, g, all);
	note_largest_share_between_sieves(r, g, all);
	if (fraction_is_screened(&g->fraction)) {
		double share = 100 * predicted_grading_value(g, g->limits.n);
		FREED char *words = quantities_fraction_text(&g->fraction);
		answer_note(r,
		    g->fraction.partition.sharpness > 0
			? N_("the fraction %s is %.1f %% of the product")
			: N_("the fraction %s is %.1f %% of the product, by "
			     "ideal screens"),
		    words, share);
		fields_put_values(answer_json_fields(r), "share_pct %g", share);
	}
	if (g->n_sieve < spec->n)
		answer_add_sentence(r, ANSWER_REMARK,
		    "not checked: %g mm and below, finer than the feed's "
		    "finest sieve",
		    units_m_to_mm(spec->size[g->n_sieve]));
	note_tolerances_unchecked(r, spec, all);
	if (spec->source[0] != '\0')
		answer_add_sentence(
		    r, ANSWER_REMARK, "limits: %s", spec->source);
	standards_free(all);
}

void
envelope_put_fields(struct answer *r, const struct grading *g)
{
	fields_put_values(answer_json_fields(r), "spec %s source %s",
	    g->spec->name, g->spec->source);
	if (fraction_is_screened(&g->fraction)) {
		FREED char *words = quantities_fraction_text(&g->fraction);
		fields_put_values(answer_json_fields(r), "cut %s", words);
	}
	answer_repeat_fields_in_rows(
	    r, "spec cut speed best certainty_pct best_trust");
	answer_add_columns_to_json_fields(
	    r, "sieve_mm min_pct max_pct passing_pct verdict");
}
