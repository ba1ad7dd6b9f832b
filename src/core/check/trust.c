/* Collects the evidence on a fit from residuals, draws and held-out runs, and
 * compares both evidence and question with thresholds found by bench/coverage.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/check/trust.h"

#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_statistics_double.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "core/model/product.h"
#include "core/model/selection.h"
#include "core/psd/rotor_speed.h"
#include "core/search/misfit.h"
#include "core/search/sensitivity.h"

const char *const LIGHT_NAME[3] = {N_("green"), N_("amber"), N_("red")};

/* The smallest error of a passing. */
static const double ROUNDING = 0.001;

/* Thresholds of the signs that residuals are more than sampling errors.  One
 * strong sign or two weak ones turn the light amber.  Found by counting, with
 * bench/coverage: TRUST in tipspeed-model(7) has the figures. */
struct warning_sign {
	double weak, strong;
};
static const struct warning_sign SIZE = {1.6, 2.2}, ALIKE = {1.2, 2.2},
				 MORE = {0.45, 0.6}, FINER = {2, 3};

/* If only one speed was measured, this share of it counts as the span of
 * several. */
static const double SPAN_OF_ONE = 0.1;

/* Limits of the mean width of a band and of the difference between feeds,
 * passing. */
static const double WIDE = 0.05, VERY_WIDE = 0.15, OTHER_FEED = 0.1,
		    STRANGE_FEED = 0.3;

/* Removes from the differences d what a small step of the parameters would
 * remove, because some of the runs may not have been used for training.
 * Returns the number of independent steps. */
static double
project_out_parameter_steps(struct misfit *m, const struct fit *fit,
    const struct bounds *bounds, double *d)
{
	double *basis = xcalloc_doubles(m->n_residual * PARAMS_MOST);
	struct sensitivity s =
	    sensitivity_of_misfit(m, &fit->params, bounds, true, basis);
	for (size_t c = 0; c < s.n; c++) {
		double along = 0;
		for (size_t i = 0; i < m->n_residual; i++)
			along += d[i] * basis[i * PARAMS_MOST + c];
		for (size_t i = 0; i < m->n_residual; i++)
			d[i] -= along * basis[i * PARAMS_MOST + c];
	}
	free(basis);
	return (double)s.n;
}

/* Compares the residuals with the sampling errors that the priors expect: the
 * sum of their squares, and the sum of the products of neighbours. */
static void
compare_residuals_with_errors(struct evidence *e, const struct misfit *m,
    const double *d, double parameters, double noise)
{
	double error = hypot(HYPER[HYPER_SHARED].median,
	    noise > 0 ? noise : HYPER[HYPER_OWN].median);
	double squares = 0, points = 0, products = 0, cells = 0, pairs = 0;
	for (size_t r = 0, k = 0; r < m->n_run; r++) {
		double last = NAN;
		for (size_t i = 0; i < m->run[r].n; i++, k++) {
			double P = m->run[r].measured[i] + d[k] / 2;
			double h = discrepancy_scale_at_passing(P);
			bool counts = h > 0.02;
			double z = d[k] / hypot(h * error, ROUNDING);
			squares += counts ? z * z : 0;
			points += counts ? d[k] * d[k] : 0;
			cells += counts;
			products += counts && !isnan(last) ? z * last : 0;
			pairs += counts && !isnan(last);
			last = counts ? z : NAN;
		}
	}
	double spare = fmax(cells - parameters, 1);
	e->size = squares / spare;
	e->unexplained = sqrt(points / spare);
	e->alike = pairs > 0 && squares > 0
		       ? products / squares * cells / sqrt(pairs)
		       : 0;
}

