/* Combines several sieve curves, which may end at different sizes, into one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/blend.h"

#include <math.h>
#include <stdbool.h>

#include "base/xalloc.h"

static bool
have_same_sieves(const struct psd *a, const struct psd *b)
{
	size_t i = 0;
	while (i < a->n && i < b->n && a->size[i] == b->size[i])
		i++;
	return i == a->n && i == b->n;
}

/* Most curves of a site have the sieves of the one before, and are left out of
 * the sort, which would otherwise take longest. */
struct psd
blend_list_sieves(const struct psd *const *curve, size_t n)
{
	size_t room = 0;
	for (size_t i = 0; i < n; i++)
		room += curve[i]->n;
	struct psd all = psd_new(room);
	all.n = 0;
	for (size_t i = 0; i < n; i++)
		if (i == 0 || !have_same_sieves(curve[i], curve[i - 1]))
			for (size_t k = 0; k < curve[i]->n; k++)
				all.size[all.n++] = curve[i]->size[k];
	all.n = psd_sort_distinct_sizes(all.size, all.n, 0);
	return all;
}

struct psd
blend_new(const struct psd *const *feed, const double *part, size_t n)
{
	struct psd blend = blend_list_sieves(feed, n);
	double sum = 0;
	for (size_t i = 0; i < n; i++)
		sum += part[i];
	size_t known = 0;
	for (bool all = true; known < blend.n; known++) {
		double x = blend.size[known], passing = 0;
		for (size_t i = 0; i < n; i++) {
			all = all && psd_covers_size(feed[i], x);
			passing += part[i] * psd_passing(feed[i], x);
		}
		if (!all)
			break;
		blend.passing[known] = known == 0 ? 1 : passing / sum;
	}
	blend.n = known;
	return blend;
}

/* Sets out to the feeds [n] without empty ones and repetitions; returns their
 * number. */
static size_t
find_distinct_feeds(
    const struct psd *const *feed, size_t n, const struct psd **out)
{
	size_t kept = 0;
	for (size_t i = 0; i < n; i++) {
		size_t k = 0;
		while (k < kept && !psd_is_same(out[k], feed[i]))
			k++;
		if (k == kept && feed[i]->n > 0)
			out[kept++] = feed[i];
	}
	return kept;
}

struct psd
blend_mean_of_feeds(const struct psd *const *feed, size_t n)
{
	FREED const struct psd **own = xcalloc(n, sizeof *own);
	n = find_distinct_feeds(feed, n, own);
	struct psd mean = blend_list_sieves(own, n);
	for (size_t k = 0; k < mean.n; k++) {
		double x = mean.size[k], above = k > 0 ? mean.size[k - 1] : x;
		double here = 0, before = 0;
		size_t known = 0;
		for (size_t i = 0; i < n; i++) {
			if (!psd_covers_size(own[i], x))
				continue;
			known++;
			here += psd_passing(own[i], x);
			before += psd_passing(own[i], above);
		}
		/* Below the finest sieve of a feed, the mean falls as the
		 * others do. */
		mean.passing[k] = known == n ? here / (double)n
				  : before > 0
				      ? mean.passing[k - 1] * here / before
				      : 0;
	}
	return mean;
}

double
blend_largest_feed_difference(
    const struct psd *const *feed, size_t n, double *sieve)
{
	struct psd all = blend_list_sieves(feed, n);
	double most = 0;
	*sieve = 0;
	for (size_t k = 0; k < all.n; k++) {
		double x = all.size[k], least = 1, largest = 0;
		for (size_t i = 0; i < n; i++) {
			if (!psd_covers_size(feed[i], x))
				continue;
			least = fmin(least, psd_passing(feed[i], x));
			largest = fmax(largest, psd_passing(feed[i], x));
		}
		if (largest - least <= most)
			continue;
		most = largest - least;
		*sieve = x;
	}
	psd_free(&all);
	return most;
}
