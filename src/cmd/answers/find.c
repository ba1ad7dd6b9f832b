/* find: the tip speed that gives a wanted product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/question.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/envelope.h"
#include "cmd/ask/goals.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/screened.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/outlook.h"
#include "cmd/lang/table.h"
#include "core/answer/predict.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

/* The goal: a value of a quantity, or its maximum or minimum; other conditions
 * that must hold; and the question.  n: number of goals in the call.  search,
 * speed: the result; speed is NAN if none was found.  detail: show more than
 * one speed and its range. */
struct find_request {
	enum { GOAL_VALUE, GOAL_MOST, GOAL_LEAST } kind;
	size_t n;
	struct condition target; /* both limits are the value */
	struct condition_list others;
	const struct question *question;
	struct conditions_search wanted; /* the others, then the target */
	struct speed_search *search;
	double speed;
	bool detail;
};

static void
set_goal_value(struct find_request *goal, struct quantity q, double value)
{
	goal->n++;
	goal->target = (struct condition){q, value, value};
}

/* Reads the goals of the options p20, p50, p80, passing and at. */
static void
parse_goal_options(const struct args *args, const struct fraction *fraction,
    struct find_request *goal)
{
	const double mm[PSD_SIZES] = {args->p20, args->p50, args->p80};
	for (size_t i = 0; i < PSD_SIZES; i++)
		if (mm[i] > 0)
			set_goal_value(goal,
			    (struct quantity){.kind = QUANTITY_SIZE,
				.x = PSD_PASSING[i],
				.fraction = *fraction},
			    mm[i] / 1000);
	if (args_is_given(args, &args->passing))
		set_goal_value(goal,
		    (struct quantity){.kind = QUANTITY_PASSING,
			.x = args->at / 1000,
			.fraction = *fraction},
		    args->passing / 100);
}

static bool
parse_goal_operand(const char *text, const struct fraction *fraction,
    struct find_request *goal, struct error *error)
{
	bool most;
	struct condition c = {.least = NAN, .most = NAN};
	FREED char *meant = conditions_rewrite_superlative(text);
	const char *of =
	    meant == NULL ? conditions_parse_max_or_min(text, &most) : NULL;
	if (of == NULL && !conditions_parse_one(text, fraction, &c, error))
		return false;
	if (of != NULL &&
	    (!quantities_parse_one(
		 of, &fraction->partition, &c.quantity, error) ||
		!quantities_apply_cut_option(&c.quantity, fraction, error)))
		return false;
	if (of == NULL && c.least != c.most) {
		conditions_add(&goal->others, c);
		return true;
	}
	goal->kind = of == NULL ? GOAL_VALUE : most ? GOAL_MOST : GOAL_LEAST;
	set_goal_value(goal, c.quantity, c.least);
	return true;
}

/* Reads an operand, which may be several separated by commas. */
static bool
parse_goal_operands(const char *text, const struct fraction *fraction,
    struct find_request *goal, struct error *error)
{
	for (const char *at = text; *at != '\0';) {
		size_t n = text_length_of_list_item(at);
		FREED char *one = xstrndup(at, n);
		const char *operand = text_trim(one);
		if (*operand != '\0' &&
		    !parse_goal_operand(operand, fraction, goal, error))
			return false;
		at += n + (at[n] != '\0');
	}
	return true;
}

/* Refuses conditions without a goal, and proposes window, or a maximum. */
static bool
error_conditions_without_goal(const struct args *args,
    const struct find_request *goal, struct error *error)
{
	FREED char *all = xstrdup("");
	FREED char *first =
	    quantities_text_to_type(&goal->others.at[0].quantity);
	for (size_t i = 0; i < args->n_operand; i++)
		xappend(&all, " \"%s\"", args->operand[i]);
	return error_set(error, ERROR_USAGE,
	    goal->others.n > 1
		? N_("find: expected a goal, one value or max of a quantity, "
		     "got only conditions\nfor the speeds at which these hold "
		     "write window%s; for the speed that gives most add \"max "
		     "%s\"")
		: N_("find: expected a goal, one value or max of a quantity, "
		     "got only a condition\nfor the speeds at which this holds "
		     "write window%s; for the speed that gives most add \"max "
		     "%s\""),
	    all, first);
}