/* Returns the share of the feed above the break size that breaks at a speed. */
static double
broken_share_of_breakable(const struct misfit *m, const struct params *p)
{
	double x =
	    params_break_size_by_impacts(p, &m->settings, m->run[0].speed);
	double above =
	    x > 0 && isfinite(x) ? 1 - psd_passing(&m->run[0].feed, x) : NAN;
	model_set_params(m->model[0], p);
	return above > 0.01
		   ? model_broken_feed_share(m->model[0], m->run[0].speed) /
			 above
		   : NAN;
}

static double
trust_median_of_draws(double *value)
{
	return gsl_stats_median(value, 1, POSTERIOR_DRAWS);
}

static void
trust_summarise_posterior(struct evidence *e, const struct posterior *p,
    const struct fit *fit, double finest)
{
	enum { N = POSTERIOR_DRAWS };
	double off[N], error[N], finer[N];
	double e0 = params_value_by_name(&fit->params, "e0_min");
	e->more = e->unbounded = 0;
	for (size_t i = 0; i < N; i++) {
		const struct posterior_draw *d = &p->draw[i];
		off[i] = hypot(d->hyper[HYPER_DELTA], d->hyper[HYPER_NARROW]);
		error[i] = hypot(d->hyper[HYPER_SHARED], d->hyper[HYPER_OWN]);
		finer[i] = params_value_by_name(&d->params, "gamma") +
			   params_value_by_name(&d->params, "kappa");
		e->more += off[i] > error[i] ? 1.0 / N : 0;
		e->unbounded += params_break_size_by_impacts(&d->params,
				    &p->settings, e->slowest) < finest ||
					params_value_by_name(
					    &d->params, "e0_min") < 0.05 * e0
				    ? 1.0 / N
				    : 0;
	}
	e->finer = gsl_stats_mean(finer, 1, N);
	e->finer_sd = gsl_stats_sd(finer, 1, N);
	e->discrepancy = trust_median_of_draws(off);
	e->sampling = trust_median_of_draws(error);
}

/* Returns the largest difference between the halves at the slowest and the
 * fastest measured speed and midway. */
static double
largest_difference_of_draw_halves(const struct evidence *e,
    const struct posterior *p, const struct site *site, const double *sieve,
    size_t n)
{
	const struct psd *feed = site_feed_of_run(site, SITE_MEAN_FEED);
	while (!psd_covers_size(feed, sieve[n - 1]))
		n--;
	struct ensemble *of = ensemble_new(p, feed, sieve, n);
	double most = 0;
	for (int i = 0; i <= 2; i++)
		most = fmax(
		    most, ensemble_difference_of_halves(of,
			      e->slowest + i * (e->fastest - e->slowest) / 2));
	ensemble_free(of);
	return most;
}

static void
find_worst_holdout(struct evidence *e, const struct site *site,
    const bool *train, const struct fit *fit)
{
	for (size_t r = 0; r < site->n_run; r++) {
		if (train[r] || misfit_count_covered_sieves(&site->run[r]) == 0)
			continue;
		struct validation v =
		    validate_run(site, r, train, &fit->params, fit->settings);
		if (e->holdout.n_sieve == 0 ||
		    v.rmse[VALIDATE_MODEL] > e->holdout.rmse[VALIDATE_MODEL])
			e->holdout = v;
	}
}

struct validation
trust_find_outlier_cell(
    const struct site *site, const bool *train, const struct fit *fit)
{
	/* With noise of 0.5 points, none of 38 sites has a difference of more
	 * than 1.9 points; of 77 products with two digits changed by 9 points,
	 * 67 have more than 4.  In a poor fit many cells are off. */
	double far_off =
	    fit->rmse > FIT_POOR ? fmax(0.04, 3 * fit->rmse) : 0.04;
	struct validation farthest = {.worst_difference = 0};
	for (size_t r = 0; r < site->n_run; r++) {
		if (misfit_count_covered_sieves(&site->run[r]) == 0)
			continue;
		struct validation v =
		    validate_run(site, r, train, &fit->params, fit->settings);
		if (fabs(v.worst_difference) >
		    fmax(far_off, fabs(farthest.worst_difference)))
			farthest = v;
	}
	return farthest;
}

