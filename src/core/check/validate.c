/* Compares the predictions of the model and of null models with the products of
 * held-out runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/check/validate.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/search/misfit.h"
#include "core/model/product.h"

/* True if run r is a training run with a product. */
static bool
is_training_product(const struct site *site, const bool *train, size_t r)
{
	return train[r] && site->run[r].product.n > 0;
}

/* Returns the nearest training speed at or below a speed or, if `above` is
 * true, above it; NAN if there is none. */
static double
training_speed_below_or_above(
    const struct site *site, const bool *train, double speed, bool above)
{
	double next = NAN;
	for (size_t r = 0; r < site->n_run; r++) {
		double v = site->run[r].speed;
		if (is_training_product(site, train, r) && (v > speed) == above)
			next = above ? fmin(next, v) : fmax(next, v);
	}
	return next;
}

/* Returns the training speed nearest to a speed; the slower of two equally
 * near. */
static double
nearest_training_speed(const struct site *site, const bool *train, double speed)
{
	double below = training_speed_below_or_above(site, train, speed, false);
	double above = training_speed_below_or_above(site, train, speed, true);
	return above - speed < speed - below || isnan(below) ? above : below;
}

/* Finds the two training speeds to interpolate between.  If there is only one,
 * it is line[0], and line[1] is NAN. */
static void
find_speeds_to_interpolate(const struct site *site, const bool *train,
    double speed, double line[static 2])
{
	line[0] = training_speed_below_or_above(site, train, speed, false);
	line[1] = training_speed_below_or_above(site, train, speed, true);
	if (isnan(line[0])) {
		line[0] = line[1];
		line[1] =
		    training_speed_below_or_above(site, train, line[0], true);
	} else if (isnan(line[1])) {
		line[1] = line[0];
		line[0] = training_speed_below_or_above(
		    site, train, nextafter(line[1], 0), false);
	}
	if (isnan(line[0])) {
		line[0] = line[1];
		line[1] = NAN;
	}
}

/* Returns the passing of a run's product at a size, or NAN below its finest
 * sieve and, unless all passes there, above its coarsest. */
static double
measured_passing_at_size(const struct run *run, double x)
{
	const struct psd *product = &run->product;
	bool above = x > product->size[0];
	if (above && psd_passing(&run->feed, x) >= 1)
		return 1;
	if (!psd_covers_size(product, x) || (above && product->passing[0] < 1))
		return NAN;
	return psd_passing(product, x);
}

/* Returns the mean passing at a size of the training products at one speed, or
 * NAN if it is not known for any of them. */
static double
mean_measured_passing_at_speed(
    const struct site *site, const bool *train, double speed, double x)
{
	double sum = 0, n = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		if (site->run[r].speed != speed ||
		    !is_training_product(site, train, r))
			continue;
		double passing = measured_passing_at_size(&site->run[r], x);
		if (isnan(passing))
			continue;
		sum += passing;
		n++;
	}
	return n > 0 ? sum / n : NAN;
}

double
validate_interpolate_passing(
    const struct site *site, const bool *train, double speed, double x)
{
	double line[2];
	find_speeds_to_interpolate(site, train, speed, line);
	double a = mean_measured_passing_at_speed(site, train, line[0], x);
	double b = mean_measured_passing_at_speed(site, train, line[1], x);
	double E_a = specific_energy_at_speed(line[0]),
	       E_b = specific_energy_at_speed(line[1]);
	double t = (specific_energy_at_speed(speed) - E_a) / (E_b - E_a);
	return a + t * (b - a);
}

static void
fill_model_passings(const struct run *run, const struct params *p,
    struct model_settings settings, double *out)
{
	struct model *model = model_new(&run->feed, run->product.size,
	    misfit_count_covered_sieves(run), settings);
	model_set_params(model, p);
	model_compute_product(model, run->speed, out);
	model_free(model);
}

static void
validate_predict_by_way(const struct site *site, size_t run, const bool *train,
    const struct params *p, struct model_settings settings,
    enum validate_way way, double *out)
{
	const struct run *at = &site->run[run];
	double nearest = nearest_training_speed(site, train, at->speed);
	if (way == VALIDATE_MODEL) {
		fill_model_passings(at, p, settings, out);
		return;
	}
	for (size_t i = 0; i < misfit_count_covered_sieves(at); i++) {
		double x = at->product.size[i];
		out[i] = way == VALIDATE_CORRECTED ? NAN
			 : way == VALIDATE_FEED    ? psd_passing(&at->feed, x)
			 : way == VALIDATE_NEAREST
			     ? mean_measured_passing_at_speed(
				   site, train, nearest, x)
			     : validate_interpolate_passing(
				   site, train, at->speed, x);
	}
}

