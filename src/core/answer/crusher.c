/* Transfer matrices: products of single size classes, from ensembles or from
 * the model, with the discrepancy added to the product of the whole feed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/crusher.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/numeric/elementary.h"
#include "core/posterior/discrepancy.h"
#include "core/posterior/ensemble.h"
#include "core/model/product.h"

enum { DRAWS = POSTERIOR_DRAWS };

/* The products of one feed: of the draws or, without a posterior, of the
 * model. */
struct feed_products {
	struct ensemble *draws;
	struct model *model;
};

struct crusher {
	const struct posterior *posterior;
	struct params params;
	struct model_settings settings;
	size_t n;
	double *size;
	struct feed_products *class; /* [n - 1], of each but the pan */
	/* Where a size lies on the way to the next coarser sieve from the next
	 * finer one, in log size; 1 at a sieve. */
	double *share; /* [n] */
	/* Of the question's feed: its masses [n], and at the sieves [n_sieve],
	 * which are its sizes number `at`, its product; or NULL. */
	double *feed;
	size_t n_sieve, *at;
	struct feed_products whole;
};

/* passing [draws][n - 1][n]: of the product of each class, at the sizes; delta,
 * more [draws][n], or NULL: the discrepancy over h, and the correction to the
 * predicted product (crusher_set_reference_feed). */
struct transfer {
	size_t n, draws;
	double *passing, *delta, *more, *share;
	double *feed; /* [n], room for the passing masses of a feed */
};

static struct feed_products
make_feed_product_model(const struct crusher *c, const struct psd *feed,
    const double *size, size_t n)
{
	struct feed_products of = {NULL, NULL};
	if (c->posterior != NULL) {
		of.draws = ensemble_new(c->posterior, feed, size, n);
		ensemble_set_machine_settings(of.draws, c->settings);
	} else {
		of.model = model_new(feed, size, n, c->settings);
		model_set_params(of.model, &c->params);
	}
	return of;
}

static void
free_feed_products(struct feed_products *of)
{
	ensemble_free(of->draws);
	model_free(of->model);
}

struct crusher *
crusher_new(const double *size, size_t n, const struct params *p,
    struct model_settings settings, const struct posterior *posterior)
{
	struct crusher *c = xcalloc(1, sizeof *c);
	*c = (struct crusher){.posterior = posterior,
	    .params = *p,
	    .settings = settings,
	    .n = n,
	    .size = xcalloc_doubles(n),
	    .share = xcalloc_doubles(n),
	    .class = xcalloc(n, sizeof *c->class)};
	memcpy(c->size, size, n * sizeof *size);
	for (size_t k = 0; k < n; k++)
		c->share[k] = 1;
	c->settings.bypass = 0;
	for (size_t i = 0; i + 1 < n; i++) {
		double bounds[2] = {size[i], size[i + 1]}, all[2] = {1, 0};
		struct psd feed = {2, bounds, all};
		c->class[i] = make_feed_product_model(c, &feed, size, n);
	}
	return c;
}

void
crusher_free(struct crusher *c)
{
	if (c == NULL)
		return;
	for (size_t i = 0; i < c->n; i++)
		free_feed_products(&c->class[i]);
	free_feed_products(&c->whole);
	free(c->feed);
	free(c->at);
	free(c->class);
	free(c->share);
	free(c->size);
	free(c);
}

static void
compute_interpolation_shares(struct crusher *c)
{
	for (size_t i = 0; i + 1 < c->n_sieve; i++) {
		size_t a = c->at[i], b = c->at[i + 1];
		double width = el_log(c->size[a] / c->size[b]);
		for (size_t k = a + 1; k < b; k++)
			c->share[k] = el_log(c->size[k] / c->size[b]) / width;
	}
}

void
crusher_set_reference_feed(
    struct crusher *c, const struct psd *feed, const double *sieve, size_t n)
{
	c->feed = xcalloc_doubles(c->n);
	c->at = xcalloc(n, sizeof *c->at);
	crusher_class_masses_of_feed(c, feed, c->feed);
	FREED double *known = xcalloc_doubles(n);
	for (size_t i = 0, k = 0; i < n; i++) {
		while (k + 1 < c->n && c->size[k] > sieve[i] * (1 + 1e-9))
			k++;
		if (fabs(c->size[k] - sieve[i]) > 1e-9 * sieve[i])
			continue;
		known[c->n_sieve] = sieve[i];
		c->at[c->n_sieve++] = k;
	}
	c->whole = make_feed_product_model(c, feed, known, c->n_sieve);
	compute_interpolation_shares(c);
}

/* Sums masses from the finest class on into below [n], which may be the array
 * mass.  Returns the total. */
static double
cumulate_from_finest_class(const double *mass, size_t n, double *below)
{
	double sum = 0;
	for (size_t i = n; i-- > 0;) {
		sum += mass[i];
		below[i] = sum;
	}
	return sum;
}

/* Sums the products of the classes of a feed: out [n] is what passes each size,
 * uncorrected, and t->feed what of the feed does.  Returns the feed's mass. */
static double
sum_products_of_feed_classes(
    const struct transfer *t, size_t draw, const double *in, double *out)
{
	size_t n = t->n;
	const double *row = t->passing + draw * (n - 1) * n;
	for (size_t i = 0; i < n; i++)
		out[i] = in[n - 1];
	for (size_t j = 0; j + 1 < n; j++, row += n)
		for (size_t i = 0; i < n && in[j] > 0; i++)
			out[i] += in[j] * row[i];
	return cumulate_from_finest_class(in, n, t->feed);
}

