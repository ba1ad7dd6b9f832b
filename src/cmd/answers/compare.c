/* compare: two speeds of a site, two sites at a speed, or a speed and the
 * pinned prediction, side by side.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/answers/predict.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/question.h"
#include "cmd/session/sites.h"
#include "cmd/ask/trust_light.h"
#include "cmd/lang/parse.h"
#include "cmd/draw/plot.h"
#include "cmd/ask/pin.h"
#include "cmd/draw/plots.h"
#include "cmd/lang/table.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/screened.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/outlook.h"
#include "core/answer/predict.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

/* One of the two products.  head, words: its name in a column heading and in
 * sentences.  A pinned prediction belongs to the session. */
struct compared {
	const struct entry *entry;
	struct question q;
	struct prediction p;
	char *head, *words;
	bool pinned;
};

static const char PIN[] = "pinned";

static bool
are_compared_sites_different(const struct compared side[2])
{
	return entry_without_scenario(side[0].entry) !=
	       entry_without_scenario(side[1].entry);
}

/* Returns the passing at a size, NAN if the side's sieves do not cover it. */
static double
compared_side_passing_at_size(const struct compared *side, double x)
{
	const struct psd *p = side->pinned ? &side->p.curve : &side->p.product;
	return psd_covers_size(p, x) ? psd_passing(p, x) : NAN;
}

/* Returns the sieves of both sides, coarsest first, without those of a pinned
 * side unless both are pinned.  The caller frees them. */
static double *
merge_sieves_of_compared_sides(const struct compared side[2], size_t *n)
{
	double *x = xcalloc_doubles(side[0].p.product.n + side[1].p.product.n);
	*n = 0;
	for (size_t i = 0; i < 2; i++) {
		const struct psd *p = &side[i].p.product;
		if (side[i].pinned && !side[1 - i].pinned)
			continue;
		memcpy(x + *n, p->size, p->n * sizeof *x);
		*n += p->n;
	}
	*n = psd_sort_distinct_sizes(x, *n, 0);
	return x;
}

/* Forecasts the passings at sieves x [n] and P20, P50 and P80 at the side's
 * speed.  Returns NULL for a pinned prediction. */
static struct forecast *
open_compared_side_forecast(const struct session *s,
    const struct compared *side, const double *x, size_t n)
{
	FREED struct quantity *q = xcalloc(n + PSD_SIZES, sizeof *q);
	for (size_t i = 0; i < n + PSD_SIZES; i++)
		q[i] = (struct quantity){
		    .kind = i < n ? QUANTITY_PASSING : QUANTITY_SIZE,
		    .x = i < n ? x[i] : PSD_PASSING[i - n],
		    .fraction = side->q.fraction};
	struct forecast *f =
	    side->pinned ? NULL : forecast_open(s, &side->q, q, n + PSD_SIZES);
	if (f != NULL)
		forecast_set_speed(f, side->p.speed);
	return f;
}

/* Adds two cells: the ends of the band of b - a. */
static void
add_difference_band_cells(
    struct answer *r, struct forecast *const f[2], size_t i, bool size)
{
	struct figure more = forecast_difference(f[0], f[1], i);
	double unit = size ? 1000 : 100;
	answer_add_cells(r, size ? "%+.2f %+.2f" : "%+.1f %+.1f",
	    unit * more.low, unit * more.high);
}

