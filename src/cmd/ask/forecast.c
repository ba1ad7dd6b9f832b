/* The only path from a question to numbers: a response and the draws of
 * outlook.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/forecast.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/asked.h"
#include "cmd/ask/quantity_words.h"

/* It borrows the draws that are kept until another site or feed is asked
 * about. */
struct forecast {
	const struct session *s;
	const struct entry *entry;
	size_t feed;
	const struct params *params;
	struct response *response;
	double level;
};

struct forecast *
forecast_open(const struct session *s, const struct question *q,
    const struct quantity *quantity, size_t n)
{
	const struct entry *entry = q->entry;
	const struct psd *feed = site_feed_of_run(entry->site, q->feed);
	struct psd sizes = predict_table_sizes(entry->site, feed);
	struct forecast *f = xcalloc(1, sizeof *f);
	*f = (struct forecast){.s = s,
	    .entry = entry,
	    .feed = q->feed,
	    .params = q->params != NULL ? q->params : &entry->params,
	    .level = q->level};
	f->response = response_new(feed, sizes.size, sizes.n, quantity, n,
	    f->params, model_settings_of_answer(s, entry));
	psd_free(&sizes);
	return f;
}

struct forecast *
forecast_open_table(const struct session *s, const struct question *q)
{
	const struct site *site = q->entry->site;
	size_t n;
	FREED struct quantity *asked = predict_table_quantities(
	    site, site_feed_of_run(site, q->feed), &q->fraction, &n);
	return forecast_open(s, q, asked, n);
}

void
forecast_close(struct forecast *f)
{
	if (f == NULL)
		return;
	response_free(f->response);
	free(f);
}

void
forecast_set_speed_and_draws(
    struct forecast *f, double speed, enum ensemble_part part)
{
	struct ensemble *e =
	    posterior_for_answers(f->s, f->entry, f->params) != NULL
		? ensemble_for_answers(f->s, f->entry, f->feed)
		: NULL;
	response_set_speed(f->response, e, part, speed);
}

void
forecast_set_speed(struct forecast *f, double speed)
{
	forecast_set_speed_and_draws(f, speed, ENSEMBLE_ANSWER);
}

struct figure
forecast_value_with_band(const struct forecast *f, size_t i)
{
	double range[2];
	response_band_of_quantity(f->response, i, f->level, range);
	return (struct figure){
	    response_value_of_quantity(f->response, i), range[0], range[1]};
}

struct figure
forecast_value_in_shown_unit(const struct forecast *f, size_t i)
{
	const struct quantity *q = response_asked_quantity(f->response, i);
	struct figure at = forecast_value_with_band(f, i);
	return (struct figure){quantities_value_in_shown_unit(q, at.value),
	    quantities_value_in_shown_unit(q, at.low),
	    quantities_value_in_shown_unit(q, at.high)};
}

double
forecast_value_of_model_alone(struct forecast *f, size_t i)
{
	return response_value_of_model(f->response, i);
}

const double *
forecast_draws(const struct forecast *f, size_t i)
{
	return response_draws_of_quantity(f->response, i);
}

double
forecast_excess_over_limit(struct forecast *f, size_t i, double limit)
{
	return response_excess_over_limit(f->response, i, limit);
}

void
forecast_excess_of_draws(struct forecast *f, size_t i, double limit,
    double over[static POSTERIOR_DRAWS])
{
	response_excess_of_draws(f->response, i, limit, over);
}

struct figure
forecast_difference(
    const struct forecast *one, const struct forecast *two, size_t i)
{
	double more[POSTERIOR_DRAWS];
	const double *a = forecast_draws(one, i), *b = forecast_draws(two, i);
	double range[2] = {NAN, NAN};
	for (size_t d = 0; d < POSTERIOR_DRAWS && a != NULL && b != NULL; d++)
		more[d] = b[d] - a[d];
	if (a != NULL && b != NULL)
		ensemble_interval_around_answer(more, one->level, NAN, range);
	return (struct figure){response_value_of_quantity(two->response, i) -
				   response_value_of_quantity(one->response, i),
	    range[0], range[1]};
}

struct prediction
forecast_product(
    const struct session *s, const struct question *q, double speed)
{
	struct forecast *f = forecast_open_table(s, q);
	forecast_set_speed(f, speed);
	struct prediction p = predict_table(
	    q->entry->site, q->feed, &q->fraction, f->response, f->level);
	forecast_close(f);
	return p;
}

double
forecast_quantity_at_speed(const struct session *s, const struct question *q,
    const struct quantity *of, double speed)
{
	struct forecast *f = forecast_open(s, q, of, 1);
	forecast_set_speed(f, speed);
	double value = forecast_value_with_band(f, 0).value;
	forecast_close(f);
	return value;
}

struct prediction
forecast_whole_product(const struct session *s, const struct entry *entry,
    double speed, size_t feed_run)
{
	const struct question q = question_of_whole_product(s, entry, feed_run);
	return forecast_product(s, &q, speed);
}