static void
find_measured_speed_range(struct evidence *e, const struct misfit *m)
{
	e->slowest = INFINITY;
	for (size_t r = 0; r < m->n_run; r++) {
		double v = m->run[r].speed;
		e->speeds += r == 0 || v != m->run[r - 1].speed;
		e->slowest = fmin(e->slowest, v);
		e->fastest = fmax(e->fastest, v);
	}
}

/* Adds to passing [n] the product of a feed at speed v, times `share`. */
static void
add_weighted_product(double *passing, const struct psd *feed,
    const double *sieve, size_t n, const struct fit *fit, double v,
    double share)
{
	double *product = xcalloc_doubles(n);
	struct model *model = model_new(feed, sieve, n, fit->settings);
	model_set_params(model, &fit->params);
	model_compute_product(model, v, product);
	for (size_t i = 0; i < n; i++)
		passing[i] += share * product[i];
	model_free(model);
	free(product);
}

/* Returns a run's product, adjusted by the fit to the site's mean feed (D19),
 * at the sieves that both feeds cover.  The caller frees it with psd_free. */
static struct psd
product_moved_to_mean_feed(
    const struct site *site, size_t r, const struct fit *fit)
{
	const struct run *run = &site->run[r];
	const struct psd *mean = site_feed_of_run(site, SITE_MEAN_FEED);
	struct psd p = psd_copy(&run->product);
	p.n = misfit_count_covered_sieves(run);
	while (p.n > 0 && !psd_covers_size(mean, p.size[p.n - 1]))
		p.n--;
	if (site->individual_feeds && p.n > 0) {
		add_weighted_product(
		    p.passing, mean, p.size, p.n, fit, run->speed, 1);
		add_weighted_product(
		    p.passing, &run->feed, p.size, p.n, fit, run->speed, -1);
	}
	return p;
}

/* Returns the sum of the squared differences, over n sieves, between a run's
 * product and the fit's product of a feed. */
static double
sum_squared_run_misfit_for_feed(const struct run *run, const struct psd *feed,
    size_t n, const struct fit *fit)
{
	double sum = 0, *d = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++)
		d[i] = -run->product.passing[i];
	add_weighted_product(d, feed, run->product.size, n, fit, run->speed, 1);
	for (size_t i = 0; i < n; i++)
		sum += d[i] * d[i];
	free(d);
	return sum;
}

bool
trust_are_feeds_misleading(
    const struct site *site, const struct fit *fit, double *own, double *mean)
{
	/* For 90 synthetic plants whose products follow their feeds, the ratio
	 * was at most 1.08. */
	const double ratio = 1.2, least = 0.001;
	const struct psd *all = site_feed_of_run(site, SITE_MEAN_FEED);
	double squares[2] = {0, 0};
	size_t cells = 0;
	for (size_t r = 0; site->individual_feeds && r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		size_t n = misfit_count_covered_sieves(run);
		while (n > 0 && !psd_covers_size(all, run->product.size[n - 1]))
			n--;
		if (n == 0 || run->lacks_feed)
			continue;
		squares[0] +=
		    sum_squared_run_misfit_for_feed(run, &run->feed, n, fit);
		squares[1] += sum_squared_run_misfit_for_feed(run, all, n, fit);
		cells += n;
	}
	if (cells == 0)
		return false;
	*own = sqrt(squares[0] / (double)cells);
	*mean = sqrt(squares[1] / (double)cells);
	return *own > ratio * *mean && *own - *mean > least;
}

