/* Bisection on what rises with the speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/inverse.h"

#include <math.h>
#include <string.h>

#include "core/product.h"

struct inverse
inverse_new(const struct psd *feed, const double *sieve, size_t n,
    const struct params *p, struct model_settings settings,
    const struct posterior *posterior)
{
	struct inverse inverse = {.model = model_new(feed, sieve, n, settings),
	    .product = psd_new(n)};
	memcpy(inverse.product.size, sieve, n * sizeof *sieve);
	model_set(inverse.model, p);
	if (posterior != NULL)
		inverse.ensemble = ensemble_new(posterior, feed, sieve, n);
	return inverse;
}

void
inverse_free(struct inverse *inverse)
{
	model_free(inverse->model);
	ensemble_free(inverse->ensemble);
	psd_free(&inverse->product);
}

const struct psd *
inverse_at(struct inverse *inverse, double v)
{
	double *passing = inverse->product.passing;
	if (inverse->ensemble == NULL) {
		model_product(inverse->model, v, passing);
		return &inverse->product;
	}
	ensemble_at(inverse->ensemble, v);
	ensemble_mean(inverse->ensemble, passing);
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

/* The product of a draw at the speed that the ensemble is at. */
static void
take_draw(struct inverse *inverse, size_t draw)
{
	const double *P =
	    ensemble_products(inverse->ensemble, ENSEMBLE_ANSWER) + draw;
	for (size_t i = 0; i < inverse->product.n; i++)
		inverse->product.passing[i] = P[i * POSTERIOR_DRAWS];
}

double
inverse_certainty(
    struct inverse *inverse, const struct envelope *envelope, double v)
{
	struct held held = {inverse, envelope};
	size_t inside = 0, worst;
	if (inverse->ensemble == NULL)
		return NAN;
	ensemble_at(inverse->ensemble, v);
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
		take_draw(inverse, d);
		inside += missed(&held, true, &worst) <= EXACT &&
			  missed(&held, false, &worst) <= EXACT;
	}
	return (double)inside / POSTERIOR_DRAWS;
}

enum { STEPS = 48 };

/* Where a draw crosses a passing, from its passings [STEPS + 1] at equal steps
 * of the speed. */
static double
crossing(const double *P, double passing, double from, double to)
{
	size_t k = 0;
	if (P[0] >= passing)
		return P[0] > passing ? 0 : from;
	while (k <= STEPS && P[k] < passing)
		k++;
	if (k > STEPS)
		return INFINITY;
	double part = (passing - P[k - 1]) / (P[k] - P[k - 1]);
	return from + (to - from) * ((double)k - 1 + part) / STEPS;
}

void
inverse_range(struct inverse *inverse, double x, double passing, double from,
    double to, double level, double range[static 2])
{
	enum { N = POSTERIOR_DRAWS };
	double P[N][STEPS + 1], speed[N];
	range[0] = range[1] = NAN;
	if (inverse->ensemble == NULL)
		return;
	for (size_t k = 0; k <= STEPS; k++) {
		double v = from + (to - from) * (double)k / STEPS;
		ensemble_at(inverse->ensemble, v);
		for (size_t d = 0; d < N; d++) {
			take_draw(inverse, d);
			P[d][k] = psd_passing(&inverse->product, x);
		}
	}
	for (size_t d = 0; d < N; d++)
		speed[d] = crossing(P[d], passing, from, to);
	ensemble_middle(speed, level, &range[0], &range[1]);
}
