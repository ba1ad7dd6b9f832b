/* Products of all draws by the search's kernel, corrected by its error at the
 * fit, with the discrepancy added and passings kept from falling with the speed
 * by pooling neighbours.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/ensemble.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "base/xalloc.h"
#include "core/model/breakage.h"
#include "core/numeric/elementary.h"
#include "core/search/kernel.h"
#include "core/model/product.h"
#include "core/model/selection.h"

/* Columns 0 to DRAWS - 1 hold the draws; those from FIT on hold the fit, whose
 * exact product minus its product by the search's scheme is the error of this
 * scheme. */
enum {
	DRAWS = POSTERIOR_DRAWS,
	FIT = DRAWS,
	ALL = FIT + KERNEL_LANES,
	EVEN = 24,
	BEYOND = 80,
	SLOWEST = BEYOND, /* index of the first speed pooled */
	RISING = BEYOND + EVEN + 1 + POSTERIOR_RUNS + BEYOND
};

/* In isotonic regression a measured speed has the weight of this many
 * others. */
static const double HELD = 1000;

struct ensemble {
	const struct posterior *of;
	size_t n;
	struct kernel *kernel;
	struct model *exact;
	double *theta[PARAMS_MOST];            /* [ALL] */
	double softer[ALL], share_softer[ALL]; /* see struct kernel_out */
	double *product, *misfit; /* [n * ALL], [ALL], by the scheme */
	double *fit, *feed;       /* [n] */
	size_t *knot;             /* [n]: the size lies between this knot and
				   * the next */
	double *share;            /* this knot's weight */
	double *delta;            /* at the knots, [n_knot * DRAWS] */
	/* [n + 1][DRAWS]: nothing passes below the finest size. */
	double *part[ENSEMBLE_PARTS];
	bool sampled; /* the samples are made */
	double at;    /* the speed last set by ensemble_set_speed, or 0 */
	/* The speeds of a grid, m/s.  Those with index SLOWEST to `last` are
	 * pooled.  counts: the weight of each; measured: the indices of the
	 * measured speeds. */
	double speed[RISING], counts[RISING];
	size_t last, measured[POSTERIOR_RUNS];
	/* rising: the answers at the speeds of the grid, pooled so that they do
	 * not fall from one speed to the next; moved: whether pooling changed
	 * them.  Each is [n * DRAWS], or NULL outside the speeds slowest to
	 * fastest. */
	double *rising[RISING];
	bool *moved[RISING];
	size_t slowest, fastest;
	double more, bypass; /* k and bypass of another machine */
};

/* Returns the same curve with points added at sizes [n], coarsest first, and
 * between them, because the kernel's classes end at the points of a feed. */
static struct psd
add_sizes_to_feed(const struct psd *feed, const double *size, size_t n)
{
	struct psd fine = psd_new_with_sizes_between(size, n);
	struct psd curve = psd_new(feed->n + fine.n);
	memcpy(curve.size, feed->size, feed->n * sizeof *feed->size);
	memcpy(curve.size + feed->n, fine.size, fine.n * sizeof *fine.size);
	curve.n = psd_sort_distinct_sizes(curve.size, curve.n, 0);
	for (size_t i = 0; i < curve.n; i++)
		curve.passing[i] = psd_passing(feed, curve.size[i]);
	psd_free(&fine);
	return curve;
}

/* Makes a kernel whose differences are passings: the measured passings that it
 * subtracts are 0. */
static struct kernel *
new_passings_kernel(const struct posterior *p, const struct psd *smooth,
    const double *size, size_t n)
{
	struct psd feed = add_sizes_to_feed(smooth, size, n);
	double *sieve = xcalloc_doubles(n), *none = xcalloc_doubles(n),
	       *one = xcalloc_doubles(n);
	memcpy(sieve, size, n * sizeof *size);
	for (size_t i = 0; i < n; i++)
		one[i] = 1;
	struct misfit_run run = {.speed = 1,
	    .feed = feed,
	    .n = n,
	    .sieve = sieve,
	    .measured = none,
	    .weight = one};
	struct misfit m = {.of = BREAKAGES[p->settings.breakage],
	    .settings = p->settings,
	    .n_run = 1,
	    .n_residual = n,
	    .run = &run};
	struct kernel *kernel = kernel_new(&m, ISA_BEST, 1);
	psd_free(&feed);
	free(sieve);
	free(none);
	free(one);
	return kernel;
}