/* Checks that there is exactly one goal and that it is complete. */
static bool
check_single_goal(const struct args *args, const struct find_request *goal,
    struct error *error)
{
	if (goal->n == 0 && goal->others.n > 0)
		return error_conditions_without_goal(args, goal, error);
	if (goal->n != 1)
		error_set(error, ERROR_USAGE,
		    "find: expected one of p20, p50, p80, passing, spec and a "
		    "condition with = or max, got %zu of them",
		    goal->n);
	else
		return true;
	return error_set_hint(error,
	    "write 'find p80=5', 'find \"passing 2 = 45\" \"passing 0.063 < "
	    "6\"' or 'find spec=NAME'");
}

/* Takes the goal and the conditions from the session's goal, which must contain
 * a single value. */
static bool
parse_session_goal_value(
    struct session *s, struct find_request *goal, struct error *error)
{
	struct condition_list all = {0};
	size_t n_value = 0;
	bool ok = goals_parse(s, s->set.goal, question_feed(goal->question),
	    &all, &n_value, error);
	if (ok && n_value == 0)
		ok = error_set(error, ERROR_USAGE,
		    "the goal %s has no single value\n"
		    "for the speeds at which it is met write: window",
		    s->set.goal);
	if (ok) {
		const struct condition *last = &all.at[all.n - 1];
		set_goal_value(goal, last->quantity, last->least);
		for (size_t i = 0; i + 1 < all.n; i++)
			conditions_add(&goal->others, all.at[i]);
	}
	conditions_free(&all);
	return ok;
}

static bool
parse_goal(struct session *s, const struct args *args,
    struct find_request *goal, struct error *error)
{
	const struct question *q = goal->question;
	const struct psd *feed = question_feed(q);
	const struct fraction *fraction = &q->fraction;
	for (size_t i = 0; i < args->n_operand; i++)
		if (!parse_goal_operands(
			args->operand[i], fraction, goal, error)) {
			error->column = args->column[i];
			return false;
		}
	bool named = goal->n > 0 || args->n_operand > 0;
	if (!named && goals_is_set(s) &&
	    !parse_session_goal_value(s, goal, error))
		return false;
	if (!check_single_goal(args, goal, error) ||
	    !conditions_check_feed_covers(&goal->target, feed, error))
		return false;
	for (size_t i = 0; i < goal->others.n; i++)
		if (!conditions_check_feed_covers(
			&goal->others.at[i], feed, error))
			return false;
	return conditions_add_envelope_option(s, args, q, &goal->others, error);
}

/* Returns the value of the target in the unit that people see. */
static double
target_in_shown_unit(const struct find_request *goal)
{
	return quantities_value_in_shown_unit(
	    &goal->target.quantity, goal->target.least);
}

static double
target_value_at_speed(const struct find_request *goal, double v)
{
	struct forecast *f = goal->wanted.forecast;
	forecast_set_speed(f, v);
	return forecast_value_in_shown_unit(f, goal->wanted.n).value;
}

/* Returns "P80 5 mm", "40 % passing 2 mm" or "the largest passing 2 mm". */
static char *
goal_text(const struct find_request *goal)
{
	const struct quantity *q = &goal->target.quantity;
	char *name = quantities_name(q), *words;
	if (goal->kind != GOAL_VALUE)
		words =
		    xasprintf(goal->kind == GOAL_MOST ? tr("the largest %s")
						      : tr("the smallest %s"),
			name);
	else if (q->kind == QUANTITY_PASSING)
		words = xasprintf("%g %% %s", target_in_shown_unit(goal), name);
	else
		words = conditions_one_text(&goal->target);
	free(name);
	return words;
}

static double
finite_speed_or_nan(double speed)
{
	return speed > 0 && isfinite(speed) ? speed : NAN;
}