static void
find_contradicting_runs(struct evidence *e, const struct site *site,
    const bool *use, const struct fit *fit)
{
	struct psd *moved = xcalloc(site->n_run, sizeof *moved);
	for (size_t r = 0; r < site->n_run; r++)
		if (use[r])
			moved[r] = product_moved_to_mean_feed(site, r, fit);
	for (size_t r = 0; r < site->n_run; r++)
		for (size_t k = 0; k < r; k++) {
			const struct run *slow = &site->run[k],
					 *fast = &site->run[r];
			struct passing_order o =
			    trust_compare_slow_fast_products(
				&moved[k], &moved[r]);
			if (slow->speed < fast->speed &&
			    trust_is_product_order_wrong(&o) &&
			    o.most > e->against.order.most) {
				e->against.slow = slow->speed;
				e->against.fast = fast->speed;
				e->against.order = o;
			}
		}
	for (size_t r = 0; r < site->n_run; r++)
		psd_free(&moved[r]);
	free(moved);
}

struct evidence
trust_gather_evidence(const struct site *site, const bool *train,
    const bool *use, const struct fit *fit, const struct bounds *bounds,
    const struct posterior *posterior, double noise)
{
	struct misfit *m = misfit_new(site, use, NULL, false, fit->settings);
	struct evidence e = {.cells = fit->cells,
	    .parameters = fit->parameters,
	    .rmse = fit->rmse,
	    .like_feed = trust_are_products_like_feed(site) ||
			 fit->misfit > (1 - FIT_LEAST_GAIN) * fit->feed_misfit,
	    .discrepancy = NAN,
	    .sampling = NAN,
	    .more = NAN,
	    .finer = NAN,
	    .finer_sd = NAN,
	    .unbounded = NAN,
	    .halves = NAN,
	    .breaks = broken_share_of_breakable(m, &fit->params)};
	double *d = xcalloc_doubles(m->n_residual);
	size_t n;
	double *sieve = site_all_sieves(site, &n);
	misfit_weighted_differences(m, &fit->params, d);
	compare_residuals_with_errors(
	    &e, m, d, project_out_parameter_steps(m, fit, bounds, d), noise);
	find_measured_speed_range(&e, m);
	find_worst_holdout(&e, site, train, fit);
	e.outlier = trust_find_outlier_cell(site, train, fit);
	find_contradicting_runs(&e, site, use, fit);
	e.all_break = !isnan(params_value_by_name(&fit->params, "e0_min")) &&
		      params_break_size_by_impacts(&fit->params, &fit->settings,
			  e.slowest) < sieve[n - 1];
	if (posterior != NULL) {
		trust_summarise_posterior(&e, posterior, fit, sieve[n - 1]);
		e.halves = largest_difference_of_draw_halves(
		    &e, posterior, site, sieve, n);
	}
	free(sieve);
	free(d);
	misfit_free(m);
	return e;
}

void
trust_add_reason(
    struct trust *t, enum light light, enum trust_cause cause, char *text)
{
	size_t at = t->n;
	if (t->n == TRUST_REASONS) {
		free(text);
		return;
	}
	for (; at > 0 && t->reason[at - 1].light < light; at--)
		t->reason[at] = t->reason[at - 1];
	t->reason[at] = (struct trust_reason){cause, light, text};
	t->n++;
	t->light = t->reason[0].light;
}

