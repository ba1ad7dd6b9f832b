/* flow: tonnes per hour, circulating load, power and earnings.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/question.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/outlook.h"
#include "cmd/draw/plot.h"
#include "cmd/plant/plant.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/lang/table.h"
#include "cmd/draw/site_chart.h"
#include "core/posterior/ensemble.h"
#include "core/psd/rotor_speed.h"

enum { DRAWS = POSTERIOR_DRAWS };

/* Sets range to the middle share of the draws, widened to include the answer,
 * or to NAN if there are no draws. */
static void
band_of_draws(const struct plant *p, const struct plant_result *o,
    const double *draw, double answer, double range[static 2])
{
	range[0] = range[1] = NAN;
	if (o->flow.draws == DRAWS)
		ensemble_interval_around_answer(
		    draw, p->question->level, answer, range);
}

/* Sets range to the band of the t/h that enter a unit or, if it is NULL, of the
 * t/h of a stream. */
static void
band_of_inflow_tph(const struct plant *p, const struct plant_result *o,
    const struct unit *unit, size_t stream, double range[static 2])
{
	double draw[DRAWS];
	for (size_t d = 0; d < o->flow.draws; d++)
		draw[d] = unit != NULL
			      ? flow_tph_into_unit_in_draw(&o->flow, unit, d)
			      : o->flow.tph_draw[d * o->flow.n_stream + stream];
	band_of_draws(p, o, draw,
	    unit != NULL ? flow_tph_into_unit(&o->flow, unit)
			 : o->flow.tph[stream],
	    range);
}

static void
add_plant_stream_rows(
    const struct plant *p, const struct plant_result *o, struct answer *r)
{
	const struct circuit *c = p->circuit;
	FREED struct plant_stream_row *line =
	    xcalloc(c->n_stream + c->n_unit, sizeof *line);
	struct fields *list =
	    fields_add_list(answer_json_fields(r), "fractions");
	size_t n = plant_list_streams(p, o, line);
	bool band = o->flow.draws == DRAWS, back = o->flow.circulating > 0;
	answer_add_columns(r, "name: %s, tph: t/h",
	    p->from_file ? "product" : tr("fraction mm"));
	if (band)
		answer_add_columns(r, "low_tph: low, high_tph: high");
	answer_add_columns(r, "share_pct: share %%");
	if (back)
		answer_add_columns(r, "circulating_tph: back t/h");
	for (size_t i = 0; i < n; i++) {
		const struct unit *unit = line[i].unit;
		double range[2] = {0, 0},
		       tph = unit != NULL ? flow_tph_into_unit(&o->flow, unit)
					  : 0,
		       around = unit != NULL ? 0 : o->flow.tph[line[i].stream];
		if (unit != NULL)
			band_of_inflow_tph(p, o, unit, 0, range);
		else if (!band)
			range[0] = range[1] = NAN;
		double share = 100 * tph / c->tph;
		answer_add_cells(r, "%s %.1f", line[i].name, tph);
		if (band)
			answer_add_cells(r, "%.1f %.1f", range[0], range[1]);
		answer_add_cells(r, "%.1f", share);
		if (back)
			answer_add_cells(r, "%.1f", around);
		fields_put_values(fields_add_object(list, NULL),
		    "name %s tph %g share_pct %g low_tph %g high_tph %g "
		    "circulating_tph %g price %g",
		    line[i].name, tph, share, range[0], range[1], around,
		    unit != NULL ? unit->price : NAN);
	}
}

/* Adds all streams, for programs. */
static void
put_circuit_stream_fields(
    const struct plant *p, const struct plant_result *o, struct fields *all)
{
	struct fields *list = fields_add_list(all, "streams");
	for (size_t i = 0; i < p->circuit->n_stream; i++) {
		double range[2];
		band_of_inflow_tph(p, o, NULL, i, range);
		fields_put_values(fields_add_object(list, NULL),
		    "name %s tph %g low_tph %g high_tph %g back %d",
		    p->circuit->stream[i], o->flow.tph[i], range[0], range[1],
		    o->flow.back[i]);
	}
}

