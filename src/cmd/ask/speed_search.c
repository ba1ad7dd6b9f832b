/* Computes margins at every tenth of a m/s, and then reads ranges, roots and
 * the best speed off that table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/speed_search.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/ask/quantity_words.h"
#include "core/check/trust.h"
#include "core/posterior/ensemble.h"

enum { DRAWS = POSTERIOR_DRAWS };

/* A limit counts as met if it is missed by no more than rounding errors. */
static const double EXACT = 1e-9;

/* What is shown as 100.0 % or 0.0 % counts as 100 or 0 %. */
static const double ROUNDS = 5e-4;

/* Margins are divided by no narrower band than this passing, the rounding of
 * sheets. */
static const double NARROW = 1e-3;

/* Two shares of the draws that differ by less may do so by chance. */
static const double CHANCE = 0.02;

/* More than any two speeds are apart, m/s. */
static const double FAR = 1e3;

/* The probability required of the slowest safe speed, which is chosen to save
 * energy and wear. */
static const double SAFE = 0.95;

static const struct wanted_limit NONE = {SIZE_MAX, false};
static const struct margin NO_LIMIT = {INFINITY, INFINITY, {SIZE_MAX, false}};

void
conditions_add(struct condition_list *list, struct condition condition)
{
	list->at = xrealloc(list->at, list->n + 1, sizeof *list->at);
	list->at[list->n++] = condition;
}

void
conditions_free(struct condition_list *list)
{
	free(list->at);
	free(list->source);
	*list = (struct condition_list){0};
}

struct conditions_search
conditions_search_from_question(const struct session *s,
    const struct question *q, size_t n, const struct condition *at,
    size_t n_more, const struct quantity *more)
{
	FREED struct quantity *asked = xcalloc(n + n_more, sizeof *asked);
	for (size_t i = 0; i < n; i++)
		asked[i] = at[i].quantity;
	for (size_t i = 0; i < n_more; i++)
		asked[n + i] = more[i];
	struct conditions_search w = {.s = s,
	    .entry = q->entry,
	    .feed = q->feed,
	    .level = q->level,
	    .n = n,
	    .at = at,
	    .forecast = forecast_open(s, q, asked, n + n_more)};
	settings_default_speed_range(&s->set, q->entry->site, &w.from, &w.to);
	bool known = origin_training_speed_range(
	    q->entry, &w.measured[0], &w.measured[1]);
	if (!known)
		w.measured[0] = w.measured[1] =
		    site_middle_speed(q->entry->site);
	w.reach = known
		      ? trust_reach_beyond_speeds(w.measured[0], w.measured[1])
		      : INFINITY;
	return w;
}

/* Returns a number that ranks margins.  A missed limit ranks below all that
 * hold, by the points by which it is missed: a wide band does not make a miss
 * smaller. */
static double
margin_rank(struct margin m)
{
	double room = isnan(m.widths) ? m.passing : m.widths;
	return m.passing < -EXACT ? m.passing : fmax(room, 0);
}

/* Returns the smaller of two margins, of which one may have no limit. */
static struct margin
lesser_margin(struct margin least, struct margin m)
{
	bool none = least.limit.i == SIZE_MAX;
	if (m.limit.i != SIZE_MAX &&
	    (none || margin_rank(m) < margin_rank(least)))
		return m;
	return least;
}

/* Returns the distance left to a limit, for a value that is above it by `over`.
 * tight: no value lies beyond the limit. */
static double
distance_to_limit(double over, bool most, bool tight)
{
	if (isnan(over))
		return -INFINITY;
	over = most ? -over : over;
	return tight && over >= -ROUNDS ? INFINITY : over;
}

/* Returns the margin to a limit in the answer, without widths; NO_LIMIT if
 * there is none, or none that a value can exceed.  *tight: no value lies beyond
 * it. */
