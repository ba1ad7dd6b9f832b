/* The only path from a question to numbers: a forecast that uses the draws of
 * outlook.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/forecast.h"

#include "base/xalloc.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/asked.h"
#include "cmd/ask/quantity_words.h"

/* Where a forecast gets its draws from.  They are cached until another site or
 * feed is asked about. */
struct draws_source {
	const struct session *s;
	const struct entry *entry;
	size_t feed;
	const struct params *params;
};

struct forecast *
forecast_open(const struct session *s, const struct question *q,
    const struct quantity *quantity, size_t n)
{
	const struct entry *entry = q->entry;
	const struct psd *feed = site_feed_of_run(entry->site, q->feed);
	struct psd sizes = predict_list_table_sieves(entry->site, feed);
	struct draws_source *asker = xcalloc(1, sizeof *asker);
	*asker = (struct draws_source){
	    s, entry, q->feed, q->params != NULL ? q->params : &entry->params};
	struct forecast *f = forecast_new(feed, sizes.size, sizes.n, quantity,
	    n, asker->params, model_settings_with_scenario(s, entry), q->level);
	forecast_set_user_data(f, asker);
	psd_free(&sizes);
	return f;
}

struct forecast *
forecast_open_for_predict_table(
    const struct session *s, const struct question *q)
{
	const struct site *site = q->entry->site;
	size_t n;
	FREED struct quantity *asked = predict_table_quantities(
	    site, site_feed_of_run(site, q->feed), &q->fraction, &n);
	return forecast_open(s, q, asked, n);
}

void
forecast_set_speed_and_ensemble(
    struct forecast *f, double speed, enum ensemble_part part)
{
	const struct draws_source *a = forecast_user_data(f);
	struct ensemble *e =
	    posterior_if_params_of_entry(a->s, a->entry, a->params) != NULL
		? ensemble_for_answers(a->s, a->entry, a->feed)
		: NULL;
	forecast_move_to_speed(f, e, part, speed);
}

void
forecast_set_speed(struct forecast *f, double speed)
{
	forecast_set_speed_and_ensemble(f, speed, ENSEMBLE_ANSWER);
}

struct figure
forecast_value_in_shown_unit(const struct forecast *f, size_t i)
{
	const struct quantity *q = forecast_get_asked_quantity(f, i);
	struct figure at = forecast_value_with_band(f, i);
	return (struct figure){quantities_value_in_shown_unit(q, at.value),
	    quantities_value_in_shown_unit(q, at.low),
	    quantities_value_in_shown_unit(q, at.high)};
}

struct prediction
forecast_product(
    const struct session *s, const struct question *q, double speed)
{
	struct forecast *f = forecast_open_for_predict_table(s, q);
	forecast_set_speed(f, speed);
	struct prediction p =
	    predict_at_table_sieves(q->entry->site, q->feed, &q->fraction, f);
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
