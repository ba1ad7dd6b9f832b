/* EWMA and self-starting CUSUM of values that are whitened by the Cholesky
 * factor of their covariance under the draws (Hawkins and Olwell 1998).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/check/control_chart.h"

#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_cdf.h>

#include "base/xalloc.h"
#include "core/posterior/discrepancy.h"
#include "core/numeric/elementary.h"
#include "core/numeric/rng.h"

/* A CUSUM with k = 0.5 is best for shifts of one standard deviation (Page).
 * For the EWMA, 0.2 and 3 are the usual textbook values. */
const struct drift_rule DRIFT_RULE = {
    .k = 0.5, .h = 5, .lambda = 0.2, .width = 3, .cuts = 2};

/* Site files state passings to a tenth of a point or better. */
static const double ROUNDING = 0.0005;

void
drift_covariance_of_known_error(
    double noise, const double *passing, size_t n, double *error)
{
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j < n; j++) {
			double sd =
			    noise * discrepancy_scale_at_passing(passing[i]);
			error[i * n + j] =
			    i == j ? sd * sd + ROUNDING * ROUNDING : 0;
		}
}

void
drift_covariance_of_errors(const struct posterior *p, const double *size,
    const double *passing, size_t n, double *error)
{
	for (size_t i = 0; i < n; i++)
		for (size_t j = 0; j <= i; j++) {
			double apart = el_log(size[i]) - el_log(size[j]);
			double sum = 0;
			for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
				const double *hyper = p->draw[d].hyper;
				double own = hyper[HYPER_OWN];
				sum += discrepancy_shared_covariance(
					   apart, hyper) +
				       (i == j ? own * own : 0);
			}
			sum *= discrepancy_scale_at_passing(passing[i]) *
			       discrepancy_scale_at_passing(passing[j]) /
			       POSTERIOR_DRAWS;
			if (i == j)
				sum += ROUNDING * ROUNDING;
			error[i * n + j] = error[j * n + i] = sum;
		}
}

/* A component of a sample: the weight of each sieve, and the values that the
 * draws give it, minus their mean. */
struct component {
	double *weight, *draw;
};

static void
compute_component_in_draws(const struct drift_cut *c, struct component *w)
{
	double mean = 0;
	for (size_t d = 0; d < c->n_draw; d++) {
		w->draw[d] = 0;
		for (size_t i = 0; i < c->n; i++)
			w->draw[d] +=
			    w->weight[i] * c->truth[i * c->n_draw + d];
		mean += w->draw[d] / (double)c->n_draw;
	}
	for (size_t d = 0; d < c->n_draw; d++)
		w->draw[d] -= mean;
}

static double
covariance_over_draws(
    const struct component *a, const struct component *b, size_t n)
{
	return n > 0 ? el_dot(a->draw, b->draw, n) / (double)n : 0;
}

/* Returns the covariance of two components of a sample. */
static double
covariance_of_drift_components(const struct drift_cut *c,
    const struct component *a, const struct component *b)
{
	double sum = covariance_over_draws(a, b, c->n_draw);
	for (size_t i = 0; i < c->n; i++)
		sum +=
		    a->weight[i] * el_dot(b->weight, c->error + i * c->n, c->n);
	return sum;
}

/* Computes the weights of the regression line's slope times the range of ln
 * size; 0 for a single sieve. */
static void
fill_tilt_weights(const struct drift_cut *c, double *weight)
{
	double mean = 0, squares = 0;
	for (size_t i = 0; i < c->n; i++)
		mean += el_log(c->size[i]) / (double)c->n;
	for (size_t i = 0; i < c->n; i++) {
		weight[i] = el_log(c->size[i]) - mean;
		squares += weight[i] * weight[i];
	}
	double range = c->n > 0 ? weight[0] - weight[c->n - 1] : 0;
	for (size_t i = 0; i < c->n; i++)
		weight[i] *= squares > 0 ? range / squares : 0;
}

static void
fill_drift_component_weights(
    const struct drift_cut *c, struct component w[static DRIFT_COMPONENTS])
{
	struct component *level = &w[DRIFT_LEVEL], *tilt = &w[DRIFT_TILT];
	for (size_t k = 0; k < DRIFT_COMPONENTS; k++) {
		w[k].weight = xcalloc_doubles(c->n);
		w[k].draw = xcalloc_doubles(c->n_draw);
	}
	for (size_t i = 0; i < c->n; i++)
		level->weight[i] = 1 / (double)c->n;
	fill_tilt_weights(c, tilt->weight);
	compute_component_in_draws(c, level);
	compute_component_in_draws(c, tilt);
	double share = covariance_of_drift_components(c, level, tilt) /
		       covariance_of_drift_components(c, level, level);
	bool single = !(tilt->weight[0] > 0);
	for (size_t i = 0; i < c->n && !single; i++)
		tilt->weight[i] -= share * level->weight[i];
	compute_component_in_draws(c, tilt);
}

/* Returns the factor [n * n], in the upper triangle, of the covariance of a
 * component's values.  w [n * DRIFT_COMPONENTS]. */
