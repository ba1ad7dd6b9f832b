/* The search in progress or the history of the last one.  search: plots the
 * residuals of the candidates at each run; convergence: misfits over the
 * generations; spread: the ranges of the candidates within the bounds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots_search.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/outlook.h"
#include "cmd/draw/site_chart.h"
#include "core/model/breakage.h"
#include "core/search/candidates.h"
#include "core/search/sensitivity.h"
#include "io/sitefile/units.h"

bool
is_calibration_of_site_running(
    const struct session *s, const struct entry *entry)
{
	return s->job.calibration != NULL && s->job.fits &&
	       &s->entry[s->job.entry] == entry_without_scenario(entry);
}

static void
copy_running_search_for_plot(struct search_shown *past, const struct session *s,
    const struct entry *entry)
{
	const struct job *job = &s->job;
	struct calibrate_status st = calibration_status(job->calibration);
	past->generation =
	    calibration_generation_history(job->calibration, &past->n);
	past->bounds = calibration_bounds(job->calibration);
	past->site = entry->site;
	past->train = job->train;
	past->settings = job->options.settings;
	past->weight = calibration_sum_squared_weights(job->calibration);
	past->misfit = st.best;
	past->best = st.params;
	past->polished = st.state != CALIBRATE_SEARCHING;
	past->runs = true;
}

struct search_shown
search_of_site_to_show(const struct session *s, const struct entry *entry)
{
	struct search_shown past = {0};
	const struct history *h = entry->history;
	if (is_calibration_of_site_running(s, entry)) {
		copy_running_search_for_plot(&past, s, entry);
	} else if (h != NULL) {
		past = (struct search_shown){h->n, h->generation, &h->bounds,
		    h->site, h->train, h->fit.settings, h->weight,
		    h->fit.misfit, h->fit.params, true, false};
	}
	if (past.n == 0 || !past.polished)
		return past;
	struct params last = past.generation[past.n - 1].params;
	params_scale_largest_beta_to_1(&last);
	past.polished = memcmp(&last, &past.best, sizeof last) != 0;
	return past;
}

/* Returns the index of generation 1..n, or for 0 that of the last.  Returns n
 * with an error if there is no such generation. */
static size_t
find_generation_index(const struct entry *entry,
    const struct search_shown *past, size_t generation, struct error *error)
{
	if (past->n == 0)
		error_set(error, ERROR_USAGE,
		    "%s has not been calibrated in this session\n"
		    "run 'calibrate' first",
		    entry->site->name);
	else if (generation <= past->n)
		return generation > 0 ? generation - 1 : past->n - 1;
	else
		error_set(error, ERROR_USAGE,
		    "there is no generation %zu, only %zu", generation,
		    past->n);
	return past->n;
}

/* Returns the best candidate of generation 1..n, or for 0 the best of all. */
static struct params
best_params_of_generation(const struct search_shown *past, size_t generation)
{
	return generation > 0 ? past->generation[generation - 1].params
			      : past->best;
}

double
misfit_as_rmse_points(const struct search_shown *past, double misfit)
{
	if (misfit == 0)
		return 0;
	bool good = isfinite(misfit) && misfit > 0 && past->weight > 0;
	return good ? 100 * sqrt(misfit / past->weight) : NAN;
}

/* As misfit_as_rmse_points, but NAN for 0, which has no place on a logarithmic
 * axis. */
static double
misfit_on_log_axis(const struct search_shown *past, double misfit)
{
	double points = misfit_as_rmse_points(past, misfit);
	return points > 0 ? points : NAN;
}

bool
find_param_values_for_plot(const struct session *s,
    const struct plot_request *request, struct params *params,
    struct error *error)
{
	const struct entry *entry = request->asked.entry;
	struct search_shown past = search_of_site_to_show(s, entry);
	bool search =
	    request->generation > 0 || is_calibration_of_site_running(s, entry);
	if (search && past.n > 0) {
		if (find_generation_index(
			entry, &past, request->generation, error) == past.n)
			return false;
		*params = best_params_of_generation(&past, request->generation);
		return true;
	}
	if (!answers_require_params(s, entry, error))
		return false;
	*params = entry->params;
	return true;
}