/* Notes the circulating load and the mass balance. */
static void
note_mass_balance(
    const struct plant *p, const struct plant_result *o, struct answer *r)
{
	double range[2], tph = p->circuit->tph;
	struct fields *f = answer_json_fields(r);
	band_of_draws(
	    p, o, o->flow.circulating_draw, o->flow.circulating, range);
	FREED char *band = quantities_band_text(range[0], range[1], 1);
	if (o->flow.circulating > 0)
		answer_note(r,
		    "circulating load %.1f t/h%s, %.0f %% of the new feed",
		    o->flow.circulating, band, 100 * o->flow.circulating / tph);
	answer_note(r, "balance: %g t/h in, %g t/h out", tph,
	    round((tph - o->flow.balance) * 1e6) / 1e6);
	fields_put_values(f, "circulating_tph %g balance_tph %g passes %zu",
	    o->flow.circulating, o->flow.balance, o->flow.passes);
	answers_put_low_high_field(
	    f, "circulating_range_tph", range[0], range[1]);
}

/* Notes how much goes through the rotor of each crusher, and how much past
 * it. */
static void
note_flow_through_each_rotor(
    const struct plant *p, const struct plant_result *o, struct answer *r)
{
	struct fields *list =
	    fields_add_list(answer_json_fields(r), "crushers");
	for (size_t u = 0; u < p->circuit->n_unit; u++) {
		const struct unit *unit = &p->circuit->unit[u];
		if (unit->kind != UNIT_CRUSHER)
			continue;
		double all = flow_tph_into_unit(&o->flow, unit),
		       rotor = all * plant_share_through_rotor(p, unit),
		       range[2];
		double speed = plant_speed_of_circuit_unit(unit, o->speed);
		band_of_inflow_tph(p, o, unit, 0, range);
		FREED char *rpm = rotor_speed_rpm_text(
		    p->question->entry->site->rotor, speed, NAN);
		if (all > rotor)
			answer_note(r,
			    "crusher at %.4g m/s%s: %.1f t/h, of which %.1f "
			    "t/h through the rotor and %.1f t/h past it (%s)",
			    speed, rpm, all, rotor, all - rotor,
			    !(unit->cascade > 0) ? tr("fitted bypass")
			    : p->bypass > 0 ? tr("cascade and fitted bypass")
					    : tr("cascade"));
		else
			answer_note(r,
			    "crusher at %.4g m/s%s: %.1f t/h, all through the "
			    "rotor",
			    speed, rpm, all);
		fields_put_values(fields_add_object(list, NULL),
		    "speed %g tph %g low_tph %g high_tph %g rotor_tph %g "
		    "cascade_tph %g",
		    speed, all, range[0], range[1], rotor, all - rotor);
	}
}

/* Makes a reason of readings that no crusher can have.  The sentence about the
 * light names one red reason alone; others are warnings of their own. */
static void
add_red_reason_of_power_readings(
    struct answer *r, struct trust *t, const char *reason)
{
	if (t->light == LIGHT_RED)
		answer_add_sentence(r, ANSWER_WARNING, "%s", reason);
	trust_add_reason(t, LIGHT_RED, TRUST_DATA, xstrdup(reason));
}

static void
check_power_readings(const struct plant *p, struct answer *r, struct trust *t)
{
	if (power_is_falling_with_speed(p->reading, p->n_reading))
		add_red_reason_of_power_readings(r, t,
		    tr("the readings contradict the estimate of power: power "
		       "cannot fall while the speed rises and the t/h do not "
		       "fall; check the readings"));
	if (p->power.below)
		add_red_reason_of_power_readings(r, t,
		    tr("the readings give less power than Q v2, the power that "
		       "brings the rock to the tip speed: check m/s, kW and "
		       "t/h, and whether all of it passes the rotor "
		       "(cascade=)"));
}

