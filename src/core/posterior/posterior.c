/* Draws by differential evolution Markov chains.
 *
 * Many chains run side by side, in two halves.  A chain of one half moves along
 * the difference of two chains of the other (ter Braak 2006), so moves have the
 * length and direction of what the data leave undetermined, and jump between
 * the valleys that contain chains.  The search's kernel evaluates a whole half
 * at once.  The warm-up gives the likelihood increasing weight and resamples
 * the chains at each step (population annealing); without this, chains that
 * start in a valley of negligible probability stay there for thousands of
 * generations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/posterior.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
#include "base/xalloc.h"
#include "core/posterior/coordinates.h"
#include "core/posterior/covariance.h"
#include "core/posterior/guide.h"
#include "core/posterior/lack_of_fit.h"
#include "core/posterior/thin.h"
#include "core/numeric/elementary.h"
#include "core/search/kernel.h"
#include "core/numeric/rng.h"
#include "core/search/sensitivity.h"

enum {
	CHAINS = POSTERIOR_DRAWS / 2, /* each gives two draws to a batch */
	BATCHES = 4, /* as many draws as one batch has are kept; see thin.h */
	DRAWS_EACH = 2 * BATCHES,
	HALF = CHAINS / 2,
	PART = 16, /* the fewest chains of a half that a thread takes at a
		   * time */
	RUNG = 6,  /* generations */
	WARM_UP = 112,
	KEPT = 176,
	RECENT = 5, /* generations that inform the guides during the warm-up */
	/* One generation in this many moves the hyperparameters; in the warm-up
	 * one in twice as many. */
	HYPER_EVERY = 6,
	/* After the warm-up, one generation in this many moves along
	 * differences. */
	ALONG_EVERY = 10,
	LEAP_EVERY = 10, /* one generation in this many leaps from valley to
			  * valley */
	STRENGTHS = PARAMS_MOST + HYPERS,
	COORDINATES = STRENGTHS + STRENGTHS_COORDINATES,
	NUMBERS = 64, /* random numbers for a chain in a generation */
	/* With many runs, this many passings of each are enough, and more would
	 * add little; with few runs, as many are used as fit one matrix. */
	LEAST = 8
};

_Static_assert((int)COORDINATES <= (int)GUIDE_MOST, "room of the guide");

static const double FIRST_RUNG = 0.02, RISE = 1.25;

enum { USE_START = 1 << 21, USE_MOVE, USE_ANNEAL, USE_DRAW };

/* x: the coordinates of the parameters (coordinates.h); from PARAMS_MOST on,
 * the logarithms of the hyperparameters; from STRENGTHS on, the coordinates of
 * the strengths.  likelihood, prior, hyper_prior: -ln of these densities, up to
 * constants. */
struct chain {
	double x[COORDINATES];
	double likelihood, prior, hyper_prior;
	double volume; /* see rescale_trial_differences */
	double
	    more; /* correction of a guided move; see guide_propose_mcmc_step */
	double *U, *d; /* of covariance_compute_factor; simulated - measured */
};

struct sampler {
	const struct breakage *of;
	struct params fit;
	struct bounds bounds;
	struct sensitivity sensitivity;
	double rms;   /* of the fit's differences */
	double noise; /* stated by the user, or 0 */
	enum isa isa;
	struct coordinates coordinates;
	bool two; /* the rock may have two strengths */
	size_t n_cell;
	struct cell *cell;
	double *measured; /* passings of the cells */
	struct covariance *covariance;
	double *scheme; /* exact minus the kernel's differences, at the fit */
	struct kernel *kernel;
	struct pool *pool;
	uint64_t seed, generation;
	double share; /* share of the likelihood that counts */
	struct chain chain[CHAINS], trial[HALF];
	size_t first; /* first chain of the half that moves */
	size_t part;  /* trials for one thread at a time */
	bool started; /* both halves have started */
	bool hyper;   /* the hyperparameters move, not the parameters */
	bool guided;  /* the guides propose the moves */
	/* The guides of the chains with one strength and of those with two,
	 * their factors, and the factor for all hyperparameters; ln of the
	 * share of moves to each kind. */
	struct guide guide[2];
	struct guide_subset kind[2], hypers;
	double log_share[2];
	double told; /* generations that inform the guides */
	/* The trials in the order of evaluation, those with two strengths
	 * first: their indices, parameters, e0_min and share of the softer
	 * rock, and differences. */
	size_t order[HALF];
	double *theta[PARAMS_MOST], softer[HALF], share_softer[HALF];
	double *difference, *misfit;
	size_t accepted, tried;
};

/* Rescales the differences of a trial d [n_cell], simulated - measured, from
 * its own h to that of the cells (list_measured_passings).  Then one covariance
 * serves all trials, and a trial is compared in the same way as a draw is
 * corrected (discrepancy_corrected_passing).  Returns ln of the factor by which
 * this shrinks a volume. */
static double
rescale_trial_differences(const struct sampler *s, double *d)
{
	enum {
		AT_ONCE = 16
	}; /* factors for one logarithm: their product does not overflow */
	const double floor = 0.05;
	double level = 0, product = 1;
	for (size_t k = 0; k < s->n_cell; k++) {
		double h =
		    discrepancy_scale_at_passing(s->measured[k] + d[k] / 2);
		double ratio = (h + floor) / (s->cell[k].h + floor);
		d[k] /= ratio;
		product *= ratio;
		if (k % AT_ONCE == AT_ONCE - 1) {
			level += el_log(product);
			product = 1;
		}
	}
	return level + el_log(product);
}

