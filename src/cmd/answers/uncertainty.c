/* uncertainty: the sources of an answer's uncertainty, and its draws.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <gsl/gsl_cdf.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/answers/advise.h"
#include "cmd/answers/predict.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/question.h"
#include "cmd/ask/screened.h"
#include "cmd/session/settings.h"
#include "cmd/lang/parse.h"
#include "cmd/lang/table.h"
#include "core/posterior/ensemble.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

static const char *const PARTS[ENSEMBLE_PARTS] = {
    "parameters_pct", "answer_pct", "sample_pct"};

/* Adds a row for each sieve with half the width of each band, in points.  The
 * band of the answer can be narrower than that of the model alone, because the
 * discrepancy that the runs show is correlated with the parameters. */
static void
add_half_band_width_rows(struct answer *r, const struct session *s,
    const struct question *q, const struct prediction *p)
{
	struct forecast *of[ENSEMBLE_PARTS];
	for (enum ensemble_part part = 0; part < ENSEMBLE_PARTS; part++) {
		of[part] = forecast_open_for_predict_table(s, q);
		forecast_set_speed_and_ensemble(of[part], p->speed, part);
	}
	answer_add_columns(r,
	    "sieve_mm: sieve mm, passing_pct: product %%, parameters_pct: "
	    "model alone, answer_pct: answer, sample_pct: a new sample");
	for (size_t i = 0; i < p->product.n; i++) {
		answer_add_cells(r, "%g %.1f",
		    units_m_to_mm(p->product.size[i]),
		    units_fraction_to_pct(p->product.passing[i]));
		for (size_t part = 0; part < ENSEMBLE_PARTS; part++) {
			struct figure f = forecast_value_with_band(of[part], i);
			answer_add_cells(r, "%.2f", 50 * (f.high - f.low));
		}
	}
	for (size_t part = 0; part < ENSEMBLE_PARTS; part++)
		forecast_close(of[part]);
}

/* Returns the default quantities: with sieves=, the passings at these sieves;
 * otherwise the passing of predict's first sentence, P20, P50 and P80. */
static char *
default_quantities_text(const struct prediction *p, bool sieves)
{
	if (!sieves)
		return xasprintf("passing %g," ANSWERS_SIZE_LIST,
		    units_m_to_mm(
			p->product.size[answers_default_sieve(&p->product)]));
	char *list = xstrdup("");
	for (size_t i = 0; i < p->product.n; i++)
		xappend_to_list(&list, ",", "passing %g",
		    units_m_to_mm(p->product.size[i]));
	return list;
}

/* Adds a row for each figure, with the range of the true value and that of a
 * new sample. */
static void
add_quantity_range_rows(struct answer *r, const struct session *s,
    const struct question *question, const struct prediction *p,
    const struct quantity *q, size_t n)
{
	struct forecast *answer = forecast_open(s, question, q, n);
	struct forecast *sample = forecast_open(s, question, q, n);
	forecast_set_speed(answer, p->speed);
	forecast_set_speed_and_ensemble(sample, p->speed, ENSEMBLE_SAMPLE);
	answer_add_columns(r, "quantity: figure, value, unit, low, high, "
			      "cut_low: cut low, cut_high: cut high");
	for (size_t i = 0; i < n; i++) {
		struct figure a = forecast_value_in_shown_unit(answer, i);
		struct figure cut = forecast_value_in_shown_unit(sample, i);
		int d = quantities_decimals(&q[i]);
		FREED char *words = quantities_name(&q[i]);
		FREED char *key = quantities_field_name(&q[i]);
		answer_add_keyed_cell(r, key, words);
		answer_add_cells(r, "%.*f %s %.*f %.*f %.*f %.*f", d, a.value,
		    quantities_unit(&q[i]), d, a.low, d, a.high, d, cut.low, d,
		    cut.high);
	}
	answer_add_rows_as_json_objects(r, "figures");
	forecast_close(answer);
	forecast_close(sample);
	FREED char *chance = predict_probability_text(question->level);
	answer_note(r,
	    "low, high: the true value lies between them %s; cut low, cut "
	    "high: the same for a new belt cut",
	    chance);
}