static struct margin
margin_without_band(
    const struct conditions_search *w, struct wanted_limit of, bool *tight)
{
	const struct condition *c = &w->at[of.i];
	double limit = of.most ? c->most : c->least;
	bool share = quantities_unit(&c->quantity)[0] == '%';
	if (isnan(limit) || (share && of.most && limit >= 1))
		return NO_LIMIT;
	*tight = share && (of.most ? limit <= EXACT : limit >= 1 - EXACT);
	double room = distance_to_limit(
	    forecast_excess_over_limit(w->forecast, of.i, limit), of.most,
	    *tight);
	return (struct margin){room, NAN, of};
}

/* As margin_without_band, with widths of the band.  Sets held [DRAWS] to false
 * for each draw in which the limit does not hold. */
static struct margin
margin_with_band_widths(
    const struct conditions_search *w, struct wanted_limit of, bool *held)
{
	double over[DRAWS], low, high;
	bool tight;
	const struct condition *c = &w->at[of.i];
	struct margin m = margin_without_band(w, of, &tight);
	if (m.limit.i == SIZE_MAX ||
	    forecast_draws_of_quantity(w->forecast, of.i) == NULL)
		return m;
	forecast_excess_in_each_draw(
	    w->forecast, of.i, of.most ? c->most : c->least, over);
	for (size_t d = 0; d < DRAWS; d++) {
		over[d] = distance_to_limit(over[d], of.most, tight);
		held[d] = held[d] && over[d] >= -EXACT;
	}
	ensemble_middle_interval(over, w->level, &low, &high);
	double width = isfinite(low) && isfinite(high) ? high - low : 0;
	m.widths =
	    isfinite(m.passing) ? m.passing / fmax(width, NARROW) : m.passing;
	return m;
}

/* Returns the share of the draws in which condition i holds, or all conditions
 * if i is SIZE_MAX; NAN for a model alone.  Sets margin [w->n + 1] to the
 * margins of these conditions and, last, the smallest of them. */
static double
compute_margins_and_certainty(
    const struct conditions_search *w, size_t i, struct margin *margin)
{
	bool held[DRAWS];
	size_t n = 0;
	memset(held, true, sizeof held);
	margin[w->n] = NO_LIMIT;
	for (size_t k = 0; k < w->n; k++) {
		if (i != SIZE_MAX && i != k)
			continue;
		struct wanted_limit low = {k, false}, high = {k, true};
		margin[k] = lesser_margin(margin_with_band_widths(w, low, held),
		    margin_with_band_widths(w, high, held));
		margin[w->n] = lesser_margin(margin[w->n], margin[k]);
	}
	for (size_t d = 0; d < DRAWS; d++)
		n += held[d];
	bool drawn =
	    w->n > 0 && forecast_draws_of_quantity(w->forecast, 0) != NULL;
	return drawn ? (double)n / DRAWS : NAN;
}

struct margin
condition_margin(const struct conditions_search *w, size_t i)
{
	FREED struct margin *margin = xcalloc(w->n + 1, sizeof *margin);
	compute_margins_and_certainty(w, i, margin);
	return margin[w->n];
}

double
conditions_probability(const struct conditions_search *w)
{
	FREED struct margin *margin = xcalloc(w->n + 1, sizeof *margin);
	return compute_margins_and_certainty(w, SIZE_MAX, margin);
}

/* Needs no draws, and therefore computes none. */
bool
conditions_are_met(const struct conditions_search *w, size_t i)
{
	bool met = true, tight;
	for (size_t k = 0; k < 2 * w->n; k++) {
		struct wanted_limit of = {k / 2, k % 2 == 1};
		if (i == SIZE_MAX || i == of.i)
			met =
			    met && margin_without_band(w, of, &tight).passing >=
				       -EXACT;
	}
	return met;
}

/* Returns the tenths of a m/s in the range of speeds, and its two ends, [*n].
 * The caller frees them. */
static double *
list_speeds_by_tenths(const struct conditions_search *w, size_t *n)
{
	const double hair = 1e-6;
	double first = floor(10 * w->from + hair) + 1;
	double last = ceil(10 * w->to - hair) - 1;
	size_t between = last >= first ? (size_t)(last - first + 1.5) : 0;
	double *v = xcalloc_doubles(between + 2);
	v[0] = w->from;
	for (size_t k = 0; k < between; k++)
		v[k + 1] = (first + (double)k) / 10;
	v[between + 1] = w->to;
	*n = between + 2;
	return v;
}