static void
add_fit_and_data_trust_reasons(
    struct trust *t, const struct evidence *e, double rotor)
{
	FREED char *rpm = rotor_speed_rpm_text(rotor, e->slowest, NAN);
	size_t spare =
	    e->cells - (e->cells < e->parameters ? e->cells : e->parameters);
	if (e->rmse > FIT_POOR)
		trust_add_reason(t, LIGHT_RED, TRUST_FIT,
		    xasprintf(
			tr("the fit is poor: it misses its products by %.1f "
			   "points on average, where repeat samples agree "
			   "within 0.5 to 1; check the data with 'check'"),
			100 * e->rmse));
	if (spare == 0)
		trust_add_reason(t, LIGHT_RED, TRUST_DATA,
		    xasprintf(tr_n("%zu passing cannot determine %zu "
				   "parameters: the quality of the fit is not "
				   "known; add sieves or a run",
				  "%zu passings cannot determine %zu "
				  "parameters: the quality of the fit is not "
				  "known; add sieves or a run",
				  e->cells),
			e->cells, e->parameters));
	else if (spare < 4)
		trust_add_reason(t, LIGHT_AMBER, TRUST_DATA,
		    xasprintf(
			tr_n("%zu passings for %zu parameter are too few to "
			     "reveal a wrong model; add sieves or a run",
			    "%zu passings for %zu parameters are too few to "
			    "reveal a wrong model; add sieves or a run",
			    e->parameters),
			e->cells, e->parameters));
	if (e->speeds == 1)
		trust_add_reason(t, LIGHT_AMBER, TRUST_DATA,
		    xasprintf(tr("only one speed, %g m/s%s, was measured: the "
				 "effect of speed is not known; add another"),
			e->slowest, rpm));
	if (e->halves > DRAWS_SETTLED && !e->like_feed)
		trust_add_reason(t, LIGHT_AMBER, TRUST_FIT,
		    xasprintf(
			tr("the band has not settled (two halves of its draws "
			   "differ by %.0f %% of its width): it may be too "
			   "narrow or too wide; compare with 'set draw_seed "
			   "2'"),
			100 * e->halves));
}

/* Adds the reasons that arise from runs that contradict each other, and from a
 * fit that no crusher can have. */
static void
add_contradiction_trust_reasons(
    struct trust *t, const struct evidence *e, double rotor)
{
	FREED char *fast = rotor_speed_rpm_text(rotor, e->against.fast, NAN);
	FREED char *slow = rotor_speed_rpm_text(rotor, e->against.slow, NAN);
	FREED char *slowest = rotor_speed_rpm_text(rotor, e->slowest, NAN);
	if (e->against.order.most > 0)
		trust_add_reason(t, LIGHT_RED, TRUST_DATA,
		    xasprintf(tr("the run at %g m/s%s is coarser than at %g%s, "
				 "by %.1f points at %g mm: exchanged, or "
				 "another feed? run 'check'"),
			e->against.fast, fast, e->against.slow, slow,
			100 * e->against.order.most,
			1e3 * e->against.order.at));
	if (e->all_break && !e->like_feed)
		trust_add_reason(t, LIGHT_AMBER, TRUST_FIT,
		    xasprintf(
			tr("the fit has no break size: in it particles of "
			   "every size break at %g m/s%s, so it cannot tell "
			   "what a slower rotor leaves whole; add a run at a "
			   "lower speed"),
			e->slowest, slowest));
}

static int
count_exceeded_trust_limits(double value, struct warning_sign sign)
{
	return (value > sign.weak) + (value > sign.strong);
}

/* True if the measured runs correct the answer, it lies between their speeds,
 * and there are enough speeds to show how the product changes.  Then the answer
 * holds even if the model does not. */
static bool
is_supported_by_measurements(
    const struct evidence *e, const struct trust_question *q)
{
	bool between =
	    q->speed >= e->slowest - 1e-9 && q->speed <= e->fastest + 1e-9;
	return q->corrected && e->speeds >= 3 && (q->speed == 0 || between);
}

/* Adds a pattern in the residuals as a reason or as a remark. */
static void
add_residual_pattern_reason(struct trust *t, bool remark, char *text)
{
	if (remark)
		t->remark[t->remarks++] = text;
	else
		trust_add_reason(t, LIGHT_AMBER, TRUST_PATTERN, text);
}

