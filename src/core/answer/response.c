/* Reads quantities off the curve of the answer and of each draw, linearly in
 * log size between the sieves (D20).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/response.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/model/breakage.h"
#include "core/model/selection.h"
#include "core/numeric/elementary.h"
#include "core/posterior/ensemble.h"
#include "core/model/product.h"

enum { DRAWS = POSTERIOR_DRAWS };

/* ensemble: NULL for the model alone.  product: at `speed`, of the model, or
 * the mean of the draws, at the sieves and at the sizes that quantities need,
 * each `share` of the way from the sieve below `above` to it; alone: the
 * model's at `alone_speed`.  curve, part: room for a draw's; sieve [n_sieve]:
 * room for passings at the sieves. */
struct response {
	struct model *model;
	struct params params;
	struct model_settings settings;
	struct ensemble *ensemble;
	struct psd product, alone;
	double alone_speed;
	size_t *above;
	double *share, *sieve;
	size_t n_sieve, n;
	struct quantity *asked;
	double **kept; /* [n][sizes] kept for its fraction; NULL: all */
	size_t *row;   /* [n] of the size that it is the passing of, or sizes */
	double *value; /* [n] */
	double **draw; /* [n][DRAWS] or NULL */
	enum ensemble_part of; /* what the draws are of */
	struct psd curve, part;
	double speed;
};

/* The sizes of both lists, coarsest first. */
static double *
merge_sieve_and_asked_sizes(const struct psd *feed, const double *size,
    size_t *n, const struct quantity *asked, size_t n_asked)
{
	double *all = xcalloc_doubles(*n + n_asked * QUANTITY_POINTS);
	memcpy(all, size, *n * sizeof *size);
	for (size_t i = 0; i < n_asked; i++) {
		double point[QUANTITY_POINTS];
		size_t more = quantity_sizes_needed(&asked[i], point);
		for (size_t k = 0; k < more; k++)
			if (psd_covers_size(feed, point[k]))
				all[(*n)++] = point[k];
	}
	*n = psd_sort_distinct_sizes(all, *n, 0);
	return all;
}

/* Where the sizes of the product lie among the sieves. */
static void
find_sieves_of_product_sizes(struct response *r, const double *sieve, size_t n)
{
	for (size_t k = 0, i = 0; k < r->product.n; k++) {
		double x = r->product.size[k];
		while (i + 2 < n && sieve[i + 1] >= x)
			i++;
		bool only = n < 2 || x >= sieve[i];
		r->above[k] = i;
		r->share[k] = only ? 1
				   : el_log(x / sieve[i + 1]) /
					 el_log(sieve[i] / sieve[i + 1]);
		r->share[k] = fmax(r->share[k], 0);
	}
}

/* A curve at all sizes from passings at the sieves, which stand `apart`. */
static void
interpolate_curve(
    const struct response *r, const double *P, size_t apart, struct psd *curve)
{
	if (curve->n == r->n_sieve) {
		for (size_t k = 0; k < curve->n; k++)
			curve->passing[k] = P[k * apart];
		return;
	}
	for (size_t k = 0; k < curve->n; k++) {
		const double *above = P + r->above[k] * apart;
		double t = r->share[k];
		curve->passing[k] =
		    t < 1 ? t * above[0] + (1 - t) * above[apart] : above[0];
	}
}

/* The place of a passing of the whole product among the sizes; n for others,
 * which are read off a curve. */
static size_t
row_of_passing_quantity(const struct quantity *q, const double *size, size_t n)
{
	size_t k = 0;
	if (q->kind != QUANTITY_PASSING || fraction_is_screened(&q->fraction))
		return n;
	while (k < n && size[k] != q->x)
		k++;
	return k;
}