struct speed_search *
speed_search_new(const struct conditions_search *w)
{
	struct speed_search *s = xcalloc(1, sizeof *s);
	*s = (struct speed_search){.found = NAN,
	    .best = NAN,
	    .best_certain = NAN,
	    .low = NONE,
	    .high = NONE,
	    .sure = {NAN, NAN},
	    .safe = NAN,
	    .range = {NAN, NAN},
	    .cut = {NAN, NAN}};
	s->speed = list_speeds_by_tenths(w, &s->n);
	s->certain = xcalloc_doubles(s->n);
	s->n_condition = w->n;
	s->step_margin = xcalloc(s->n * (w->n + 1), sizeof *s->step_margin);
	if (w->target == NULL)
		return s;
	s->over = xcalloc_doubles(s->n);
	s->value = xcalloc_doubles(s->n);
	s->draw = xcalloc(s->n, sizeof *s->draw);
	s->sample = xcalloc(s->n, sizeof *s->sample);
	return s;
}

void
speed_search_free(struct speed_search *s)
{
	if (s == NULL)
		return;
	free(s->step_margin);
	free(s->over);
	free(s->value);
	free(s->draw);
	free(s->sample);
	free(s->speed);
	free(s->certain);
	free(s->inside);
	free(s->alone);
	free(s->root);
	free(s);
}

/* Keeps what step k shows of the target. */
static void
record_target_at_search_step(
    struct speed_search *s, const struct conditions_search *w, size_t k)
{
	double value = w->target->least;
	s->value[k] = forecast_value_with_band(w->forecast, w->n).value;
	if (isnan(value))
		return;
	s->over[k] = forecast_excess_over_limit(w->forecast, w->n, value);
	if (forecast_draws_of_quantity(w->forecast, w->n) == NULL)
		return;
	forecast_excess_in_each_draw(w->forecast, w->n, value, s->draw[k]);
	forecast_set_speed_and_ensemble(
	    w->forecast, s->speed[k], ENSEMBLE_SAMPLE);
	forecast_excess_in_each_draw(w->forecast, w->n, value, s->sample[k]);
}

/* ---- what is read off the margins */

/* Returns the margin of condition i at step k; for i = n_condition, the
 * smallest of all. */
static const struct margin *
margin_at_step(const struct speed_search *s, size_t k, size_t i)
{
	return &s->step_margin[k * (s->n_condition + 1) + i];
}

static const struct margin *
least_margin_at_step(const struct speed_search *s, size_t k)
{
	return margin_at_step(s, k, s->n_condition);
}

/* Returns the limit with the smallest margin at step k, or NONE if k is beyond
 * the ends. */
static struct wanted_limit
tightest_limit_at_speed_step(const struct speed_search *s, size_t k)
{
	return k < s->n ? least_margin_at_step(s, k)->limit : NONE;
}

/* Returns whether condition i holds at each step [n]; for i = n_condition,
 * whether all hold.  The caller frees it. */
static bool *
mark_steps_meeting_condition(const struct speed_search *s, size_t i)
{
	bool *met = xcalloc(s->n, sizeof *met);
	for (size_t k = 0; k < s->n; k++)
		met[k] = margin_at_step(s, k, i)->passing >= -EXACT;
	return met;
}

/* Finds the first and the last of the marked steps around step k, without a
 * gap. */
static void
find_marked_steps_around(
    const bool *mark, size_t n, size_t k, size_t end[static 2])
{
	end[0] = end[1] = k;
	while (end[0] > 0 && mark[end[0] - 1])
		end[0]--;
	while (end[1] + 1 < n && mark[end[1] + 1])
		end[1]++;
}

