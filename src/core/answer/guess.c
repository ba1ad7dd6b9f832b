/* Sorts materials by rock and top size, takes the median of their products, and
 * finds the error of such guesses by leaving out one site at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/guess.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort_double.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "core/model/breakage.h"
#include "core/answer/predict.h"
#include "core/model/synth.h"

/* True if parameters, settings and top size are the same, as for Ubbarp and
 * Gasgruvan (D9). */
static bool
has_same_parameters(
    const struct guess_material *a, const struct guess_material *b)
{
	if (a->params.breakage != b->params.breakage)
		return false;
	for (size_t j = 0; j < breakage_model_of_params(&a->params)->n; j++)
		if (a->params.at[j] != b->params.at[j])
			return false;
	return a->top_size == b->top_size &&
	       model_settings_are_same(&a->settings, &b->settings);
}

/* Returns how far a material is from the wanted one: the difference of the
 * logarithms of their top sizes.  Materials of another rock are farther than
 * all of the same rock; within a rock, those without a top size are the
 * farthest. */
static double
distance_from_wanted_material(
    const struct guess_material *m, const struct guess_material *wanted)
{
	const double other_rock = 1000, unknown = 100;
	bool same =
	    m->rock[0] != '\0' && text_is_same_folded(m->rock, wanted->rock);
	double far = same ? 0 : other_rock;
	if (wanted->top_size > 0 && m->top_size > 0)
		far += fabs(log(m->top_size / wanted->top_size));
	else if (wanted->top_size > 0)
		far += unknown;
	return far;
}

size_t
guess_find_nearest_materials(const struct guess_material *m, size_t n,
    const struct guess_material *wanted, const bool *leave_out, size_t most,
    size_t *pick)
{
	size_t picked = 0;
	FREED bool *taken = xcalloc(n, sizeof *taken);
	FREED double *far = xcalloc_doubles(n);
	/* The same 11.2 mm may differ in the last bit. */
	const double hair = 1e-9;
	memcpy(taken, leave_out, n * sizeof *taken);
	for (size_t i = 0; i < n; i++)
		far[i] = distance_from_wanted_material(&m[i], wanted);
	while (picked < most) {
		size_t best = n;
		for (size_t i = 0; i < n; i++)
			if (!taken[i] &&
			    (best == n || far[i] < far[best] - hair))
				best = i;
		if (best == n)
			break;
		for (size_t i = 0; i < n; i++)
			taken[i] =
			    taken[i] || has_same_parameters(&m[i], &m[best]);
		pick[picked++] = best;
	}
	return picked;
}

/* Returns the value at a rank, from 1, among v [n] in rising order,
 * interpolated linearly between ranks.  Beyond the ends, returns the first or
 * last value. */
static double
interpolate_sorted_values(const double *v, size_t n, double place)
{
	double at = fmin(fmax(place - 1, 0), (double)(n - 1));
	size_t i = (size_t)at;
	double part = at - (double)i;
	return part > 0 ? v[i] * (1 - part) + v[i + 1] * part : v[i];
}

/* Sorts v, which must not contain NAN, and returns its median and 80 %
 * range. */
static struct guess_range
sort_and_compute_80_range(double *v, size_t n)
{
	double places = (double)n + 1;
	gsl_sort(v, 1, n);
	return (struct guess_range){
	    interpolate_sorted_values(v, n, 0.5 * places),
	    interpolate_sorted_values(v, n, 0.1 * places),
	    interpolate_sorted_values(v, n, 0.9 * places)};
}

/* Returns the range of a size, such as P80.  A size outside the sieves is finer
 * than all of them, as the coarsest sieves pass all of feed and product. */
static struct guess_range
range_of_size_at_passing(const struct psd *median, const struct prediction *p,
    size_t n, double passing)
{
	FREED double *v = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++) {
		v[i] = psd_size_at_passing(&p[i].curve, passing);
		v[i] = isnan(v[i]) ? -INFINITY : v[i];
	}
	struct guess_range range = sort_and_compute_80_range(v, n);
	range.middle = psd_size_at_passing(median, passing);
	range.low = isfinite(range.low) ? range.low : NAN;
	range.high = isfinite(range.high) ? range.high : NAN;
	return range;
}

