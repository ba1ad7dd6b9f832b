/* Circuits: what flows where around a crusher, in steady state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_CIRCUIT_H
#define TIPSPEED_CORE_ANSWER_CIRCUIT_H

#include <stdbool.h>

#include "core/answer/crusher.h"
#include "core/psd/screening.h"

/* A feed has one output stream.  A crusher has one output for all of its
 * inputs, a stockpile none, a screen two: oversize, undersize; a split several,
 * by their shares. */
enum unit_kind {
	UNIT_FEED,
	UNIT_CRUSHER,
	UNIT_SCREEN,
	UNIT_SPLIT,
	UNIT_STOCKPILE,
	UNIT_KINDS
};

enum { UNIT_STREAMS = 16, CIRCUIT_UNITS = 64 };

/* in, out: indices of streams.  share [n_out]: the shares of a split's outputs,
 * 0..1, which add up to 1.  cascade: share of a crusher's input that bypasses
 * the rotor (D14).  speed: the crusher's tip speed, m/s; 0: the speed of the
 * question.  opening: of a screen, m.  price: of a stockpile, for each t.
 * name: "" where the unit has none. */
struct unit {
	enum unit_kind kind;
	char *name;
	size_t n_in, n_out, in[UNIT_STREAMS], out[UNIT_STREAMS];
	double share[UNIT_STREAMS];
	double cascade, speed, opening, price;
	struct partition partition;
};

/* stream [n_stream]: names.  tph: the rate of its one feed, t/h. */
struct circuit {
	char *name;
	size_t n_unit, n_stream;
	struct unit *unit;
	char **stream;
	double tph;
};

struct circuit *circuit_new(void);
void circuit_free(struct circuit *c);

/* circuit_unit: adds a unit and returns it, borrowed until the next is added;
 * NULL beyond CIRCUIT_UNITS.  circuit_stream: returns the index of the stream
 * of that name, new or not. */
struct unit *circuit_unit(
    struct circuit *c, enum unit_kind kind, const char *name);
size_t circuit_stream(struct circuit *c, const char *name);

/* Return the index of the unit that a stream comes from, or goes to; n_unit
 * where there is none. */
size_t circuit_source(const struct circuit *c, size_t stream);
size_t circuit_destination(const struct circuit *c, size_t stream);

/* Return a unit that no part of the feed reaches, and a stream from which
 * nothing reaches a stockpile; n_unit and n_stream where there is none.  Every
 * stream has a source and a use. */
size_t circuit_unfed(const struct circuit *c);
size_t circuit_trapped(const struct circuit *c);

/* The most passes over the streams. */
enum { CIRCUIT_PASSES = 2000 };

/* The flows in a circuit.  draws: 1 for a model alone.  tph [n_stream]: means
 * over the draws; tph_draw [draws][n_stream]: the value of each draw.  mass
 * [n_stream][classes]: means.  back [n_stream]: whether the stream closes a
 * loop, so that it circulates; circulating: the flow that circulates, t/h.
 * balance: feed less stockpiles, t/h, the largest of all draws; passes: the
 * most of all draws.  open: a draw was not steady after CIRCUIT_PASSES: then
 * circulating is the value of this draw, and the rest is not valid. */
struct flow {
	bool open;
	size_t n_stream, classes, draws, passes;
	double *tph, *tph_draw, *mass;
	bool *back;
	double balance, circulating, *circulating_draw;
};

/* feed [classes]: the new feed's masses by class, which add up to 1.  transfer
 * [n_unit]: the transfers of the crushers, all with the same number of draws.
 * The method is successive substitution: streams that close loops begin empty,
 * and all units are computed in turn until these streams change by less than
 * 1e-13 of the feed.  The remaining change is the mass-balance error. */
struct flow circuit_flow(const struct circuit *c, const double *feed,
    const double *size, size_t classes, struct transfer *const *transfer);
void flow_free(struct flow *flow);

/* Return the flow into a unit, t/h: its mean, and its value in a draw. */
double flow_into_unit(const struct flow *flow, const struct unit *unit);
double flow_draw_into_unit(
    const struct flow *flow, const struct unit *unit, size_t draw);

#endif