/* Reads P20, P50 and P80 off the known passings of a curve. */
static void
read_p20_p50_p80(const struct psd *sieves, const double *passing, size_t n,
    double size[static PSD_SIZES])
{
	struct psd known = psd_new(n);
	known.n = 0;
	for (size_t i = 0; i < n; i++) {
		if (isnan(passing[i]))
			continue;
		known.size[known.n] = sieves->size[i];
		known.passing[known.n++] = passing[i];
	}
	for (size_t i = 0; i < PSD_SIZES; i++)
		size[i] = psd_size_at_passing(&known, PSD_PASSING[i]);
	psd_free(&known);
}

/* Scores a way's predictions at the covered sieves. */
static void
score_prediction_method(struct validation *v, const struct site *site,
    enum validate_way way, const double *passing)
{
	const struct psd *product = &site->run[v->run].product;
	size_t worst = 0, n = v->n_sieve, idle = v->n_idle;
	v->rmse[way] = psd_rms_difference(
	    passing + idle, product->passing + idle, n - idle, &worst);
	worst += idle;
	read_p20_p50_p80(product, passing, n, v->size[way]);
	if (way != VALIDATE_MODEL)
		return;
	v->misfit = v->rmse[way] * v->rmse[way] * (double)(n - idle);
	v->worst_sieve = product->size[worst];
	v->worst_difference = passing[worst] - product->passing[worst];
}

double *
validate_predict_by_all_ways(const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings,
    const double *corrected)
{
	size_t n = misfit_count_covered_sieves(&site->run[run]);
	double *passing = xcalloc_doubles(VALIDATE_WAYS * n);
	for (enum validate_way way = 0; way < VALIDATE_WAYS; way++)
		if (way == VALIDATE_CORRECTED && corrected != NULL)
			memcpy(
			    passing + way * n, corrected, n * sizeof *passing);
		else
			validate_predict_by_way(site, run, train, p, settings,
			    way, passing + way * n);
	return passing;
}

struct validation
validate_run_from_predictions(const struct site *site, size_t run,
    const bool *train, const double *passing)
{
	const struct run *at = &site->run[run];
	size_t n = misfit_count_covered_sieves(at);
	assert(n > 0);
	struct validation v = {.run = run,
	    .speed = at->speed,
	    .holdout = !train[run],
	    .n_sieve = n,
	    .n_left_out = at->product.n - n,
	    .n_idle = misfit_count_uninformative_sieves(
		at, site_finest_sieve_all_pass(site)),
	    .nearest = nearest_training_speed(site, train, at->speed)};
	find_speeds_to_interpolate(site, train, at->speed, v.line);
	for (size_t i = 0; i < PSD_SIZES; i++)
		v.measured[i] =
		    psd_size_at_passing(&at->product, PSD_PASSING[i]);
	for (enum validate_way way = 0; way < VALIDATE_WAYS; way++)
		score_prediction_method(&v, site, way, passing + way * n);
	return v;
}

struct validation
validate_run(const struct site *site, size_t run, const bool *train,
    const struct params *p, struct model_settings settings)
{
	FREED double *passing =
	    validate_predict_by_all_ways(site, run, train, p, settings, NULL);
	return validate_run_from_predictions(site, run, train, passing);
}

double
validate_rmse_of_model(const struct run *run, double top,
    const struct params *p, struct model_settings settings)
{
	size_t n = misfit_count_covered_sieves(run),
	       idle = misfit_count_uninformative_sieves(run, top);
	FREED double *passing = xcalloc_doubles(n);
	fill_model_passings(run, p, settings, passing);
	return psd_rms_difference(
	    passing + idle, run->product.passing + idle, n - idle, NULL);
}

enum validate_way
validate_way_of_least_rmse(const double rmse[static VALIDATE_WAYS])
{
	enum validate_way best = VALIDATE_MODEL;
	for (enum validate_way way = 0; way < VALIDATE_WAYS; way++)
		if (rmse[way] < rmse[best])
			best = way;
	return best;
}

bool
validation_is_interpolation_better(const struct validation *v)
{
	return v->holdout &&
	       v->rmse[VALIDATE_INTERPOLATION] < v->rmse[VALIDATE_MODEL];
}

bool
validation_is_extrapolated(const struct validation *v)
{
	return v->speed < v->line[0] || v->speed > v->line[1];
}

struct validate_score
validate_score_at_size(const struct validation *const *v, size_t n,
    enum validate_way way, size_t i)
{
	double mean = 0, bias = 0, square = 0, left = 0, spread = 0, count = 0;
	for (size_t k = 0; k < n; k++) {
		double m = v[k]->measured[i], p = v[k]->size[way][i];
		if (isnan(m) || isnan(p))
			continue;
		count++;
		bias += (p - m) / m;
		square += (p - m) / m * ((p - m) / m);
		left += (p - m) * (p - m);
		spread += (m - mean) * (m - mean) * (count - 1) / count;
		mean += (m - mean) / count;
	}
	return (struct validate_score){.n = (size_t)count,
	    .bias = count > 0 ? bias / count : NAN,
	    .rms = count > 0 ? sqrt(square / count) : NAN,
	    .r2 = spread > 0 ? 1 - left / spread : NAN};
}
