/* Chooses draws.  A random subset would have random errors in everything.
 * Instead, one draw of each pair is kept, chosen to preserve the sums that
 * matter (as in the walks of Alweiss, Liu and Sawhney 2021 and Dwivedi and
 * Mackey 2024).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/thin.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>

#include "base/xalloc.h"
#include "core/posterior/ensemble.h"

/* An answer has three features: its value, and the side of each end of the band
 * on which it lies; see fill_draw_features_of_answer. */
enum { SPEEDS = 5, SIEVES = 16, FEATURES = 3 };

struct thin {
	struct psd feed;
	size_t n_sieve;
	double sieve[SIEVES];
	size_t n, added; /* candidates */
	double *answer;  /* [SPEEDS * n_sieve][n] */
};

struct thin *
thin_new(const struct site *site, size_t batches)
{
	struct thin *t = xcalloc(1, sizeof *t);
	size_t n, covered = 0;
	double *sieve = site_all_sieves(site, &n);
	t->feed = psd_copy(site_feed_of_run(site, SITE_MEAN_FEED));
	for (size_t i = 0; i < n; i++)
		if (psd_covers_size(&t->feed, sieve[i]))
			sieve[covered++] = sieve[i];
	t->n_sieve = covered < SIEVES ? covered : SIEVES;
	for (size_t i = 0; i < t->n_sieve; i++)
		t->sieve[i] = sieve[i * covered / t->n_sieve];
	free(sieve);
	t->n = batches * POSTERIOR_DRAWS;
	t->answer = xcalloc_doubles(SPEEDS * t->n_sieve * t->n + 1);
	return t;
}

void
thin_free(struct thin *t)
{
	if (t == NULL)
		return;
	psd_free(&t->feed);
	free(t->answer);
	free(t);
}

void
thin_add_posterior_batch(struct thin *t, const struct posterior *batch)
{
	if (t->n_sieve > 0) {
		struct ensemble *e =
		    ensemble_new(batch, &t->feed, t->sieve, t->n_sieve);
		double *to = t->answer + t->added;
		for (size_t k = 0; k < SPEEDS; k++) {
			double far = (double)k / (SPEEDS - 1);
			ensemble_set_speed_unconstrained(
			    e, batch->from + far * (batch->to - batch->from));
			const double *P = ensemble_products(e, ENSEMBLE_ANSWER);
			for (size_t i = 0; i < t->n_sieve; i++, to += t->n)
				memcpy(to, P + i * POSTERIOR_DRAWS,
				    POSTERIOR_DRAWS * sizeof *to);
		}
		ensemble_free(e);
	}
	t->added += POSTERIOR_DRAWS;
}

/* Returns the side of a band's end on which a value lies, from -1 to 1, with a
 * gradual change near the end. */
static double
soft_sign_of_distance(double off)
{
	return fmin(fmax(3 * off, -1), 1);
}

/* Writes the features of an answer to the candidates' rows [n][width], and adds
 * the answer to `by`, the values by which candidates are sorted. */
static void
fill_draw_features_of_answer(
    const double *answer, size_t n, double *row, size_t width, double *by)
{
	const double end = 1.28; /* standard deviations, for a band of 80 % */
	double mean = 0, squares = 0;
	for (size_t i = 0; i < n; i++)
		mean += answer[i] / (double)n;
	for (size_t i = 0; i < n; i++)
		squares += (answer[i] - mean) * (answer[i] - mean);
	double sd = sqrt(squares / (double)n);
	for (size_t i = 0; i < n && sd > 2e-4; i++, row += width) {
		double u = (answer[i] - mean) / sd;
		row[0] = u;
		row[1] = 2 * soft_sign_of_distance(u - end);
		row[2] = 2 * soft_sign_of_distance(u + end);
		by[i] += u;
	}
}

/* Chooses the draw of a pair so that the sums [width] of features of the kept
 * and of the other draws come closer.  *sign is the choice so far: 1 for the
 * first, -1 for the second, 0 for none.  Returns true if the choice changed. */
static bool
choose_draw_of_pair(const double *one, const double *two, size_t width,
    double *sum, double *sign)
{
	double product = 0, square = 0, was = *sign;
	for (size_t k = 0; k < width; k++) {
		double apart = one[k] - two[k];
		product += sum[k] * apart;
		square += apart * apart;
	}
	*sign = product - was * square > 0 ? -1 : 1;
	for (size_t k = 0; k < width && *sign != was; k++)
		sum[k] += (*sign - was) * (one[k] - two[k]);
	return *sign != was;
}

/* Keeps one draw of each pair.  The pairs choose in turn until no choice
 * changes. */
