/* Reads quantities off the curve of the answer and of each draw, linearly in
 * log size between the sieves (D20).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/forecast.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/model/breakage.h"
#include "core/model/selection.h"
#include "core/numeric/elementary.h"
#include "core/posterior/ensemble.h"
#include "core/model/product.h"

enum { DRAWS = POSTERIOR_DRAWS };

/* ensemble: NULL for the model alone.  product: the answer at `speed`, at the
 * sieves and at the sizes that quantities need.  Each size lies `share` of the
 * way up from the next finer sieve to sieve number `above`.  alone: the model's
 * product at `alone_speed`.  curve, part, sieve [n_sieve]: workspace for a
 * draw's curve, for its fraction, and for passings at the sieves. */
struct forecast {
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
	double **kept; /* [n][sizes] share of each class that the quantity's
		        * fraction keeps; NULL: all */
	size_t *row;   /* [n] index of the size whose passing the quantity is,
		        * or the number of sizes */
	double *value; /* [n] */
	double **draw; /* [n][DRAWS] or NULL */
	enum ensemble_part of; /* the part that the draws are of */
	struct psd curve, part;
	double speed, level;
	void *asker;
};

/* Returns the sieves and the sizes that the quantities need, coarsest first. */
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

/* Finds where the sizes of the product lie among the sieves. */
static void
locate_product_sizes_in_sieves(
    struct forecast *f, const double *sieve, size_t n)
{
	for (size_t k = 0, i = 0; k < f->product.n; k++) {
		double x = f->product.size[k];
		while (i + 2 < n && sieve[i + 1] >= x)
			i++;
		bool only = n < 2 || x >= sieve[i];
		f->above[k] = i;
		f->share[k] = only ? 1
				   : el_log(x / sieve[i + 1]) /
					 el_log(sieve[i] / sieve[i + 1]);
		f->share[k] = fmax(f->share[k], 0);
	}
}

/* Computes a curve at all sizes from passings P at the sieves, which are
 * `apart` elements apart. */
static void
interpolate_curve(
    const struct forecast *f, const double *P, size_t apart, struct psd *curve)
{
	if (curve->n == f->n_sieve) {
		for (size_t k = 0; k < curve->n; k++)
			curve->passing[k] = P[k * apart];
		return;
	}
	for (size_t k = 0; k < curve->n; k++) {
		const double *above = P + f->above[k] * apart;
		double t = f->share[k];
		curve->passing[k] =
		    t < 1 ? t * above[0] + (1 - t) * above[apart] : above[0];
	}
}

/* Returns the index of the size whose passing, of the whole product, the
 * quantity is; n for other quantities, which are read off a curve. */
static size_t
size_index_of_passing_quantity(
    const struct quantity *q, const double *size, size_t n)
{
	size_t k = 0;
	if (q->kind != QUANTITY_PASSING || fraction_is_screened(&q->fraction))
		return n;
	while (k < n && size[k] != q->x)
		k++;
	return k;
}

struct forecast *
forecast_new(const struct psd *feed, const double *size, size_t n,
    const struct quantity *asked, size_t n_asked, const struct params *p,
    struct model_settings settings, double level)
{
	struct forecast *f = xcalloc(1, sizeof *f);
	size_t n_sieve = n;
	FREED double *all =
	    merge_sieve_and_asked_sizes(feed, size, &n, asked, n_asked);
	*f =
	    (struct forecast){.model = model_new(feed, size, n_sieve, settings),
		.params = *p,
		.settings = settings,
		.product = psd_new(n),
		.alone_speed = NAN,
		.level = level,
		.of = ENSEMBLE_ANSWER,
		.above = xcalloc(n, sizeof *f->above),
		.share = xcalloc_doubles(n),
		.sieve = xcalloc_doubles(n_sieve),
		.n_sieve = n_sieve,
		.n = n_asked,
		.asked = xcalloc(n_asked, sizeof *asked),
		.kept = xcalloc(n_asked, sizeof *f->kept),
		.row = xcalloc(n_asked, sizeof *f->row),
		.value = xcalloc_doubles(n_asked),
		.draw = xcalloc(n_asked, sizeof *f->draw),
		.part = psd_new(n)};
	model_set_params(f->model, p);
	memcpy(f->product.size, all, n * sizeof *all);
	memcpy(f->part.size, all, n * sizeof *all);
	locate_product_sizes_in_sieves(f, size, n_sieve);
	f->curve = psd_copy(&f->product);
	f->alone = psd_copy(&f->product);
	for (size_t i = 0; i < n_asked; i++) {
		f->asked[i] = asked[i];
		f->row[i] = size_index_of_passing_quantity(&asked[i], all, n);
		if (!fraction_is_screened(&asked[i].fraction))
			continue;
		f->kept[i] = xcalloc_doubles(n);
		fraction_share_of_each_class(
		    &asked[i].fraction, all, n, f->kept[i]);
	}
	return f;
}

