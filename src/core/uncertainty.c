/* How well other parameters than the fitted ones go with the data, and a random
 * walk among the fits that the data allow.
 *
 * The linear picture alone, an ellipsoid about the optimum, fails here: the
 * valley of E0_min, alpha and f_mat is bent, and bounds cut it.  It serves as
 * the stride of a Metropolis walk, which takes the true misfit at each step and
 * so follows the bend.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/uncertainty.h"

#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_statistics_double.h>

#include "base/xalloc.h"
#include "core/elementary.h"
#include "core/product.h"
#include "core/rng.h"
#include "core/sensitivity.h"

/* The noise of the data as a fit's differences show it, and what it leaves
 * open.
 *
 * A passing is a share of a sample, so the variance of its noise is taken to go
 * with P (1 - P), or to be as the sheet states where it weighs the sieves; its
 * size comes from the misfit,
 *   a^2 = 1.6 misfit / sum of h (1 - leverage),  h = 4 P (1 - P) weight^2
 * and no sieve is trusted to less than 0.1 point, also where made-up data are
 * perfect.  The fit counts all sieves alike, so its own noise is
 *   G = U' diag(a^2 h) U
 * in the directions U in which the parameters move the differences; across them
 * the variance is s^2, the mean of G's. */
struct plausible {
	struct misfit *misfit;
	const struct bounds *bounds;
	const double *basis; /* U, [n_residual * PARAMS_MOST] */
	double *own, *now;   /* differences of the fit and of another */
	double variance;     /* s^2 */
	double weight[PARAMS_MOST][PARAMS_MOST]; /* G^-1 */
	double directions;                       /* D */
	double least;                            /* misfit of the fit */
	double freedom;                          /* nu */
	size_t n, size; /* parameters that move; the model's n */
};

static double
leverage(const double *row)
{
	double sum = 0;
	for (size_t c = 0; c < PARAMS_MOST; c++)
		sum += row[c] * row[c];
	return sum;
}

/* Variance of each weighted difference's noise, [n_residual], and how many
 * equal ones would tell its size as well (Satterthwaite).  choice: the search
 * takes the best of several valleys, which swallows more of the noise than the
 * parameters of one valley do; found by counting on made-up sites, where bands
 * without it held 73 % instead of 80 %. */
static void
find_noise(struct plausible *f, double *noise)
{
	const double least = 0.001, choice = 1.6;
	const struct misfit *m = f->misfit;
	double left = 0, squares = 0;
	for (size_t r = 0, k = 0; r < m->n_run; r++)
		for (size_t i = 0; i < m->run[r].n; i++, k++) {
			double P = m->run[r].measured[i];
			double w = m->run[r].weight[i];
			noise[k] = m->run[r].by_sd ? m->run[r].run_weight
						   : 4 * w * w * P * (1 - P);
			double part =
			    noise[k] *
			    (1 - leverage(f->basis + k * PARAMS_MOST));
			left += part;
			squares += part * part;
		}
	double scale = left > 0 ? choice * f->least / left : 0;
	f->freedom = squares > 0 ? fmax(left * left / squares, 1) : 1;
	for (size_t r = 0, k = 0; r < m->n_run; r++)
		for (size_t i = 0; i < m->run[r].n; i++, k++) {
			double floor = least * m->run[r].weight[i];
			noise[k] = fmax(scale * noise[k], floor * floor);
		}
}

/* The inverse of G, and s^2. A direction that moves nothing has a row of 0,
 * where any weight will do. */
static void
weigh_directions(struct plausible *f, const double *noise)
{
	gsl_matrix *G = gsl_matrix_calloc(f->size, f->size);
	double trace = 0, rank = 0, sum = 0;
	for (size_t k = 0; k < f->misfit->n_residual; k++) {
		const double *u = f->basis + k * PARAMS_MOST;
		sum += noise[k];
		for (size_t a = 0; a < f->size; a++)
			for (size_t b = 0; b < f->size; b++)
				*gsl_matrix_ptr(G, a, b) +=
				    u[a] * noise[k] * u[b];
		trace += leverage(u) * noise[k];
		rank += leverage(u);
	}
	f->variance =
	    rank > 0 ? trace / rank : sum / (double)f->misfit->n_residual;
	for (size_t a = 0; a < f->size; a++)
		if (!(gsl_matrix_get(G, a, a) > 0))
			gsl_matrix_set(G, a, a, f->variance);
	gsl_linalg_cholesky_decomp1(G);
	gsl_linalg_cholesky_invert(G);
	for (size_t a = 0; a < f->size; a++)
		for (size_t b = 0; b < f->size; b++)
			f->weight[a][b] = gsl_matrix_get(G, a, b);
	gsl_matrix_free(G);
}

