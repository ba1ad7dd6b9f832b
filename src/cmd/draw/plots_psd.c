/* psd: plots size distributions at one speed, with the measured ones, the
 * limits of the envelope, a second prediction, and a strip of differences
 * below.  sweep: plots them at several speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/asked.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/moved.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/pin.h"
#include "cmd/ask/screened.h"
#include "cmd/draw/plots_search.h"
#include "cmd/draw/site_chart.h"
#include "cmd/session/sites.h"
#include "core/psd/rotor_speed.h"
#include "core/answer/predict.h"
#include "io/formats/spec.h"
#include "io/sitefile/units.h"

static const struct chart_series OTHER = {.series = SERIES_OTHER,
    .line = CHART_DASHED,
    .ascii = '%',
    .compared = true};
static const struct chart_series PART = {
    .series = SERIES_PREDICTED, .line = CHART_LONG, .ascii = '@'};

/* Styles of the upper and the lower limits. */
static const struct chart_series LIMITS[2] = {
    {.series = SERIES_TEXT, .line = CHART_DOTTED, .ascii = '\'', .mark = 'T'},
    {.series = SERIES_TEXT, .line = CHART_DOTTED, .ascii = '\'', .mark = 'L'}};

/* Adds a series of the lower or the upper limits that lie within the axis. */
static void
add_envelope_limit_series(
    struct chart *chart, const struct spec *spec, bool least)
{
	const double *limit = least ? spec->least : spec->most;
	size_t n = 0;
	FREED double *x = xcalloc_doubles(spec->n);
	FREED double *y = xcalloc_doubles(spec->n);
	for (size_t i = 0; i < spec->n; i++) {
		double mm = units_m_to_mm(spec->size[i]);
		if (mm < chart->x.low || mm > chart->x.high || isnan(limit[i]))
			continue;
		x[n] = mm;
		y[n++] = units_fraction_to_pct(limit[i]);
	}
	if (n == 0)
		return;
	FREED char *name =
	    xasprintf("%s, %s", least ? tr("min") : tr("max"), spec->name);
	chart_append_point_series(chart, LIMITS[least], n, x, y, name);
	chart_move_last_series_to_back(chart);
}

/* Adds the limits of the chosen envelope, if any, behind all curves.  notes:
 * name their source below the chart. */
static void
draw_envelope_limits(struct chart *chart, const struct session *s, bool notes)
{
	const struct spec *spec = s->spec;
	if (spec == NULL)
		return;
	add_envelope_limit_series(chart, spec, true);
	add_envelope_limit_series(chart, spec, false);
	FREED char *cut = session_envelope_size_fraction_text(s);
	const char *source =
	    spec->source[0] != '\0' ? spec->source : spec->name;
	if (notes && cut[0] != '\0')
		chart_add_note(
		    chart, "limits of the fraction %s: %s", cut, source);
	else if (notes)
		chart_add_note(chart, "limits: %s", source);
}

/* Sets part->product, and nothing else in part, to the fraction to which the
 * chosen envelope applies, read off the prediction's curve.  Free with
 * prediction_free.  Returns false if the envelope is for the whole product. */
static bool
extract_fraction_for_envelope(const struct session *s,
    const struct entry *entry, const struct prediction *whole,
    struct prediction *part)
{
	struct fraction fraction = session_envelope_size_fraction(s);
	if (!fraction_is_screened(&fraction))
		return false;
	/* The sizes of the cut are included, so that the curve ends there. */
	const double cut[] = {fraction.fine, fraction.coarse};
	const struct psd *feed = site_feed_of_run(entry->site, whole->feed_run);
	const struct psd *sieves = &whole->product;
	struct psd all = psd_new(sieves->n + ARRAY_LEN(cut));
	all.n = sieves->n;
	memcpy(all.size, sieves->size, sieves->n * sizeof *sieves->size);
	for (size_t i = 0; i < ARRAY_LEN(cut); i++)
		if (cut[i] > 0 && psd_covers_size(feed, cut[i]) &&
		    cut[i] < sieves->size[0])
			all.size[all.n++] = cut[i];
	all.n = psd_sort_distinct_sizes(all.size, all.n, 0);
	/* The curve of the whole product is exact enough for a drawing.
	 * Computing the fraction itself would take longer than all else in a
	 * step of the slider. */
	struct psd curve =
	    screened_fraction_of_product(&whole->curve, &fraction);
	for (size_t i = 0; i < all.n; i++)
		all.passing[i] = psd_passing(&curve, all.size[i]);
	psd_free(&curve);
	*part = (struct prediction){.product = all};
	return true;
}

