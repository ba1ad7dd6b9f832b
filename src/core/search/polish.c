/* Bounded Levenberg-Marquardt on the misfit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/polish.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

enum {
	DAMPED = 40, /* evaluations after which secants replace damped steps */
	PATIENCE = 8 /* evaluations between comparisons with the rival */
};

/* Shares of the misfit.  A step that gains less than NO_GAIN, or a descent that
 * gains less than AT_REST, counts as gaining nothing.  If the squared gradient
 * still exceeds STEEP, the point is a crease that no line search leaves. */
static const double NO_GAIN = 1e-13, AT_REST = 1e-11, STEEP = 1e-9;
/* Below this misfit a fit has no residuals. */
static const double EXACT = 1e-24;

struct polish {
	struct misfit *misfit;
	size_t n, width; /* differences, parameters */
	double *r, *J, *r_try, *J_try;
	/* See triangularise_damped_jacobian. */
	double (*A)[PARAMS_MOST + 1], top[PARAMS_MOST];
	double scale[PARAMS_MOST]; /* largest column norms seen (More) */
};

struct polish *
polish_new(struct misfit *m)
{
	struct polish *s = xcalloc(1, sizeof *s);
	size_t n = m->n_residual;
	s->misfit = m;
	s->n = n;
	s->width = m->of->n;
	s->r = xcalloc_doubles(n);
	s->r_try = xcalloc_doubles(n);
	s->J = xcalloc_doubles(n * s->width);
	s->J_try = xcalloc_doubles(n * s->width);
	s->A = xcalloc(n + s->width, sizeof *s->A);
	return s;
}

void
polish_free(struct polish *s)
{
	if (s == NULL)
		return;
	free(s->r);
	free(s->r_try);
	free(s->J);
	free(s->J_try);
	free(s->A);
	free(s);
}

/* Lists the parameters that may move: those neither fixed nor on a bound and,
 * if let_go is true, those on a bound whose gradient leads away from it.
 * Returns their number. */
static size_t
list_movable_params(const struct polish *s, const struct bounds *bounds,
    const struct params *p, bool let_go, size_t column[PARAMS_MOST])
{
	size_t n_free = 0;
	for (size_t j = 0; j < s->width; j++) {
		double gradient = 0, norm = 0, x = p->at[j];
		for (size_t i = 0; i < s->n; i++) {
			double d = s->J[i * s->width + j];
			gradient += s->r[i] * d;
			norm += d * d;
		}
		bool held =
		    bounds->lower[j] >= bounds->upper[j] ||
		    (x <= bounds->lower[j] && !(let_go && gradient <= 0)) ||
		    (x >= bounds->upper[j] && !(let_go && gradient >= 0)) ||
		    !(norm > 0);
		if (!held)
			column[n_free++] = j;
	}
	return n_free;
}

static void
update_jacobian_column_scale(struct polish *s)
{
	for (size_t j = 0; j < s->width; j++) {
		double norm = 0;
		for (size_t i = 0; i < s->n; i++) {
			double d = s->J[i * s->width + j];
			norm += d * d;
		}
		s->scale[j] = fmax(s->scale[j], sqrt(norm));
	}
}

/* Applies to A [rows] the Householder reflection that turns column c into `top`
 * with zeros below; the n columns after it are reflected too.  Column c then
 * holds the direction of the reflection. */
static void
householder_reflect(
    double (*A)[PARAMS_MOST + 1], size_t rows, size_t c, size_t n, double top)
{
	double along[PARAMS_MOST + 1] = {0};
	A[c][c] -= top;
	for (size_t i = c; i < rows; i++)
		for (size_t k = c + 1; k <= c + n; k++)
			along[k] += A[i][c] * A[i][k];
	double half = -top * A[c][c]; /* half the square of the column's
				       * length */
	for (size_t i = c; i < rows; i++)
		for (size_t k = c + 1; k <= c + n; k++)
			A[i][k] -= A[i][c] * (along[k] / half);
}

/* Reduces the first n columns of A [rows] to a triangular matrix R by
 * Householder reflections: the diagonal of R is top [n], the rest is above A's
 * diagonal.  Column n is reflected too.  No library is used because its last
 * bits differ between versions and processors, and would change later
 * perturbations. */