static void
evaluate_trial_of_chain(struct sampler *s, size_t place, double *work)
{
	size_t i = s->order[place];
	struct chain *trial = &s->trial[i];
	const struct chain *now = &s->chain[s->first + i];
	size_t n = s->n_cell;
	if (s->hyper) {
		memcpy(trial->d, now->d, n * sizeof *now->d);
		covariance_compute_factor(
		    s->covariance, trial->x + PARAMS_MOST, trial->U);
	}
	for (size_t k = 0; k < n && !s->hyper; k++)
		trial->d[k] = s->difference[k * HALF + place] + s->scheme[k];
	trial->volume =
	    s->hyper ? now->volume : rescale_trial_differences(s, trial->d);
	memcpy(work, trial->d, n * sizeof *work);
	trial->likelihood =
	    trial->volume + covariance_minus_log_density(s->covariance,
				s->hyper ? trial->U : now->U, work);
	if (s->hyper)
		trial->prior = now->prior;
	trial->hyper_prior = s->hyper ? discrepancy_minus_log_prior(
					    trial->x + PARAMS_MOST, s->noise)
				      : now->hyper_prior;
	if (!isfinite(trial->likelihood))
		trial->prior = INFINITY;
}

static void
compute_residuals_of_trials(
    struct sampler *s, size_t from, size_t to, unsigned thread)
{
	struct kernel_out out = {
	    s->misfit, s->difference, HALF, s->softer, s->share_softer};
	kernel_evaluate_candidates(
	    s->kernel, (const double *const *)s->theta, from, to, thread, &out);
}

static void
evaluate_some_posterior_trials(void *data, size_t part, unsigned thread)
{
	struct sampler *s = data;
	size_t from = part * s->part, to = from + s->part;
	double *work = xcalloc_doubles(s->n_cell);
	if (!s->hyper)
		compute_residuals_of_trials(s, from, to, thread);
	for (size_t i = from; i < to; i++)
		evaluate_trial_of_chain(s, i, work);
	free(work);
}

static struct strengths
rock_strengths_at_coordinates(const struct sampler *s, const double *x)
{
	return s->two ? strengths_from_coordinates(x + STRENGTHS)
		      : (struct strengths){0, 1, 1};
}

static void
convert_trial_to_params(
    struct sampler *s, size_t i, struct strengths rock, size_t place)
{
	size_t e0 = s->of->strength + 1;
	double at[PARAMS_MOST], *prior = &s->trial[i].prior;
	const double *x = s->trial[i].x;
	*prior = coordinates_to_params(&s->coordinates, x, at);
	for (size_t j = STRENGTHS; j < COORDINATES; j++)
		*prior += x[j] * x[j] / 2;
	s->order[place] = i;
	s->softer[place] = at[e0] * rock.softer;
	s->share_softer[place] = strengths_softer_share(&rock);
	at[e0] *= rock.harder;
	for (size_t j = 0; j < s->of->n; j++)
		s->theta[j][place] = at[j];
}

static void
evaluate_all_trials(struct sampler *s)
{
	size_t two = 0, one = HALF;
	for (size_t i = 0; i < HALF && s->hyper; i++)
		s->order[i] = i;
	for (size_t i = 0; i < HALF && !s->hyper; i++) {
		struct strengths rock =
		    rock_strengths_at_coordinates(s, s->trial[i].x);
		convert_trial_to_params(
		    s, i, rock, rock.share > 0 ? two++ : --one);
	}
	pool_run(s->pool, HALF / s->part, evaluate_some_posterior_trials, s);
}

/* Proposes a move of chain i along the difference of two chains of the other
 * half. */
static void
propose_along_chain_difference(struct sampler *s, size_t i, struct rng_key key)
{
	const struct chain *other = &s->chain[s->first == 0 ? HALF : 0];
	uint32_t at = (uint32_t)((s->first + i) * NUMBERS);
	size_t strengths = s->two && !s->hyper ? STRENGTHS_COORDINATES : 0;
	size_t from = s->hyper ? PARAMS_MOST : 0;
	size_t to = s->hyper ? STRENGTHS : s->of->n;
	double n = s->hyper ? HYPERS : (double)(s->sensitivity.n + strengths);
	size_t a = (size_t)(rng_uniform(key, at) * HALF);
	size_t b = (size_t)(rng_uniform(key, at + 1) * (HALF - 1));
	b += b >= a;
	double length = 2.38 / sqrt(2 * fmax(n, 1));
	length *= 0.5 + rng_uniform(key, at + 2);
	if (s->generation % LEAP_EVERY == 0)
		length = 1;
	double *x = s->trial[i].x;
	memcpy(x, s->chain[s->first + i].x, sizeof s->trial[i].x);
	for (size_t j = from; j < to; j++)
		x[j] += length * (other[a].x[j] - other[b].x[j]);
	for (size_t j = STRENGTHS; j < STRENGTHS + strengths; j++)
		x[j] += length * (other[a].x[j] - other[b].x[j]);
	coordinates_reflect_at_bounds(&s->coordinates, x);
}

/* Returns 1 if the rock has two strengths, else 0. */
static size_t
has_two_strengths(const struct sampler *s, const double *x)
{
	return s->two && x[STRENGTHS] > 0;
}

/* Returns ln of the density from which propose_guided_move draws, up to a
 * constant. */
static double
log_guided_proposal_density(const struct sampler *s, const double *x)
{
	size_t kind = has_two_strengths(s, x);
	double sum = s->log_share[kind] + guide_log_density(&s->kind[kind], x);
	for (size_t j = STRENGTHS; j < COORDINATES && kind == 0; j++)
		sum -= x[j] * x[j] / 2;
	return kind == 0 ? sum + el_log(2) : sum;
}

/* Draws the coordinates of the strengths from their prior, as the data say
 * nothing about them if the rock has only one strength.  Returns the same as
 * guide_propose_mcmc_step. */
static double
sample_strengths_from_prior(double *x, struct rng_key key, uint32_t at)
{
	double more = 0;
	for (size_t j = STRENGTHS; j < COORDINATES; j++) {
		double anew = rng_normal(key, at++);
		more += (x[j] * x[j] - anew * anew) / 2;
		x[j] = j == STRENGTHS ? -fabs(anew) : anew;
	}
	return more;
}

