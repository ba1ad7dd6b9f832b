/* Fills a table over the tenths of a m/s, and reads ranges, roots and the best
 * speed off it.
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

/* What is shown as 100.0 % or 0.0 % counts as all or nothing. */
static const double ROUNDS = 5e-4;

/* A band is no narrower than the rounding of sheets. */
static const double NARROW = 1e-3;

/* Shares of the draws that differ by less may do so by chance. */
static const double CHANCE = 0.02;

/* The certainty that is required of a slow speed, chosen for less energy and
 * wear. */
static const double SAFE = 0.95;

static const struct wanted_limit NONE = {SIZE_MAX, false};

/* What was computed at each speed [n]: margin [n][n_condition]; value of the
 * target's quantity and its excess over the target's value, in the answer
 * (over), in the draws and in the draws of one more sample. */
struct speed_table {
	size_t n_condition;
	struct margin *margin;
	double *over, *value;
	double (*draw)[DRAWS], (*sample)[DRAWS];
};

struct wanted
wanted_from_question(const struct session *s, const struct question *q,
    size_t n, const struct condition *at, size_t n_more,
    const struct quantity *more)
{
	FREED struct quantity *asked = xcalloc(n + n_more, sizeof *asked);
	for (size_t i = 0; i < n; i++)
		asked[i] = at[i].quantity;
	for (size_t i = 0; i < n_more; i++)
		asked[n + i] = more[i];
	struct wanted w = {.site = q->entry->site,
	    .n = n,
	    .at = at,
	    .level = q->level,
	    .forecast = forecast_open(s, q, asked, n + n_more)};
	settings_default_speed_range(&s->set, q->entry->site, &w.from, &w.to);
	bool known =
	    origin_known_speed_range(q->entry, &w.measured[0], &w.measured[1]);
	if (!known)
		w.measured[0] = w.measured[1] =
		    site_middle_speed(q->entry->site);
	w.reach = known
		      ? trust_reach_beyond_speeds(w.measured[0], w.measured[1])
		      : INFINITY;
	return w;
}

/* One limit of condition i.  sign: 1 for a lower limit, -1 for an upper one,
 * so that sign times the excess over the limit is above 0 where it holds. */
struct side {
	size_t i;
	double limit, sign;
	bool tight; /* no value lies beyond the limit */
};

static double
room_to_limit(const struct side *side, double over)
{
	if (isnan(over))
		return -INFINITY;
	over *= side->sign;
	return side->tight && over >= -ROUNDS ? INFINITY : over;
}

/* Lists the limits of condition i and returns their number. */
static size_t
limits_of_condition(
    const struct wanted *w, size_t i, struct side side[static 2])
{
	const struct condition *of = &w->at[i];
	bool share = quantities_unit(&of->quantity)[0] == '%';
	size_t n = 0;
	if (!isnan(of->least))
		side[n++] = (struct side){
		    i, of->least, 1, share && of->least >= 1 - EXACT};
	if (!isnan(of->most) && !(share && of->most >= 1))
		side[n++] =
		    (struct side){i, of->most, -1, share && of->most <= EXACT};
	return n;
}

/* Returns the margin of a limit.  held [DRAWS], or NULL: set to false for each
 * draw in which it does not hold. */
static struct margin
limit_margin_and_draws(
    const struct wanted *w, const struct side *side, bool *held)
{
	double over[DRAWS], low, high;
	struct forecast *f = w->forecast;
	struct margin m = {.limit = {side->i, side->sign < 0}};
	m.passing = room_to_limit(
	    side, forecast_excess_over_limit(f, side->i, side->limit));
	m.widths = m.passing;
	if (forecast_draws(f, side->i) == NULL)
		return m;
	forecast_excess_of_draws(f, side->i, side->limit, over);
	for (size_t d = 0; d < DRAWS; d++) {
		over[d] = room_to_limit(side, over[d]);
		if (held != NULL)
			held[d] = held[d] && over[d] >= -EXACT;
	}
	ensemble_middle_interval(over, w->level, &low, &high);
	double width = isfinite(low) && isfinite(high) ? high - low : 0;
	if (isfinite(m.passing))
		m.widths = m.passing / fmax(width, NARROW);
	return m;
}