static void
find_knots_of_sieves(struct ensemble *e, const double *size)
{
	const struct posterior *p = e->of;
	e->knot = xcalloc(e->n, sizeof *e->knot);
	e->share = xcalloc_doubles(e->n);
	for (size_t i = 0; i < e->n; i++) {
		double at = el_log(size[i]);
		size_t k = 0;
		while (k + 2 < p->n_knot && p->knot[k + 1] > at)
			k++;
		double share =
		    (at - p->knot[k + 1]) / (p->knot[k] - p->knot[k + 1]);
		e->knot[i] = k;
		e->share[i] = fmin(fmax(share, 0), 1);
	}
}

static void
set_params_of_draw(struct ensemble *e, size_t column, const struct params *p,
    const struct strengths *rock)
{
	size_t f = breakage_model_of_params(p)->strength;
	for (size_t j = 0; j < breakage_model_of_params(p)->n; j++)
		e->theta[j][column] = p->at[j];
	e->theta[f][column] *= e->more;
	e->theta[f + 1][column] *= rock->harder;
	e->softer[column] = p->at[f + 1] * rock->softer;
	e->share_softer[column] = strengths_softer_share(rock);
}

static void
set_params_of_all_draws(struct ensemble *e)
{
	const struct posterior *p = e->of;
	for (size_t i = FIT; i < ALL; i++)
		set_params_of_draw(e, i, &p->fit, &(struct strengths){0, 1, 1});
	for (size_t d = 0; d < DRAWS; d++)
		set_params_of_draw(
		    e, d, &p->draw[d].params, &p->draw[d].strengths);
}

/* In most fits gamma and kappa are 0.  Then the product is that of the paper's
 * model, which takes a fraction of the time. */
static void
use_smallest_equivalent_model(struct ensemble *e, struct params fit)
{
	struct params p = breakage_params_in_narrower_model(&fit);
	model_set_params(e->exact, &p);
}

/* Chooses the speeds of the grid: evenly spaced in the range that is pooled,
 * together with the measured speeds, and 2 % apart beyond this range, down to a
 * fifth of the slowest and up to five times the fastest. */
static void
make_speed_grid(struct ensemble *e)
{
	const struct posterior *p = e->of;
	const double apart = 0.02;
	size_t at = SLOWEST, even = 0, held = 0;
	while (even <= EVEN || held < p->n_speed) {
		double next = p->from + (p->to - p->from) * (double)even / EVEN;
		bool measured = held < p->n_speed &&
				(even > EVEN || p->speed[held] <= next);
		if (measured)
			e->measured[held] = at;
		even += !measured || p->speed[held] == next;
		e->speed[at] = measured ? p->speed[held++] : next;
		e->counts[at++] = measured ? HELD : 1;
	}
	e->last = at - 1;
	for (size_t k = 1; k <= BEYOND; k++) {
		double far = el_exp(apart * (double)k);
		e->speed[SLOWEST - k] = e->speed[SLOWEST] / far;
		e->speed[e->last + k] = e->speed[e->last] * far;
	}
}