/* below, above: the steps just outside the interval. */
static void
add_allowed_speed_interval(
    struct speed_search *s, double from, double to, size_t below, size_t above)
{
	s->inside = xrealloc(s->inside, s->n_inside + 1, sizeof *s->inside);
	s->inside[s->n_inside++] = (struct speed_range){from, to,
	    tightest_limit_at_speed_step(s, below),
	    tightest_limit_at_speed_step(s, above)};
}

/* For a speed between steps k and k + 1, where not all conditions hold: returns
 * 0 if they all hold at it, -1 if it is too slow, because it misses a limit
 * that step k misses too, and 1 if it is too fast. */
static int
compare_speed_with_window(const struct speed_search *s,
    const struct conditions_search *w, size_t k, double v)
{
	forecast_set_speed(w->forecast, v);
	for (size_t i = 0; i < w->n; i++) {
		struct margin m = condition_margin(w, i),
			      at = *margin_at_step(s, k, i);
		if (!(m.passing < -EXACT))
			continue;
		return at.passing < -EXACT && at.limit.most == m.limit.most ? -1
									    : 1;
	}
	return 0;
}

/* True if steps k and k + 1 miss different limits. */
static bool
may_conditions_hold_between_steps(const struct speed_search *s, size_t k)
{
	for (size_t i = 0; i < s->n_condition; i++) {
		const struct margin *a = margin_at_step(s, k, i),
				    *b = margin_at_step(s, k + 1, i);
		if (a->passing < -EXACT && b->passing < -EXACT &&
		    a->limit.most == b->limit.most)
			return false;
	}
	return true;
}

/* Returns the end of an interval: the speed nearest to `bad` at which all
 * conditions hold, as they do at `good`. */
static double
bisect_speed_interval_end(const struct speed_search *s,
    const struct conditions_search *w, size_t k, double good, double bad)
{
	const double close = 1e-4;
	while (fabs(bad - good) > close) {
		double v = (good + bad) / 2;
		*(compare_speed_with_window(s, w, k, v) == 0 ? &good : &bad) =
		    v;
	}
	return good;
}

static void
find_speeds_in_limits_between_steps(
    struct speed_search *s, const struct conditions_search *w, size_t k)
{
	const double close = 1e-6;
	double a = s->speed[k], b = s->speed[k + 1];
	int way = 1;
	while (way != 0 && b - a > close) {
		double v = (a + b) / 2;
		way = compare_speed_with_window(s, w, k, v);
		if (way <= 0)
			a = v;
		if (way >= 0)
			b = v;
	}
	if (way == 0)
		add_allowed_speed_interval(s,
		    bisect_speed_interval_end(s, w, k, a, s->speed[k]),
		    bisect_speed_interval_end(s, w, k, b, s->speed[k + 1]), k,
		    k + 1);
}

/* met [n]: whether all conditions hold at each step. */
static void
find_ranges_meeting_conditions(
    struct speed_search *s, const struct conditions_search *w, const bool *met)
{
	size_t run[2];
	for (size_t k = 0; k < s->n; k++) {
		if (met[k]) {
			/* For k = 0, k - 1 wraps round to a step beyond the
			 * last, which has no limit. */
			find_marked_steps_around(met, s->n, k, run);
			add_allowed_speed_interval(s, s->speed[k],
			    s->speed[run[1]], k - 1, run[1] + 1);
			k = run[1];
		} else if (k + 1 < s->n && !met[k + 1] &&
			   may_conditions_hold_between_steps(s, k)) {
			find_speeds_in_limits_between_steps(s, w, k);
		}
	}
}

/* Returns how far a speed is outside the measured range, m/s, or 0. */
static double
distance_beyond_measured_speeds(const struct conditions_search *w, double v)
{
	return fmax(0, fmax(w->measured[0] - v, v - w->measured[1]));
}

static bool
is_within_measured_speeds(const struct conditions_search *w, double v)
{
	return distance_beyond_measured_speeds(w, v) <= EXACT;
}

/* Returns which steps [n] may be the best: those where all conditions hold, if
 * there are any; of these, those within the measured speeds, if there are any;
 * and of these, those about as certain as the most certain.  The caller frees
 * it. */
