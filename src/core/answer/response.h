/* Quantities of the product of one feed, at any speed, with their bands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_RESPONSE_H
#define TIPSPEED_CORE_ANSWER_RESPONSE_H

#include "core/posterior/ensemble.h"
#include "core/psd/psd.h"
#include "core/psd/quantity.h"

/* Opaque. */
struct response;

/* size [n]: the sieves, m, coarsest first, see predict_table_sizes.  Between
 * them, also at the sizes that the quantities asked [n_asked] need, the curve
 * is interpolated linearly in log size (D20). */
struct response *response_new(const struct psd *feed, const double *size,
    size_t n, const struct quantity *asked, size_t n_asked,
    const struct params *p, struct model_settings settings);
void response_free(struct response *r);

/* Moves to tip speed v, m/s: for the model alone (e NULL), or with the draws of
 * an ensemble of the same feed and sieves, borrowed until the next move.  of:
 * the part of the ensemble from which draws and bands are read; values are
 * always those of the answer. */
void response_set_speed(
    struct response *r, struct ensemble *e, enum ensemble_part of, double v);

/* Returns quantity i as it was asked; borrowed. */
const struct quantity *response_asked_quantity(
    const struct response *r, size_t i);

/* Return quantity i at the response's speed, for the answer and for the model
 * alone; NAN if the curve does not reach that far. */
double response_value_of_quantity(const struct response *r, size_t i);
double response_value_of_model(struct response *r, size_t i);

double response_tip_speed(const struct response *r);

/* Return the break size at the response's speed, m (see
 * params_break_size_by_impacts), and the band of the draws' break sizes. */
double response_break_size(const struct response *r);
void response_break_size_band(
    const struct response *r, double level, double range[static 2]);

/* For predict_table and the model alone: return the share of the feed that is
 * selected, and whether the product differs from the feed. */
double response_share_selected(struct response *r);
bool response_breaks_feed(struct response *r);

/* Returns the values of quantity i in the draws, [POSTERIOR_DRAWS], borrowed,
 * or NULL for a model alone. */
const double *response_draws_of_quantity(const struct response *r, size_t i);

/* Return how far quantity i is above a limit at the response's speed (see
 * quantity_excess_as_passing), for the answer and, in over, for each draw. */
double response_excess_over_limit(struct response *r, size_t i, double limit);
void response_excess_of_draws(struct response *r, size_t i, double limit,
    double over[static POSTERIOR_DRAWS]);

/* Computes the band of quantity i, the middle `level` of the draws, for
 * ENSEMBLE_ANSWER widened to contain the value; NAN for a model alone. */
void response_band_of_quantity(
    const struct response *r, size_t i, double level, double range[static 2]);

/* Returns the answer's curve of the fraction of quantity i at the response's
 * speed, at the sizes of the product's curve.  Free with psd_free. */
struct psd response_screened_curve(struct response *r, size_t i);

#endif