void
forecast_close(struct forecast *f)
{
	if (f == NULL)
		return;
	for (size_t i = 0; i < f->n; i++) {
		free(f->kept[i]);
		free(f->draw[i]);
	}
	free(f->asker);
	model_free(f->model);
	psd_free(&f->product);
	psd_free(&f->alone);
	psd_free(&f->curve);
	psd_free(&f->part);
	free(f->above);
	free(f->share);
	free(f->sieve);
	free(f->asked);
	free(f->kept);
	free(f->row);
	free(f->value);
	free(f->draw);
	free(f);
}

/* Returns the curve of the fraction that quantity i is about, and sets *share
 * to its share of the product. */
static const struct psd *
curve_of_fraction(
    struct forecast *f, size_t i, const struct psd *curve, double *share)
{
	*share = 1;
	if (f->kept[i] == NULL)
		return curve;
	*share = screening_compute_kept_part(curve, f->kept[i], &f->part);
	return &f->part;
}

/* Returns quantity i of a curve of the product. */
static double
quantity_of_curve(struct forecast *f, size_t i, const struct psd *curve)
{
	double share;
	if (f->row[i] < curve->n)
		return curve->passing[f->row[i]];
	curve = curve_of_fraction(f, i, curve, &share);
	return quantity_read_off_curve(&f->asked[i], curve, share);
}

static void
fill_posterior_draw_curve(struct forecast *f, size_t d)
{
	const double *P = ensemble_products(f->ensemble, f->of) + d;
	interpolate_curve(f, P, DRAWS, &f->curve);
}

/* Computes the passings at size k in all draws. */
static void
compute_passing_draws(const struct forecast *f, size_t k, double *draw)
{
	const double *P = ensemble_products(f->ensemble, f->of);
	const double *above = P + f->above[k] * DRAWS, *below = above + DRAWS;
	double t = f->share[k];
	if (t < 1)
		for (size_t d = 0; d < DRAWS; d++)
			draw[d] = t * above[d] + (1 - t) * below[d];
	else
		memcpy(draw, above, DRAWS * sizeof *draw);
}

static const struct psd *
curve_of_model_alone(struct forecast *f)
{
	if (f->alone_speed != f->speed) {
		model_compute_product(f->model, f->speed, f->sieve);
		interpolate_curve(f, f->sieve, 1, &f->alone);
		f->alone_speed = f->speed;
	}
	return &f->alone;
}

static void
compute_forecast_at_speed(struct forecast *f, double v)
{
	f->speed = v;
	if (f->ensemble == NULL) {
		memcpy(f->product.passing, curve_of_model_alone(f)->passing,
		    f->product.n * sizeof *f->product.passing);
	} else {
		ensemble_set_speed(f->ensemble, v);
		ensemble_mean_answer(f->ensemble, f->sieve);
		interpolate_curve(f, f->sieve, 1, &f->product);
	}
	for (size_t i = 0; i < f->n; i++)
		f->value[i] = quantity_of_curve(f, i, &f->product);
}

static void
compute_quantities_in_draws(struct forecast *f)
{
	bool curves = false;
	for (size_t i = 0; i < f->n; i++) {
		if (f->draw[i] == NULL)
			f->draw[i] = xcalloc_doubles(DRAWS);
		if (f->row[i] < f->product.n)
			compute_passing_draws(f, f->row[i], f->draw[i]);
		else
			curves = true;
	}
	for (size_t d = 0; d < DRAWS && curves; d++) {
		fill_posterior_draw_curve(f, d);
		for (size_t i = 0; i < f->n; i++)
			if (f->row[i] >= f->product.n)
				f->draw[i][d] =
				    quantity_of_curve(f, i, &f->curve);
	}
}

void
forecast_set_user_data(struct forecast *f, void *asker)
{
	f->asker = asker;
}

const void *
forecast_user_data(const struct forecast *f)
{
	return f->asker;
}

void
forecast_move_to_speed(
    struct forecast *f, struct ensemble *e, enum ensemble_part of, double v)
{
	f->ensemble = e;
	f->of = of;
	compute_forecast_at_speed(f, v);
	if (e != NULL)
		compute_quantities_in_draws(f);
}