static bool *
mark_speeds_eligible_as_best(const struct speed_search *s,
    const struct conditions_search *w, const bool *met)
{
	bool *may = xcalloc(s->n, sizeof *may), measured = false;
	double most = -INFINITY;
	for (size_t k = 0; k < s->n; k++)
		measured = measured || (met[k] && is_within_measured_speeds(
						      w, s->speed[k]));
	for (size_t k = 0; k < s->n; k++) {
		may[k] =
		    (s->n_inside == 0 || met[k]) &&
		    (!measured || is_within_measured_speeds(w, s->speed[k]));
		if (may[k] && s->n_inside > 0)
			most = fmax(most, s->certain[k]);
	}
	for (size_t k = 0; k < s->n; k++)
		may[k] = may[k] && !(s->certain[k] < most - CHANCE);
	return may;
}

/* Returns the step with the largest margin, or of several the one nearest to
 * the middle; SIZE_MAX if the conditions hold only between two steps. */
static size_t
find_best_speed_step(const struct speed_search *s,
    const struct conditions_search *w, const bool *met)
{
	bool reaches = w->measured[0] < w->measured[1];
	double middle = reaches ? (w->measured[0] + w->measured[1]) / 2
				: (w->from + w->to) / 2;
	double largest = -INFINITY, off = INFINITY;
	size_t best = SIZE_MAX;
	FREED bool *may = mark_speeds_eligible_as_best(s, w, met);
	for (size_t k = 0; k < s->n; k++) {
		double rank = margin_rank(*least_margin_at_step(s, k));
		double from_middle = fabs(s->speed[k] - middle);
		bool alike = rank == largest || fabs(rank - largest) < EXACT;
		if (!may[k] || (alike ? from_middle >= off : rank < largest))
			continue;
		off = from_middle;
		best = k;
		largest = rank;
	}
	return best;
}

static void
find_best_allowed_speed(
    struct speed_search *s, const struct conditions_search *w, const bool *met)
{
	size_t k = find_best_speed_step(s, w, met);
	if (k == SIZE_MAX) {
		s->best = (s->inside[0].from + s->inside[0].to) / 2;
		forecast_set_speed(w->forecast, s->best);
		s->margin = condition_margin(w, SIZE_MAX);
		s->best_certain = conditions_probability(w);
	} else {
		s->best = s->speed[k];
		s->margin = *least_margin_at_step(s, k);
		s->best_certain = s->certain[k];
		s->low = tightest_limit_at_speed_step(s, k - 1);
		s->high = tightest_limit_at_speed_step(s, k + 1);
	}
	const struct speed_range *in = speed_search_best_range(s);
	if (in != NULL) {
		s->low = in->low;
		s->high = in->high;
	}
}

/* True if every speed misses the conditions by as much as the best. */
static bool
is_goal_missed_alike_at_all_speeds(const struct speed_search *s)
{
	bool alike = s->margin.passing < 0 && isfinite(s->margin.passing);
	for (size_t k = 0; k < s->n && alike; k++)
		alike =
		    s->margin.passing - least_margin_at_step(s, k)->passing <
		    ROUNDS;
	return alike;
}

/* Finds the interval in which condition i holds, whatever the others do, around
 * the best speed or nearest to it. */
static void
find_speed_range_of_condition(
    const struct speed_search *s, size_t i, double ends[static 2])
{
	FREED bool *met = mark_steps_meeting_condition(s, i);
	size_t near = SIZE_MAX, run[2];
	for (size_t k = 0; k < s->n; k++)
		if (met[k] &&
		    (near == SIZE_MAX || fabs(s->speed[k] - s->best) <
					     fabs(s->speed[near] - s->best)))
			near = k;
	ends[0] = ends[1] = NAN;
	if (near == SIZE_MAX)
		return;
	find_marked_steps_around(met, s->n, near, run);
	if (run[0] > 0)
		ends[0] = s->speed[run[0]];
	if (run[1] + 1 < s->n)
		ends[1] = s->speed[run[1]];
}

