/* Eq 2 in the limit of fine classes: S is integrated over the feed by
 * Gauss-Legendre panels; B is read from a table for each of their points and
 * each sieve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/continuous.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/numeric/elementary.h"

/* Values of -ln(1 - S) at which the panels end: 1 - S falls to e^-40 over them,
 * and each is short enough for eight points. */
static const double STOP_AT[STOPS] = {0, 2, 6, 16, 40};

/* Makes the edges: the feed's sieves, the product's sieves between them, and
 * enough others that no class is wider than an octave. */
static void
make_size_class_edges(struct continuous_solver *c, const struct psd *feed)
{
	double top = el_log(feed->size[0]);
	double bottom = el_log(feed->size[feed->n - 1]);
	size_t octaves = (size_t)((top - bottom) / 0.69) + 1;
	size_t room = feed->n + c->n_sieve + octaves;
	c->edge = xcalloc_doubles(room);
	size_t n = 0;
	for (size_t i = 0; i < feed->n; i++)
		c->edge[n++] = el_log(feed->size[i]);
	for (size_t i = 0; i < c->n_sieve; i++)
		if (c->log_sieve[i] < top && c->log_sieve[i] > bottom)
			c->edge[n++] = c->log_sieve[i];
	for (size_t i = 1; i < octaves; i++)
		c->edge[n++] =
		    top - (top - bottom) * (double)i / (double)octaves;
	c->n_edge = psd_sort_distinct_sizes(c->edge, n, 1e-12);
}

static void
make_feed_density(struct continuous_solver *c, const struct psd *feed)
{
	c->density = xcalloc_doubles(c->n_edge);
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

struct continuous_solver *
continuous_solver_new(const struct breaker *b, const struct psd *feed,
    const double *sieve, const double *feed_passing, size_t n)
{
	assert(feed->n >= 2 && feed->passing[0] >= 1);
	struct continuous_solver *c = xcalloc(1, sizeof *c);
	c->b = b;
	c->feed_passing = feed_passing;
	c->n_sieve = n;
	c->log_sieve = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++) {
		assert(psd_covers_size(feed, sieve[i]));
		c->log_sieve[i] = el_log(sieve[i]);
	}
	make_size_class_edges(c, feed);
	make_feed_density(c, feed);
	c->point = xcalloc((c->n_edge + STOPS_MOST) * GAUSS, sizeof *c->point);
	return c;
}

void
continuous_solver_free(struct continuous_solver *c)
{
	if (c == NULL)
		return;
	free(c->log_sieve);
	free(c->edge);
	free(c->density);
	free(c->point);
	free(c->above);
	free(c->node);
	free(c);
}

/* Finds the ends for a spectrum: S is a sum over its nodes, with a kink at the
 * break size of each. */
static void
find_integration_ends_for_impacts(struct continuous_solver *c)
{
	struct breaker b = *c->b;
	const struct impacts *of = &b.impacts;
	double stop[STOPS_MOST];
	size_t n = 0;
	for (size_t j = 0; j < of->n; j++) {
		bool end = j == 0 || j + 1 == of->n;
		b.E = of->ratio[j] * c->b->E;
		for (size_t i = 0; i < (end ? STOPS : 1); i++)
			stop[n++] =
			    selection_log_size_at_exponent(&b, STOP_AT[i]);
	}
	/* psd_sort_distinct_sizes puts the largest first. */
	c->n_stop = psd_sort_distinct_sizes(stop, n, 1e-9);
	for (size_t i = 0; i < c->n_stop; i++)
		c->stop[i] = stop[c->n_stop - 1 - i];
}

static void
find_quadrature_panel_ends(struct continuous_solver *c)
{
	for (size_t i = 0; i < STOPS; i++)
		c->stop[i] = selection_log_size_at_exponent(c->b, STOP_AT[i]);
	c->n_stop = STOPS;
	if (c->b->impacts.n > 0)
		find_integration_ends_for_impacts(c);
}

static void
add_quadrature_points(
    const struct continuous_solver *c, const struct panel *panel, void *data)
{
	size_t *n = data;
	double shape[SHAPES][GAUSS];
	selection_shares_by_impacts(c->b, GAUSS, panel->t, shape[0]);
	for (size_t i = 0; i < GAUSS; i++)
		c->point[(*n)++] = (struct point){panel->t[i], panel->weight[i],
		    {shape[0][i], shape[1][i], shape[2][i], shape[3][i]}};
}

static void
make_quadrature_points(struct continuous_solver *c)
{
	c->n_point = 0;
	for (size_t e = 0; e + 1 < c->n_edge; e++)
		continuous_solver_visit_panels(c, c->edge[e + 1], c->edge[e],
		    c->density[e], add_quadrature_points, &c->n_point);
}

/* The step of the table of B: cubics through four nodes give B within 1e-5
 * where p has a kink, and far more exactly elsewhere. */
static const double NODE_STEP = 0.025;

/* Computes B at the nodes; computing it at each point and sieve would take ten
 * times as long. */
