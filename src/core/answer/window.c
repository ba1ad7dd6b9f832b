/* Steps over the speeds, roots between them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/window.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include <gsl/gsl_sort_double.h>

#include "base/xalloc.h"
#include "core/posterior/ensemble.h"

/* Steps of the speed, m/s; and how far apart the ends of a root's bracket
 * are. */
static const double STEP = 0.1, ROOT = 1e-9;

/* A limit is met when it is missed by no more than arithmetic does. */
static const double EXACT = 1e-9;

/* All that people see as 100.0 % or as 0.0 is all or nothing. */
static const double ROUNDS = 5e-4;

/* What is above 0 where the value of quantity i is on the right side of a
 * limit: its distance, times the sign. */
struct side {
	size_t i;
	double limit, sign;
	bool tight; /* nothing lies beyond the limit */
};

static double
side_at(const struct wanted *c, const struct side *side, size_t draw)
{
	double over =
	    side->sign * response_over(c->response, side->i, side->limit, draw);
	if (isnan(over))
		return -INFINITY;
	return side->tight && over >= -ROUNDS ? INFINITY : over;
}

/* The sides of condition i.  Returns how many. */
static size_t
sides_of(const struct wanted *c, size_t i, struct side side[static 2])
{
	const struct condition *of = &c->at[i];
	bool share = of->quantity.kind == QUANTITY_PASSING ||
		     of->quantity.kind == QUANTITY_SHARE;
	size_t n = 0;
	if (!isnan(of->least))
		side[n++] = (struct side){
		    i, of->least, 1, share && of->least >= 1 - EXACT};
	if (!isnan(of->most) && !(share && of->most >= 1))
		side[n++] =
		    (struct side){i, of->most, -1, share && of->most <= EXACT};
	return n;
}

static struct side *
all_sides(const struct wanted *c, size_t *n)
{
	struct side *side = xcalloc(2 * c->n + 2, sizeof *side);
	*n = 0;
	for (size_t i = 0; i < c->n; i++)
		*n += sides_of(c, i, side + *n);
	return side;
}

static const struct window_limit NONE = {SIZE_MAX, false};

/* The least of sides [n]. */
static double
least_of(const struct wanted *c, const struct side *side, size_t n,
    struct window_limit *limit)
{
	double least = INFINITY;
	*limit = NONE;
	for (size_t k = 0; k < n; k++) {
		double at = side_at(c, &side[k], SIZE_MAX);
		if (at < least || limit->i == SIZE_MAX)
			*limit =
			    (struct window_limit){side[k].i, side[k].sign < 0};
		least = fmin(least, at);
	}
	return least;
}

double
window_margin(const struct wanted *c, struct window_limit *limit)
{
	size_t n;
	struct side *side = all_sides(c, &n);
	double least = least_of(c, side, n, limit);
	free(side);
	return least;
}

double
window_margin_of(const struct wanted *c, size_t i, struct window_limit *limit)
{
	struct side side[2];
	return least_of(c, side, sides_of(c, i, side), limit);
}

bool
window_holds(const struct wanted *c)
{
	struct window_limit limit;
	return window_margin(c, &limit) >= -EXACT;
}

bool
window_holds_of(const struct wanted *c, size_t i)
{
	struct window_limit limit;
	return window_margin_of(c, i, &limit) >= -EXACT;
}

double
window_certainty(const struct wanted *c)
{
	size_t n, held = 0;
	if (c->n == 0 || response_draws(c->response, 0) == NULL)
		return NAN;
	struct side *side = all_sides(c, &n);
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
		size_t k = 0;
		while (k < n && side_at(c, &side[k], d) >= -EXACT)
			k++;
		held += k == n;
	}
	free(side);
	return (double)held / POSTERIOR_DRAWS;
}

static double
moved(const struct wanted *c, const struct side *side, double v)
{
	response_answer_at(c->response, v);
	return side_at(c, side, SIZE_MAX);
}

static double
margin_at(const struct wanted *c, double v)
{
	struct window_limit limit;
	response_answer_at(c->response, v);
	return window_margin(c, &limit);
}