static void
add_passing_comparison_rows(struct answer *r, const struct compared side[2],
    struct forecast *const f[2], bool band, const double *x, size_t n)
{
	char key[40], head[24];
	answer_add_columns(r, "quantity: sieve mm, a: %s, b: %s, difference",
	    side[0].head, side[1].head);
	if (band)
		answer_add_columns(r, "low, high");
	for (size_t i = 0; i < n; i++) {
		double a = compared_side_passing_at_size(&side[0], x[i]);
		double b = compared_side_passing_at_size(&side[1], x[i]);
		snprintf(
		    key, sizeof key, "passing_pct@%g", units_m_to_mm(x[i]));
		snprintf(head, sizeof head, "%g", units_m_to_mm(x[i]));
		answer_add_keyed_cell(r, key, head);
		answer_set_missing_text(r, "-");
		answer_add_cells(r, "%.1f %.1f %+.1f", units_fraction_to_pct(a),
		    units_fraction_to_pct(b), 100 * (b - a));
		if (band)
			add_difference_band_cells(r, f, i, false);
	}
	for (size_t i = 0; i < ANSWERS_SIZES; i++) {
		answer_add_keyed_cell(
		    r, ANSWERS_SIZE[i].key, ANSWERS_SIZE[i].head);
		answers_add_size_cell(r, &side[0].p, i);
		answers_add_size_cell(r, &side[1].p, i);
		answer_set_missing_text(r, "-");
		answer_add_cells(r, "%+.2f",
		    answers_product_size_mm(&side[1].p, i) -
			answers_product_size_mm(&side[0].p, i));
		if (band && i != ANSWERS_BREAK)
			add_difference_band_cells(r, f, n + i, true);
		else if (band)
			answer_add_cells(r, "%.2f %.2f", NAN, NAN);
	}
}

/* Rounds a difference to the digits shown.  Never returns -0. */
static double
round_difference_as_shown(const struct quantity *q, double value)
{
	double steps = pow(10, quantities_decimals(q));
	return round(steps * quantities_value_in_shown_unit(q, value)) / steps +
	       0.0;
}

/* Says on which side the quantity is higher, and how far the difference varies
 * with the sampled feeds. */
static void
note_higher_of_compared_sides(struct answer *r, const struct session *s,
    const struct compared side[2], const struct quantity *q, struct figure more)
{
	int digits = quantities_decimals(q);
	const char *unit = quantities_difference_suffix(q);
	FREED char *words = quantities_name(q);
	FREED char *chance = predict_probability_text(side[0].q.level);
	double range[2], low = round_difference_as_shown(q, more.low);
	double high = round_difference_as_shown(q, more.high);
	if (low > 0 || high < 0)
		answer_note(r,
		    low > 0 ? N_("%s is higher at %s, %s by %.*f to %.*f%s")
			    : N_("%s is lower at %s, %s by %.*f to %.*f%s"),
		    words, side[1].words, chance, digits,
		    fmin(fabs(low), fabs(high)), digits,
		    fmax(fabs(low), fabs(high)), unit);
	else if (low < 0 || high > 0)
		answer_note(r,
		    "the data do not show which of the two has the higher %s: "
		    "the difference is %s between %+.*f and %+.*f%s",
		    words, chance, digits, low, digits, high, unit);
	else if (isnan(low) || isnan(high))
		answer_note(r,
		    "%s may be beyond the sieves: the difference has no band",
		    words);
	else
		answer_note(
		    r, "%s: the same at both, to the digits shown", words);
	const struct question *asked = &side[0].q;
	if ((low < 0 || high > 0) && !are_compared_sites_different(side) &&
	    asked->feed == SITE_MEAN_FEED &&
	    predict_value_range_over_feeds(
		s, asked, q, side[0].p.speed, side[1].p.speed, range))
		answer_note(r,
		    "with the feeds that were sampled, the difference in %s "
		    "ranges from %+.*f to %+.*f%s",
		    words, digits, round_difference_as_shown(q, range[0]),
		    digits, round_difference_as_shown(q, range[1]), unit);
}

/* Returns the value of a quantity, the ith of a forecast, in the unit shown.
 * f: NULL for a pinned prediction. */
static double
compared_side_quantity(const struct compared *side, struct forecast *f,
    const struct quantity *q, size_t i)
{
	return f != NULL ? forecast_value_in_shown_unit(f, i).value
			 : quantities_value_in_shown_unit(q,
			       screened_quantity_of_product(&side->p.curve, q));
}

/* Adds a row, an object for programs and, if there are bands, a sentence for
 * each quantity q [n]. */