/* Returns a number by which margins compare.  A limit that is missed ranks
 * below all that hold, by the points that it is missed by, because a wide band
 * does not make a miss smaller. */
static double
margin_rank(struct margin m)
{
	return m.passing < -EXACT ? m.passing : fmax(m.widths, 0);
}

/* Returns the lesser of two margins, ignoring one without a limit. */
static struct margin
lesser_margin(struct margin least, struct margin m)
{
	bool none = least.limit.i == SIZE_MAX;
	if (m.limit.i != SIZE_MAX &&
	    (none || margin_rank(m) < margin_rank(least)))
		return m;
	return least;
}

static struct margin
condition_margin_and_draws(const struct wanted *w, size_t i, bool *held)
{
	struct side side[2];
	struct margin least = {INFINITY, INFINITY, NONE};
	size_t n = limits_of_condition(w, i, side);
	for (size_t k = 0; k < n; k++)
		least = lesser_margin(
		    least, limit_margin_and_draws(w, &side[k], held));
	return least;
}

struct margin
condition_margin(const struct wanted *w, size_t i)
{
	struct margin least = {INFINITY, INFINITY, NONE};
	if (i != SIZE_MAX)
		return condition_margin_and_draws(w, i, NULL);
	for (i = 0; i < w->n; i++)
		least = lesser_margin(
		    least, condition_margin_and_draws(w, i, NULL));
	return least;
}

/* Does not compute draws, which are not needed for this. */
bool
conditions_are_met(const struct wanted *w, size_t i)
{
	struct side side[2];
	size_t first = i == SIZE_MAX ? 0 : i,
	       end = i == SIZE_MAX ? w->n : i + 1;
	for (i = first; i < end; i++)
		for (size_t k = 0, n = limits_of_condition(w, i, side); k < n;
		     k++) {
			const struct side *of = &side[k];
			double over = forecast_excess_over_limit(
			    w->forecast, of->i, of->limit);
			if (!(room_to_limit(of, over) >= -EXACT))
				return false;
		}
	return true;
}

/* Returns the share of draws in which all conditions hold, NAN for a model
 * alone. margin [w->n]: out, or NULL. */
static double
share_of_draws_that_hold(const struct wanted *w, struct margin *margin)
{
	bool held[DRAWS];
	size_t n = 0;
	memset(held, true, sizeof held);
	for (size_t i = 0; i < w->n; i++) {
		struct margin m = condition_margin_and_draws(w, i, held);
		if (margin != NULL)
			margin[i] = m;
	}
	for (size_t d = 0; d < DRAWS; d++)
		n += held[d];
	bool drawn = w->n > 0 && forecast_draws(w->forecast, 0) != NULL;
	return drawn ? (double)n / DRAWS : NAN;
}

double
conditions_probability(const struct wanted *w)
{
	return share_of_draws_that_hold(w, NULL);
}

/* Returns both ends of the range of speeds and the tenths between them,
 * [*n]. */
static double *
list_speeds_by_tenths(const struct wanted *w, size_t *n)
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
speed_search_new(const struct wanted *w)
{
	struct speed_search *s = xcalloc(1, sizeof *s);
	struct speed_table *t = xcalloc(1, sizeof *t);
	*s = (struct speed_search){.table = t, .found = NAN, .best = NAN};
	s->range[0] = s->range[1] = s->cut[0] = s->cut[1] = NAN;
	s->sure[0] = s->sure[1] = s->safe = s->best_certain = NAN;
	s->low = s->high = NONE;
	s->speed = list_speeds_by_tenths(w, &s->n);
	s->certain = xcalloc_doubles(s->n);
	t->n_condition = w->n;
	t->margin = xcalloc(s->n * (w->n + 1), sizeof *t->margin);
	if (w->target == NULL)
		return s;
	t->over = xcalloc_doubles(s->n);
	t->value = xcalloc_doubles(s->n);
	t->draw = xcalloc(s->n, sizeof *t->draw);
	t->sample = xcalloc(s->n, sizeof *t->sample);
	return s;
}