static struct candidates
residuals_of_generation(
    const struct session *s, const struct search_shown *past, size_t generation)
{
	size_t at = generation > 0 ? generation : past->n;
	struct params best = best_params_of_generation(past, generation);
	return candidates_compute_residuals(past->site, past->train,
	    past->settings, s->isa, &past->generation[at - 1], &best);
}

/* Returns the standard deviation of a passing near 50 %, points.  Sets *assumed
 * to true if `set noise` does not state it. */
static double
sampling_noise_near_50_percent(const struct session *s, bool *assumed)
{
	*assumed = !(s->set.noise > 0);
	return *assumed ? units_fraction_to_pct(HYPER[HYPER_OWN].median)
			: s->set.noise;
}

static void
add_noise_band_to_chart(struct chart *chart, const struct session *s)
{
	bool assumed;
	double noise = sampling_noise_near_50_percent(s, &assumed);
	struct chart_series *stripe =
	    chart_append_series(chart, SITE_CHART_FEED, 2,
		assumed ? N_("noise %.2g points (assumed)")
			: N_("noise %.2g points"),
		noise);
	series_allocate_band(stripe);
	for (size_t i = 0; i < 2; i++) {
		stripe->x[i] = i == 0 ? chart->x.low : chart->x.high;
		stripe->low[i] = -noise;
		stripe->high[i] = noise;
	}
}

/* Counts the passings of the run that begins at cell `from`. */
static size_t
count_passings_of_run(const struct candidates *c, size_t from)
{
	size_t n = 0;
	while (from + n < c->n && c->cell[from + n].run == c->cell[from].run)
		n++;
	return n;
}

/* Adds the bars and the best candidate of a run, which is drawn as number nth
 * (from 0) of `runs` side by side. */
static void
add_search_candidate_bars_of_run(struct chart *chart,
    const struct candidates *c, const struct site *site, size_t from,
    size_t nth, size_t runs)
{
	static const enum chart_line LINES[] = {
	    CHART_LONG, CHART_SOLID, CHART_DOTTED};
	static const char ASCII[] = "#|:";
	size_t n = count_passings_of_run(c, from),
	       kind = nth % ARRAY_LEN(LINES);
	const struct run *run = &site->run[c->cell[from].run];
	struct chart_series look =
	    site_chart_run_style(site, c->cell[from].run, false);
	look.beside = (int)nth - (int)(runs - 1) / 2;
	char mark = look.mark;
	look.mark = 0;
	look.bars = true;
	look.line = LINES[kind];
	look.ascii = ASCII[kind];
	FREED char *speed = answers_speed_text(site, run->speed, -1);
	struct chart_series *bars = chart_append_series(
	    chart, look, n, "%s%s: middle 80 %%", speed, run->repeat);
	series_allocate_band(bars);
	for (size_t i = 0; i < n; i++) {
		bars->x[i] = units_m_to_mm(c->cell[from + i].size);
		bars->y[i] = units_fraction_to_pct(c->cell[from + i].median);
		bars->low[i] = units_fraction_to_pct(c->cell[from + i].p10);
		bars->high[i] = units_fraction_to_pct(c->cell[from + i].p90);
	}
	look.mark = mark;
	look.bars = false;
	look.line = CHART_MARKS;
	look.series = SERIES_PREDICTED;
	look.lifted = true;
	struct chart_series *best = chart_append_series(
	    chart, look, n, "%s%s: best", speed, run->repeat);
	for (size_t i = 0; i < n; i++) {
		best->x[i] = units_m_to_mm(c->cell[from + i].size);
		best->y[i] = units_fraction_to_pct(c->cell[from + i].best);
	}
}