struct ensemble *
ensemble_new(const struct posterior *p, const struct psd *measured,
    const double *size, size_t n)
{
	struct psd curve = psd_add_points_on_cubic(measured), *feed = &curve;
	struct ensemble *e = xcalloc(1, sizeof *e);
	*e = (struct ensemble){.of = p,
	    .n = n,
	    .kernel = new_passings_kernel(p, feed, size, n),
	    .exact = model_new(feed, size, n, p->settings),
	    .product = xcalloc_doubles(n * ALL),
	    .misfit = xcalloc_doubles(ALL),
	    .fit = xcalloc_doubles(n),
	    .feed = xcalloc_doubles(n),
	    .delta = xcalloc_doubles(p->n_knot * DRAWS),
	    .more = 1};
	use_smallest_equivalent_model(e, p->fit);
	for (size_t j = 0; j < breakage_model_of_params(&p->fit)->n; j++)
		e->theta[j] = xcalloc_doubles(ALL);
	set_params_of_all_draws(e);
	for (size_t i = 0; i < n; i++)
		e->feed[i] = psd_passing(feed, size[i]);
	for (size_t i = 0; i < ENSEMBLE_PARTS; i++)
		e->part[i] = xcalloc_doubles((n + 1) * DRAWS);
	find_knots_of_sieves(e, size);
	make_speed_grid(e);
	psd_free(&curve);
	return e;
}

static void
free_grid_of_rising_answers(struct ensemble *e)
{
	for (size_t k = 0; k < RISING; k++) {
		free(e->rising[k]);
		free(e->moved[k]);
		e->rising[k] = NULL;
		e->moved[k] = NULL;
	}
}

void
ensemble_set_machine_settings(
    struct ensemble *e, struct model_settings settings)
{
	const struct params *fit = &e->of->fit;
	size_t strength = breakage_model_of_params(fit)->strength;
	e->more = settings.k / e->of->settings.k;
	struct params p = *fit;
	p.at[strength] *= e->more;
	use_smallest_equivalent_model(e, p);
	set_params_of_all_draws(e);
	e->bypass = settings.bypass;
	e->at = 0;
	free_grid_of_rising_answers(e);
}

void
ensemble_free(struct ensemble *e)
{
	if (e == NULL)
		return;
	for (size_t j = 0; j < PARAMS_MOST; j++)
		free(e->theta[j]);
	for (size_t i = 0; i < ENSEMBLE_PARTS; i++)
		free(e->part[i]);
	kernel_free(e->kernel);
	model_free(e->exact);
	free(e->product);
	free(e->misfit);
	free(e->fit);
	free(e->feed);
	free(e->knot);
	free(e->share);
	free(e->delta);
	free_grid_of_rising_answers(e);
	free(e);
}

size_t
ensemble_count_sieves(const struct ensemble *e)
{
	return e->n;
}

/* Below this share of the slowest measured speed, the correction of a draw no
 * longer follows its trend, but shrinks in proportion to the selection of the
 * coarsest size in the draw's own model.  Where nothing breaks no correction is
 * needed, and no measurement supports its trend so far away. */
static const double SLOW = 0.875;

/* Returns a draw's S of the coarsest size at speed v.  Its rock may have two
 * strengths. */
static double
broken_share_of_coarsest_size(
    const struct posterior *p, const struct posterior_draw *draw, double v)
{
	const struct strengths *rock = &draw->strengths;
	const struct impacts *by = &p->settings.impacts;
	const double *f =
	    draw->params.at + breakage_model_of_params(&draw->params)->strength;
	double harder[] = {f[0], rock->harder * f[1], f[2]};
	double softer[] = {f[0], rock->softer * f[1], f[2]};
	double k = p->settings.k, E = specific_energy_at_speed(v),
	       size = p->knot[0];
	double share = strengths_softer_share(rock),
	       S = selection_share_by_impacts(by, harder, k, E, size, NULL);
	if (share > 0)
		S += share *
		     (selection_share_by_impacts(by, softer, k, E, size, NULL) -
			 S);
	return S;
}

/* Computes left [DRAWS], the share of each draw's correction that remains at
 * speed v, 0..1.  Returns the speed at which to compute the correction. */
static double
compute_correction_share_left(const struct posterior *p, double v, double *left)
{
	double at = fmax(v, SLOW * p->speed[0]);
	for (size_t d = 0; d < DRAWS; d++) {
		left[d] = 1;
		if (v == at)
			continue;
		double there =
		    broken_share_of_coarsest_size(p, &p->draw[d], at);
		left[d] = there > 0 ? broken_share_of_coarsest_size(
					  p, &p->draw[d], v) /
					  there
				    : 0;
	}
	return at;
}