/* Rounds a value up to a limit of the axis.  There are few such limits, so that
 * the scale seldom changes while the slider moves. */
static double
round_up_axis_limit(double value)
{
	static const double ROUND[] = {1, 2, 5, 10, 20, 50};
	for (size_t i = 0; i < ARRAY_LEN(ROUND); i++)
		if (value <= ROUND[i])
			return ROUND[i];
	return 100;
}

/* Returns an axis that reaches as far below 0 as above, so that 0 stays in
 * place. */
static struct axis
difference_strip_axis(const struct chart *chart)
{
	struct axis axis = {.title = xstrdup(tr("difference, points"))};
	struct chart_extent e = chart_compute_extent(chart);
	axis.high = round_up_axis_limit(fmax(-e.y[0], e.y[1]));
	axis.low = -axis.high;
	axis_add_signed_number(&axis, axis.low, 0);
	axis_add_signed_number(&axis, 0, 0);
	axis_add_signed_number(&axis, axis.high, 0);
	return axis;
}

/* Adds the difference a - b at each point of a; NAN where b has no value. */
static void
add_difference_curve(struct chart *strip, const struct chart *chart,
    const struct chart_series *a, const struct chart_series *b,
    struct chart_series look)
{
	struct chart_series *s = chart_append_series(
	    strip, look, a->n, "%s less %s", a->name, b->name);
	for (size_t i = 0; i < a->n; i++) {
		s->x[i] = a->x[i];
		s->y[i] = a->y[i] - chart_series_y_at_x(chart, b, a->x[i]);
	}
}

static struct axis
axis_copy(const struct axis *from)
{
	struct axis axis = *from;
	axis.title = xstrdup(from->title);
	axis.tick = xcalloc(from->n, sizeof *axis.tick);
	for (size_t i = 0; i < from->n; i++)
		axis.tick[i] = from->tick[i];
	return axis;
}

/* Returns the length of "measured 74 m/s" in "measured 74 m/s (2)". */
static int
series_short_name_length(const struct chart_series *s)
{
	return (int)strcspn(s->name, ",(") -
	       (s->name[strcspn(s->name, ",(")] == '(');
}

/* Returns a title such as "points; line: predicted less pin; marks: measured 74
 * m/s less it", or "points; marks: measured 74 m/s less predicted 72 m/s".
 * The two speeds may differ.  other, measured: the curves compared, or NULL. */
static char *
title_of_difference_strip(const struct chart_series *predicted,
    const struct chart_series *other, const struct chart_series *measured)
{
	char *title = xstrdup(tr("points"));
	if (other != NULL)
		xappend_to_list(&title, "; ", tr("line: predicted less %s"),
		    strncmp(other->name, "pin", 3) == 0 ? tr("pin")
							: tr("the other"));
	if (measured != NULL && other != NULL)
		xappend_to_list(&title, "; ", tr("marks: %.*s less it"),
		    series_short_name_length(measured), measured->name);
	else if (measured != NULL)
		xappend_to_list(&title, "; ", tr("marks: %.*s less %.*s"),
		    series_short_name_length(measured), measured->name,
		    series_short_name_length(predicted), predicted->name);
	return title;
}

/* Adds the band of a prediction as differences from the prediction.  In the
 * chart above, the line often hides it. */
static void
add_band_difference_series(
    struct chart *strip, const struct chart_series *predicted)
{
	struct chart_series *s = chart_append_series(
	    strip, *predicted, predicted->n, "uncertainty band");
	series_allocate_band(s);
	for (size_t i = 0; i < s->n; i++) {
		s->x[i] = predicted->x[i];
		s->y[i] = NAN;
		s->low[i] = predicted->low[i] - predicted->y[i];
		s->high[i] = predicted->high[i] - predicted->y[i];
	}
}

/* Adds a strip of differences below a chart whose last series is the
 * prediction: the prediction minus the second one, and the product measured at
 * the nearest speed minus the prediction, with the band of the prediction.
 * Adds nothing if there is neither. */