static void
add_compared_quantity_rows(struct answer *r, const struct session *s,
    const struct compared side[2], const struct quantity *q, size_t n)
{
	struct fields *list = fields_add_list(answer_json_fields(r), "figures");
	struct forecast *f[2];
	for (size_t i = 0; i < 2; i++) {
		f[i] =
		    side[i].pinned ? NULL : forecast_open(s, &side[i].q, q, n);
		if (f[i] != NULL)
			forecast_set_speed(f[i], side[i].p.speed);
	}
	bool band = f[0] != NULL && f[1] != NULL &&
		    forecast_draws_of_quantity(f[0], 0) != NULL &&
		    forecast_draws_of_quantity(f[1], 0) != NULL;
	answer_add_columns(r,
	    "quantity: figure, a: %s, b: %s, unit, difference", side[0].head,
	    side[1].head);
	if (band)
		answer_add_columns(r, "low, high");
	for (size_t i = 0; i < n; i++) {
		struct figure more = {NAN, NAN, NAN};
		if (band)
			more = forecast_difference(f[0], f[1], i);
		double a = compared_side_quantity(&side[0], f[0], &q[i], i);
		double b = compared_side_quantity(&side[1], f[1], &q[i], i);
		double low = quantities_value_in_shown_unit(&q[i], more.low);
		double high = quantities_value_in_shown_unit(&q[i], more.high);
		int decimals = quantities_decimals(&q[i]);
		FREED char *key = quantities_field_name(&q[i]);
		FREED char *words = quantities_name(&q[i]);
		const char *unit = quantities_unit(&q[i]);
		answer_add_keyed_cell(r, key, words);
		answer_add_cells(r, "%.*f %.*f %s %+.*f", decimals, a, decimals,
		    b, unit, decimals, b - a);
		if (band)
			answer_add_cells(
			    r, "%+.*f %+.*f", decimals, low, decimals, high);
		fields_put_values(fields_add_object(list, NULL),
		    "quantity %s unit %s a %g b %g difference %g low %g high "
		    "%g",
		    key, unit, a, b, b - a, low, high);
		if (band)
			note_higher_of_compared_sides(r, s, side, &q[i], more);
	}
	for (size_t i = 0; i < 2; i++)
		forecast_close(f[i]);
}

static void
put_compared_side_fields(struct fields *o, const char *key,
    const struct compared *side, const double *x, size_t n)
{
	struct fields *one = fields_add_object(o, key);
	fields_put_values(one, "site %s speed %g extrapolated %d",
	    side->entry->site->name, side->p.speed,
	    answers_is_speed_extrapolated(side->entry, side->p.speed));
	struct fields *passing = fields_add_list(one, "passing_pct");
	for (size_t i = 0; i < n; i++)
		fields_put_values(passing, "%g",
		    units_fraction_to_pct(
			compared_side_passing_at_size(side, x[i])));
	answers_put_product_size_fields(one, &side->p);
	screened_put_fraction_fields(one, &side->p);
	origin_put_param_source(one, side->entry);
}

/* Returns the provenance of both sides, or of one if they are the same. */
static char *
provenance_of_compared_sides(const struct compared side[2])
{
	char *first[2];
	for (size_t i = 0; i < 2; i++)
		first[i] = site_provenance_first_clause(
		    side[i].entry->site, "not stated");
	bool same = strcmp(first[0], first[1]) == 0;
	char *both = same ? xstrdup(first[0])
			  : xasprintf("%s: %s, %s: %s", side[0].head, first[0],
				side[1].head, first[1]);
	free(first[0]);
	free(first[1]);
	return both;
}

/* Notes what breaks on each side, and warns of speeds outside the training
 * speeds. */
static void
note_broken_shares_and_extrapolation(
    struct answer *r, const struct compared side[2])
{
	answer_note(r, "broken, %% of feed: %.1f and %.1f",
	    100 * side[0].p.selected, 100 * side[1].p.selected);
	for (size_t i = 0; i < 2; i++)
		if (answers_is_speed_extrapolated(
			side[i].entry, side[i].p.speed))
			answer_add_sentence(r, ANSWER_WARNING,
			    "%s is outside the training speeds", side[i].words);
}

