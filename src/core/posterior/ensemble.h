/* The products of a posterior's draws, and the answer computed from them.
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

/* Sets another machine than the measured one: settings with the posterior's
 * method, another k, in proportion to which the strength of every draw is
 * scaled, and a bypass. */
void ensemble_machine(struct ensemble *e, struct model_settings settings);

/* The parts of an ensemble: products of the model alone, which differ by their
 * parameters; products with the discrepancy, the answer; and products with the
 * error of one more sample, as a measurement would show them. */
enum ensemble_part {
	ENSEMBLE_MODEL,
	ENSEMBLE_ANSWER,
	ENSEMBLE_SAMPLE,
	ENSEMBLE_PARTS
};

/* Returns the number of the ensemble's sizes. */
size_t ensemble_sizes(const struct ensemble *e);

/* Moves to tip speed v, m/s; costs nothing at the same speed. */
void ensemble_at(struct ensemble *e, double v);

/* As ensemble_at, but without D23 and the bypass, which saves the products of
 * some sixty speeds: for callers that read the model or differences only. */
void ensemble_draws_at(struct ensemble *e, double v);

/* Returns the products at the ensemble's speed, [n * POSTERIOR_DRAWS] row by
 * size, borrowed.  No product is coarser than the feed, except for samples, and
 * each falls with the size. */
const double *ensemble_products(struct ensemble *e, enum ensemble_part part);

/* Computes the discrepancy of a draw at the ensemble's speed, over h, at the
 * sizes, [n] out: see discrepancy_answer. */
void ensemble_delta(const struct ensemble *e, size_t draw, double *delta);

/* Returns the ensemble's posterior. */
const struct posterior *ensemble_posterior(const struct ensemble *e);

/* Computes the middle `level` of a row of products. */
void ensemble_row_interval(struct ensemble *e, enum ensemble_part part,
    size_t row, double level, double *low, double *high);

/* Computes the mean of the answers, [n] out: the best single answer. */
void ensemble_mean(const struct ensemble *e, double *passing);

/* Computes the middle `level` (0..1) of values [POSTERIOR_DRAWS] and changes
 * their order.  NAN counts as the least value, so that an end may be NAN. */
void ensemble_interval(double *value, double level, double *low, double *high);

/* As ensemble_interval, but keeps the order of the values, and widens the range
 * to hold the answer unless the answer is NAN. */
void ensemble_interval_with_answer(
    const double *draw, double level, double answer, double range[static 2]);

/* Returns the difference between the two halves of the draws, taken at
 * different times, at speed v: between their means or the ends of their bands,
 * whichever is larger, over the width of the band; root mean square over the
 * sizes at which the band is wider than the rounding of sheets. */
double ensemble_halves(struct ensemble *e, double v);

/* Puts values [n] into blocks of neighbours that do not fall from one to the
 * next, each the mean of its own by weights [n]: the nearest in the least
 * squares sense (Barlow and others 1972, ch. 1).  Returns how many; value,
 * weight, length [n]: of each its mean, its weight and how many values it has.
 */
size_t ensemble_pool(double *value, double *weight, size_t *length, size_t n);

#endif