/* Proposes a move of chain i by redrawing some coordinates.  In every other
 * generation these are about half of the parameters; in the rest, all of them,
 * and also whether the rock has one strength or two, which small steps hardly
 * ever change.  Each kind has its own mean and covariance. */
static void
propose_guided_move(struct sampler *s, size_t i, struct rng_key key)
{
	const double half = 0.5;
	const double *now = s->chain[s->first + i].x;
	struct chain *trial = &s->trial[i];
	uint32_t at = (uint32_t)((s->first + i) * NUMBERS + 4);
	bool all = s->hyper || s->generation % 2 == 0;
	size_t kind = has_two_strengths(s, now), to = kind;
	if (all && !s->hyper && s->two)
		to = el_log(rng_uniform(key, at)) < s->log_share[1];
	memcpy(trial->x, now, sizeof trial->x);
	trial->more =
	    guide_propose_mcmc_step(s->hyper ? &s->hypers : &s->kind[to],
		all ? 1 : half, now, trial->x, key, at + 1);
	if (!s->hyper && s->two && to == 0)
		trial->more += sample_strengths_from_prior(
		    trial->x, key, at + 1 + 2 * COORDINATES);
	if (has_two_strengths(s, trial->x) != to)
		trial->more = INFINITY;
	else if (to != kind)
		trial->more = log_guided_proposal_density(s, trial->x) -
			      log_guided_proposal_density(s, now);
}

/* Lists the coordinates that move in at [COORDINATES] and returns their
 * number. */
static size_t
list_moving_coordinates(const struct sampler *s, size_t *at)
{
	size_t n = 0;
	for (size_t j = 0; j < HYPERS && s->hyper; j++)
		at[n++] = PARAMS_MOST + j;
	for (size_t j = 0; j < s->of->n && !s->hyper; j++)
		at[n++] = j;
	for (size_t j = STRENGTHS; j < COORDINATES && s->two && !s->hyper; j++)
		at[n++] = j;
	return n;
}

/* Factors the guides of this generation.  A kind with few chains is blended
 * with all chains, which say more than these few alone. */
static void
factor_guide_covariances(struct sampler *s)
{
	const double generations = 2, least = 0.05;
	size_t at[COORDINATES], n = list_moving_coordinates(s, at);
	struct guide all = s->guide[0];
	guide_merge_moments(&all, &s->guide[1], s->guide[1].n);
	if (s->hyper) {
		guide_factor_subset(&all, at, n, &s->hypers);
		return;
	}
	for (size_t kind = 0; kind < 2; kind++) {
		struct guide g = s->guide[kind];
		double share = g.n / all.n;
		guide_merge_moments(&g, &all, generations);
		guide_factor_subset(&g, at,
		    s->two && kind == 0 ? n - STRENGTHS_COORDINATES : n,
		    &s->kind[kind]);
		s->log_share[kind] = el_log((share + least) / (1 + 2 * least));
	}
}

/* Chooses the kind of move of a generation.  With moves along differences
 * alone, chains take 100 to 400 generations to forget where they were, so most
 * moves are guided.  During the warm-up, parameters move along differences,
 * because the cloud of chains has no useful shape while they are still choosing
 * valleys. */
static void
choose_kind_of_chain_move(struct sampler *s)
{
	size_t every = s->generation < WARM_UP ? 2 * HYPER_EVERY : HYPER_EVERY;
	s->hyper = s->generation % every == every - 1;
	s->guided = s->hyper || (s->generation >= WARM_UP &&
				    s->generation % ALONG_EVERY != 0);
	s->guided = s->guided && s->generation >= RUNG;
	if (s->guided && s->first == 0)
		factor_guide_covariances(s);
}

static void
swap_pointers(double **a, double **b)
{
	double *other = *a;
	*a = *b;
	*b = other;
}

static void
accept_trial(struct chain *chain, struct chain *trial, bool hyper)
{
	memcpy(chain->x, trial->x, sizeof chain->x);
	chain->likelihood = trial->likelihood;
	chain->prior = trial->prior;
	chain->volume = trial->volume;
	chain->hyper_prior = trial->hyper_prior;
	swap_pointers(&chain->d, &trial->d);
	if (hyper)
		swap_pointers(&chain->U, &trial->U);
}

static void
accept_or_reject_trial(struct sampler *s, size_t i, struct rng_key key)
{
	struct chain *now = &s->chain[s->first + i], *trial = &s->trial[i];
	double rise = s->share * (trial->likelihood - now->likelihood) +
		      trial->prior - now->prior + trial->hyper_prior -
		      now->hyper_prior + (s->guided ? trial->more : 0);
	uint32_t at = (uint32_t)((s->first + i) * NUMBERS + 3);
	s->tried++;
	if (!(el_log(rng_uniform(key, at)) < -rise))
		return;
	s->accepted++;
	accept_trial(now, trial, s->hyper);
}

/* Switches to the other half.  Returns true if both have moved. */
static bool
switch_to_other_chain_half(struct sampler *s)
{
	s->first = HALF - s->first;
	return s->first == 0;
}

/* Moves a half.  Returns true if that completes a generation. */
static bool
move_half_of_chains(struct sampler *s)
{
	struct rng_key key = rng_make_key(s->seed, s->generation, USE_MOVE);
	choose_kind_of_chain_move(s);
	for (size_t i = 0; i < HALF; i++)
		(s->guided ? propose_guided_move
			   : propose_along_chain_difference)(s, i, key);
	evaluate_all_trials(s);
	for (size_t i = 0; i < HALF; i++)
		accept_or_reject_trial(s, i, key);
	if (!switch_to_other_chain_half(s))
		return false;
	s->generation++;
	return true;
}

/* Puts a chain near the fit, at a random distance along each direction of the
 * sensitivities, as far as the data leave that direction open. */
