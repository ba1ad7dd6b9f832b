/* predict: the product at a speed, and how far to trust it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/answers/predict.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/cut.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/question.h"
#include "cmd/draw/plot.h"
#include "cmd/draw/plots.h"
#include "cmd/ask/screened.h"
#include "cmd/lang/table.h"
#include "cmd/session/invocation.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/moved.h"
#include "cmd/ask/trust_light.h"
#include "core/answer/predict.h"
#include "core/check/validate.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

#include "config.h"

/* Says in a sentence which sizes break at this speed. */
static void
note_breaking_sizes(
    struct answer *r, const struct question *q, const struct prediction *p)
{
	double top = question_feed(q)->size[0];
	FREED char *rpm =
	    rotor_speed_rpm_text(q->entry->site->rotor, p->speed, NAN);
	if (p->no_daughters)
		answer_note(r,
		    "the appearance function gives no progeny: feed unchanged");
	else if (p->break_size >= top)
		answer_note(r,
		    p->low != NULL
			? N_("by the fit nothing breaks at %.*f m/s%s: only "
			     "particles of %.3g mm or more would, and the feed "
			     "has none above %g mm")
			: N_("nothing breaks at %.*f m/s%s: only particles of "
			     "%.3g mm or more would, and the feed has none "
			     "above %g mm: feed unchanged"),
		    units_speed_decimals(p->speed), p->speed, rpm,
		    1000 * p->break_size, units_m_to_mm(top));
	else if (params_value_by_name(q->params, "e0_min") <= 0)
		answer_note(r,
		    "all sizes can break (e0_min is 0: no threshold); %.1f %% "
		    "of the feed breaks",
		    100 * p->selected);
	else if (p->break_size < ANSWERS_NO_SIZE)
		answer_note(r,
		    "all sizes can break (alpha is %.2g: size hardly matters); "
		    "%.1f %% of the feed breaks",
		    params_value_by_name(q->params, "alpha"),
		    100 * p->selected);
	else if (isfinite(p->range[PSD_SIZES][0]) && p->break_size >= 1e-4)
		answer_note(r,
		    "break size %.2f mm by the fit, %.2f to %.2f mm in %.0f %% "
		    "of the draws (nothing finer breaks); %.1f %% of the feed "
		    "breaks",
		    1000 * p->break_size, 1000 * p->range[PSD_SIZES][0],
		    1000 * p->range[PSD_SIZES][1], 100 * q->level,
		    100 * p->selected);
	else
		answer_note(r,
		    p->break_size < 1e-4 ? N_("break size %.3g mm (nothing "
					      "finer breaks); %.1f %% "
					      "of the feed breaks")
					 : N_("break size %.2f mm (nothing "
					      "finer breaks); %.1f %% "
					      "of the feed breaks"),
		    1000 * p->break_size, 100 * p->selected);
}

/* Names the sieves on which the feed was not measured. */
static void
note_sieves_missing_in_feed(
    struct answer *r, const struct psd *feed, const struct prediction *p)
{
	FREED char *list = xstrdup("");
	for (size_t i = 0; i < p->feed.n; i++)
		/* All of the feed is known to pass what is coarser. */
		if (p->feed.size[i] < feed->size[0] &&
		    isnan(psd_passing_at_sieve(feed, p->feed.size[i])))
			xappend_to_list(
			    &list, ", ", "%g", units_m_to_mm(p->feed.size[i]));
	if (list[0] != '\0')
		answer_add_sentence(r, ANSWER_REMARK,
		    "the feed was not sieved at %s mm: its passing there is "
		    "interpolated",
		    list);
}

static void
note_wide_sieve_gap_in_feed(struct answer *r, const struct psd *feed)
{
	size_t i = psd_sieve_above_widest_gap(feed);
	if (i < feed->n)
		answer_add_sentence(r, ANSWER_REMARK,
		    "the feed has no sieve between %g and %g mm: passings and "
		    "sizes there rest on a straight line",
		    units_m_to_mm(feed->size[i]),
		    units_m_to_mm(feed->size[i + 1]));
}

/* Returns the passing at each sieve of p, interpolated in speed squared between
 * measured products that were moved to the feed.  Returns NULL if the question
 * changes the feed or the machine, or if the speed is not between measured
 * ones.  The caller frees it. */