/* Returns the lack of fit (lack_of_fit.h) at a knot and tip speed v, m/s:
 * linear in v^2 between measured speeds, constant beyond them; 0 if it has not
 * been computed. */
static double
lack_of_fit_at_knot(const struct posterior *p, double v, size_t knot)
{
	if (p->lack == NULL)
		return 0;
	size_t k = 0;
	while (k + 2 < p->n_speed && v > p->speed[k + 1])
		k++;
	double a = p->speed[k], b = p->speed[k + 1];
	double t = (v * v - a * a) / (b * b - a * a);
	t = fmin(fmax(t, 0), 1);
	const double *at = p->lack + k * p->n_knot + knot;
	return (1 - t) * at[0] + t * at[p->n_knot];
}

static void
fill_discrepancy_at_knots(struct ensemble *e, double v)
{
	const struct posterior *p = e->of;
	double left[DRAWS], at = compute_correction_share_left(p, v, left);
	double t = discrepancy_speed_to_coordinate(at, p->middle);
	double factor[DISCREPANCY_TERMS][DRAWS];
	for (size_t d = 0; d < DRAWS; d++) {
		double term[DISCREPANCY_TERMS];
		discrepancy_speed_terms(t, p->draw[d].hyper[HYPER_SLOPE], term);
		for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
			factor[j][d] = left[d] * term[j];
	}
	for (size_t i = 0; i < p->n_knot * DRAWS; i += DRAWS) {
		double lack = lack_of_fit_at_knot(p, at, i / DRAWS);
		for (size_t d = 0; d < DRAWS; d++) {
			double sum = left[d] * lack;
			for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
				sum += factor[j][d] * p->term[j][i + d];
			e->delta[i + d] = sum;
		}
	}
}

void
ensemble_discrepancy_of_draw(const struct ensemble *e, size_t d, double *delta)
{
	for (size_t i = 0; i < e->n; i++) {
		const double *at = e->delta + e->knot[i] * DRAWS + d;
		delta[i] = e->share[i] * at[0] + (1 - e->share[i]) * at[DRAWS];
	}
}

/* Fills row i of model and answer.  The row of the next finer size must
 * exist. */
static void
fill_passing_draws_at_sieve(const struct ensemble *e, size_t i,
    double *restrict model, double *restrict answer)
{
	const double *P = e->product + i * ALL;
	const double *delta = e->delta + e->knot[i] * DRAWS;
	double share = e->share[i], rest = 1 - share;
	double fit = e->fit[i], scheme = P[FIT], feed = e->feed[i];
	for (size_t d = 0; d < DRAWS; d++) {
		double p = discrepancy_clamp_passing(P[d] + fit - scheme, feed);
		double more = share * delta[d] + rest * delta[d + DRAWS];
		double finer = answer[d + DRAWS];
		model[d] = p;
		answer[d] = discrepancy_corrected_passing(
		    p, more, finer > feed ? finer : feed);
	}
}

/* As fill_passing_draws_at_sieve, for row i of the samples. */
static void
fill_sample_draws_at_sieve(
    const struct ensemble *e, size_t i, double *restrict sample)
{
	const double *answer = e->part[ENSEMBLE_ANSWER] + i * DRAWS;
	const double *error = e->of->error + e->knot[i] * DRAWS;
	double share = e->share[i], rest = 1 - share;
	for (size_t d = 0; d < DRAWS; d++) {
		double err = share * error[d] + rest * error[d + DRAWS];
		sample[d] = discrepancy_clamp_passing(
		    answer[d] + discrepancy_scale_at_passing(answer[d]) * err,
		    sample[d + DRAWS]);
	}
}