static void
place_chain_near_fit(
    const struct sampler *s, struct rng_key key, struct chain *c)
{
	const struct sensitivity *of = &s->sensitivity;
	struct params p = s->fit;
	for (size_t h = 0; h < of->n; h++) {
		double length =
		    fmin(1.5 * s->rms / fmax(of->sigma[h], 1e-9), 0.3);
		double move = length * rng_normal(key, (uint32_t)h);
		for (size_t k = 0; k < of->n; k++)
			p.at[of->column[k]] += move * of->direction[h][k] *
					       of->range[of->column[k]];
	}
	for (size_t j = s->of->gauge; j < s->of->n; j++)
		p.at[j] =
		    fmin(fmax(p.at[j], s->bounds.lower[j]), s->bounds.upper[j]);
	coordinates_from_params(&s->coordinates, p.at, c->x);
	for (size_t h = 0; h < HYPERS; h++)
		c->x[PARAMS_MOST + h] =
		    el_log(HYPER[h].median) +
		    HYPER[h].spread *
			rng_normal(key, (uint32_t)(PARAMS_MOST + h));
	for (size_t j = STRENGTHS; j < COORDINATES; j++)
		c->x[j] = rng_normal(key, (uint32_t)j);
	covariance_compute_factor(s->covariance, c->x + PARAMS_MOST, c->U);
	c->hyper_prior =
	    discrepancy_minus_log_prior(c->x + PARAMS_MOST, s->noise);
}

static void
start_half_of_chains(struct sampler *s)
{
	s->hyper = false;
	s->share = FIRST_RUNG;
	for (size_t i = 0; i < HALF; i++) {
		struct chain *c = &s->chain[s->first + i];
		place_chain_near_fit(
		    s, rng_make_key(s->seed, s->first + i, USE_START), c);
		memcpy(s->trial[i].x, c->x, sizeof c->x);
	}
	evaluate_all_trials(s);
	for (size_t i = 0; i < HALF; i++)
		accept_trial(&s->chain[s->first + i], &s->trial[i], false);
	s->started = switch_to_other_chain_half(s);
}

static void
copy_markov_chain(
    const struct sampler *s, struct chain *to, const struct chain *from)
{
	size_t room = covariance_factor_size(s->covariance);
	memcpy(to->x, from->x, sizeof to->x);
	memcpy(to->U, from->U, room * sizeof *to->U);
	memcpy(to->d, from->d, s->n_cell * sizeof *to->d);
	to->likelihood = from->likelihood;
	to->prior = from->prior;
	to->volume = from->volume;
	to->hyper_prior = from->hyper_prior;
}

/* Lets a larger share of the likelihood count, and resamples the chains with
 * weights in proportion to the resulting change of their probability. */
static void
resample_tempered_chains(struct sampler *s, double share)
{
	double weight[CHAINS], least = INFINITY, sum = 0, at = 0;
	size_t copies[CHAINS] = {0}, spare = 0, drawn = 0;
	for (size_t i = 0; i < CHAINS; i++)
		least = fmin(least, s->chain[i].likelihood);
	for (size_t i = 0; i < CHAINS; i++) {
		double rise = s->chain[i].likelihood - least;
		weight[i] = rise < 1e9 ? el_exp(-(share - s->share) * rise) : 0;
		sum += weight[i];
	}
	s->share = share;
	double u =
	    rng_uniform(rng_make_key(s->seed, s->generation, USE_ANNEAL), 0);
	for (size_t i = 0; i < CHAINS; i++) {
		at += weight[i] / sum * CHAINS;
		for (; drawn < CHAINS && (double)drawn + u < at; drawn++)
			copies[i]++;
	}
	for (size_t i = 0; i < CHAINS; i++)
		for (; copies[i] > 1; copies[i]--) {
			while (copies[spare] > 0)
				spare++;
			copy_markov_chain(s, &s->chain[spare], &s->chain[i]);
			copies[spare] = 1;
		}
}

/* Sums over the kept generations, by chain and coordinate. */
struct sums {
	double n, of[CHAINS][COORDINATES], squares[CHAINS][COORDINATES];
};

static void
add_chains_to_sums(struct sums *sums, const struct sampler *s)
{
	sums->n++;
	for (size_t i = 0; i < CHAINS; i++)
		for (size_t j = 0; j < COORDINATES; j++) {
			double x = s->chain[i].x[j];
			sums->of[i][j] += x;
			sums->squares[i][j] += x * x;
		}
}

static double
gelman_rubin(const struct sums *sums, size_t j)
{
	double mean = 0, within = 0, between = 0;
	for (size_t i = 0; i < CHAINS; i++) {
		double own = sums->of[i][j] / sums->n;
		mean += own / CHAINS;
		within += (sums->squares[i][j] / sums->n - own * own) / CHAINS;
	}
	for (size_t i = 0; i < CHAINS; i++) {
		double off = sums->of[i][j] / sums->n - mean;
		between += off * off / (CHAINS - 1);
	}
	return within > 1e-12 * fabs(mean) ? sqrt(1 + between / within) : 1;
}

/* Returns the difference between the means of the two halves of the draws, in
 * standard deviations. */
static double
difference_of_draw_halves(const struct posterior *p, size_t j)
{
	double sum[2] = {0}, squares = 0;
	for (size_t i = 0; i < POSTERIOR_DRAWS; i++) {
		double x = p->draw[i].params.at[j];
		sum[i / CHAINS] += x / CHAINS;
		squares += x * x / POSTERIOR_DRAWS;
	}
	double mean = (sum[0] + sum[1]) / 2, variance = squares - mean * mean;
	return variance > 1e-12 * mean * mean
		   ? fabs(sum[0] - sum[1]) / sqrt(variance)
		   : 0;
}

static void
measure_chain_convergence(
    struct posterior *p, const struct sampler *s, const struct sums *sums)
{
	p->ratio = 1;
	p->accepted = (double)s->accepted / (double)s->tried;
	for (size_t j = 0; j < COORDINATES; j++)
		if (j < s->of->n || j >= PARAMS_MOST)
			p->ratio = fmax(p->ratio, gelman_rubin(sums, j));
	for (size_t j = 0; j < s->of->n; j++)
		p->drift = fmax(p->drift, difference_of_draw_halves(p, j));
}

