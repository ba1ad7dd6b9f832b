/* Residuals of the candidates of one generation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_CANDIDATES_H
#define TIPSPEED_CORE_SEARCH_CANDIDATES_H

#include "core/search/calibrate.h"
#include "core/psd/site.h"

/* Simulated minus measured passing at a sieve of a training run, -1..1: the
 * 10th, 50th and 90th percentiles of the candidates kept, and the value of the
 * best. */
struct candidates_cell {
	size_t run;
	double size; /* m */
	double p10, median, p90, best;
};

/* cell [n]: run by run, coarsest sieve first.  speed: the slowest training
 * speed; break_size: the quartiles of the candidates' break sizes at that
 * speed, m, INFINITY if nothing breaks. */
struct candidates {
	size_t n;
	struct candidates_cell *cell;
	double speed, break_size[3];
};

/* Computes, on request and not during the search, the residuals of the
 * candidates that a generation kept.  settings, train [n_run]: those of the
 * search.  best is evaluated with the accurate product, the others with the
 * search's scheme.  The caller frees the result with candidates_clear. */
struct candidates candidates_compute_residuals(const struct site *site,
    const bool *train, struct model_settings settings, enum isa isa,
    const struct calibrate_generation *generation, const struct params *best);
void candidates_clear(struct candidates *c);

/* Returns the cell with the largest absolute median residual; there must be at
 * least one cell. */
const struct candidates_cell *candidates_worst_fitted_passing(
    const struct candidates *c);

/* Computes the range of a parameter over the middle 80 % of the candidates, as
 * reported: a parameter in the gauge is divided by the candidate's largest
 * (D4). */
void candidates_p10_p90_of_param(const struct calibrate_generation *generation,
    size_t j, double *p10, double *p90);

#endif