static double *
interpolate_measured_products(const struct session *s, const struct question *q,
    const struct prediction *p)
{
	if (q->entry->site->with[0] != '\0')
		return NULL;
	struct site *site = site_copy(q->entry->site);
	for (size_t r = 0; r < site->n_run; r++) {
		psd_free(&site->run[r].product);
		site->run[r].product = psd_copy(measured_product_moved_to_feed(
		    s, q->entry, q->params, r, q->feed));
	}
	FREED bool *measured = xcalloc(site->n_run, sizeof *measured);
	double *passing = NULL;
	for (size_t r = 0; r < site->n_run; r++)
		measured[r] = site->run[r].product.n > 0;
	if (!predict_is_extrapolation(site, measured, p->speed)) {
		passing = xcalloc_doubles(p->product.n);
		for (size_t i = 0; i < p->product.n; i++)
			passing[i] = validate_interpolate_passing(
			    site, measured, p->speed, p->product.size[i]);
	}
	site_free(site);
	return passing;
}

/* Returns the products measured at the speed, repeats included, moved to the
 * question's feed and screened to its fraction.  Sets *n to their number, which
 * is 0 if the question changes the feed or the machine.  The caller frees
 * them. */
static struct psd *
measured_products_at_speed(
    const struct session *s, const struct question *q, size_t *n)
{
	const struct site *site = q->entry->site;
	struct psd *part = xcalloc(site->n_run, sizeof *part);
	size_t first = site_run_at_speed(site, q->speed);
	*n = 0;
	for (size_t r = first; site->with[0] == '\0' && r < site->n_run &&
			       site->run[r].product.n > 0 &&
			       site->run[r].speed == site->run[first].speed;
	     r++)
		part[(*n)++] = screened_fraction_of_product(
		    measured_product_moved_to_feed(
			s, q->entry, q->params, r, q->feed),
		    &q->fraction);
	return part;
}

/* The smallest difference, passing 0..1, that shows in tenths of a per cent. */
static const double SHOWN_PASSING = 5e-4;

/* True if at sieve i the answer, or the low end of its band, comes down to the
 * passing of the feed. */
static bool
is_passing_limited_by_feed(
    const struct question *q, const struct prediction *p, size_t i)
{
	double fed = psd_passing_at_sieve(question_feed(q), p->product.size[i]);
	double least = p->low != NULL ? p->low[i] : p->product.passing[i];
	return fed > 0 && fed < 1 && least - fed < SHOWN_PASSING;
}

/* Adds a row for each sieve.  between: the interpolated products, or NULL.
 * model: name of the model, for the columns speed and model, which only files
 * have; NULL: without them.  alone: add the passings by the model alone. */
static void
add_prediction_sieve_rows(struct answer *r, const struct session *s,
    const struct question *q, const struct prediction *p, const double *between,
    const char *model, bool alone)
{
	size_t n;
	FREED struct psd *part = measured_products_at_speed(s, q, &n);
	FREED double *feed = screened_feed_passings(p);
	answer_add_columns(r,
	    "sieve_mm: sieve mm, feed_pct: feed %%, passing_pct: product %%");
	if (p->low != NULL)
		answer_add_columns(r, "low_pct: low %%, high_pct: high %%");
	if (p->low != NULL && alone)
		answer_add_columns(r, "model_pct: model alone %%");
	for (size_t k = 0; k < n; k++)
		if (n == 1)
			answer_add_columns(r, "measured_pct: measured %%");
		else
			answer_add_columns(r,
			    "measured_%zu_pct: measured (%zu) %%", k + 1,
			    k + 1);
	if (between != NULL)
		answer_add_columns(r, "interpolated_pct: interpolated %%");
	if (model != NULL)
		answer_add_columns(r, "speed, model");
	for (size_t i = 0; i < p->product.n; i++) {
		double x = p->product.size[i];
		answer_add_cells(r, "%g %.1f %.1f", units_m_to_mm(x),
		    units_fraction_to_pct(feed[i]),
		    units_fraction_to_pct(p->product.passing[i]));
		if (p->low != NULL)
			answer_add_cells(r, "%.1f %.1f",
			    units_fraction_to_pct(p->low[i]),
			    units_fraction_to_pct(p->high[i]));
		if (p->low != NULL && alone)
			answer_add_cells(
			    r, "%.1f", units_fraction_to_pct(p->model[i]));
		for (size_t k = 0; k < n; k++)
			answer_add_cells(r, "%.1f",
			    units_fraction_to_pct(
				psd_passing_at_sieve(&part[k], x)));
		if (between != NULL)
			answer_add_cells(
			    r, "%.1f", units_fraction_to_pct(between[i]));
		if (model != NULL)
			answer_add_cells(r, "%g %s", p->speed, model);
	}
	for (size_t k = 0; k < n; k++)
		psd_free(&part[k]);
}

