/* Circuits: the steady-state flows around a crusher.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_CIRCUIT_H
#define TIPSPEED_CORE_ANSWER_CIRCUIT_H

#include <stdbool.h>

#include "core/answer/crusher.h"
#include "core/psd/screening.h"

/* A feed and a crusher have one output, a screen two (oversize, undersize), a
 * split several, and a stockpile none. */
enum unit_kind {
	UNIT_FEED,
	UNIT_CRUSHER,
	UNIT_SCREEN,
	UNIT_SPLIT,
	UNIT_STOCKPILE,
	UNIT_KINDS
};

enum { UNIT_STREAMS = 16, CIRCUIT_UNITS = 64 };

/* in, out: indices of streams.  share [n_out]: the share of each output of a
 * split, 0..1, with sum 1.  cascade: share of a crusher's input that bypasses
 * the rotor (D14).  speed: a crusher's tip speed, m/s; 0: the speed of the
 * question.  opening: a screen's, m.  price: of a stockpile's material, per t.
 * name: "" if the unit has
 * none. */
struct unit {
	enum unit_kind kind;
	char *name;
	size_t n_in, n_out, in[UNIT_STREAMS], out[UNIT_STREAMS];
	double share[UNIT_STREAMS];
	double cascade, speed, opening, price;
	struct partition partition;
};

/* stream [n_stream]: names.  tph: the rate of the only feed, t/h. */
struct circuit {
	char *name;
	size_t n_unit, n_stream;
	struct unit *unit;
	char **stream;
	double tph;
};

struct circuit *circuit_new(void);
void circuit_free(struct circuit *c);

/* circuit_add_unit adds a unit and returns it, or NULL if there are
 * CIRCUIT_UNITS already.  circuit_find_or_add_stream returns the index of the
 * stream with that name, which it adds if needed. */
struct unit *circuit_add_unit(
    struct circuit *c, enum unit_kind kind, const char *name);
size_t circuit_find_or_add_stream(struct circuit *c, const char *name);

/* Returns the index of the unit that a stream goes to, or n_unit if there is
 * none. */
size_t circuit_destination_of_stream(const struct circuit *c, size_t stream);

/* Return the index of a unit that the feed does not reach, or n_unit, and of a
 * stream from which no stockpile can be reached, or n_stream.  Every stream
 * must have a source and a destination. */
size_t circuit_find_unfed_unit(const struct circuit *c);
size_t circuit_find_trapped_stream(const struct circuit *c);

/* The maximum number of passes over the streams. */
enum { CIRCUIT_PASSES = 2000 };

/* The flows in a circuit, t/h.  draws: 1 for a model alone.  tph [n_stream]:
 * means over the draws; tph_draw [draws][n_stream]: the values in each draw.
 * mass [n_stream][classes]: means by size class.  back [n_stream]: true if the
 * stream closes a loop; circulating: the flow in these streams.  balance: feed
 * minus stockpiles; passes: number of passes; both are the largest in any draw.
 * open: a draw was not steady after CIRCUIT_PASSES; then circulating is that
 * draw's, and the rest is invalid. */
struct flow {
	bool open;
	size_t n_stream, draws, passes;
	double *tph, *tph_draw, *mass;
	bool *back;
	double balance, circulating, *circulating_draw;
};

/* Computes the steady flows.  feed [classes]: the masses of the new feed by
 * class, with sum 1; size: see partition_oversize_of_classes.  transfer
 * [n_unit]: the transfers of the crushers, all with the same number of draws.
 * Method: successive substitution.  Streams that close loops start empty, and
 * all units are computed in turn until these streams change by less than 1e-13
 * of the feed.  The change that remains is the mass-balance error. */
struct flow circuit_compute_flow(const struct circuit *c, const double *feed,
    const double *size, size_t classes, struct transfer *const *transfer);
void flow_free(struct flow *flow);

/* Return the flow into a unit, t/h: the mean, and the value in a draw. */
double flow_tph_into_unit(const struct flow *flow, const struct unit *unit);
double flow_tph_into_unit_in_draw(
    const struct flow *flow, const struct unit *unit, size_t draw);

#endif