static double *
covariance_factor_of_drift_component(const struct drift_cut *cut,
    const struct component *w, size_t n, size_t component)
{
	double *U = xcalloc_doubles(n * n);
	for (size_t i = 0; i < n; i++) {
		const struct component *a =
		    &w[i * DRIFT_COMPONENTS + component];
		for (size_t j = 0; j < i; j++)
			U[j * n + i] = covariance_over_draws(a,
			    &w[j * DRIFT_COMPONENTS + component],
			    cut[i].n_draw);
		double own = covariance_of_drift_components(&cut[i], a, a);
		/* Without weights the value is 0, whatever its variance. */
		U[i * n + i] = own > 0 ? own : 1;
	}
	discrepancy_cholesky(ISA_BEST, U, n);
	return U;
}

/* Advances the charts of a component by its score, the n-th.  Returns 1 or -1
 * if a chart is beyond its upper or lower limit, else 0. */
static int
advance_control_charts(
    struct drift_chart *c, const struct drift_rule *r, size_t n)
{
	double share = r->lambda / (2 - r->lambda) *
		       -expm1(2 * (double)n * log1p(-r->lambda));
	c->up = fmax(0, c->up + c->score - r->k);
	c->down = fmax(0, c->down - c->score - r->k);
	c->ewma += r->lambda * (c->score - c->ewma);
	c->ewma_limit = r->width * sqrt(share);
	bool above = c->up > r->h || c->ewma > c->ewma_limit;
	bool below = c->down > r->h || c->ewma < -c->ewma_limit;
	return above ? 1 : below ? -1 : 0;
}

/* The level comes first, because a shift that differs between sizes also tilts
 * the curve. */
static enum drift_state
drift_state_from_chart_signals(const int side[static DRIFT_COMPONENTS])
{
	return side[DRIFT_LEVEL] < 0   ? DRIFT_COARSER
	       : side[DRIFT_LEVEL] > 0 ? DRIFT_FINER
	       : side[DRIFT_TILT] < 0  ? DRIFT_FLATTER
	       : side[DRIFT_TILT] > 0  ? DRIFT_STEEPER
				       : DRIFT_NONE;
}

/* Returns the sample at which the CUSUM that signals at sample i last began to
 * rise from 0. */
static size_t
find_cusum_start(const struct drift_point *point, size_t i)
{
	enum drift_state state = point[i].state;
	size_t k = state == DRIFT_COARSER || state == DRIFT_FINER ? DRIFT_LEVEL
								  : DRIFT_TILT;
	bool up = state == DRIFT_FINER || state == DRIFT_STEEPER;
	size_t since = i;
	while (since > 0) {
		const struct drift_chart *c = &point[since - 1].chart[k];
		if (!((up ? c->up : c->down) > 0))
			break;
		since--;
	}
	return since;
}

/* Returns how far value i is from its prediction by the first `known` values,
 * in standard deviations.  U: see covariance_factor_of_drift_component. */
static double
z_score_given_earlier_values(const double *U, size_t n, size_t i, size_t known,
    size_t k, const struct drift_point *point)
{
	double expected = 0, variance = 0;
	for (size_t j = 0; j < known; j++)
		expected += U[j * n + i] * point[j].chart[k].off;
	for (size_t j = known; j <= i; j++)
		variance += U[j * n + i] * U[j * n + i];
	return (point[i].chart[k].value - expected) / sqrt(variance);
}

/* Returns the normal score of a value that is off by `off` standard deviations.
 * squares: the sum of the squares of the `known` earlier ones. */
static double
normal_score(
    const struct drift_rule *r, double off, size_t known, double squares)
{
	double freedom = r->cuts + (double)known;
	double t = off / sqrt((r->cuts + squares) / freedom);
	double beyond = fmax(gsl_cdf_tdist_Q(fabs(t), freedom), 1e-300);
	return copysign(gsl_cdf_ugaussian_Qinv(beyond), t);
}

static void
free_drift_component_arrays(struct component *w, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		free(w[i].weight);
		free(w[i].draw);
	}
}