static struct answer *
build_prediction_answer(const struct session *s, const struct question *q,
    const struct prediction *p, const double *between, bool detail)
{
	const struct site *site = q->entry->site;
	const char *model = breakage_model_of_params(q->params)->name;
	FREED char *fraction = screened_fraction_title_suffix(&p->fraction);
	FREED char *more =
	    detail ? xasprintf(tr(" (%.0f J/kg)"), p->energy) : xstrdup("");
	FREED char *band = !detail && p->low != NULL
			       ? xasprintf(tr(", %.0f %% band"),
				     100 * settings_band_probability(&s->set))
			       : xstrdup("");
	FREED char *rpm = rotor_speed_rpm_text(site->rotor, p->speed, NAN);
	struct answer *r = answer_new_about_site(site, "predict",
	    "product at %.*f m/s%s%s%s%s", units_speed_decimals(p->speed),
	    p->speed, rpm, more, fraction, band);
	/* In a table that is read aloud, the numbers of a sieve belong in one
	 * line. */
	if (!s->linear)
		answer_allow_transposed(r);
	add_prediction_sieve_rows(r, s, q, p, between, NULL, detail);
	answer_begin_table_for_programs(r);
	add_prediction_sieve_rows(r, s, q, p, between, model, true);
	return r;
}

/* Notes how well parameters from elsewhere match the only product of a site. */
static void
note_match_of_only_product(
    struct answer *r, const struct session *s, const struct entry *entry)
{
	size_t run;
	if (session_is_calibrating(s) ||
	    entry->site != entry_without_scenario(entry)->site ||
	    !cut_is_only_product(entry, &run))
		return;
	struct cut cut = cut_compare_with_prediction(s, entry, run);
	FREED char *words = cut_comparison_text(&cut);
	FREED char *rpm = rotor_speed_rpm_text(
	    entry->site->rotor, entry->site->run[run].speed, NAN);
	answer_add_sentence(r, cut.missed ? ANSWER_WARNING : ANSWER_PLAIN,
	    cut.missed ? N_("the prediction misses the cut at %g m/s%s, the "
			    "only product of this site: %s")
		       : N_("the prediction matches the cut at %g m/s%s, the "
			    "only product of this site: %s"),
	    entry->site->run[run].speed, rpm, words);
	fields_put_values(fields_add_object(answer_json_fields(r), "cut"),
	    "speed %g rms_pct %g sieves %zu", entry->site->run[run].speed,
	    100 * cut.rms, cut.n);
}

/* Lists passings measured at the speed that lie below a band which cannot go
 * lower because of the feed: "44.7 % at 2 mm, 11.1 % at 0.5 mm", at most MOST;
 * "" if there are none.  The caller frees it. */
static char *
measured_below_band_text(const struct session *s, const struct question *q,
    const struct prediction *p)
{
	enum { MOST = 3 };
	size_t n, found = 0;
	FREED struct psd *part = measured_products_at_speed(s, q, &n);
	char *list = xstrdup("");
	for (size_t i = 0; i < p->product.n && p->low != NULL; i++)
		for (size_t k = 0; k < n; k++) {
			double x = p->product.size[i];
			double own = psd_passing_at_sieve(&part[k], x);
			if (is_passing_limited_by_feed(q, p, i) &&
			    own < p->low[i] - SHOWN_PASSING && found++ < MOST)
				xappend_to_list(&list, ", ",
				    tr("%.1f %% at %g mm"),
				    units_fraction_to_pct(own),
				    units_m_to_mm(x));
		}
	for (size_t k = 0; k < n; k++)
		psd_free(&part[k]);
	if (found > MOST)
		xappend(&list, "%s", tr(", among others"));
	return list;
}

/* Names the sieves where a measured product passes clearly less than its feed,
 * and where the answer or its band comes down to the feed.  Breakage cannot
 * bring it any lower. */