static void
judge_residual_pattern(struct trust *t, const struct evidence *e, bool remark)
{
	double finer = fabs(e->finer) / e->finer_sd;
	int size = count_exceeded_trust_limits(e->size, SIZE),
	    alike = count_exceeded_trust_limits(e->alike, ALIKE);
	int more = count_exceeded_trust_limits(e->more, MORE),
	    drift = count_exceeded_trust_limits(finer, FINER);
	if (size + alike + more + drift < 2)
		return;
	if (size > 0)
		add_residual_pattern_reason(t, remark,
		    xasprintf(
			tr("the residuals are %.1f times as large as usual "
			   "sampling errors: the model misses something, or "
			   "the samples are biased"),
			sqrt(e->size)));
	if (alike > 0)
		add_residual_pattern_reason(t, remark,
		    xasprintf(
			tr("residuals of neighbouring sieves are alike "
			   "(%.1f sd more than by chance): the model misses "
			   "something, or whole samples are biased"),
			e->alike));
	if (more > 0)
		add_residual_pattern_reason(t, remark,
		    xasprintf(
			tr("what the model leaves out (%.1f points) is no "
			   "smaller than the sampling errors (%.1f): the "
			   "answer is as much correction as model"),
			100 * e->discrepancy, 100 * e->sampling));
	if (drift > 0)
		add_residual_pattern_reason(t, remark,
		    xasprintf(tr("the residuals follow the speed, as if "
				 "particles became %s with energy (gamma + "
				 "kappa %.2f \302\261 %.2f): beyond the "
				 "measured speeds the answer rests on that"),
			e->finer > 0 ? tr("finer") : tr("coarser"), e->finer,
			e->finer_sd));
}

static void
judge_holdout_error(struct trust *t, const struct evidence *e, double rotor)
{
	const struct validation *v = &e->holdout;
	FREED char *rpm = rotor_speed_rpm_text(rotor, v->speed, NAN);
	double own = v->rmse[VALIDATE_MODEL];
	double line = v->rmse[VALIDATE_INTERPOLATION];
	if (v->n_sieve == 0)
		return;
	if (own > FIT_POOR)
		trust_add_reason(t, LIGHT_RED, TRUST_HOLDOUT,
		    xasprintf(tr("at %g m/s%s, held out, the model misses by "
				 "%.1f points on average"),
			v->speed, rpm, 100 * own));
	else if (validation_is_interpolation_better(v) &&
		 own > 1.2 * line + 0.001)
		trust_add_reason(t, LIGHT_AMBER, TRUST_HOLDOUT,
		    xasprintf(tr("at %g m/s%s, held out, the model misses by "
				 "%.2f points on average, a straight line "
				 "through the training products by %.2f"),
			v->speed, rpm, 100 * own, 100 * line));
}

static void
judge_trust_by_outlier_cell(
    struct trust *t, const struct evidence *e, double rotor)
{
	const struct validation *v = &e->outlier;
	FREED char *rpm = rotor_speed_rpm_text(rotor, v->speed, NAN);
	if (v->worst_difference != 0)
		trust_add_reason(t, LIGHT_AMBER, TRUST_DATA,
		    xasprintf(
			tr("the product at %g m/s%s is %.1f points off the fit "
			   "at %g mm: run 'check', which looks for a mistyped "
			   "value"),
			v->speed, rpm, 100 * fabs(v->worst_difference),
			1e3 * v->worst_sieve));
}

static void
add_trust_reason_unbounded_params(
    struct trust *t, const struct evidence *e, double rotor)
{
	FREED char *rpm = rotor_speed_rpm_text(rotor, e->slowest, NAN);
	if (e->unbounded > 0.05)
		trust_add_reason(t, LIGHT_AMBER, TRUST_SLOW,
		    xasprintf(tr("the threshold is only bounded from above "
				 "(%.0f %% of the draws have none): below %g "
				 "m/s%s far less of the feed may break"),
			100 * e->unbounded, e->slowest, rpm));
	else if (e->breaks > 0.995)
		trust_add_reason(t, LIGHT_AMBER, TRUST_SLOW,
		    xasprintf(tr("at %g m/s%s, %.0f %% of the breakable feed "
				 "breaks already: f_mat is only bounded from "
				 "below, and at lower speeds less may break"),
			e->slowest, rpm, 100 * e->breaks));
}