static void
find_certain_speed_interval(struct speed_search *s, double level)
{
	FREED bool *sure = xcalloc(s->n, sizeof *sure);
	size_t at = 0, run[2];
	for (size_t k = 0; k < s->n; k++) {
		sure[k] = s->certain[k] >= level;
		if (s->certain[k] > s->certain[at])
			at = k;
	}
	for (size_t k = 0; k < s->n; k++)
		if (sure[k] && s->speed[k] == s->best)
			at = k;
	if (!sure[at])
		return;
	find_marked_steps_around(sure, s->n, at, run);
	s->sure[0] = s->speed[run[0]];
	s->sure[1] = s->speed[run[1]];
}

static void
find_slowest_safe_speed(
    struct speed_search *s, const struct conditions_search *w, const bool *met)
{
	for (size_t k = s->n; k-- > 0;) {
		if (s->speed[k] > s->best)
			continue;
		if (!is_within_measured_speeds(w, s->speed[k]) || !met[k] ||
		    !(s->certain[k] >= SAFE))
			return;
		s->safe = s->speed[k];
	}
}

/* ---- the target's value */

/* Returns the speed between a and b at which the target's excess changes sign;
 * it is fa at a and fb at b.  By secants, and by bisection where these gain
 * little; to 1e-9 m/s, so that predict at that speed shows the value. */
static double
refine_target_speed_between(
    const struct conditions_search *w, double a, double fa, double b, double fb)
{
	const double close = 1e-9;
	bool rises = fb >= 0;
	while (b - a > close) {
		double width = b - a, middle = (a + b) / 2;
		double at = a - fa * (width / (fb - fa));
		/* Aim a little beyond the root, so that both ends close in. */
		at += at < middle ? close / 4 : -close / 4;
		for (int half = 0; half < 2 && b - a > width / 2; half++) {
			double v =
			    half == 0 && at > a && at < b ? at : (a + b) / 2;
			forecast_set_speed(w->forecast, v);
			double f = forecast_excess_over_limit(
			    w->forecast, w->n, w->target->least);
			bool beyond = (f >= 0) == rises;
			*(beyond ? &b : &a) = v;
			*(beyond ? &fb : &fa) = f;
		}
	}
	return rises ? b : a;
}

static void
add_speed_meeting_target(
    struct speed_search *s, const struct conditions_search *w, double v)
{
	forecast_set_speed(w->forecast, v);
	s->root = xrealloc(s->root, s->n_root + 1, sizeof *s->root);
	s->root[s->n_root++] =
	    (struct speed_root){v, conditions_are_met(w, SIZE_MAX)};
}

static void
find_target_speeds(struct speed_search *s, const struct conditions_search *w)
{
	const double *f = s->over, *v = s->speed;
	double least = INFINITY;
	if (f[0] == 0)
		add_speed_meeting_target(s, w, v[0]);
	for (size_t k = 1; k < s->n; k++)
		if ((f[k - 1] >= 0) != (f[k] >= 0))
			add_speed_meeting_target(s, w,
			    refine_target_speed_between(
				w, v[k - 1], f[k - 1], v[k], f[k]));
	for (size_t i = 0; i < s->n_root; i++) {
		double at = s->root[i].speed;
		double off = distance_beyond_measured_speeds(w, at) +
			     (s->root[i].holds ? 0 : FAR);
		s->found = off < least ? at : s->found;
		least = fmin(least, off);
	}
}

/* Returns the speed nearest to v at which column d of the table f, times sign,
 * rises through 0; 0 or INFINITY if it does so below or above the search. */
static double
target_speed_of_posterior_draw(const struct speed_search *s, double (*f)[DRAWS],
    size_t d, double sign, double v)
{
	double nearest = f[0][d] == 0 ? s->speed[0] : NAN;
	for (size_t k = 1; k < s->n; k++) {
		double a = sign * f[k - 1][d], b = sign * f[k][d];
		if (!(a < 0 && b >= 0))
			continue;
		double at = s->speed[k - 1] +
			    (s->speed[k] - s->speed[k - 1]) * (a / (a - b));
		if (isnan(nearest) || fabs(at - v) < fabs(nearest - v))
			nearest = at;
	}
	if (!isnan(nearest))
		return nearest;
	return sign * f[0][d] > 0 ? 0 : INFINITY;
}

