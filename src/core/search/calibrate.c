/* Search, then polish: generations of the genetic algorithm on the batch
 * kernel, then bounded least squares on the accurate product from several
 * starts.
 *
 * The genetic algorithm finds the region; the polish finds the optimum.  One
 * start is not enough: p(u) is clipped at 0, and each pattern of its zeros has
 * a valley of its own.  So, besides the best of the last generation, the
 * leaders of two early generations, when the population still spans several
 * valleys, are also starts.  Then perturbations of the overall best are tried
 * until none helps.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/search/calibrate.h"

#include <assert.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
#include "base/xalloc.h"
#include "core/numeric/elementary.h"
#include "core/search/ga.h"
#include "core/search/kernel.h"
#include "core/search/polish.h"
#include "core/search/settle.h"
#include "core/numeric/rng.h"

enum {
	SCOUTS = 16,             /* leaders kept from each early generation */
	STARTS = 2 * SCOUTS + 2, /* plus the best of each of the two phases */
	BATCH = 8,          /* starts or perturbations polished side by side */
	LEADERS = 64,       /* SCOUTS are spread over the best this many */
	POLISH_MOST = 1000, /* evaluations of a polish */
	POLISH_HELD = 30,   /* with a parameter held */
	PLACES = 8,         /* values at which a parameter is held */
	PERTURBATIONS = 64, /* fruitless in a row: end the polish */
	PERTURBATIONS_IN_NOISE = 256, /* if the misfit is mostly noise */
	/* Where the misfit falls more and more slowly, as on the ridge of
	 * E0_min, alpha and f_mat, a polish can still gain a few times its last
	 * gain; in noise, more.  These limits are for struct polish_rival. */
	GAINS = 16,
	GAINS_IN_NOISE = 200,
	EARLIEST = 25, /* generations before the stop rules apply */
	USE_PERTURBATION = 1 << 20
};

/* The workspace for polishing one start in parallel with others. */
struct worker {
	struct misfit *misfit;
	struct polish *polish;
	struct params p;
	struct bounds first; /* of a first polish, with a parameter held */
	bool holds;
	struct polish_result result;
};

struct calibration {
	struct calibrate_options options;
	struct misfit *misfit;
	struct pool *pool;
	struct kernel *kernel;
	struct ga *ga;
	struct worker worker[BATCH];
	double *told;
	size_t elite; /* candidates that a generation keeps from the last */
	enum calibrate_state state, stop;
	atomic_bool stopped; /* options.stop ended the current step */
	size_t stall, evaluations;
	size_t edits, edited_at; /* changes of the bounds; generation of the
				  * last */
	/* First phase: a larger model is calibrated as the smaller. */
	bool nested;
	struct bounds box; /* bounds of the current phase */
	size_t phase_from; /* generation at which it began */
	size_t batches;    /* batches polished before it */
	double stall_from;
	struct params start[STARTS];
	size_t n_start, done, perturbations, fruitless;
	size_t n_history, history_room;
	struct calibrate_generation *history;
	struct params best;
	double best_misfit; /* accurate; INFINITY during the search */
	bool converged;     /* the polish of the best converged */
};

static const size_t SCOUT_GENERATION[2] = {6, 11};

struct calibrate_options
calibrate_options_default(void)
{
	return (struct calibrate_options){.seed = 1,
	    .population = 8000,
	    .generations = 800,
	    .stall = 20,
	    .tolerance = 0.05,
	    .polish = true,
	    .threads = 1,
	    .isa = ISA_BEST,
	    .bounds = bounds_default(0),
	    .settings = model_settings_default()};
}

const char *
calibrate_state_name(enum calibrate_state state)
{
	static const char *const NAMES[] = {"searching", "polishing",
	    "tolerance", "stall", "generations", "stopped"};
	return NAMES[state];
}

struct misfit *
calibrate_make_misfit(
    const struct site *site, const struct calibrate_options *options)
{
	FREED bool *train = xcalloc(site->n_run, sizeof *train);
	if (options->train == NULL)
		misfit_mark_default_training(site, train);
	struct misfit *m =
	    misfit_new(site, options->train != NULL ? options->train : train,
		options->run_weight, options->by_sd, options->settings);
	m->stop = options->stop;
	return m;
}

/* Holds a model's reference energy, if it has one, at the mean of the training
 * runs, unless the bounds give another (D12). */