static void
householder_triangle(
    double (*A)[PARAMS_MOST + 1], size_t rows, size_t n, double *top)
{
	for (size_t c = 0; c < n; c++) {
		double norm = 0;
		for (size_t i = c; i < rows; i++)
			norm += A[i][c] * A[i][c];
		top[c] = A[c][c] > 0 ? -sqrt(norm) : sqrt(norm);
		if (norm > 0)
			householder_reflect(A, rows, c, n - c, top[c]);
	}
}

/* Reduces the free columns of J, with the damping stacked below, to a
 * triangular matrix as above; -r, with zeros stacked below, is reflected
 * too. */
static void
triangularise_damped_jacobian(
    struct polish *s, const size_t *column, size_t n_free, double damping)
{
	memset(s->A, 0, (s->n + n_free) * sizeof *s->A);
	for (size_t i = 0; i < s->n; i++) {
		for (size_t c = 0; c < n_free; c++)
			s->A[i][c] = s->J[i * s->width + column[c]];
		s->A[i][n_free] = -s->r[i];
	}
	for (size_t c = 0; c < n_free; c++)
		s->A[s->n + c][c] = sqrt(damping) * s->scale[column[c]];
	householder_triangle(s->A, s->n + n_free, n_free, s->top);
}

/* Computes the step of all parameters: that of the free ones, x, solves R x = z
 * [n_free]; the others do not move. */
static void
solve_step_from_triangle(const struct polish *s, const size_t *column,
    size_t n_free, const double *z, double step[PARAMS_MOST])
{
	double x[PARAMS_MOST];
	memset(step, 0, PARAMS_MOST * sizeof *step);
	for (size_t c = n_free; c-- > 0;) {
		x[c] = z[c];
		for (size_t k = c + 1; k < n_free; k++)
			x[c] -= s->A[c][k] * x[k];
		x[c] = s->top[c] != 0 ? x[c] / s->top[c] : 0;
		step[column[c]] = x[c];
	}
}

/* Solves min |J d + r|^2 + damping |D d|^2 over the free columns. */
static void
solve_damped_step(struct polish *s, const size_t *column, size_t n_free,
    double damping, double step[PARAMS_MOST])
{
	double z[PARAMS_MOST];
	triangularise_damped_jacobian(s, column, n_free, damping);
	for (size_t c = 0; c < n_free; c++)
		z[c] = s->A[c][n_free];
	solve_step_from_triangle(s, column, n_free, z, step);
}

/* Returns the parameters after a step, moved back to the bounds.  Sets *cut if
 * a bound shortened the step. */
static struct params
params_after_step(const struct params *p, const double step[PARAMS_MOST],
    const struct bounds *bounds, bool *cut)
{
	struct params q = *p;
	*cut = false;
	for (size_t j = 0; j < breakage_model_of_params(p)->n; j++) {
		double x = p->at[j] + step[j];
		*cut = *cut || x < bounds->lower[j] || x > bounds->upper[j];
		x = x > bounds->lower[j] ? x : bounds->lower[j];
		q.at[j] = x < bounds->upper[j] ? x : bounds->upper[j];
	}
	return q;
}

struct descent {
	struct polish *s;
	const struct bounds *bounds;
	const struct polish_rival *rival;
	struct params *p;
	struct polish_result result;
	int most;      /* evaluations */
	int small;     /* gains of next to nothing in a row */
	double before; /* misfit PATIENCE evaluations ago */
	bool given_up;
};

/* True if the misfit is so far above the rival's that further gains like the
 * last one, over PATIENCE evaluations, would not reach it, or if it is at the
 * rival's. */
static bool
is_rival_out_of_reach(
    double before, double now, const struct polish_rival *rival)
{
	if (rival == NULL)
		return false;
	double above = now - rival->misfit;
	return fabs(above) < 1e-9 * rival->misfit ||
	       rival->gains * (before - now) < above;
}

static bool
descent_has_ended(const struct descent *d)
{
	return d->result.converged || d->result.stopped || d->given_up ||
	       d->result.evaluations >= d->most;
}

/* True if the rival is better, so that a descent at rest need not be examined
 * further. */
static bool
is_rival_descent_better(const struct descent *d)
{
	return d->rival != NULL && !(d->result.misfit < d->rival->misfit);
}

