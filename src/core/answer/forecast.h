/* Quantities of the product of one feed, at any speed, with their bands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_FORECAST_H
#define TIPSPEED_CORE_ANSWER_FORECAST_H

#include "core/posterior/ensemble.h"
#include "core/psd/psd.h"
#include "core/psd/quantity.h"

/* A quantity of the answer with its band.  The value is NAN beyond the ends of
 * the curve; low and high are NAN without a band. */
struct figure {
	double value, low, high;
};

struct forecast;

/* size [n]: the sieves, m, coarsest first; see predict_list_table_sieves.
 * Between them, the curve is interpolated linearly in log size (D20), also at
 * the sizes that the quantities asked [n_asked] need.  level: of the bands,
 * 0..1. */
struct forecast *forecast_new(const struct psd *feed, const double *size,
    size_t n, const struct quantity *asked, size_t n_asked,
    const struct params *p, struct model_settings settings, double level);
void forecast_close(struct forecast *f);

/* Store and return data with which the caller finds an ensemble.  The forecast
 * owns the data, which free() must be able to free; NULL if none was set. */
void forecast_set_user_data(struct forecast *f, void *asker);
const void *forecast_user_data(const struct forecast *f);

/* Moves to tip speed v, m/s.  e: an ensemble of the same feed and sieves,
 * borrowed until the next move, or NULL for the model alone.  of: the part of
 * the ensemble from which draws and bands are read; values are always the
 * answer's. */
void forecast_move_to_speed(
    struct forecast *f, struct ensemble *e, enum ensemble_part of, double v);

/* Returns quantity i as asked; borrowed. */
const struct quantity *forecast_get_asked_quantity(
    const struct forecast *f, size_t i);

/* Returns quantity i in its own unit.  The band is the middle `level` of the
 * draws, widened to contain the value if they are of ENSEMBLE_ANSWER. */
struct figure forecast_value_with_band(const struct forecast *f, size_t i);

double forecast_value_of_model_alone(struct forecast *f, size_t i);

double forecast_tip_speed(const struct forecast *f);

/* Returns the break size, m (see params_break_size_by_impacts), with the band
 * of the draws' break sizes. */
struct figure forecast_break_size(const struct forecast *f);

/* For predict_at_table_sieves.  Return, for the model alone, the share of the
 * feed that is selected, and true if the product differs from the feed. */
double forecast_broken_feed_share(struct forecast *f);
bool forecast_is_feed_broken(struct forecast *f);

/* Returns the values [POSTERIOR_DRAWS] of quantity i in the draws, borrowed, or
 * NULL before the first move with an ensemble. */
const double *forecast_draws_of_quantity(const struct forecast *f, size_t i);

/* Compute how far quantity i is above a limit (quantity_excess_as_passing):
 * forecast_excess_over_limit in the answer, forecast_excess_in_each_draw in
 * each draw.  Call them before another forecast moves. */
double forecast_excess_over_limit(struct forecast *f, size_t i, double limit);
void forecast_excess_in_each_draw(struct forecast *f, size_t i, double limit,
    double over[static POSTERIOR_DRAWS]);

/* Returns quantity i of the second forecast minus that of the first, each at
 * its own speed.  The difference is taken draw by draw: draws of one posterior
 * are paired, those of two are independent.  An end is NAN if so many draws are
 * beyond the curve that it may lie there. */
struct figure forecast_difference(
    const struct forecast *one, const struct forecast *two, size_t i);

/* Returns the answer's curve of the fraction that quantity i is about, at the
 * sizes of the product's curve.  Free with psd_free. */
struct psd forecast_screened_curve(struct forecast *f, size_t i);

#endif