/* The steps: speeds [n], of which the last step may be a short one. */
static double *
steps(const struct wanted *c, size_t *n)
{
	size_t whole = (size_t)ceil((c->to - c->from) / STEP - 1e-6);
	double *v = xdoubles(whole + 1);
	for (size_t k = 0; k < whole; k++)
		v[k] = c->from + STEP * (double)k;
	v[whole] = c->to;
	*n = whole + 1;
	return v;
}

/* Speeds that are collected. */
struct found {
	size_t n;
	double *v;
};

static void
keep(struct found *found, double v)
{
	found->v = xrealloc(found->v, found->n + 2, sizeof *found->v);
	found->v[found->n++] = v;
}

/* Where side + slack changes its sign between a and b, at which it is fa and
 * fb: secants, and halves where these gain little. */
static void
find_root(const struct wanted *c, const struct side *side, double slack,
    double a, double fa, double b, double fb, struct found *found)
{
	bool rises = fb >= 0;
	while (b - a > ROOT) {
		double width = b - a, middle = (a + b) / 2;
		double at = a - fa * (width / (fb - fa));
		/* A little beyond the root, so that both ends close in. */
		at += at < middle ? ROOT / 4 : -ROOT / 4;
		for (int half = 0; half < 2 && b - a > width / 2; half++) {
			double v =
			    half == 0 && at > a && at < b ? at : (a + b) / 2;
			double f = moved(c, side, v) + slack;
			if ((f >= 0) == rises) {
				b = v;
				fb = f;
			} else {
				a = v;
				fa = f;
			}
		}
	}
	keep(found, rises ? b : a);
}

/* The speed at which a function is largest between a and b, where it has one
 * top. */
struct top {
	double v, f;
};

static struct top
climb(const struct wanted *c,
    double (*f)(const struct wanted *, const void *, double), const void *of,
    double a, double b)
{
	const double golden = (sqrt(5) - 1) / 2, close = 1e-6;
	double left = b - golden * (b - a), right = a + golden * (b - a);
	double at_left = f(c, of, left), at_right = f(c, of, right);
	while (b - a > close) {
		if (at_left >= at_right) {
			b = right;
			right = left;
			at_right = at_left;
			left = b - golden * (b - a);
			at_left = f(c, of, left);
		} else {
			a = left;
			left = right;
			at_left = at_right;
			right = a + golden * (b - a);
			at_right = f(c, of, right);
		}
	}
	return at_left >= at_right ? (struct top){left, at_left}
				   : (struct top){right, at_right};
}

/* How far a side reaches towards the other sign. */
static double
towards(const struct wanted *c, const void *of, double v)
{
	const struct side *side = of;
	return moved(c, side, v);
}

static double
away(const struct wanted *c, const void *of, double v)
{
	return -towards(c, of, v);
}

/* A side that turns back near 0 between steps may cross it twice there.  f [3]
 * at v [3]; no parabola through these goes further beyond the middle one than
 * an eighth of what it differs from the others. */
static void
find_turn(const struct wanted *c, const struct side *side, double slack,
    const double v[static 3], const double f[static 3], struct found *found)
{
	double sign = f[1] < 0 ? -1 : 1;
	double left = sign * (f[0] - f[1]), right = sign * (f[2] - f[1]);
	bool turns = left >= 0 && right >= 0 && left + right > 0;
	if (!turns || !(fabs(f[1]) <= fmax(left, right)))
		return;
	struct top top = climb(c, sign < 0 ? towards : away, side, v[0], v[2]);
	double at = (sign < 0 ? top.f : -top.f) + slack;
	if ((at >= 0) == (f[1] >= 0))
		return;
	find_root(c, side, slack, v[0], f[0], top.v, at, found);
	find_root(c, side, slack, top.v, at, v[2], f[2], found);
}