/* Sets the interval that holds the middle w->level of the draws' speeds.  An
 * end between a draw's speed and the 0 of one below the search is below it. */
static void
target_speed_interval(
    const struct conditions_search *w, double speed[DRAWS], double interval[2])
{
	ensemble_middle_interval(speed, w->level, &interval[0], &interval[1]);
	for (int end = 0; end < 2; end++)
		if (interval[end] < w->from)
			interval[end] = 0;
}

static void
compute_target_speed_bands(
    struct speed_search *s, const struct conditions_search *w)
{
	double about = isnan(s->found) ? (w->from + w->to) / 2 : s->found;
	double speed[DRAWS], sample[DRAWS];
	size_t k = 1;
	if (forecast_draws_of_quantity(w->forecast, w->n) == NULL)
		return;
	while (k + 1 < s->n && s->speed[k] < about)
		k++;
	double sign = s->over[k] < s->over[k - 1] ? -1 : 1;
	for (size_t d = 0; d < DRAWS; d++) {
		speed[d] =
		    target_speed_of_posterior_draw(s, s->draw, d, sign, about);
		sample[d] = target_speed_of_posterior_draw(
		    s, s->sample, d, sign, about);
	}
	target_speed_interval(w, speed, s->range);
	target_speed_interval(w, sample, s->cut);
}

static void
derive_speed_search_results(
    struct speed_search *s, const struct conditions_search *w)
{
	FREED bool *met = mark_steps_meeting_condition(s, w->n);
	find_ranges_meeting_conditions(s, w, met);
	find_best_allowed_speed(s, w, met);
	s->alike = is_goal_missed_alike_at_all_speeds(s);
	find_certain_speed_interval(s, w->level);
	find_slowest_safe_speed(s, w, met);
	s->alone = xcalloc(w->n + 1, sizeof *s->alone);
	for (size_t i = 0; i < w->n; i++)
		find_speed_range_of_condition(s, i, s->alone[i]);
	if (w->target == NULL || isnan(w->target->least))
		return;
	find_target_speeds(s, w);
	compute_target_speed_bands(s, w);
}

bool
speed_search_step(struct speed_search *s, const struct conditions_search *w)
{
	size_t k = s->done;
	if (k == s->n)
		return true;
	forecast_set_speed(w->forecast, s->speed[k]);
	s->certain[k] = compute_margins_and_certainty(
	    w, SIZE_MAX, s->step_margin + k * (w->n + 1));
	if (w->target != NULL)
		record_target_at_search_step(s, w, k);
	if (++s->done < s->n)
		return false;
	derive_speed_search_results(s, w);
	return true;
}

struct speed_search *
speed_search_run(const struct conditions_search *w)
{
	struct speed_search *s = speed_search_new(w);
	while (!speed_search_step(s, w))
		;
	return s;
}

const struct speed_range *
speed_search_best_range(const struct speed_search *s)
{
	for (size_t k = 0; k < s->n_inside; k++)
		if (s->best >= s->inside[k].from && s->best <= s->inside[k].to)
			return &s->inside[k];
	return NULL;
}

double
speed_search_speed_of_max_or_min(
    const struct speed_search *s, bool most, bool sure)
{
	double best = NAN, speed = NAN;
	for (size_t k = 0; k < s->n; k++) {
		double value = s->value[k], v = s->speed[k];
		bool in = sure ? v >= s->sure[0] && v <= s->sure[1]
			       : least_margin_at_step(s, k)->passing >= -EXACT;
		bool better =
		    isnan(best) || (most ? value > best : value < best);
		if (!in || isnan(value) || !better)
			continue;
		best = value;
		speed = v;
	}
	return speed;
}
