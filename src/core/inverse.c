/* Bisection on what rises with the speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/inverse.h"

#include <math.h>
#include <string.h>

#include "core/product.h"

struct inverse
inverse_new(const struct psd *feed, const double *sieve, size_t n,
    const struct params *p, struct model_settings settings)
{
	struct inverse inverse = {
	    model_new(feed, sieve, n, settings), psd_new(n)};
	memcpy(inverse.product.size, sieve, n * sizeof *sieve);
	model_set(inverse.model, p);
	return inverse;
}

void
inverse_free(struct inverse *inverse)
{
	model_free(inverse->model);
	psd_free(&inverse->product);
}

const struct psd *
inverse_at(struct inverse *inverse, double v)
{
	model_product(inverse->model, v, inverse->product.passing);
	return &inverse->product;
}

double
inverse_speed(
    double (*rises)(void *data, double v), void *data, double from, double to)
{
	if (rises(data, from) >= 0)
		return from;
	if (rises(data, to) < 0)
		return INFINITY;
	while (to - from > 1e-9) {
		double middle = (from + to) / 2;
		if (rises(data, middle) >= 0)
			to = middle;
		else
			from = middle;
	}
	return to;
}

/* An inverse with the envelope it is compared with. */
struct held {
	struct inverse *inverse;
	const struct envelope *envelope;
};

/* By how much the worst sieve is over its upper limit, else short of its lower
 * one; below 0 when none is.  Over rises with the speed, short falls. */
static double
missed(const struct held *held, bool over, size_t *worst)
{
	const struct psd *product = &held->inverse->product;
	double most = -INFINITY;
	for (size_t i = 0; i < product->n; i++) {
		double p = product->passing[i];
		double by = over ? p - held->envelope->most[i]
				 : held->envelope->least[i] - p;
		if (by > most) {
			most = by;
			*worst = i;
		}
	}
	return most;
}

/* A limit is met when it is missed by no more than arithmetic does. */
static const double EXACT = 1e-9;

static double
enough(void *data, double v)
{
	struct held *held = data;
	size_t worst;
	inverse_at(held->inverse, v);
	return EXACT - missed(held, false, &worst);
}

static double
too_much(void *data, double v)
{
	struct held *held = data;
	size_t worst;
	inverse_at(held->inverse, v);
	return missed(held, true, &worst) - EXACT;
}

/* Rises with the speed and is 0 where both limits are missed alike. */
static double
finer_than_coarse(void *data, double v)
{
	struct held *held = data;
	size_t worst;
	inverse_at(held->inverse, v);
	return missed(held, true, &worst) - missed(held, false, &worst);
}

double
inverse_outside(struct inverse *inverse, const struct envelope *envelope,
    double v, size_t *worst)
{
	struct held held = {inverse, envelope};
	size_t coarse = 0, fine = 0;
	inverse_at(inverse, v);
	double short_of = missed(&held, false, &coarse);
	double over = missed(&held, true, &fine);
	bool is_fine = over > short_of;
	*worst = is_fine ? fine : coarse;
	if (fmax(short_of, over) <= EXACT)
		return 0;
	return is_fine ? over : -short_of;
}

struct window
inverse_window(struct inverse *inverse, const struct envelope *envelope,
    double from, double to)
{
	struct held held = {inverse, envelope};
	struct window w = {.slowest = inverse_speed(enough, &held, from, to),
	    .fastest = inverse_speed(too_much, &held, from, to)};
	bool too_fine_at_once = too_much(&held, from) > 0;
	w.inside =
	    isfinite(w.slowest) && !too_fine_at_once && w.slowest <= w.fastest;
	w.fastest = fmin(w.fastest, to);
	if (w.inside)
		return w;
	double even = inverse_speed(finer_than_coarse, &held, from, to);
	w.nearest = fmin(even, to);
	w.by = inverse_outside(inverse, envelope, w.nearest, &w.worst);
	return w;
}