/* m and bounds must outlive it.  p: the fit, at its optimum. */
static struct plausible *
plausible_new(struct misfit *m, const struct params *p,
    const struct bounds *bounds, const struct sensitivity *s,
    const double *basis)
{
	struct plausible *f = xcalloc(1, sizeof *f);
	*f = (struct plausible){.misfit = m,
	    .bounds = bounds,
	    .basis = basis,
	    .own = xdoubles(m->n_residual),
	    .now = xdoubles(m->n_residual),
	    .directions = m->of->gauge > 0,
	    .size = m->of->n,
	    .n = s->n};
	f->least = misfit_differences(m, p, f->own);
	find_noise(f, f->now);
	weigh_directions(f, f->now);
	for (size_t c = 0; c < s->n; c++)
		f->directions += s->column[c] < m->of->gauge;
	return f;
}

static void
plausible_free(struct plausible *f)
{
	free(f->own);
	free(f->now);
	free(f);
}

/* s, in units of the weighted differences. */
static double
plausible_deviation(const struct plausible *f)
{
	return sqrt(f->variance);
}

/* Whether the gauge, whose scale is free, can be scaled into its bounds. */
static bool
gauge_fits(const struct bounds *b, const struct params *p)
{
	const double slack = 1e-9;
	double least = 0, most = INFINITY;
	for (size_t j = 0; j < breakage_of(p)->gauge; j++) {
		double x = p->at[j];
		double lower = b->lower[j] / fabs(x);
		double upper = b->upper[j] / fabs(x);
		if (x == 0) {
			if (b->lower[j] > 0 || b->upper[j] < 0)
				return false;
			continue;
		}
		least = fmax(least, x > 0 ? lower : -upper);
		most = fmin(most, x > 0 ? upper : -lower);
	}
	return most > 0 && least <= most * (1 + slack);
}

static bool
is_within(const struct bounds *b, const struct params *p)
{
	for (size_t j = breakage_of(p)->gauge; j < breakage_of(p)->n; j++) {
		double x = p->at[j];
		if (x < b->lower[j] || x > b->upper[j])
			return false;
	}
	return gauge_fits(b, p);
}

/* -ln of the probability of p, but for a constant; Student's, as the size of
 * the noise is itself known from nu differences or so only:
 *   (nu + n)/2 ln(1 + T / nu) + D/2 ln |gauge|^2
 *   T = (misfit - that of the fit - |e|^2) / s^2 + e' G^-1 e
 * where e = U' (differences at p - those of the fit); INFINITY outside the
 * bounds.  The last term makes all directions of beta alike (D4); D is the
 * number of its free ones and the one that is held, n of the parameters that
 * move. */
static double
plausible_level(struct plausible *f, const struct params *p)
{
	if (!is_within(f->bounds, p))
		return INFINITY;
	double squares = 0, along = 0, weighted = 0, e[PARAMS_MOST] = {0};
	double misfit = misfit_differences(f->misfit, p, f->now);
	if (!isfinite(misfit))
		return INFINITY;
	for (size_t k = 0; k < f->misfit->n_residual; k++)
		for (size_t c = 0; c < PARAMS_MOST; c++)
			e[c] += f->basis[k * PARAMS_MOST + c] *
				(f->now[k] - f->own[k]);
	for (size_t a = 0; a < f->size; a++) {
		along += e[a] * e[a];
		for (size_t b = 0; b < f->size; b++)
			weighted += e[a] * f->weight[a][b] * e[b];
	}
	for (size_t j = 0; j < f->misfit->of->gauge; j++)
		squares += p->at[j] * p->at[j];
	/* Seen from the plane in which the largest of the gauge is held,
	 * directions far out are rarer than on a sphere. */
	double far = squares > 0 ? f->directions / 2 * el_log(squares) : 0;
	double T = (misfit - f->least - along) / f->variance + weighted;
	double power = (f->freedom + (double)f->n) / 2;
	return power * el_log(1 + fmax(T, 0) / f->freedom) + far;
}

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