static void
add_difference_strip(struct chart *chart, int rows, bool band)
{
	const struct chart_series *last = chart->series[chart->n - 1];
	const struct chart_series *other = NULL, *measured = NULL;
	struct chart *strip =
	    chart_new("", chart->about, axis_copy(&chart->x), (struct axis){0});
	for (size_t i = 0; i + 1 < chart->n; i++) {
		const struct chart_series *s = chart->series[i];
		if (s->compared && s->series == SERIES_OTHER) {
			other = s;
			add_difference_curve(strip, chart, last, s, *last);
		} else if (s->compared) {
			measured = s;
			add_difference_curve(strip, chart, s, last, *s);
		}
	}
	if (strip->n > 0 && band && last->low != NULL)
		add_band_difference_series(strip, last);
	xfree_and_set(
	    &strip->title, title_of_difference_strip(last, other, measured));
	strip->strip = rows;
	strip->y = difference_strip_axis(strip);
	if (strip->n > 0)
		chart->below = strip;
	else
		chart_free(strip);
}

/* A function that reads a curve: chart_series_y_at_x at a size or
 * chart_series_x_at_y at a passing. */
typedef double curve_reader(
    const struct chart *, const struct chart_series *, double);

/* Appends " feed 16.0 %" to a note, " predicted 33.1 % (31.6 to 34.5)" if the
 * curve has a band there, or " feed -" if it has no value. */
static void
append_curve_value_to_note(char **note, const struct chart *chart,
    const struct chart_series *s, curve_reader *read, double at,
    const struct figure *band)
{
	int digits = read == chart_series_y_at_x ? 1 : 2;
	double own = read(chart, s, at);
	if (isnan(own)) {
		xappend(note, " %s -", s->name);
		return;
	}
	xappend(note, " %s %.*f %s", s->name, digits, own,
	    read == chart_series_y_at_x ? "%" : "mm");
	if (s->low != NULL && isfinite(band->low) && isfinite(band->high))
		xappend(note, tr(" (%.*f to %.*f)"), digits, band->low, digits,
		    band->high);
}

/* Sets the bands at the crosshair from a pinned prediction, which has bands
 * only at its sieves and for P20, P50 and P80. */
static void
find_crosshair_bands_of_pin(const struct plot_request *q,
    const struct prediction *p, struct figure band[static 2])
{
	for (size_t i = 0; i < p->product.n && p->low != NULL; i++)
		if (fabs(units_m_to_mm(p->product.size[i]) - q->crosshair_mm) <
		    1e-9)
			band[0] = (struct figure){NAN,
			    units_fraction_to_pct(p->low[i]),
			    units_fraction_to_pct(p->high[i])};
	for (size_t k = 0; k < PSD_SIZES; k++)
		if (fabs(q->level - 100 * PSD_PASSING[k]) < 1e-9)
			band[1] = (struct figure){
			    NAN, 1000 * p->range[k][0], 1000 * p->range[k][1]};
}

/* Computes the bands at the crosshair: of the passing, %, and of the size,
 * mm. */
static void
compute_crosshair_bands(const struct session *s, const struct plot_request *q,
    const struct params *params, const struct prediction *p,
    struct figure band[static 2])
{
	struct question question = q->asked;
	question.params = params;
	const struct quantity asked[] = {{.kind = QUANTITY_PASSING,
					     .x = q->crosshair_mm / 1000,
					     .fraction = q->asked.fraction},
	    {.kind = QUANTITY_SIZE,
		.x = q->level / 100,
		.fraction = q->asked.fraction}};
	struct forecast *f = forecast_open(s, &question, asked, 2);
	forecast_set_speed(f, p->speed);
	for (size_t i = 0; i < 2; i++)
		band[i] = forecast_value_in_shown_unit(f, i);
	forecast_close(f);
}

/* Adds a vertical line.  If the chart has notes, adds "at 2 mm: feed 16.0 %,
 * measured 69 m/s 29.0 %" and the size of each curve that `level` % pass.  p:
 * the prediction by these parameters, for its bands, or NULL. */