/* Makes the samples, only on request because few callers need them. */
static void
simulate_new_belt_cuts(struct ensemble *e)
{
	if (e->sampled)
		return;
	for (size_t i = e->n; i-- > 0;)
		fill_sample_draws_at_sieve(
		    e, i, e->part[ENSEMBLE_SAMPLE] + i * DRAWS);
	e->sampled = true;
}

static void
ensemble_add_bypass(struct ensemble *e)
{
	for (size_t k = 0; k < ENSEMBLE_PARTS; k++)
		for (size_t i = 0; i < e->n * DRAWS; i++) {
			double *P = &e->part[k][i];
			*P += e->bypass * (e->feed[i / DRAWS] - *P);
		}
}

void
ensemble_set_speed_unconstrained(struct ensemble *e, double v)
{
	struct kernel_out out = {
	    e->misfit, e->product, ALL, e->softer, e->share_softer};
	e->at = 0;
	kernel_set_speed(e->kernel, v);
	const double *const *theta = (const double *const *)e->theta;
	kernel_evaluate_candidates(e->kernel, theta, 0, ALL, 0, &out);
	model_compute_product(e->exact, v, e->fit);
	fill_discrepancy_at_knots(e, v);
	for (size_t i = e->n; i-- > 0;)
		fill_passing_draws_at_sieve(e, i,
		    e->part[ENSEMBLE_MODEL] + i * DRAWS,
		    e->part[ENSEMBLE_ANSWER] + i * DRAWS);
	e->sampled = false;
}

/* Returns the index of the last computed grid speed not above v, but never the
 * fastest; if all are above v, the slowest. */
static size_t
grid_index_below_speed(const struct ensemble *e, double v)
{
	size_t low = e->slowest, high = e->fastest;
	while (low + 1 < high) {
		size_t middle = (low + high) / 2;
		*(e->speed[middle] <= v ? &low : &high) = middle;
	}
	return low;
}

size_t
ensemble_pool_falling_values(
    double *value, double *weight, size_t *length, size_t n)
{
	size_t blocks = 0;
	for (size_t k = 0; k < n; k++) {
		value[blocks] = value[k];
		weight[blocks] = weight[k];
		length[blocks++] = 1;
		for (; blocks > 1 && value[blocks - 2] > value[blocks - 1];
		     blocks--) {
			double *last = value + blocks - 2,
			       *w = weight + blocks - 2;
			last[0] =
			    (w[0] * last[0] + w[1] * last[1]) / (w[0] + w[1]);
			w[0] += w[1];
			length[blocks - 2] += length[blocks - 1];
		}
	}
	return blocks;
}

/* Replaces the values i at the pooled speeds with the nearest ones that do not
 * fall. */
static void
pool_adjacent_violators(struct ensemble *e, size_t i)
{
	double mean[RISING], weight[RISING];
	size_t length[RISING], k = SLOWEST, all = e->last - SLOWEST + 1;
	for (size_t j = 0; j < all; j++) {
		mean[j] = e->rising[SLOWEST + j][i];
		weight[j] = e->counts[SLOWEST + j];
	}
	size_t n = ensemble_pool_falling_values(mean, weight, length, all);
	for (size_t block = 0; block < n; block++)
		for (size_t j = 0; j < length[block]; j++, k++) {
			e->rising[k][i] = mean[block];
			e->moved[k][i] = length[block] > 1;
		}
}

static void
compute_answers_at_grid_speed(struct ensemble *e, size_t k)
{
	size_t size = e->n * DRAWS;
	ensemble_set_speed_unconstrained(e, e->speed[k]);
	e->rising[k] = xcalloc_doubles(size);
	e->moved[k] = xcalloc(size, sizeof **e->moved);
	memcpy(e->rising[k], e->part[ENSEMBLE_ANSWER], size * sizeof(double));
}

static void
compute_draws_rising_with_speed(struct ensemble *e)
{
	for (size_t k = SLOWEST; k <= e->last; k++)
		compute_answers_at_grid_speed(e, k);
	for (size_t i = 0; i < e->n * DRAWS; i++)
		pool_adjacent_violators(e, i);
	e->slowest = SLOWEST;
	e->fastest = e->last;
}

