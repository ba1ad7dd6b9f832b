/* Measures how much one more sample narrows the band of an answer, both for the
 * sample that advise names and for the others that it considers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/answer/advise.h"
#include "core/posterior/ensemble.h"
#include "counts.h"
#include "plants.h"

enum { N = POSTERIOR_DRAWS, SAMPLES = 7, ASKED = 3 };

static const double ASKED_SPEED[ASKED] = {65, 72, 85},
		    SAMPLE[SAMPLES] = {65, 69, 72, 74, 79, 82, 85};

/* A plant, and the sieve and speed asked about. */
struct asking {
	struct plant plant;
	uint64_t number;
	size_t sieve;
	double speed;
};

/* The width of the band, the error of the answer, and the width that each
 * sample is predicted to leave. */
struct band {
	double width, off, said[SAMPLES];
};

static void
weigh(const struct asking *a, struct ensemble *e, struct band *band)
{
	double answer[N];
	size_t n = a->plant.n_sieve;
	ensemble_set_speed(e, a->speed);
	memcpy(answer, ensemble_products(e, ENSEMBLE_ANSWER) + a->sieve * N,
	    sizeof answer);
	for (size_t i = 0; i < SAMPLES; i++) {
		ensemble_set_speed(e, SAMPLE[i]);
		const double *sample = ensemble_products(e, ENSEMBLE_SAMPLE);
		band->said[i] =
		    band->width *
		    sqrt(1 - advise_variance_share_removed(answer, sample, n));
	}
}

static struct band
band_of(const struct asking *a, const struct site *site)
{
	const struct plant *p = &a->plant;
	const struct psd *feed = site_feed_of_run(site, SITE_MEAN_FEED);
	double asked[PLANT_SIEVES], mean[PLANT_SIEVES], low, high;
	struct fit fit;
	struct posterior *posterior = counts_calibrate(site, a->number, &fit);
	struct ensemble *e =
	    ensemble_new(posterior, feed, p->sieve, p->n_sieve);
	for (size_t i = 0; i < p->n_sieve; i++)
		asked[i] = psd_passing(feed, p->sieve[i]);
	ensemble_set_speed(e, a->speed);
	ensemble_mean_answer(e, mean);
	ensemble_interval_at_sieve(
	    e, ENSEMBLE_ANSWER, a->sieve, 0.8, &low, &high);
	struct band band = {.width = high - low,
	    .off = mean[a->sieve] -
		   plant_truth(p, asked, a->speed, p->sieve[a->sieve])};
	weigh(a, e, &band);
	ensemble_free(e);
	posterior_free(posterior);
	return band;
}

static int
slower_first(const void *a, const void *b)
{
	double x = ((const struct run *)a)->speed;
	double y = ((const struct run *)b)->speed;
	return (x > y) - (x < y);
}

/* Returns the sheet with one more run, which has new errors. */
static struct site *
sheet_with(const struct asking *a, double v)
{
	struct plant more = a->plant;
	more.speed[more.n_run++] = v;
	struct site *site = plant_site(&more, a->number);
	qsort(site->run, site->n_run, sizeof *site->run, slower_first);
	site_update_digest_and_mean_feed(site);
	return site;
}

/* Over plants: the width after a sample over the width before, and the errors
 * of the answer, for the sample named, the mean of all, and the best of all.
 * first: the sample named is the best. */
struct left {
	struct counts_mean said, named, any, best, first;
	double before, after, after_any;
};

static void
count_plant(const struct asking *a, struct left *left)
{
	struct site *site = plant_site(&a->plant, a->number);
	struct band now = band_of(a, site);
	size_t named = 0;
	double best = INFINITY, any = 0, after = NAN, squares = 0;
	site_free(site);
	for (size_t i = 0; i < SAMPLES; i++)
		named = now.said[i] < now.said[named] ? i : named;
	for (size_t i = 0; i < SAMPLES; i++) {
		struct site *with = sheet_with(a, SAMPLE[i]);
		struct band then = band_of(a, with);
		site_free(with);
		best = fmin(best, then.width);
		any += then.width / SAMPLES;
		squares += then.off * then.off / SAMPLES;
		if (i != named)
			continue;
		after = then.width;
		left->after += then.off * then.off;
	}
	left->before += now.off * now.off;
	left->after_any += squares;
	counts_add(&left->said, now.said[named] / now.width);
	counts_add(&left->named, after / now.width);
	counts_add(&left->any, any / now.width);
	counts_add(&left->best, best / now.width);
	counts_add(&left->first, after == best);
}

/* Returns the sieve at which the product's passing is nearest to 0.4, because
 * users ask about the middle of the curve. */
static size_t
middle_sieve(const struct plant *p, double v)
{
	size_t best = 0;
	double least = INFINITY;
	for (size_t i = 0; i < p->n_sieve; i++) {
		double P = plant_product(p, p->feed_n, v, p->sieve[i]);
		if (fabs(P - 0.4) < least) {
			least = fabs(P - 0.4);
			best = i;
		}
	}
	return best;
}

static void
print_left(const struct left *left)
{
	const struct counts_mean *mean[] = {
	    &left->said, &left->named, &left->any, &left->best, &left->first};
	double n = left->named.n;
	for (size_t i = 0; i < ARRAY_LEN(mean); i++)
		counts_print(mean[i], 100);
	printf("   %.2f %.2f %.2f\n", 100 * sqrt(left->before / n),
	    100 * sqrt(left->after / n), 100 * sqrt(left->after_any / n));
}

bool
count_advise(size_t n)
{
	bool ok = true;
	printf("width of the band after one more sample, %% of that before, "
	       "and errors of the answer, points\n"
	       "%-7s%14s%14s%14s%14s%14s   %s\n",
	    "asked", "named, said", "named", "any", "best", "named is best",
	    "before, named, any");
	for (size_t q = 0; q < ASKED; q++) {
		struct left left = {.before = 0};
		for (size_t i = q; i < n; i += ASKED) {
			struct asking a = {.speed = ASKED_SPEED[q]};
			a.plant = counts_plant(i, &a.number);
			a.sieve = middle_sieve(&a.plant, a.speed);
			count_plant(&a, &left);
		}
		if (left.named.n == 0)
			break;
		printf("%2.0f m/s", ASKED_SPEED[q]);
		print_left(&left);
		fflush(stdout);
		ok = ok && left.named.sum <
			       left.any.sum +
				   3 * left.any.n * counts_error(&left.any);
	}
	return ok;
}
