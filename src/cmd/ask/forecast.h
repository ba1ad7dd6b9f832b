/* Forecasts of a product: the values of quantities at any speed, for one
 * question.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FORECAST_H
#define TIPSPEED_CMD_ASK_FORECAST_H

#include "cmd/ask/asked.h"
#include "core/answer/forecast.h"
#include "core/answer/predict.h"

/* Opens a forecast of quantities [n].  The question's entry must outlive it.
 * Free with forecast_close. */
struct forecast *forecast_open(const struct session *s,
    const struct question *q, const struct quantity *quantity, size_t n);

/* Opens a forecast of the quantities in the table of the question's product, in
 * the order of predict_table_quantities. */
struct forecast *forecast_open_for_predict_table(
    const struct session *s, const struct question *q);

/* Moves the forecast to a speed, m/s. */
void forecast_set_speed(struct forecast *f, double speed);

/* As forecast_set_speed, but with the draws of one more sample, or of the model
 * alone.  The values are still those of the answer; the bands are those of the
 * draws, and need not contain the values. */
void forecast_set_speed_and_ensemble(
    struct forecast *f, double speed, enum ensemble_part part);

/* As forecast_value_with_band, in the unit that users see
 * (quantities_value_in_shown_unit). */
struct figure forecast_value_in_shown_unit(const struct forecast *f, size_t i);

/* Returns the table of the question's product or fraction at a speed: the
 * passing at each sieve, sizes, and the share of the feed that breaks.  Free
 * with prediction_free. */
struct prediction forecast_product(
    const struct session *s, const struct question *q, double speed);

/* Returns the value of a quantity at a speed, m/s. */
double forecast_quantity_at_speed(const struct session *s,
    const struct question *q, const struct quantity *of, double speed);

/* As forecast_product, for the entry's whole product with the feed of a run. */
struct prediction forecast_whole_product(const struct session *s,
    const struct entry *entry, double speed, size_t feed_run);

#endif