static void
put_goal_fields(struct fields *o, const struct find_request *goal)
{
	const struct speed_search *f = goal->search;
	double speed = goal->speed;
	const struct quantity *q = &goal->target.quantity;
	bool passing =
	    q->kind == QUANTITY_PASSING && !fraction_is_screened(&q->fraction);
	bool value = goal->kind == GOAL_VALUE;
	FREED char *key = passing && value ? xstrdup("passing_pct")
					   : quantities_field_name(q);
	FREED char *wanted = xasprintf("%s%s",
	    value                     ? ""
	    : goal->kind == GOAL_MOST ? "max "
				      : "min ",
	    key);
	fields_put_values(o,
	    "wanted %s value %g at_mm %g from %g to %g value_from %g "
	    "value_to %g speed %g",
	    wanted,
	    value ? target_in_shown_unit(goal)
		  : target_value_at_speed(goal, speed),
	    q->kind == QUANTITY_PASSING ? units_m_to_mm(q->x) : NAN,
	    goal->wanted.from, goal->wanted.to,
	    target_value_at_speed(goal, goal->wanted.from),
	    target_value_at_speed(goal, goal->wanted.to), speed);
	fields_put_values(
	    o, "found %s .found_speed %g", isnan(speed) ? "no" : "yes", speed);
	fields_put_values(o,
	    "speed_low %g speed_high %g cut_low %g cut_high %g",
	    finite_speed_or_nan(f->range[0]), finite_speed_or_nan(f->range[1]),
	    finite_speed_or_nan(f->cut[0]), finite_speed_or_nan(f->cut[1]));
}

/* Returns "66.2 to 68.9 m/s (1290 to 1343 rpm)", with "below" or "above" before
 * an end that lies beyond the speeds searched.  The caller frees it. */
static char *
speed_range_text(const struct find_request *goal, const double range[2])
{
	double rotor = goal->wanted.entry->site->rotor;
	bool below = !(range[0] > 0), above = !isfinite(range[1]);
	double from = below ? goal->wanted.from : range[0],
	       to = above ? goal->wanted.to : range[1];
	FREED char *low = xasprintf(below ? tr("below %g") : "%.2f", from);
	FREED char *high = xasprintf(above ? tr("above %g") : "%.2f", to);
	char *words = xasprintf(tr("%s to %s m/s"), low, high);
	if (!(rotor > 0))
		return words;
	FREED char *slow = xasprintf(
	    below ? tr("below %.0f") : "%.0f", rotor_speed_to_rpm(from, rotor));
	FREED char *fast = xasprintf(
	    above ? tr("above %.0f") : "%.0f", rotor_speed_to_rpm(to, rotor));
	xappend(&words, tr(" (%s to %s rpm)"), slow, fast);
	return words;
}

/* Finds the speed that gives the target with the feed of a run.  Returns 0 or
 * INFINITY if it lies below or above the speeds searched, and NAN if that
 * feed's curves do not reach the quantity. */
static double
find_goal_speed_with_feed_of_run(
    const struct session *s, const struct find_request *goal, size_t run)
{
	const double close = 1e-6;
	struct question own = *goal->question;
	own.feed = run;
	struct forecast *f = forecast_open(s, &own, &goal->target.quantity, 1);
	double a = goal->wanted.from, b = goal->wanted.to;
	forecast_set_speed(f, a);
	double slow = forecast_excess_over_limit(f, 0, goal->target.least);
	forecast_set_speed(f, b);
	double fast = forecast_excess_over_limit(f, 0, goal->target.least);
	bool rises = fast > slow, known = !isnan(slow) && !isnan(fast);
	bool within = (slow >= 0) != (fast >= 0);
	while (within && b - a > close) {
		double v = (a + b) / 2;
		forecast_set_speed(f, v);
		bool over =
		    forecast_excess_over_limit(f, 0, goal->target.least) >= 0;
		*(over == rises ? &b : &a) = v;
	}
	forecast_close(f);
	if (!known || within)
		return known ? b : NAN;
	return (slow >= 0) == rises ? 0 : INFINITY;
}

/* Notes the range of the speed over the sampled feeds, used one at a time
 * instead of their mean.  Only for quantities that rise or fall with the speed
 * throughout, as the product becomes finer. */
static void
note_speed_range_over_feeds(
    struct answer *r, const struct session *s, const struct find_request *goal)
{
	const double tells = 0.05;
	const struct question *q = goal->question;
	const struct quantity *of = &goal->target.quantity;
	double range[2] = {goal->speed, goal->speed};
	const struct site *site = q->entry->site;
	bool other = site_run_at_speed(site, SITE_OTHER_FEED) < site->n_run;
	if (!site->individual_feeds || other || q->feed != SITE_MEAN_FEED ||
	    quantity_sign_if_finer(of) == 0)
		return;
	for (size_t run = 0; run < site->n_run; run++) {
		if (site->run[run].lacks_feed)
			continue;
		double v = find_goal_speed_with_feed_of_run(s, goal, run);
		range[0] = fmin(range[0], v);
		range[1] = fmax(range[1], v);
	}
	fields_put_values(answer_json_fields(r), "feeds_low %g feeds_high %g",
	    finite_speed_or_nan(range[0]), finite_speed_or_nan(range[1]));
	if (range[1] - range[0] < tells || !goal->detail)
		return;
	FREED char *words = speed_range_text(goal, range);
	answer_note(r,
	    "with each sampled feed instead of their mean the speed would be "
	    "from %s",
	    words);
}