void
speed_search_free(struct speed_search *s)
{
	if (s == NULL)
		return;
	free(s->table->margin);
	free(s->table->over);
	free(s->table->value);
	free(s->table->draw);
	free(s->table->sample);
	free(s->table);
	free(s->speed);
	free(s->certain);
	free(s->inside);
	free(s->alone);
	free(s->root);
	free(s);
}

/* Stores what concerns the target, at step k, whose speed is v. */
static void
store_target_at_step(
    struct speed_table *t, const struct wanted *w, size_t k, double v)
{
	const struct condition *c = w->target;
	t->value[k] = forecast_value_with_band(w->forecast, w->n).value;
	if (isnan(c->least))
		return;
	t->over[k] = forecast_excess_over_limit(w->forecast, w->n, c->least);
	if (forecast_draws(w->forecast, w->n) == NULL)
		return;
	forecast_excess_of_draws(w->forecast, w->n, c->least, t->draw[k]);
	forecast_set_speed_and_draws(w->forecast, v, ENSEMBLE_SAMPLE);
	forecast_excess_of_draws(w->forecast, w->n, c->least, t->sample[k]);
}

/* ---- what is read off the table */

static const struct margin *
margins_of_step(const struct speed_search *s, size_t k)
{
	return s->table->margin + k * s->table->n_condition;
}

static bool
is_condition_met_at_step(const struct speed_search *s, size_t k, size_t i)
{
	return margins_of_step(s, k)[i].passing >= -EXACT;
}

static struct margin
least_margin_at_step(const struct speed_search *s, size_t k)
{
	struct margin least = {INFINITY, INFINITY, NONE};
	for (size_t i = 0; i < s->table->n_condition; i++)
		least = lesser_margin(least, margins_of_step(s, k)[i]);
	return least;
}

static bool
are_conditions_met_at_step(const struct speed_search *s, size_t k)
{
	size_t i = 0, n = s->table->n_condition;
	while (i < n && is_condition_met_at_step(s, k, i))
		i++;
	return i == n;
}

/* Returns the limit with the smallest margin at step k, or none for a step
 * beyond the ends. */
static struct wanted_limit
missed_limit_at_step(const struct speed_search *s, size_t k)
{
	return k < s->n ? least_margin_at_step(s, k).limit : NONE;
}

static void
add_speed_interval(
    struct speed_search *s, double from, double to, size_t below, size_t above)
{
	s->inside = xrealloc(s->inside, s->n_inside + 1, sizeof *s->inside);
	s->inside[s->n_inside++] = (struct speed_range){from, to,
	    missed_limit_at_step(s, below), missed_limit_at_step(s, above)};
}

/* For a speed between steps k and k + 1, at neither of which all conditions
 * hold: returns -1 if it is too slow, as it misses a limit that step k misses,
 * 1 if it is too fast, and 0 if all conditions hold. */
static int
bisection_direction(
    const struct speed_search *s, const struct wanted *w, size_t k, double v)
{
	forecast_set_speed(w->forecast, v);
	for (size_t i = 0; i < w->n; i++) {
		struct margin m = condition_margin(w, i),
			      at = margins_of_step(s, k)[i];
		if (!(m.passing < -EXACT))
			continue;
		return at.passing < -EXACT && at.limit.most == m.limit.most ? -1
									    : 1;
	}
	return 0;
}

/* True if step k and the next miss different limits. */
static bool
may_conditions_hold_between(const struct speed_search *s, size_t k)
{
	const struct margin *a = margins_of_step(s, k),
			    *b = margins_of_step(s, k + 1);
	for (size_t i = 0; i < s->table->n_condition; i++)
		if (a[i].passing < -EXACT && b[i].passing < -EXACT &&
		    a[i].limit.most == b[i].limit.most)
			return false;
	return true;
}

/* Returns the speed nearest to `bad` at which all conditions hold, as at
 * `good`. */
static double
bisect_interval_end(const struct speed_search *s, const struct wanted *w,
    size_t k, double good, double bad)
{
	const double close = 1e-4;
	while (fabs(bad - good) > close) {
		double v = (good + bad) / 2;
		*(bisection_direction(s, w, k, v) == 0 ? &good : &bad) = v;
	}
	return good;
}

