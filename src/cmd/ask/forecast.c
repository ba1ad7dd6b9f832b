/* The one way from a question to numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/forecast.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/ask/outlook.h"

/* Its draws are those of the question's other answers, which are kept until
 * another site or feed is asked about. */
struct forecast {
	const struct session *s;
	const struct entry *entry;
	size_t feed;
	struct response *response;
	double level;
};

struct forecast *
forecast_open(const struct session *s, const struct question *q,
    const struct quantity *quantity, size_t n)
{
	struct forecast *f = xcalloc(1, sizeof *f);
	*f = (struct forecast){.s = s,
	    .entry = q->entry,
	    .feed = q->feed,
	    .response = outlook_reader(
		s, q->entry, &q->entry->params, q->feed, quantity, n),
	    .level = settings_level(&s->set)};
	return f;
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
forecast_at(struct forecast *f, double speed)
{
	outlook_read_at(
	    f->s, f->entry, &f->entry->params, f->feed, f->response, speed);
}

struct figure
forecast_figure(const struct forecast *f, size_t i)
{
	double range[2];
	response_band(f->response, i, f->level, range);
	return (struct figure){
	    response_value(f->response, i), range[0], range[1]};
}

double
forecast_model(struct forecast *f, size_t i)
{
	return response_model(f->response, i);
}

const double *
forecast_draws(const struct forecast *f, size_t i)
{
	return response_draws(f->response, i);
}

double
forecast_over(struct forecast *f, size_t i, double limit)
{
	return response_over(f->response, i, limit);
}

void
forecast_overs(struct forecast *f, size_t i, double limit, bool sample,
    double over[static POSTERIOR_DRAWS])
{
	response_overs(f->response, i, limit,
	    sample ? ENSEMBLE_SAMPLE : ENSEMBLE_ANSWER, over);
}

struct figure
forecast_difference(
    const struct forecast *one, const struct forecast *two, size_t i)
{
	double more[POSTERIOR_DRAWS];
	const double *a = forecast_draws(one, i), *b = forecast_draws(two, i);
	struct figure f = {
	    response_value(two->response, i) - response_value(one->response, i),
	    NAN, NAN};
	if (a == NULL || b == NULL)
		return f;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		more[d] = b[d] - a[d];
	ensemble_middle(more, one->level, &f.low, &f.high);
	return f;
}
