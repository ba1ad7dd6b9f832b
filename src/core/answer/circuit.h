/* Circuits: what flows where around a crusher, in steady state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_CIRCUIT_H
#define TIPSPEED_CORE_ANSWER_CIRCUIT_H

#include <stdbool.h>

#include "core/answer/crusher.h"
#include "core/psd/screening.h"

/* A feed goes into one stream, a crusher and a stockpile make one stream or
 * none of all they take, a screen makes two: oversize, undersize; a split
 * several, by their shares. */
enum unit_kind {
	UNIT_FEED,
	UNIT_CRUSHER,
	UNIT_SCREEN,
	UNIT_SPLIT,
	UNIT_STOCKPILE,
	UNIT_KINDS
};

enum { UNIT_STREAMS = 16, CIRCUIT_UNITS = 64 };

/* in, out: indices of streams.  share [n_out]: of a split, 0..1, together 1.
 * cascade: share of what a crusher takes that by-passes the rotor (D14); speed:
 * its tip speed, m/s, 0: that of the question.  opening: m.  price: of a
 * stockpile, for each t.  name: "" where there is none. */
struct unit {
	enum unit_kind kind;
	char *name;
	size_t n_in, n_out, in[UNIT_STREAMS], out[UNIT_STREAMS];
	double share[UNIT_STREAMS];
	double cascade, speed, opening, price;
	struct partition partition;
};

/* stream [n_stream]: names.  tph: of its one feed, t/h. */
struct circuit {
	char *name;
	size_t n_unit, n_stream;
	struct unit *unit;
	char **stream;
	double tph;
};

struct circuit *circuit_new(void);
void circuit_free(struct circuit *c);

/* A further unit, which is borrowed until the next one; NULL beyond
 * CIRCUIT_UNITS.  The index of a stream of that name, new or not. */
struct unit *circuit_unit(
    struct circuit *c, enum unit_kind kind, const char *name);
size_t circuit_stream(struct circuit *c, const char *name);

/* The unit that a stream comes from, or goes to; n_unit: none. */
size_t circuit_source(const struct circuit *c, size_t stream);
size_t circuit_use(const struct circuit *c, size_t stream);

/* A unit that nothing of the feed reaches, and a stream from which nothing
 * reaches a stockpile: n_unit and n_stream where there is none such.  Every
 * stream has a source and a use. */
size_t circuit_unfed(const struct circuit *c);
size_t circuit_trapped(const struct circuit *c);

/* The most passes over the streams. */
enum { CIRCUIT_PASSES = 2000 };

/* What flows in a circuit.  draws: 1 for a model alone.  tph [n_stream]: their
 * means, tph_draw [draws][n_stream]: of each.  mass [n_stream][classes]: means.
 * back [n_stream]: whether it closes a loop, so that it circulates;
 * circulating: what does, t/h.  balance: feed less stockpiles, t/h, the largest
 * of all draws; passes: likewise.  open: a draw was not steady after
 * CIRCUIT_PASSES: then circulating is that of this draw, and the rest is not
 * valid. */
struct flow {
	bool open;
	size_t n_stream, classes, draws, passes;
	double *tph, *tph_draw, *mass;
	bool *back;
	double balance, circulating, *circulating_draw;
};

/* feed [classes]: of a unit of the new feed, adds up to 1; transfer [n_unit]:
 * of crushers, all with as many draws.  By successive substitution: streams
 * that close loops begin empty, and all units are computed in turn until these
 * streams change by less than 1e-13 of the feed.  The remaining change is the
 * mass-balance error. */
struct flow circuit_flow(const struct circuit *c, const double *feed,
    const double *size, size_t classes, struct transfer *const *transfer);
void flow_free(struct flow *flow);

/* What goes into a unit, t/h: its mean, and of a draw. */
double flow_into(const struct flow *flow, const struct unit *unit);
double flow_draw_into(
    const struct flow *flow, const struct unit *unit, size_t draw);

#endif
