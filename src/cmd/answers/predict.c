/* predict: the product at a speed, and how far to trust it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/answers/predict.h"

#include <math.h>
#include <stdlib.h>

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
#include "cmd/ask/feed.h"
#include "cmd/ask/moved.h"
#include "core/answer/predict.h"
#include "core/check/validate.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

/* Says in a sentence which sizes break at this speed. */
static void
note_breakage(struct answer *r, const struct params *params,
    const struct psd *feed, const struct prediction *p)
{
	double top = feed->size[0];
	if (p->no_daughters)
		answer_note(r,
		    "the appearance function gives no progeny: feed unchanged");
	else if (p->break_size >= top)
		answer_note(r,
		    "nothing breaks at %.*f m/s: only particles of %.3g mm or "
		    "more would, and the feed has none above %g mm: feed "
		    "unchanged",
		    units_speed_digits(p->speed), p->speed,
		    1000 * p->break_size, units_mm(top));
	else if (params_value(params, "e0_min") <= 0)
		answer_note(r,
		    "all sizes can break (e0_min is 0: no threshold); %.1f %% "
		    "of the feed breaks",
		    100 * p->selected);
	else if (p->break_size < ANSWERS_NO_SIZE)
		answer_note(r,
		    "all sizes can break (alpha is %.2g: size hardly matters); "
		    "%.1f %% of the feed breaks",
		    params_value(params, "alpha"), 100 * p->selected);
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

/* Names the sieves that the feed was not sieved on. */
static void
note_feed_gaps(
    struct answer *r, const struct site *site, const struct prediction *p)
{
	const struct psd *feed = site_feed(site, p->feed_run);
	FREED char *list = xstrdup("");
	for (size_t i = 0; i < p->feed.n; i++)
		if (isnan(psd_at_sieve(feed, p->feed.size[i])))
			xlist(&list, ", ", "%g", units_mm(p->feed.size[i]));
	if (list[0] != '\0')
		answer_say(r, ANSWER_REMARK,
		    "the feed was not sieved at %s mm: its passing there is "
		    "interpolated",
		    list);
}

static void
note_wide_gap(struct answer *r, const struct psd *feed)
{
	size_t i = psd_sieve_above_widest_gap(feed);
	if (i < feed->n)
		answer_say(r, ANSWER_REMARK,
		    "the feed has no sieve between %g and %g mm: passings and "
		    "sizes there rest on a straight line",
		    units_mm(feed->size[i]), units_mm(feed->size[i + 1]));
}

/* Returns the measured products, moved to the feed and interpolated in speed
 * squared at each sieve [n].  NULL unless measured runs with this feed and
 * machine lie on both sides of the speed. */
static double *
interpolate_measured(const struct session *s, const struct entry *entry,
    const struct params *params, const struct prediction *p)
{
	if (entry->site->with[0] != '\0')
		return NULL;
	struct site *site = site_copy(entry->site);
	for (size_t r = 0; r < site->n_run; r++) {
		psd_free(&site->run[r].product);
		site->run[r].product =
		    psd_copy(moved_product(s, entry, params, r, p->feed_run));
	}
	FREED bool *measured = xcalloc(site->n_run, sizeof *measured);
	double *passing = NULL;
	for (size_t r = 0; r < site->n_run; r++)
		measured[r] = site->run[r].product.n > 0;
	if (!predict_extrapolates(site, measured, p->speed)) {
		passing = xdoubles(p->product.n);
		for (size_t i = 0; i < p->product.n; i++)
			passing[i] = validate_interpolation(
			    site, measured, p->speed, p->product.size[i]);
	}
	site_free(site);
	return passing;
}

/* Returns how many runs have a product at a speed, repeats included, and sets
 * *first to the first of them.  With another feed or machine there are none. */
static size_t
predict_measured_at(
    const struct site *site, double speed, const struct run **first)
{
	size_t from = site_run_at(site, speed), n = 0;
	*first = &site->run[from];
	while (site->with[0] == '\0' && from + n < site->n_run &&
	       (*first)[n].product.n > 0 &&
	       (*first)[n].speed == (*first)[0].speed)
		n++;
	return n;
}

/* Returns the measured products of the runs [n] for the feed and the fraction
 * asked about.  The caller frees them. */
static struct psd *
measured_parts(const struct session *s, const struct entry *entry,
    const struct params *params, const struct run *run, size_t n,
    const struct prediction *p)
{
	size_t first = (size_t)(run - entry->site->run);
	struct psd *part = xcalloc(n, sizeof *part);
	for (size_t k = 0; k < n; k++)
		part[k] = screened_measured(
		    moved_product(s, entry, params, first + k, p->feed_run),
		    &p->fraction);
	return part;
}

/* Adds a row for each sieve.  between: the interpolated products, or NULL.
 * model: NULL, or the model for a column of its own, beside one for the speed,
 * as files want them.  alone: adds the passings by the model alone. */
static void
predict_add_rows(struct answer *r, const struct session *s,
    const struct entry *entry, const struct params *params,
    const struct prediction *p, const double *between, const char *model,
    bool alone)
{
	const struct run *run;
	size_t n = predict_measured_at(entry->site, p->speed, &run);
	FREED struct psd *part = measured_parts(s, entry, params, run, n, p);
	answer_columns(r,
	    "sieve_mm: sieve mm, feed_pct: feed %%, passing_pct: product %%");
	if (p->low != NULL)
		answer_columns(r, "low_pct: low %%, high_pct: high %%");
	if (p->low != NULL && alone)
		answer_columns(r, "model_pct: model alone %%");
	for (size_t k = 0; k < n; k++)
		if (n == 1)
			answer_columns(r, "measured_pct: measured %%");
		else
			answer_columns(r, "measured_%zu_pct: measured (%zu) %%",
			    k + 1, k + 1);
	if (between != NULL)
		answer_columns(r, "interpolated_pct: interpolated %%");
	if (model != NULL)
		answer_columns(r, "speed, model");
	for (size_t i = 0; i < p->product.n; i++) {
		double x = p->product.size[i];
		answer_cells(r, "%g %.1f %.1f", units_mm(x),
		    units_pct(p->feed.passing[i]),
		    units_pct(p->product.passing[i]));
		if (p->low != NULL)
			answer_cells(r, "%.1f %.1f", units_pct(p->low[i]),
			    units_pct(p->high[i]));
		if (p->low != NULL && alone)
			answer_cells(r, "%.1f", units_pct(p->model[i]));
		for (size_t k = 0; k < n; k++)
			answer_cells(
			    r, "%.1f", units_pct(psd_at_sieve(&part[k], x)));
		if (between != NULL)
			answer_cells(r, "%.1f", units_pct(between[i]));
		if (model != NULL)
			answer_cells(r, "%g %s", p->speed, model);
	}
	for (size_t k = 0; k < n; k++)
		psd_free(&part[k]);
}

static struct answer *
prediction_answer(const struct session *s, const struct entry *entry,
    const struct prediction *p, const struct params *params,
    const double *between, bool detail)
{
	const char *model = breakage_of(params)->name;
	FREED char *fraction = screened_title(&p->fraction);
	FREED char *more =
	    detail ? xasprintf(tr(" (%.0f J/kg)"), p->energy) : xstrdup("");
	FREED char *band =
	    !detail && p->low != NULL
		? xasprintf(tr(", %.0f %% band"), 100 * settings_level(&s->set))
		: xstrdup("");
	FREED char *rpm = rotor_speed_words(entry->site->rotor, p->speed, NAN);
	struct answer *r = answers_new(entry->site, "predict",
	    "product at %.*f m/s%s%s%s%s", units_speed_digits(p->speed),
	    p->speed, rpm, more, fraction, band);
	/* In a table that is read aloud, the numbers of a sieve belong in one
	 * line. */
	if (!s->linear)
		answer_set_across(r);
	predict_add_rows(r, s, entry, params, p, between, NULL, detail);
	answer_fill_for_programs(r);
	predict_add_rows(r, s, entry, params, p, between, model, true);
	return r;
}

/* Notes how well parameters from elsewhere meet the only product of a site. */
static void
note_fit_of_only_cut(
    struct answer *r, const struct session *s, const struct entry *entry)
{
	size_t run;
	if (session_busy(s) || entry->site != entry_loaded(entry)->site ||
	    !cut_is_only_check(entry, &run))
		return;
	struct cut cut = cut_compare(s, entry, run);
	FREED char *words = cut_words(&cut);
	FREED char *rpm = rotor_speed_words(
	    entry->site->rotor, entry->site->run[run].speed, NAN);
	answer_say(r, cut.missed ? ANSWER_WARNING : ANSWER_PLAIN,
	    cut.missed
		? N_("the prediction misses the cut at %g m/s%s, the one "
		     "product of this site: %s")
		: N_("the prediction meets the cut at %g m/s%s, the one "
		     "product of this site: %s"),
	    entry->site->run[run].speed, rpm, words);
	fields_put(fields_object(answer_fields(r), "cut"),
	    "speed %g rms_pct %g sieves %zu", entry->site->run[run].speed,
	    100 * cut.rms, cut.n);
}

/* Names the sieves at which measured products pass clearly less than their
 * feeds, while the answer equals the passing of the feed: breakage cannot bring
 * it any lower. */
static void
note_sieves_at_feed(
    struct answer *r, const struct question *q, const struct prediction *p)
{
	const double shown = 5e-4;
	const struct site *site = q->entry->site;
	const struct psd *feed = question_feed(q);
	FREED char *list = xstrdup("");
	for (size_t i = 0; i < p->product.n; i++) {
		double x = p->product.size[i], fed = psd_at_sieve(feed, x);
		double least = INFINITY;
		for (size_t k = 0; k < site->n_run; k++)
			least = fmin(
			    least, psd_at_sieve(&site->run[k].product, x) -
				       psd_at_sieve(&site->run[k].feed, x));
		if (fed > 0 && fed < 1 && least < -shown &&
		    p->product.passing[i] - fed < shown)
			xlist(&list, ", ", "%g", units_mm(x));
	}
	if (list[0] != '\0' && !fraction_screens(&p->fraction))
		answer_say(r, ANSWER_REMARK,
		    "at %s mm the feed has more than measured products, which "
		    "crushing cannot cause: there the answer is the feed; "
		    "sample the feed again",
		    list);
}

bool
predict_correction_is_worth_saying(
    const struct session *s, const struct entry *entry)
{
	return outlook_correction(s, entry) != CORRECTION_ALL ||
	       !entry->has_fit;
}

char *
predict_chance_words(double level)
{
	double tenths = 10 * level;
	return fabs(tenths - round(tenths)) < 1e-9
		   ? xasprintf(tr("%.0f times in 10"), tenths)
		   : xasprintf(tr("with %g %% probability"), 100 * level);
}

static double
value_at(const struct session *s, const struct question *q,
    const struct quantity *of, double speed)
{
	struct forecast *f = forecast_open(s, q, of, 1);
	forecast_at(f, speed);
	double value = forecast_figure(f, 0).value;
	forecast_close(f);
	return value;
}

size_t
predict_each_feed(const struct session *s, const struct question *q,
    const struct quantity *of, double speed, double *value)
{
	const struct site *site = q->entry->site;
	bool other = site_run_at(site, SITE_OTHER_FEED) < site->n_run;
	size_t n = site->individual_feeds && !other ? site->n_run : 0;
	for (size_t run = 0; run < n; run++) {
		struct question own = *q;
		own.feed = run;
		value[run] = value_at(s, &own, of, speed);
	}
	return n;
}

bool
predict_feeds_range(const struct session *s, const struct question *q,
    const struct quantity *of, double speed, double range[static 2])
{
	FREED double *fed = xdoubles(q->entry->site->n_run);
	size_t n = predict_each_feed(s, q, of, speed, fed);
	range[0] = INFINITY;
	range[1] = -INFINITY;
	for (size_t run = 0; run < n; run++) {
		range[0] = fmin(range[0], fed[run]);
		range[1] = fmax(range[1], fed[run]);
	}
	return range[0] <= range[1];
}

double
predict_change_by_feeds(const struct session *s, const struct question *q,
    const struct quantity *of, double speed)
{
	double range[2];
	if (!predict_feeds_range(s, q, of, speed, range))
		return 0;
	double value = value_at(s, q, of, speed);
	return fmax(fabs(range[0] - value), fabs(range[1] - value));
}

/* Adds the range of the quantity over the sampled feeds, used one at a time
 * instead of their mean, if the last digit shown can tell them from it. */
static void
add_each_feed(const struct session *s, const struct question *q,
    const struct quantity *of, double speed, double value, char **words)
{
	int decimals = quantities_decimals(of);
	double range[2];
	if (!predict_feeds_range(s, q, of, speed, range))
		return;
	double most = fmax(value - range[0], range[1] - value);
	if (!(quantities_shown(of, most) >= 0.5 * pow(10, -decimals)))
		return;
	xappend(words,
	    tr("; with each sampled feed instead of their mean from %.*f to "
	       "%.*f"),
	    decimals, quantities_shown(of, range[0]), decimals,
	    quantities_shown(of, range[1]));
}

char *
predict_certainty_words(const struct session *s, const struct question *q,
    const struct quantity *of, double speed)
{
	int decimals = quantities_decimals(of);
	struct forecast *f = forecast_open(s, q, of, 1);
	forecast_at(f, speed);
	struct figure answer = forecast_shown(f, 0);
	double value = forecast_figure(f, 0).value;
	forecast_part_at(f, speed, ENSEMBLE_SAMPLE);
	struct figure sample = forecast_shown(f, 0);
	forecast_close(f);
	if (isnan(value) || isnan(answer.low) || isnan(sample.low))
		return NULL;
	FREED char *chance = predict_chance_words(q->level);
	FREED char *said = quantities_statement(of, value);
	FREED char *rpm = rotor_speed_words(q->entry->site->rotor, speed, NAN);
	char *words = xasprintf(
	    tr("at %.*f m/s%s %s: %s between %.*f and %.*f; a new belt cut "
	       "between %.*f and %.*f"),
	    units_speed_digits(speed), speed, rpm, said, chance, decimals,
	    answer.low, decimals, answer.high, decimals, sample.low, decimals,
	    sample.high);
	if (q->feed == SITE_MEAN_FEED)
		add_each_feed(s, q, of, speed, value, &words);
	return words;
}

/* Adds, for a user who types, the line that asks for the next sieve, because
 * the rows of the table have no range for a belt cut. */
static void
add_other_sieve(const struct session *s, const struct question *q,
    const struct prediction *p, char **words)
{
	size_t said = answers_usual_sieve(&p->product);
	size_t other = said > 0 ? said - 1 : said + 1;
	if (!s->prompt || s->scripts > s->typed_depth || other >= p->product.n)
		return;
	FREED char *speed = answers_typed_speed(q->entry->site, p->speed);
	xappend(words, tr("; another sieve: predict %s passing %g"), speed,
	    units_mm(p->product.size[other]));
}

static void
note_certainty(struct answer *r, const struct session *s,
    const struct question *q, const struct prediction *p)
{
	const struct quantity of = answers_usual_passing(&p->product);
	if (p->low == NULL || fraction_screens(&p->fraction))
		return;
	FREED char *words = predict_certainty_words(s, q, &of, p->speed);
	if (words == NULL)
		return;
	add_other_sieve(s, q, p, &words);
	answer_note(r, "%s", words);
}

/* Returns how far the measured products that stand beside the answer were
 * moved, the largest distance, passing 0..1; 0 if that does not show. */
static double
largest_move_to_feed(const struct session *s, const struct question *q,
    const struct prediction *p, bool between)
{
	const double SHOWN = 5e-4; /* changes a tenth of a point */
	const struct site *site = q->entry->site;
	double most = 0;
	for (size_t k = 0; k < site->n_run; k++)
		if (between || fabs(site->run[k].speed - p->speed) <= 1e-3)
			most = fmax(most, moved_largest(s, q->entry, q->params,
					      k, p->feed_run));
	return most > SHOWN ? most : 0;
}

/* Builds the answer with all notes.  wanted: with interpolated products. */
static struct answer *
prediction_with_notes(const struct session *s, const struct question *q,
    const struct prediction *p, const struct params *params, bool wanted,
    bool detail)
{
	const struct entry *entry = q->entry;
	FREED double *between =
	    wanted ? interpolate_measured(s, entry, params, p) : NULL;
	struct answer *r =
	    prediction_answer(s, entry, p, params, between, detail);
	struct fields *o = answer_fields(r);
	answers_put_prediction(s, o, entry, params, p);
	note_certainty(r, s, q, p);
	screened_note(r, p);
	answers_note_sizes(r, p);
	if (p->low != NULL) {
		answer_put_columns(r, "low_pct high_pct");
		answers_put_band(o, s, p);
	}
	if (detail || p->no_daughters || p->break_size >= p->feed.size[0])
		note_breakage(
		    r, params, site_feed(entry->site, p->feed_run), p);
	note_sieves_at_feed(r, q, p);
	note_feed_gaps(r, entry->site, p);
	note_wide_gap(r, site_feed(entry->site, p->feed_run));
	if (session_fitting(s) == entry_loaded(entry))
		answer_say(r, ANSWER_REMARK,
		    "predicted with the best parameters so far");
	if (between != NULL)
		answer_put_columns(r, "interpolated_pct");
	else if (wanted)
		answer_say(r, ANSWER_REMARK,
		    entry->site->with[0] != '\0'
			? N_("no interpolation: at %g m/s nothing was measured "
			     "with this feed and machine")
			: N_("no interpolation: %g m/s is not between measured "
			     "runs"),
		    p->speed);
	note_fit_of_only_cut(r, s, entry);
	struct question at = *q;
	at.moved = largest_move_to_feed(s, q, p, between != NULL);
	answers_show_basis_at(s, r, &at, p->speed,
	    p->low != NULL &&
		(detail || predict_correction_is_worth_saying(s, entry)));
	return r;
}

/* Draws the psd plot of the prediction: with its band if an image is wanted,
 * otherwise as plain text. */
static bool
draw_curves(struct session *s, const struct question *q,
    const struct prediction *p, struct error *error)
{
	enum { WIDTH = 78, HEIGHT = 24 };
	struct plot_request request = plots_request(PLOT_PSD);
	request.entry = q->entry;
	request.speed = p->speed;
	request.fraction = p->fraction;
	request.feed = p->feed_run;
	request.band = plot_writes_image(s) && p->low != NULL;
	if (!plot_writes_image(s))
		request.strip = 0;
	struct chart *chart = plots_chart(s, &request, error);
	if (chart == NULL)
		return false;
	if (plot_writes_image(s))
		return plot_write_image(s, chart, error);
	struct canvas *canvas =
	    chart_draw(chart, WIDTH, HEIGHT, request.charset, request.words);
	fputc('\n', s->out);
	canvas_print(canvas, 0, s->out);
	canvas_free(canvas);
	chart_free(chart);
	return true;
}

/* Takes the parameters that predict a site; during its calibration, the best so
 * far. */
static bool
params_to_predict_with(const struct session *s, const struct entry *entry,
    struct params *params, struct error *error)
{
	*params = entry->params;
	return answers_best_so_far(s, entry, params) ||
	       answers_check_params(s, entry, error);
}

bool
predict_step(struct session *s, const struct entry *entry, double speed,
    size_t feed_run, const char *line, struct prediction *p,
    struct error *error)
{
	struct params params;
	if (!params_to_predict_with(s, entry, &params, error))
		return false;
	struct question q = question_of_whole_product(s, entry, feed_run);
	q.params = &params;
	*p = forecast_product(s, &q, speed);
	answers_keep_prediction(s, entry, &params, p);
	invocation_asked(s, "predict", line);
	return true;
}

/* Refuses interpolated= for a fraction, because it shows the whole product. */
static bool
check_whole_product(const struct args *args, const struct fraction *fraction,
    struct error *error)
{
	if (!args->interpolated || !fraction_screens(fraction))
		return true;
	return error_set(error, ERROR_USAGE,
	    "interpolated= shows the whole product, not a fraction\n"
	    "leave out cut=, or write plot response");
}

bool
cmd_predict(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	const struct entry *entry = q->entry;
	struct params params;
	question_take_last_speed(s, q);
	if (!params_to_predict_with(s, entry, &params, error) ||
	    !check_whole_product(args, &q->fraction, error) ||
	    !screened_check_covered(q, error))
		return false;
	struct question at = *q;
	at.params = &params;
	struct prediction p = forecast_product(s, &at, at.speed);
	asked_keep(s, p.speed, NULL);
	if (!args->band)
		prediction_drop_band(&p);
	struct answer *r = prediction_with_notes(
	    s, &at, &p, &params, args->interpolated, args->detail);
	if (args_given(args, &args->band) && args->band && p.low == NULL)
		answer_note(r, "%s", outlook_why_none(s, entry));
	bool picture = plot_writes_image(s) && s->document == NULL;
	bool curve = args->curve && s->set.format == ANSWER_TABLE;
	if (picture)
		session_keep_answer(s, r);
	else
		session_show_answer(s, r);
	bool ok = (!picture && !curve) || draw_curves(s, &at, &p, error);
	prediction_free(&p);
	return ok;
}