/* Puts knots at the sizes of the cells and the ends of the feeds, and more in
 * wide gaps, so that a process is nearly linear between knots. */
static void
make_log_size_knots(
    struct posterior *p, const struct site *site, const struct sampler *s)
{
	const double most = 0.2;
	double *at = xcalloc_doubles(s->n_cell + 2 * site->n_run + 2);
	size_t n = 0;
	for (size_t i = 0; i < s->n_cell; i++)
		at[n++] = s->cell[i].log_size;
	double coarsest = 0, finest = INFINITY;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct psd *feed = &site->run[r].feed;
		coarsest = fmax(coarsest, feed->size[0]);
		finest = fmin(finest, feed->size[feed->n - 1]);
		/* With many runs, the ends of their feeds would make too many
		 * knots. */
		if (s->n_cell > COVARIANCE_FEW)
			continue;
		at[n++] = el_log(feed->size[0]);
		at[n++] = el_log(feed->size[feed->n - 1]);
	}
	at[n++] = el_log(coarsest);
	at[n++] = el_log(finest);
	n = psd_sort_distinct_sizes(at, n, 1e-9);
	p->knot = xcalloc_doubles(n + (size_t)((at[0] - at[n - 1]) / most) + 2);
	p->knot[p->n_knot++] = at[0];
	for (size_t i = 1; i < n; i++) {
		double gap = at[i - 1] - at[i];
		double parts = floor(gap / most) + 1;
		for (double k = 1; k <= parts; k++)
			p->knot[p->n_knot++] = at[i - 1] - gap * k / parts;
	}
	free(at);
}

static size_t
index_of_knot(const struct posterior *p, double log_size)
{
	size_t k = 0;
	while (k + 1 < p->n_knot && p->knot[k] > log_size + 1e-6)
		k++;
	return k;
}

/* The random numbers of a draw.  The two draws of a chain use the same numbers
 * with opposite signs, so that the error of their mean is smaller. */
struct noise {
	enum isa isa;
	struct rng_key key;
	uint32_t next;
	double sign;
};

static void
next_random_normals(struct noise *noise, size_t n, double *z)
{
	discrepancy_random_normals(noise->isa, noise->key, noise->next, n, z);
	noise->next += (uint32_t)n;
	for (size_t i = 0; i < n; i++)
		z[i] *= noise->sign;
}

/* Draws a Gaussian process at the knots.  Its covariance is U' U. */
static void
sample_gaussian_process(
    const double *U, size_t n, struct noise *noise, double *f, double *work)
{
	next_random_normals(noise, n, work);
	for (size_t i = 0; i < n; i++)
		f[i] = 0;
	for (size_t k = 0; k < n; k++)
		for (size_t i = k; i < n; i++)
			f[i] += U[k * n + i] * work[k];
}

/* The covariances of pairs of knots (discrepancy_covariances_of_pairs), and
 * their Cholesky factors. */
struct knot_pairs {
	double *f, *error;     /* [m * (m + 1) / 2] */
	double *wide, *shared; /* [m * m] */
};

static double *
factor_knot_covariance(enum isa isa, const double *pair, size_t m)
{
	double *U = xcalloc_doubles(m * m);
	discrepancy_factor_pair_covariances(isa, pair, m, U);
	return U;
}

static struct knot_pairs
knot_pairs_new(enum isa isa, const struct posterior *p, const double *hyper)
{
	size_t m = p->n_knot, n = 0, pairs = m * (m + 1) / 2;
	struct knot_pairs k = {
	    .f = xcalloc_doubles(pairs), .error = xcalloc_doubles(pairs)};
	for (size_t i = 0; i < m; i++)
		for (size_t j = 0; j <= i; j++)
			k.f[n++] = p->knot[i] - p->knot[j];
	discrepancy_covariances_of_pairs(isa, pairs, hyper, k.f, k.error);
	k.wide = factor_knot_covariance(isa, k.f, m);
	k.shared = factor_knot_covariance(isa, k.error, m);
	return k;
}

static void
knot_pairs_clear(struct knot_pairs *k)
{
	free(k->f);
	free(k->error);
	free(k->wide);
	free(k->shared);
}

/* Simulates d [n_cell], the differences of an artificial plant with processes
 * and errors drawn from the prior. */
static void
simulate_plant_residuals(const struct sampler *s, const struct posterior *p,
    const struct posterior_draw *draw, double *const *process,
    const double *shared, struct noise *noise, double *d)
{
	size_t m = p->n_knot;
	double *error = xcalloc_doubles(m), *work = xcalloc_doubles(m);
	double term[DISCREPANCY_TERMS];
	next_random_normals(noise, s->n_cell, d);
	for (size_t i = 0; i < s->n_cell; i++) {
		const struct cell *c = &s->cell[i];
		size_t k = index_of_knot(p, c->log_size);
		if (i == 0 || c->run != s->cell[i - 1].run)
			sample_gaussian_process(shared, m, noise, error, work);
		double sum = error[k] + draw->hyper[HYPER_OWN] * d[i];
		discrepancy_speed_terms(c->t, draw->hyper[HYPER_SLOPE], term);
		for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
			sum += term[j] * process[j][k];
		d[i] = c->h * sum;
	}
	free(error);
	free(work);
}

/* Conditions processes drawn from the prior on the data (Matheron's rule),
 * using the differences between the data and the artificial plant's, d.  pair:
 * knot_pairs.f, because the sizes of the cells are among the knots. */
