/* The table of a product at a speed: passings, sizes, the share that breaks,
 * and their bands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/predict.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/model/breakage.h"
#include "core/numeric/elementary.h"
#include "core/model/product.h"

/* Those of sizes [n], coarsest first, that the feed covers. */
static struct psd
sizes_covered(const double *size, size_t n, const struct psd *feed)
{
	size_t kept = 0;
	while (kept < n && psd_covers(feed, size[kept]))
		kept++;
	struct psd psd = psd_new(kept);
	for (size_t i = 0; i < kept; i++)
		psd.size[i] = size[i];
	return psd;
}

static struct psd
covered_sieves(const struct site *site, const struct psd *feed)
{
	size_t n;
	double *size = site_sieves(site, &n);
	struct psd psd = sizes_covered(size, n, feed);
	free(size);
	return psd;
}

/* Those that a table of the product shows. */
static struct psd
product_sieves(const struct site *site, const struct psd *feed)
{
	return site->n_shown > 0
		   ? sizes_covered(site->shown, site->n_shown, feed)
		   : covered_sieves(site, feed);
}

struct psd
predict_sizes(const struct site *site, const struct psd *feed)
{
	struct psd sieves = covered_sieves(site, feed);
	struct psd shown = sizes_covered(site->shown, site->n_shown, feed);
	struct psd psd = psd_new(sieves.n + shown.n);
	memcpy(psd.size, sieves.size, sieves.n * sizeof *psd.size);
	if (shown.n > 0)
		memcpy(psd.size + sieves.n, shown.size,
		    shown.n * sizeof *psd.size);
	psd.n = psd_sort(psd.size, psd.n, 0);
	psd_free(&sieves);
	psd_free(&shown);
	return psd;
}

void
prediction_drop_band(struct prediction *p)
{
	free(p->low);
	free(p->high);
	p->low = p->high = NULL;
	for (size_t i = 0; i <= PSD_SIZES; i++)
		p->range[i][0] = p->range[i][1] = NAN;
}

struct quantity *
predict_quantities(const struct site *site, const struct psd *feed,
    const struct fraction *fraction, size_t *n)
{
	struct psd sieves = product_sieves(site, feed);
	struct quantity *asked =
	    xcalloc(sieves.n + 1 + PSD_SIZES, sizeof *asked);
	*n = 0;
	for (size_t i = 0; i < sieves.n; i++)
		asked[(*n)++] = (struct quantity){
		    .kind = QUANTITY_PASSING, .x = sieves.size[i]};
	for (size_t i = 0; i < PSD_SIZES; i++)
		asked[(*n)++] = (struct quantity){
		    .kind = QUANTITY_SIZE, .x = PSD_PASSING[i]};
	if (fraction_screens(fraction))
		asked[(*n)++] = (struct quantity){.kind = QUANTITY_SHARE};
	for (size_t i = 0; i < *n; i++)
		asked[i].fraction = *fraction;
	psd_free(&sieves);
	return asked;
}

static void
prediction_read_passings(struct prediction *p, struct response *r, double level)
{
	bool band = response_draws(r, 0) != NULL;
	p->model = xdoubles(p->product.n);
	p->low = band ? xdoubles(p->product.n) : NULL;
	p->high = band ? xdoubles(p->product.n) : NULL;
	for (size_t i = 0; i < p->product.n; i++) {
		double range[2];
		p->product.passing[i] = response_value(r, i);
		p->model[i] = response_model(r, i);
		if (!band)
			continue;
		response_band(r, i, level, range);
		p->low[i] = range[0];
		p->high[i] = range[1];
	}
}

struct prediction
predict_table(const struct site *site, size_t feed_run,
    const struct fraction *fraction, struct response *r, double level)
{
	const struct psd *feed = site_feed(site, feed_run);
	double speed = response_speed(r);
	struct prediction p = {.speed = speed,
	    .energy = energy_specific(speed),
	    .feed_run = feed_run,
	    .share = 1,
	    .share_range = {NAN, NAN},
	    .fraction =
		fraction_screens(fraction) ? *fraction : (struct fraction){0},
	    .product = product_sieves(site, feed),
	    .selected = response_selected(r),
	    .no_daughters = !response_breaks(r)};
	size_t n = p.product.n;
	p.feed = psd_copy(&p.product);
	for (size_t i = 0; i < n; i++)
		p.feed.passing[i] = psd_passing(feed, p.feed.size[i]);
	prediction_read_passings(&p, r, level);
	for (size_t i = 0; i < PSD_SIZES; i++) {
		p.size[i] = response_value(r, n + i);
		response_band(r, n + i, level, p.range[i]);
	}
	p.break_size = response_break_size(r);
	response_break_band(r, level, p.range[PSD_SIZES]);
	if (fraction_screens(fraction)) {
		p.share = response_value(r, n + PSD_SIZES);
		response_band(r, n + PSD_SIZES, level, p.share_range);
	}
	p.curve = response_screened(r, n);
	return p;
}

struct prediction
predict(const struct site *site, const struct params *p,
    struct model_settings settings, double speed, size_t feed_run)
{
	const struct psd *feed = site_feed(site, feed_run);
	const struct fraction whole = {0};
	struct psd sizes = predict_sizes(site, feed);
	size_t n;
	struct quantity *asked = predict_quantities(site, feed, &whole, &n);
	struct response *r =
	    response_new(feed, sizes.size, sizes.n, asked, n, p, settings);
	response_at(r, NULL, ENSEMBLE_MODEL, speed);
	struct prediction out = predict_table(site, feed_run, &whole, r, 0);
	response_free(r);
	psd_free(&sizes);
	free(asked);
	return out;
}

/* A feed of one class alone, selected as a whole: the class's mean S. */
void
predict_selection(const struct psd *feed, const struct params *p,
    struct model_settings settings, double speed, double *S)
{
	for (size_t i = 0; i < feed->n; i++) {
		bool pan = i + 1 == feed->n;
		S[i] = 0;
		if (pan && settings.method == METHOD_CONTINUOUS)
			continue;
		double one[2] = {1, 0};
		struct psd class = {pan ? 1 : 2, feed->size + i, one};
		struct model *model =
		    model_new(&class, feed->size + i, 1, settings);
		model_use_params(model, p);
		S[i] = fmin(model_selected(model, speed), 1);
		model_free(model);
	}
}

void
prediction_free(struct prediction *prediction)
{
	psd_free(&prediction->feed);
	psd_free(&prediction->product);
	psd_free(&prediction->curve);
	free(prediction->model);
	free(prediction->low);
	free(prediction->high);
}

bool
predict_extrapolates(const struct site *site, const bool *train, double speed)
{
	double slowest = 1e300, fastest = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		if (!train[r])
			continue;
		double v = site->run[r].speed;
		slowest = v < slowest ? v : slowest;
		fastest = v > fastest ? v : fastest;
	}
	return speed < slowest - 1e-9 || speed > fastest + 1e-9;
}
