/* Moves measured products to a feed, and caches those for one site and feed,
 * because each step of the slider shows them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/moved.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/screened.h"
#include "cmd/ask/asked.h"

/* The moved products of one site, for one feed, parameters and settings. */
struct moved {
	const struct site *site;
	uint64_t digest;
	const struct posterior *posterior;
	struct params drawn; /* the first draw, because addresses are reused */
	struct params params;
	struct model_settings settings;
	size_t feed, n;
	/* For each run [n] that was asked for: its moved product, and the
	 * largest change of a passing. */
	struct psd *product;
	double *most;
};

struct moved *
moved_products_new(void)
{
	return xcalloc(1, sizeof(struct moved));
}

void
moved_products_discard(struct moved *m)
{
	for (size_t r = 0; r < m->n; r++)
		psd_free(&m->product[r]);
	free(m->product);
	free(m->most);
	*m = (struct moved){0};
}

void
moved_products_free(struct moved *m)
{
	moved_products_discard(m);
	free(m);
}

/* Opens a forecast of the passings at these sieves, at a speed. */
static struct forecast *
open_forecast_of_passings(const struct session *s, const struct question *q,
    const struct psd *sieves, double speed)
{
	FREED struct quantity *asked = xcalloc(sieves->n, sizeof *asked);
	for (size_t i = 0; i < sieves->n; i++)
		asked[i] = (struct quantity){
		    .kind = QUANTITY_PASSING, .x = sieves->size[i]};
	struct forecast *f = forecast_open(s, q, asked, sieves->n);
	forecast_set_speed(f, speed);
	return f;
}

/* Keeps passings between 0 and 1, and no larger at a finer sieve. */
static void
compute_product_moved_to_feed(struct moved *m, const struct session *s,
    const struct entry *entry, size_t run)
{
	const struct run *r = &entry->site->run[run];
	struct psd *product = &m->product[run];
	*product = psd_copy(&r->product);
	if (product->n == 0 ||
	    psd_is_same(&r->feed, site_feed_of_run(m->site, m->feed)))
		return;
	struct question q = question_of_whole_product(s, entry, m->feed);
	q.params = &m->params;
	struct question own = q;
	own.feed = run;
	struct forecast *to =
	    open_forecast_of_passings(s, &q, product, r->speed);
	struct forecast *from =
	    open_forecast_of_passings(s, &own, product, r->speed);
	for (size_t i = 0; i < product->n; i++) {
		double more = forecast_value_with_band(to, i).value -
			      forecast_value_with_band(from, i).value;
		if (!isfinite(more))
			more = 0;
		double most = i > 0 ? product->passing[i - 1] : 1;
		product->passing[i] =
		    fmin(fmax(product->passing[i] + more, 0), most);
		m->most[run] = fmax(m->most[run], fabs(more));
	}
	forecast_close(to);
	forecast_close(from);
}

static struct moved *
moved_products_cache_for_feed(const struct session *s,
    const struct entry *entry, const struct params *params, size_t feed_run)
{
	struct moved *m = s->moved;
	const struct site *site = entry->site;
	const struct posterior *posterior =
	    posterior_if_params_of_entry(s, entry, params);
	struct model_settings settings = model_settings_with_scenario(s, entry);
	const struct params *drawn =
	    posterior != NULL ? &posterior->draw[0].params : params;
	if (m->site == site && m->digest == site->digest &&
	    m->feed == feed_run && m->posterior == posterior &&
	    memcmp(&m->params, params, sizeof *params) == 0 &&
	    memcmp(&m->drawn, drawn, sizeof *drawn) == 0 &&
	    model_settings_are_same(&m->settings, &settings))
		return m;
	moved_products_discard(m);
	*m = (struct moved){.site = site,
	    .digest = site->digest,
	    .posterior = posterior,
	    .drawn = *drawn,
	    .params = *params,
	    .settings = settings,
	    .feed = feed_run,
	    .n = site->n_run,
	    .product = xcalloc(site->n_run, sizeof *m->product),
	    .most = xcalloc_doubles(site->n_run)};
	return m;
}

const struct psd *
measured_product_moved_to_feed(const struct session *s,
    const struct entry *entry, const struct params *params, size_t run,
    size_t feed_run)
{
	const struct psd *measured = &entry->site->run[run].product;
	if (params == NULL || !entry->site->individual_feeds)
		return measured;
	struct moved *m =
	    moved_products_cache_for_feed(s, entry, params, feed_run);
	if (measured->n > 0 && m->product[run].n == 0)
		compute_product_moved_to_feed(m, s, entry, run);
	return &m->product[run];
}

double
largest_change_by_moving_to_feed(const struct session *s,
    const struct entry *entry, const struct params *params, size_t run,
    size_t feed_run)
{
	const struct site *site = entry->site;
	if (params == NULL || !site->individual_feeds || site->with[0] != '\0')
		return 0;
	measured_product_moved_to_feed(s, entry, params, run, feed_run);
	return s->moved->most[run];
}

double
measured_mean_quantity_at_speed(const struct session *s,
    const struct entry *entry, size_t feed_run, const struct quantity *of,
    double speed, double *moved, size_t *n)
{
	const struct site *site = entry->site;
	const struct params *params = &entry->params;
	double sum = 0;
	*n = 0;
	for (size_t r = site_run_at_speed(site, speed);
	     site->with[0] == '\0' && r < site->n_run &&
	     site->run[r].speed - speed < 1e-3;
	     r++) {
		if (site->run[r].product.n == 0)
			continue;
		double value = screened_quantity_of_product(
		    measured_product_moved_to_feed(
			s, entry, params, r, feed_run),
		    of);
		if (isnan(value))
			continue;
		sum += value;
		++*n;
		*moved = fmax(*moved, largest_change_by_moving_to_feed(
					  s, entry, params, r, feed_run));
	}
	return *n > 0 ? quantities_value_in_shown_unit(of, sum / (double)*n)
		      : NAN;
}