static void
note_sieves_limited_by_feed(struct answer *r, const struct session *s,
    const struct question *q, const struct prediction *p)
{
	const struct site *site = q->entry->site;
	FREED char *list = xstrdup("");
	for (size_t i = 0; i < p->product.n; i++) {
		double x = p->product.size[i];
		double least = INFINITY;
		for (size_t k = 0; k < site->n_run; k++)
			least = fmin(least,
			    psd_passing_at_sieve(&site->run[k].product, x) -
				psd_passing_at_sieve(&site->run[k].feed, x));
		if (is_passing_limited_by_feed(q, p, i) &&
		    least < -SHOWN_PASSING)
			xappend_to_list(&list, ", ", "%g", units_m_to_mm(x));
	}
	if (list[0] == '\0' || fraction_is_screened(&p->fraction))
		return;
	FREED char *below = measured_below_band_text(s, q, p);
	answer_add_sentence(r, ANSWER_REMARK,
	    p->low != NULL
		? N_("at %s mm more feed passes than measured product, which "
		     "crushing cannot cause: there answer and band do not go "
		     "below the feed; sample the feed again")
		: N_("at %s mm more feed passes than measured product, which "
		     "crushing cannot cause: there the answer is the feed; "
		     "sample the feed again"),
	    list);
	if (below[0] != '\0')
		answer_add_sentence(r, ANSWER_REMARK,
		    "measured at this speed, below the band: %s", below);
}

char *
predict_probability_text(double level)
{
	double tenths = 10 * level;
	return fabs(tenths - round(tenths)) < 1e-9
		   ? xasprintf(tr("%.0f times in 10"), tenths)
		   : xasprintf(tr("with %g %% probability"), 100 * level);
}

bool
predict_value_range_over_feeds(const struct session *s,
    const struct question *q, const struct quantity *of, double from,
    double speed, double range[static 2])
{
	const struct site *site = q->entry->site;
	bool other = site_run_at_speed(site, SITE_OTHER_FEED) < site->n_run;
	size_t n = site->individual_feeds && !other ? site->n_run : 0;
	range[0] = INFINITY;
	range[1] = -INFINITY;
	for (size_t run = 0; run < n; run++) {
		struct question own = *q;
		if (site->run[run].lacks_feed)
			continue;
		own.feed = run;
		double value = forecast_quantity_at_speed(s, &own, of, speed);
		if (!isnan(from))
			value -= forecast_quantity_at_speed(s, &own, of, from);
		range[0] = fmin(range[0], value);
		range[1] = fmax(range[1], value);
	}
	return range[0] <= range[1];
}

double
predict_largest_change_by_feed(const struct session *s,
    const struct question *q, const struct quantity *of, double speed)
{
	double range[2];
	if (!predict_value_range_over_feeds(s, q, of, NAN, speed, range))
		return 0;
	double value = forecast_quantity_at_speed(s, q, of, speed);
	return fmax(fabs(range[0] - value), fabs(range[1] - value));
}

/* Appends the range of the quantity over the sampled feeds, used one at a time
 * instead of their mean, if the last digit shown changes. */
static void
append_range_over_sampled_feeds(const struct session *s,
    const struct question *q, const struct quantity *of, double speed,
    double value, char **words)
{
	int decimals = quantities_decimals(of);
	double range[2];
	if (!predict_value_range_over_feeds(s, q, of, NAN, speed, range))
		return;
	double most = fmax(value - range[0], range[1] - value);
	if (!(quantities_value_in_shown_unit(of, most) >=
		0.5 * pow(10, -decimals)))
		return;
	xappend(words,
	    tr("; with each sampled feed instead of their mean from %.*f to "
	       "%.*f"),
	    decimals, quantities_value_in_shown_unit(of, range[0]), decimals,
	    quantities_value_in_shown_unit(of, range[1]));
}

/* Appends the value measured at the speed, if any, and whether it lies in the
 * range for a belt cut. */
static void
append_whether_measured_in_range(const struct session *s,
    const struct question *q, const struct quantity *of,
    const struct figure *range, double speed, char **words)
{
	double moved = 0;
	size_t n;
	double measured = measured_mean_quantity_at_speed(
	    s, q->entry, q->feed, of, speed, &moved, &n);
	if (isnan(measured))
		return;
	FREED char *mean =
	    n > 1 ? xasprintf(tr(", the mean of %zu runs"), n) : xstrdup("");
	bool within = measured >= range->low && measured <= range->high;
	xappend(words,
	    within ? tr(" (measured: %.*f%s, within it)")
		   : tr(" (measured: %.*f%s, outside it)"),
	    quantities_decimals(of), measured, mean);
}