size_t
drift_compute_charts(const struct drift_cut *cut, size_t n,
    const struct drift_rule *rule, struct drift_point *point, size_t *since)
{
	FREED struct component *w =
	    xcalloc(n * DRIFT_COMPONENTS + 1, sizeof *w);
	double *U[DRIFT_COMPONENTS];
	size_t first = n;
	for (size_t i = 0; i < n; i++)
		fill_drift_component_weights(&cut[i], &w[i * DRIFT_COMPONENTS]);
	for (size_t k = 0; k < DRIFT_COMPONENTS; k++)
		U[k] = covariance_factor_of_drift_component(cut, w, n, k);
	*since = n;
	for (size_t i = 0; i < n; i++) {
		int side[DRIFT_COMPONENTS];
		for (size_t k = 0; k < DRIFT_COMPONENTS; k++) {
			struct drift_chart *c = &point[i].chart[k];
			const struct component *own =
			    &w[i * DRIFT_COMPONENTS + k];
			*c = i > 0 ? point[i - 1].chart[k]
				   : (struct drift_chart){0};
			c->value =
			    el_dot(own->weight, cut[i].residual, cut[i].n);
			size_t known = i < *since ? i : *since;
			double truth =
			    covariance_over_draws(own, own, cut[i].n_draw);
			c->truth = sqrt(truth);
			c->error = sqrt(
			    covariance_of_drift_components(&cut[i], own, own) -
			    truth);
			c->off = z_score_given_earlier_values(
			    U[k], n, i, known, k, point);
			double squares = 0;
			for (size_t j = 0; j < known; j++)
				squares += point[j].chart[k].off *
					   point[j].chart[k].off;
			c->score = normal_score(rule, c->off, known, squares);
			side[k] = advance_control_charts(c, rule, i + 1);
		}
		point[i].state = drift_state_from_chart_signals(side);
		if (first == n && point[i].state != DRIFT_NONE) {
			first = i;
			*since = find_cusum_start(point, i);
		}
	}
	for (size_t k = 0; k < DRIFT_COMPONENTS; k++)
		free(U[k]);
	free_drift_component_arrays(w, n * DRIFT_COMPONENTS);
	return first;
}

double
drift_mean_run_length(
    const struct drift_rule *rule, double shift, uint64_t seed)
{
	enum { SEQUENCES = 2000, LONGEST = 20000, USE = 1 << 22 };
	double sum = 0;
	for (uint64_t q = 0; q < SEQUENCES; q++) {
		struct rng_key key = rng_make_key(seed, q, USE);
		struct drift_chart chart[DRIFT_COMPONENTS] = {{0}};
		bool signal = false;
		size_t n = 0;
		while (!signal && n < LONGEST) {
			for (size_t k = 0; k < DRIFT_COMPONENTS; k++) {
				size_t at = n * DRIFT_COMPONENTS + k;
				chart[k].score = rng_normal(key, (uint32_t)at) +
						 (k == DRIFT_LEVEL ? shift : 0);
				if (advance_control_charts(
					&chart[k], rule, n + 1) != 0)
					signal = true;
			}
			n++;
		}
		sum += (double)n;
	}
	return sum / SEQUENCES;
}

/* A simulated level and its chart.  error, actual: the standard deviation of a
 * sample's error, according to the posterior and in truth.  mean, variance: the
 * estimate of the true level, which narrows with each sample. */
struct simulated_level {
	double error, actual, mean, variance, squares;
	size_t known;
	struct drift_chart chart;
};

/* Adds a sample.  Returns true if the chart signals. */
static bool
add_sample_to_simulated_charts(
    struct simulated_level *l, const struct drift_rule *r, double value)
{
	double sum = l->variance + l->error * l->error;
	double share = l->variance / sum;
	l->chart.off = (value - l->mean) / sqrt(sum);
	l->chart.score = normal_score(r, l->chart.off, l->known, l->squares);
	l->mean += share * (value - l->mean);
	l->variance *= 1 - share;
	l->squares += l->chart.off * l->chart.off;
	return advance_control_charts(&l->chart, r, ++l->known) != 0;
}

/* Simulates `quiet` samples, then shifted ones.  Returns the number, from 1, of
 * the shifted sample at which the chart first signals; 0 if it signals before
 * the shift; LONGEST + 1 if it never does. */
enum { LONGEST = 200 };
static size_t
simulate_cuts_from_shift_to_signal(const struct drift_rule *rule,
    struct simulated_level l, size_t quiet, double shift, struct rng_key key)
{
	double truth = sqrt(l.variance) * rng_normal(key, 0);
	for (uint32_t at = 1; at <= quiet + LONGEST; at++) {
		double value = truth + l.actual * rng_normal(key, at);
		if (add_sample_to_simulated_charts(
			&l, rule, at > quiet ? value + shift : value))
			return at > quiet ? at - quiet : 0;
	}
	return LONGEST + 1;
}

double
drift_detection_delay(const struct drift_rule *rule,
    const struct drift_point *point, size_t n, size_t known, double shift,
    uint64_t seed)
{
	enum { SEQUENCES = 401, USE = (1 << 22) + 1 };
	const struct drift_chart *last = &point[n - 1].chart[DRIFT_LEVEL];
	double squares = rule->cuts;
	for (size_t j = 0; j < known; j++)
		squares += pow(point[j].chart[DRIFT_LEVEL].off, 2);
	struct simulated_level l = {.error = last->error,
	    .actual =
		last->error * sqrt(squares / (rule->cuts + (double)known)),
	    .variance = last->truth * last->truth};
	size_t after[LONGEST + 2] = {0}, all = 0, sum = 0, median = 1;
	for (uint64_t q = 0; q < SEQUENCES; q++)
		after[simulate_cuts_from_shift_to_signal(
		    rule, l, known, shift, rng_make_key(seed, q, USE))]++;
	all = SEQUENCES - after[0];
	while (median <= LONGEST && 2 * (sum + after[median]) <= all)
		sum += after[median++];
	return median <= LONGEST ? (double)median : INFINITY;
}