static void
condition_discrepancy_on_data(const struct sampler *s,
    const struct posterior *p, const struct chain *chain, const double *pair,
    double slope, double *const *process, double *d)
{
	double term[DISCREPANCY_TERMS];
	for (size_t i = 0; i < s->n_cell; i++)
		d[i] = -chain->d[i] - d[i];
	covariance_solve(s->covariance, chain->U, d);
	for (size_t i = 0; i < s->n_cell; i++) {
		const struct cell *c = &s->cell[i];
		size_t at = index_of_knot(p, c->log_size);
		discrepancy_speed_terms(c->t, slope, term);
		for (size_t k = 0; k < p->n_knot; k++) {
			double gain = c->h * d[i] *
				      pair[discrepancy_index_of_pair(k, at)];
			for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
				process[j][k] += term[j] * gain;
		}
	}
}

static void
make_posterior_draw(const struct sampler *s, struct posterior *p,
    const struct chain *chain, struct noise noise, size_t at)
{
	struct posterior_draw *draw = &p->draw[at];
	size_t m = p->n_knot;
	double *room = xcalloc_doubles((DISCREPANCY_TERMS + 2) * m + s->n_cell);
	double *process[DISCREPANCY_TERMS], *next = room;
	draw->params = s->fit;
	coordinates_to_params(&s->coordinates, chain->x, draw->params.at);
	params_scale_largest_beta_to_1(&draw->params);
	draw->strengths = rock_strengths_at_coordinates(s, chain->x);
	for (size_t j = 0; j < HYPERS; j++)
		draw->hyper[j] = el_exp(chain->x[PARAMS_MOST + j]);
	for (size_t j = 0; j < DISCREPANCY_TERMS; j++, next += m)
		process[j] = next;
	double *error = next, *work = error + m, *d = work + m;
	struct knot_pairs pairs = knot_pairs_new(s->isa, p, draw->hyper);
	for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
		sample_gaussian_process(
		    pairs.wide, m, &noise, process[j], work);
	sample_gaussian_process(pairs.shared, m, &noise, error, work);
	next_random_normals(&noise, m, work);
	for (size_t k = 0; k < m; k++)
		error[k] += draw->hyper[HYPER_OWN] * work[k];
	simulate_plant_residuals(s, p, draw, process, pairs.shared, &noise, d);
	condition_discrepancy_on_data(
	    s, p, chain, pairs.f, draw->hyper[HYPER_SLOPE], process, d);
	for (size_t k = 0; k < m; k++) {
		size_t place = k * POSTERIOR_DRAWS + at;
		for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
			p->term[j][place] = process[j][k];
		p->error[place] = error[k];
	}
	knot_pairs_clear(&pairs);
	free(room);
}

static double
mean_energy_of_runs(const struct misfit *m)
{
	double sum = 0;
	for (size_t r = 0; r < m->n_run; r++)
		sum += specific_energy_at_speed(m->run[r].speed);
	return sum / (double)m->n_run;
}

/* Returns the fit, and converts its bounds, in the model with gamma that
 * extends the fit's own, if there is one and Eq 1 is used in the form `ratio`
 * (D3). */
static struct params
widen_to_model_with_gamma(const struct params *p, double energy,
    struct model_settings *settings, struct bounds *bounds)
{
	const struct breakage *own = breakage_model_of_params(p);
	size_t wide = settings->appearance == APPEARANCE_RATIO
			  ? breakage_widest_containing_model(p->breakage)
			  : p->breakage;
	const struct breakage *of = BREAKAGES[wide];
	struct bounds b = bounds_default(wide);
	struct params q = breakage_params_in_wider_model(p, wide);
	for (size_t j = 0; j < of->n; j++) {
		const struct param_info *info = &of->parameter[j];
		size_t i = breakage_parameter_index(own, info->name);
		if (i < own->n) {
			b.lower[j] = bounds->lower[i];
			b.upper[j] = bounds->upper[i];
		} else {
			b.lower[j] = info->start - 5 * info->spread;
			b.upper[j] = info->start + 5 * info->spread;
		}
		if (j == of->reference) {
			q.at[j] = i < own->n ? q.at[j] : energy;
			b.lower[j] = b.upper[j] = q.at[j];
		}
	}
	settings->breakage = (unsigned)wide;
	*bounds = b;
	params_scale_largest_beta_to_1(&q);
	return q;
}

/* Lists the measured passings.  h is taken midway between the measured passing
 * and the fit's, because either may be an outlier. */
static void
list_measured_passings(
    struct sampler *s, const struct misfit *m, const double *d)
{
	s->n_cell = m->n_residual;
	s->cell = xcalloc(s->n_cell, sizeof *s->cell);
	s->measured = xcalloc_doubles(s->n_cell);
	for (size_t r = 0, k = 0; r < m->n_run; r++)
		for (size_t i = 0; i < m->run[r].n; i++, k++) {
			double P = m->run[r].measured[i] + d[k] / 2;
			s->measured[k] = m->run[r].measured[i];
			s->cell[k] = (struct cell){.run = r,
			    .log_size = el_log(m->run[r].sieve[i]),
			    .t = discrepancy_speed_to_coordinate(
				m->run[r].speed, s->coordinates.middle),
			    .h = discrepancy_scale_at_passing(P)};
		}
}

static void
allocate_sampler(struct sampler *s)
{
	size_t n = s->n_cell;
	for (size_t j = 0; j < s->of->n; j++)
		s->theta[j] = xcalloc_doubles(HALF);
	s->difference = xcalloc_doubles(n * HALF);
	s->misfit = xcalloc_doubles(HALF);
	s->scheme = xcalloc_doubles(n);
	for (size_t i = 0; i < CHAINS + HALF; i++) {
		struct chain *c =
		    i < CHAINS ? &s->chain[i] : &s->trial[i - CHAINS];
		c->U = xcalloc_doubles(covariance_factor_size(s->covariance));
		c->d = xcalloc_doubles(n);
	}
}

/* Computes the kernel's error at the fit: the exact differences d minus the
 * kernel's. */
