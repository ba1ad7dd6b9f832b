/* Checks the control charts of drift: counts the cuts between two signals if
 * nothing drifts, and the cuts until a step is signalled, on plants that were
 * calibrated at 69, 74 and 79 m/s.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/check/control_chart.h"
#include "core/posterior/ensemble.h"
#include "counts.h"
#include "plants.h"

/* Cuts in a sequence without drift; before a step; and after it. */
enum { LONG = 200, BEFORE = 10, AFTER = 60, SEQUENCES = 4, SPEEDS = 2 };
static const double SPEED[SPEEDS] = {72, 76};
static const double STEP[2] = {0.005, 0.01};

/* The errors of cuts and of the sheet: a law of plants, and the errors of
 * single passings and of curves, in points. */
static const struct errors {
	const char *name;
	enum law law;
	double own, shared;
} ERRORS[] = {
    {"each passing, 0.3", RIGHT, 0.3, 0},
    {"each passing, 0.5", RIGHT, 0.5, 0},
    {"shared, 0.25 + 0.6", SHARED, 0.25, 0.6},
    {"shared, 0.3 + 1", SHARED, 0.3, 1},
    {"feeds that vary, 0.5", DRIFT, 0.5, 0},
};

/* A calibrated plant, and the predictions for its cuts. */
struct view {
	struct plant plant;
	size_t from, n; /* the plant's sieves that crushing changes: first,
			 * number */
	double *predicted[SPEEDS], *truth[SPEEDS], *error[SPEEDS];
};

static struct view
view_of(const struct errors *errors, uint64_t number)
{
	struct view v = {.plant = plant_of(errors->law, number)};
	struct plant *p = &v.plant;
	p->own = errors->own / 100;
	p->shared = errors->shared / 100;
	struct site *site = plant_site(p, number);
	struct fit fit;
	struct posterior *posterior = counts_calibrate(site, number, &fit);
	const struct psd *feed = &site->run[0].feed;
	while (!(psd_passing(feed, p->sieve[v.from]) < 1))
		v.from++;
	v.n = p->n_sieve - v.from;
	struct ensemble *e =
	    ensemble_new(posterior, feed, p->sieve + v.from, v.n);
	for (size_t k = 0; k < SPEEDS; k++) {
		size_t cells = v.n * POSTERIOR_DRAWS;
		v.predicted[k] = xcalloc_doubles(v.n);
		v.truth[k] = xcalloc_doubles(cells);
		v.error[k] = xcalloc_doubles(v.n * v.n);
		ensemble_set_speed(e, SPEED[k]);
		ensemble_mean_answer(e, v.predicted[k]);
		memcpy(v.truth[k], ensemble_products(e, ENSEMBLE_ANSWER),
		    cells * sizeof(double));
		drift_covariance_of_errors(posterior, p->sieve + v.from,
		    v.predicted[k], v.n, v.error[k]);
	}
	ensemble_free(e);
	posterior_free(posterior);
	site_free(site);
	return v;
}

static void
view_free(struct view *v)
{
	for (size_t k = 0; k < SPEEDS; k++) {
		free(v->predicted[k]);
		free(v->truth[k]);
		free(v->error[k]);
	}
}

/* Returns the first of n cuts with a signal, or n.  Cuts from `from` on are
 * finer by `step`, as a mean over the sieves, and most where half passes.  Sets
 * *said to the number of cuts after which the program says such a step is
 * signalled. */
static size_t
first_signal(const struct view *v, uint64_t number, size_t n, size_t from,
    double step, double *said)
{
	struct plant cuts = v->plant;
	cuts.n_run = n;
	for (size_t j = 0; j < n; j++)
		cuts.speed[j] = SPEED[j % SPEEDS];
	struct site *site = plant_site(&cuts, number);
	struct drift_cut *cut = xcalloc(n, sizeof *cut);
	struct drift_point *point = xcalloc(n, sizeof *point);
	double *residual = xcalloc_doubles(n * v->n);
	size_t since;
	for (size_t j = 0; j < n; j++) {
		size_t k = j % SPEEDS;
		const double *P = site->run[j].product.passing + v->from;
		double h = 0;
		for (size_t i = 0; i < v->n; i++)
			h += sqrt(v->predicted[k][i] *
				  (1 - v->predicted[k][i])) /
			     (double)v->n;
		for (size_t i = 0; i < v->n; i++) {
			double own =
			    sqrt(v->predicted[k][i] * (1 - v->predicted[k][i]));
			residual[j * v->n + i] =
			    P[i] - v->predicted[k][i] +
			    (j >= from ? step * own / h : 0);
		}
		cut[j] = (struct drift_cut){v->n, v->plant.sieve + v->from,
		    residual + j * v->n, POSTERIOR_DRAWS, v->truth[k],
		    v->error[k]};
	}
	size_t first = drift_compute_charts(cut, n, &DRIFT_RULE, point, &since);
	*said = step > 0 ? drift_detection_delay(
			       &DRIFT_RULE, point, from, from, step, 1)
			 : (double)NAN;
	free(cut);
	free(point);
	free(residual);
	site_free(site);
	return first;
}

/* Sums over plants: cuts until a signal or the end, and signals.  For each
 * step: sequences with a signal within the cuts said, the cuts said, and
 * sequences. */
struct charts {
	double cuts, signals, within[2], said[2], found[2];
};

static void
count_plant(const struct errors *errors, uint64_t number, struct charts *c)
{
	struct view v = view_of(errors, number);
	for (uint64_t q = 0; q < SEQUENCES; q++) {
		uint64_t own = 1000000 + 100 * number + q;
		double said;
		size_t first = first_signal(&v, own, LONG, LONG, 0, &said);
		c->cuts += (double)(first < LONG ? first + 1 : LONG);
		c->signals += first < LONG;
		for (size_t k = 0; k < 2; k++) {
			first = first_signal(&v, own + 50, BEFORE + AFTER,
			    BEFORE, STEP[k], &said);
			if (first < BEFORE)
				continue;
			c->found[k] += 1;
			c->within[k] += (double)(first - BEFORE + 1) <= said;
			c->said[k] += fmin(said, AFTER);
		}
	}
	view_free(&v);
}

bool
count_drift(size_t n)
{
	double said = drift_mean_run_length(&DRIFT_RULE, 0, 1);
	bool ok = true;
	printf("without drift, said: once in %.0f cuts; 0.5 and 1 point finer "
	       "after %d cuts: signalled after, said\n%-22s %4s %s\n",
	    said, BEFORE, "errors", "once in cuts",
	    "   0.5 points       1 point");
	for (size_t l = 0; l < sizeof ERRORS / sizeof *ERRORS; l++) {
		struct charts c = {0};
		for (uint64_t i = 1; i <= n; i++)
			count_plant(&ERRORS[l], i, &c);
		double signals = fmax(c.signals, 1), length = c.cuts / signals,
		       error = length / sqrt(signals);
		ok = ok && length + 3 * error > said / 2 &&
		     length - 3 * error < 2 * said;
		printf("%-22s %4.0f +- %-4.0f", ERRORS[l].name, length, error);
		for (size_t k = 0; k < 2; k++) {
			printf(" %6.1f", c.said[k] / c.found[k]);
			ok = counts_share((size_t)c.within[k],
				 (size_t)c.found[k], 0.5, 1) &&
			     ok;
		}
		printf("\n");
		fflush(stdout);
	}
	return ok;
}