/* Shows the basis of both sides, once if it is the same, and the worse of the
 * two lights. */
static void
note_basis_and_trust_of_both_sides(
    const struct session *s, struct answer *r, const struct compared side[2])
{
	bool two = are_compared_sites_different(side);
	bool feeds = two || side[0].p.feed_run != side[1].p.feed_run;
	struct trust light =
	    trust_in_answer_or_fit(s, side[0].entry, &side[0].p);
	trust_replace_if_worse(
	    &light, trust_in_answer_or_fit(s, side[1].entry, &side[1].p));
	correction_note_unless_all(r, s, side[0].entry);
	for (size_t i = 0; i < 2; i++) {
		const struct question q = question_of_whole_product(
		    s, side[i].entry, side[i].p.feed_run);
		const char *whose = feeds ? side[i].words : NULL;
		if (i == 0 || two)
			answers_note_basis_without_trust(
			    s, r, &q, 0, whose, &light);
		else if (feeds)
			feed_add_note_to_answer(
			    r, q.entry->site, q.feed, whose, 0);
	}
	trust_add_to_answer(r, light);
}

/* A pinned prediction is not computed again, so its draws cannot be paired with
 * those of the other side, and the difference has no band. */
static bool
use_pin_as_compared_side(struct session *s, const struct args *args,
    struct compared *side, struct error *error)
{
	const struct pin *pin = s->pin;
	size_t at = 0;
	if (args->cut != NULL)
		return error_set(error, ERROR_USAGE,
		    "compare: expected no cut= with what is pinned, which is "
		    "the whole product\n"
		    "leave out cut=, or write two speeds");
	if (pin == NULL)
		return error_set(error, ERROR_USAGE,
		    "compare: nothing is pinned\n"
		    "'pin speed=74' pins a prediction");
	while (at < s->n_entry && s->entry[at].site != pin->site)
		at++;
	if (at == s->n_entry && !session_find_site(s, pin->key, &at, error))
		return false;
	const struct entry *entry = &s->entry[at];
	side->entry = entry;
	side->p = pin->p;
	side->pinned = true;
	return true;
}

static bool
is_operand_pin(const struct args *args, size_t i)
{
	return strcmp(args->operand[i], PIN) == 0;
}

/* Reads operand i as a loaded site, to predict at speed v with its own feed, or
 * as a speed of the site in use.  Two speeds share one feed.  Beside a pinned
 * prediction the feed is chosen as in predict. */
static bool
parse_compared_side_and_predict(struct session *s, const struct args *args,
    bool sites, double v, size_t i, struct compared *side, struct error *error)
{
	const char *word = args->operand[i];
	if (is_operand_pin(args, i))
		return use_pin_as_compared_side(s, args, side, error);
	size_t at = s->current;
	if (sites && !session_find_site(s, word, &at, error))
		return false;
	if (!sites &&
	    (!value_parse_number(word, "m/s", &v) || v < 1 || v > SITE_FASTEST))
		return error_set(error, ERROR_USAGE,
		    "compare: expected speeds from 1 to %d m/s, got %s",
		    SITE_FASTEST, word);
	const struct question *like = i > 0 ? &side[-1].q : NULL;
	if (!answers_require_params(s, &s->entry[at], error) ||
	    !(like != NULL && like->entry != NULL
		    ? question_repeat_for_site(
			  s, &s->entry[at], args, like, &side->q, error)
		    : question_from_args(
			  s, &s->entry[at], args, &side->q, error)))
		return false;
	side->entry = side->q.entry;
	if (!screened_check_feed_covers(&side->q, error))
		return false;
	side->p = forecast_product(s, &side->q, v);
	return true;
}