static void
find_interval_between_steps(
    struct speed_search *s, const struct wanted *w, size_t k)
{
	const double close = 1e-6;
	double a = s->speed[k], b = s->speed[k + 1];
	int way = 1;
	while (way != 0 && b - a > close) {
		double v = (a + b) / 2;
		way = bisection_direction(s, w, k, v);
		if (way <= 0)
			a = v;
		if (way >= 0)
			b = v;
	}
	if (way == 0)
		add_speed_interval(s,
		    bisect_interval_end(s, w, k, a, s->speed[k]),
		    bisect_interval_end(s, w, k, b, s->speed[k + 1]), k, k + 1);
}

static void
find_speed_intervals(struct speed_search *s, const struct wanted *w)
{
	for (size_t k = 0; k < s->n; k++) {
		size_t last = k;
		if (!are_conditions_met_at_step(s, k)) {
			if (k + 1 < s->n &&
			    !are_conditions_met_at_step(s, k + 1) &&
			    may_conditions_hold_between(s, k))
				find_interval_between_steps(s, w, k);
			continue;
		}
		while (
		    last + 1 < s->n && are_conditions_met_at_step(s, last + 1))
			last++;
		/* For k = 0, k - 1 wraps round to a step beyond the last, which
		 * has no limit. */
		add_speed_interval(
		    s, s->speed[k], s->speed[last], k - 1, last + 1);
		k = last;
	}
}

static bool
is_within_measured_speeds(const struct wanted *w, double v)
{
	return v >= w->measured[0] - EXACT && v <= w->measured[1] + EXACT;
}

/* True if all conditions hold at some speed between the measured ones. */
static bool
is_met_within_measured_speeds(
    const struct speed_search *s, const struct wanted *w)
{
	for (size_t k = 0; k < s->n; k++)
		if (are_conditions_met_at_step(s, k) &&
		    is_within_measured_speeds(w, s->speed[k]))
			return true;
	return false;
}

/* Which steps may be the best.  inside: only those at which all conditions
 * hold; measured: only those between the measured speeds; sure: the least
 * certainty. */
struct eligible {
	bool inside, measured;
	double sure;
};

static bool
may_be_best_step(const struct speed_search *s, const struct wanted *w, size_t k,
    const struct eligible *e)
{
	return (!e->inside || are_conditions_met_at_step(s, k)) &&
	       (!e->measured || is_within_measured_speeds(w, s->speed[k])) &&
	       !(s->certain[k] < e->sure);
}

/* Returns the step with the largest margin, of equals the one nearest to the
 * middle; SIZE_MAX if the conditions hold only between two steps. */
static size_t
find_best_step(const struct speed_search *s, const struct wanted *w)
{
	struct eligible e = {
	    s->n_inside > 0, is_met_within_measured_speeds(s, w), -INFINITY};
	bool reaches = w->measured[0] < w->measured[1];
	double middle = reaches ? (w->measured[0] + w->measured[1]) / 2
				: (w->from + w->to) / 2;
	double most = -INFINITY, largest = -INFINITY, off = INFINITY;
	size_t best = SIZE_MAX;
	for (size_t k = 0; k < s->n && e.inside; k++)
		if (may_be_best_step(s, w, k, &e))
			most = fmax(most, s->certain[k]);
	e.sure = most - CHANCE;
	for (size_t k = 0; k < s->n; k++) {
		double rank = margin_rank(least_margin_at_step(s, k));
		double from_middle = fabs(s->speed[k] - middle);
		if (!may_be_best_step(s, w, k, &e))
			continue;
		bool alike = rank == largest || fabs(rank - largest) < EXACT;
		if (alike ? from_middle >= off : rank < largest)
			continue;
		off = from_middle;
		best = k;
		largest = rank;
	}
	return best;
}

static void
find_best_speed(struct speed_search *s, const struct wanted *w)
{
	size_t k = find_best_step(s, w);
	if (k == SIZE_MAX) {
		s->best = (s->inside[0].from + s->inside[0].to) / 2;
		forecast_set_speed(w->forecast, s->best);
		s->margin = condition_margin(w, SIZE_MAX);
		s->best_certain = conditions_probability(w);
	} else {
		s->best = s->speed[k];
		s->margin = least_margin_at_step(s, k);
		s->best_certain = s->certain[k];
		s->low = missed_limit_at_step(s, k - 1);
		s->high = missed_limit_at_step(s, k + 1);
	}
	const struct speed_range *in = speed_search_best_range(s);
	if (in != NULL) {
		s->low = in->low;
		s->high = in->high;
	}
	s->alike = s->margin.passing < 0 && isfinite(s->margin.passing);
	for (size_t i = 0; i < s->n && s->alike; i++)
		s->alike =
		    s->margin.passing - least_margin_at_step(s, i).passing <
		    ROUNDS;
}