/* Notes the speed found, its range, the speeds at which a belt cut may show the
 * value, and other speeds that give it too. */
static void
note_speed_found(
    struct answer *r, const struct find_request *goal, const char *words)
{
	const struct speed_search *f = goal->search;
	const struct site *site = goal->wanted.entry->site;
	FREED char *rpm = rotor_speed_rpm_text(site->rotor, f->found, NAN);
	if (isnan(f->range[0])) {
		answer_note(r, "%s at %.2f m/s%s", words, f->found, rpm);
	} else {
		FREED char *range = speed_range_text(goal, f->range);
		FREED char *cut = speed_range_text(goal, f->cut);
		answer_note(r,
		    "%s at %.2f m/s%s; %.0f %% range: %s; a belt cut may show "
		    "it from %s",
		    words, f->found, rpm, 100 * goal->wanted.level, range, cut);
	}
	if (!isnan(f->range[0]))
		conditions_note_unsearched_speeds(r, &goal->wanted,
		    !(f->range[0] > 0), !isfinite(f->range[1]));
	for (size_t i = 0; i < f->n_root; i++) {
		double v = f->root[i].speed;
		FREED char *turns = rotor_speed_rpm_text(site->rotor, v, NAN);
		if (v != f->found)
			answer_note(r, "also at %.2f m/s%s%s", v, turns,
			    answers_is_speed_extrapolated(
				goal->question->entry, v)
				? tr(", extrapolated")
				: "");
	}
}

/* Returns "passing 2 mm 36.0 % (35.2 to 36.9)", or "P20 beyond the sieves", at
 * the speed of the forecast.  The caller frees the words. */
static char *
value_with_band_text(const struct find_request *goal, size_t i)
{
	const struct quantity *q = i < goal->wanted.n
				       ? &goal->wanted.at[i].quantity
				       : &goal->target.quantity;
	int digits = quantities_decimals(q);
	struct figure f =
	    forecast_value_in_shown_unit(goal->wanted.forecast, i);
	FREED char *name = quantities_name(q);
	if (isnan(f.value))
		return xasprintf(tr("%s beyond the sieves"), name);
	FREED char *band = quantities_band_text(f.low, f.high, digits);
	return xasprintf("%s %.*f%s%s", name, digits, f.value,
	    quantities_unit_suffix(q), band);
}

/* Names the speeds of the search at which the quantity cannot be read, if the
 * extreme may lie there: a size is then smaller than any that can be. */
static void
note_speeds_beyond_sieves(struct answer *r, const struct find_request *goal)
{
	const struct speed_search *f = goal->search;
	double from = NAN, to = NAN;
	for (size_t k = 0; k < f->n; k++) {
		if (!isnan(f->value[k]))
			continue;
		from = isnan(from) ? f->speed[k] : from;
		to = f->speed[k];
	}
	FREED char *name = quantities_name(&goal->target.quantity);
	FREED char *rpm =
	    rotor_speed_rpm_text(goal->wanted.entry->site->rotor, from, to);
	bool small = goal->target.quantity.kind == QUANTITY_SIZE;
	if (!isnan(from) && !(small && goal->kind == GOAL_MOST))
		answer_add_sentence(r, ANSWER_WARNING,
		    "from %.1f to %.1f m/s%s %s is beyond the sieves: these "
		    "speeds are left out",
		    from, to, rpm, name);
}

/* Notes the extreme value and what limits it: a condition, or the end of the
 * speeds searched. */