char *
predict_certainty_text(const struct session *s, const struct question *q,
    const struct quantity *of, double speed, enum light light)
{
	int decimals = quantities_decimals(of);
	struct forecast *f = forecast_open(s, q, of, 1);
	forecast_set_speed(f, speed);
	struct figure answer = forecast_value_in_shown_unit(f, 0);
	double value = forecast_value_with_band(f, 0).value;
	forecast_set_speed_and_ensemble(f, speed, ENSEMBLE_SAMPLE);
	struct figure sample = forecast_value_in_shown_unit(f, 0);
	forecast_close(f);
	if (isnan(value) || isnan(answer.low) || isnan(sample.low))
		return NULL;
	/* What the band allows for is not all that can be wrong where the light
	 * is red. */
	FREED char *often = predict_probability_text(q->level);
	FREED char *chance = xasprintf(
	    light == LIGHT_RED ? tr("if the model holds, %s") : "%s", often);
	FREED char *said = quantities_sentence_with_value(of, value);
	FREED char *rpm =
	    rotor_speed_rpm_text(q->entry->site->rotor, speed, NAN);
	char *words = xasprintf(
	    tr("at %.*f m/s%s %s: %s between %.*f and %.*f; a new belt cut "
	       "between %.*f and %.*f"),
	    units_speed_decimals(speed), speed, rpm, said, chance, decimals,
	    answer.low, decimals, answer.high, decimals, sample.low, decimals,
	    sample.high);
	append_whether_measured_in_range(s, q, of, &sample, speed, &words);
	if (q->feed == SITE_MEAN_FEED)
		append_range_over_sampled_feeds(s, q, of, speed, value, &words);
	return words;
}

/* For a user at the prompt, appends the command that asks about the next sieve,
 * because the rows of the table have no range for a belt cut. */
static void
append_command_for_other_sieve(const struct session *s,
    const struct question *q, const struct prediction *p, char **words)
{
	size_t said = answers_default_sieve(&p->product);
	size_t other = said > 0 ? said - 1 : said + 1;
	if (!s->prompt || s->scripts > s->typed_depth || other >= p->product.n)
		return;
	FREED char *speed = speed_text_in_typed_unit(q->entry->site, p->speed);
	xappend(words, tr("; another sieve: predict %s passing %g"), speed,
	    units_m_to_mm(p->product.size[other]));
}

static void
note_certainty_of_passing(struct answer *r, const struct session *s,
    const struct question *q, const struct prediction *p, enum light light)
{
	const struct quantity of =
	    answers_default_passing_quantity(&p->product);
	if (p->low == NULL || fraction_is_screened(&p->fraction))
		return;
	FREED char *words = predict_certainty_text(s, q, &of, p->speed, light);
	if (words == NULL)
		return;
	append_command_for_other_sieve(s, q, p, &words);
	answer_note(r, "%s", words);
}

/* Returns the most by which the measured products shown beside the answer were
 * moved to its feed, passing 0..1, or 0 if that is too little to show. */
static double
largest_shown_change_by_feed_move(const struct session *s,
    const struct question *q, const struct prediction *p, bool between)
{
	const struct site *site = q->entry->site;
	double most = 0;
	for (size_t k = 0; k < site->n_run; k++)
		if (between || fabs(site->run[k].speed - p->speed) <= 1e-3)
			most = fmax(
			    most, largest_change_by_moving_to_feed(
				      s, q->entry, q->params, k, p->feed_run));
	return most > SHOWN_PASSING ? most : 0;
}

/* Puts what is set for the draws, with which the answer can be had again. */
static void
put_posterior_settings(
    struct fields *o, const struct session *s, const struct entry *entry)
{
	fields_put_values(o,
	    "correction %s speed_sd_pct %g draw_seed %zu version %s",
	    correction_name(s, entry), s->set.speed_sd,
	    (size_t)s->set.draw_seed, PACKAGE_VERSION);
}

/* Builds the answer with all notes.  wanted: the user asked for the
 * interpolated products. */
