/* What is forecast of a product: any quantity at any speed, of one question.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FORECAST_H
#define TIPSPEED_CMD_ASK_FORECAST_H

#include "cmd/ask/asked.h"
#include "core/answer/predict.h"

/* A quantity of the answer with its band; NAN where the curve does not reach so
 * far, and where there is no band. */
struct figure {
	double value, low, high;
};

/* Opaque; the question's entry must outlive it. */
struct forecast;

/* Of quantities [n]; forecast_close. */
struct forecast *forecast_open(const struct session *s,
    const struct question *q, const struct quantity *quantity, size_t n);
void forecast_close(struct forecast *f);

/* Of what a table of the question's product shows, in the order of
 * predict_asks. */
struct forecast *forecast_table(
    const struct session *s, const struct question *q);

/* Moves to a speed, m/s. */
void forecast_at(struct forecast *f, double speed);

/* The same with other draws beside the answer's values, of one more sample, or
 * of the model alone: bands are then of these, and not widened to hold the
 * value. */
void forecast_part_at(
    struct forecast *f, double speed, enum ensemble_part part);

struct figure forecast_figure(const struct forecast *f, size_t i);

/* The same of the model alone. */
double forecast_model(struct forecast *f, size_t i);

/* Its values in the draws, [POSTERIOR_DRAWS], borrowed; NULL where the answer
 * is the model alone, and before the first move. */
const double *forecast_draws(const struct forecast *f, size_t i);

/* By how much it lies above a limit, see quantity_over: of the answer; of the
 * draws, [POSTERIOR_DRAWS] out, which are asked before another forecast moves.
 */
double forecast_over(struct forecast *f, size_t i, double limit);
void forecast_overs(struct forecast *f, size_t i, double limit,
    double over[static POSTERIOR_DRAWS]);

/* How much more the second has of quantity i than the first, each at its speed.
 * Their draws go together where both are of one posterior and are independent
 * where they are not. */
struct figure forecast_difference(
    const struct forecast *one, const struct forecast *two, size_t i);

/* The table of the question's product, or of the fraction that it asks for, at
 * a speed: passings at all sieves, sizes, what breaks; prediction_free. */
struct prediction forecast_product(
    const struct session *s, const struct question *q, double speed);

/* The same of the site's whole product with the feed of a run, as it stands. */
struct prediction forecast_whole(const struct session *s,
    const struct entry *entry, double speed, size_t feed_run);

#endif