static void
add_crosshair(struct chart *chart, const struct session *s,
    const struct plot_request *q, const struct params *params,
    const struct prediction *p)
{
	double x = q->crosshair_mm, level = q->level;
	struct figure band[2] = {{NAN, NAN, NAN}, {NAN, NAN, NAN}};
	chart_add_vertical_rule(
	    chart, SERIES_CROSSHAIR, x, "crosshair at %g mm", x);
	if (!(q->words & CHART_NOTES))
		return;
	if (p != NULL && p == q->made)
		find_crosshair_bands_of_pin(q, p, band);
	else if (p != NULL)
		compute_crosshair_bands(s, q, params, p, band);
	FREED char *at = xasprintf(tr("at %g mm:"), x);
	FREED char *sizes = xasprintf(tr("%g %% pass:"), level);
	for (size_t i = 0; i < chart->n; i++) {
		const struct chart_series *of = chart->series[i];
		const char *comma = i + 1 < chart->n ? "," : "";
		append_curve_value_to_note(
		    &at, chart, of, chart_series_y_at_x, x, &band[0]);
		append_curve_value_to_note(
		    &sizes, chart, of, chart_series_x_at_y, level, &band[1]);
		xappend(&at, "%s", comma);
		xappend(&sizes, "%s", comma);
	}
	chart_add_note(chart, "%s", at);
	chart_add_note(chart, "%s", sizes);
}

/* Adds a vertical line at the break size, and a note with P20, P50 and P80.
 * whose: the site of the prediction, or NULL if it is no longer loaded.  In a
 * chart without notes the name of the line contains no numbers. */
static void
mark_break_size(struct chart *chart, const struct session *s,
    const struct plot_request *q, const struct entry *whose,
    const struct prediction *p, const char *name, enum series series)
{
	double mm = 1000 * p->break_size;
	FREED char *speed =
	    answers_speed_text(q->asked.entry->site, p->speed, -1);
	if (!(q->words & CHART_NOTES))
		chart_add_vertical_rule(chart, series, mm, "%sbreak size",
		    series == SERIES_OTHER ? tr("pin ") : "");
	else if (series == SERIES_OTHER && q->beside != NULL)
		chart_add_vertical_rule(
		    chart, series, mm, "%s: break size %.2f mm", q->beside, mm);
	else
		chart_add_vertical_rule(
		    chart, series, mm, "break size %.2f mm at %s", mm, speed);
	char p20[32], p50[32], p80[32];
	char *const words[] = {p20, p50, p80};
	for (size_t i = 0; i < PSD_SIZES; i++)
		snprintf(words[i], sizeof p20,
		    isnan(p->size[i]) ? tr("outside") : "%.2f mm",
		    1000 * p->size[i]);
	FREED char *text =
	    xasprintf("%s: P20 %s, P50 %s, P80 %s", name, p20, p50, p80);
	if (whose != NULL && answers_is_speed_extrapolated(whose, p->speed))
		xappend_to_list(&text, "; ", "%s", tr("extrapolated"));
	if (whose != NULL && p->low != NULL)
		xappend_to_list(
		    &text, "; ", "%s", correction_in_words(s, whose));
	chart_add_note(chart, "%s", text);
	if (whose == NULL || origin_site_key(whose) == whose->key)
		return;
	FREED char *from = origin_params_source_sentence(whose);
	chart_add_note(chart, "%s%s",
	    origin_is_other_site(whose) ? tr("warning: ") : "", from);
}

/* Shades the band of the last series, a prediction by the site's own
 * parameters, or notes why there is no band. */
static void
shade_prediction_band(struct chart *chart, const struct session *s,
    const struct entry *entry, const struct prediction *p)
{
	if (p->low == NULL) {
		chart_add_note(chart, "%s", band_why_missing(s, entry));
		return;
	}
	struct chart_series *series = chart->series[chart->n - 1];
	double level = 100 * settings_band_probability(&s->set), widest = 0;
	series_allocate_band(series);
	for (size_t i = 0; i < series->n; i++) {
		series->low[i] = units_fraction_to_pct(p->low[i]);
		series->high[i] = units_fraction_to_pct(p->high[i]);
		widest = fmax(widest, series->high[i] - series->low[i]);
	}
	const double *range = p->range[1];
	if (isfinite(range[0]) && isfinite(range[1]))
		chart_add_note(chart,
		    "shaded: %.0f %% uncertainty band, at most %.1f points "
		    "wide; P50 %.2f to %.2f mm",
		    level, widest, 1000 * range[0], 1000 * range[1]);
	else
		chart_add_note(chart,
		    "shaded: %.0f %% uncertainty band, at most %.1f points "
		    "wide",
		    level, widest);
}