static void
fix_reference_energy(const struct misfit *m, struct bounds *b)
{
	size_t j = m->of->reference;
	double sum = 0;
	for (size_t r = 0; r < m->n_run; r++)
		sum += specific_energy_at_speed(m->run[r].speed);
	if (j < m->of->n && !(b->upper[j] > 0))
		b->lower[j] = b->upper[j] = sum / (double)m->n_run;
}

/* A model may extend another by parameters that have no effect at their start
 * values.  It is calibrated first with these held there, then with all free.
 * Otherwise it may end in a distant valley, worse than the smaller model's
 * best: with gamma at its bound, grunditz-energy had three times the misfit of
 * the paper's model. */
static void
begin_with_simpler_model(struct calibration *c)
{
	const struct breakage *of = c->misfit->of;
	struct bounds *b = &c->box;
	c->box = c->options.bounds;
	for (size_t j = of->gauge; j < of->n; j++) {
		double start = of->parameter[j].start;
		if (!(start >= b->lower[j] && start <= b->upper[j]) ||
		    b->lower[j] >= b->upper[j])
			continue;
		b->lower[j] = b->upper[j] = start;
		c->nested = true;
	}
}

/* The scale of the gauge is free (D4).  At half the largest scale that its
 * bounds allow, perturbations reach all directions equally. */
static void
rescale_betas_to_mid_bounds(const struct bounds *b, struct params *p)
{
	double reach = INFINITY;
	size_t gauge = breakage_model_of_params(p)->gauge;
	for (size_t j = 0; j < gauge; j++)
		reach = fmin(reach, fmin(b->upper[j], -b->lower[j]));
	if (!(reach > 0))
		return;
	params_scale_largest_beta_to_1(p);
	for (size_t j = 0; j < gauge; j++)
		p->at[j] *= reach / 2;
}

/* Rescales the gauge so that the bounds cut off as little as possible (D4), and
 * moves all parameters inside the bounds. */
static void
scale_betas_into_bounds(const struct bounds *b, struct params *p)
{
	rescale_betas_to_mid_bounds(b, p);
	for (size_t j = 0; j < breakage_model_of_params(p)->n; j++)
		p->at[j] = fmin(fmax(p->at[j], b->lower[j]), b->upper[j]);
}

/* Skips the first phase, because its best result is given.  Polishing this at
 * once was tried: it took a third less time, but of 32 fits to plants with
 * gamma, one ended at 3.6 times the lowest misfit. */
static void
skip_first_calibration_phase(struct calibration *c, const struct params *start)
{
	c->best =
	    breakage_params_in_wider_model(start, c->options.settings.breakage);
	c->nested = false;
	c->box = c->options.bounds;
	scale_betas_into_bounds(&c->box, &c->best);
	c->best_misfit = misfit_of_params(c->misfit, &c->best);
	c->start[c->n_start++] = c->best;
}

struct calibration *
calibration_new(
    const struct site *site, const struct calibrate_options *options)
{
	struct calibration *c = xcalloc(1, sizeof *c);
	struct ga_options ga = ga_options_default();
	c->options = *options;
	c->best_misfit = INFINITY;
	c->pool = pool_new(options->threads);
	c->misfit = calibrate_make_misfit(site, options);
	fix_reference_energy(c->misfit, &c->options.bounds);
	assert(c->misfit->n_residual > 0);
	c->kernel =
	    kernel_new(c->misfit, options->isa, pool_count_threads(c->pool));
	if (options->plain)
		ga = ga_options_textbook();
	ga.population = options->population;
	ga.seed = options->seed;
	ga.isa = options->isa;
	if (ga.elite > ga.population / 4)
		ga.elite = ga.population / 4;
	begin_with_simpler_model(c);
	if (options->start != NULL)
		skip_first_calibration_phase(c, options->start);
	c->elite = ga.elite;
	c->ga = ga_new(&ga, c->misfit->of->n, c->box.lower, c->box.upper);
	for (size_t i = 0; i < BATCH; i++) {
		c->worker[i].misfit = calibrate_make_misfit(site, options);
		c->worker[i].polish = polish_new(c->worker[i].misfit);
	}
	c->told = xcalloc_doubles(options->population);
	c->stall_from = INFINITY;
	return c;
}