/* All roots of side + slack; f [n]: at the steps. */
static void
find_roots(const struct wanted *c, const struct side *side, double slack,
    const double *v, const double *f, size_t n, struct found *found)
{
	for (size_t k = 1; k < n; k++) {
		bool same = (f[k - 1] >= 0) == (f[k] >= 0);
		if (!same)
			find_root(c, side, slack, v[k - 1], f[k - 1], v[k],
			    f[k], found);
		else if (k + 1 < n && (f[k] >= 0) == (f[k + 1] >= 0))
			find_turn(c, side, slack, &v[k - 1], &f[k - 1], found);
	}
}

size_t
window_roots(const struct wanted *c, size_t i, double value, double **root)
{
	struct side side = {i, value, 1, false};
	struct found found = {0};
	size_t n;
	double *v = steps(c, &n), *f = xdoubles(n);
	for (size_t k = 0; k < n; k++)
		f[k] = moved(c, &side, v[k]);
	if (f[0] == 0)
		keep(&found, c->from);
	find_roots(c, &side, 0, v, f, n, &found);
	free(v);
	free(f);
	gsl_sort(found.v, 1, found.n);
	*root = found.v;
	return found.n;
}

/* What the search for a window has: at its steps the sides [n_side][n] and the
 * margin. */
struct search {
	const struct wanted *c;
	size_t n_side, n;
	struct side *side;
	double *v, *margin, **f;
	struct found *root; /* [n_side] */
};

static void
look(struct search *s, struct window_found *w)
{
	s->side = all_sides(s->c, &s->n_side);
	s->f = xcalloc(s->n_side + 1, sizeof *s->f);
	s->root = xcalloc(s->n_side + 1, sizeof *s->root);
	for (size_t j = 0; j < s->n_side; j++)
		s->f[j] = xdoubles(s->n);
	for (size_t k = 0; k < s->n; k++) {
		response_at(s->c->response, s->v[k]);
		s->margin[k] = INFINITY;
		for (size_t j = 0; j < s->n_side; j++) {
			double at = side_at(s->c, &s->side[j], SIZE_MAX);
			s->margin[k] = fmin(s->margin[k], at);
			s->f[j][k] = at + EXACT;
		}
		w->certain[k] = window_certainty(s->c);
	}
}

/* The limit that is missed most at a speed; none beyond those looked at. */
static struct window_limit
binding(const struct wanted *c, double v)
{
	struct window_limit limit = NONE;
	if (v < c->from || v > c->to)
		return limit;
	response_answer_at(c->response, v);
	window_margin(c, &limit);
	return limit;
}

/* The better of the two; of equals the one nearer to the middle. */
static void
better(const struct wanted *c, struct top *best, double v, double f)
{
	double middle = (c->from + c->to) / 2;
	bool nearer = fabs(v - middle) < fabs(best->v - middle);
	if (f > best->f + EXACT || (f >= best->f - EXACT && nearer) ||
	    (isinf(f) && f == best->f && nearer))
		*best = (struct top){v, f};
}

/* Stretches between neighbouring roots, each wholly inside or not. */
static void
find_inside(struct search *s, struct window_found *w, struct top *best)
{
	const struct wanted *c = s->c;
	struct found ends = {0};
	keep(&ends, c->from);
	for (size_t j = 0; j < s->n_side; j++) {
		struct found *root = &s->root[j];
		find_roots(c, &s->side[j], EXACT, s->v, s->f[j], s->n, root);
		for (size_t k = 0; k < root->n; k++)
			keep(&ends, root->v[k]);
	}
	keep(&ends, c->to);
	gsl_sort(ends.v, 1, ends.n);
	w->inside = xcalloc(ends.n, sizeof *w->inside);
	bool joins = false;
	for (size_t k = 1; k < ends.n; k++) {
		double middle = (ends.v[k - 1] + ends.v[k]) / 2;
		if (ends.v[k] - ends.v[k - 1] <= 2 * ROOT)
			continue;
		double margin = margin_at(c, middle);
		better(c, best, middle, margin);
		if (margin >= -EXACT && joins)
			w->inside[w->n_inside - 1].to = ends.v[k];
		else if (margin >= -EXACT)
			w->inside[w->n_inside++] = (struct window_range){
			    .from = ends.v[k - 1], .to = ends.v[k]};
		joins = margin >= -EXACT;
	}
	free(ends.v);
}

