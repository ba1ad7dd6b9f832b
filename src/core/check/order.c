/* Compares two products sieve by sieve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/check/order.h"

struct order
order_of(const struct psd *slow, const struct psd *fast)
{
	struct order o = {0};
	double sum = 0, n = 0;
	for (size_t j = 0; j < fast->n; j++) {
		double x = fast->size[j];
		if (!psd_covers(slow, x))
			continue;
		double by = psd_passing(slow, x) - fast->passing[j];
		sum += by;
		n++;
		if (by > o.most) {
			o.most = by;
			o.at = x;
		}
	}
	o.mean = n > 0 ? sum / n : 0;
	return o;
}

bool
order_wrong(const struct order *o)
{
	const double on_the_whole = 0.003, far = 0.05;
	return o->most > ORDER_NOTABLE &&
	       (o->mean > on_the_whole || o->most > far);
}