/* Returns the misfit at q and keeps its r and J for
 * accept_descent_trial. */
static double
evaluate_trial_step(struct descent *d, const struct params *q)
{
	struct polish *s = d->s;
	d->result.stopped = d->result.stopped || misfit_should_stop(s->misfit);
	if (d->result.evaluations % PATIENCE == 0) {
		d->given_up = d->given_up || is_rival_out_of_reach(d->before,
						 d->result.misfit, d->rival);
		d->before = d->result.misfit;
	}
	d->result.evaluations++;
	return misfit_jacobian(s->misfit, q, s->r_try, s->J_try);
}

/* Makes q, the point tried last, the current point. */
static void
accept_descent_trial(struct descent *d, const struct params *q, double trial)
{
	struct polish *s = d->s;
	double *r = s->r, *J = s->J;
	double gain = (d->result.misfit - trial) / d->result.misfit;
	d->small = gain < NO_GAIN ? d->small + 1 : 0;
	d->result.converged = trial < EXACT;
	d->result.misfit = trial;
	*d->p = *q;
	s->r = s->r_try;
	s->r_try = r;
	s->J = s->J_try;
	s->J_try = J;
	update_jacobian_column_scale(s);
}

/* Takes Levenberg-Marquardt steps until they gain nothing or the number of
 * evaluations is reached. */
static void
descend_by_damped_steps(struct descent *d, int evaluations)
{
	const double least_damping = 1e-14, most_damping = 1e12;
	double damping = 1e-2, grow = 2, step[PARAMS_MOST];
	size_t column[PARAMS_MOST];
	while (!descent_has_ended(d) && d->small < 3 &&
	       damping <= most_damping && d->result.evaluations < evaluations) {
		size_t n_free =
		    list_movable_params(d->s, d->bounds, d->p, true, column);
		d->result.converged = n_free == 0;
		if (d->result.converged)
			break;
		solve_damped_step(d->s, column, n_free, damping, step);
		bool cut;
		struct params q =
		    params_after_step(d->p, step, d->bounds, &cut);
		double trial = evaluate_trial_step(d, &q);
		if (trial < d->result.misfit) {
			accept_descent_trial(d, &q, trial);
			damping = fmax(damping / 5, least_damping);
			grow = 2;
		} else {
			damping *= grow;
			grow *= 2;
		}
	}
}

/* The state of a secant method in the coordinates z = R x, where R is the
 * triangular matrix at its start.  g: half the gradient; H: the inverse of its
 * derivative. */
struct secant {
	size_t n, column[PARAMS_MOST];
	double g[PARAMS_MOST], H[PARAMS_MOST][PARAMS_MOST];
};

static void
compute_secant_gradient(const struct polish *s, const struct secant *q,
    const double *r, const double *J, double *g)
{
	for (size_t c = 0; c < q->n; c++) {
		g[c] = 0;
		for (size_t i = 0; i < s->n; i++)
			g[c] += J[i * s->width + q->column[c]] * r[i];
		for (size_t k = 0; k < c; k++)
			g[c] -= s->A[k][c] * g[k];
		g[c] = s->top[c] != 0 ? g[c] / s->top[c] : 0;
	}
}

/* Updates the inverse after a move dz that changed the gradient by dg. */
static void
update_inverse_hessian(struct secant *q, const double *dz, const double *dg)
{
	double along = 0, across = 0, Hg[PARAMS_MOST] = {0};
	for (size_t c = 0; c < q->n; c++) {
		for (size_t k = 0; k < q->n; k++)
			Hg[c] += q->H[c][k] * dg[k];
		along += dz[c] * dg[c];
		across += dg[c] * Hg[c];
	}
	if (!(along > 0))
		return;
	for (size_t c = 0; c < q->n; c++)
		for (size_t k = 0; k < q->n; k++)
			q->H[c][k] += ((1 + across / along) * dz[c] * dz[k] -
					  Hg[c] * dz[k] - dz[c] * Hg[k]) /
				      along;
}

struct move {
	double z[PARAMS_MOST], g[PARAMS_MOST]; /* move, and half the gradient
					        * after it */
	bool cut;                              /* shortened by a bound */
	bool rest;                             /* nothing to gain */
};

/* Searches along -H g, by bisection, for a point that is lower and less steep
 * (weak Wolfe conditions).  Returns false if there is none. */