/* Names a side by its site, its speed, or both if the site is not enough. */
static char *
name_of_compared_side(
    const struct compared *side, bool sites, bool two, const char *speed)
{
	const char *key = side->entry->key;
	FREED char *words =
	    side->pinned ? xasprintf(tr("pinned %s"), speed) : xstrdup(speed);
	return sites && !side->pinned ? xstrdup(key)
	       : two                  ? xasprintf("%s %s", key, words)
				      : xstrdup(words);
}

/* Names the sides, in headings and in words, by what differs between them. */
static void
set_headings_of_compared_sides(bool sites, struct compared side[2])
{
	bool two = are_compared_sites_different(side);
	for (size_t i = 0; i < 2; i++) {
		const struct site *site = side[i].entry->site;
		double v = side[i].p.speed;
		FREED char *column = answers_speed_text(site, v, -1);
		FREED char *rpm = rotor_speed_rpm_text(site->rotor, v, NAN);
		FREED char *speed = xasprintf("%g m/s%s", v, rpm);
		side[i].head =
		    name_of_compared_side(&side[i], sites, two, column);
		side[i].words =
		    name_of_compared_side(&side[i], sites, two, speed);
	}
}

/* Sets the title of an answer about two sites. */
static void
set_title_of_two_sites(struct answer *r, const struct compared side[2],
    const char *passing, const char *fraction)
{
	const struct site *a = side[0].entry->site, *b = side[1].entry->site;
	FREED char *both = xasprintf("%s, %s", a->name, b->name);
	FREED char *data = provenance_of_compared_sides(side);
	FREED char *rpm = rotor_speed_rpm_text(
	    a->rotor == b->rotor ? a->rotor : 0, side[0].p.speed, NAN);
	if (side[0].p.speed != side[1].p.speed)
		answer_set_title(r, "%s and %s%s%s", side[0].words,
		    side[1].words, passing, fraction);
	else if (a->with[0] != '\0')
		answer_set_title(r, "%s and %s, with %s, at %g m/s%s%s%s",
		    a->name, b->name, a->with, side[0].p.speed, rpm, passing,
		    fraction);
	else
		answer_set_title(r, "%s and %s at %g m/s%s%s%s", a->name,
		    b->name, side[0].p.speed, rpm, passing, fraction);
	answers_put_feed_and_machine(r, a);
	answer_set_site_names(r, both, data);
}

/* Adds the passings, sizes and break sizes of both sides. */
static void
add_compared_sieves_and_sizes(struct answer *r, const struct session *s,
    const struct compared side[2], const double *x, size_t n)
{
	struct forecast *f[2];
	for (size_t i = 0; i < 2; i++)
		f[i] = open_compared_side_forecast(s, &side[i], x, n);
	bool band = f[0] != NULL && f[1] != NULL &&
		    forecast_draws_of_quantity(f[0], n) != NULL &&
		    forecast_draws_of_quantity(f[1], n) != NULL;
	add_passing_comparison_rows(r, side, f, band, x, n);
	if (band)
		answer_add_sentence(r, ANSWER_REMARK,
		    "low, high: the difference lies between them with %.0f %% "
		    "probability",
		    100 * side[0].q.level);
	for (size_t i = 0; i < 2; i++)
		forecast_close(f[i]);
}

/* q [n_q]: the quantities to compare; NULL: compare the whole curves. */
static struct answer *
build_comparison_answer(const struct session *s, const struct compared side[2],
    const struct quantity *q, size_t n_q)
{
	size_t n;
	FREED double *x = merge_sieves_of_compared_sides(side, &n);
	FREED char *fraction =
	    screened_fraction_title_suffix(&side[0].p.fraction);
	const char *passing = q != NULL ? "" : tr(", % passing");
	struct answer *r = are_compared_sites_different(side)
			       ? answer_new("compare")
			       : answer_new_about_site(side[0].entry->site,
				     "compare", "%s and %s%s%s", side[0].words,
				     side[1].words, passing, fraction);
	if (are_compared_sites_different(side))
		set_title_of_two_sites(r, side, passing, fraction);
	if (q != NULL) {
		add_compared_quantity_rows(r, s, side, q, n_q);
	} else {
		add_compared_sieves_and_sizes(r, s, side, x, n);
		note_broken_shares_and_extrapolation(r, side);
	}
	note_basis_and_trust_of_both_sides(s, r, side);
	fields_put_values(answer_json_fields(r), ".speed_a %g .speed_b %g",
	    side[0].p.speed, side[1].p.speed);
	answer_repeat_fields_in_rows(r, "speed_a speed_b");
	fields_put_numbers(
	    answer_json_fields(r), "sieve_mm", x, n, units_m_to_mm);
	for (size_t i = 0; i < 2; i++)
		put_compared_side_fields(
		    answer_json_fields(r), i == 0 ? "a" : "b", &side[i], x, n);
	return r;
}