/* Computes the difference between the prediction and the sum of the classes at
 * the sieves, from the finest on: the sum is limited by the prediction at the
 * next finer sieve, as correct_passings_of_product will limit it. */
static void
transfer_compute_draw_correction(const struct crusher *c, struct transfer *t,
    size_t d, const double *P, double *out)
{
	double *more = t->more + d * c->n;
	const double *delta = t->delta != NULL ? t->delta + d * c->n : NULL;
	double finer = 0,
	       total = sum_products_of_feed_classes(t, d, c->feed, out);
	for (size_t i = c->n_sieve; i-- > 0;) {
		size_t k = c->at[i];
		double raw = out[k], least = fmax(t->feed[k], finer);
		if (delta != NULL)
			raw = total * discrepancy_corrected_passing(
					  raw / total, delta[k], least / total);
		more[k] = P[i * t->draws] - raw;
		finer = P[i * t->draws];
	}
}

static void
transfer_correct_to_prediction(struct crusher *c, struct transfer *t, double v)
{
	FREED double *P = xcalloc_doubles(c->n_sieve),
		     *out = xcalloc_doubles(c->n);
	const double *draws = P;
	t->more = xcalloc_doubles(t->draws * c->n);
	if (c->posterior != NULL) {
		ensemble_set_speed(c->whole.draws, v);
		draws = ensemble_products(c->whole.draws, ENSEMBLE_ANSWER);
	} else {
		model_compute_product(c->whole.model, v, P);
	}
	for (size_t d = 0; d < t->draws; d++)
		transfer_compute_draw_correction(c, t, d, draws + d, out);
}

struct transfer *
crusher_transfer_at_speed(struct crusher *c, double v)
{
	struct transfer *t = xcalloc(1, sizeof *t);
	size_t n = c->n;
	t->n = n;
	t->draws = c->posterior != NULL ? DRAWS : 1;
	t->passing = xcalloc_doubles(t->draws * n * n);
	t->feed = xcalloc_doubles(n);
	t->share = xcalloc_doubles(n);
	memcpy(t->share, c->share, n * sizeof *t->share);
	for (size_t i = 0; i + 1 < n; i++) {
		if (c->posterior == NULL) {
			model_compute_product(
			    c->class[i].model, v, t->passing + i * n);
			continue;
		}
		struct ensemble *draws = c->class[i].draws;
		ensemble_set_speed_unconstrained(draws, v);
		/* P has a row for each size, t->passing one for each draw. */
		const double *P = ensemble_products(draws, ENSEMBLE_MODEL);
		for (size_t d = 0; d < DRAWS; d++)
			for (size_t k = 0; k < n; k++)
				t->passing[(d * (n - 1) + i) * n + k] =
				    P[k * DRAWS + d];
	}
	if (c->posterior != NULL && n > 1) {
		t->delta = xcalloc_doubles(DRAWS * n);
		for (size_t d = 0; d < DRAWS; d++)
			ensemble_discrepancy_of_draw(
			    c->class[0].draws, d, t->delta + d * n);
	}
	if (c->feed != NULL)
		transfer_correct_to_prediction(c, t, v);
	return t;
}

void
transfer_free(struct transfer *t)
{
	if (t == NULL)
		return;
	free(t->passing);
	free(t->delta);
	free(t->more);
	free(t->share);
	free(t->feed);
	free(t);
}

size_t
transfer_count_draws(const struct transfer *t)
{
	return t->draws;
}

/* Makes the passings between two sieves, sizes `above` and `below`, straight in
 * log size (D20), but not coarser than the feed. */
static void
interpolate_between_sieves(
    const struct transfer *t, size_t above, size_t below, double *P)
{
	for (size_t k = above + 1; k < below; k++) {
		double straight =
		    P[below] + t->share[k] * (P[above] - P[below]);
		P[k] = fmax(straight, t->feed[k]);
	}
}

/* Corrects passings of the product, P [n], of `total` mass. */
static void
correct_passings_of_product(
    const struct transfer *t, size_t draw, double total, double *P)
{
	size_t n = t->n, finer = n;
	const double *delta = t->delta != NULL ? t->delta + draw * n : NULL;
	const double *more = t->more != NULL ? t->more + draw * n : NULL;
	for (size_t i = n; i-- > 0;) {
		if (t->share[i] < 1)
			continue;
		double least = finer < n ? P[finer] : 0;
		least = fmax(t->feed[i], least);
		if (delta != NULL && total > 0)
			P[i] =
			    total * discrepancy_corrected_passing(
					P[i] / total, delta[i], least / total);
		if (more != NULL)
			P[i] += total * more[i];
		P[i] = fmin(fmax(P[i], least), total);
		interpolate_between_sieves(t, i, finer, P);
		finer = i;
	}
}

void
transfer_compute_product(
    const struct transfer *t, size_t draw, const double *in, double *out)
{
	size_t n = t->n;
	double *below = out,
	       total = sum_products_of_feed_classes(t, draw, in, out);
	correct_passings_of_product(t, draw, total, below);
	/* All mass passes the coarsest size: the coarsest class gets what
	 * rounding lost. */
	below[0] = total;
	for (size_t i = 0; i + 1 < n; i++)
		out[i] = below[i] - below[i + 1];
}

void
crusher_class_masses_of_feed(
    const struct crusher *c, const struct psd *feed, double *out)
{
	double finer = 0;
	for (size_t i = c->n; i-- > 0;) {
		double P = psd_passing(feed, c->size[i]);
		out[i] = P - finer;
		finer = P;
	}
}
