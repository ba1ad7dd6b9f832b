/* Solves a circuit in steady state by successive substitution, for each draw:
 * streams that close loops start empty, and the units are computed in turn
 * until these streams no longer change.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/circuit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

struct circuit *
circuit_new(void)
{
	struct circuit *c = xcalloc(1, sizeof *c);
	c->name = xstrdup("");
	c->unit = xcalloc(CIRCUIT_UNITS, sizeof *c->unit);
	c->stream = xcalloc(
	    (size_t)CIRCUIT_UNITS * UNIT_STREAMS * 2, sizeof(*c->stream));
	return c;
}

void
circuit_free(struct circuit *c)
{
	if (c == NULL)
		return;
	for (size_t u = 0; u < c->n_unit; u++)
		free(c->unit[u].name);
	for (size_t i = 0; i < c->n_stream; i++)
		free(c->stream[i]);
	free(c->name);
	free(c->unit);
	free(c->stream);
	free(c);
}

struct unit *
circuit_add_unit(struct circuit *c, enum unit_kind kind, const char *name)
{
	if (c->n_unit == CIRCUIT_UNITS)
		return NULL;
	struct unit *unit = &c->unit[c->n_unit++];
	*unit = (struct unit){.kind = kind,
	    .name = xstrdup(name),
	    .price = NAN,
	    .partition = PARTITION_IDEAL};
	return unit;
}

size_t
circuit_find_or_add_stream(struct circuit *c, const char *name)
{
	size_t i = 0;
	while (i < c->n_stream && strcmp(c->stream[i], name) != 0)
		i++;
	if (i == c->n_stream)
		c->stream[c->n_stream++] = xstrdup(name);
	return i;
}

static bool
list_contains(const size_t *list, size_t n, size_t what)
{
	for (size_t i = 0; i < n; i++)
		if (list[i] == what)
			return true;
	return false;
}

size_t
circuit_destination_of_stream(const struct circuit *c, size_t stream)
{
	size_t u = 0;
	while (u < c->n_unit &&
	       !list_contains(c->unit[u].in, c->unit[u].n_in, stream))
		u++;
	return u;
}

/* A depth-first walk from the feed.  order: the units, each before the units it
 * leads to, except in loops; filled from the end.  back: streams that lead back
 * to a unit whose walk is not finished. */
struct unit_walk {
	const struct circuit *c;
	enum { WALK_NEW, WALK_UNDER_WAY, WALK_DONE } state[CIRCUIT_UNITS];
	size_t order[CIRCUIT_UNITS], first;
	bool *back;
};

/* The depth of recursion is at most the number of units. */
static void
order_circuit_units_from(struct unit_walk *w, size_t u)
{
	const struct unit *unit = &w->c->unit[u];
	w->state[u] = WALK_UNDER_WAY;
	for (size_t i = 0; i < unit->n_out; i++) {
		size_t next = circuit_destination_of_stream(w->c, unit->out[i]);
		if (w->state[next] == WALK_UNDER_WAY)
			w->back[unit->out[i]] = true;
		else if (w->state[next] == WALK_NEW)
			order_circuit_units_from(w, next);
	}
	w->state[u] = WALK_DONE;
	w->order[--w->first] = u;
}

/* Orders the units and sets back [n_stream]. */
static struct unit_walk
order_circuit_units(const struct circuit *c, bool *back)
{
	struct unit_walk w = {.c = c, .first = c->n_unit, .back = back};
	for (size_t u = 0; u < c->n_unit; u++)
		if (c->unit[u].kind == UNIT_FEED)
			order_circuit_units_from(&w, u);
	return w;
}

size_t
circuit_find_unfed_unit(const struct circuit *c)
{
	FREED bool *back = xcalloc(c->n_stream + 1, sizeof *back);
	struct unit_walk w = order_circuit_units(c, back);
	size_t u = 0;
	while (u < c->n_unit && w.state[u] != WALK_NEW)
		u++;
	return u;
}

size_t
circuit_find_trapped_stream(const struct circuit *c)
{
	bool leads[CIRCUIT_UNITS] = {false};
	for (size_t pass = 0; pass < c->n_unit; pass++)
		for (size_t u = 0; u < c->n_unit; u++) {
			const struct unit *unit = &c->unit[u];
			if (unit->kind == UNIT_STOCKPILE)
				leads[u] = true;
			for (size_t i = 0; i < unit->n_out; i++) {
				size_t to = circuit_destination_of_stream(
				    c, unit->out[i]);
				if (to < c->n_unit && leads[to])
					leads[u] = true;
			}
		}
	for (size_t i = 0; i < c->n_stream; i++) {
		size_t to = circuit_destination_of_stream(c, i);
		if (to < c->n_unit && !leads[to])
			return i;
	}
	return c->n_stream;
}