static double
climbing(const struct wanted *c, const void *of, double v)
{
	(void)of;
	return margin_at(c, v);
}

static void
find_best(struct search *s, struct window_found *w, struct top best)
{
	const struct wanted *c = s->c;
	for (size_t k = 0; k < s->n; k++)
		better(c, &best, s->v[k], s->margin[k]);
	double a = fmax(best.v - STEP, c->from), b = fmin(best.v + STEP, c->to);
	struct top top = c->coarse ? best : climb(c, climbing, NULL, a, b);
	if (top.f > best.f)
		best = top;
	w->best = best.v;
	w->margin = best.f;
	response_at(c->response, w->best);
	w->best_certain = window_certainty(c);
}

/* Just outside each range a limit is missed. */
static void
find_binding(const struct wanted *c, struct window_found *w)
{
	const double beside = 1e-3;
	for (size_t k = 0; k < w->n_inside; k++) {
		struct window_range *in = &w->inside[k];
		in->low = binding(c, in->from - beside);
		in->high = binding(c, in->to + beside);
		if (in->from <= c->from)
			in->low = NONE;
		if (in->to >= c->to)
			in->high = NONE;
	}
	const struct window_range *in = window_around(w);
	w->low = in != NULL ? in->low : binding(c, w->best - beside);
	w->high = in != NULL ? in->high : binding(c, w->best + beside);
}

/* The nearest roots of condition i below and above the best speed; one that it
 * is not met at has one end of where it is. */
static void
find_ends(const struct search *s, double best, size_t i, double ends[static 2])
{
	ends[0] = ends[1] = NAN;
	for (size_t j = 0; j < s->n_side; j++)
		for (size_t k = 0; s->side[j].i == i && k < s->root[j].n; k++) {
			double v = s->root[j].v[k];
			size_t end = v > best;
			if (isnan(ends[end]) ||
			    fabs(v - best) < fabs(ends[end] - best))
				ends[end] = v;
		}
	struct window_limit limit;
	response_at(s->c->response, best);
	if (window_margin_of(s->c, i, &limit) >= -EXACT)
		return;
	bool above = isnan(ends[0]) || ends[1] - best < best - ends[0];
	double nearest = above ? ends[1] : ends[0];
	ends[0] = above ? nearest : NAN;
	ends[1] = above ? NAN : nearest;
}

static void
find_alone(const struct search *s, struct window_found *w)
{
	w->alone = xcalloc(s->c->n + 1, sizeof *w->alone);
	for (size_t i = 0; i < s->c->n; i++)
		find_ends(s, w->best, i, w->alone[i]);
}

/* To what people see of a margin. */
static bool
misses_alike(const struct search *s, double margin)
{
	size_t k = 0;
	while (k < s->n && margin - s->margin[k] < ROUNDS)
		k++;
	return k == s->n;
}

struct window_found
window_find(const struct wanted *c)
{
	struct window_found w = {0};
	struct search s = {.c = c};
	struct top best = {NAN, -INFINITY};
	s.v = steps(c, &s.n);
	s.margin = xdoubles(s.n);
	w.certain = xdoubles(s.n);
	best.v = c->from;
	look(&s, &w);
	find_inside(&s, &w, &best);
	find_best(&s, &w, best);
	find_binding(c, &w);
	w.alike =
	    w.margin < 0 && isfinite(w.margin) && misses_alike(&s, w.margin);
	w.n = s.n;
	w.speed = s.v;
	find_alone(&s, &w);
	for (size_t j = 0; j < s.n_side; j++) {
		free(s.f[j]);
		free(s.root[j].v);
	}
	free(s.f);
	free(s.root);
	free(s.side);
	free(s.margin);
	return w;
}

void
window_free(struct window_found *w)
{
	free(w->inside);
	free(w->speed);
	free(w->certain);
	free(w->alone);
}