static void
note_plant_power(
    const struct plant *p, const struct plant_result *o, struct answer *r)
{
	double range[2] = {NAN, NAN}, idle[2], factor = 0, t = p->circuit->tph;
	FREED char *words = plant_power_basis_text(p, o);
	struct fields *f = answer_json_fields(r);
	if (!p->power.least)
		ensemble_interval_around_answer(
		    o->kw_draw, p->question->level, o->kw, range);
	for (size_t d = 0; d < POWER_DRAWS; d++)
		factor += p->power.draw[d].factor / POWER_DRAWS;
	if (isfinite(range[0]))
		answer_note(r, "power %.0f kW (%.0f to %.0f), %.2f kWh/t: %s",
		    o->kw, range[0], range[1], o->kw / t, words);
	else
		answer_note(r,
		    "power at least %.0f kW, %.2f kWh/t, no band: %s", o->kw,
		    o->kw / t, words);
	fields_put_values(f,
	    "power_kw %g power_low_kw %g power_high_kw %g kwh_per_t %g "
	    "power_from %s readings %zu idle_kw %g euler_factor %g",
	    o->kw, range[0], range[1], o->kw / t,
	    p->power.n > 0 ? "readings" : "Q v2", p->power.n,
	    plant_idle_power(p, o->speed, idle), factor);
	answers_put_low_high_field(f, "idle_range_kw", idle[0], idle[1]);
}

/* Notes the earnings; a product without a price adds nothing to them. */
static void
note_earnings(
    const struct plant *p, const struct plant_result *o, struct answer *r)
{
	double range[2];
	if (!p->priced)
		return;
	FREED char *none = xstrdup("");
	band_of_draws(p, o, o->money_draw, o->money, range);
	for (size_t u = 0; u < p->circuit->n_unit; u++) {
		const struct unit *unit = &p->circuit->unit[u];
		if (unit->kind == UNIT_STOCKPILE && isnan(unit->price))
			xappend_to_list(&none, ", ", "%s", unit->name);
	}
	FREED char *band = quantities_band_text(range[0], range[1], 2);
	FREED char *fixed = plant_fixed_speeds_text(p, NULL);
	FREED char *rpm = rotor_speed_rpm_text(
	    p->question->entry->site->rotor, o->speed, NAN);
	FREED char *speed =
	    fixed != NULL ? xstrdup(fixed) : xasprintf("%.4g", o->speed);
	answer_note(r,
	    !(p->kwh > 0) ? N_("earnings %.2f an hour%s at %s m/s%s")
	    : !p->power.least
		? N_("earnings %.2f an hour%s at %s m/s%s, less the power")
		: N_("earnings %.2f an hour%s at %s m/s%s, less the lowest "
		     "possible power"),
	    o->money, band, speed, fixed != NULL ? "" : rpm);
	if (none[0] != '\0')
		answer_add_sentence(
		    r, ANSWER_REMARK, "no price, counted as 0: %s", none);
	fields_put_values(answer_json_fields(r),
	    "earnings %g earnings_low %g earnings_high %g", o->money, range[0],
	    range[1]);
}

/* The speeds tried, m/s, and what each earns per hour, on average (NAN if the
 * circuit has no steady state) and in each draw.  best: index of the speed that
 * earns most. */
enum { COARSE = 20, FINE = 10, SPEEDS_TRIED = COARSE + 1 + FINE };
struct speed_trials {
	size_t n, best;
	double from, to, step, speed[SPEEDS_TRIED], money[SPEEDS_TRIED];
	double (*draw)[DRAWS];
};

static void
add_earnings_trial_at_speed(
    struct speed_trials *search, const struct plant *p, double speed)
{
	struct plant_result o = plant_compute_flow_at_speed(p, speed);
	size_t i = search->n++;
	search->speed[i] = speed;
	search->money[i] = o.flow.open ? NAN : o.money;
	memcpy(search->draw[i], o.money_draw, sizeof o.money_draw);
	flow_free(&o.flow);
	if (isnan(search->money[search->best]) ||
	    search->money[i] > search->money[search->best])
		search->best = i;
}

/* Tries speeds over the whole range, then in tenths of a step around the
 * best. */
