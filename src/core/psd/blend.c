/* Adds feeds up by mass at the sieves of all of them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/blend.h"

#include <stdbool.h>
#include <string.h>

/* The sieves of all, coarsest first, passings 0. */
static struct psd
all_sieves(const struct psd *const *feed, size_t n)
{
	size_t room = 0;
	for (size_t i = 0; i < n; i++)
		room += feed[i]->n;
	struct psd all = psd_new(room);
	all.n = 0;
	for (size_t i = 0; i < n; i++) {
		memcpy(all.size + all.n, feed[i]->size,
		    feed[i]->n * sizeof *all.size);
		all.n += feed[i]->n;
	}
	all.n = psd_sort(all.size, all.n, 0);
	return all;
}

struct psd
blend_new(const struct psd *const *feed, const double *part, size_t n)
{
	struct psd blend = all_sieves(feed, n);
	double sum = 0;
	for (size_t i = 0; i < n; i++)
		sum += part[i];
	size_t known = 0;
	for (bool all = true; known < blend.n; known++) {
		double x = blend.size[known], passing = 0;
		for (size_t i = 0; i < n; i++) {
			all = all && psd_covers(feed[i], x);
			passing += part[i] * psd_passing(feed[i], x);
		}
		if (!all)
			break;
		blend.passing[known] = known == 0 ? 1 : passing / sum;
	}
	blend.n = known;
	return blend;
}
