/* Hold-out runs, always beside two null models.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/validate.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/misfit.h"
#include "core/product.h"

double
validate_interpolation(
    const struct site *site, const bool *train, double speed, double x)
{
	size_t below = site->n_run, above = site->n_run;
	for (size_t r = 0; r < site->n_run; r++) {
		if (!train[r] || site->run[r].product.n == 0)
			continue;
		bool first = below == site->n_run;
		if (first || site->run[r].speed <= speed) {
			below = r;
		} else if (above == site->n_run) {
			above = r;
		}
	}
	/* Above the fastest: the two fastest; `below` is then the fastest. */
	for (size_t r = below; above == site->n_run && r-- > 0;)
		if (train[r] && site->run[r].product.n > 0)
			above = r;
	if (above == site->n_run)
		return NAN;
	const struct run *a = &site->run[below], *b = &site->run[above];
	if (!psd_covers(&a->product, x) || !psd_covers(&b->product, x))
		return NAN;
	double E_a = energy_specific(a->speed), E_b = energy_specific(b->speed);
	double t = (energy_specific(speed) - E_a) / (E_b - E_a);
	double at_a = psd_passing(&a->product, x);
	return at_a + t * (psd_passing(&b->product, x) - at_a);
}

bool
validation_loses(const struct validation *v)
{
	return v->holdout && v->interpolation_rmse < v->rmse;
}

static void
compare_sizes(struct validation *v, const struct psd *measured,
    const struct psd *predicted)
{
	for (size_t i = 0; i < PSD_SIZES; i++)
		v->size[i] = (struct validate_size){PSD_PASSING[i],
		    psd_size(measured, PSD_PASSING[i]),
		    psd_size(predicted, PSD_PASSING[i])};
}

static void
compare_nulls(struct validation *v, const struct site *site, const bool *train,
    const struct psd *predicted)
{
	const struct run *run = &site->run[v->run];
	size_t n = predicted->n;
	double *null = xdoubles(n);
	for (size_t i = 0; i < n; i++)
		null[i] = psd_passing(&run->feed, predicted->size[i]);
	v->feed_rmse = psd_rms(null, run->product.passing, n, NULL);
	for (size_t i = 0; i < n; i++)
		null[i] = validate_interpolation(
		    site, train, run->speed, predicted->size[i]);
	v->interpolation_rmse = psd_rms(null, run->product.passing, n, NULL);
	free(null);
}

struct validation
validate_run(const struct site *site, size_t run, const bool *train,
    const struct params *p, struct model_settings settings)
{
	const struct run *at = &site->run[run];
	size_t n = misfit_covered(at), worst = 0;
	assert(n > 0);
	struct validation v = {.run = run,
	    .speed = at->speed,
	    .holdout = !train[run],
	    .n_sieve = n,
	    .n_left_out = at->product.n - n};
	struct psd predicted = psd_copy(&at->product);
	predicted.n = n;
	struct model *model = model_new(&at->feed, predicted.size, n, settings);
	model_set(model, p);
	model_product(model, at->speed, predicted.passing);
	model_free(model);
	v.rmse = psd_rms(predicted.passing, at->product.passing, n, &worst);
	v.misfit = v.rmse * v.rmse * (double)n;
	v.worst_sieve = predicted.size[worst];
	v.worst_difference =
	    predicted.passing[worst] - at->product.passing[worst];
	compare_sizes(&v, &at->product, &predicted);
	compare_nulls(&v, site, train, &predicted);
	psd_free(&predicted);
	return v;
}