/* Adds a product.  Values between its sieves are read off the curve of its
 * prediction.  Takes ownership of the name. */
static void
add_product_curve(struct chart *chart, const struct prediction *p, char *name,
    struct chart_series look)
{
	site_chart_add_psd(
	    chart, look, &p->product, p->curve.n > 0 ? &p->curve : NULL, name);
}

static struct prediction
predict_for_plot(const struct session *s, const struct plot_request *q,
    const struct entry *entry, const struct params *params, double speed,
    size_t feed)
{
	struct question question = q->asked;
	question.entry = entry;
	question.feed = feed;
	question.params = params;
	return forecast_product(s, &question, speed);
}

/* A second prediction, p, to draw beside the first, or NULL, and its site.
 * made: holds it, unless the request did. */
struct second_prediction {
	const struct prediction *p;
	const struct entry *whose; /* NULL if no longer loaded */
	struct prediction made;
};

/* Finds or makes the second prediction, if the request has one.  own: the
 * parameters of the first, or NULL; speed: of the first.  Returns false with an
 * error if the site beside is not loaded or has no parameters. */
static bool
compute_second_prediction(struct session *s, const struct plot_request *q,
    const struct params *own, double speed, struct second_prediction *second,
    struct error *error)
{
	size_t i, feed = q->asked.feed;
	struct error gone = {0};
	bool beside = q->beside != NULL, kept = q->kept != NULL;
	*second = (struct second_prediction){.p = q->kept};
	if (beside && session_find_site(s, q->beside, &i, kept ? &gone : error))
		second->whose = q->second != NULL ? q->second : &s->entry[i];
	else if (beside && !kept)
		return false;
	else if (!beside)
		second->whose = q->asked.entry;
	if (kept)
		return true;
	if (entry_without_scenario(second->whose) !=
	    entry_without_scenario(q->asked.entry)) {
		if (!answers_require_params(s, second->whose, error))
			return false;
		own = &second->whose->params;
		feed = SITE_MEAN_FEED;
	}
	if (own == NULL || (!beside && isnan(q->other_speed)))
		return true;
	if (q->other_feed != 0 &&
	    !feed_find_run_sampled_at_speed(
		second->whose->site, q->other_feed, &feed, error))
		return false;
	second->made = predict_for_plot(s, q, second->whose, own,
	    isnan(q->other_speed) ? speed : q->other_speed, feed);
	second->p = &second->made;
	return true;
}

static void
add_second_predicted_curve(struct chart *chart, const struct session *s,
    const struct plot_request *q, const struct second_prediction *second)
{
	bool beside = q->beside != NULL;
	if (second->p == NULL)
		return;
	FREED char *speed = answers_speed_text(
	    second->whose != NULL ? second->whose->site : NULL,
	    second->p->speed, -1);
	add_product_curve(chart, second->p,
	    xasprintf("%s %s%s%s",
		s->pin != NULL && q->kept == &s->pin->p ? tr("pin")
							: tr("predicted"),
		beside ? q->beside : "", beside ? " " : "", speed),
	    OTHER);
}

/* Adds break sizes, notes and the band for the two predictions, which are the
 * last series of the chart. */
static void
add_break_sizes_and_bands(struct chart *chart, struct session *s,
    const struct plot_request *q, const struct prediction *one,
    const struct second_prediction *two, bool shade)
{
	const struct entry *entry = q->asked.entry;
	struct chart_series **last = &chart->series[chart->n - 1];
	if (one != NULL)
		mark_break_size(
		    chart, s, q, entry, one, (*last)->name, SERIES_BREAK);
	if (one != NULL && shade)
		shade_prediction_band(chart, s, entry, one);
	if (two->p != NULL)
		mark_break_size(chart, s, q, two->whose, two->p,
		    last[one != NULL ? -1 : 0]->name, SERIES_OTHER);
}

/* Adds the feed, named after its run if each run has its own. */
static void
add_feed_curve(struct chart *chart, const struct site *site, size_t run)
{
	bool one = run < site->n_run && site->individual_feeds;
	FREED char *speed =
	    one ? answers_speed_text(site, site->run[run].speed, -1) : NULL;
	site_chart_add_psd(chart, SITE_CHART_FEED, site_feed_of_run(site, run),
	    NULL,
	    one ? xasprintf(tr("feed %s%s"), speed, site->run[run].repeat)
		: xstrdup(tr("feed")));
}