const struct quantity *
forecast_get_asked_quantity(const struct forecast *f, size_t i)
{
	return &f->asked[i];
}

double
forecast_value_of_model_alone(struct forecast *f, size_t i)
{
	return quantity_of_curve(f, i, curve_of_model_alone(f));
}

double
forecast_tip_speed(const struct forecast *f)
{
	return f->speed;
}

struct figure
forecast_break_size(const struct forecast *f)
{
	const struct posterior *p =
	    f->ensemble != NULL ? ensemble_posterior(f->ensemble) : NULL;
	double draw[DRAWS];
	struct figure x = {
	    params_break_size_by_impacts(&f->params, &f->settings, f->speed),
	    NAN, NAN};
	for (size_t d = 0; d < DRAWS && p != NULL; d++)
		draw[d] = params_break_size_by_impacts(
		    &p->draw[d].params, &p->settings, f->speed);
	if (p != NULL)
		ensemble_middle_interval(draw, f->level, &x.low, &x.high);
	return x;
}

double
forecast_broken_feed_share(struct forecast *f)
{
	return model_broken_feed_share(f->model, f->speed);
}

bool
forecast_is_feed_broken(struct forecast *f)
{
	return model_is_feed_broken(f->model, f->speed);
}

const double *
forecast_draws_of_quantity(const struct forecast *f, size_t i)
{
	return f->draw[i];
}

/* Returns how far quantity i, with this value on a curve of the product, is
 * above a limit. */
static double
excess_of_curve_over_limit(struct forecast *f, size_t i, double limit,
    double value, const struct psd *curve)
{
	double share;
	curve = quantity_excess_needs_whole_curve(&f->asked[i])
		    ? curve_of_fraction(f, i, curve, &share)
		    : NULL;
	return quantity_excess_as_passing(&f->asked[i], limit, value, curve);
}

double
forecast_excess_over_limit(struct forecast *f, size_t i, double limit)
{
	return excess_of_curve_over_limit(
	    f, i, limit, f->value[i], &f->product);
}

void
forecast_excess_in_each_draw(struct forecast *f, size_t i, double limit,
    double over[static POSTERIOR_DRAWS])
{
	for (size_t d = 0; d < DRAWS; d++) {
		if (quantity_excess_needs_whole_curve(&f->asked[i]))
			fill_posterior_draw_curve(f, d);
		over[d] = excess_of_curve_over_limit(
		    f, i, limit, f->draw[i][d], &f->curve);
	}
}

/* True if the quantity is higher than can be read, not lower, where the curve
 * does not reach far enough: Cu and Cc are divided by D10. */
static bool
is_high_beyond_curve(const struct quantity *q)
{
	return q->kind == QUANTITY_UNIFORMITY || q->kind == QUANTITY_CURVATURE;
}

struct figure
forecast_value_with_band(const struct forecast *f, size_t i)
{
	double to_hold = f->of == ENSEMBLE_ANSWER ? f->value[i] : NAN;
	double range[2] = {NAN, NAN}, draw[DRAWS];
	double sign = is_high_beyond_curve(&f->asked[i]) ? -1 : 1;
	if (f->draw[i] == NULL)
		return (struct figure){f->value[i], NAN, NAN};
	for (size_t d = 0; d < DRAWS; d++)
		draw[d] = sign * f->draw[i][d];
	ensemble_interval_around_answer(draw, f->level, sign * to_hold, range);
	return sign > 0 ? (struct figure){f->value[i], range[0], range[1]}
			: (struct figure){f->value[i], -range[1], -range[0]};
}

struct figure
forecast_difference(
    const struct forecast *one, const struct forecast *two, size_t i)
{
	double more[DRAWS], less[DRAWS];
	double low[2] = {NAN, NAN}, high[2] = {NAN, NAN};
	const double *a = one->draw[i], *b = two->draw[i];
	for (size_t d = 0; d < DRAWS && a != NULL && b != NULL; d++) {
		more[d] = b[d] - a[d];
		less[d] = -more[d];
	}
	/* A draw with one side beyond the sieves may be at either end. */
	if (a != NULL && b != NULL) {
		ensemble_interval_around_answer(more, one->level, NAN, low);
		ensemble_interval_around_answer(less, one->level, NAN, high);
	}
	return (struct figure){two->value[i] - one->value[i], low[0], -high[0]};
}

struct psd
forecast_screened_curve(struct forecast *f, size_t i)
{
	double share;
	return psd_copy(curve_of_fraction(f, i, &f->product, &share));
}
