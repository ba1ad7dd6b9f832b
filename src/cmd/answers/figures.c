/* figures: single numbers that describe a product: sizes, moduli, shares of
 * fractions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/answers/predict.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/question.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/trust_light.h"
#include "cmd/lang/table.h"
#include "core/psd/rotor_speed.h"

/* The figures shown by default.  Those that the feed does not cover are left
 * out. */
#define USUAL "P10,P20,P50,P80,P90,cu,cc,fines,fm EN,fm ASTM,fm IS,fm DIN,fm GB"

/* Adds a row for each quantity and, unless list is NULL, an object.  model:
 * adds columns for the figure by the model alone and the speed, for which only
 * the table for programs has room. */
static void
add_quantity_rows(struct answer *r, struct fields *list, struct forecast *all,
    const struct quantity *q, size_t n, double speed, bool model)
{
	bool band = n > 0 && forecast_draws_of_quantity(all, 0) != NULL;
	answer_add_columns(r, "quantity: figure, value, unit");
	if (band)
		answer_add_columns(r, "low, high");
	if (band && model)
		answer_add_column(r, "model", "model");
	if (model)
		answer_add_column(r, "speed", "m/s");
	for (size_t i = 0; i < n; i++) {
		struct figure f = forecast_value_in_shown_unit(all, i);
		int decimals = quantities_decimals(&q[i]);
		const char *unit = quantities_unit(&q[i]);
		FREED char *words = quantities_name(&q[i]);
		FREED char *key = quantities_field_name(&q[i]);
		answer_add_keyed_cell(r, key, words);
		answer_add_cells(r, "%.*f %s", decimals, f.value, unit);
		if (band)
			answer_add_cells(
			    r, "%.*f %.*f", decimals, f.low, decimals, f.high);
		if (band && model)
			answer_add_cells(r, "%g",
			    quantities_value_in_shown_unit(
				&q[i], forecast_value_of_model_alone(all, i)));
		if (model)
			answer_add_cells(r, "%g", speed);
		if (list != NULL)
			fields_put_values(fields_add_object(list, NULL),
			    "quantity %s value %g unit %s low %g high %g", key,
			    f.value, unit, f.low, f.high);
	}
}

/* Notes the range in which a new belt cut may show each quantity. */
static void
note_ranges_of_new_cut(struct answer *r, const struct session *s,
    const struct question *question, const struct quantity *q, size_t n)
{
	struct forecast *f = forecast_open(s, question, q, n);
	FREED char *list = xstrdup("");
	FREED char *chance = predict_probability_text(question->level);
	forecast_set_speed_and_ensemble(f, question->speed, ENSEMBLE_SAMPLE);
	for (size_t i = 0; i < n; i++) {
		struct figure sample = forecast_value_in_shown_unit(f, i);
		int decimals = quantities_decimals(&q[i]);
		FREED char *words = quantities_name(&q[i]);
		if (isfinite(sample.low) && isfinite(sample.high))
			xappend_to_list(&list, ", ", tr("%s %.*f to %.*f%s"),
			    words, decimals, sample.low, decimals, sample.high,
			    quantities_unit_suffix(&q[i]));
	}
	forecast_close(f);
	if (list[0] != '\0')
		answer_note(r, "a new belt cut, %s: %s", chance, list);
}

bool
cmd_figures(struct session *s, const struct args *args,
    struct question *question, struct error *error)
{
	const struct entry *entry = question->entry;
	question_use_last_speed(s, question);
	double v = question->speed;
	bool named = args->of != NULL;
	size_t n;
	FREED struct quantity *q =
	    quantities_parse_list_for_feed(named ? args->of : USUAL,
		&question->fraction, question_feed(question), named, &n, error);
	if (q == NULL)
		return false;
	struct forecast *all = forecast_open(s, question, q, n);
	forecast_set_speed(all, v);
	session_set_last_question(s, v, named ? &q[0] : NULL);
	bool band = n > 0 && forecast_draws_of_quantity(all, 0) != NULL;
	FREED char *rpm = rotor_speed_rpm_text(entry->site->rotor, v, NAN);
	struct answer *r = answer_new_about_site(entry->site, "figures",
	    "figures of the product at %.4g m/s%s", v, rpm);
	fields_put_values(answer_json_fields(r), "speed %g extrapolated %d", v,
	    answers_is_speed_extrapolated(entry, v));
	add_quantity_rows(r, fields_add_list(answer_json_fields(r), "figures"),
	    all, q, n, v, false);
	answer_begin_table_for_programs(r);
	add_quantity_rows(r, NULL, all, q, n, v, true);
	struct trust trust = trust_at_speed(s, entry, v, question->feed);
	FREED char *sure = NULL;
	if (named && n == 1)
		sure = predict_certainty_text(s, question, q, v, trust.light);
	if (named && n > 1)
		note_ranges_of_new_cut(r, s, question, q, n);
	if (sure != NULL) {
		answer_note(r, "%s", sure);
		band = !entry->has_fit;
	}
	answers_note_basis_and_trust(s, r, question, v, band, trust);
	forecast_close(all);
	return session_show_answer(s, r);
}
