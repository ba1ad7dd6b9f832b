/* A random walk among the fits that the data allow.
 *
 * The linear picture alone, an ellipsoid about the optimum, fails here: the
 * valley of E0_min, alpha and f_mat is bent, and bounds cut it.  It serves as
 * the stride of a Metropolis walk, which takes the true misfit at each step and
 * so follows the bend.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/uncertainty.h"

#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_statistics_double.h>

#include "base/xalloc.h"
#include "core/elementary.h"
#include "core/plausible.h"
#include "core/product.h"
#include "core/rng.h"
#include "core/sensitivity.h"

enum {
	WARM_UP = 2000,  /* steps before the first draw */
	APART = 40,      /* steps from draw to draw */
	TUNE_EVERY = 50, /* steps of the warm-up from one stride to the next */
	USE_WALK = 1 << 21
};

struct walk {
	struct sensitivity sensitivity;
	struct plausible *plausible;
	double stride;
	struct params at;
	double level; /* plausible_level there */
	const struct misfit *misfit;
	bool stopped;
};

/* One step: a stride along all directions of the sensitivity, each as long as
 * the data allow, but not beyond half a range.  Returns whether it was
 * taken. */
static bool
step(struct walk *w, struct rng_key key)
{
	const struct sensitivity *s = &w->sensitivity;
	struct params p = w->at;
	w->stopped = w->stopped || misfit_stopped(w->misfit);
	if (w->stopped)
		return false;
	for (size_t i = 0; i < s->n; i++) {
		double z = w->stride * rng_normal(key, (uint32_t)i);
		double length = fmin(plausible_deviation(w->plausible) /
					 fmax(s->sigma[i], 1e-12),
		    0.5);
		for (size_t c = 0; c < s->n; c++) {
			size_t j = s->column[c];
			double move = z * length * s->direction[i][c];
			p.at[j] += move * s->range[j];
		}
	}
	double level = plausible_level(w->plausible, &p);
	double chance = rng_uniform(key, (uint32_t)(12 * breakage_of(&p)->n));
	if (!(el_log(chance) < w->level - level))
		return false;
	w->at = p;
	w->level = level;
	return true;
}

/* Walks on, and makes the stride such that one step in three is taken. */
static void
warm_up(struct walk *w, uint64_t seed)
{
	int taken = 0;
	w->stride = 2.4 / sqrt((double)w->sensitivity.n);
	for (uint64_t i = 0; i < WARM_UP; i++) {
		taken += step(w, rng_key(seed, i, USE_WALK));
		if ((i + 1) % TUNE_EVERY != 0)
			continue;
		if (taken < TUNE_EVERY / 4)
			w->stride *= 0.7;
		else if (taken > TUNE_EVERY / 2)
			w->stride *= 1.4;
		taken = 0;
	}
}

/* The middle 80 % of the values [UNCERTAINTY_DRAWS], whose order changes,
 * widened to hold the fit's own. */
static void
middle(double *value, double own, double *low, double *high)
{
	enum { CUT = UNCERTAINTY_DRAWS * (100 - UNCERTAINTY_LEVEL) / 200 };
	size_t n = UNCERTAINTY_DRAWS;
	*low = fmin(gsl_stats_select(value, 1, n, CUT), own);
	*high = fmax(gsl_stats_select(value, 1, n, n - 1 - CUT), own);
}

static void
draw_all(struct walk *w, uint64_t seed, struct params *draw)
{
	uint64_t number = WARM_UP;
	if (w->sensitivity.n > 0)
		warm_up(w, seed);
	for (size_t i = 0; i < UNCERTAINTY_DRAWS; i++) {
		for (int k = 0; w->sensitivity.n > 0 && k < APART; k++)
			step(w, rng_key(seed, number++, USE_WALK));
		draw[i] = w->at;
		params_scale(&draw[i]);
	}
}

struct uncertainty *
uncertainty_new(struct misfit *m, const struct params *p,
    const struct bounds *bounds, uint64_t seed)
{
	struct uncertainty *u = xcalloc(1, sizeof *u);
	double value[UNCERTAINTY_DRAWS];
	double *basis = xdoubles(m->n_residual * PARAMS_MOST);
	struct params own = *p;
	params_scale(&own);
	struct walk w = {.at = own, .misfit = m};
	w.sensitivity = sensitivity_of(m, &own, bounds, true, basis);
	w.plausible = plausible_new(m, &own, bounds, &w.sensitivity, basis);
	w.level = plausible_level(w.plausible, &own);
	draw_all(&w, seed, u->draw);
	u->deviation = plausible_deviation(w.plausible);
	for (size_t j = 0; j < m->of->n; j++) {
		for (size_t i = 0; i < UNCERTAINTY_DRAWS; i++)
			value[i] = u->draw[i].at[j];
		middle(value, own.at[j], &u->low[j], &u->high[j]);
	}
	plausible_free(w.plausible);
	free(basis);
	if (!w.stopped)
		return u;
	free(u);
	return NULL;
}

enum { BREAK = PSD_SIZES, SIZES };

/* As values to sort: what lies below the finest sieve is the least. */
static void
sizes_of(const struct params *p, const struct psd *product, double v,
    double size[SIZES])
{
	for (size_t i = 0; i < PSD_SIZES; i++) {
		double x = psd_size(product, PSD_PASSING[i]);
		size[i] = isfinite(x) ? x : 0;
	}
	size[BREAK] = params_break_size(p, v);
}

struct band
uncertainty_band(const struct uncertainty *u, const struct params *p,
    const struct psd *feed, const struct psd *product,
    struct model_settings settings, double v)
{
	enum { N = UNCERTAINTY_DRAWS };
	size_t n = product->n;
	struct band band = {.n = n, .low = xdoubles(n), .high = xdoubles(n)};
	double *value = xdoubles((n + SIZES) * N), own[SIZES];
	struct psd one = psd_copy(product);
	struct model *model = model_new(feed, product->size, n, settings);
	for (size_t i = 0; i < N; i++) {
		double size[SIZES];
		model_set(model, &u->draw[i]);
		model_product(model, v, one.passing);
		sizes_of(&u->draw[i], &one, v, size);
		for (size_t j = 0; j < n; j++)
			value[j * N + i] = one.passing[j];
		for (size_t j = 0; j < SIZES; j++)
			value[(n + j) * N + i] = size[j];
	}
	for (size_t j = 0; j < n; j++)
		middle(value + j * N, product->passing[j], &band.low[j],
		    &band.high[j]);
	sizes_of(p, product, v, own);
	for (size_t j = 0; j < SIZES; j++) {
		double *range = band.size[j];
		middle(value + (n + j) * N, own[j], &range[0], &range[1]);
		for (size_t k = 0; k < 2 && j != BREAK; k++)
			if (range[k] == 0)
				range[k] = NAN;
	}
	model_free(model);
	psd_free(&one);
	free(value);
	return band;
}

void
band_free(struct band *band)
{
	free(band->low);
	free(band->high);
}