static void
note_largest_or_least_value(struct answer *r, const struct find_request *goal)
{
	const double near = 1e-3;
	const struct speed_search *f = goal->search;
	double v = goal->speed;
	bool most = goal->kind == GOAL_MOST;
	forecast_set_speed(goal->wanted.forecast, v);
	char *words = value_with_band_text(goal, goal->wanted.n);
	FREED char *rpm =
	    rotor_speed_rpm_text(goal->wanted.entry->site->rotor, v, NAN);
	answer_note(r, "%s at %.2f m/s%s: %s",
	    most ? tr("largest") : tr("least"), v, rpm, words);
	free(words);
	note_speeds_beyond_sieves(r, goal);
	struct wanted_limit binds = {SIZE_MAX, false};
	for (size_t k = 0; k < f->n_inside; k++) {
		const struct speed_range *in = &f->inside[k];
		if (fabs(in->from - v) < near)
			binds = in->low;
		if (fabs(in->to - v) < near)
			binds = in->high;
	}
	if (binds.i != SIZE_MAX) {
		words = conditions_limit_text(goal->others.at, binds);
		answer_note(r, "limited by: %s", words);
		free(words);
	} else {
		conditions_note_unsearched_speeds(r, &goal->wanted,
		    v - goal->wanted.from < near, goal->wanted.to - v < near);
	}
}

/* Notes the best speed at which the conditions hold with the probability of the
 * bands.  At the speed where a limit is just met, they hold with a probability
 * of only a half. */
static void
note_best_speed_with_certainty(
    struct answer *r, const struct find_request *goal)
{
	double level = 100 * goal->wanted.level;
	double v = speed_search_speed_of_max_or_min(
	    goal->search, goal->kind == GOAL_MOST, true);
	if (isnan(v)) {
		answer_note(r,
		    "at no speed do the conditions hold with %.0f %% certainty",
		    level);
		return;
	}
	forecast_set_speed(goal->wanted.forecast, v);
	FREED char *words = value_with_band_text(goal, goal->wanted.n);
	FREED char *rpm =
	    rotor_speed_rpm_text(goal->wanted.entry->site->rotor, v, NAN);
	answer_note(r, "with %.0f %% certainty at %.2f m/s%s: %s", level, v,
	    rpm, words);
}

static void
note_verdict_on_condition(
    struct answer *r, const struct find_request *goal, size_t i)
{
	const struct condition *c = &goal->wanted.at[i];
	bool points = quantities_unit(&c->quantity)[0] == '%';
	FREED char *words = conditions_one_text(c),
		   *value = value_with_band_text(goal, i);
	double missed = -100 * condition_margin(&goal->wanted, i).passing;
	if (conditions_are_met(&goal->wanted, i))
		answer_note(r, "%s: met, %s", words, value);
	else if (!points)
		answer_note(r, "%s: missed: %s", words, value);
	else
		answer_note(r, "%s: missed by %.*f points, %s", words,
		    conditions_decimals_of_miss(missed), missed, value);
}

/* Notes whether each condition holds at the speed found, and with what
 * certainty they all do. */
static void
note_verdict_on_all_conditions(
    struct answer *r, const struct find_request *goal)
{
	double v = goal->speed;
	forecast_set_speed(goal->wanted.forecast, v);
	for (size_t i = 0; i < goal->wanted.n; i++)
		note_verdict_on_condition(r, goal, i);
	double certain = conditions_probability(&goal->wanted);
	fields_put_number(
	    answer_json_fields(r), "certainty_pct", 100 * certain);
	if (isnan(certain))
		return;
	FREED char *words = conditions_probability_text(certain);
	FREED char *rpm =
	    rotor_speed_rpm_text(goal->wanted.entry->site->rotor, v, NAN);
	answer_note(r,
	    goal->wanted.n > 1
		? N_("at %.2f m/s%s these conditions hold with %s certainty")
		: N_("at %.2f m/s%s this condition holds with %s certainty"),
	    v, rpm, words);
	if (goal->kind != GOAL_VALUE && certain < goal->wanted.level)
		note_best_speed_with_certainty(r, goal);
}

/* For a search that found nothing, returns the speed that comes nearest: the
 * one that misses the conditions by the least or, if the goal is a value, an
 * end of the range searched. */
static double
speed_nearest_to_goal(const struct find_request *goal)
{
	const struct conditions_search *w = &goal->wanted;
	double wanted = target_in_shown_unit(goal);
	if (goal->kind != GOAL_VALUE)
		return goal->search->best;
	return fabs(target_value_at_speed(goal, w->to) - wanted) <
		       fabs(target_value_at_speed(goal, w->from) - wanted)
		   ? w->to
		   : w->from;
}