struct response *
response_new(const struct psd *feed, const double *size, size_t n,
    const struct quantity *asked, size_t n_asked, const struct params *p,
    struct model_settings settings)
{
	struct response *r = xcalloc(1, sizeof *r);
	size_t n_sieve = n;
	FREED double *all =
	    merge_sieve_and_asked_sizes(feed, size, &n, asked, n_asked);
	*r =
	    (struct response){.model = model_new(feed, size, n_sieve, settings),
		.params = *p,
		.settings = settings,
		.product = psd_new(n),
		.alone_speed = NAN,
		.of = ENSEMBLE_ANSWER,
		.above = xcalloc(n, sizeof *r->above),
		.share = xcalloc_doubles(n),
		.sieve = xcalloc_doubles(n_sieve),
		.n_sieve = n_sieve,
		.n = n_asked,
		.asked = xcalloc(n_asked, sizeof *asked),
		.kept = xcalloc(n_asked, sizeof *r->kept),
		.row = xcalloc(n_asked, sizeof *r->row),
		.value = xcalloc_doubles(n_asked),
		.draw = xcalloc(n_asked, sizeof *r->draw),
		.part = psd_new(n)};
	model_use_params(r->model, p);
	memcpy(r->product.size, all, n * sizeof *all);
	memcpy(r->part.size, all, n * sizeof *all);
	find_sieves_of_product_sizes(r, size, n_sieve);
	r->curve = psd_copy(&r->product);
	r->alone = psd_copy(&r->product);
	for (size_t i = 0; i < n_asked; i++) {
		r->asked[i] = asked[i];
		r->row[i] = row_of_passing_quantity(&asked[i], all, n);
		if (!fraction_is_screened(&asked[i].fraction))
			continue;
		r->kept[i] = xcalloc_doubles(n);
		fraction_kept_of_classes(
		    &asked[i].fraction, all, n, r->kept[i]);
	}
	return r;
}

void
response_free(struct response *r)
{
	if (r == NULL)
		return;
	for (size_t i = 0; i < r->n; i++) {
		free(r->kept[i]);
		free(r->draw[i]);
	}
	model_free(r->model);
	psd_free(&r->product);
	psd_free(&r->alone);
	psd_free(&r->curve);
	psd_free(&r->part);
	free(r->above);
	free(r->share);
	free(r->sieve);
	free(r->asked);
	free(r->kept);
	free(r->row);
	free(r->value);
	free(r->draw);
	free(r);
}

/* The curve of the fraction that quantity i is of, and its share of the
 * product. */
static const struct psd *
curve_of_fraction(
    struct response *r, size_t i, const struct psd *curve, double *share)
{
	*share = 1;
	if (r->kept[i] == NULL)
		return curve;
	*share = screening_part_of_product(curve, r->kept[i], &r->part);
	return &r->part;
}

/* Of a curve of the product. */
static double
quantity_of_curve(struct response *r, size_t i, const struct psd *curve)
{
	double share;
	if (r->row[i] < curve->n)
		return curve->passing[r->row[i]];
	curve = curve_of_fraction(r, i, curve, &share);
	return quantity_read_off_curve(&r->asked[i], curve, share);
}

/* The curve of draw d. */
static void
fill_curve_of_draw(const struct response *r, size_t d, struct psd *curve)
{
	const double *P = ensemble_products(r->ensemble, r->of) + d;
	interpolate_curve(r, P, DRAWS, curve);
}

/* The same of one size, for all draws. */
static void
response_copy_row_of_draws(const struct response *r, size_t k, double *draw)
{
	const double *P = ensemble_products(r->ensemble, r->of);
	const double *above = P + r->above[k] * DRAWS, *below = above + DRAWS;
	double t = r->share[k];
	if (t < 1)
		for (size_t d = 0; d < DRAWS; d++)
			draw[d] = t * above[d] + (1 - t) * below[d];
	else
		memcpy(draw, above, DRAWS * sizeof *draw);
}

/* The curve of the model alone. */
static const struct psd *
curve_of_model(struct response *r)
{
	if (r->alone_speed != r->speed) {
		model_product(r->model, r->speed, r->sieve);
		interpolate_curve(r, r->sieve, 1, &r->alone);
		r->alone_speed = r->speed;
	}
	return &r->alone;
}

static void
compute_answer_at_speed(struct response *r, double v)
{
	r->speed = v;
	if (r->ensemble == NULL) {
		memcpy(r->product.passing, curve_of_model(r)->passing,
		    r->product.n * sizeof *r->product.passing);
	} else {
		ensemble_set_speed(r->ensemble, v);
		ensemble_mean_answer(r->ensemble, r->sieve);
		interpolate_curve(r, r->sieve, 1, &r->product);
	}
	for (size_t i = 0; i < r->n; i++)
		r->value[i] = quantity_of_curve(r, i, &r->product);
}