static void
compute_kernel_error_at_fit(struct sampler *s, const double *d)
{
	struct kernel_out out = {
	    .misfit = s->misfit, .difference = s->difference, .stride = HALF};
	for (size_t j = 0; j < s->of->n; j++)
		for (size_t i = 0; i < KERNEL_LANES; i++)
			s->theta[j][i] = s->fit.at[j];
	kernel_evaluate_candidates(s->kernel, (const double *const *)s->theta,
	    0, KERNEL_LANES, 0, &out);
	for (size_t k = 0; k < s->n_cell; k++)
		s->scheme[k] = d[k] - s->difference[k * HALF];
}

/* Returns the largest number of trials at a time that leaves no thread idle:
 * among more trials, the kernel finds more that are alike. */
static size_t
choose_trial_batch_size(unsigned threads)
{
	size_t part = HALF;
	while (part > PART && part * threads > HALF)
		part /= 2;
	return part;
}

static struct sampler *
sampler_new(struct misfit *m, const struct params *fit,
    const struct bounds *bounds, const struct posterior_options *o)
{
	struct sampler *s = xcalloc(1, sizeof *s);
	double *d = xcalloc_doubles(m->n_residual), origin[COORDINATES] = {0};
	size_t f = m->of->strength;
	s->of = m->of;
	s->fit = *fit;
	s->bounds = *bounds;
	s->seed = o->seed;
	s->noise = o->noise;
	s->isa = isa_usable_or_best(o->isa);
	s->coordinates = coordinates_new_about_fit(
	    fit, bounds, &m->settings, el_log(mean_energy_of_runs(m)));
	s->two = bounds->upper[f + 1] > bounds->lower[f + 1];
	s->sensitivity = sensitivity_of_misfit(m, fit, bounds, true, NULL);
	double squares = misfit_weighted_differences(m, fit, d);
	s->rms = fmax(sqrt(squares / (double)m->n_residual), 0.001);
	s->kernel = kernel_new(m, o->isa, o->threads);
	s->pool = pool_new(o->threads);
	s->part = choose_trial_batch_size(o->threads);
	list_measured_passings(s, m, d);
	s->covariance = covariance_new(s->isa, s->cell, s->n_cell);
	allocate_sampler(s);
	coordinates_from_params(&s->coordinates, fit->at, origin);
	for (size_t kind = 0; kind < 2; kind++)
		guide_init(&s->guide[kind], COORDINATES, origin);
	compute_kernel_error_at_fit(s, d);
	free(d);
	return s;
}

static void
sampler_free(struct sampler *s)
{
	for (size_t i = 0; i < CHAINS + HALF; i++) {
		struct chain *c =
		    i < CHAINS ? &s->chain[i] : &s->trial[i - CHAINS];
		free(c->U);
		free(c->d);
	}
	for (size_t j = 0; j < PARAMS_MOST; j++)
		free(s->theta[j]);
	kernel_free(s->kernel);
	pool_free(s->pool);
	covariance_free(s->covariance);
	free(s->cell);
	free(s->measured);
	free(s->difference);
	free(s->misfit);
	free(s->scheme);
	free(s);
}

struct posterior_run {
	struct site *site; /* with smooth feeds */
	struct posterior *p, *batch;
	struct thin *thin;
	struct misfit *m;
	struct sampler *s;
	struct sums *sums;
};

static struct site *
copy_site_with_smooth_feeds(const struct site *site)
{
	struct site *copy = site_copy(site);
	for (size_t r = 0; r < copy->n_run; r++) {
		struct psd curve = psd_add_points_on_cubic(&copy->run[r].feed);
		psd_free(&copy->run[r].feed);
		copy->run[r].feed = curve;
	}
	return copy;
}

/* Returns marks [n_run] of the runs that inform the draws.  The caller frees
 * them. */
static bool *
mark_runs_informing_posterior(const struct site *site, const bool *use)
{
	size_t n = 0, at = 0, next = 0;
	bool *taken = xcalloc(site->n_run, sizeof *taken);
	for (size_t r = 0; r < site->n_run; r++)
		n += use[r] && misfit_count_covered_sieves(&site->run[r]) > 0;
	for (size_t r = 0; r < site->n_run; r++) {
		if (!use[r] || misfit_count_covered_sieves(&site->run[r]) == 0)
			continue;
		taken[r] = n <= POSTERIOR_RUNS ||
			   at == next * (n - 1) / (POSTERIOR_RUNS - 1);
		next += taken[r];
		at++;
	}
	return taken;
}

static void
allocate_discrepancy_draws(struct posterior *p)
{
	for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
		p->term[j] = xcalloc_doubles(p->n_knot * POSTERIOR_DRAWS);
	p->error = xcalloc_doubles(p->n_knot * POSTERIOR_DRAWS);
}

static void
free_discrepancy_draws(struct posterior *p)
{
	for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
		free(p->term[j]);
	free(p->error);
}

/* Lists the speeds of the runs, each once, because there may be repeats. */
static void
list_run_speeds(struct posterior *p, const struct misfit *m)
{
	for (double last = 0, next;; last = next) {
		next = INFINITY;
		for (size_t r = 0; r < m->n_run; r++)
			if (m->run[r].speed > last)
				next = fmin(next, m->run[r].speed);
		if (isinf(next))
			break;
		p->speed[p->n_speed++] = next;
	}
}