void
calibration_free(struct calibration *c)
{
	if (c == NULL)
		return;
	for (size_t i = 0; i < BATCH; i++) {
		polish_free(c->worker[i].polish);
		misfit_free(c->worker[i].misfit);
	}
	ga_free(c->ga);
	kernel_free(c->kernel);
	pool_free(c->pool);
	misfit_free(c->misfit);
	free(c->told);
	free(c->history);
	free(c);
}

/* Returns the number of batches polished so far.  The last batch of starts may
 * be a short one. */
static size_t
count_polished_batches(const struct calibration *c)
{
	size_t starts = c->done < c->n_start ? c->done : c->n_start;
	return c->batches + (starts + BATCH - 1) / BATCH +
	       (c->done - starts) / BATCH;
}

static struct params
best_params_of_search(const struct calibration *c)
{
	struct params p = {.breakage = c->options.settings.breakage};
	memcpy(p.at, ga_best_genes(c->ga), c->misfit->of->n * sizeof *p.at);
	return p;
}

static struct params
params_of_genes(
    const struct calibration *c, const double *const *gene, size_t i)
{
	struct params p = {.breakage = c->options.settings.breakage};
	for (size_t j = 0; j < c->misfit->of->n; j++)
		p.at[j] = gene[j][i];
	return p;
}

static void
choose_starts_for_polish(struct calibration *c)
{
	const uint32_t *ranking = ga_get_candidate_ranking(c->ga);
	size_t n = c->options.population;
	size_t leaders = n < LEADERS ? n : LEADERS;
	for (size_t i = 0; i < SCOUTS; i++)
		c->start[c->n_start++] =
		    params_of_genes(c, ga_genes_of_last_generation(c->ga),
			ranking[i * leaders / SCOUTS]);
}

/* Ends the calibration or, after the first phase, continues from its result
 * with all parameters. */
static void
end_calibration_phase(struct calibration *c)
{
	bool used = ga_status(c->ga).generation >= c->options.generations;
	if (!c->nested || used) {
		if (c->converged &&
		    settle_at_stationary_point(c->misfit, &c->box, &c->best))
			c->best_misfit = misfit_of_params(c->misfit, &c->best);
		c->state = c->stop;
		return;
	}
	c->nested = false;
	c->box = c->options.bounds;
	c->phase_from = ga_status(c->ga).generation;
	c->batches = count_polished_batches(c);
	c->converged = false;
	c->stall = c->done = c->fruitless = 0;
	c->stall_from = INFINITY;
	c->start[0] = c->best;
	c->n_start = 1;
	ga_set_bounds(c->ga, c->box.lower, c->box.upper);
	c->state = CALIBRATE_SEARCHING;
}

static void
update_best_params(struct calibration *c, const struct params *found)
{
	double misfit = misfit_of_params(c->misfit, found);
	if (c->best_misfit < misfit)
		return;
	c->best = *found;
	c->best_misfit = misfit;
	c->converged = false;
}

/* Ends the search and begins the polish, with the search's best as a further
 * start. */
static void
end_search_begin_polish(struct calibration *c, enum calibrate_state why)
{
	struct params found = best_params_of_search(c);
	c->stop = why;
	update_best_params(c, &found);
	c->start[c->n_start++] = found;
	c->state = CALIBRATE_POLISHING;
	if (!c->options.polish)
		end_calibration_phase(c);
}

static void
record_generation(struct calibration *c, const struct ga_status *s)
{
	if (c->n_history == c->history_room) {
		c->history_room = 2 * c->history_room + 64;
		c->history =
		    xrealloc(c->history, c->history_room, sizeof *c->history);
	}
	struct calibrate_generation *g = &c->history[c->n_history++];
	*g = (struct calibrate_generation){.best = s->best,
	    .median = s->median,
	    .params = best_params_of_search(c)};
	const double *const *told = ga_genes_of_last_generation(c->ga);
	size_t elite = c->elite, n = c->options.population - elite;
	g->n_kept = n < CALIBRATE_KEPT ? n : CALIBRATE_KEPT;
	for (size_t j = 0; j < c->misfit->of->n; j++) {
		ga_quantiles_of_gene(c->ga, j, &g->p10[j], &g->p90[j]);
		for (size_t i = 0; i < g->n_kept; i++)
			g->kept[j][i] = (float)told[j][elite + i];
	}
}