/* If a speed lies beyond the measured ones, notes the value at the nearest
 * measured speed. */
static void
note_value_at_nearest_measured(
    struct answer *r, const struct find_request *goal, double speed)
{
	const struct conditions_search *w = &goal->wanted;
	double near = conditions_nearest_measured_speed(w, speed);
	if (isnan(near))
		return;
	forecast_set_speed(w->forecast, near);
	FREED char *words = value_with_band_text(goal, w->n);
	FREED char *rpm =
	    rotor_speed_rpm_text(w->entry->site->rotor, near, NAN);
	answer_note(r, "the nearest measured speed, %.*f m/s%s, gives %s",
	    units_speed_decimals(near), near, rpm, words);
}

/* Says why no speed gives the value, with the values at both ends of the
 * range. */
static void
note_goal_unattainable(
    struct answer *r, const struct find_request *goal, const char *words)
{
	const struct quantity *q = &goal->target.quantity;
	const struct conditions_search *c = &goal->wanted;
	int rises = quantity_sign_if_finer(q);
	double high = target_value_at_speed(goal, c->to),
	       low = target_value_at_speed(goal, c->from);
	double over =
	    forecast_excess_over_limit(c->forecast, c->n, goal->target.least);
	bool finer = rises > 0 ? over > 0 : over < 0;
	double rotor = c->entry->site->rotor;
	FREED char *rpm = rotor_speed_rpm_text(rotor, c->from, c->to);
	FREED char *slow = rotor_speed_rpm_text(rotor, c->from, NAN);
	FREED char *fast = rotor_speed_rpm_text(rotor, c->to, NAN);
	if (rises != 0)
		answer_note(r,
		    "no speed from %g to %g m/s%s gives %s: the product is "
		    "still %s at %g m/s%s",
		    c->from, c->to, rpm, words,
		    finer ? tr("finer") : tr("coarser"),
		    finer ? c->from : c->to, finer ? slow : fast);
	else
		answer_note(r, "no speed from %g to %g m/s%s gives %s", c->from,
		    c->to, rpm, words);
	const char *unit = quantities_unit_suffix(q);
	if (isfinite(low) && isfinite(high))
		answer_note(r,
		    "it is %.2f%s at %g m/s%s and %.2f%s at %g m/s%s", low,
		    unit, c->from, slow, high, unit, c->to, fast);
	note_value_at_nearest_measured(r, goal, speed_nearest_to_goal(goal));
	if (finer &&
	    conditions_note_feed_too_fine(r, c, &goal->target, rises > 0))
		return;
	if (rises != 0)
		conditions_note_no_reliable_speed(r, c, finer, !finer);
}

static void
note_find_result(struct answer *r, const struct session *s,
    const struct find_request *goal, const char *words)
{
	bool found = !isnan(goal->speed);
	if (!found && goal->kind == GOAL_VALUE) {
		note_goal_unattainable(r, goal, words);
	} else if (!found) {
		conditions_note_why_unmet(r, &goal->wanted, goal->search);
	} else if (goal->kind == GOAL_VALUE) {
		note_speed_found(r, goal, words);
		note_value_at_nearest_measured(r, goal, goal->speed);
		note_speed_range_over_feeds(r, s, goal);
	} else {
		note_largest_or_least_value(r, goal);
		note_value_at_nearest_measured(r, goal, goal->speed);
	}
	if (found && goal->wanted.n > 0)
		note_verdict_on_all_conditions(r, goal);
	conditions_note_source_of_limits(r, &goal->others);
}

static void
put_goal_search_fields(struct fields *o, const struct find_request *goal)
{
	double v = goal->speed;
	put_goal_fields(o, goal);
	if (goal->wanted.n == 0)
		return;
	forecast_set_speed(
	    goal->wanted.forecast, isnan(v) ? goal->search->best : v);
	conditions_put_fields(o, &goal->wanted, goal->search);
	fields_put_values(o, "holds %d",
	    !isnan(v) && conditions_are_met(&goal->wanted, SIZE_MAX));
}

/* Shows the basis and the light of the speed found or, if there is none, of the
 * nearest speed, which is then named.  Returns that speed, for 'why'. */