static struct speed_trials
search_best_earning_speed(const struct plant *p, double from, double to)
{
	struct speed_trials s = {.from = from,
	    .to = to,
	    .step = (to - from) / COARSE,
	    .draw = xcalloc(SPEEDS_TRIED, sizeof *s.draw)};
	for (int i = 0; i <= COARSE; i++)
		add_earnings_trial_at_speed(
		    &s, p, i < COARSE ? from + i * s.step : to);
	double middle = s.speed[s.best];
	for (int i = -FINE / 2; i <= FINE / 2 && isfinite(s.money[s.best]);
	     i++) {
		double speed = middle + i * s.step / FINE;
		if (i != 0 && speed >= from && speed <= to)
			add_earnings_trial_at_speed(&s, p, speed);
	}
	return s;
}

/* Sets range to the band of the speed that earns most, see band_of_draws. */
static void
band_of_best_earning_speed(const struct plant *p, const struct speed_trials *s,
    const struct plant_result *o, double range[static 2])
{
	double best[DRAWS];
	for (size_t d = 0; d < DRAWS; d++) {
		size_t at = s->best;
		for (size_t i = 0; i < s->n; i++)
			if (isfinite(s->money[i]) &&
			    s->draw[i][d] > s->draw[at][d])
				at = i;
		best[d] = s->speed[at];
	}
	band_of_draws(p, o, best, s->speed[s->best], range);
}

/* Notes what the best speed gains over the usual one, and whether the gain
 * exceeds its uncertainty. */
static void
note_gain_of_best_over_usual(const struct plant *p,
    const struct plant_result *best, const struct plant_result *usual,
    struct answer *r)
{
	double draw[DRAWS], gain = best->money - usual->money, range[2];
	for (size_t d = 0; d < best->flow.draws; d++)
		draw[d] = best->money_draw[d] - usual->money_draw[d];
	band_of_draws(p, best, draw, gain, range);
	fields_put_values(answer_json_fields(r),
	    "compared_speed %g compared_earnings %g gain %g gain_low %g "
	    "gain_high %g",
	    usual->speed, usual->money, gain, range[0], range[1]);
	FREED char *rpm = rotor_speed_rpm_text(
	    p->question->entry->site->rotor, usual->speed, NAN);
	if (isnan(range[0])) {
		answer_note(r, "%.2f an hour more than at %.4g m/s%s, no band",
		    gain, usual->speed, rpm);
		return;
	}
	answer_note(r, "%.2f an hour more (%.2f to %.2f) than at %.4g m/s%s",
	    gain, range[0], range[1], usual->speed, rpm);
	double own[2];
	band_of_draws(p, best, best->money_draw, best->money, own);
	if (range[0] < 0)
		answer_add_sentence(r, ANSWER_WARNING,
		    "the gain is not certain: it may be a loss");
	else if (own[1] - own[0] > gain)
		answer_add_sentence(r, ANSWER_REMARK,
		    "the band of the earnings, %.2f wide, is wider than the "
		    "gain: what both speeds earn is less certain than which "
		    "earns more",
		    own[1] - own[0]);
}

static void
note_best_earning_speed(const struct plant *p, const struct speed_trials *s,
    const struct plant_result *best, struct answer *r)
{
	double range[2], v = s->speed[s->best];
	size_t open = 0;
	bool end = v <= s->from || v >= s->to;
	FREED char *rpm =
	    rotor_speed_rpm_text(p->question->entry->site->rotor, v, NAN);
	band_of_best_earning_speed(p, s, best, range);
	for (size_t i = 0; i < s->n; i++)
		open += isnan(s->money[i]) ? 1 : 0;
	FREED char *band = quantities_band_text(range[0], range[1], 1);
	answer_note(r,
	    end ? N_("best speed %.1f m/s%s%s, at the end of the range from %g "
		     "to %g m/s")
		: N_("best speed %.1f m/s%s%s in the range from %g to %g m/s"),
	    v, rpm, band[0] != '\0' ? band : tr(" (no band)"), s->from, s->to);
	if (open > 0)
		answer_add_sentence(r, ANSWER_REMARK,
		    "at %zu of %zu speeds there is no steady state", open,
		    s->n);
	fields_put_values(answer_json_fields(r), "best_speed %g from %g to %g",
	    v, s->from, s->to);
	answers_put_low_high_field(
	    answer_json_fields(r), "best_speed_range", range[0], range[1]);
}