static struct axis
sieve_axis_of_search_candidates(const struct candidates *c)
{
	const double margin = 1.1;
	FREED double *size = xcalloc_doubles(c->n);
	for (size_t k = 0; k < c->n; k++)
		size[k] = c->cell[k].size;
	struct axis axis = site_chart_sieve_axis(size, c->n);
	/* Leaves room for what is drawn beside the last sieve. */
	axis.low /= margin;
	axis.high *= margin;
	return axis;
}

/* Returns an axis that covers all candidates.  It has few possible limits, so
 * that it seldom changes while a search converges. */
static struct axis
difference_axis_of_search_candidates(const struct candidates *c)
{
	static const double MOST[] = {1, 3, 10, 30, 100};
	const double straight = 0.1;
	double most = 0;
	size_t i = 0;
	for (size_t k = 0; k < c->n; k++) {
		const struct candidates_cell *at = &c->cell[k];
		most =
		    fmax(most, fmax(fabs(at->best), fmax(-at->p10, at->p90)));
	}
	while (i + 1 < ARRAY_LEN(MOST) && units_fraction_to_pct(most) > MOST[i])
		i++;
	return axis_new_symlog(
	    tr("candidate minus measured, points"), straight, MOST[i]);
}

struct chart *
plots_candidate_residuals(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct search_shown past = search_of_site_to_show(s, q->asked.entry);
	size_t at = find_generation_index(
		   q->asked.entry, &past, q->generation, error),
	       runs = 0;
	if (at == past.n)
		return NULL;
	struct candidates c = residuals_of_generation(s, &past, q->generation);
	struct chart *chart =
	    site_chart_new(past.site, sieve_axis_of_search_candidates(&c),
		difference_axis_of_search_candidates(&c),
		q->generation == 0 && past.polished
		    ? N_("generation %zu of %zu, polished")
		    : N_("generation %zu of %zu"),
		at + 1, past.n);
	add_noise_band_to_chart(chart, s);
	for (size_t k = 0; k < c.n; k += count_passings_of_run(&c, k))
		runs++;
	for (size_t k = 0, nth = 0; k < c.n;
	     k += count_passings_of_run(&c, k), nth++)
		add_search_candidate_bars_of_run(
		    chart, &c, past.site, k, nth, runs);
	FREED char *words = fit_search_progress_text(s, &past, q->generation);
	chart_add_note(chart, "%s", words);
	candidates_clear(&c);
	return chart;
}

/* Returns an axis for all generations.  It is the same for most searches. */
static struct axis
convergence_rmse_axis(const struct search_shown *past)
{
	double low = 0.1, high = 30;
	for (size_t i = 0; i < past->n; i++) {
		const struct calibrate_generation *g = &past->generation[i];
		low = fmin(low, misfit_on_log_axis(past, g->best));
		high = fmax(high, misfit_on_log_axis(past, g->median));
	}
	low = fmin(low, misfit_on_log_axis(past, past->misfit));
	return axis_new_log(tr("difference, points RMS"), low, high);
}

struct chart *
plots_search_convergence(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct search_shown past = search_of_site_to_show(s, q->asked.entry);
	size_t at =
	    find_generation_index(q->asked.entry, &past, q->generation, error);
	if (at == past.n)
		return NULL;
	struct chart *chart = site_chart_new(past.site,
	    axis_new_linear(tr("generation"), 1, (double)past.n),
	    convergence_rmse_axis(&past), "the search, %zu generations",
	    past.n);
	struct chart_series *median = chart_append_series(
	    chart, SITE_CHART_FEED, past.n, N_("median candidate"));
	struct chart_series *best = chart_append_series(
	    chart, SITE_CHART_PREDICTED, past.n, N_("best"));
	for (size_t i = 0; i < past.n; i++) {
		const struct calibrate_generation *g = &past.generation[i];
		median->x[i] = best->x[i] = (double)(i + 1);
		median->y[i] = misfit_on_log_axis(&past, g->median);
		best->y[i] = misfit_on_log_axis(&past, g->best);
	}
	if (past.polished)
		chart_append_point_series(chart,
		    (struct chart_series){
			.series = SERIES_PREDICTED, .mark = '*'},
		    1, (double[]){(double)past.n},
		    (double[]){misfit_on_log_axis(&past, past.misfit)},
		    tr("polished"));
	if (q->generation > 0)
		chart_add_vertical_rule(chart, SERIES_CROSSHAIR,
		    (double)q->generation, "generation %zu", q->generation);
	return chart;
}

