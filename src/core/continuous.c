/* Eq 2 in the limit of fine classes, by integrals of the broken mass.
 *
 * B(s/x) is, between the zeros of p(u), a combination of 1, ln x, 1/x, 1/x^2
 * and 1/x^3, so five integrals of S dF over x > t give every product exactly:
 *   J_m(t) = integral over x > e^t of S(x) g_m(x) dF,  g = 1, 1/x, .., ln x
 * They are summed from the coarse end, where they are small, so that their
 * differences keep their digits.  The derivatives with respect to f_mat, E0_min
 * and alpha need the same five integrals of dS; those with respect to beta come
 * for nothing, because p is linear in beta between its zeros.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/continuous.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/elementary.h"
#include "core/energy.h"

enum {
	MOMENTS = 5, /* 1, 1/x, 1/x^2, 1/x^3, ln x */
	SHAPES = 4,  /* S, dS/df_mat, dS/dE0_min, dS/dalpha */
	BREAKS = 5,
	GAUSS = 8
};

struct moments {
	double of[SHAPES][MOMENTS];
};

/* Classes between neighbouring edges; density is dF / d ln x.  above[e] holds
 * the integrals over x > exp(edge[e]). */
struct continuous {
	size_t n_sieve, n_edge;
	double *log_sieve, *feed_passing;
	double *edge, *density;
	struct moments *above;
	double k;
	struct params p;
	struct appearance appearance;
	double piece_total[4]; /* of each power of u, over all pieces */
	double E;
	size_t n_shape;
	double stop[BREAKS]; /* ln x where the panels end, rising */
};

/* Values of the exponent f_mat k (x^alpha E - E0_min) at which the panels end:
 * 1 - S falls by e^-40 over them, each short enough for eight points. */
static const double STOP_AT[BREAKS] = {0, 2, 6, 16, 40};