double
trust_reach_beyond_speeds(double slowest, double fastest)
{
	double span = fastest - slowest;
	return span > 0 ? span : SPAN_OF_ONE * slowest;
}

static void
judge_extrapolated_speed(
    struct trust *t, const struct evidence *e, double v, double rotor)
{
	bool slow = v<e->slowest - 1e-9, fast = v> e->fastest + 1e-9;
	double end = slow ? e->slowest : e->fastest;
	double span = trust_reach_beyond_speeds(e->slowest, e->fastest);
	double beyond = fabs(v - end);
	bool far = beyond > span + 1e-9;
	if (!slow && !fast)
		return;
	FREED char *rpm = rotor_speed_rpm_text(rotor, beyond, NAN);
	if (e->slowest == e->fastest)
		trust_add_reason(t, far ? LIGHT_RED : LIGHT_AMBER, TRUST_BEYOND,
		    xasprintf(
			far ? tr("%.1f m/s%s from the one speed that was "
				 "measured: too far for a reliable answer")
			    : tr("%.1f m/s%s from the one speed that was "
				 "measured: there the answer rests on the "
				 "model, not on measurements"),
			beyond, rpm));
	else if (far)
		trust_add_reason(t, LIGHT_RED, TRUST_BEYOND,
		    xasprintf(tr("%.1f m/s%s beyond the measured speeds, which "
				 "span %.1f: too far for a reliable answer"),
			beyond, rpm, span));
	else
		trust_add_reason(t, LIGHT_AMBER, TRUST_BEYOND,
		    xasprintf(
			tr("%.1f m/s%s beyond the measured speeds: there the "
			   "answer rests on the model, not on measurements"),
			beyond, rpm));
	if (slow)
		add_trust_reason_unbounded_params(t, e, rotor);
}

static void
judge_band_feed_and_bound(struct trust *t, const struct trust_question *q)
{
	if (q->width > WIDE)
		trust_add_reason(t,
		    q->width > VERY_WIDE ? LIGHT_RED : LIGHT_AMBER, TRUST_BAND,
		    xasprintf(tr("the uncertainty band is wide, %.0f points on "
				 "average: the data leave the answer open"),
			100 * q->width));
	if (q->feed > OTHER_FEED)
		trust_add_reason(t,
		    q->feed > STRANGE_FEED ? LIGHT_RED : LIGHT_AMBER,
		    TRUST_FEED,
		    xasprintf(
			tr("the feed differs by up to %.0f points from those "
			   "of the calibration: it may break differently"),
			100 * q->feed));
	if (q->bound != NULL)
		trust_add_reason(t, LIGHT_AMBER, TRUST_BOUND,
		    xasprintf(tr("%s is at its bound, which the data would "
				 "exceed: past the bound the answer would "
				 "change by %.1f points"),
			q->bound, 100 * q->bound_moves));
}

void
trust_judge_answer(
    struct trust *t, const struct evidence *e, const struct trust_question *q)
{
	/* A fit to sampling errors has other faults, but they follow from
	 * this. */
	if (e->like_feed)
		trust_add_reason(t, LIGHT_AMBER, TRUST_DATA,
		    xstrdup(tr("the products are not measurably finer than the "
			       "feed: there is nothing to calibrate on")));
	add_fit_and_data_trust_reasons(t, e, q->rotor);
	add_contradiction_trust_reasons(t, e, q->rotor);
	if (!e->like_feed) {
		judge_holdout_error(t, e, q->rotor);
		judge_trust_by_outlier_cell(t, e, q->rotor);
	}
	/* The speed comes before the pattern, because an answer shows only its
	 * first reason. */
	if (q->speed > 0)
		judge_extrapolated_speed(t, e, q->speed, q->rotor);
	if (!e->like_feed)
		judge_residual_pattern(
		    t, e, is_supported_by_measurements(e, q));
	judge_band_feed_and_bound(t, q);
}