/* The state of a solution.  over [n_unit][classes]: the share of each class
 * that goes to a screen's oversize; mass [n_stream][classes]: t/h; in, rotor,
 * out [classes]: workspace for the flows of one unit. */
struct circuit_solver {
	const struct circuit *c;
	const double *feed;
	size_t classes;
	struct transfer *const *transfer;
	struct unit_walk walk;
	double *over, *mass, *in, *rotor, *out;
};

static double
sum_of_masses(const double *mass, size_t n)
{
	double sum = 0;
	for (size_t i = 0; i < n; i++)
		sum += mass[i];
	return sum;
}

/* Replaces the masses of a stream.  Returns their change if the stream closes a
 * loop, else 0. */
static double
update_stream_masses(struct circuit_solver *s, size_t stream,
    const double *mass, const double *share, double of)
{
	double *to = s->mass + stream * s->classes, change = 0;
	for (size_t i = 0; i < s->classes; i++) {
		double now = mass[i] * (share != NULL ? share[i] : of);
		change += fabs(now - to[i]);
		to[i] = now;
	}
	return s->walk.back[stream] ? change : 0;
}

/* Computes both outputs from the same numbers, so that no mass is lost. */
static double
separate_by_screen(struct circuit_solver *s, const struct unit *unit, size_t u)
{
	const double *over = s->over + u * s->classes;
	double change = update_stream_masses(s, unit->out[0], s->in, over, 1);
	for (size_t i = 0; i < s->classes; i++)
		s->out[i] = s->in[i] - s->in[i] * over[i];
	return change + update_stream_masses(s, unit->out[1], s->out, NULL, 1);
}

static double
pass_through_crusher(
    struct circuit_solver *s, const struct unit *unit, size_t u, size_t draw)
{
	for (size_t i = 0; i < s->classes; i++)
		s->rotor[i] = s->in[i] * (1 - unit->cascade);
	transfer_compute_product(s->transfer[u], draw, s->rotor, s->out);
	for (size_t i = 0; i < s->classes; i++)
		s->out[i] += s->in[i] * unit->cascade;
	return update_stream_masses(s, unit->out[0], s->out, NULL, 1);
}

/* Computes one unit.  Returns the change of the streams that close loops. */
static double
compute_circuit_unit_outputs(struct circuit_solver *s, size_t u, size_t draw)
{
	const struct unit *unit = &s->c->unit[u];
	double change = 0;
	memset(s->in, 0, s->classes * sizeof *s->in);
	for (size_t k = 0; k < unit->n_in; k++)
		for (size_t i = 0; i < s->classes; i++)
			s->in[i] += s->mass[unit->in[k] * s->classes + i];
	switch (unit->kind) {
	case UNIT_FEED:
		return update_stream_masses(
		    s, unit->out[0], s->feed, NULL, s->c->tph);
	case UNIT_CRUSHER:
		return pass_through_crusher(s, unit, u, draw);
	case UNIT_SCREEN:
		return separate_by_screen(s, unit, u);
	case UNIT_SPLIT:
		for (size_t k = 0; k < unit->n_out; k++)
			change += update_stream_masses(
			    s, unit->out[k], s->in, NULL, unit->share[k]);
		return change;
	case UNIT_STOCKPILE:
	case UNIT_KINDS:
		break;
	}
	return 0;
}

/* Returns the number of passes until the flows are steady, or 0 if they never
 * are.  Starts from the current flows.  A tiny stream may alternate between two
 * values because of rounding, so small changes that no longer shrink count as
 * steady. */
static size_t
circuit_solve(struct circuit_solver *s, size_t draw)
{
	enum { PATIENCE = 10 };
	const double steady = 1e-13, small = 1e-9;
	double least = INFINITY;
	size_t since = 0;
	for (size_t pass = 1; pass <= CIRCUIT_PASSES; pass++) {
		double change = 0;
		for (size_t k = s->walk.first; k < s->c->n_unit; k++)
			change += compute_circuit_unit_outputs(
			    s, s->walk.order[k], draw);
		since = change < least ? 0 : since + 1;
		least = fmin(least, change);
		if (change <= steady * s->c->tph ||
		    (change <= small * s->c->tph && since >= PATIENCE))
			return pass;
	}
	return 0;
}