/* Puts the median and the range of each hyperparameter into the fields and, if
 * `words`, into notes. */
static void
put_hyperparameter_fields(struct answer *r, const struct session *s,
    const struct posterior *p, bool words)
{
	double value[POSTERIOR_DRAWS], range[2], median, unused;
	struct fields *o = fields_add_object(answer_json_fields(r), "errors");
	for (enum hyper h = 0; h < HYPERS; h++) {
		bool size = h != HYPER_LENGTH && h != HYPER_SLOPE;
		double unit = size ? 100 : 1;
		for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
			value[d] = unit * p->draw[d].hyper[h];
		ensemble_interval_around_answer(
		    value, settings_band_probability(&s->set), NAN, range);
		ensemble_middle_interval(value, 0, &median, &unused);
		struct fields *one = fields_add_object(o, HYPER[h].name);
		fields_put_values(one, "median %g low %g high %g", median,
		    range[0], range[1]);
		if (words)
			answer_note(r,
			    size ? N_("%s: %.2f points (%.2f to %.2f): %s")
				 : N_("%s: %.2f (%.2f to %.2f): %s"),
			    HYPER[h].name, median, range[0], range[1],
			    tr(HYPER[h].meaning));
	}
}

/* States in how many draws the rock has two strengths, and how they differ: in
 * the fields and, if `words`, in a note. */
static void
note_draws_with_two_strengths(
    struct answer *r, const struct posterior *p, bool words)
{
	double two = 0, share = 0, ratio = 0;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
		const struct strengths *rock = &p->draw[d].strengths;
		if (!(rock->share > 0))
			continue;
		two++;
		share += rock->share;
		ratio += rock->harder / rock->softer;
	}
	struct fields *o =
	    fields_add_object(answer_json_fields(r), "two_strengths");
	fields_put_values(o, "draws_pct %g harder_share_pct %g ratio %g",
	    100 * two / POSTERIOR_DRAWS, 100 * share / two, ratio / two);
	if (words && two > 0)
		answer_note(r,
		    "two strengths: in %.0f %% of the draws; in those, %.0f %% "
		    "of the rock has a threshold %.2f times that of the rest",
		    100 * two / POSTERIOR_DRAWS, 100 * share / two,
		    ratio / two);
}

static void
note_convergence_of_posterior_draws(struct answer *r, const struct posterior *p,
    const struct evidence *e, bool words)
{
	bool settled = !(e->halves > DRAWS_SETTLED);
	fields_put_values(answer_json_fields(r),
	    "draws %g halves_pct %g ratio %g drift %g accepted %g",
	    (double)POSTERIOR_DRAWS, 100 * e->halves, p->ratio, p->drift,
	    p->accepted);
	if (words || !settled)
		answer_add_sentence(r, settled ? ANSWER_REMARK : ANSWER_WARNING,
		    settled
			? N_("%d draws: the first half and the second differ "
			     "by %.0f %% of the band's width")
			: N_("%d draws that have not settled: their two halves "
			     "differ by %.0f %% of the band's width"),
		    POSTERIOR_DRAWS, 100 * e->halves);
}

