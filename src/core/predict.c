/* One product with what can be read off it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/predict.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/breakage.h"
#include "core/product.h"

/* All sieves of the site that the feed covers, coarsest first. */
static struct psd
all_sieves(const struct site *site, const struct psd *feed)
{
	size_t n, kept = 0;
	double *size = site_sieves(site, &n);
	while (kept < n && psd_covers(feed, size[kept]))
		kept++;
	struct psd psd = psd_new(kept);
	memcpy(psd.size, size, kept * sizeof *size);
	free(size);
	return psd;
}

struct prediction
predict(const struct site *site, const struct params *p,
    struct model_settings settings, double speed, size_t feed_run)
{
	const struct psd *feed = &site->run[feed_run].feed;
	struct prediction out = {.speed = speed,
	    .energy = energy_specific(speed),
	    .feed_run = feed_run,
	    .product = all_sieves(site, feed),
	    .break_size = params_break_size(p, speed)};
	out.feed = psd_copy(&out.product);
	for (size_t i = 0; i < out.feed.n; i++)
		out.feed.passing[i] = psd_passing(feed, out.feed.size[i]);
	struct model *model =
	    model_new(feed, out.product.size, out.product.n, settings);
	model_set(model, p);
	model_product(model, speed, out.product.passing);
	out.selected = model_selected(model, speed);
	out.no_daughters = !model_breaks(model, speed);
	model_free(model);
	for (size_t i = 0; i < PSD_SIZES; i++)
		out.size[i] = psd_size(&out.product, PSD_PASSING[i]);
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
		model_set(model, p);
		S[i] = fmin(model_selected(model, speed), 1);
		model_free(model);
	}
}

void
prediction_free(struct prediction *prediction)
{
	psd_free(&prediction->feed);
	psd_free(&prediction->product);
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
