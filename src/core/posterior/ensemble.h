/* The products of a posterior's draws, and the answer that they make.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_ENSEMBLE_H
#define TIPSPEED_CORE_POSTERIOR_ENSEMBLE_H

#include "core/posterior/draws.h"
#include "core/psd/psd.h"

/* Products of all draws from one feed, at any speed.  The posterior must
 * outlive it. */
struct ensemble;

/* size [n] m, coarsest first, each covered by the feed, which is taken smooth
 * between its sieves (D18). */
struct ensemble *ensemble_new(const struct posterior *posterior,
    const struct psd *feed, const double *size, size_t n);
void ensemble_free(struct ensemble *e);

/* Of another machine than the measured one: settings of the posterior's method
 * with its own k, which the strength of every draw follows, and a share of the
 * feed that goes by the rotor. */
void ensemble_machine(struct ensemble *e, struct model_settings settings);

/* What a row of products is of: the model alone, so that rows differ by their
 * parameters; with the discrepancy, which is the answer; and with the error of
 * one more sample, which is what would be measured. */
enum ensemble_part {
	ENSEMBLE_MODEL,
	ENSEMBLE_ANSWER,
	ENSEMBLE_SAMPLE,
	ENSEMBLE_PARTS
};

/* How many sizes it has. */
size_t ensemble_sizes(const struct ensemble *e);

/* Moves to tip speed v, m/s; where it is already, for nothing. */
void ensemble_at(struct ensemble *e, double v);

/* The same for who wants model and differences only: that no passing falls with
 * the speed, and what goes by the rotor, is left out, and with it the work of
 * some sixty speeds once. */
void ensemble_draws_at(struct ensemble *e, double v);

/* The products at that speed, [n * POSTERIOR_DRAWS] row by size, borrowed.
 * None is coarser than the feed, and each falls with the size, but for the
 * samples, which only fall. */
const double *ensemble_products(struct ensemble *e, enum ensemble_part part);

/* What the model leaves out in a draw at that speed, over h, at the sizes, [n]
 * out: see discrepancy_answer. */
void ensemble_delta(const struct ensemble *e, size_t draw, double *delta);

/* What it is of. */
const struct posterior *ensemble_posterior(const struct ensemble *e);

/* The middle `level` of a row of products. */
void ensemble_band(struct ensemble *e, enum ensemble_part part, size_t row,
    double level, double *low, double *high);

/* The mean of the answers, [n] out: the best single one. */
void ensemble_mean(const struct ensemble *e, double *passing);

/* The middle `level` (0..1) of values [POSTERIOR_DRAWS], whose order changes.
 * NAN counts as the least, and is an end where it is found there. */
void ensemble_middle(double *value, double level, double *low, double *high);

/* The same of values that stay in their order, widened to hold the answer where
 * that is no NAN. */
void ensemble_range(
    const double *draw, double level, double answer, double range[static 2]);

/* How far the draws' two halves, which were taken at different times, lie apart
 * at speed v: their means or the ends of their bands, whichever differ more,
 * over the width of the band; root mean square over the sizes at which it is
 * wider than what sheets are rounded to. */
double ensemble_halves(struct ensemble *e, double v);

#endif