/* Sets span->drawn from the draws, once the calibration that found the
 * parameters is over. */
static void
set_param_interval_from_draws(
    struct session *s, const char *name, struct param_span *span)
{
	const struct entry *entry = session_current_site_entry(s);
	bool over = !session_is_calibrating(s) && entry->has_fit &&
		    entry->origin != NULL &&
		    entry->origin->history == entry->history;
	const struct posterior *p =
	    over ? posterior_even_if_correction_off(s, entry) : NULL;
	double value[POSTERIOR_DRAWS];
	if (p == NULL)
		return;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		value[d] = params_value_by_name(&p->draw[d].params, name);
	ensemble_interval_around_answer(value, 0.8, NAN, span->drawn);
}

struct param_span
param_span_of_generation(struct session *s, const struct search_shown *past,
    size_t generation, size_t j)
{
	const double outer = 0.05;
	size_t at = generation > 0 ? generation : past->n;
	const struct calibrate_generation *g = &past->generation[at - 1];
	const struct breakage *of = breakage_model_of_params(&g->params);
	struct params best = best_params_of_generation(past, generation);
	struct param_span span = {.lower = past->bounds->lower[j],
	    .upper = past->bounds->upper[j],
	    .p10 = g->p10[j],
	    .p90 = g->p90[j],
	    .drawn = {NAN, NAN},
	    .at_bound = sensitivity_is_param_on_bound(past->bounds, &best, j)};
	double range = span.upper - span.lower;
	span.fixed = !(range > 0);
	params_scale_largest_beta_to_1(&best);
	span.best = best.at[j];
	if (j < of->gauge && !span.fixed) {
		candidates_p10_p90_of_param(g, j, &span.p10, &span.p90);
		span.lower = -1;
		span.upper = 1;
	} else
		span.near =
		    !span.fixed && (span.best - span.lower < outer * range ||
				       span.upper - span.best < outer * range);
	if (generation == 0)
		set_param_interval_from_draws(s, of->parameter[j].name, &span);
	return span;
}

/* Gives each parameter a row, the first one on top, about half a row from
 * either end: slightly less, so that rounding does not put two parameters into
 * one row of cells. */
static struct axis
parameter_row_axis(const struct breakage *of)
{
	const double margin = 0.45;
	struct axis axis = {.title = xstrdup("parameter"),
	    .names = true,
	    .low = margin,
	    .high = (double)of->n + margin};
	for (size_t j = 0; j < of->n; j++)
		axis_add_tick(
		    &axis, (double)(of->n - j), of->parameter[j].name, 0);
	return axis;
}

/* Returns the position of a value between the bounds, %; NAN for a parameter
 * held fixed. */
static double
position_within_bounds_pct(const struct param_span *span, double value)
{
	double range = span->upper - span->lower;
	return span->fixed ? NAN : 100 * (value - span->lower) / range;
}