/* Extends the grid to a speed beyond those that are pooled.  The answers
 * already there do not change: those at each added speed are limited by its
 * neighbour's. */
static void
extend_grid_of_rising_answers(struct ensemble *e, double v)
{
	while (e->slowest > 0 && v < e->speed[e->slowest]) {
		size_t k = --e->slowest;
		compute_answers_at_grid_speed(e, k);
		for (size_t i = 0; i < e->n * DRAWS; i++) {
			double above = e->rising[k + 1][i];
			e->moved[k][i] = e->rising[k][i] > above;
			e->rising[k][i] = fmin(e->rising[k][i], above);
		}
	}
	while (e->fastest + 1 < RISING && v > e->speed[e->fastest]) {
		size_t k = ++e->fastest;
		compute_answers_at_grid_speed(e, k);
		for (size_t i = 0; i < e->n * DRAWS; i++) {
			double below = e->rising[k - 1][i];
			e->moved[k][i] = e->rising[k][i] < below;
			e->rising[k][i] = fmax(e->rising[k][i], below);
		}
	}
}

/* A higher speed never gives a coarser product (D23): no passing of a draw
 * falls with the speed.  At the speeds of the grid, the passings are the
 * nearest that do not fall.  Between two of these speeds, a passing is
 * interpolated linearly if pooling changed it at either; otherwise it is as
 * drawn. */
static void
force_answers_to_rise_with_speed(struct ensemble *e, double v)
{
	size_t k = grid_index_below_speed(e, v);
	const double *below = e->rising[k], *above = e->rising[k + 1];
	double from = e->speed[k], to = e->speed[k + 1];
	double *answer = e->part[ENSEMBLE_ANSWER], t = (v - from) / (to - from);
	for (size_t i = 0; i < e->n * DRAWS; i++) {
		if (v < from)
			answer[i] = fmin(answer[i], below[i]);
		else if (v > to)
			answer[i] = fmax(answer[i], above[i]);
		else if (e->moved[k][i] || e->moved[k + 1][i])
			answer[i] = below[i] + t * (above[i] - below[i]);
		else
			answer[i] = fmin(fmax(answer[i], below[i]), above[i]);
	}
}

/* Computes the answers as drawn, but so that none falls with the speed. */
static void
compute_rising_answers_at_speed(struct ensemble *e, double v)
{
	if (e->rising[SLOWEST] == NULL)
		compute_draws_rising_with_speed(e);
	extend_grid_of_rising_answers(e, v);
	ensemble_set_speed_unconstrained(e, v);
	force_answers_to_rise_with_speed(e, v);
}

/* True if v lies between two measured speeds, with indices *k and *k + 1. */
static bool
is_between_measured_speeds(const struct posterior *p, double v, size_t *k)
{
	for (*k = 0; *k + 1 < p->n_speed; ++*k)
		if (v > p->speed[*k] && v < p->speed[*k + 1])
			return true;
	return false;
}

/* True if a draw is straight between measured speeds.  Neighbouring draws may
 * resemble each other, so the straight ones are spread over all of them. */
static bool
is_posterior_draw_linear_in_speed(const struct posterior *p, size_t draw)
{
	size_t place = draw * 97 % DRAWS;
	return (double)place + 0.5 < p->straight * DRAWS;
}

/* Computes the answers at a speed between two measured ones (D25, thin.h). */
static void
compute_answers_between_speeds(struct ensemble *e, double v, size_t k)
{
	const struct posterior *p = e->of;
	double a = p->speed[k], b = p->speed[k + 1];
	double t = (v * v - a * a) / (b * b - a * a);
	double *answer = e->part[ENSEMBLE_ANSWER];
	compute_rising_answers_at_speed(e, v);
	const double *below = e->rising[e->measured[k]],
		     *above = e->rising[e->measured[k + 1]];
	for (size_t d = 0; d < DRAWS; d++)
		for (size_t i = d; is_posterior_draw_linear_in_speed(p, d) &&
				   i < e->n * DRAWS;
		     i += DRAWS)
			answer[i] = below[i] + t * (above[i] - below[i]);
}