/* Adds the measured products or, if the question has a fraction, that fraction
 * of them; nothing if it has another feed or machine.  Returns the most by
 * which a product was moved to the feed, see largest_change_by_moving_to_feed.
 */
static double
add_measured_curves_moved_to_feed(struct chart *chart, const struct session *s,
    const struct plot_request *q, const struct params *params, double speed)
{
	const struct site *site = q->asked.entry->site;
	double moved = 0;
	for (size_t i = 0; i < site->n_run && site->with[0] == '\0'; i++) {
		if (!site_run_is_among_nearest(
			site, i, speed, SITE_CHART_SPEEDS))
			continue;
		struct chart_series look =
		    site_chart_run_style(site, i, !q->asked.entry->train[i]);
		look.compared = site_run_is_among_nearest(site, i, speed, 1);
		const struct psd *product = measured_product_moved_to_feed(
		    s, q->asked.entry, params, i, q->asked.feed);
		struct psd part = fraction_is_screened(&q->asked.fraction)
				      ? screened_fraction_of_product(
					    product, &q->asked.fraction)
				      : psd_copy(product);
		FREED char *at =
		    answers_speed_text(site, site->run[i].speed, -1);
		site_chart_add_psd(chart, look, &part, NULL,
		    xasprintf(tr("measured %s%s"), at, site->run[i].repeat));
		psd_free(&part);
		moved =
		    fmax(moved, largest_change_by_moving_to_feed(s,
				    q->asked.entry, params, i, q->asked.feed));
	}
	return moved;
}

/* Adds the fraction of the product to which the chosen envelope applies, if
 * any. */
static void
add_curve_of_envelope_fraction(struct chart *chart, const struct session *s,
    const struct entry *entry, const struct prediction *whole)
{
	struct prediction part;
	if (!extract_fraction_for_envelope(s, entry, whole, &part))
		return;
	FREED char *words = session_envelope_size_fraction_text(s);
	add_product_curve(
	    chart, &part, xasprintf(tr("fraction %s"), words), PART);
	prediction_free(&part);
}

/* Adds the first prediction, dashed if it is extrapolated. */
static void
add_first_predicted_curve(struct chart *chart, const struct session *s,
    const struct plot_request *q, const struct prediction *p)
{
	struct chart_series look = SITE_CHART_PREDICTED;
	if (answers_is_speed_extrapolated(q->asked.entry, p->speed))
		look.line = CHART_LONG;
	FREED char *speed =
	    answers_speed_text(q->asked.entry->site, p->speed, -1);
	add_product_curve(chart, p,
	    q->words & CHART_NOTES
		? xasprintf(tr("predicted %s"), speed)
		: xasprintf(tr("predicted%s"),
		      correction_legend_text(s, q->asked.entry, p)),
	    look);
}

/* The predictions of a plot at one speed.  one: the first, by these parameters,
 * or NULL, and then `unknown` says what is missing.  made: holds it, unless the
 * request did. */
struct psd_plot {
	double speed;
	struct params params;
	struct error unknown;
	const struct prediction *one;
	struct prediction made;
	struct second_prediction two;
};

/* Finds or makes both predictions.  It is not an error if the first is missing,
 * because the measured curves are still worth a look, unless a generation is
 * requested. */
static bool
compute_plotted_predictions(struct session *s, const struct plot_request *q,
    struct psd_plot *p, struct error *error)
{
	const struct entry *entry = q->asked.entry;
	*p = (struct psd_plot){.speed = isnan(q->asked.speed)
					    ? site_middle_speed(entry->site)
					    : q->asked.speed};
	bool known = find_param_values_for_plot(s, q, &p->params, &p->unknown);
	if (!known && q->generation > 0) {
		*error = p->unknown;
		return false;
	}
	if (!compute_second_prediction(
		s, q, known ? &p->params : NULL, p->speed, &p->two, error))
		return false;
	p->one = q->made;
	if (known && p->one == NULL) {
		p->made = predict_for_plot(
		    s, q, entry, &p->params, p->speed, q->asked.feed);
		p->one = &p->made;
	}
	return true;
}

