/* Synthetic sites: a feed that follows a power law, the model's product, and
 * normal errors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/synth.h"

#include <math.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "core/numeric/elementary.h"
#include "core/model/breakage.h"
#include "core/model/product.h"
#include "core/numeric/rng.h"

/* EN 933-2, the basic series with set 1 above 4 mm; mm. */
static const double SIEVES_MM[] = {
    63, 45, 31.5, 22.4, 16, 11.2, 8, 5.6, 4, 2, 1, 0.5, 0.25, 0.125, 0.063};

/* Returns twice the top size, the top size, and the series below twice the top
 * size without sieves within 5 % of these two. */
static struct psd
synth_make_sieve_series(double top_mm)
{
	struct psd feed = psd_new(ARRAY_LEN(SIEVES_MM) + 2);
	double own[2] = {2 * top_mm, top_mm};
	size_t n = 0, next_own = 0;
	feed.size[n++] = own[next_own++] / 1000;
	for (size_t i = 0; i < ARRAY_LEN(SIEVES_MM); i++) {
		double s = SIEVES_MM[i];
		if (s > own[0] * 0.95)
			continue;
		if (next_own < 2 && s < own[1] * 1.05) {
			feed.size[n++] = own[1] / 1000;
			next_own++;
		}
		if (s < own[1] * 0.95 || s > own[1] * 1.05)
			feed.size[n++] = s / 1000;
	}
	feed.n = n;
	return feed;
}

/* Rounds to 0.01 % of mass, as a careful laboratory reports. */
static double
round_passing(double passing)
{
	return floor(passing * 1e4 + 0.5) / 1e4;
}

static struct psd
synth_make_feed(const struct synth *s, double n)
{
	struct psd feed = synth_make_sieve_series(s->top_size * 1000);
	for (size_t i = 0; i < feed.n; i++) {
		double d = feed.size[i] / s->top_size;
		double above = 0.9 + 0.1 * el_log(d) / el_log(2);
		feed.passing[i] =
		    round_passing(d >= 1 ? fmin(above, 1) : 0.9 * el_pow(d, n));
	}
	return feed;
}

static uint64_t
digest_synth_numbers(const struct synth *s)
{
	uint64_t h = TEXT_DIGEST_START;
	h = text_fnv1a_digest(h, &s->top_size, sizeof s->top_size);
	h = text_fnv1a_digest(h, s->params.at,
	    breakage_model_of_params(&s->params)->n * sizeof *s->params.at);
	h = text_fnv1a_digest(h, &s->n, sizeof s->n);
	return h;
}

static struct psd
synth_make_product(const struct synth *s, const struct psd *feed, double speed,
    struct rng_key key)
{
	struct psd product = psd_copy(feed);
	struct model *model =
	    model_new(feed, feed->size, feed->n, model_settings_default());
	model_set_params(model, &s->params);
	model_compute_product(model, speed, product.passing);
	model_free(model);
	double ceiling = 1;
	for (size_t i = 0; i < product.n; i++) {
		double p = product.passing[i];
		double sd = 2 * s->noise * sqrt(fmax(p * (1 - p), 0));
		p += sd * rng_normal(key, (uint32_t)i);
		p = round_passing(fmin(fmax(p, 0), ceiling));
		product.passing[i] = ceiling = p;
	}
	return product;
}

struct site *
synth_make_site(const struct synth *s)
{
	enum { USE_FEED = 1, USE_PRODUCT = 2 };
	struct site *site = site_new(s->n_speed);
	uint64_t numbers = digest_synth_numbers(s);
	site->top_size = s->top_size;
	site->individual_feeds = s->individual_feeds;
	for (size_t r = 0; r < s->n_speed; r++) {
		struct run *run = &site->run[r];
		struct rng_key feed_key =
		    rng_make_key(s->seed ^ numbers, r, USE_FEED);
		double n = s->n;
		if (s->individual_feeds)
			n *= 1 + 0.05 * rng_normal(feed_key, 0);
		run->speed = s->speed[r];
		run->feed = synth_make_feed(s, n);
		run->product = synth_make_product(s, &run->feed, s->speed[r],
		    rng_make_key(s->seed ^ numbers, r, USE_PRODUCT));
	}
	site_update_digest_and_mean_feed(site);
	return site;
}