/* Adds a row for each draw: its parameters and its answer. */
static struct answer *
build_posterior_draws_answer(const struct session *s, const struct question *q,
    const struct posterior *p, const struct prediction *at, size_t n)
{
	struct forecast *f = forecast_open_for_predict_table(s, q);
	size_t sieves = at->product.n;
	forecast_set_speed(f, at->speed);
	const struct breakage *of = BREAKAGES[p->settings.breakage];
	FREED char *fraction = screened_fraction_title_suffix(&at->fraction);
	FREED char *rpm =
	    rotor_speed_rpm_text(q->entry->site->rotor, at->speed, NAN);
	struct answer *r = answer_new_about_site(q->entry->site, "uncertainty",
	    "draws at %.*f m/s%s%s", units_speed_decimals(at->speed), at->speed,
	    rpm, fraction);
	answer_add_columns(r, "draw: draw");
	for (size_t j = 0; j < of->n; j++)
		answer_add_columns(r, "%s", of->parameter[j].name);
	answer_add_columns(r, "harder_share, softer_e0, harder_e0");
	for (size_t h = 0; h < HYPERS; h++)
		answer_add_columns(r, "%s", HYPER[h].symbol);
	for (size_t k = 0; k < PSD_SIZES; k++)
		answer_add_columns(r, "%s", ANSWERS_SIZE[k].key);
	for (size_t i = 0; i < sieves; i++)
		answer_add_columns(
		    r, "passing_pct@%g", units_m_to_mm(at->product.size[i]));
	for (size_t d = 0; d < n; d++) {
		double e0 = p->draw[d].params.at[of->strength + 1];
		answer_add_cells(r, "%g", (double)d + 1);
		for (size_t j = 0; j < of->n; j++)
			answer_add_cells(r, "%.6g", p->draw[d].params.at[j]);
		answer_add_cells(r, "%.6g %.6g %.6g",
		    p->draw[d].strengths.share,
		    e0 * p->draw[d].strengths.softer,
		    e0 * p->draw[d].strengths.harder);
		for (size_t h = 0; h < HYPERS; h++)
			answer_add_cells(r, "%.6g", p->draw[d].hyper[h]);
		for (size_t k = 0; k < PSD_SIZES; k++)
			answer_add_cells(r, "%.4f",
			    1000 *
				forecast_draws_of_quantity(f, sieves + k)[d]);
		for (size_t i = 0; i < sieves; i++)
			answer_add_cells(r, "%.4f",
			    100 * forecast_draws_of_quantity(f, i)[d]);
	}
	forecast_close(f);
	answer_add_sentence(r, ANSWER_REMARK,
	    "sigma_d, sigma_n, sigma_s and sigma_i are passings from 0 to 1: "
	    "0.001 is 0.1 points");
	return r;
}

/* Returns the quantity for the notes: the first of of= or, without of=, the
 * passing of predict's first sentence. */
static struct quantity
choose_quantity_for_notes(const struct question *q, const struct args *args,
    const struct prediction *at, const struct quantity *named)
{
	if (args->of != NULL)
		return named[0];
	struct quantity of = answers_default_passing_quantity(&at->product);
	of.fraction = q->fraction;
	return of;
}

/* Returns "0/2" for what passes 2 mm.  The caller frees it. */
static char *
quantity_short_name(const struct quantity *of)
{
	if (of->kind == QUANTITY_PASSING &&
	    !fraction_is_screened(&of->fraction))
		return xasprintf("0/%g", units_m_to_mm(of->x));
	return quantities_name(of);
}

static void
note_effect_of_sampled_feeds(struct answer *r, const struct session *s,
    const struct question *q, const struct quantity *of, double speed)
{
	double most = predict_largest_change_by_feed(s, q, of, speed);
	if (!(most > 0))
		return;
	FREED char *name = quantity_short_name(of);
	double shown = quantities_value_in_shown_unit(of, most);
	answer_note(r, "the feeds that were sampled change %s by up to %.*f%s",
	    name, quantities_decimals(of), shown,
	    quantities_difference_suffix(of));
	if (of->kind == QUANTITY_PASSING)
		fields_put_values(
		    answer_json_fields(r), "feeds_move_pct %g", shown);
}

/* Notes which next sample would narrow the band of a quantity most, or that
 * more exact tip speeds would. */