const struct calibrate_generation *
calibration_generation_history(const struct calibration *c, size_t *n)
{
	*n = c->n_history;
	return c->history;
}

/* Makes and evaluates a part of the generation. */
static void
evaluate_generation_part(void *data, size_t part, unsigned thread)
{
	struct calibration *c = data;
	size_t from = part * KERNEL_PART, to = from + KERNEL_PART;
	if (misfit_should_stop(c->misfit))
		atomic_store(&c->stopped, true);
	if (atomic_load(&c->stopped))
		return;
	to = to < c->options.population ? to : c->options.population;
	kernel_evaluate_candidates(c->kernel,
	    ga_next_candidates_subset(c->ga, from, to), from, to, thread,
	    &(struct kernel_out){.misfit = c->told});
}

static void
run_search_generation(struct calibration *c)
{
	const struct calibrate_options *o = &c->options;
	size_t parts = (o->population + KERNEL_PART - 1) / KERNEL_PART;
	pool_run(c->pool, parts, evaluate_generation_part, c);
	if (atomic_load(&c->stopped))
		return;
	ga_set_misfits(c->ga, c->told);
	struct ga_status s = ga_status(c->ga);
	record_generation(c, &s);
	c->evaluations += o->population;
	c->stall++;
	if (s.best < 0.999 * c->stall_from) {
		c->stall_from = s.best;
		c->stall = 0;
	}
	for (size_t i = 0; i < 2 && o->polish; i++)
		if (s.generation == c->phase_from + SCOUT_GENERATION[i])
			choose_starts_for_polish(c);
	/* Where the misfit is flat, all candidates are alike at once, before
	 * the search has looked around; so early generations do not count.
	 * With a perfect fit, both misfits are near 0, and the last term ends
	 * the search. */
	bool together = s.median - s.best <= o->tolerance * s.best + 1e-16;
	size_t since =
	    c->edited_at > c->phase_from ? c->edited_at : c->phase_from;
	bool early = s.generation - since < EARLIEST;
	if (s.generation >= o->generations)
		end_search_begin_polish(c, CALIBRATE_GENERATIONS);
	else if (!early && o->tolerance > 0 && together)
		end_search_begin_polish(c, CALIBRATE_TOLERANCE);
	else if (!early && o->stall > 0 && c->stall >= o->stall)
		end_search_begin_polish(c, CALIBRATE_STALLED);
}

/* Returns a point at some distance from the best: most parameters move little,
 * a few far. */
static struct params
perturb_best_params(const struct calibration *c, size_t number)
{
	const struct bounds *b = &c->box;
	struct rng_key key =
	    rng_make_key(c->options.seed, number, USE_PERTURBATION);
	struct params p = c->best;
	size_t n = c->misfit->of->n;
	for (size_t j = 0; j < n; j++) {
		double v = 2 * rng_uniform(key, (uint32_t)j) - 1;
		double size = rng_uniform(key, (uint32_t)(j + n));
		double x =
		    p.at[j] + (b->upper[j] - b->lower[j]) * size * v * v * v;
		p.at[j] = fmin(fmax(x, b->lower[j]), b->upper[j]);
	}
	return p;
}

/* Returns a value at which to hold parameter j: in the gauge, a share of the
 * largest; otherwise, one of PLACES evenly spaced between the bounds, on a log
 * scale if these are above 0. */
static double
nth_value_to_hold_parameter(
    const struct calibration *c, size_t j, size_t number)
{
	static const double SHARE[PLACES] = {
	    -1, -0.1, -0.01, 0, 0.001, 0.003, 0.03, 0.3};
	double lower = c->box.lower[j], upper = c->box.upper[j];
	double at = ((double)number + 0.5) / PLACES;
	if (j < c->misfit->of->gauge)
		return fmin(fmax(SHARE[number] * upper / 2, lower), upper);
	return lower > 0 ? lower * el_exp(at * el_log(upper / lower))
			 : lower + at * (upper - lower);
}

/* Makes perturbation `number` of those that hold one parameter (the first of
 * the gauge, or one outside it) while the others are polished, and then release
 * it.  Random perturbations rarely reach far along the ridge of E0_min, alpha
 * and f_mat, which has a valley wherever the break size of a run crosses a
 * sieve of its feed, or the narrow valleys with little ultra-fines (beta1 just
 * above 0).  Returns false if there are no more. */