/* Finds the interval around the best speed, or nearest to it, in which
 * condition i holds by itself. */
static void
find_interval_of_condition(
    const struct speed_search *s, size_t i, double ends[static 2])
{
	size_t near = SIZE_MAX;
	for (size_t k = 0; k < s->n; k++)
		if (is_condition_met_at_step(s, k, i) &&
		    (near == SIZE_MAX || fabs(s->speed[k] - s->best) <
					     fabs(s->speed[near] - s->best)))
			near = k;
	ends[0] = ends[1] = NAN;
	if (near == SIZE_MAX)
		return;
	size_t low = near, high = near;
	while (low > 0 && is_condition_met_at_step(s, low - 1, i))
		low--;
	while (high + 1 < s->n && is_condition_met_at_step(s, high + 1, i))
		high++;
	if (low > 0)
		ends[0] = s->speed[low];
	if (high + 1 < s->n)
		ends[1] = s->speed[high];
}

static void
find_certain_interval(struct speed_search *s, double level)
{
	size_t at = SIZE_MAX, most = 0;
	for (size_t k = 0; k < s->n; k++) {
		if (s->speed[k] == s->best && s->certain[k] >= level)
			at = k;
		if (s->certain[k] > s->certain[most])
			most = k;
	}
	if (at == SIZE_MAX && s->certain[most] >= level)
		at = most;
	if (at == SIZE_MAX)
		return;
	size_t low = at, high = at;
	while (low > 0 && s->certain[low - 1] >= level)
		low--;
	while (high + 1 < s->n && s->certain[high + 1] >= level)
		high++;
	s->sure[0] = s->speed[low];
	s->sure[1] = s->speed[high];
}

static void
find_slowest_safe_speed(struct speed_search *s, const struct wanted *w)
{
	for (size_t k = s->n; k-- > 0;) {
		if (s->speed[k] > s->best)
			continue;
		if (!is_within_measured_speeds(w, s->speed[k]) ||
		    !are_conditions_met_at_step(s, k) ||
		    !(s->certain[k] >= SAFE))
			return;
		s->safe = s->speed[k];
	}
}

/* ---- the target's value */

static double
target_excess_at_speed(const struct wanted *w, double v)
{
	forecast_set_speed(w->forecast, v);
	return forecast_excess_over_limit(w->forecast, w->n, w->target->least);
}

/* Returns the speed between a and b at which the target's excess, fa and fb
 * there, changes its sign: by secants, and by bisection where these gain
 * little.  To 1e-9 m/s, so that predict at that speed gives the value. */
static double
target_speed_between(
    const struct wanted *w, double a, double fa, double b, double fb)
{
	const double close = 1e-9;
	bool rises = fb >= 0;
	while (b - a > close) {
		double width = b - a, middle = (a + b) / 2;
		double at = a - fa * (width / (fb - fa));
		/* Go a little beyond the root, so that both ends close in. */
		at += at < middle ? close / 4 : -close / 4;
		for (int half = 0; half < 2 && b - a > width / 2; half++) {
			double v =
			    half == 0 && at > a && at < b ? at : (a + b) / 2;
			double f = target_excess_at_speed(w, v);
			if ((f >= 0) == rises) {
				b = v;
				fb = f;
			} else {
				a = v;
				fa = f;
			}
		}
	}
	return rises ? b : a;
}

static void
add_target_speed(struct speed_search *s, const struct wanted *w, double v)
{
	forecast_set_speed(w->forecast, v);
	s->root = xrealloc(s->root, s->n_root + 1, sizeof *s->root);
	s->root[s->n_root++] =
	    (struct speed_root){v, conditions_are_met(w, SIZE_MAX)};
}