static void
note_best_next_sample(struct answer *r, const struct session *s,
    const struct question *q, const struct quantity *of)
{
	struct sample_advice best;
	double width, exact_width;
	if (!advise_find_best_sample(s, q, of, &best, &width, &exact_width))
		return;
	double share = 1 - best.width / width;
	FREED char *name = quantity_short_name(of);
	FREED char *rpm =
	    rotor_speed_rpm_text(q->entry->site->rotor, best.speed, NAN);
	fields_put_values(answer_json_fields(r), "next_mps %g", best.speed);
	if (exact_width < best.width) {
		answer_note(r,
		    "what would help %s at %.4g m/s most: tip speeds that are "
		    "known better than to %g %% (speed_sd=); exact ones would "
		    "narrow its band by %.0f %%",
		    name, q->speed, s->set.speed_sd,
		    100 * (1 - exact_width / width));
		return;
	}
	answer_note(r,
	    share < ADVISE_WORTH
		? N_("what would help %s at %.4g m/s most: several samples, "
		     "for instance at %.4g m/s%s; one narrows the band by only "
		     "%.0f %%")
	    : best.repeat
		? N_("what would help %s at %.4g m/s most: another sample at "
		     "%.4g m/s%s; it is expected to narrow its band by %.0f "
		     "%%; 'advise' takes other figures")
		: N_("what would help %s at %.4g m/s most: a sample at %.4g "
		     "m/s%s; it is expected to narrow its band by %.0f %%; "
		     "'advise' takes other figures"),
	    name, q->speed, best.speed, rpm, 100 * fmax(share, 0));
}

/* Notes how far the errors of the stated speeds, which are in the band, move
 * the product, if at all. */
static void
note_effect_of_speed_errors(struct answer *r, const struct session *s,
    const struct question *q, const struct posterior *p,
    const struct prediction *at)
{
	const double step = 0.005;
	double sd = p->speed_sd;
	double times = ensemble_speed_error_factor(p),
	       sure = gsl_cdf_ugaussian_Pinv((1 + q->level) / 2), most = 0;
	size_t worst = 0;
	struct prediction to[2];
	for (size_t k = 0; k < 2; k++)
		to[k] = forecast_product(
		    s, q, at->speed * (1 + (k == 0 ? -step : step)));
	for (size_t i = 0; i < at->product.n; i++) {
		double slope =
		    (to[1].product.passing[i] - to[0].product.passing[i]) / 2 /
		    step;
		if (fabs(slope) > most) {
			most = fabs(slope);
			worst = i;
		}
	}
	prediction_free(&to[0]);
	prediction_free(&to[1]);
	most *= sure * times * sd;
	if (!isfinite(most))
		return;
	if (most > 0)
		answer_note(r,
		    "in the band: tip speeds known to %g %% (speed_sd=) move "
		    "what passes %g mm by +- %.2f points, and other sizes by "
		    "less",
		    100 * sd, units_m_to_mm(at->product.size[worst]),
		    100 * most);
	fields_put_values(answer_json_fields(r),
	    "speed_sd_pct %g speeds_move_pct %g", 100 * sd, 100 * most);
}

/* Puts the columns of the table of half widths, which was added last. */
static void
put_half_band_widths(struct answer *r, const struct session *s,
    const struct question *q, const struct prediction *at)
{
	fields_put_values(answer_json_fields(r),
	    "speed %g level %g correction %s", at->speed, 100 * q->level,
	    correction_name(s, q->entry));
	for (size_t i = 0; i < ENSEMBLE_PARTS; i++)
		answer_add_columns_to_json_fields(r, PARTS[i]);
	answer_add_columns_to_json_fields(r, "sieve_mm passing_pct");
	answer_repeat_fields_in_rows(r, "speed level");
}

/* Shows people the figures; with detail=, the table that programs get.  Figures
 * that are named are in csv, too. */