static struct answer *
build_prediction_with_notes(const struct session *s, const struct question *q,
    const struct prediction *p, bool wanted, bool detail)
{
	const struct entry *entry = q->entry;
	FREED double *between =
	    wanted ? interpolate_measured_products(s, q, p) : NULL;
	struct answer *r = build_prediction_answer(s, q, p, between, detail);
	struct fields *o = answer_json_fields(r);
	answers_put_prediction_fields(s, o, entry, q->params, p);
	put_posterior_settings(o, s, entry);
	struct trust trust = trust_at_speed(s, entry, p->speed, q->feed);
	note_certainty_of_passing(r, s, q, p, trust.light);
	screened_note_share(r, p);
	answers_note_p_sizes(r, p);
	if (p->low != NULL) {
		answer_add_columns_to_json_fields(r, "low_pct high_pct");
		answers_put_p_size_bands(o, s, p);
	}
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, p->speed, NAN);
	if (detail || p->no_daughters || p->break_size >= p->feed.size[0])
		note_breaking_sizes(r, q, p);
	note_sieves_limited_by_feed(r, s, q, p);
	note_sieves_missing_in_feed(r, question_feed(q), p);
	note_wide_sieve_gap_in_feed(r, question_feed(q));
	if (session_entry_being_fitted(s) == entry_without_scenario(entry))
		answer_add_sentence(r, ANSWER_REMARK,
		    "predicted with the best parameters so far");
	if (between != NULL)
		answer_add_columns_to_json_fields(r, "interpolated_pct");
	else if (wanted)
		answer_add_sentence(r, ANSWER_REMARK,
		    entry->site->with[0] != '\0'
			? N_("no interpolation: at %g m/s%s nothing was "
			     "measured with this feed and machine")
			: N_("no interpolation: %g m/s%s is not between "
			     "measured runs"),
		    p->speed, rpm);
	note_match_of_only_product(r, s, entry);
	struct question at = *q;
	at.moved = largest_shown_change_by_feed_move(s, q, p, between != NULL);
	answers_note_basis_and_trust(s, r, &at, p->speed,
	    p->low != NULL && (detail || !entry->has_fit), trust);
	return r;
}

/* Draws the psd plot of the prediction: with its band if an image is wanted,
 * otherwise as plain text. */
static bool
draw_prediction_curves(struct session *s, const struct question *q,
    const struct prediction *p, struct error *error)
{
	enum { WIDTH = 78, HEIGHT = 24 };
	struct plot_request request = plots_default_request(PLOT_PSD);
	request.asked = *q;
	request.asked.speed = p->speed;
	request.band = plot_is_image_wanted(s) && p->low != NULL;
	if (!plot_is_image_wanted(s))
		request.strip = 0;
	struct chart *chart = plots_make_chart(s, &request, error);
	if (chart == NULL)
		return false;
	if (plot_is_image_wanted(s))
		return plot_write_image(s, chart, error);
	struct canvas *canvas =
	    chart_draw(chart, WIDTH, HEIGHT, request.charset, request.words);
	fputc('\n', s->out);
	canvas_print(canvas, 0, s->out);
	canvas_free(canvas);
	chart_free(chart);
	return true;
}

/* Sets *params to the site's parameters or, during its calibration, to the best
 * so far. */
static bool
find_params_to_predict(const struct session *s, const struct entry *entry,
    struct params *params, struct error *error)
{
	*params = entry->params;
	return answers_best_params_so_far(s, entry, params) ||
	       answers_require_params(s, entry, error);
}

bool
predict_at_screen_speed(struct session *s, const struct entry *entry,
    double speed, size_t feed_run, const char *line, struct prediction *p,
    struct error *error)
{
	struct params params;
	if (!find_params_to_predict(s, entry, &params, error))
		return false;
	struct question q = question_of_whole_product(s, entry, feed_run);
	q.params = &params;
	*p = forecast_product(s, &q, speed);
	answers_store_newest_prediction(s, entry, &params, p);
	invocation_journal_prediction(s, line);
	return true;
}

bool
cmd_predict(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	const struct entry *entry = q->entry;
	struct params params;
	question_use_last_speed(s, q);
	if (!find_params_to_predict(s, entry, &params, error))
		return false;
	if (args->interpolated && fraction_is_screened(&q->fraction))
		return error_set(error, ERROR_USAGE,
		    "interpolated= shows the whole product, not a fraction\n"
		    "leave out cut=, or write plot response");
	if (!screened_check_feed_covers(q, error))
		return false;
	struct question at = *q;
	at.params = &params;
	struct prediction p = forecast_product(s, &at, at.speed);
	session_set_last_question(s, p.speed, NULL);
	if (!args->band)
		prediction_remove_band(&p);
	struct answer *r = build_prediction_with_notes(
	    s, &at, &p, args->interpolated, args->detail);
	if (args_is_given(args, &args->band) && args->band && p.low == NULL)
		answer_note(r, "%s", band_why_missing(s, entry));
	bool picture = plot_is_image_wanted(s) && s->document == NULL;
	bool curve = args->curve && s->set.format == ANSWER_TABLE;
	if (picture)
		session_store_newest_answer(s, r);
	else
		session_show_answer(s, r);
	bool ok =
	    (!picture && !curve) || draw_prediction_curves(s, &at, &p, error);
	prediction_free(&p);
	return ok;
}