double
ensemble_speed_error_factor(const struct posterior *p)
{
	return sqrt(1 + 1 / (double)p->n_speed);
}

double
ensemble_speed_error_of_draw(size_t draw)
{
	/* Quantiles of a normal distribution at even shares, by an
	 * approximation with errors below 0.0005 (Abramowitz and Stegun 1964,
	 * 26.2.23).  The factor 157 spreads them over all draws, and over the
	 * straight ones. */
	double share = ((double)(draw * 157 % DRAWS) + 0.5) / DRAWS;
	double t = sqrt(-2 * el_log(fmin(share, 1 - share)));
	double z = t - (2.515517 + t * (0.802853 + t * 0.010328)) /
			   (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
	return share < 0.5 ? -z : z;
}

double
ensemble_true_speed_of_draw(const struct posterior *p, size_t draw, double v)
{
	return v * (1 + p->speed_sd * ensemble_speed_error_factor(p) *
			    ensemble_speed_error_of_draw(draw));
}

/* Reads the answers of a draw off the grid at speed w: linear between two grid
 * speeds or, for straight draws, between measured speeds (D25).  Beyond the
 * grid, keeps the answers at the ensemble's speed, limited by the end of the
 * grid. */
static void
interpolate_draw_on_speed_grid(struct ensemble *e, size_t draw, double w)
{
	const struct posterior *p = e->of;
	size_t k, at = grid_index_below_speed(e, w), next = at + 1;
	double from = e->speed[at], to = e->speed[next];
	double t = (w - from) / (to - from);
	double *answer = e->part[ENSEMBLE_ANSWER];
	if (is_posterior_draw_linear_in_speed(p, draw) &&
	    is_between_measured_speeds(p, w, &k)) {
		at = e->measured[k];
		next = e->measured[k + 1];
		from = p->speed[k] * p->speed[k];
		to = p->speed[k + 1] * p->speed[k + 1];
		t = (w * w - from) / (to - from);
	}
	const double *below = e->rising[at], *above = e->rising[next];
	for (size_t i = draw; i < e->n * DRAWS; i += DRAWS) {
		if (t < 0)
			answer[i] = fmin(answer[i], below[i]);
		else if (t > 1)
			answer[i] = fmax(answer[i], above[i]);
		else
			answer[i] = below[i] + t * (above[i] - below[i]);
	}
}

/* Computes the answer of each draw at its own true speed for a stated speed v.
 * The true speed rises with v, and so does the answer. */
static void
compute_draws_at_true_speeds(struct ensemble *e, double v)
{
	double speed[DRAWS], slowest = v, fastest = v;
	for (size_t d = 0; d < DRAWS; d++) {
		speed[d] = ensemble_true_speed_of_draw(e->of, d, v);
		slowest = fmin(slowest, speed[d]);
		fastest = fmax(fastest, speed[d]);
	}
	if (e->rising[SLOWEST] == NULL)
		compute_draws_rising_with_speed(e);
	extend_grid_of_rising_answers(e, slowest);
	extend_grid_of_rising_answers(e, fastest);
	ensemble_set_speed_unconstrained(e, v);
	for (size_t d = 0; d < DRAWS; d++)
		interpolate_draw_on_speed_grid(e, d, speed[d]);
}

void
ensemble_set_speed(struct ensemble *e, double v)
{
	size_t k;
	if (v == e->at)
		return;
	if (e->of->speed_sd > 0)
		compute_draws_at_true_speeds(e, v);
	else if (is_between_measured_speeds(e->of, v, &k))
		compute_answers_between_speeds(e, v, k);
	else
		compute_rising_answers_at_speed(e, v);
	if (e->bypass > 0) {
		simulate_new_belt_cuts(e);
		ensemble_add_bypass(e);
	}
	e->at = v;
}

const double *
ensemble_products(struct ensemble *e, enum ensemble_part part)
{
	if (part == ENSEMBLE_SAMPLE)
		simulate_new_belt_cuts(e);
	return e->part[part];
}

const struct posterior *
ensemble_posterior(const struct ensemble *e)
{
	return e->of;
}

void
ensemble_mean_answer(const struct ensemble *e, double *passing)
{
	const double *P = e->part[ENSEMBLE_ANSWER];
	for (size_t i = 0; i < e->n; i++, P += DRAWS) {
		passing[i] = 0;
		for (size_t d = 0; d < DRAWS; d++)
			passing[i] += P[d];
		passing[i] /= DRAWS;
	}
}

/* Sorts n values and finds the interval that holds their middle `level`.  Each
 * end is an average of the values around it, with weights that fall with the
 * distance, because a single value is subject to chance. */
static void
sort_and_find_middle_interval(
    double *value, size_t n, double level, double *low, double *high)
{
	size_t cut = (size_t)floor((1 - level) / 2 * (double)n + 0.5);
	size_t about = n / 20 < cut ? n / 20 : cut;
	double sum = (double)((about + 1) * (about + 1));
	gsl_sort(value, 1, n);
	*low = *high = 0;
	for (size_t k = 0; k <= 2 * about; k++) {
		size_t near = k < about ? k : 2 * about - k;
		double weight = (double)(near + 1) / sum;
		*low += weight * value[cut - about + k];
		*high += weight * value[n - 1 - cut + about - k];
	}
}

void
ensemble_middle_interval(double *value, double level, double *low, double *high)
{
	for (size_t i = 0; i < DRAWS; i++)
		if (isnan(value[i]))
			value[i] = -INFINITY;
	sort_and_find_middle_interval(value, DRAWS, level, low, high);
	if (*low < -1e300)
		*low = NAN;
	if (*high < -1e300)
		*high = NAN;
}

void
ensemble_interval_around_answer(
    const double *draw, double level, double answer, double range[static 2])
{
	double value[DRAWS];
	memcpy(value, draw, sizeof value);
	ensemble_middle_interval(value, level, &range[0], &range[1]);
	/* A low end that is NAN lies below every number.  Of a number and NAN,
	 * fmax returns the number. */
	range[0] = answer < range[0] ? answer : range[0];
	range[1] = fmax(range[1], answer);
}

void
ensemble_interval_at_sieve(struct ensemble *e, enum ensemble_part part,
    size_t row, double level, double *low, double *high)
{
	double value[DRAWS];
	memcpy(value, ensemble_products(e, part) + row * DRAWS, sizeof value);
	ensemble_middle_interval(value, level, low, high);
}

double
ensemble_difference_of_halves(struct ensemble *e, double v)
{
	enum { HALF = DRAWS / 2 };
	const double rounding = 0.001, level = 0.8;
	double sum = 0, n = 0;
	ensemble_set_speed_unconstrained(e, v);
	for (size_t i = 0; i < e->n; i++) {
		const double *P = e->part[ENSEMBLE_ANSWER] + i * DRAWS;
		double value[DRAWS], low[3], high[3];
		memcpy(value, P, sizeof value);
		double off = gsl_stats_mean(value, 1, HALF) -
			     gsl_stats_mean(value + HALF, 1, HALF);
		sort_and_find_middle_interval(
		    value, HALF, level, &low[0], &high[0]);
		sort_and_find_middle_interval(
		    value + HALF, HALF, level, &low[1], &high[1]);
		sort_and_find_middle_interval(
		    value, DRAWS, level, &low[2], &high[2]);
		double width = high[2] - low[2];
		if (width < rounding)
			continue;
		off = fmax(fabs(off), fabs(low[1] - low[0]));
		off = fmax(off, fabs(high[1] - high[0])) / width;
		sum += off * off;
		n++;
	}
	return n > 0 ? sqrt(sum / n) : 0;
}