static struct answer *
build_uncertainty_answer(const struct session *s, const struct question *q,
    const struct prediction *at, const struct args *args, struct error *error)
{
	const struct entry *entry = q->entry;
	const struct posterior *p = posterior_even_if_correction_off(s, entry);
	bool detail = args->detail;
	FREED char *fraction = screened_fraction_title_suffix(&at->fraction);
	FREED char *usual = default_quantities_text(at, args->sieves.n > 0);
	size_t n;
	FREED struct quantity *figures =
	    quantities_parse_list_for_feed(args->of != NULL ? args->of : usual,
		&q->fraction, question_feed(q), args->of != NULL, &n, error);
	if (figures == NULL)
		return NULL;
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, at->speed, NAN);
	const struct quantity of =
	    choose_quantity_for_notes(q, args, at, figures);
	struct answer *r = answer_new_about_site(entry->site, "uncertainty",
	    detail
		? N_("half width of the %.0f %% band at %.*f m/s%s%s, points")
		: N_("how sure, %.0f %% bands at %.*f m/s%s%s"),
	    100 * q->level, units_speed_decimals(at->speed), at->speed, rpm,
	    fraction);
	if (detail && !s->linear)
		answer_allow_transposed(r);
	if (!detail) {
		add_quantity_range_rows(r, s, q, at, figures, n);
		answer_begin_table_for_programs(r);
	}
	add_half_band_width_rows(r, s, q, at);
	put_half_band_widths(r, s, q, at);
	if (!detail && args->of != NULL)
		answer_drop_table_for_programs(r);
	screened_note_share(r, at);
	screened_put_fraction_fields(answer_json_fields(r), at);
	if (detail && correction_in_use(s, entry) == CORRECTION_ALL)
		answer_note(r, "%s", correction_in_words(s, entry));
	put_hyperparameter_fields(r, s, p, detail);
	note_draws_with_two_strengths(r, p, detail);
	note_effect_of_sampled_feeds(r, s, q, &of, at->speed);
	note_effect_of_speed_errors(r, s, q, p, at);
	note_convergence_of_posterior_draws(
	    r, p, trust_evidence_of_calibration(s, entry), detail);
	note_best_next_sample(r, s, q, &of);
	answers_note_basis_and_trust_at_speed(s, r, q, at->speed, false);
	return r;
}

/* Reads a speed, as in predict, and "draws" or "next", in any order. */
static bool
parse_uncertainty_operands(const struct args *args, struct question *q,
    bool *draws, bool *next, struct error *error)
{
	bool given = q->speed_given;
	for (size_t i = 0; i < args->n_operand; i++) {
		const char *word = args->operand[i];
		double v;
		bool number = value_parse_number(word, "m/s", &v) && v >= 1 &&
			      v <= SITE_FASTEST && !given;
		if (number) {
			q->speed = v;
			q->speed_given = true;
		} else if (strcmp(word, "draws") == 0 && !*draws)
			*draws = true;
		else if (strcmp(word, "next") == 0)
			*next = true;
		else
			return error_set(error, ERROR_USAGE,
			    "uncertainty: expected a speed, draws or next, got "
			    "'%s'\n"
			    "write: uncertainty 74",
			    word);
		given = given || number;
	}
	return true;
}

static bool
show_prediction_uncertainty(struct session *s, const struct args *args,
    const struct question *q, bool draws, struct error *error)
{
	if (!screened_check_feed_covers(q, error))
		return false;
	struct prediction at = forecast_product(s, q, q->speed);
	if (at.low == NULL) {
		prediction_free(&at);
		return band_set_error_missing(s, q->entry, error);
	}
	struct answer *r =
	    draws ? build_posterior_draws_answer(s, q,
			posterior_even_if_correction_off(s, q->entry), &at,
			(size_t)args->n)
		  : build_uncertainty_answer(s, q, &at, args, error);
	prediction_free(&at);
	return r != NULL && session_show_answer(s, r);
}

bool
cmd_uncertainty(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	bool draws = false, next = false;
	if (!parse_uncertainty_operands(args, q, &draws, &next, error))
		return false;
	question_use_last_speed_and_feed(s, args, q);
	const struct settings was = s->set;
	if (args_is_given(args, &args->probability))
		s->set.level = args->probability;
	if (args_is_given(args, &args->noise))
		s->set.noise = args->noise;
	if (args_is_given(args, &args->speed_sd))
		s->set.speed_sd = args->speed_sd;
	q->level = settings_band_probability(&s->set);
	bool ok = next ? cmd_advise(s, args, q, error)
		       : show_prediction_uncertainty(s, args, q, draws, error);
	if (!ok)
		s->set = was;
	return ok;
}