static struct psd
median_curve(const struct prediction *p, size_t n)
{
	struct psd median = psd_copy(&p[0].curve);
	FREED double *v = xcalloc_doubles(n);
	for (size_t s = 0; s < median.n; s++) {
		for (size_t i = 0; i < n; i++)
			v[i] = p[i].curve.passing[s];
		median.passing[s] = sort_and_compute_80_range(v, n).middle;
	}
	return median;
}

/* Fills the guess's curves, and its break size, from n products on the same
 * sieves. */
static void
fill_guess_median_and_range(
    struct guess *guess, const struct prediction *p, size_t n)
{
	FREED double *v = xcalloc_doubles(n);
	guess->feed = psd_copy(&p[0].feed);
	guess->median = psd_copy(&p[0].product);
	guess->low = psd_copy(&p[0].product);
	guess->high = psd_copy(&p[0].product);
	for (size_t s = 0; s < guess->median.n; s++) {
		for (size_t i = 0; i < n; i++)
			v[i] = p[i].product.passing[s];
		struct guess_range range = sort_and_compute_80_range(v, n);
		guess->median.passing[s] = range.middle;
		guess->low.passing[s] = range.low;
		guess->high.passing[s] = range.high;
	}
	for (size_t i = 0; i < n; i++)
		v[i] = p[i].break_size;
	guess->size[PSD_SIZES] = sort_and_compute_80_range(v, n);
}

static struct guess
summarise_predictions_as_guess(const struct prediction *p, size_t n, double v)
{
	struct guess guess = {.speed = v};
	fill_guess_median_and_range(&guess, p, n);
	struct psd median = median_curve(p, n);
	for (size_t i = 0; i < PSD_SIZES; i++)
		guess.size[i] =
		    range_of_size_at_passing(&median, p, n, PSD_PASSING[i]);
	psd_free(&median);
	return guess;
}

/* The default beta with dust added, equal in each octave (beta1), or with
 * coarse pieces (u^2). */
static const double LAWS[GUESS_LAWS][4] = {
    {0, 0.4889, 1, 0.2445},  /* 5 % finer than a tenth */
    {0, 1, -0.3862, 0.5},    /* 10 */
    {0.0016, 1, -1, 0.5},    /* 15 */
    {0.0221, 1, -1, 0.5},    /* 24 */
    {0.063, 1, -1, 0.5},     /* 35 */
    {0.1472, 1, -1, 0.5},    /* 46 */
    {0.3728, 1, -1, 0.5},    /* 56 */
    {1, 0.02, -0.02, 0.01}}; /* 67 */

struct guess
guess_psd_from_materials(const struct site *site, size_t feed_run,
    const struct guess_material *m, const size_t *pick, size_t n, double v)
{
	size_t laws = 1, all;
	assert(n >= 1);
	for (size_t i = 0; i < n; i++)
		laws = m[pick[i]].law_open ? GUESS_LAWS : laws;
	all = n * laws;
	FREED struct prediction *p = xcalloc(all, sizeof *p);
	for (size_t i = 0; i < all; i++) {
		const struct guess_material *of = &m[pick[i / laws]];
		struct params params = of->params;
		if (of->law_open)
			memcpy(params.beta, LAWS[i % laws], sizeof params.beta);
		p[i] = predict_with_model_alone(
		    site, &params, of->settings, v, feed_run);
	}
	struct guess guess = summarise_predictions_as_guess(p, all, v);
	for (size_t i = 0; i < all; i++)
		prediction_free(&p[i]);
	return guess;
}

void
guess_free(struct guess *guess)
{
	psd_free(&guess->feed);
	psd_free(&guess->median);
	psd_free(&guess->low);
	psd_free(&guess->high);
}

/* The result of leaving out one material. */
struct trial {
	double error, feed; /* RMSE of the guess, and of product = feed */
	size_t cells, held; /* passings where the band has a width; those within
			     * it */
};

/* p [n * n]: the products of each material's synthetic feed with each
 * material's parameters, computed once for all trials. */
struct pairs {
	size_t n;
	double v;
	const struct guess_material *m;
	struct prediction *p;
};

static struct pairs
material_pairs_new(const struct guess_material *m, size_t n, double v)
{
	struct pairs pairs = {n, v, m, xcalloc(n * n, sizeof *pairs.p)};
	for (size_t i = 0; i < n; i++) {
		struct synth synth = {.top_size = m[i].top_size,
		    .params = m[i].params,
		    .n = 1,
		    .n_speed = 1,
		    .speed = &v};
		struct site *site = synth_make_site(&synth);
		for (size_t j = 0; j < n; j++)
			pairs.p[i * n + j] = predict_with_model_alone(
			    site, &m[j].params, m[j].settings, v, 0);
		site_free(site);
	}
	return pairs;
}