static void
find_target_speeds(struct speed_search *s, const struct wanted *w)
{
	const double *f = s->table->over, *v = s->speed;
	if (f[0] == 0)
		add_target_speed(s, w, v[0]);
	for (size_t k = 1; k < s->n; k++)
		if ((f[k - 1] >= 0) != (f[k] >= 0))
			add_target_speed(s, w,
			    target_speed_between(
				w, v[k - 1], f[k - 1], v[k], f[k]));
}

/* Returns how far a speed lies beyond the measured ones, or 0. */
static double
distance_beyond_measured_speeds(const struct wanted *w, double v)
{
	return fmax(0, fmax(w->measured[0] - v, v - w->measured[1]));
}

static void
choose_target_speed(struct speed_search *s, const struct wanted *w)
{
	const struct speed_root *best = NULL;
	for (size_t i = 0; i < s->n_root; i++) {
		const struct speed_root *r = &s->root[i];
		bool better =
		    best == NULL || r->holds > best->holds ||
		    (r->holds == best->holds &&
			distance_beyond_measured_speeds(w, r->speed) <
			    distance_beyond_measured_speeds(w, best->speed));
		best = better ? r : best;
	}
	s->found = best != NULL ? best->speed : NAN;
}

/* Returns the speed nearest to v at which sign times draw d of a table rises
 * through 0; 0 or INFINITY if it does so below or above the search. */
static double
target_speed_of_draw(const struct speed_search *s, double (*f)[DRAWS], size_t d,
    double sign, double v)
{
	double nearest = NAN;
	if (f[0][d] == 0)
		nearest = s->speed[0];
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

static void
find_target_speed_bands(struct speed_search *s, const struct wanted *w)
{
	struct speed_table *t = s->table;
	double about = isnan(s->found) ? (w->from + w->to) / 2 : s->found;
	double speed[DRAWS];
	size_t k = 1;
	if (forecast_draws(w->forecast, w->n) == NULL)
		return;
	while (k + 1 < s->n && s->speed[k] < about)
		k++;
	double sign = t->over[k] < t->over[k - 1] ? -1 : 1;
	for (size_t d = 0; d < DRAWS; d++)
		speed[d] = target_speed_of_draw(s, t->draw, d, sign, about);
	ensemble_middle_interval(speed, w->level, &s->range[0], &s->range[1]);
	for (size_t d = 0; d < DRAWS; d++)
		speed[d] = target_speed_of_draw(s, t->sample, d, sign, about);
	ensemble_middle_interval(speed, w->level, &s->cut[0], &s->cut[1]);
}

static void
finish_speed_search(struct speed_search *s, const struct wanted *w)
{
	find_speed_intervals(s, w);
	find_best_speed(s, w);
	find_certain_interval(s, w->level);
	find_slowest_safe_speed(s, w);
	s->alone = xcalloc(w->n + 1, sizeof *s->alone);
	for (size_t i = 0; i < w->n; i++)
		find_interval_of_condition(s, i, s->alone[i]);
	if (w->target == NULL || isnan(w->target->least))
		return;
	find_target_speeds(s, w);
	choose_target_speed(s, w);
	find_target_speed_bands(s, w);
}

bool
speed_search_step(struct speed_search *s, const struct wanted *w)
{
	size_t k = s->done;
	if (k == s->n)
		return true;
	forecast_set_speed(w->forecast, s->speed[k]);
	s->certain[k] =
	    share_of_draws_that_hold(w, s->table->margin + k * w->n);
	if (w->target != NULL)
		store_target_at_step(s->table, w, k, s->speed[k]);
	if (++s->done < s->n)
		return false;
	finish_speed_search(s, w);
	return true;
}

struct speed_search *
speed_search_run(const struct wanted *w)
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
speed_search_speed_of_extreme(
    const struct speed_search *s, bool most, bool sure)
{
	double best = NAN, speed = NAN;
	for (size_t k = 0; k < s->n; k++) {
		double value = s->table->value[k], v = s->speed[k];
		bool in = sure ? v >= s->sure[0] && v <= s->sure[1]
			       : are_conditions_met_at_step(s, k);
		bool better =
		    isnan(best) || (most ? value > best : value < best);
		if (!in || isnan(value) || !better)
			continue;
		best = value;
		speed = v;
	}
	return speed;
}