static void
flow_add_posterior_draw(struct flow *flow, const struct circuit_solver *s,
    size_t draw, size_t passes)
{
	size_t n = s->classes;
	double closing = s->c->tph,
	       *tph = flow->tph_draw + draw * flow->n_stream;
	for (size_t i = 0; i < flow->n_stream; i++) {
		size_t to = circuit_destination_of_stream(s->c, i);
		tph[i] = sum_of_masses(s->mass + i * n, n);
		flow->tph[i] += tph[i] / (double)flow->draws;
		if (flow->back[i])
			flow->circulating_draw[draw] += tph[i];
		if (s->c->unit[to].kind == UNIT_STOCKPILE)
			closing -= tph[i];
	}
	flow->circulating += flow->circulating_draw[draw] / (double)flow->draws;
	for (size_t i = 0; i < flow->n_stream * n; i++)
		flow->mass[i] += s->mass[i] / (double)flow->draws;
	if (!(fabs(closing) <= fabs(flow->balance)))
		flow->balance = closing;
	flow->passes = passes > flow->passes ? passes : flow->passes;
	flow->open = passes == 0;
	if (flow->open)
		flow->circulating = flow->circulating_draw[draw];
}

static struct circuit_solver
circuit_solver_new(const struct circuit *c, const double *feed,
    const double *size, size_t classes, bool *back)
{
	struct circuit_solver s = {.c = c,
	    .feed = feed,
	    .classes = classes,
	    .walk = order_circuit_units(c, back),
	    .over = xcalloc_doubles(c->n_unit * classes),
	    .mass = xcalloc_doubles(c->n_stream * classes),
	    .in = xcalloc_doubles(classes),
	    .rotor = xcalloc_doubles(classes),
	    .out = xcalloc_doubles(classes)};
	for (size_t u = 0; u < c->n_unit; u++)
		if (c->unit[u].kind == UNIT_SCREEN)
			partition_oversize_of_classes(&c->unit[u].partition,
			    c->unit[u].opening, size, classes,
			    s.over + u * classes);
	return s;
}

static void
circuit_solver_free(struct circuit_solver *s)
{
	free(s->over);
	free(s->mass);
	free(s->in);
	free(s->rotor);
	free(s->out);
}

struct flow
circuit_compute_flow(const struct circuit *c, const double *feed,
    const double *size, size_t classes, struct transfer *const *transfer)
{
	struct flow flow = {.n_stream = c->n_stream,
	    .draws = 1,
	    .back = xcalloc(c->n_stream, sizeof *flow.back)};
	for (size_t u = 0; u < c->n_unit; u++)
		if (c->unit[u].kind == UNIT_CRUSHER)
			flow.draws = transfer_count_draws(transfer[u]);
	flow.tph = xcalloc_doubles(c->n_stream);
	flow.tph_draw = xcalloc_doubles(flow.draws * c->n_stream);
	flow.mass = xcalloc_doubles(c->n_stream * classes);
	flow.circulating_draw = xcalloc_doubles(flow.draws);
	struct circuit_solver s =
	    circuit_solver_new(c, feed, size, classes, flow.back);
	s.transfer = transfer;
	/* After a draw that is not steady, the others are not computed, because
	 * they would take as long. */
	for (size_t d = 0; d < flow.draws && !flow.open; d++)
		flow_add_posterior_draw(&flow, &s, d, circuit_solve(&s, d));
	circuit_solver_free(&s);
	return flow;
}

void
flow_free(struct flow *flow)
{
	free(flow->tph);
	free(flow->tph_draw);
	free(flow->mass);
	free(flow->back);
	free(flow->circulating_draw);
	*flow = (struct flow){0};
}

double
flow_tph_into_unit(const struct flow *flow, const struct unit *unit)
{
	double sum = 0;
	for (size_t i = 0; i < unit->n_in; i++)
		sum += flow->tph[unit->in[i]];
	return sum;
}

double
flow_tph_into_unit_in_draw(
    const struct flow *flow, const struct unit *unit, size_t draw)
{
	double sum = 0;
	for (size_t i = 0; i < unit->n_in; i++)
		sum += flow->tph_draw[draw * flow->n_stream + unit->in[i]];
	return sum;
}