static void
tabulate_progeny_shares(struct continuous_solver *c, bool gradient)
{
	const struct breaker *b = c->b;
	size_t n = b->model->n;
	double finest = c->edge[0];
	for (size_t i = 0; i < c->n_sieve; i++)
		finest = fmin(finest, c->log_sieve[i]);
	c->n_node = (size_t)((c->edge[0] - finest) / NODE_STEP) + 4;
	if (c->node == NULL)
		c->node = xcalloc_doubles(c->n_node * ROW_MOST);
	double d[PARAMS_MOST] = {0};
	b->model->finer(b, -0.7, d);
	c->n_moved = 0;
	for (size_t j = 0; gradient && j < n; j++)
		if (d[j] < 0 || d[j] > 0 || j < b->model->gauge)
			c->moved[c->n_moved++] = j;
	c->row = (1 + c->n_moved + AT_ONCE - 1) / AT_ONCE * AT_ONCE;
	for (size_t i = 0; i < c->n_node; i++) {
		double *node = c->node + i * c->row;
		memset(d, 0, sizeof d);
		node[0] = b->model->finer(
		    b, -NODE_STEP * (double)i, gradient ? d : NULL);
		for (size_t k = 0; k < c->n_moved; k++)
			node[1 + k] = d[c->moved[k]];
	}
}

/* Returns the first of the four nodes around a depth, -ln u, and sets their
 * weights. */
static const double *
find_interpolation_nodes(
    const struct continuous_solver *c, double depth, double weight[static 4])
{
	double at = depth / NODE_STEP;
	size_t first = at > 1 ? (size_t)at - 1 : 0;
	first = first + 4 > c->n_node ? c->n_node - 4 : first;
	double t = at - (double)first, a = t - 1, b = t - 2, e = t - 3;
	weight[0] = -a * b * e / 6;
	weight[1] = t * b * e / 2;
	weight[2] = -t * a * e / 2;
	weight[3] = t * a * b / 6;
	return c->node + first * c->row;
}

/* Interpolates between four rows of the table, which have these weights. */
static inline void
interpolate_table_row(const struct continuous_solver *c,
    const double *restrict first, const double weight[static 4],
    double *restrict to)
{
	size_t row = c->row;
	for (size_t k = 0; k < row; k += AT_ONCE, first += AT_ONCE)
		for (size_t j = 0; j < AT_ONCE; j++)
			to[k + j] = weight[0] * first[j] +
				    weight[1] * first[row + j] +
				    weight[2] * first[2 * row + j] +
				    weight[3] * first[3 * row + j];
}

/* Returns the mass broken to below a sieve, without the factor at_size.  Adds
 * its derivatives to row [model's n], if not NULL. */
static double
mass_broken_below_sieve(
    const struct continuous_solver *c, double log_s, double *row)
{
	double by_S[SHAPES] = {0}, by_B[ROW_MOST] = {0}, B[ROW_MOST] = {0};
	for (size_t i = 0; i < c->n_point; i++) {
		const struct point *p = &c->point[i];
		if (p->t <= log_s)
			continue;
		double weight[4];
		const double *first =
		    find_interpolation_nodes(c, p->t - log_s, weight);
		interpolate_table_row(c, first, weight, B);
		for (size_t s = 1; s < SHAPES; s++)
			by_S[s] += p->mass * p->shape[s] * B[0];
		for (size_t k = 0; k < c->row; k += AT_ONCE)
			for (size_t j = k; j < k + AT_ONCE; j++)
				by_B[j] += p->mass * p->shape[0] * B[j];
	}
	for (size_t s = 1; row != NULL && s < SHAPES; s++)
		row[c->b->model->strength + s - 1] += by_S[s];
	for (size_t k = 0; row != NULL && k < c->n_moved; k++)
		row[c->moved[k]] += by_B[1 + k];
	return by_B[0];
}

/* As mass_broken_below_sieve, with the factor at_size. */
static double
mass_broken_below_with_size_factor(
    const struct continuous_solver *c, double log_s, double *row)
{
	const struct breaker *b = c->b;
	double d[PARAMS_MOST] = {0};
	double below = mass_broken_below_sieve(c, log_s, row);
	if (b->model->at_size == NULL)
		return below;
	double factor = b->model->at_size(b, log_s, row != NULL ? d : NULL);
	for (size_t j = 0; row != NULL && j < b->model->n; j++)
		row[j] = factor * row[j] + below * d[j];
	return factor * below;
}

void
continuous_solver_compute_product(
    struct continuous_solver *c, double *passing, double *d_passing)
{
	find_quadrature_panel_ends(c);
	size_t n = c->b->model->n;
	if (d_passing != NULL)
		memset(d_passing, 0, c->n_sieve * n * sizeof *d_passing);
	if (c->b->model->product != NULL) {
		c->b->model->product(c, passing, d_passing);
		return;
	}
	make_quadrature_points(c);
	tabulate_progeny_shares(c, d_passing != NULL);
	bool breaks = breaker_has_progeny(c->b);
	for (size_t i = 0; i < c->n_sieve; i++) {
		double *row = d_passing != NULL ? d_passing + i * n : NULL;
		passing[i] = c->feed_passing[i];
		if (c->log_sieve[i] >= c->edge[0] || !breaks)
			continue;
		passing[i] +=
		    mass_broken_below_with_size_factor(c, c->log_sieve[i], row);
		passing[i] = passing[i] < 1 ? passing[i] : 1;
	}
}

double
continuous_solver_broken_feed_share(struct continuous_solver *c)
{
	double sum = 0;
	find_quadrature_panel_ends(c);
	make_quadrature_points(c);
	for (size_t i = 0; i < c->n_point; i++)
		sum += c->point[i].mass * c->point[i].shape[0];
	return sum;
}