/* Returns the largest difference in passing, 0..1, between what enters a
 * crusher and the feed of the site. */
static double
largest_inflow_difference_from_feed(const struct plant *p,
    const struct plant_result *o, const struct unit *unit)
{
	size_t n = p->n;
	double most = 0, in = 0, feed = 0,
	       all = flow_tph_into_unit(&o->flow, unit);
	for (size_t i = n; i-- > 0 && all > 0;) {
		for (size_t k = 0; k < unit->n_in; k++)
			in += o->flow.mass[unit->in[k] * n + i] / all;
		feed += p->feed[i];
		most = fmax(most, fabs(in - feed));
	}
	return most;
}

/* Returns the worst light of the crushers at their speeds.  Recycled material
 * changes the feed of a crusher, which counts as for any other feed. */
static struct trust
worst_trust_of_crushers(const struct plant *p, const struct plant_result *o)
{
	const double other = 0.1, strange = 0.3;
	struct trust worst = {0};
	const struct entry *entry = p->question->entry;
	for (size_t u = 0; u < p->circuit->n_unit; u++) {
		const struct unit *unit = &p->circuit->unit[u];
		if (unit->kind != UNIT_CRUSHER)
			continue;
		struct trust t = trust_at_speed(p->s, entry,
		    plant_speed_of_circuit_unit(unit, o->speed),
		    p->question->feed);
		double off = largest_inflow_difference_from_feed(p, o, unit);
		if (off > other)
			trust_add_reason(&t,
			    off > strange ? LIGHT_RED : LIGHT_AMBER, TRUST_FEED,
			    xasprintf(
				tr("what goes into the crusher differs by "
				   "up to %.0f points from the site's "
				   "feed: it may break differently"),
				100 * off));
		trust_replace_if_worse(&worst, t);
	}
	return worst;
}

static bool
is_any_crusher_extrapolated(const struct plant *p, const struct plant_result *o)
{
	bool is = false;
	for (size_t u = 0; u < p->circuit->n_unit; u++) {
		const struct unit *unit = &p->circuit->unit[u];
		double speed = plant_speed_of_circuit_unit(unit, o->speed);
		is = is || (unit->kind == UNIT_CRUSHER &&
			       answers_is_speed_extrapolated(
				   p->question->entry, speed));
	}
	return is;
}

static struct answer *
begin_flow_answer(const struct plant *p, const struct plant_result *o)
{
	const struct entry *entry = p->question->entry;
	const char *back = p->back != NULL ? p->back : "";
	FREED char *what =
	    p->from_file
		? xstrdup(p->circuit->name[0] != '\0' ? p->circuit->name
						      : tr("circuit of a file"))
	    : back[0] != '\0' ? xasprintf(tr("%s back to the crusher"), back)
			      : xstrdup(tr("nothing goes back"));
	FREED char *fixed = plant_fixed_speeds_text(p, NULL),
		   *speed = fixed != NULL ? xstrdup(fixed)
					  : xasprintf("%.4g", o->speed);
	FREED char *rpm =
	    fixed != NULL
		? xstrdup("")
		: rotor_speed_rpm_text(entry->site->rotor, o->speed, NAN);
	struct answer *r = answer_new_about_site(entry->site, "flow",
	    "%g t/h at %s m/s%s%s%s", p->circuit->tph, speed, rpm,
	    p->from_file || back[0] != '\0' ? ", " : "",
	    p->from_file || back[0] != '\0' ? what : "");
	fields_put_values(answer_json_fields(r),
	    "speed %g extrapolated %d feed_tph %g circuit %s",
	    fixed != NULL ? NAN : o->speed, is_any_crusher_extrapolated(p, o),
	    p->circuit->tph, what);
	answer_repeat_fields_in_rows(
	    r, "speed feed_tph power_kw kwh_per_t earnings best_speed gain");
	add_plant_stream_rows(p, o, r);
	note_mass_balance(p, o, r);
	note_flow_through_each_rotor(p, o, r);
	note_plant_power(p, o, r);
	note_earnings(p, o, r);
	return r;
}

