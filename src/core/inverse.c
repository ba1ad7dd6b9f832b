/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/inverse.h"

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
	if (posterior == NULL)
		return inverse;
	inverse.ensemble = ensemble_new(posterior, feed, sieve, n);
	ensemble_machine(inverse.ensemble, settings);
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