static bool
perturb_params_with_one_fixed(
    const struct calibration *c, size_t number, struct worker *w)
{
	size_t j = 0, gauge = c->misfit->of->gauge;
	w->first = c->box;
	w->p = c->best;
	for (size_t nth = 0; j < c->misfit->of->n; j++)
		if ((j == 0 || j >= gauge) &&
		    c->box.lower[j] < c->box.upper[j] &&
		    number / PLACES == nth++)
			break;
	if (j == c->misfit->of->n)
		return false;
	w->p.at[j] = nth_value_to_hold_parameter(c, j, number % PLACES);
	w->first.lower[j] = w->first.upper[j] = w->p.at[j];
	return true;
}

static void
update_best_from_result(
    struct calibration *c, const struct worker *w, bool perturbing)
{
	double gain = c->best_misfit - w->result.misfit;
	double next_to_nothing = 1e-9 * c->best_misfit;
	c->evaluations += (size_t)w->result.evaluations;
	c->fruitless += perturbing;
	c->perturbations += perturbing;
	if (w->result.converged && gain > -next_to_nothing)
		c->converged = true;
	else if (gain > next_to_nothing)
		c->converged = false;
	if (!(gain > 0))
		return;
	c->best_misfit = w->result.misfit;
	c->best = w->p;
	rescale_betas_to_mid_bounds(&c->box, &c->best);
}

/* True if the misfit is more than half that of product = feed.  Noise makes
 * many shallow valleys, which need more perturbations, and the descent along
 * them is slow. */
static bool
is_misfit_mostly_noise(const struct calibration *c)
{
	return c->best_misfit > misfit_of_feed_as_product(c->misfit) / 2;
}

static size_t
limit_of_fruitless_perturbations(const struct calibration *c)
{
	return is_misfit_mostly_noise(c) ? PERTURBATIONS_IN_NOISE
					 : PERTURBATIONS;
}

static void
polish_one_start(void *data, size_t i, unsigned thread)
{
	(void)thread;
	struct calibration *c = data;
	struct worker *w = &c->worker[i];
	bool perturbing = c->done >= c->n_start;
	struct polish_rival best = {c->best_misfit, INFINITY};
	int before = 0;
	if (perturbing)
		best.gains = is_misfit_mostly_noise(c) ? GAINS_IN_NOISE : GAINS;
	w->result.stopped = false;
	if (w->holds) {
		w->result = polish_minimise_misfit(
		    w->polish, &w->first, POLISH_HELD, NULL, &w->p);
		before = w->result.evaluations;
	}
	if (!w->result.stopped)
		w->result =
		    polish_minimise_misfit(w->polish, &c->box, POLISH_MOST,
			perturbing || c->converged ? &best : NULL, &w->p);
	w->result.evaluations += before;
	if (w->result.stopped)
		atomic_store(&c->stopped, true);
}

/* Polishes the next batch of starts, or of perturbations of the best.  The size
 * of a batch does not depend on the number of threads, so the result does not
 * either. */
static void
polish_next_batch(struct calibration *c)
{
	bool perturbing = c->done >= c->n_start;
	size_t left = c->n_start - c->done;
	size_t n = perturbing || left > BATCH ? BATCH : left;
	double before = c->best_misfit;
	for (size_t i = 0; i < n; i++) {
		struct worker *w = &c->worker[i];
		w->holds = perturbing && perturb_params_with_one_fixed(
					     c, c->fruitless + i, w);
		if (!perturbing)
			w->p = c->start[c->done + i];
		else if (!w->holds)
			w->p = perturb_best_params(c, c->perturbations + i);
	}
	pool_run(c->pool, n, polish_one_start, c);
	if (atomic_load(&c->stopped))
		return;
	for (size_t i = 0; i < n; i++)
		update_best_from_result(c, &c->worker[i], perturbing);
	c->done += n;
	if (c->best_misfit < before * (1 - 1e-7))
		c->fruitless = 0;
	if (c->fruitless >= limit_of_fruitless_perturbations(c))
		end_calibration_phase(c);
}

enum calibrate_state
calibration_step(struct calibration *c)
{
	atomic_store(&c->stopped, false);
	if (c->state == CALIBRATE_SEARCHING)
		run_search_generation(c);
	else if (c->state == CALIBRATE_POLISHING)
		polish_next_batch(c);
	return c->state;
}

