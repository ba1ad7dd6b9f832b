/* validate: the model against runs it has not seen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cmd/answers.h"
#include "cmd/fit.h"
#include "cmd/table.h"
#include "core/validate.h"
#include "io/units.h"

static void
put_validation(struct fields *o, const struct validation *v)
{
	static const char *const NAMES[3] = {"p20", "p50", "p80"};
	fields_put(o, "speed %g rmse_pct %g", v->speed, 100 * v->rmse);
	for (size_t i = 0; i < 3; i++)
		fields_put(fields_object(o, NAMES[i]),
		    "measured_mm %g predicted_mm %g",
		    1000 * v->size[i].measured, 1000 * v->size[i].predicted);
	fields_put(fields_object(o, "null"),
	    "feed_rmse_pct %g interpolation_rmse_pct %g", 100 * v->feed_rmse,
	    100 * v->interpolation_rmse);
	fields_put(o, "loses_to_interpolation %d", validation_loses(v));
}

static void
validation_rows(struct answer *r, const struct validation *v)
{
	for (size_t i = 0; i < 3; i++) {
		const struct validate_size *size = &v->size[i];
		answer_cells(r, "%g", v->speed);
		answer_text(r, "P%.0f", 100 * size->passing);
		answer_missing(r, "outside");
		answer_cells(r, "%.3f %.3f %.3f", 1000 * size->measured,
		    1000 * size->predicted,
		    1000 * (size->predicted - size->measured));
	}
}

/* A difference of RMSE, passing 0..1, that sampling could tell. */
static const double CLEARLY = 0.001;

/* RMSE of the other sieves than the worst, passing 0..1. */
static double
rest(const struct validation *v)
{
	double n = (double)v->n_sieve;
	double square =
	    n * v->rmse * v->rmse - v->worst_difference * v->worst_difference;
	return sqrt(fmax(square, 0) / (n - 1));
}

/* The worst sieve is far beyond the others and beyond sampling: rather a slip
 * of the pen than a fault of the model, which errs on several sieves. */
static bool
stands_out(const struct validation *v)
{
	const double times = 4, least = 0.03;
	double worst = fabs(v->worst_difference);
	return v->n_sieve > 3 && worst > least && worst > times * rest(v);
}

static void
validation_notes(struct answer *r, const struct validation *v)
{
	answer_note(r,
	    "at %g m/s: RMSE %.2f points over %zu sieves, misfit %.4g; largest "
	    "error %+.2f points at %g mm (predicted - measured)",
	    v->speed, 100 * v->rmse, v->n_sieve, v->misfit,
	    100 * v->worst_difference, units_mm(v->worst_sieve));
	if (isfinite(v->interpolation_rmse))
		answer_note(r,
		    "  RMSE without the model: feed unchanged %.2f points; "
		    "training products interpolated %.2f points",
		    100 * v->feed_rmse, 100 * v->interpolation_rmse);
	else
		answer_note(r,
		    "  RMSE without the model: feed unchanged %.2f points; no "
		    "two training products to interpolate on these sieves",
		    100 * v->feed_rmse);
	if (stands_out(v))
		answer_say(r, ANSWER_REMARK,
		    "  %g mm stands out (RMSE of the other sieves: %.2f "
		    "points): check that cell",
		    units_mm(v->worst_sieve), 100 * rest(v));
	bool loses = validation_loses(v);
	bool clearly = loses && v->rmse > 1.1 * v->interpolation_rmse &&
		       v->rmse - v->interpolation_rmse > CLEARLY;
	if (clearly)
		answer_say(r, ANSWER_WARNING,
		    "at %g m/s the model predicts worse than interpolation: "
		    "between the training speeds, prefer the interpolated "
		    "products",
		    v->speed);
	else if (loses)
		answer_say(r, ANSWER_REMARK,
		    "  the model predicts no better than interpolation at this "
		    "speed; the difference is too small for sampling to show");
	if (v->n_left_out > 0)
		answer_say(r, ANSWER_REMARK,
		    "  %zu finer sieves are not compared: the feed was not "
		    "sieved so fine",
		    v->n_left_out);
}

static void
add_validations(struct session *s, struct answer *r)
{
	struct fields *list = fields_list(answer_fields(r), "holdout");
	const struct entry *entry = session_entry(s);
	const struct site *site = entry->site;
	size_t n = 0;
	for (size_t i = 0; i < site->n_run; i++) {
		const struct run *run = &site->run[i];
		if (entry->train[i] || misfit_covered(run) == 0)
			continue;
		struct validation v = validate_run(
		    site, i, entry->train, &entry->params, s->set.model);
		validation_rows(r, &v);
		validation_notes(r, &v);
		put_validation(fields_object(list, NULL), &v);
		n++;
	}
	if (n == 0)
		answer_say(r, ANSWER_REMARK,
		    "no run was held out; measure another speed to test the "
		    "model");
}

bool
cmd_validate(struct session *s, const struct args *args, struct error *error)
{
	(void)args;
	if (!answers_ready(s, error))
		return false;
	const struct entry *entry = session_entry(s);
	struct answer *r = answers_new(
	    entry->site, "validate", "held-out speeds, measured and predicted");
	answer_columns(r,
	    "speed: m/s, size, measured_mm: measured mm, "
	    "predicted_mm: predicted mm, difference_mm: difference mm");
	add_validations(s, r);
	origin_note(r, entry);
	if (entry->has_fit)
		fields_put(
		    answer_fields(r), "verdict %s", fit_verdict(&entry->fit));
	answers_note_worth(s, r, entry);
	return session_answer(s, r);
}