struct chart *
plots_search_param_spread(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct search_shown past = search_of_site_to_show(s, q->asked.entry);
	size_t at =
	    find_generation_index(q->asked.entry, &past, q->generation, error);
	if (at == past.n)
		return NULL;
	const struct breakage *of =
	    breakage_model_of_params(&past.generation[at].params);
	struct chart *chart = site_chart_new(past.site,
	    axis_new_linear(tr("position between the bounds, %"), 0, 100),
	    parameter_row_axis(of), "candidates of generation %zu", at + 1);
	/* Two ends, and a gap that lifts the pen. */
	struct chart_series *spread = chart_append_series(chart,
	    (struct chart_series){
		.series = SERIES_FEED, .line = CHART_SOLID, .ascii = '='},
	    3 * of->n, N_("middle 80 %%"));
	struct chart_series *best = chart_append_series(chart,
	    (struct chart_series){.series = SERIES_PREDICTED, .mark = '#'},
	    of->n,
	    q->generation == 0 && past.polished ? N_("polished") : N_("best"));
	for (size_t j = 0; j < of->n; j++) {
		struct param_span span =
		    param_span_of_generation(s, &past, q->generation, j);
		double row = span.fixed ? NAN : (double)(of->n - j);
		double end[3] = {position_within_bounds_pct(&span, span.p10),
		    position_within_bounds_pct(&span, span.p90), NAN};
		for (size_t k = 0; k < 3; k++) {
			spread->x[3 * j + k] = k < 2 ? end[k] : 0;
			spread->y[3 * j + k] = k < 2 ? row : NAN;
		}
		best->x[j] = position_within_bounds_pct(&span, span.best);
		best->y[j] = row;
	}
	chart_add_note(chart,
	    "only the ratios of beta matter: the values of each candidate are "
	    "divided by the largest of them, from -1 to 1");
	return chart;
}

/* Returns "most candidates still miss 4 mm by 5.2 points at 69 m/s", or a
 * sentence on the break size once half of the candidates agree on it. */
static char *
fit_candidates_progress_text(
    const struct session *s, const struct search_shown *past, size_t generation)
{
	const double agreed = 1.1;
	bool assumed;
	double noise = sampling_noise_near_50_percent(s, &assumed);
	struct candidates c = residuals_of_generation(s, past, generation);
	const struct candidates_cell *worst =
	    candidates_worst_fitted_passing(&c);
	double miss = units_fraction_to_pct(fabs(worst->median));
	const double *x = c.break_size;
	char *words;
	FREED char *at = answers_speed_text(past->site, c.speed, -1);
	FREED char *missed = answers_speed_text(
	    past->site, past->site->run[worst->run].speed, -1);
	if (x[2] < agreed * x[0] && x[0] > 0)
		words = xasprintf(tr("half of the candidates agree on a break "
				     "size of %.*f mm at %s"),
		    x[1] < 0.001 ? 2 : 1, units_m_to_mm(x[1]), at);
	else if (miss > noise)
		words =
		    xasprintf(tr("most candidates still miss %.3g mm by %.*f "
				 "points at %s"),
			units_m_to_mm(worst->size), miss < 9.95 ? 1 : 0, miss,
			missed);
	else
		words = xasprintf(tr("most candidates match all sieves to "
				     "within %.2g points, with break sizes "
				     "from %.2f to %.2f mm at %s"),
		    fmax(miss, 0.01), units_m_to_mm(x[0]), units_m_to_mm(x[2]),
		    at);
	candidates_clear(&c);
	return words;
}

static char *
polish_progress_text(const struct session *s, double points)
{
	struct calibrate_status st = calibration_status(s->job.calibration);
	if (st.starts_done < st.starts)
		return xasprintf(
		    tr("polishing: start %zu of %zu, %.2f points RMS"),
		    st.starts_done + 1, st.starts, points);
	return xasprintf(tr("polishing: %zu of %zu trials without a gain, %.2f "
			    "points RMS"),
	    st.trials, st.trials_most, points);
}

char *
fit_search_progress_text(
    struct session *s, const struct search_shown *past, size_t generation)
{
	double points = misfit_as_rmse_points(past, past->misfit);
	bool runs = generation == 0 && past->runs;
	enum calibrate_state state =
	    runs ? calibration_status(s->job.calibration).state
		 : CALIBRATE_SEARCHING;
	if (state == CALIBRATE_POLISHING)
		return polish_progress_text(s, points);
	if (session_is_calibrating(s) && state >= CALIBRATE_TOLERANCE)
		return xstrdup(
		    tr("posterior: drawing parameters that fit the data"));
	if (generation == 0 && past->polished && !past->runs)
		return xasprintf(tr("polished: %.2f points RMS"), points);
	return fit_candidates_progress_text(s, past, generation);
}