static double
note_basis_and_trust_at_found_speed(
    struct session *s, struct answer *r, const struct find_request *goal)
{
	const struct question *q = goal->question;
	bool found = !isnan(goal->speed);
	double shown = found ? goal->speed : speed_nearest_to_goal(goal);
	struct trust light = trust_at_speed(s, q->entry, shown, q->feed);
	correction_note_unless_all(r, s, q->entry);
	answers_note_basis_without_trust(
	    s, r, q, found ? shown : 0, NULL, &light);
	trust_add_to_answer_at_speed(
	    r, q->entry->site, found ? 0 : shown, light);
	return shown;
}

/* If no speed was found the title says so, so that nobody takes the rows for
 * the result. */
static struct answer *
begin_find_answer(
    const struct find_request *goal, bool found, const char *words)
{
	const struct site *site = goal->question->entry->site;
	if (found)
		return answer_new_about_site(
		    site, "find", "the speed for %s", words);
	if (goal->kind == GOAL_VALUE)
		return answer_new_about_site(site, "find",
		    "no speed gives %s; at the ends searched", words);
	return answer_new_about_site(site, "find",
	    goal->others.n > 1
		? N_("no speed meets the conditions; at the ends searched")
		: N_("no speed meets the condition; at the ends searched"));
}

/* Says which product the table has where that may be another than the goal's:
 * that of cut=, or the whole product. */
static void
note_which_product_table_shows(struct answer *r,
    const struct find_request *goal, const struct prediction *p, bool found)
{
	FREED char *cut = quantities_fraction_text(&p->fraction);
	if (fraction_is_screened(&p->fraction))
		answer_note(r, "the table is of the fraction %s", cut);
	else if (fraction_is_screened(&goal->target.quantity.fraction))
		answer_note(r, "the table is of the whole product");
	if (fraction_is_screened(&p->fraction))
		fields_put_values(answer_json_fields(r), "fraction %s", cut);
	if (found)
		screened_note_share(r, p);
}

/* Shows the product at the speed found or, if there is none, at both ends of
 * the range. */
static void
show_product_at_goal_speed(struct session *s, const struct find_request *goal)
{
	const struct question *q = goal->question;
	const struct entry *entry = q->entry;
	bool found = !isnan(goal->speed);
	double speed[2] = {
	    found ? goal->speed : goal->wanted.from, goal->wanted.to};
	size_t n = found ? 1 : 2;
	struct prediction p[2];
	for (size_t i = 0; i < n; i++)
		p[i] = forecast_product(s, q, speed[i]);
	session_remove_answers(s);
	FREED char *words = goal_text(goal);
	struct answer *r = begin_find_answer(goal, found, words);
	answers_add_row_per_prediction(r, entry, p, n);
	note_find_result(r, s, goal, words);
	note_which_product_table_shows(r, goal, &p[0], found);
	if (found && goal->detail)
		answers_note_p_sizes(r, &p[0]);
	double shown = note_basis_and_trust_at_found_speed(s, r, goal);
	put_goal_search_fields(answer_json_fields(r), goal);
	answer_repeat_fields_in_rows(r,
	    "fraction wanted value at_mm found found_speed speed_low "
	    "speed_high certainty_pct");
	answers_put_products(s, answer_json_fields(r), entry, p, n);
	session_show_answer(s, r);
	if (found)
		answers_store_newest_prediction(
		    s, entry, &entry->params, &p[0]);
	session_set_last_question(s, shown, &goal->target.quantity);
	s->last_asked.found_by = "find";
	for (size_t i = 0; i < n; i++)
		prediction_free(&p[i]);
}

/* Notes the speeds that meet the envelope, unless the certain speeds already
 * noted are about the same.  If no speed meets it, notes what the nearest one
 * misses. */
