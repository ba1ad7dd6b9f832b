/* Nearest materials, their products, and what such guesses are worth.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/guess.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "core/breakage.h"
#include "core/predict.h"
#include "core/synth.h"

/* Same parameters, settings and top size, as Ubbarp and Gasgruvan have. */
static bool
same_numbers(const struct guess_material *a, const struct guess_material *b)
{
	if (a->params.breakage != b->params.breakage)
		return false;
	for (size_t j = 0; j < breakage_of(&a->params)->n; j++)
		if (a->params.at[j] != b->params.at[j])
			return false;
	return a->top_size == b->top_size &&
	       model_settings_same(&a->settings, &b->settings);
}

static bool
same_rock(const struct guess_material *a, const struct guess_material *b)
{
	return a->rock[0] != '\0' && text_same(a->rock, b->rock);
}

/* How far m lies from what is wanted among those of its rock. */
static double
size_distance(
    const struct guess_material *m, const struct guess_material *wanted)
{
	if (wanted->top_size <= 0)
		return 0;
	return m->top_size > 0 ? fabs(log(m->top_size / wanted->top_size))
			       : INFINITY;
}

static bool
nearer(const struct guess_material *a, const struct guess_material *b,
    const struct guess_material *wanted)
{
	bool rock_a = same_rock(a, wanted), rock_b = same_rock(b, wanted);
	if (rock_a != rock_b)
		return rock_a;
	/* 11.2 mm read twice may differ in the last bit. */
	return size_distance(a, wanted) < size_distance(b, wanted) - 1e-9;
}

size_t
guess_nearest(const struct guess_material *m, size_t n,
    const struct guess_material *wanted, const bool *leave_out, size_t most,
    size_t *pick)
{
	size_t picked = 0;
	bool *taken = xcalloc(n, sizeof *taken);
	memcpy(taken, leave_out, n * sizeof *taken);
	while (picked < most) {
		size_t best = n;
		for (size_t i = 0; i < n; i++)
			if (!taken[i] &&
			    (best == n || nearer(&m[i], &m[best], wanted)))
				best = i;
		if (best == n)
			break;
		for (size_t i = 0; i < n; i++)
			taken[i] = taken[i] || same_numbers(&m[i], &m[best]);
		pick[picked++] = best;
	}
	free(taken);
	return picked;
}

static int
rising(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

/* Sorts v, which has no NAN. */
static struct guess_range
range_of(double *v, size_t n)
{
	qsort(v, n, sizeof *v, rising);
	double middle = n % 2 == 1 ? v[n / 2] : 0.5 * (v[n / 2 - 1] + v[n / 2]);
	return (struct guess_range){middle, v[0], v[n - 1]};
}

/* A size that lies outside the sieves is finer than they are, as some sieve
 * passes all of the feed and of the product: it is the least then. */
static struct guess_range
range_of_sizes(const struct psd *median, const struct prediction *p, size_t n,
    double passing)
{
	struct guess_range range = {
	    psd_size(median, passing), INFINITY, -INFINITY};
	bool finer = false;
	for (size_t i = 0; i < n; i++) {
		double x = psd_size(&p[i].product, passing);
		finer = finer || isnan(x);
		range.least = fmin(range.least, x);
		range.most = fmax(range.most, x);
	}
	if (finer)
		range.least = NAN;
	if (isinf(range.most))
		range.most = NAN;
	return range;
}

/* The curves over n products on the same sieves. */
static void
spread(struct guess *guess, const struct prediction *p, size_t n)
{
	double *v = xdoubles(n);
	guess->feed = psd_copy(&p[0].feed);
	guess->median = psd_copy(&p[0].product);
	guess->least = psd_copy(&p[0].product);
	guess->most = psd_copy(&p[0].product);
	for (size_t s = 0; s < guess->median.n; s++) {
		for (size_t i = 0; i < n; i++)
			v[i] = p[i].product.passing[s];
		struct guess_range range = range_of(v, n);
		guess->median.passing[s] = range.middle;
		guess->least.passing[s] = range.least;
		guess->most.passing[s] = range.most;
	}
	for (size_t i = 0; i < n; i++)
		v[i] = p[i].break_size;
	guess->break_size = range_of(v, n);
	free(v);
}

struct guess
guess_product(const struct site *site, size_t feed_run,
    const struct guess_material *m, const size_t *pick, size_t n, double v)
{
	struct guess guess = {.speed = v};
	struct prediction *p = xcalloc(n, sizeof *p);
	assert(n >= 1);
	for (size_t i = 0; i < n; i++)
		p[i] = predict(
		    site, &m[pick[i]].params, m[pick[i]].settings, v, feed_run);
	spread(&guess, p, n);
	for (size_t i = 0; i < PSD_SIZES; i++)
		guess.size[i] =
		    range_of_sizes(&guess.median, p, n, PSD_PASSING[i]);
	for (size_t i = 0; i < n; i++)
		prediction_free(&p[i]);
	free(p);
	return guess;
}

void
guess_free(struct guess *guess)
{
	psd_free(&guess->feed);
	psd_free(&guess->median);
	psd_free(&guess->least);
	psd_free(&guess->most);
}

/* The error of the guess of one material, and of product = feed. */
static void
guess_one(const struct guess_material *m, const size_t *pick, size_t n,
    const struct guess_material *truth, double v, double *error, double *feed)
{
	struct synth synth = {.top_size = truth->top_size,
	    .params = truth->params,
	    .n = 1,
	    .n_speed = 1,
	    .speed = &v};
	struct site *site = synth_site(&synth);
	struct guess guess = guess_product(site, 0, m, pick, n, v);
	struct prediction p =
	    predict(site, &truth->params, truth->settings, v, 0);
	*error =
	    psd_rms(guess.median.passing, p.product.passing, p.product.n, NULL);
	*feed = psd_rms(p.feed.passing, p.product.passing, p.product.n, NULL);
	prediction_free(&p);
	guess_free(&guess);
	site_free(site);
}

struct guess_error
guess_leave_one_out(
    const struct guess_material *m, size_t n, size_t nearest, double v)
{
	struct guess_error out = {.worst = -1};
	bool *leave_out = xcalloc(n, sizeof *leave_out);
	size_t *pick = xcalloc(nearest, sizeof *pick);
	double *error = xdoubles(n), *feed = xdoubles(n);
	for (size_t i = 0; i < n; i++) {
		bool twin = false;
		for (size_t j = 0; j < n; j++) {
			bool same = same_numbers(&m[i], &m[j]);
			twin = twin || (same && j < i);
			leave_out[j] = same || text_same(m[i].site, m[j].site);
		}
		size_t picked =
		    guess_nearest(m, n, &m[i], leave_out, nearest, pick);
		if (twin || picked == 0)
			continue;
		guess_one(
		    m, pick, picked, &m[i], v, &error[out.n], &feed[out.n]);
		if (error[out.n] > out.worst) {
			out.worst = error[out.n];
			out.worst_at = i;
		}
		out.n++;
	}
	if (out.n > 0) {
		out.median = range_of(error, out.n).middle;
		out.feed = range_of(feed, out.n).middle;
	}
	free(leave_out);
	free(pick);
	free(error);
	free(feed);
	return out;
}
