/* Passes each class of a feed through the model separately, as Eq 2 is linear
 * in the feed, and adds up where its mass goes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/mass_balance.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/answer/predict.h"
#include "core/model/product.h"

/* Computes product [n]: the share of one class's mass that ends up in each
 * class. */
static void
compute_product_of_class(const struct psd *feed, const struct params *p,
    struct model_settings settings, double v, size_t class, double *product)
{
	struct psd one = psd_copy(feed);
	for (size_t i = 0; i < one.n; i++)
		one.passing[i] = i <= class ? 1 : 0;
	struct model *model = model_new(&one, one.size, one.n, settings);
	model_set_params(model, p);
	model_compute_product(model, v, product);
	for (size_t i = 0; i + 1 < one.n; i++)
		product[i] -= product[i + 1];
	model_free(model);
	psd_free(&one);
}

static void
mass_balance_add_class(struct mass_balance *l, size_t class, double selected,
    const double *product)
{
	double feed = l->feed[class], stays = feed * product[class];
	l->unbroken[class] = feed * fmax(1 - selected, 0);
	l->unbroken[class] = fmin(l->unbroken[class], stays);
	l->within[class] = stays - l->unbroken[class];
	l->left[class] = feed - stays;
	l->broken += feed - l->unbroken[class];
	for (size_t i = class + 1; i < l->n; i++)
		l->arrived[i] += feed * product[i];
}

struct mass_balance
mass_balance_new(const struct psd *feed, const struct params *p,
    struct model_settings settings, double v)
{
	size_t n = feed->n;
	struct mass_balance l = {.n = n,
	    .feed = xcalloc_doubles(n),
	    .unbroken = xcalloc_doubles(n),
	    .within = xcalloc_doubles(n),
	    .left = xcalloc_doubles(n),
	    .arrived = xcalloc_doubles(n),
	    .product = xcalloc_doubles(n)};
	FREED double *S = xcalloc_doubles(n), *product = xcalloc_doubles(n);
	predict_broken_share_of_classes(feed, p, settings, v, S);
	for (size_t i = 0; i < n; i++) {
		double finer = i + 1 < n ? feed->passing[i + 1] : 0;
		l.feed[i] = feed->passing[i] - finer;
		compute_product_of_class(feed, p, settings, v, i, product);
		mass_balance_add_class(&l, i, S[i], product);
	}
	for (size_t i = 0; i < n; i++)
		l.product[i] = l.unbroken[i] + l.within[i] + l.arrived[i];
	return l;
}

void
mass_balance_free(struct mass_balance *l)
{
	free(l->feed);
	free(l->unbroken);
	free(l->within);
	free(l->left);
	free(l->arrived);
	free(l->product);
}

size_t
mass_balance_largest_class(const double *a, const double *b, size_t n)
{
	size_t most = 0;
	for (size_t i = 1; i < n; i++) {
		double at = a[i] - (b != NULL ? b[i] : 0);
		double best = a[most] - (b != NULL ? b[most] : 0);
		most = at > best ? i : most;
	}
	return most;
}