static void
fill_psd_chart(struct chart *chart, struct session *s,
    const struct plot_request *q, const struct psd_plot *p)
{
	const struct entry *entry = q->asked.entry;
	const struct prediction *one = p->one;
	add_feed_curve(chart, entry->site, q->asked.feed);
	double moved = add_measured_curves_moved_to_feed(
	    chart, s, q, one != NULL ? &p->params : NULL, p->speed);
	if (one != NULL && !fraction_is_screened(&q->asked.fraction))
		add_curve_of_envelope_fraction(chart, s, entry, one);
	add_second_predicted_curve(chart, s, q, &p->two);
	if (one != NULL)
		add_first_predicted_curve(chart, s, q, one);
	site_chart_set_sieve_axis(chart);
	draw_envelope_limits(chart, s, (q->words & CHART_NOTES) != 0);
	bool own = memcmp(&entry->params, &p->params, sizeof p->params) == 0;
	add_break_sizes_and_bands(chart, s, q, one, &p->two, q->band && own);
	if (one == NULL)
		chart_add_note(chart, "no prediction: %s", p->unknown.text);
	else if (q->strip > 0)
		/* The screen's band would change many cells at each step. */
		add_difference_strip(
		    chart, q->strip, (q->words & CHART_NOTES) != 0);
	site_chart_note_run_marks(chart, entry->site);
	site_chart_note_moved_products(chart, moved);
	if (!isnan(q->crosshair_mm))
		add_crosshair(chart, s, q, &p->params, one);
}

struct chart *
plots_psd(struct session *s, const struct plot_request *q, struct error *error)
{
	const struct site *site = q->asked.entry->site;
	struct psd_plot p;
	if (!compute_plotted_predictions(s, q, &p, error))
		return NULL;
	FREED char *fraction =
	    screened_fraction_title_suffix(&q->asked.fraction);
	FREED char *rpm = rotor_speed_rpm_text(site->rotor, p.speed, NAN);
	struct chart *chart = site_chart_new(site, (struct axis){0},
	    axis_new_percent(tr("passing, %")),
	    p.one != NULL                   ? N_("product at %.*f m/s%s%s")
	    : site_count_products(site) > 0 ? N_("feed and products")
					    : N_("feed"),
	    units_speed_decimals(p.speed), p.speed, rpm, fraction);
	fill_psd_chart(chart, s, q, &p);
	prediction_free(&p.made);
	prediction_free(&p.two.made);
	return chart;
}

struct chart *
plots_sweep(
    struct session *s, const struct plot_request *q, struct error *error)
{
	enum { MOST = 8 };
	const struct site *site = q->asked.entry->site;
	size_t n = q->asked.n_at;
	struct params params;
	if (!find_param_values_for_plot(s, q, &params, error))
		return NULL;
	if (n > MOST) {
		error_set(error, ERROR_USAGE,
		    "%zu speeds are too many to draw\n"
		    "use at most %zu, so that the curves can be distinguished",
		    n, (size_t)MOST);
		return NULL;
	}
	FREED double *usual =
	    n == 0 ? answers_list_few_round_speeds(s, site, &n) : NULL;
	const double *speed = usual != NULL ? usual : q->asked.at;
	FREED char *fraction =
	    screened_fraction_title_suffix(&q->asked.fraction);
	struct chart *chart = site_chart_new(site, (struct axis){0},
	    axis_new_percent(tr("passing, %")), "products at %zu speeds%s", n,
	    fraction);
	site_chart_add_psd(chart, SITE_CHART_FEED,
	    site_feed_of_run(site, q->asked.feed), NULL, xstrdup(tr("feed")));
	for (size_t i = 0; i < n; i++) {
		struct prediction p = predict_for_plot(
		    s, q, q->asked.entry, &params, speed[i], q->asked.feed);
		FREED char *at = answers_speed_text(site, speed[i], -1);
		bool beyond =
		    answers_is_speed_extrapolated(q->asked.entry, speed[i]);
		add_product_curve(chart, &p,
		    xasprintf(beyond ? tr("predicted %s (extrapolated)")
				     : tr("predicted %s"),
			at),
		    site_chart_series_style(i));
		prediction_free(&p);
	}
	site_chart_set_sieve_axis(chart);
	return chart;
}