static void
pairs_free(struct pairs *pairs)
{
	for (size_t i = 0; i < pairs->n * pairs->n; i++)
		prediction_free(&pairs->p[i]);
	free(pairs->p);
}

static struct trial
guess_error_of_left_out_site(
    const struct pairs *pairs, const size_t *pick, size_t n, size_t truth)
{
	const struct prediction *row = &pairs->p[truth * pairs->n];
	FREED struct prediction *picked = xcalloc(n, sizeof *picked);
	struct prediction p = row[truth];
	for (size_t i = 0; i < n; i++)
		picked[i] = row[pick[i]];
	struct guess g = summarise_predictions_as_guess(picked, n, pairs->v);
	const double *P = p.product.passing;
	struct trial trial = {
	    .error = psd_rms_difference(g.median.passing, P, p.product.n, NULL),
	    .feed = psd_rms_difference(p.feed.passing, P, p.product.n, NULL)};
	for (size_t s = 0; s < p.product.n; s++) {
		if (g.high.passing[s] - g.low.passing[s] < 1e-4)
			continue;
		trial.cells++;
		trial.held +=
		    P[s] >= g.low.passing[s] && P[s] <= g.high.passing[s];
	}
	guess_free(&g);
	return trial;
}

/* Marks the materials that a guess for material i may not use.  Returns false
 * if a material with the same numbers comes before i. */
static bool
mark_materials_left_out_of_guess(
    const struct guess_material *m, size_t n, size_t i, bool *leave_out)
{
	bool first = true;
	for (size_t j = 0; j < n; j++) {
		bool same = has_same_parameters(&m[i], &m[j]);
		first = first && !(same && j < i);
		leave_out[j] =
		    same || text_is_same_folded(m[i].site, m[j].site);
	}
	return first;
}

static struct guess_error
leave_one_material_out_error(const struct pairs *pairs, size_t nearest)
{
	const struct guess_material *m = pairs->m;
	size_t n = pairs->n;
	struct guess_error out = {.worst = -1, .nearest = nearest};
	FREED bool *leave_out = xcalloc(n, sizeof *leave_out);
	FREED size_t *pick = xcalloc(nearest, sizeof *pick);
	size_t cells = 0, held = 0;
	FREED double *error = xcalloc_doubles(n), *feed = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++) {
		if (!mark_materials_left_out_of_guess(m, n, i, leave_out))
			continue;
		size_t picked = guess_find_nearest_materials(
		    m, n, &m[i], leave_out, nearest, pick);
		if (picked == 0)
			continue;
		struct trial trial =
		    guess_error_of_left_out_site(pairs, pick, picked, i);
		cells += trial.cells;
		held += trial.held;
		if (trial.error > out.worst) {
			out.worst = trial.error;
			out.worst_at = i;
		}
		feed[out.n] = trial.feed;
		error[out.n++] = trial.error;
	}
	if (out.n > 0) {
		out.median = sort_and_compute_80_range(error, out.n).middle;
		out.feed = sort_and_compute_80_range(feed, out.n).middle;
		out.held = cells > 0 ? (double)held / (double)cells : NAN;
	}
	return out;
}

struct guess_error
guess_leave_one_out_error(
    const struct guess_material *m, size_t n, size_t nearest, double v)
{
	struct pairs pairs = material_pairs_new(m, n, v);
	struct guess_error e = leave_one_material_out_error(&pairs, nearest);
	pairs_free(&pairs);
	return e;
}

struct guess_choice
guess_choose_neighbour_count(const struct guess_material *m, size_t n, double v)
{
	struct pairs pairs = material_pairs_new(m, n, v);
	struct guess_choice choice = {
	    .all = leave_one_material_out_error(&pairs, n)};
	choice.few = leave_one_material_out_error(&pairs, 1);
	for (size_t k = 2; k + 1 < n; k++) {
		struct guess_error e = leave_one_material_out_error(&pairs, k);
		choice.few = e.median < choice.few.median ? e : choice.few;
	}
	choice.helps = choice.few.median < 0.8 * choice.all.median;
	pairs_free(&pairs);
	return choice;
}
