/* The products of a posterior's draws, and the answer computed from them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_ENSEMBLE_H
#define TIPSPEED_CORE_POSTERIOR_ENSEMBLE_H

#include "core/posterior/draws.h"
#include "core/psd/psd.h"

/* The products that all draws predict for one feed, at any speed.  The
 * posterior must outlive it. */
struct ensemble;

/* size [n]: m, coarsest first, each covered by the feed.  The feed's curve is
 * taken to be smooth between its sieves (D18). */
struct ensemble *ensemble_new(const struct posterior *posterior,
    const struct psd *feed, const double *size, size_t n);
void ensemble_free(struct ensemble *e);

/* Sets a machine other than the measured one.  Uses the settings' bypass and k,
 * which scales f_mat in every draw; their method must be the posterior's. */
void ensemble_set_machine_settings(
    struct ensemble *e, struct model_settings settings);

/* The parts of an ensemble: products of the model alone, which differ only in
 * their parameters; products with the discrepancy, whose mean is the answer;
 * and products with the error of one more sample, as a measurement would show
 * them. */
enum ensemble_part {
	ENSEMBLE_MODEL,
	ENSEMBLE_ANSWER,
	ENSEMBLE_SAMPLE,
	ENSEMBLE_PARTS
};

size_t ensemble_count_sieves(const struct ensemble *e);

/* Moves to tip speed v, m/s; does nothing if that is the speed already. */
void ensemble_set_speed(struct ensemble *e, double v);

/* As ensemble_set_speed, but without D23, D25, speed errors and the bypass.
 * This saves computing products at some sixty speeds, for callers that read
 * only the model or differences. */
void ensemble_set_speed_unconstrained(struct ensemble *e, double v);

/* Returns the total speed error in an answer, in errors of one stated speed:
 * that of the speed asked about, combined with that of the mean speed of the
 * runs that inform the draws. */
double ensemble_speed_error_factor(const struct posterior *p);

/* Returns the error of the stated speeds in a draw, in standard deviations. */
double ensemble_speed_error_of_draw(size_t draw);

/* Returns the rotor's true speed, m/s, according to a draw, if v is stated.
 * The error is the same share of all speeds. */
double ensemble_true_speed_of_draw(
    const struct posterior *p, size_t draw, double v);

/* Returns the products at the ensemble's speed [n * POSTERIOR_DRAWS], a row for
 * each size; borrowed.  Except for samples, no product is coarser than the
 * feed.  No passing rises on a finer size. */
const double *ensemble_products(struct ensemble *e, enum ensemble_part part);

/* Computes delta [n], the discrepancy over h of a draw at the ensemble's speed
 * and sizes; see discrepancy_corrected_passing. */
void ensemble_discrepancy_of_draw(
    const struct ensemble *e, size_t draw, double *delta);

const struct posterior *ensemble_posterior(const struct ensemble *e);

/* Computes the interval that holds the middle `level` (0..1) of a row of
 * products. */
void ensemble_interval_at_sieve(struct ensemble *e, enum ensemble_part part,
    size_t row, double level, double *low, double *high);

/* Computes passing [n]: the mean of the answers, which is the best single
 * answer. */
void ensemble_mean_answer(const struct ensemble *e, double *passing);

/* Computes the interval that holds the middle `level` (0..1) of values
 * [POSTERIOR_DRAWS], and changes their order.  NAN counts as the lowest value,
 * so an end may be NAN. */
void ensemble_middle_interval(
    double *value, double level, double *low, double *high);

/* As ensemble_middle_interval, but keeps the order of the values and widens the
 * range to contain the answer, unless that is NAN. */
void ensemble_interval_around_answer(
    const double *draw, double level, double answer, double range[static 2]);

/* Returns the difference at speed v between the two halves of the draws, which
 * were taken at different times.  At each size it is the larger of the
 * differences between their means and between the ends of their bands, divided
 * by the width of the band; the result is the root mean square over the sizes
 * at which the band is wider than the rounding in sheets. */
double ensemble_difference_of_halves(struct ensemble *e, double v);

/* Pools neighbouring values [n] into blocks whose weighted means do not fall
 * from one block to the next: the nearest such sequence in the least-squares
 * sense (Barlow and others 1972, ch. 1).  Sets value, weight and length [n] to
 * the mean, the weight and the number of values of each block, and returns the
 * number of blocks. */
size_t ensemble_pool_falling_values(
    double *value, double *weight, size_t *length, size_t n);

#endif