const struct window_range *
window_around(const struct window_found *w)
{
	const struct window_range *nearest = NULL;
	double least = INFINITY;
	for (size_t k = 0; k < w->n_inside; k++) {
		const struct window_range *in = &w->inside[k];
		double beyond = fmax(in->from - w->best, w->best - in->to);
		if (beyond < least)
			nearest = in;
		least = fmin(least, beyond);
	}
	return nearest;
}

void
window_certain(
    const struct window_found *w, double level, double range[static 2])
{
	size_t best = 0;
	for (size_t k = 0; k < w->n; k++)
		if (w->certain[k] > w->certain[best] ||
		    (w->certain[k] == w->certain[best] &&
			fabs(w->speed[k] - w->best) <
			    fabs(w->speed[best] - w->best)))
			best = k;
	size_t low = best, high = best;
	range[0] = range[1] = NAN;
	if (!(w->certain[best] >= level))
		return;
	while (low > 0 && w->certain[low - 1] >= level)
		low--;
	while (high + 1 < w->n && w->certain[high + 1] >= level)
		high++;
	range[0] = w->speed[low];
	range[1] = w->speed[high];
}

/* The last time before, or the first time after, that a draw's distances f
 * [n], at equal steps, rise through 0, whichever is nearer to v. */
static double
crossing(const double *f, size_t n, double from, double step, double v)
{
	double nearest = NAN;
	if (f[0] == 0)
		nearest = from;
	for (size_t k = 1; k < n; k++) {
		if (!(f[k - 1] < 0 && f[k] >= 0))
			continue;
		double part = f[k - 1] / (f[k - 1] - f[k]);
		double at = from + step * ((double)k - 1 + part);
		if (isnan(nearest) || fabs(at - v) < fabs(nearest - v))
			nearest = at;
	}
	if (!isnan(nearest))
		return nearest;
	return f[0] > 0 ? 0 : INFINITY;
}

void
window_spread(const struct wanted *c, size_t i, double value, double v,
    double level, double range[static 2])
{
	enum { STEPS = 48, N = POSTERIOR_DRAWS };
	const double beside = 1e-3;
	struct side side = {i, value, 1, false};
	double f[N][STEPS + 1], speed[N], step = (c->to - c->from) / STEPS;
	range[0] = range[1] = NAN;
	if (response_draws(c->response, i) == NULL)
		return;
	double ahead = fmin(v + beside, c->to), behind = ahead - beside;
	if (moved(c, &side, ahead) < moved(c, &side, behind))
		side.sign = -1;
	for (size_t k = 0; k <= STEPS; k++) {
		response_at(c->response, c->from + step * (double)k);
		for (size_t d = 0; d < N; d++)
			f[d][k] = side_at(c, &side, d);
	}
	for (size_t d = 0; d < N; d++)
		speed[d] = crossing(f[d], STEPS + 1, c->from, step, v);
	ensemble_middle(speed, level, &range[0], &range[1]);
}

/* A quantity and which way is up. */
static double
valued(const struct wanted *c, const void *of, double v)
{
	const struct side *side = of;
	response_answer_at(c->response, v);
	double value = side->sign * response_value(c->response, side->i);
	return isnan(value) ? -INFINITY : value;
}

double
window_extreme(
    const struct wanted *c, const struct window_found *w, size_t i, bool most)
{
	struct side side = {.i = i, .sign = most ? 1 : -1};
	struct top best = {NAN, -INFINITY};
	for (size_t k = 0; k < w->n_inside; k++) {
		const struct window_range *in = &w->inside[k];
		size_t n = (size_t)ceil((in->to - in->from) / STEP) + 1;
		for (size_t j = 0; j <= n; j++) {
			double v = in->from +
				   (in->to - in->from) * (double)j / (double)n;
			double f = valued(c, &side, v);
			if (f > best.f)
				best = (struct top){v, f};
		}
		double a = fmax(best.v - STEP, in->from);
		double b = fmin(best.v + STEP, in->to);
		struct top top = b > a ? climb(c, valued, &side, a, b) : best;
		if (top.f > best.f)
			best = top;
	}
	return best.v;
}