static void
response_fill_quantity_draws(struct response *r)
{
	bool curves = false;
	for (size_t i = 0; i < r->n; i++) {
		if (r->draw[i] == NULL)
			r->draw[i] = xcalloc_doubles(DRAWS);
		if (r->row[i] < r->product.n)
			response_copy_row_of_draws(r, r->row[i], r->draw[i]);
		else
			curves = true;
	}
	for (size_t d = 0; d < DRAWS && curves; d++) {
		fill_curve_of_draw(r, d, &r->curve);
		for (size_t i = 0; i < r->n; i++)
			if (r->row[i] >= r->product.n)
				r->draw[i][d] =
				    quantity_of_curve(r, i, &r->curve);
	}
}

void
response_set_speed(
    struct response *r, struct ensemble *e, enum ensemble_part of, double v)
{
	r->ensemble = e;
	r->of = of;
	compute_answer_at_speed(r, v);
	if (e != NULL)
		response_fill_quantity_draws(r);
}

const struct quantity *
response_asked_quantity(const struct response *r, size_t i)
{
	return &r->asked[i];
}

double
response_value_of_quantity(const struct response *r, size_t i)
{
	return r->value[i];
}

double
response_value_of_model(struct response *r, size_t i)
{
	return quantity_of_curve(r, i, curve_of_model(r));
}

double
response_tip_speed(const struct response *r)
{
	return r->speed;
}

double
response_break_size(const struct response *r)
{
	return params_break_size_by_impacts(&r->params, &r->settings, r->speed);
}

void
response_break_size_band(
    const struct response *r, double level, double range[static 2])
{
	const struct posterior *p =
	    r->ensemble != NULL ? ensemble_posterior(r->ensemble) : NULL;
	double draw[DRAWS];
	range[0] = range[1] = NAN;
	for (size_t d = 0; d < DRAWS && p != NULL; d++)
		draw[d] = params_break_size_by_impacts(
		    &p->draw[d].params, &p->settings, r->speed);
	if (p != NULL)
		ensemble_middle_interval(draw, level, &range[0], &range[1]);
}

double
response_share_selected(struct response *r)
{
	return model_share_selected(r->model, r->speed);
}

bool
response_breaks_feed(struct response *r)
{
	return model_breaks_feed(r->model, r->speed);
}

const double *
response_draws_of_quantity(const struct response *r, size_t i)
{
	return r->draw[i];
}

/* Of a curve of the product that has this value. */
static double
excess_of_curve_over_limit(struct response *r, size_t i, double limit,
    double value, const struct psd *curve)
{
	double share;
	curve = quantity_excess_needs_curve(&r->asked[i])
		    ? curve_of_fraction(r, i, curve, &share)
		    : NULL;
	return quantity_excess_as_passing(&r->asked[i], limit, value, curve);
}

double
response_excess_over_limit(struct response *r, size_t i, double limit)
{
	return excess_of_curve_over_limit(
	    r, i, limit, r->value[i], &r->product);
}

void
response_excess_of_draws(struct response *r, size_t i, double limit,
    double over[static POSTERIOR_DRAWS])
{
	for (size_t d = 0; d < DRAWS; d++) {
		if (quantity_excess_needs_curve(&r->asked[i]))
			fill_curve_of_draw(r, d, &r->curve);
		over[d] = excess_of_curve_over_limit(
		    r, i, limit, r->draw[i][d], &r->curve);
	}
}

void
response_band_of_quantity(
    const struct response *r, size_t i, double level, double range[static 2])
{
	double to_hold = r->of == ENSEMBLE_ANSWER ? r->value[i] : NAN;
	range[0] = range[1] = NAN;
	if (r->draw[i] != NULL)
		ensemble_interval_around_answer(
		    r->draw[i], level, to_hold, range);
}

struct psd
response_screened_curve(struct response *r, size_t i)
{
	double share;
	return psd_copy(curve_of_fraction(r, i, &r->product, &share));
}
