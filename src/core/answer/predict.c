/* The table of a product at a speed: passings, sizes, the share that breaks,
 * and their bands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/predict.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/model/breakage.h"
#include "core/model/product.h"

/* Returns the sizes, of size [n], coarsest first, that the feed covers. */
static struct psd
list_covered_sizes(const double *size, size_t n, const struct psd *feed)
{
	size_t kept = 0;
	while (kept < n && psd_covers_size(feed, size[kept]))
		kept++;
	struct psd psd = psd_new(kept);
	for (size_t i = 0; i < kept; i++)
		psd.size[i] = size[i];
	return psd;
}

/* Returns the sieves that a table of the product shows. */
static struct psd
sieves_of_product_table(const struct site *site, const struct psd *feed)
{
	return site->n_shown > 0
		   ? list_covered_sizes(site->shown, site->n_shown, feed)
		   : predict_list_table_sieves(site, feed);
}

struct psd
predict_list_table_sieves(const struct site *site, const struct psd *feed)
{
	size_t n;
	FREED double *size = site_all_sieves(site, &n);
	size = xrealloc(size, n + site->n_shown + 1, sizeof *size);
	for (size_t i = 0; i < site->n_shown; i++)
		size[n++] = site->shown[i];
	n = psd_sort_distinct_sizes(size, n, 0);
	return list_covered_sizes(size, n, feed);
}

void
prediction_remove_band(struct prediction *p)
{
	free(p->low);
	free(p->high);
	p->low = p->high = NULL;
	for (size_t i = 0; i <= PSD_SIZES; i++)
		p->range[i][0] = p->range[i][1] = NAN;
}

struct quantity *
predict_table_quantities(const struct site *site, const struct psd *feed,
    const struct fraction *fraction, size_t *n)
{
	struct psd sieves = sieves_of_product_table(site, feed);
	struct quantity *asked =
	    xcalloc(sieves.n + 1 + PSD_SIZES, sizeof *asked);
	*n = 0;
	for (size_t i = 0; i < sieves.n; i++)
		asked[(*n)++] = (struct quantity){
		    .kind = QUANTITY_PASSING, .x = sieves.size[i]};
	for (size_t i = 0; i < PSD_SIZES; i++)
		asked[(*n)++] = (struct quantity){
		    .kind = QUANTITY_SIZE, .x = PSD_PASSING[i]};
	if (fraction_is_screened(fraction))
		asked[(*n)++] = (struct quantity){.kind = QUANTITY_SHARE};
	for (size_t i = 0; i < *n; i++)
		asked[i].fraction = *fraction;
	psd_free(&sieves);
	return asked;
}

static void
prediction_fill_passings(struct prediction *p, struct forecast *f)
{
	bool band = forecast_draws_of_quantity(f, 0) != NULL;
	p->model = xcalloc_doubles(p->product.n);
	p->low = band ? xcalloc_doubles(p->product.n) : NULL;
	p->high = band ? xcalloc_doubles(p->product.n) : NULL;
	for (size_t i = 0; i < p->product.n; i++) {
		struct figure at = forecast_value_with_band(f, i);
		p->product.passing[i] = at.value;
		p->model[i] = forecast_value_of_model_alone(f, i);
		if (!band)
			continue;
		p->low[i] = at.low;
		p->high[i] = at.high;
	}
}

struct prediction
predict_at_table_sieves(const struct site *site, size_t feed_run,
    const struct fraction *fraction, struct forecast *f)
{
	const struct psd *feed = site_feed_of_run(site, feed_run);
	double speed = forecast_tip_speed(f);
	struct prediction p = {.speed = speed,
	    .energy = specific_energy_at_speed(speed),
	    .feed_run = feed_run,
	    .share = 1,
	    .share_range = {NAN, NAN},
	    .fraction = fraction_is_screened(fraction) ? *fraction
						       : (struct fraction){0},
	    .product = sieves_of_product_table(site, feed),
	    .selected = forecast_broken_feed_share(f),
	    .no_daughters = !forecast_is_feed_broken(f)};
	size_t n = p.product.n;
	p.feed = psd_copy(&p.product);
	for (size_t i = 0; i < n; i++)
		p.feed.passing[i] = psd_passing(feed, p.feed.size[i]);
	prediction_fill_passings(&p, f);
	for (size_t i = 0; i <= PSD_SIZES; i++) {
		struct figure x = i < PSD_SIZES
				      ? forecast_value_with_band(f, n + i)
				      : forecast_break_size(f);
		p.size[i] = x.value;
		p.range[i][0] = x.low;
		p.range[i][1] = x.high;
	}
	if (fraction_is_screened(fraction)) {
		struct figure share =
		    forecast_value_with_band(f, n + PSD_SIZES);
		p.share = share.value;
		p.share_range[0] = share.low;
		p.share_range[1] = share.high;
	}
	p.curve = forecast_screened_curve(f, n);
	return p;
}

struct prediction
predict_with_model_alone(const struct site *site, const struct params *p,
    struct model_settings settings, double speed, size_t feed_run)
{
	const struct psd *feed = site_feed_of_run(site, feed_run);
	const struct fraction whole = {0};
	struct psd sizes = predict_list_table_sieves(site, feed);
	size_t n;
	FREED struct quantity *asked =
	    predict_table_quantities(site, feed, &whole, &n);
	struct forecast *f =
	    forecast_new(feed, sizes.size, sizes.n, asked, n, p, settings, 0);
	forecast_move_to_speed(f, NULL, ENSEMBLE_MODEL, speed);
	struct prediction out =
	    predict_at_table_sieves(site, feed_run, &whole, f);
	forecast_close(f);
	psd_free(&sizes);
	return out;
}

/* The share selected of a feed of one class alone is the class's mean S. */
void
predict_broken_share_of_classes(const struct psd *feed, const struct params *p,
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
		model_set_params(model, p);
		S[i] = fmin(model_broken_feed_share(model, speed), 1);
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
predict_is_extrapolation(
    const struct site *site, const bool *train, double speed)
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