/* Adds the streams to the fields, and the basis of the answer. */
static void
add_streams_basis_and_trust(
    const struct plant *p, const struct plant_result *o, struct answer *r)
{
	const struct entry *entry = p->question->entry;
	put_circuit_stream_fields(p, o, answer_json_fields(r));
	bool band = o->flow.draws == DRAWS;
	if (!band)
		answer_add_sentence(
		    r, ANSWER_REMARK, "%s", band_why_missing(p->s, entry));
	if (p->s->set.model.method == METHOD_CLASSES)
		answer_add_sentence(r, ANSWER_REMARK,
		    "method classes takes the classes of the screens here, "
		    "which are finer than those of predict");
	fields_put_values(
	    answer_json_fields(r), "level %g", 100 * p->question->level);
	struct trust trust = worst_trust_of_crushers(p, o);
	check_power_readings(p, r, &trust);
	answers_note_basis_and_trust(p->s, r, p->question, 0, band, trust);
}

/* Shows the answer, or only keeps it if it is drawn as an image. */
static void
show_flow_answer(const struct plant *p, struct answer *r)
{
	if (!plot_is_image_wanted(p->s) || p->s->document != NULL)
		session_show_answer(p->s, r);
	else
		session_store_newest_answer(p->s, r);
}

static bool
show_best_earning_speed(
    const struct plant *p, const struct args *args, struct error *error)
{
	const struct entry *entry = p->question->entry;
	double from, to;
	if (!p->priced)
		return error_set(error, ERROR_USAGE,
		    "best=on needs prices\n"
		    "write: flow tph=120 prices=0/2:12,2/5:9 best=on");
	if (!conditions_parse_search_range(
		p->s, args, entry->site, &from, &to, error))
		return false;
	struct speed_trials search = search_best_earning_speed(p, from, to);
	struct plant_result usual = plant_compute_flow_at_speed(
				p, p->question->speed),
			    best = plant_compute_flow_at_speed(
				p, search.speed[search.best]);
	bool ok =
	    !best.flow.open || plant_set_error_not_steady(p, &best, error);
	if (ok) {
		struct answer *r = begin_flow_answer(p, &best);
		note_best_earning_speed(p, &search, &best, r);
		if (!usual.flow.open)
			note_gain_of_best_over_usual(p, &best, &usual, r);
		add_streams_basis_and_trust(p, &best, r);
		show_flow_answer(p, r);
	}
	flow_free(&usual.flow);
	flow_free(&best.flow);
	free(search.draw);
	return ok;
}

static bool
show_flow_at_speed(const struct plant *p, double speed, struct error *error)
{
	struct plant_result o = plant_compute_flow_at_speed(p, speed);
	bool ok = !o.flow.open || plant_set_error_not_steady(p, &o, error);
	if (ok) {
		struct answer *r = begin_flow_answer(p, &o);
		add_streams_basis_and_trust(p, &o, r);
		show_flow_answer(p, r);
	}
	flow_free(&o.flow);
	return ok;
}

/* Points of the curves: few, because each solves the circuit for all draws. */
enum { POINTS = 21 };

/* Adds a series for each product, in the order of the table, which is the same
 * at all speeds.  Sets unit to their units, and returns their number. */
static size_t
add_flow_product_series(struct chart *chart, const struct plant *p,
    const struct plant_result *o, const struct unit **unit)
{
	const struct circuit *c = p->circuit;
	FREED struct plant_stream_row *line =
	    xcalloc(c->n_stream + c->n_unit, sizeof *line);
	size_t n = plant_list_streams(p, o, line), products = 0;
	for (size_t i = 0; i < n; i++) {
		if (line[i].unit == NULL)
			continue;
		struct chart_series look = site_chart_series_style(products);
		look.line = CHART_SOLID;
		chart_append_series(chart, look, POINTS, "%s", line[i].name);
		unit[products++] = line[i].unit;
	}
	return products;
}