static void
note_speeds_meeting_envelope(struct answer *r, const struct find_request *goal,
    const struct grading *g, const struct speed_search *w)
{
	const struct speed_range *in = speed_search_best_range(w);
	const struct site *site = g->conditions.entry->site;
	FREED char *best = rotor_speed_rpm_text(site->rotor, w->best, NAN);
	if (in != NULL) {
		bool all =
		    goal->detail || w->n_inside > 1 || !isfinite(w->sure[0]);
		FREED char *speeds =
		    conditions_met_speeds_text_with_units(&g->conditions, w);
		if (all)
			answer_note(r,
			    g->n_sieve < g->spec->n
				? N_("meets the limits that were checked at %s")
				: N_("meets the envelope at %s"),
			    speeds);
		return;
	}
	FREED char *range = rotor_speed_rpm_text(
	    site->rotor, goal->wanted.from, goal->wanted.to);
	answer_note(r,
	    "no speed from %g to %g m/s%s meets the envelope; the nearest is "
	    "%.1f m/s%s",
	    goal->wanted.from, goal->wanted.to, range, w->best, best);
	FREED char *missed = envelope_missed_limits_text(g);
	answer_note(r, "%s", missed);
}

static bool
show_speeds_for_envelope(struct session *s, const struct args *args,
    const struct find_request *goal, struct error *error)
{
	const struct entry *entry = goal->question->entry;
	const struct spec *spec =
	    envelope_named_or_chosen(s, args->spec, error);
	struct grading g;
	if (spec == NULL || !envelope_open_grading(
				s, args->cut, spec, goal->question, &g, error))
		return false;
	g.conditions.from = goal->wanted.from;
	g.conditions.to = goal->wanted.to;
	struct speed_search *w = speed_search_run(&g.conditions);
	const struct speed_range *in = speed_search_best_range(w);
	double v = w->best;
	FREED char *words = envelope_title_text(&g);
	FREED char *rpm = rotor_speed_rpm_text(entry->site->rotor, v, NAN);
	struct answer *r = answer_new_about_site(
	    entry->site, "find", "%s at %.4g m/s%s", words, v, rpm);
	envelope_add_sieve_rows(r, &g, v);
	conditions_note_best_speed(r, &g.conditions, true, goal->detail, w);
	note_speeds_meeting_envelope(r, goal, &g, w);
	if (forecast_draws_of_quantity(g.conditions.forecast, 0) != NULL)
		answers_put_low_high_field(
		    answer_json_fields(r), "certain", w->sure[0], w->sure[1]);
	envelope_add_notes(r, &g);
	conditions_note_basis_and_trust(r, goal->question, &g.conditions, w, v);
	session_set_last_question(s, v, NULL);
	s->last_asked.found_by = "find";
	fields_put_values(answer_json_fields(r), "wanted %s from %g to %g",
	    "spec", goal->wanted.from, goal->wanted.to);
	envelope_put_inside(r, &g, in != NULL);
	fields_put_values(answer_json_fields(r),
	    "slowest %g fastest %g speed %g best %g",
	    in != NULL ? in->from : NAN, in != NULL ? in->to : NAN, v, w->best);
	envelope_put_worst_sieve(answer_json_fields(r), &g);
	envelope_put_fields(r, &g);
	session_remove_answers(s);
	session_show_answer(s, r);
	speed_search_free(w);
	envelope_close(&g);
	return true;
}

static void
find_goal_speed(const struct session *s, struct find_request *goal)
{
	double from = goal->wanted.from, to = goal->wanted.to;
	goal->wanted = conditions_open_search(
	    s, goal->question, &goal->others, &goal->target);
	goal->wanted.from = from;
	goal->wanted.to = to;
	goal->search = speed_search_run(&goal->wanted);
	goal->speed = goal->kind == GOAL_VALUE
			  ? goal->search->found
			  : speed_search_speed_of_max_or_min(
				goal->search, goal->kind == GOAL_MOST, false);
}

bool
cmd_find(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	struct find_request goal = {
	    .kind = GOAL_VALUE, .question = q, .detail = args->detail};
	if (!conditions_parse_search_range(s, args, q->entry->site,
		&goal.wanted.from, &goal.wanted.to, error))
		return false;
	parse_goal_options(args, &q->fraction, &goal);
	bool named = goal.n > 0 || args->n_operand > 0;
	if (!named && (args->spec != NULL || s->spec != NULL))
		return show_speeds_for_envelope(s, args, &goal, error);
	bool ok = screened_check_feed_covers(q, error) &&
		  parse_goal(s, args, &goal, error);
	if (ok) {
		find_goal_speed(s, &goal);
		show_product_at_goal_speed(s, &goal);
		speed_search_free(goal.search);
		forecast_close(goal.wanted.forecast);
	}
	conditions_free(&goal.others);
	return ok;
}