void
calibration_set_bounds(struct calibration *c, const struct bounds *bounds)
{
	assert(c->state <= CALIBRATE_POLISHING);
	c->options.bounds = *bounds;
	fix_reference_energy(c->misfit, &c->options.bounds);
	bounds = &c->options.bounds;
	c->edits++;
	c->edited_at = ga_status(c->ga).generation;
	c->nested = false;
	c->box = *bounds;
	c->stall = 0;
	c->stall_from = INFINITY;
	ga_set_bounds(c->ga, bounds->lower, bounds->upper);
	for (size_t i = 0; i < c->n_start; i++)
		scale_betas_into_bounds(bounds, &c->start[i]);
	if (isfinite(c->best_misfit)) {
		scale_betas_into_bounds(bounds, &c->best);
		c->converged = false;
		c->best_misfit = misfit_of_params(c->misfit, &c->best);
	}
	if (c->state == CALIBRATE_SEARCHING)
		return;
	c->done = c->fruitless = 0;
}

/* Returns the best so far, which may be from the first phase. */
static struct params
best_params_so_far(const struct calibration *c, double searched)
{
	bool search = c->state == CALIBRATE_SEARCHING;
	return search && !(c->best_misfit < searched) ? best_params_of_search(c)
						      : c->best;
}

struct calibrate_status
calibration_status(const struct calibration *c)
{
	if (c == NULL)
		return (struct calibrate_status){.generation = 0};
	struct ga_status s = ga_status(c->ga);
	struct calibrate_status status = {.state = c->state,
	    .generation = s.generation,
	    .step = s.generation + count_polished_batches(c),
	    .evaluations = c->evaluations,
	    .best = fmin(s.best, c->best_misfit),
	    .median = s.median,
	    .worst = s.worst,
	    .starts_done = c->done,
	    .starts = c->n_start,
	    .trials = c->fruitless,
	    .trials_most = limit_of_fruitless_perturbations(c),
	    .params = best_params_so_far(c, s.best)};
	/* The bounds have changed, and nothing has been evaluated within
	 * them. */
	if (isinf(status.best) && s.generation > 0)
		status.best = misfit_of_params(c->misfit, &status.params);
	params_scale_largest_beta_to_1(&status.params);
	return status;
}

double
calibration_sum_squared_weights(const struct calibration *c)
{
	double sum = 0;
	for (size_t r = 0; r < c->misfit->n_run; r++)
		for (size_t i = 0; i < c->misfit->run[r].n; i++)
			sum += c->misfit->run[r].weight[i] *
			       c->misfit->run[r].weight[i];
	return sum;
}

const struct bounds *
calibration_bounds(const struct calibration *c)
{
	return &c->options.bounds;
}

struct fit
calibration_best_fit(struct calibration *c)
{
	struct ga_status s = ga_status(c->ga);
	struct params p = best_params_so_far(c, s.best);
	struct fit fit = {.misfit = misfit_of_params(c->misfit, &p),
	    .rmse = misfit_rmse(c->misfit, &p),
	    .feed_misfit = misfit_of_feed_as_product(c->misfit),
	    .n_residual = c->misfit->n_residual,
	    .cells = misfit_count_changeable_passings(c->misfit),
	    .stop =
		c->state >= CALIBRATE_TOLERANCE ? c->stop : CALIBRATE_STOPPED,
	    .generations = s.generation,
	    .evaluations = c->evaluations,
	    .perturbations = c->perturbations,
	    .converged = c->converged,
	    .plain = c->options.plain && !c->options.polish,
	    .edits = c->edits,
	    .edited_at = c->edited_at,
	    .seed = c->options.seed,
	    .population = c->options.population,
	    .settings = c->options.settings};
	for (size_t j = 0; j < c->misfit->of->n; j++) {
		const struct bounds *b = &c->options.bounds;
		fit.on_bound[j] = sensitivity_is_param_on_bound(b, &p, j);
		fit.parameters += b->lower[j] < b->upper[j];
	}
	params_scale_largest_beta_to_1(&p);
	fit.flat =
	    sensitivity_flattest_direction(c->misfit, &p, &c->options.bounds);
	fit.params = p;
	return fit;
}