static const double GAUSS_X[GAUSS / 2] = {0.1834346424956498,
    0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
static const double GAUSS_W[GAUSS / 2] = {0.3626837833783620,
    0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

/* Edges: the feed's sieves, the product's sieves between them, and enough
 * others that no class is wider than an octave. */
static void
make_edges(struct continuous *c, const struct psd *feed)
{
	double top = el_log(feed->size[0]);
	double bottom = el_log(feed->size[feed->n - 1]);
	size_t octaves = (size_t)((top - bottom) / 0.69) + 1;
	size_t room = feed->n + c->n_sieve + octaves;
	c->edge = xdoubles(room);
	size_t n = 0;
	for (size_t i = 0; i < feed->n; i++)
		c->edge[n++] = el_log(feed->size[i]);
	for (size_t i = 0; i < c->n_sieve; i++)
		if (c->log_sieve[i] < top && c->log_sieve[i] > bottom)
			c->edge[n++] = c->log_sieve[i];
	for (size_t i = 1; i < octaves; i++)
		c->edge[n++] =
		    top - (top - bottom) * (double)i / (double)octaves;
	c->n_edge = psd_sort(c->edge, n, 1e-12);
}

static void
make_density(struct continuous *c, const struct psd *feed)
{
	c->density = xdoubles(c->n_edge);
	size_t i = 0; /* the feed's interval size[i]..size[i + 1] */
	for (size_t e = 0; e + 1 < c->n_edge; e++) {
		double middle = (c->edge[e] + c->edge[e + 1]) / 2;
		while (i + 2 < feed->n && middle < el_log(feed->size[i + 1]))
			i++;
		double width =
		    el_log(feed->size[i]) - el_log(feed->size[i + 1]);
		c->density[e] =
		    (feed->passing[i] - feed->passing[i + 1]) / width;
	}
}

struct continuous *
continuous_new(const struct psd *feed, const double *sieve, size_t n, double k)
{
	assert(feed->n >= 2 && feed->passing[0] >= 1);
	struct continuous *c = xcalloc(1, sizeof *c);
	c->n_sieve = n;
	c->k = k;
	c->log_sieve = xdoubles(n);
	c->feed_passing = xdoubles(n);
	for (size_t i = 0; i < n; i++) {
		assert(psd_covers(feed, sieve[i]));
		c->log_sieve[i] = el_log(sieve[i]);
		c->feed_passing[i] = psd_passing(feed, sieve[i]);
	}
	make_edges(c, feed);
	make_density(c, feed);
	c->above = xcalloc(c->n_edge, sizeof *c->above);
	return c;
}

void
continuous_free(struct continuous *c)
{
	if (c == NULL)
		return;
	free(c->log_sieve);
	free(c->feed_passing);
	free(c->edge);
	free(c->density);
	free(c->above);
	free(c);
}

/* Integral of u^(power) d ln u, the part of B that belongs to one beta. */
static double
power_primitive(size_t power, double u)
{
	double up = 1;
	for (size_t i = 0; i < power; i++)
		up *= u;
	return power == 0 ? el_log(u) : up / (double)power;
}

void
continuous_set(struct continuous *c, const struct params *p)
{
	c->p = *p;
	params_scale_beta(&c->p);
	c->appearance = appearance_of(c->p.beta);
	for (size_t b = 0; b < 4; b++) {
		c->piece_total[b] = 0;
		for (size_t i = 0; i < c->appearance.n; i++)
			c->piece_total[b] +=
			    power_primitive(b, c->appearance.upper[i]) -
			    power_primitive(b, c->appearance.lower[i]);
	}
}

/* ln x at which f_mat k (x^alpha E - E0_min) reaches the value given. */
static double
log_size_at(const struct continuous *c, double exponent)
{
	const double beyond = 1e3;
	double f = c->p.f_mat * c->k;
	double ratio = (exponent / f + c->p.e0_min) / c->E;
	if (!(ratio > 0))
		return -beyond;
	if (!(ratio < 1e300))
		return beyond;
	double log_ratio = el_log(ratio);
	if (fabs(log_ratio) >= c->p.alpha * beyond)
		return log_ratio < 0 ? -beyond : beyond;
	return log_ratio / c->p.alpha;
}

/* S dF and its derivatives at one point, times the weight, times each g_m. */
static void
add_point(
    const struct continuous *c, double t, double weight, struct moments *sum)
{
	double w = el_exp(c->p.alpha * t);
	double f = c->p.f_mat * c->k;
	double over = w * c->E - c->p.e0_min;
	if (over < 0)
		over = 0;
	double S = -el_expm1(-f * over), kept = 1 - S;
	double shape[SHAPES] = {
	    S, c->k * over * kept, -f * kept, f * c->E * w * t * kept};
	double x1 = el_exp(-t);
	double g[MOMENTS] = {1, x1, x1 * x1, x1 * x1 * x1, t};
	for (size_t i = 0; i < c->n_shape; i++)
		for (size_t m = 0; m < MOMENTS; m++)
			sum->of[i][m] += weight * shape[i] * g[m];
}

/* Adds the integrals over ln x from a to b, within one class. */
static void
add_panel(const struct continuous *c, double a, double b, double density,
    struct moments *sum)
{
	double middle = (a + b) / 2, half = (b - a) / 2;
	for (size_t i = 0; i < GAUSS / 2; i++) {
		double weight = density * half * GAUSS_W[i];
		add_point(c, middle - half * GAUSS_X[i], weight, sum);
		add_point(c, middle + half * GAUSS_X[i], weight, sum);
	}
}

static void
add_stretch(const struct continuous *c, double a, double b, double density,
    struct moments *sum)
{
	if (density <= 0)
		return;
	if (a < c->stop[0])
		a = c->stop[0];
	for (size_t i = 1; i < BREAKS && a < b; i++) {
		if (c->stop[i] <= a)
			continue;
		double end = c->stop[i] < b ? c->stop[i] : b;
		add_panel(c, a, end, density, sum);
		a = end;
	}
	if (a < b)
		add_panel(c, a, b, density, sum);
}

static void
integrate_all(struct continuous *c, double v, size_t n_shape)
{
	c->E = energy_specific(v);
	c->n_shape = n_shape;
	for (size_t i = 0; i < BREAKS; i++)
		c->stop[i] = log_size_at(c, STOP_AT[i]);
	memset(&c->above[0], 0, sizeof c->above[0]);
	for (size_t e = 0; e + 1 < c->n_edge; e++) {
		c->above[e + 1] = c->above[e];
		add_stretch(c, c->edge[e + 1], c->edge[e], c->density[e],
		    &c->above[e + 1]);
	}
}

/* The integrals over x > exp(t). */
static struct moments
moments_above(const struct continuous *c, double t)
{
	size_t low = 0, high = c->n_edge;
	/* Finds the last edge that is not below t. */
	while (high - low > 1) {
		size_t middle = (low + high) / 2;
		if (c->edge[middle] >= t - 1e-12)
			low = middle;
		else
			high = middle;
	}
	struct moments sum = c->above[low];
	bool inside = t < c->edge[low] - 1e-12 && low + 1 < c->n_edge;
	if (inside)
		add_stretch(c, t, c->edge[low], c->density[low], &sum);
	return sum;
}

/* What the stretch of x between two tables of integrals adds to
 * Q_b = integral of S(x) N_b(s/x) dF, N_b the part of B that goes with beta_b
 * where N_b = base_b on the stretch, plus the primitive of u^b if inside a
 * piece of p. */
static void
add_parts(const struct continuous *c, double log_s, const struct moments *from,
    const struct moments *to, const double base[static 4], bool inside,
    double Q[SHAPES][4])
{
	double s = el_exp(log_s), scale[4] = {0, s, s * s / 2, s * s * s / 3};
	for (size_t i = 0; i < c->n_shape; i++) {
		double d[MOMENTS];
		for (size_t m = 0; m < MOMENTS; m++)
			d[m] = from->of[i][m] - to->of[i][m];
		for (size_t b = 0; b < 4; b++)
			Q[i][b] += base[b] * d[0];
		if (!inside)
			continue;
		Q[i][0] += log_s * d[0] - d[4];
		for (size_t b = 1; b < 4; b++)
			Q[i][b] += scale[b] * d[b];
	}
}

/* Walks from u = 2^-10 up to 1, piece by piece of p and the gaps between. */
static void
broken_parts(const struct continuous *c, double log_s, double Q[SHAPES][4])
{
	memset(Q, 0, sizeof(double[SHAPES][4]));
	double full[4] = {0}, base[4];
	struct moments outer = {0}, inner;
	for (size_t i = 0; i < c->appearance.n; i++) {
		double lower = c->appearance.lower[i];
		double upper = c->appearance.upper[i];
		inner = moments_above(c, log_s - el_log(lower));
		add_parts(c, log_s, &inner, &outer, full, false, Q);
		for (size_t b = 0; b < 4; b++)
			base[b] = full[b] - power_primitive(b, lower);
		outer = moments_above(c, log_s - el_log(upper));
		add_parts(c, log_s, &outer, &inner, base, true, Q);
		for (size_t b = 0; b < 4; b++)
			full[b] = base[b] + power_primitive(b, upper);
	}
	inner = moments_above(c, log_s);
	add_parts(c, log_s, &inner, &outer, full, false, Q);
}

static double
combined(const struct continuous *c, const double parts[static 4])
{
	double sum = 0;
	for (size_t b = 0; b < 4; b++)
		sum += c->p.beta[b] * parts[b];
	return sum;
}

/* Derivatives of (sum beta_b Q_b) / (sum beta_b T_b).  beta was scaled by its
 * largest value; the caller's beta moves the product that much less. */
static void
fill_row(const struct continuous *c, double broken, double total,
    double Q[SHAPES][4], double *row)
{
	for (size_t b = 0; b < 4; b++)
		row[b] = (Q[0][b] - broken * c->piece_total[b]) / total;
	row[PARAM_F_MAT] = combined(c, Q[1]) / total;
	row[PARAM_E0_MIN] = combined(c, Q[2]) / total;
	row[PARAM_ALPHA] = combined(c, Q[3]) / total;
}

void
continuous_product(
    struct continuous *c, double v, double *passing, double *d_passing)
{
	integrate_all(c, v, d_passing != NULL ? SHAPES : 1);
	double total = combined(c, c->piece_total);
	for (size_t i = 0; i < c->n_sieve; i++) {
		double *row =
		    d_passing != NULL ? d_passing + i * PARAM_COUNT : NULL;
		passing[i] = c->feed_passing[i];
		if (row != NULL)
			memset(row, 0, PARAM_COUNT * sizeof *row);
		if (c->log_sieve[i] >= c->edge[0] || !(total > 0))
			continue;
		double Q[SHAPES][4];
		broken_parts(c, c->log_sieve[i], Q);
		double broken = combined(c, Q[0]) / total;
		if (row != NULL)
			fill_row(c, broken, total, Q, row);
		passing[i] += broken;
		passing[i] = passing[i] < 1 ? passing[i] : 1;
	}
}

double
continuous_selected(struct continuous *c, double v)
{
	integrate_all(c, v, 1);
	return c->above[c->n_edge - 1].of[0][0];
}