static bool
search_misfit_along_line(
    struct descent *d, const struct secant *q, struct move *m)
{
	double way[PARAMS_MOST] = {0}, slope = 0, step[PARAMS_MOST];
	double low = 0, high = INFINITY, t = 1;
	for (size_t c = 0; c < q->n; c++) {
		for (size_t k = 0; k < q->n; k++)
			way[c] -= q->H[c][k] * q->g[k];
		slope += way[c] * q->g[c];
	}
	m->rest = -slope <= NO_GAIN * d->result.misfit;
	for (int i = 0; i < 30 && !m->rest && !descent_has_ended(d); i++) {
		double there = 0;
		for (size_t c = 0; c < q->n; c++)
			m->z[c] = t * way[c];
		solve_step_from_triangle(d->s, q->column, q->n, m->z, step);
		struct params p =
		    params_after_step(d->p, step, d->bounds, &m->cut);
		double trial = evaluate_trial_step(d, &p);
		compute_secant_gradient(
		    d->s, q, d->s->r_try, d->s->J_try, m->g);
		for (size_t c = 0; c < q->n; c++)
			there += way[c] * m->g[c];
		if (!(trial < d->result.misfit + 2e-4 * t * slope)) {
			high = t;
		} else if (!m->cut && there < 0.9 * slope) {
			low = t;
		} else {
			accept_descent_trial(d, &p, trial);
			return true;
		}
		t = isinf(high) ? 2 * low : (low + high) / 2;
	}
	return false;
}

/* Continues by a secant method (Broyden, Fletcher, Goldfarb, Shanno), starting
 * from the identity, until it gains nothing or meets a bound.  It learns the
 * curvature that J lacks: where p(u) has a zero at small u, or all of p is
 * small, most of the curvature is that of the residuals themselves, and it
 * jumps where zeros appear and disappear.  There damped steps would zigzag
 * across the valley thousands of times.  Returns true if it gained nothing and
 * the descent has not ended. */
static bool
descend_by_secants(struct descent *d, struct secant *q)
{
	struct move m = {.cut = false};
	double steep = 0, from = d->result.misfit;
	triangularise_damped_jacobian(d->s, q->column, q->n, 1e-4);
	compute_secant_gradient(d->s, q, d->s->r, d->s->J, q->g);
	for (size_t c = 0; c < q->n; c++) {
		q->H[c][c] = 1;
		steep += q->g[c] * q->g[c];
	}
	while (search_misfit_along_line(d, q, &m) && !m.cut) {
		double dg[PARAMS_MOST];
		for (size_t c = 0; c < q->n; c++)
			dg[c] = m.g[c] - q->g[c];
		update_inverse_hessian(q, m.z, dg);
		memcpy(q->g, m.g, sizeof q->g);
	}
	bool idle = from - d->result.misfit <= AT_REST * from && !m.cut;
	d->given_up = d->given_up || (idle && steep > STEEP * from) ||
		      (m.rest && is_rival_descent_better(d));
	return idle && !descent_has_ended(d);
}

/* Parameters on a bound stay there until the others are at rest; only then does
 * the gradient show whether they should leave it. */
static void
descend_to_minimum(struct descent *d)
{
	bool let_go = false;
	while (!descent_has_ended(d)) {
		struct secant q = {0};
		q.n = list_movable_params(
		    d->s, d->bounds, d->p, let_go, q.column);
		bool rest = descend_by_secants(d, &q);
		d->result.converged = d->result.converged || (rest && let_go);
		let_go = rest;
	}
}

struct polish_result
polish_minimise_misfit(struct polish *s, const struct bounds *bounds, int most,
    const struct polish_rival *rival, struct params *p)
{
	struct descent d = {s, bounds, rival, p, .most = most};
	memset(s->scale, 0, sizeof s->scale);
	d.result.misfit = d.before = misfit_jacobian(s->misfit, p, s->r, s->J);
	d.result.evaluations = 1;
	d.given_up = !isfinite(d.result.misfit);
	update_jacobian_column_scale(s);
	descend_by_damped_steps(&d, DAMPED);
	d.given_up =
	    d.given_up || (d.small >= 3 && is_rival_descent_better(&d));
	descend_to_minimum(&d);
	return d.result;
}