static void
choose_draw_of_each_pair(
    const double *row, size_t width, size_t *list, size_t n)
{
	enum { TURNS = 8 };
	double *sum = xcalloc_doubles(width + 1),
	       *sign = xcalloc_doubles(n / 2);
	bool changed = true;
	for (size_t turn = 0; turn < TURNS && changed; turn++) {
		changed = false;
		for (size_t i = 0; i < n / 2; i++)
			changed |=
			    choose_draw_of_pair(row + list[2 * i] * width,
				row + list[2 * i + 1] * width, width, sum,
				&sign[i]);
	}
	for (size_t i = 0; i < n / 2; i++)
		list[i] = list[sign[i] < 0 ? 2 * i + 1 : 2 * i];
	free(sign);
	free(sum);
}

/* Sorts the first and the second half of the candidates, each from the coarsest
 * to the finest, so that neighbours are alike. */
static void
sort_draw_halves_by_fineness(const double *by, size_t n, size_t *list)
{
	size_t half = n / 2;
	gsl_sort_index(list, by, 1, half);
	gsl_sort_index(list + half, by + half, 1, half);
	for (size_t i = half; i < n; i++)
		list[i] += half;
}

/* Keeps answers from falling with the speed (D23) over the few speeds used
 * here. */
static void
make_answers_rise_with_speed(struct thin *t)
{
	size_t size = t->n_sieve * t->n, length[SPEEDS];
	double value[SPEEDS], weight[SPEEDS];
	for (size_t i = 0; i < size; i++) {
		double *to = t->answer + i;
		for (size_t k = 0; k < SPEEDS; k++) {
			value[k] = to[k * size];
			weight[k] = 1;
		}
		size_t blocks =
		    ensemble_pool_falling_values(value, weight, length, SPEEDS);
		for (size_t b = 0; b < blocks; b++)
			for (size_t j = 0; j < length[b]; j++, to += size)
				*to = value[b];
	}
}

void
thin_choose_draws(struct thin *t, size_t chosen[static POSTERIOR_DRAWS])
{
	size_t n = t->n, answers = SPEEDS * t->n_sieve;
	size_t width = FEATURES * answers, *list = xcalloc(n, sizeof *list);
	double *row = xcalloc_doubles(n * width + 1), *by = xcalloc_doubles(n);
	make_answers_rise_with_speed(t);
	for (size_t k = 0; k < answers; k++)
		fill_draw_features_of_answer(
		    t->answer + k * n, n, row + k * FEATURES, width, by);
	sort_draw_halves_by_fineness(by, n, list);
	for (; n > POSTERIOR_DRAWS; n /= 2)
		choose_draw_of_each_pair(row, width, list, n);
	memcpy(chosen, list, POSTERIOR_DRAWS * sizeof *list);
	free(list);
	free(row);
	free(by);
}

/* The error assumed for the straight line between measured speeds, as a share
 * of the change between them (doc/decisions/straight-answers.md). */
static const double LINE = 0.15;

/* The largest share of straight draws.  Some draws always stay as drawn, so
 * that a band of 80 % covers both courses. */
static const double MOST = 0.75;

/* Computes the means of model [n] and answer [n] at a speed. */
static void
mean_model_and_corrected_products(
    struct ensemble *e, double v, double *model, double *answer)
{
	size_t n = ensemble_count_sieves(e);
	ensemble_set_speed_unconstrained(e, v);
	const double *M = ensemble_products(e, ENSEMBLE_MODEL);
	ensemble_mean_answer(e, answer);
	for (size_t i = 0; i < n; i++, M += POSTERIOR_DRAWS) {
		model[i] = 0;
		for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
			model[i] += M[d] / POSTERIOR_DRAWS;
	}
}

/* Returns q for a feed at sieves [n], coarsest first; 0 with fewer than two
 * speeds. */
static double
share_of_draws_linear_in_speed(const struct posterior *p,
    const struct psd *feed, const double *sieve, size_t n)
{
	double missed = 0, all = 0;
	if (n == 0 || p->n_speed < 2)
		return 0;
	struct ensemble *e = ensemble_new(p, feed, sieve, n);
	double *model = xcalloc_doubles(4 * n), *answer = model + 2 * n;
	for (size_t k = 0; k < p->n_speed; k++) {
		size_t now = k % 2 * n, last = n - now;
		mean_model_and_corrected_products(
		    e, p->speed[k], model + now, answer + now);
		for (size_t i = 0; i < n && k > 0; i++) {
			double by = answer[now + i] - answer[last + i];
			double told = model[now + i] - model[last + i];
			missed += (by - told) * (by - told);
			all += by * by;
		}
	}
	free(model);
	ensemble_free(e);
	double line = LINE * LINE * all;
	return all > 0 ? MOST * missed / (missed + line) : 0;
}

void
thin_set_linear_draw_share(const struct thin *t, struct posterior *p)
{
	p->straight =
	    share_of_draws_linear_in_speed(p, &t->feed, t->sieve, t->n_sieve);
}