struct posterior_run *
posterior_begin_sampling(const struct site *measured, const struct params *fit,
    const struct posterior_options *o)
{
	struct site *site = copy_site_with_smooth_feeds(measured);
	struct posterior *p = xcalloc(1, sizeof *p);
	struct bounds bounds = o->bounds;
	bool *use = mark_runs_informing_posterior(site, o->use);
	struct misfit *m = misfit_new(site, use, NULL, false, o->settings);
	p->settings = o->settings;
	p->fit = widen_to_model_with_gamma(
	    fit, mean_energy_of_runs(m), &p->settings, &bounds);
	p->bounds = bounds;
	misfit_free(m);
	m = misfit_new(site, use, NULL, false, p->settings);
	free(use);
	size_t most = COVARIANCE_FEW / m->n_run;
	misfit_limit_sieves_per_run(m, most < LEAST ? LEAST : most);
	struct sampler *s = sampler_new(m, &p->fit, &bounds, o);
	p->n_cell = s->n_cell;
	p->middle = s->coordinates.middle;
	p->speed_sd = o->speed_sd;
	site_default_speed_range(site, &p->from, &p->to);
	list_run_speeds(p, m);
	make_log_size_knots(p, site, s);
	allocate_discrepancy_draws(p);
	struct posterior_run *run = xcalloc(1, sizeof *run);
	*run = (struct posterior_run){site, p, NULL,
	    thin_new(measured, BATCHES), m, s, xcalloc(1, sizeof *run->sums)};
	run->batch = xcalloc(BATCHES, sizeof *run->batch);
	for (size_t b = 0; b < BATCHES; b++) {
		run->batch[b] = *p;
		allocate_discrepancy_draws(&run->batch[b]);
	}
	return run;
}

/* Returns the number of draws that each chain should have made by now. */
static size_t
count_draws_due_per_chain(const struct sampler *s)
{
	return (size_t)(s->generation - WARM_UP) * DRAWS_EACH / KEPT;
}

static void
make_draws_of_some_chains(void *data, size_t part, unsigned thread)
{
	struct posterior_run *run = data;
	struct sampler *s = run->s;
	size_t which = count_draws_due_per_chain(s) - 1,
	       first = which % 2 * CHAINS;
	(void)thread;
	for (size_t i = part * PART; i < (part + 1) * PART; i++) {
		struct noise noise = {s->isa,
		    rng_make_key(s->seed, which / 2 * CHAINS + i, USE_DRAW), 0,
		    first == 0 ? 1 : -1};
		make_posterior_draw(
		    s, &run->batch[which / 2], &s->chain[i], noise, first + i);
	}
}

static void
make_draws_of_each_chain(struct posterior_run *run)
{
	pool_run(run->s->pool, CHAINS / PART, make_draws_of_some_chains, run);
	size_t n = count_draws_due_per_chain(run->s);
	if (n % 2 == 0)
		thin_add_posterior_batch(run->thin, &run->batch[n / 2 - 1]);
}

static void
choose_posterior_draws(struct posterior_run *run)
{
	enum { N = POSTERIOR_DRAWS };
	struct posterior *p = run->p;
	size_t chosen[N];
	thin_choose_draws(run->thin, chosen);
	for (size_t d = 0; d < N; d++) {
		const struct posterior *b = &run->batch[chosen[d] / N];
		size_t from = chosen[d] % N;
		p->draw[d] = b->draw[from];
		for (size_t k = 0; k < p->n_knot * N; k += N) {
			for (size_t j = 0; j < DISCREPANCY_TERMS; j++)
				p->term[j][k + d] = b->term[j][k + from];
			p->error[k + d] = b->error[k + from];
		}
	}
}

static void
update_proposal_guides(struct sampler *s)
{
	double most = s->generation <= WARM_UP ? RECENT : KEPT;
	double told = fmin(s->told + 1, most);
	double keep = s->told > 0 ? (told - 1) / s->told : 0;
	const double *x[2][CHAINS];
	size_t n[2] = {0};
	for (size_t i = 0; i < CHAINS; i++) {
		size_t kind = has_two_strengths(s, s->chain[i].x);
		x[kind][n[kind]++] = s->chain[i].x;
	}
	for (size_t kind = 0; kind < 2; kind++)
		guide_add_generation(&s->guide[kind], x[kind], n[kind],
		    (double)n[kind] / CHAINS, keep);
	s->told = told;
}

bool
posterior_step(struct posterior_run *run)
{
	struct sampler *s = run->s;
	if (s->generation == WARM_UP + KEPT)
		return true;
	if (!s->started) {
		start_half_of_chains(s);
		return false;
	}
	if (!move_half_of_chains(s))
		return false;
	if (s->generation % RUNG == 0 && s->share < 1)
		resample_tempered_chains(s, fmin(1, RISE * s->share));
	update_proposal_guides(s);
	if (s->generation <= WARM_UP) {
		s->accepted = s->tried = 0;
		return false;
	}
	add_chains_to_sums(run->sums, s);
	if ((s->generation - WARM_UP) % (KEPT / DRAWS_EACH) == 0)
		make_draws_of_each_chain(run);
	if (s->generation < WARM_UP + KEPT)
		return false;
	choose_posterior_draws(run);
	lack_of_fit_compute(run->p, run->m);
	thin_set_linear_draw_share(run->thin, run->p);
	lack_of_fit_add_smooth_part(run->p, run->m);
	measure_chain_convergence(run->p, s, run->sums);
	return true;
}

struct posterior *
posterior_end(struct posterior_run *run)
{
	if (run == NULL)
		return NULL;
	struct posterior *p = run->p;
	bool done = run->s->generation == WARM_UP + KEPT;
	for (size_t b = 0; b < BATCHES; b++)
		free_discrepancy_draws(&run->batch[b]);
	free(run->batch);
	thin_free(run->thin);
	sampler_free(run->s);
	misfit_free(run->m);
	site_free(run->site);
	free(run->sums);
	free(run);
	if (done)
		return p;
	posterior_free(p);
	return NULL;
}

struct posterior *
posterior_new(const struct site *site, const struct params *fit,
    const struct posterior_options *o)
{
	struct posterior_run *run = posterior_begin_sampling(site, fit, o);
	while (!posterior_step(run) && (o->stop == NULL || !o->stop()))
		;
	return posterior_end(run);
}

void
posterior_free(struct posterior *p)
{
	if (p == NULL)
		return;
	free_discrepancy_draws(p);
	free(p->lack);
	free(p->knot);
	free(p);
}
