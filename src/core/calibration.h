/* The inside of a calibration, for the files that make it up.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CALIBRATION_H
#define TIPSPEED_CORE_CALIBRATION_H

#include <stdatomic.h>
#include <string.h>

#include "core/calibrate.h"
#include "core/ga.h"
#include "core/kernel.h"
#include "core/misfit.h"
#include "core/polish.h"

enum {
	SCOUTS = 16,             /* leaders kept of each early generation */
	STARTS = 2 * SCOUTS + 2, /* and the bests of the two phases */
	BATCH = 8,               /* starts or hops polished side by side */
	LEADERS = 64,            /* spread over this many */
	POLISH_STEPS = 300,
	HOPS = 64,           /* fruitless ones in a row that end the polish, */
	HOPS_IN_NOISE = 256, /* and where there is little but noise */
	/* Where the misfit falls ever slower, as it does on the E0_min, alpha,
	 * f_mat ridge, the rest of a hop's way is some few times its last gain;
	 * in noise it is more. */
	HOPE = 16,
	HOPE_IN_NOISE = 200,
	EARLIEST = 25, /* generations before the stop rules apply */
	USE_HOP = 1 << 20
};

/* What one start needs to be polished beside others. */
struct worker {
	struct misfit *misfit;
	struct polish *polish;
	struct params p;
	struct polish_result result;
};

struct calibration {
	struct calibrate_options options;
	uint64_t site_digest;
	struct misfit *misfit;
	struct pool *pool;
	struct kernel *kernel;
	struct ga *ga;
	struct worker worker[BATCH];
	double *told;
	enum calibrate_state state, stop;
	atomic_bool stopped; /* the present step */
	size_t stall, evaluations;
	size_t edits, edited_at; /* of the bounds; generation of the last */
	/* A larger model is calibrated as the smaller one first. */
	bool nested;
	struct bounds box; /* of the present phase */
	size_t phase_from; /* generation that it began at, */
	size_t batches;    /* and what was polished before it */
	double stall_from;
	struct params start[STARTS];
	size_t n_start, done, hops, fruitless;
	size_t n_history, history_room;
	struct calibrate_generation *history;
	struct params best;
	double best_misfit; /* accurate; INFINITY during the search */
};

/* Batches polished so far; the last of the starts may be a short one. */
static inline size_t
calibration_batches(const struct calibration *c)
{
	size_t starts = c->done < c->n_start ? c->done : c->n_start;
	return c->batches + (starts + BATCH - 1) / BATCH +
	       (c->done - starts) / BATCH;
}

/* The best candidate of the search so far. */
static inline struct params
calibration_search_best(const struct calibration *c)
{
	struct params p = {.breakage = c->options.settings.breakage};
	memcpy(p.at, ga_best(c->ga), c->misfit->of->n * sizeof *p.at);
	return p;
}

#endif