bool
trust_is_band_impossible(double rmse, size_t speeds)
{
	return rmse > FIT_POOR && speeds <= 2;
}

void
trust_free(struct trust *t)
{
	for (size_t i = 0; i < t->n; i++)
		free(t->reason[i].text);
	for (size_t i = 0; i < t->remarks; i++)
		free(t->remark[i]);
	*t = (struct trust){0};
}

double
trust_answer_change_per_param_sd(
    const struct posterior *p, struct ensemble *e, const char *parameter)
{
	enum { N = POSTERIOR_DRAWS };
	size_t n = ensemble_count_sieves(e);
	double value[N], sum = 0;
	for (size_t d = 0; d < N; d++)
		value[d] = params_value_by_name(&p->draw[d].params, parameter);
	double sd = gsl_stats_sd(value, 1, N);
	for (size_t i = 0; i < n && sd > 0; i++) {
		const double *P = ensemble_products(e, ENSEMBLE_ANSWER) + i * N;
		double move = gsl_stats_covariance(value, 1, P, 1, N) / sd;
		sum += move * move / (double)n;
	}
	return sqrt(sum);
}

double
trust_largest_feed_difference(const struct psd *a, const struct psd *b)
{
	double most = 0;
	for (size_t i = 0; i < a->n; i++)
		if (psd_covers_size(b, a->size[i]))
			most = fmax(most,
			    fabs(psd_passing(b, a->size[i]) - a->passing[i]));
	for (size_t i = 0; i < b->n; i++)
		if (psd_covers_size(a, b->size[i]))
			most = fmax(most,
			    fabs(psd_passing(a, b->size[i]) - b->passing[i]));
	return most;
}

/* Returns the passing at size x or, if that is none of the curve's sieves, at
 * the next finer one: at x at least as much passes.  A straight line between
 * the sieves may lie several points too high. */
static double
passing_known_at_least(const struct psd *curve, double x)
{
	const double same = 1 + 1e-9;
	size_t i = 0;
	while (i + 1 < curve->n && curve->size[i] > x * same)
		i++;
	return curve->passing[i];
}

struct passing_order
trust_compare_slow_fast_products(const struct psd *slow, const struct psd *fast)
{
	struct passing_order o = {0};
	double sum = 0, n = 0;
	for (size_t j = 0; j < fast->n; j++) {
		double x = fast->size[j];
		if (!psd_covers_size(slow, x))
			continue;
		double by = passing_known_at_least(slow, x) - fast->passing[j];
		/* Of the sieves that all passes only the finest counts. */
		if (sum == 0 && fast->passing[j] >= 1 &&
		    psd_passing(slow, x) >= 1)
			n = 0;
		sum += by;
		n++;
		if (by > o.most) {
			o.most = by;
			o.at = x;
		}
	}
	o.mean = n > 0 ? sum / n : 0;
	return o;
}

/* Returns by how much more passes in the product than in its feed, at most over
 * the feed's sieves, 0..1. */
static double
most_gained_by_crushing(const struct run *run)
{
	double most = 0;
	for (size_t j = 0; j < run->feed.n; j++)
		if (psd_covers_size(&run->product, run->feed.size[j]))
			most = fmax(most,
			    psd_passing(&run->product, run->feed.size[j]) -
				run->feed.passing[j]);
	return most;
}

bool
trust_are_products_like_feed(const struct site *site)
{
	size_t n = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		if (misfit_count_covered_sieves(run) == 0)
			continue;
		n++;
		if (most_gained_by_crushing(run) > SAMPLES_AGREE)
			return false;
	}
	return n > 0;
}

bool
trust_is_product_order_wrong(const struct passing_order *o)
{
	const double on_the_whole = 0.003, far = 0.05;
	return o->most > ORDER_NOTABLE &&
	       (o->mean > on_the_whole || o->most > far);
}
