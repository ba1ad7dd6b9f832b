/* One product with what can be read off it.
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
covered(const double *size, size_t n, const struct psd *feed)
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
	struct psd psd = covered(size, n, feed);
	free(size);
	return psd;
}

struct psd
predict_sizes(const struct site *site, const struct psd *feed)
{
	struct psd sieves = covered_sieves(site, feed);
	struct psd shown = covered(site->shown, site->n_shown, feed);
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

/* The place of a sieve among a curve's sizes, from k on. */
static size_t
find_size(const struct psd *curve, size_t k, double sieve)
{
	while (k + 1 < curve->n && curve->size[k] > sieve)
		k++;
	return k;
}

static void
read_curve(struct prediction *p)
{
	for (size_t i = 0, k = 0; i < p->product.n; i++) {
		k = find_size(&p->curve, k, p->product.size[i]);
		p->product.passing[i] = p->curve.passing[k];
	}
	for (size_t i = 0; i < PSD_SIZES; i++)
		p->size[i] = psd_size(&p->curve, PSD_PASSING[i]);
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

struct prediction
predict(const struct site *site, const struct params *p,
    struct model_settings settings, double speed, size_t feed_run)
{
	const struct psd *feed = site_feed(site, feed_run);
	struct prediction out = {.speed = speed,
	    .energy = energy_specific(speed),
	    .feed_run = feed_run,
	    .share = 1,
	    .share_range = {NAN, NAN},
	    .product = site->n_shown > 0
			   ? covered(site->shown, site->n_shown, feed)
			   : covered_sieves(site, feed),
	    .curve = predict_sizes(site, feed),
	    .break_size = params_break_size_by(p, &settings, speed)};
	out.feed = psd_copy(&out.product);
	for (size_t i = 0; i < out.feed.n; i++)
		out.feed.passing[i] = psd_passing(feed, out.feed.size[i]);
	struct model *model =
	    model_new(feed, out.curve.size, out.curve.n, settings);
	model_set(model, p);
	model_product(model, speed, out.curve.passing);
	out.selected = model_selected(model, speed);
	out.no_daughters = !model_breaks(model, speed);
	model_free(model);
	read_curve(&out);
	out.model = xdoubles(out.product.n);
	memcpy(
	    out.model, out.product.passing, out.product.n * sizeof *out.model);
	prediction_drop_band(&out);
	return out;
}

/* The size at a level of a draw's curve, whose passings P stand a row of draws
 * apart and fall: as psd_size has it, of the interval that holds it. */
static double
size_of_draw(const struct psd *curve, const double *P, double level)
{
	enum { N = POSTERIOR_DRAWS };
	size_t above = 0, n = curve->n < 2 ? curve->n : 2;
	for (size_t below = curve->n - 1; above + 1 < below;) {
		size_t middle = (above + below) / 2;
		*(P[middle * N] > level ? &above : &below) = middle;
	}
	double ends[2] = {P[above * N], P[(above + n - 1) * N]};
	return psd_size(&(struct psd){n, curve->size + above, ends}, level);
}

/* The sizes of the draws' own curves. */
static void
spread_sizes(struct prediction *p, struct ensemble *e, double level)
{
	enum { N = POSTERIOR_DRAWS };
	const double *P = ensemble_products(e, ENSEMBLE_ANSWER);
	double value[N];
	for (size_t k = 0; k <= PSD_SIZES; k++) {
		double *range = p->range[k];
		for (size_t d = 0; d < N; d++)
			value[d] =
			    k < PSD_SIZES
				? size_of_draw(&p->curve, P + d, PSD_PASSING[k])
				: ensemble_break_size(e, d, p->speed);
		ensemble_middle(value, level, &range[0], &range[1]);
		range[0] = fmin(range[0], p->size[k]);
		range[1] = fmax(range[1], p->size[k]);
	}
}

/* Bands are worked out at the sieves only, which are among the curve's
 * sizes. */
void
predict_spread(struct prediction *p, struct ensemble *e, double level)
{
	const struct psd *product = &p->product;
	ensemble_at(e, p->speed);
	ensemble_mean(e, p->curve.passing);
	read_curve(p);
	p->low = xdoubles(product->n);
	p->high = xdoubles(product->n);
	for (size_t i = 0, k = 0; i < product->n; i++) {
		k = find_size(&p->curve, k, product->size[i]);
		ensemble_band(
		    e, ENSEMBLE_ANSWER, k, level, &p->low[i], &p->high[i]);
		p->low[i] = fmin(p->low[i], product->passing[i]);
		p->high[i] = fmax(p->high[i], product->passing[i]);
	}
	spread_sizes(p, e, level);
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

static double *
copy_of(const double *from, size_t n)
{
	if (from == NULL)
		return NULL;
	double *to = xdoubles(n);
	memcpy(to, from, n * sizeof *to);
	return to;
}

struct prediction
prediction_copy(const struct prediction *from)
{
	struct prediction to = *from;
	to.feed = psd_copy(&from->feed);
	to.product = psd_copy(&from->product);
	to.curve = psd_copy(&from->curve);
	to.model = copy_of(from->model, to.product.n);
	to.low = copy_of(from->low, to.product.n);
	to.high = copy_of(from->high, to.product.n);
	return to;
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
