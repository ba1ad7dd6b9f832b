/* Quantities of the product of one feed, at any speed, with their bands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_RESPONSE_H
#define TIPSPEED_CORE_ANSWER_RESPONSE_H

#include "core/posterior/ensemble.h"
#include "core/psd/psd.h"
#include "core/psd/quantity.h"

/* Opaque. */
struct response;

/* size [n]: the sieves, m, coarsest first, see predict_sizes; between them the
 * curve is read straight on log size (D20), also at the sizes that the
 * quantities asked [n_asked] need. */
struct response *response_new(const struct psd *feed, const double *size,
    size_t n, const struct quantity *asked, size_t n_asked,
    const struct params *p, struct model_settings settings);
void response_free(struct response *r);

/* Moves to tip speed v, m/s: for the model alone (e NULL), or with the draws of
 * an ensemble of the same feed and sieves, borrowed until the next move.  of:
 * the part of the ensemble that draws and bands are read from; values are
 * always the answer's. */
void response_at(
    struct response *r, struct ensemble *e, enum ensemble_part of, double v);

/* Return quantity i at the response's speed: of the answer, and of the model
 * alone.  NAN where the curve does not reach that far. */
double response_value(const struct response *r, size_t i);
double response_model(struct response *r, size_t i);

double response_speed(const struct response *r);

/* Return the break size at the response's speed, m, see params_break_size, and
 * the band of the draws' break sizes. */
double response_break_size(const struct response *r);
void response_break_band(
    const struct response *r, double level, double range[static 2]);

/* For predict_table, for the model alone: return the share of the feed that is
 * selected, and whether the product differs from the feed. */
double response_selected(struct response *r);
bool response_breaks(struct response *r);

/* Returns the values of quantity i in the draws, [POSTERIOR_DRAWS], borrowed;
 * NULL for a model alone. */
const double *response_draws(const struct response *r, size_t i);

/* Return the distance of quantity i above a limit at the response's speed, see
 * quantity_over: of the answer; of the draws, [POSTERIOR_DRAWS] out. */
double response_excess(struct response *r, size_t i, double limit);
void response_excess_draws(struct response *r, size_t i, double limit,
    double over[static POSTERIOR_DRAWS]);

/* Computes the band of quantity i, the middle `level` of the draws, for
 * ENSEMBLE_ANSWER widened to hold the value; NAN for a model alone. */
void response_band(
    const struct response *r, size_t i, double level, double range[static 2]);

/* Returns the answer's curve of the fraction of quantity i at the response's
 * speed, at the sizes of the product's curve; psd_free. */
struct psd response_screened(const struct response *r, size_t i);

#endif