static struct figure
tph_of_product(const struct plant *p, const struct plant_result *o,
    const struct unit *unit)
{
	double range[2];
	if (o->flow.open)
		return (struct figure){NAN, NAN, NAN};
	band_of_inflow_tph(p, o, unit, 0, range);
	return (struct figure){
	    flow_tph_into_unit(&o->flow, unit), range[0], range[1]};
}

/* Returns a chart with a line and a band for each product, t/h, at speeds
 * from..to, m/s, with gaps where the circuit has no steady state.  The caller
 * frees it with chart_free. */
static struct chart *
chart_of_flow_against_speed(const struct plant *p, double from, double to)
{
	const struct circuit *c = p->circuit;
	struct chart *chart = site_chart_new(p->question->entry->site,
	    axis_new_linear(tr("tip speed, m/s"), from, to),
	    axis_new_linear("t/h", 0, c->tph),
	    "products of %g t/h against speed", c->tph);
	FREED const struct unit **unit =
	    xcalloc(c->n_stream + c->n_unit, sizeof *unit);
	size_t n = 0;
	for (size_t k = 0; k < POINTS; k++) {
		double v = from + (to - from) * (double)k / (POINTS - 1);
		struct plant_result o = plant_compute_flow_at_speed(p, v);
		if (k == 0)
			n = add_flow_product_series(chart, p, &o, unit);
		for (size_t i = 0; i < n; i++)
			site_chart_set_point_with_band(chart->series[i], k,
			    o.speed, tph_of_product(p, &o, unit[i]));
		flow_free(&o.flow);
	}
	for (size_t i = 0; i < n; i++)
		site_chart_close_band_at_gaps(chart->series[i]);
	if (n > 0 && chart->series[0]->low != NULL)
		chart_add_note(chart, "band: %.0f %% uncertainty",
		    100 * p->question->level);
	/* The light at the middle speed, where it is at its best. */
	FREED char *light = trust_in_words_at_speed(
	    p->s, p->question->entry, (from + to) / 2, p->question->feed);
	chart_add_note(chart, "%s", light);
	site_chart_show_speeds_in_rpm(chart, p->question->entry->site);
	return chart;
}

/* Refuses options on speeds and best=on where the crushers have the speeds
 * `fixed`. */
static bool
check_speed_not_given_if_fixed(
    const struct args *args, const char *fixed, struct error *error)
{
	const void *const of_speed[] = {
	    &args->speed, &args->rpm, &args->from, &args->to};
	FREED char *given = args->best ? xstrdup("best=on") : NULL;
	for (size_t i = 0; i < ARRAY_LEN(of_speed) && given == NULL; i++)
		if (args_is_given(args, of_speed[i]))
			given = xasprintf(
			    "%s=", args_option_name(args, of_speed[i]));
	if (given == NULL)
		return true;
	return error_set(error, ERROR_USAGE,
	    "%s changes nothing: each crusher of %s has a speed of its own, "
	    "%s m/s\nleave out speed= of a crusher in that file",
	    given, args->circuit, fixed);
}

bool
cmd_flow(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	struct plant p;
	question_use_last_speed_and_feed(s, args, q);
	if (!plant_from_args(s, args, q, &p, error))
		return false;
	double speed = q->speed;
	FREED char *fixed = plant_fixed_speeds_text(&p, &speed);
	bool ok =
	    fixed == NULL || check_speed_not_given_if_fixed(args, fixed, error);
	ok = ok && (args->best ? show_best_earning_speed(&p, args, error)
			       : show_flow_at_speed(&p,
				     fixed != NULL ? speed : q->speed, error));
	if (ok && plot_is_image_wanted(s) && s->document == NULL) {
		double from, to;
		ok = conditions_parse_search_range(
			 s, args, q->entry->site, &from, &to, error) &&
		     plot_write_image(
			 s, chart_of_flow_against_speed(&p, from, to), error);
	}
	plant_free(&p);
	return ok;
}
