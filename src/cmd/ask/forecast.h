/* Forecasts of a product: any quantity at any speed, for one question.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FORECAST_H
#define TIPSPEED_CMD_ASK_FORECAST_H

#include "cmd/ask/asked.h"
#include "core/answer/predict.h"

/* A quantity of the answer with its band.  The value is NAN beyond the ends of
 * the curve; low and high are NAN without a band. */
struct figure {
	double value, low, high;
};

/* Opaque; the question's entry must outlive it. */
struct forecast;

/* Opens a forecast of quantities [n].  Free with forecast_close. */
struct forecast *forecast_open(const struct session *s,
    const struct question *q, const struct quantity *quantity, size_t n);
void forecast_close(struct forecast *f);

/* Opens a forecast of the quantities in a table of the question's product, in
 * the order of predict_table_quantities. */
struct forecast *forecast_open_table(
    const struct session *s, const struct question *q);

/* Moves the forecast to a speed, m/s. */
void forecast_set_speed(struct forecast *f, double speed);

/* As forecast_set_speed, but with the draws of one more sample or of the model
 * alone. Values are still those of the answer; bands are those of the draws and
 * need not contain the values. */
void forecast_set_speed_and_draws(
    struct forecast *f, double speed, enum ensemble_part part);

/* forecast_value_with_band returns quantity i in its own unit,
 * forecast_value_in_shown_unit in the one that people see
 * (quantities_value_in_shown_unit). */
struct figure forecast_value_with_band(const struct forecast *f, size_t i);
struct figure forecast_value_in_shown_unit(const struct forecast *f, size_t i);

/* Returns quantity i of the model alone. */
double forecast_value_of_model_alone(struct forecast *f, size_t i);

/* Returns the values of quantity i in the draws, [POSTERIOR_DRAWS], borrowed,
 * or NULL if the answer is the model alone or before the first move. */
const double *forecast_draws(const struct forecast *f, size_t i);

/* Compute how far quantity i is above a limit (quantity_excess_as_passing):
 * forecast_excess_over_limit in the answer, forecast_excess_of_draws in each
 * draw.  Call them before another forecast moves. */
double forecast_excess_over_limit(struct forecast *f, size_t i, double limit);
void forecast_excess_of_draws(struct forecast *f, size_t i, double limit,
    double over[static POSTERIOR_DRAWS]);

/* Returns quantity i of the second forecast minus that of the first, each at
 * its own speed.  Draws are paired if both are from one posterior, otherwise
 * independent. */
struct figure forecast_difference(
    const struct forecast *one, const struct forecast *two, size_t i);

/* Returns the table of the question's product or fraction at a speed: passings
 * at all sieves, sizes, and the share that breaks.  Free with
 * prediction_free. */
struct prediction forecast_product(
    const struct session *s, const struct question *q, double speed);

/* Returns the value of a quantity at a speed, m/s. */
double forecast_quantity_at_speed(const struct session *s,
    const struct question *q, const struct quantity *of, double speed);

/* As forecast_product, but for the entry's whole product with the feed of a
 * run. */
struct prediction forecast_whole_product(const struct session *s,
    const struct entry *entry, double speed, size_t feed_run);

#endif