/* Draws both curves as an image.  The second is the main one, unless it is
 * pinned. */
static bool
draw_compared_curves(
    struct session *s, const struct compared side[2], struct error *error)
{
	const struct compared *one = &side[side[1].pinned ? 0 : 1];
	const struct compared *two = &side[side[1].pinned ? 1 : 0];
	struct plot_request request = plots_default_request(PLOT_PSD);
	request.asked.entry = one->entry;
	request.asked.speed = one->p.speed;
	request.asked.fraction = one->p.fraction;
	request.asked.feed = one->p.feed_run;
	request.made = &one->p;
	request.kept = two->pinned ? &s->pin->p : &two->p;
	if (are_compared_sites_different(side))
		request.beside = two->entry->key;
	request.band = one->p.low != NULL;
	struct chart *chart = plots_make_chart(s, &request, error);
	return chart != NULL && plot_write_image(s, chart, error);
}

/* Reads the quantities of of=, or leaves *q NULL without of=.  The caller frees
 * *q. */
static bool
parse_compared_quantities(const struct args *args,
    const struct compared side[2], struct quantity **q, size_t *n,
    struct error *error)
{
	if (args->of == NULL)
		return true;
	const struct question *like = &side[side[0].pinned].q;
	if (like->entry == NULL)
		return error_set(error, ERROR_USAGE,
		    "compare: expected a speed beside pinned with '%s'\n"
		    "write: compare pinned 74 %s",
		    args->of, args->of);
	*q = quantities_parse_list_for_feed(
	    args->of, &like->fraction, question_feed(like), true, n, error);
	return *q != NULL;
}

bool
cmd_compare(struct session *s, const struct args *args, struct error *error)
{
	struct compared side[2] = {{0}};
	double v, speed = args->speed;
	bool sites = false;
	for (size_t i = 0; i < 2; i++)
		sites = sites ||
			(!is_operand_pin(args, i) &&
			    !value_parse_number(args->operand[i], "m/s", &v));
	if (!sites && args->speed > 0)
		return error_set(error, ERROR_USAGE,
		    "compare: expected no speed= with two speeds\n"
		    "write: compare 69 79, or two sites: compare tierp bro "
		    "speed=74");
	if (sites && !(speed > 0))
		speed = question_last_speed_or_usual(
		    s, answers_default_speed(session_current_site_entry(s)));
	FREED struct quantity *q = NULL;
	size_t n = 0;
	bool ok = parse_compared_side_and_predict(
		      s, args, sites, speed, 0, &side[0], error) &&
		  parse_compared_side_and_predict(
		      s, args, sites, speed, 1, &side[1], error) &&
		  parse_compared_quantities(args, side, &q, &n, error);
	if (ok && plot_is_image_wanted(s)) {
		ok = draw_compared_curves(s, side, error);
	} else if (ok) {
		set_headings_of_compared_sides(sites, side);
		session_show_answer(s, build_comparison_answer(s, side, q, n));
	}
	for (size_t i = 0; i < 2; i++) {
		if (!side[i].pinned)
			prediction_free(&side[i].p);
		question_free(s, &side[i].q);
		free(side[i].head);
		free(side[i].words);
	}
	return ok;
}
